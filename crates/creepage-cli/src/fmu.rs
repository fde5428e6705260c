//! `creepage fmu`: a contact map, or a wheelset's file for the solver itself, as a Functional Mock-up Unit.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use creepage::table::Table;
use creepage_fmu::{Version, library_name, pack, pack_solver};
use creepage_map::ContactMap;
use creepage_study::{Sources, WholeFile};

use crate::failure::Failure;
use crate::input::is_wheelset;
use crate::outcome::Outcome;
use crate::output::say_written;
use crate::wheelset::{say_found, say_left_out};

#[derive(Debug, clap::Args)]
pub(crate) struct FmuArgs {
    /// Contact map, as `creepage map` makes it; with --exact a wheelset's file.
    #[arg(value_name = "MAP.nc")]
    source: PathBuf,
    /// The solver itself instead of a map, by the theory of the wheelset's file: no range and no error of a map, but
    /// tens of milliseconds an answer.
    #[arg(long)]
    exact: bool,
    /// Version of the Functional Mock-up Interface.
    #[arg(long, value_name = "2|3", default_value = "3")]
    fmi: Interface,
    /// File for the FMU; it appears when it is whole.
    #[arg(long, value_name = "FILE.fmu")]
    out: PathBuf,
    /// The library that goes into it, built by `cargo build --release -p creepage-fmu`; beside this program or in
    /// ../lib if not given.
    #[arg(long, value_name = "LIBRARY")]
    library: Option<PathBuf>,
}

/// Version of the interface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Interface {
    /// FMI 2.0
    #[value(name = "2")]
    Two,
    /// FMI 3.0
    #[value(name = "3")]
    Three,
}

pub(crate) fn run(args: &FmuArgs) -> Result<Outcome, Failure> {
    let version = match args.fmi {
        Interface::Two => Version::Two,
        Interface::Three => Version::Three,
    };
    let bytes = if args.exact { of_solver(args, version) } else { of_map(args, version) }?;
    let failed = |source| Failure::Write { path: args.out.clone(), source };
    let mut file = WholeFile::create(&args.out).map_err(failed)?;
    file.write_all(&bytes).and_then(|()| file.finish()).map_err(failed)?;
    say_written(std::slice::from_ref(&args.out));
    Ok(Outcome::Done)
}

fn of_map(args: &FmuArgs, version: Version) -> Result<Vec<u8>, Failure> {
    let path = || args.source.clone();
    if is_wheelset(&args.source) {
        return Err(Failure::NoMap { path: path() });
    }
    let map = read(&args.source)?;
    if Table::from_bytes(map.clone()).is_ok() {
        return Err(Failure::IsTable { path: path() });
    }
    let library = library(args, &Sources::new([&args.source]))?;
    pack(&map, &library, version)
        .map_err(|source| Failure::Pack { path: path(), source: Box::new(source) })
}

fn of_solver(args: &FmuArgs, version: Version) -> Result<Vec<u8>, Failure> {
    let path = || args.source.clone();
    if ContactMap::from_bytes(read(&args.source)?).is_ok() {
        return Err(Failure::ExactMap { path: path() });
    }
    let case = crate::wheelset::read(&args.source)?;
    case.notes.iter().for_each(say_found);
    say_left_out(&case, "FMUs");
    let library = library(args, &case.sources().with(&Sources::new([&args.source])))?;
    pack_solver(&args.source, &library, version)
        .map_err(|source| Failure::Pack { path: path(), source: Box::new(source) })
}

/// The library's bytes; nothing that was read is written over.
fn library(args: &FmuArgs, sources: &Sources) -> Result<Vec<u8>, Failure> {
    let path = args.library.clone().map_or_else(found, Ok)?;
    let bytes = read(&path)?;
    sources.clone().with(&Sources::new([path])).ensure_not_overwritten(&args.out)?;
    Ok(bytes)
}

fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    fs::read(path).map_err(|source| Failure::Read { path: path.into(), source })
}

/// The library beside this program, or in `lib` beside its folder.
fn found() -> Result<PathBuf, Failure> {
    let name = library_name();
    let program = std::env::current_exe().unwrap_or_default();
    let folder = program.parent().unwrap_or(Path::new(""));
    let places = [folder.join(&name), folder.join("../lib").join(&name)];
    places.into_iter().find(|place| place.is_file()).ok_or(Failure::NoLibrary { name })
}
