//! The guide names commands that exist. (Its build runs them, and ends where one fails.)

use std::fs;
use std::path::{Path, PathBuf};

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

/// Commands in the running text name subcommands that exist.
#[test]
fn the_guide_names_only_commands_that_exist() {
    let place = Place::new();
    let help = place.run(&["--help"]).done();
    let pages = pages(&repository().join("book/pages"));
    assert!(pages.len() > 40, "only {}: the guide's pages are not where they were", pages.len());
    for page in pages {
        for mention in fs::read_to_string(&page).unwrap().split("`creepage ").skip(1) {
            let name = mention.split([' ', '`']).next().unwrap();
            assert!(help.contains(&format!("\n  {name} ")), "{}: {name}", page.display());
        }
    }
}
