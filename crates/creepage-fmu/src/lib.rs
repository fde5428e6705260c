//! A wheelset as a Functional Mock-up Unit, for FMI 2.0 and 3.0, Model Exchange and Co-Simulation: by its
//! [contact map](creepage_map), or by the [solver](creepage_study::WheelsetSolver) itself.
//!
//! One library serves both versions: `fmi2*` and `fmi3*` do not collide. It keeps nothing when an instance is freed. By a
//! map it starts no thread; each solver has one, which ends with its instance. The FMU is memoryless: outputs are those of
//! the present inputs, the same bits whatever was asked before. [`pack`] and [`pack_solver`] make the archive from a map or a
//! wheelset's file and the library, without a compiler.
//!
//! ```no_run
//! use creepage_fmu::{Version, pack};
//! let (map, library) = (std::fs::read("wheelset.nc")?, std::fs::read("libcreepage_fmu.so")?);
//! std::fs::write("W.fmu", pack(&map, &library, Version::Three)?)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod contacts;
mod description;
pub mod fmi2;
pub mod fmi3;
mod host;
mod instance;
mod pack;
mod resources;
mod solver;
mod variables;

pub use contacts::ContactsError;
pub use pack::{PackError, Version, library_name, pack, pack_solver};
