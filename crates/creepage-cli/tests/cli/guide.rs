//! The guide's commands: every line `$ ...` of its pages runs, in the order of the page and in a
//! directory of the page's own that has the examples in it. (The guide's build shows what they
//! print; a command that fails is found here.)

use std::env;
use std::ffi::OsString;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

use crate::place::Place;

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

/// All Markdown files below a directory.
fn pages(directory: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path());
    let found = entries.flat_map(|path| if path.is_dir() { pages(&path) } else { vec![path] });
    found.filter(|path| path.extension().is_some_and(|extension| extension == "md")).collect()
}

/// The command on a line: one that is shown, or one in a comment that only draws a picture.
fn command(line: &str) -> Option<&str> {
    let hidden = || line.strip_prefix("<!-- $ ")?.strip_suffix(" -->");
    line.strip_prefix("$ ").or_else(hidden)
}

/// The search path with the command under test in front.
fn search_path() -> OsString {
    let own = Path::new(env!("CARGO_BIN_EXE_creepage")).parent().unwrap().to_owned();
    let others = env::var_os("PATH").unwrap_or_default();
    env::join_paths([own].into_iter().chain(env::split_paths(&others))).unwrap()
}

/// Runs the commands of a page and counts them.
fn run(page: &Path) -> usize {
    let place = Place::new();
    symlink(repository().join("examples"), place.path("examples")).unwrap();
    let text = fs::read_to_string(page).unwrap();
    let commands: Vec<_> = text.lines().filter_map(command).collect();
    for command in &commands {
        let mut shell = Command::new("sh");
        shell.args(["-c", command]).env("PATH", search_path()).current_dir(place.path(""));
        let ran = shell.output().unwrap();
        let said = String::from_utf8_lossy(&ran.stderr);
        assert!(ran.status.success(), "{}: `{command}`: {said}", page.display());
    }
    commands.len()
}

#[test]
fn every_command_of_the_guide_runs() {
    let pages = pages(&repository().join("book/pages"));
    let count: usize = thread::scope(|scope| {
        let running: Vec<_> = pages.iter().map(|page| scope.spawn(|| run(page))).collect();
        running.into_iter().map(|page| page.join().unwrap()).sum()
    });
    assert!(count > 30, "only {count} commands: the guide's pages are not where they were");
}

/// Commands in the running text name subcommands that exist.
#[test]
fn the_guide_names_only_commands_that_exist() {
    let place = Place::new();
    let help = place.run(&["--help"]).done();
    for page in pages(&repository().join("book/pages")) {
        for mention in fs::read_to_string(&page).unwrap().split("`creepage ").skip(1) {
            let name = mention.split([' ', '`']).next().unwrap();
            assert!(help.contains(&format!("\n  {name} ")), "{}: {name}", page.display());
        }
    }
}
