//! `creepage completions` and `creepage man`: what shells and `man` know of the command.

use clap::CommandFactory;

use creepage_study::{Sources, write_all};

use crate::about::{CompletionsArgs, ManArgs};
use crate::args::Args;
use crate::failure::Failure;
use crate::output::{print, say_written};

/// The script by which a shell completes the command.
pub(crate) fn completions(args: &CompletionsArgs) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Args::command(), "creepage", &mut script);
    print(&String::from_utf8_lossy(&script))
}

/// The manual: a page for the command and one for each of its subcommands.
pub(crate) fn man(args: &ManArgs) -> Result<(), Failure> {
    let mut command = Args::command();
    command.build();
    let Some(directory) = &args.out else {
        let page = page(&command)?;
        return print(&String::from_utf8_lossy(&page));
    };
    let mut pages = Vec::new();
    add_pages(&command, &mut pages)?;
    let files: Vec<_> = pages.iter().map(|(name, page)| (&name[..], &page[..])).collect();
    say_written(&write_all(directory, &files, &Sources::default())?);
    Ok(())
}

/// The page of a command, then those of its subcommands.
fn add_pages(command: &clap::Command, pages: &mut Vec<(String, Vec<u8>)>) -> Result<(), Failure> {
    let name = command.get_display_name().unwrap_or(command.get_name());
    pages.push((format!("{name}.1"), page(command)?));
    for sub in command.get_subcommands().filter(|sub| sub.get_name() != "help") {
        add_pages(sub, pages)?;
    }
    Ok(())
}

fn page(command: &clap::Command) -> Result<Vec<u8>, Failure> {
    let mut page = Vec::new();
    clap_mangen::Man::new(command.clone()).render(&mut page).map_err(Failure::Stdout)?;
    Ok(page)
}
