//! A wheelset's [contact map](creepage_map) as a Functional Mock-up Unit, for FMI 2.0 and 3.0, Model Exchange
//! and Co-Simulation.
//!
//! One library serves both versions: `fmi2*` and `fmi3*` do not collide. It is serial, starts no thread, and
//! keeps nothing when an instance is freed. The FMU is memoryless: outputs are those of the present inputs.
//! [`pack`] makes the archive from a map and the library, without a compiler.
//!
//! ```no_run
//! use creepage_fmu::{Version, pack};
//! let (map, library) = (std::fs::read("wheelset.nc")?, std::fs::read("libcreepage_fmu.so")?);
//! std::fs::write("W.fmu", pack(&map, &library, Version::Three)?)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod description;
pub mod fmi2;
pub mod fmi3;
mod host;
mod instance;
mod pack;
mod variables;

pub use pack::{PackError, Version, library_name, pack};
