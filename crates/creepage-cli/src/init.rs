//! `creepage init`: a commented case file to start from.

use std::io::{ErrorKind, Write};

use creepage_study::WholeFile;

use crate::about::InitArgs;
use crate::failure::Failure;
use crate::output::{print, say};

const EXAMPLE: &str = include_str!("example.toml");

pub(crate) fn run(args: &InitArgs) -> Result<(), Failure> {
    let Some(path) = &args.out else {
        return print(EXAMPLE);
    };
    let failed = |source| Failure::Write { path: path.clone(), source };
    if path.exists() {
        return Err(failed(ErrorKind::AlreadyExists.into()));
    }
    // It appears when it is whole, so that a full disk leaves nothing in the way of the next try.
    let mut file = WholeFile::create(path).map_err(failed)?;
    file.write_all(EXAMPLE.as_bytes()).and_then(|()| file.finish()).map_err(failed)?;
    say(&format!("wrote {}; next: creepage solve {}", path.display(), path.display()));
    Ok(())
}
