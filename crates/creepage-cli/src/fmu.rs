//! `creepage fmu`: a contact map as a Functional Mock-up Unit.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use creepage::table::Table;
use creepage_fmu::{Version, library_name, pack};
use creepage_study::{Sources, WholeFile};

use crate::failure::Failure;
use crate::input::is_wheelset;
use crate::outcome::Outcome;
use crate::output::say_written;

#[derive(Debug, clap::Args)]
pub(crate) struct FmuArgs {
    /// Contact map, as `creepage map` makes it.
    #[arg(value_name = "MAP.nc")]
    map: PathBuf,
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
    if is_wheelset(&args.map) {
        return Err(Failure::NoMap { path: args.map.clone() });
    }
    let read =
        |path: &Path| fs::read(path).map_err(|source| Failure::Read { path: path.into(), source });
    let map = read(&args.map)?;
    if Table::from_bytes(map.clone()).is_ok() {
        return Err(Failure::IsTable { path: args.map.clone() });
    }
    let library = args.library.clone().map_or_else(found, Ok)?;
    let binary = read(&library)?;
    let version = match args.fmi {
        Interface::Two => Version::Two,
        Interface::Three => Version::Three,
    };
    let wrong = |source| Failure::Pack { path: args.map.clone(), source };
    let bytes = pack(&map, &binary, version).map_err(wrong)?;
    Sources::new([&args.map, &library]).ensure_not_overwritten(&args.out)?;
    let failed = |source| Failure::Write { path: args.out.clone(), source };
    let mut file = WholeFile::create(&args.out).map_err(failed)?;
    file.write_all(&bytes).and_then(|()| file.finish()).map_err(failed)?;
    say_written(std::slice::from_ref(&args.out));
    Ok(Outcome::Done)
}

/// The library beside this program, or in `lib` beside its folder.
fn found() -> Result<PathBuf, Failure> {
    let name = library_name();
    let program = std::env::current_exe().unwrap_or_default();
    let folder = program.parent().unwrap_or(Path::new(""));
    let places = [folder.join(&name), folder.join("../lib").join(&name)];
    places.into_iter().find(|place| place.is_file()).ok_or(Failure::NoLibrary { name })
}
