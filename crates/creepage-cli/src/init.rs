//! `creepage init`: a commented case file to start from.

use std::fs::File;
use std::io::Write;

use crate::args::InitArgs;
use crate::failure::Failure;
use crate::output::{print, say};

const EXAMPLE: &str = include_str!("example.toml");

pub(crate) fn run(args: &InitArgs) -> Result<(), Failure> {
    let Some(path) = &args.out else {
        return print(EXAMPLE);
    };
    File::create_new(path)
        .and_then(|mut file| file.write_all(EXAMPLE.as_bytes()))
        .map_err(|source| Failure::Write { path: path.clone(), source })?;
    say(&format!("wrote {}; next: creepage solve {}", path.display(), path.display()));
    Ok(())
}
