//! `creepage import`: case files from an input file of the program CONTACT.

use std::fs;
use std::path::PathBuf;

use creepage_import::{Imported, import};
use creepage_study::{Sources, write_all};

use crate::failure::Failure;
use crate::outcome::Outcome;
use crate::output::{print, say};

#[derive(Debug, clap::Args)]
pub(crate) struct ImportArgs {
    /// Input file of CONTACT.
    #[arg(value_name = "FILE.inp")]
    input: PathBuf,
    /// Directory for the case files; it is made when missing.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// The commands that solve what was written go to standard output, a line each.
pub(crate) fn run(args: &ImportArgs) -> Result<Outcome, Failure> {
    let failed = |source| Failure::Import { path: args.input.clone(), source };
    let imported = import(&args.input, &args.out).map_err(failed)?;
    let written = imported.cases.iter().filter_map(|case| case.written.as_ref().ok());
    let files: Vec<_> = written
        .flat_map(|written| &written.files)
        .chain(&imported.profiles)
        .map(|file| (file.name.as_str(), file.contents.as_slice()))
        .collect();
    for (name, contents) in &files {
        let path = args.out.join(name);
        if path.exists() && fs::read(&path).is_ok_and(|there| there != *contents) {
            return Err(Failure::ImportExists { path });
        }
    }
    if !files.is_empty() {
        let sources = Sources::new(imported.sources.iter().cloned());
        write_all(&args.out, &files, &sources).map_err(Failure::from)?;
    }
    tell(&imported);
    let mut commands = String::new();
    for written in imported.cases.iter().filter_map(|case| case.written.as_ref().ok()) {
        commands += &written.command;
        commands.push('\n');
    }
    print(commands.trim_end())?;
    let all = imported.cases.iter().all(|case| case.written.is_ok());
    Ok(if all { Outcome::Done } else { Outcome::Doubtful })
}

fn tell(imported: &Imported) {
    for case in &imported.cases {
        match &case.written {
            Ok(_) => {
                for note in &case.notes {
                    say(&format!("{}: {note}", case.name));
                }
            }
            Err(cause) => {
                say(&format!("{} (line {}) is not written: {cause}", case.name, case.line));
            }
        }
    }
    let written = imported.cases.iter().filter(|case| case.written.is_ok()).count();
    say(&format!("{written} of {} cases written", imported.cases.len()));
}
