//! Tables of creep force: any theory of rolling contact, looked up in a hundred nanoseconds.
//!
//! A table holds the dimensionless force and moment of a theory over `xi`, `eta`, `chi`, from zero
//! to infinity, at one ratio `a/b` and one Poisson's ratio, or over ranges of these. Kalker's
//! USETAB (1996) is the precedent. [`build`] asks the theory, in parallel, and measures the
//! table's error against it, at random places and where the force bends most; [`Table::to_bytes`] and
//! [`Table::from_bytes`] keep the table as a NetCDF file. For one contact a table is a [`Theory`]
//! like any other, [`TableTheory`].
//!
//! # What is interpolated
//! Forces at nodes of spherical coordinates in scaled creepage, of which one quarter is needed by
//! the symmetries (4.28): the angles of the direction, and `t = r/(2 + r)` for the size `r`.
//! Along `t` a cubic spline, along the angles the functions `1, sin s, cos s, sin 2s`, which linear
//! theory is made of: so the force has a continuous derivative everywhere, at zero and on the
//! axis of pure spin too. Over `a/b` and Poisson's ratio, cubic convolution. Without spin the
//! force between nodes rises along a ray where it does from node to node.
//!
//! # Where it errs
//! Where the force itself hardly has a derivative: in long contacts it turns from rising to
//! falling as the leading edge begins to slide, which with little but spin it does everywhere
//! at once. And where the theory's own force ripples, as that of coarse elements does under strong
//! spin.
//!
//! ```
//! use creepage::InvalidValue;
//! use creepage::{Contact, Creepage, Ellipse, Theory};
//! use creepage::approximate::polach::Polach;
//! use creepage::table::{Axis, Intervals, Provenance, Spec, build};
//! let spec = Spec {
//!     a_over_b: Axis::fixed(1.0),
//!     poisson: Axis::fixed(0.28),
//!     intervals: Intervals { theta: 8, phi: 12, t: 16 },
//!     places: 100,
//!     provenance: Provenance { theory: "polach".into(), ..Provenance::default() },
//! };
//! let prepare = |contact: &Contact| -> Result<Box<dyn Theory>, InvalidValue> {
//!     Ok(Box::new(Polach::new(contact)?))
//! };
//! let table = build(&spec, prepare, &|| {})?;
//! let (force, derivative) =
//!     table.at(1.0, 0.28)?.force_and_derivative(Creepage::new(0.9, 0.0, 0.0)?);
//! let polach = Polach::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?)?;
//! assert!((force.fx - polach.solve(Creepage::new(0.9, 0.0, 0.0)?).force.fx).abs() < 5e-4);
//! assert!(derivative[0][0] > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(doc)]
use crate::Theory;

mod axis;
mod bends;
mod build;
mod coordinates;
mod file;
mod hermite;
mod in_memory;
mod measure;
mod slice;
mod slopes;
mod spec;
mod theory;
mod values;

pub use axis::Axis;
pub use build::{BuildError, build};
pub use file::FileError;
pub use in_memory::{Provenance, Table};
pub use measure::{Accuracy, Spread};
pub use slice::{Shape, Slice};
pub use spec::Spec;
pub use theory::TableTheory;
pub use values::Intervals;
