//! Subsurface fields: displacement, strain and stress at any depth, (2.3)-(2.16).
//!
//! Each body is a half-space, so its field is one integral over the tractions on its surface
//! (2.7), (2.13). For a polynomial traction on the ellipse that integral is done in closed form
//! along every line of the ellipse, and what is left is a single integral over the directions of
//! lines; for constant tractions on polygons it is done in closed form, edge by edge; on a grid of
//! equal rectangles, a whole plane at one depth is a convolution ([`Grid`]).
//!
//! # Convention
//! Each body has its own frame: `x` and `y` as everywhere, `z` from the surface **into that
//! body**. Tractions are given as everywhere, by the upper body on the lower; [`Body::Upper`]
//! takes their reactions. Stresses are positive in tension. With `r` the distance from the point
//! of the surface to the point below, and unit tractions there, all follows from the harmonic
//! function
//!
//! ```math
//! \Omega = z \ln(r + z) - r
//! ```
//!
//! and its derivatives. Lengths are in one unit, tractions and stresses in another one; both are
//! at choice, as long as displacements are not asked (then they are those of the shear modulus).
//!
//! ```
//! use creepage::subsurface::{Body, Interior};
//! use creepage::{Ellipse, Hertz, Solid, SolidPair};
//! let steel = Solid::new(82e9, 0.28)?;
//! let ellipse = Ellipse::new(5e-3, 5e-3)?;
//! let contact = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 53.67e3)?;
//! let rail = Interior::sliding(&contact, [0.0, 0.0], steel, Body::Lower)?;
//! let stress = rail.stress([0.0, 0.0, 0.48 * 5e-3])?;
//! assert!((stress.tresca() / contact.peak_pressure() - 0.629).abs() < 5e-4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod directions;
mod edges;
mod element;
mod far;
mod grid;
mod hertz_waves;
mod interior;
mod largest;
mod legendre;
mod many;
mod near_edge;
mod rolling;
mod spectrum;
mod stress;
mod tree;
mod wave;
mod waves;

pub use element::{Element, ElementError};
pub use grid::{Grid, GridError, PlaneLoad};
pub use interior::{Body, Inside, Interior, InteriorError};
pub use largest::{Largest, largest};
pub use near_edge::{EdgePoint, SurfaceSlip};
pub use rolling::RollingError;
pub use stress::Stress;
