//! Rolling contact of two elastic bodies with dry friction: creepage and spin in, tangential
//! force and moment out.
//!
//! Data flows one way, **bodies -> contact ellipse -> theory -> force**, and each arrow is a
//! type:
//!
//! | room | what it holds |
//! |---|---|
//! | [`Solid`], [`SolidPair`] | materials, and the pair as one equivalent solid (2.10) |
//! | [`Hertz`], [`Ellipse`] | radii and load to the contact ellipse (3.36)-(3.52) |
//! | [`rolling`] | every theory of rolling contact, in the dimensionless quantities (4.20), and [`rolling::Scaling`] between these and SI units |
//! | [`statics`] | the classical problems without rolling |
//! | [`halfspace`] | the elastic answer to tractions, on which all of them rest |
//! | [`special`] | the elliptic integrals |
//!
//! A theory is prepared once from the shape of the contact and Poisson's ratio, and asked many
//! times. Equation numbers are those of J.J. Kalker, *On the rolling contact of two elastic
//! bodies in the presence of dry friction*, thesis, Delft, 1967.
//!
//! A driven wheel on a rail:
//!
//! ```
//! use creepage::rolling::exact::{Exact, Resolution};
//! use creepage::rolling::{Scaling, SiCreepage, Theory};
//! use creepage::{Hertz, Radii, Solid, SolidPair};
//!
//! let steel = Solid::new(82e9, 0.28)?;
//! let wheel = Radii { rolling: 0.46, lateral: f64::INFINITY };
//! let rail = Radii { rolling: f64::INFINITY, lateral: 0.30 };
//! let contact = Hertz::new(SolidPair::new(steel, steel), wheel, rail, 0.0, 80e3)?;
//!
//! let scaling = Scaling::new(&contact, 0.3)?;
//! let slipping = SiCreepage { longitudinal: -1.5e-3, ..SiCreepage::default() };
//! let creepage = scaling.creepage(slipping)?;
//!
//! let ratio = contact.ellipse().ratio();
//! let theory = Exact::new(ratio, contact.pair().poisson(), Resolution::STANDARD)?;
//! let on_the_rail = scaling.si_force(theory.solve(creepage).force);
//! assert!((on_the_rail.longitudinal + 14.56e3).abs() < 20.0); // newtons, against the motion
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod below;
pub mod damage;
pub mod friction_law;
pub mod halfspace;
pub mod rolling;
pub mod special;
pub mod statics;

mod check;
mod ellipse;
mod hertz;
mod solid;

pub use check::InvalidValue;
pub use ellipse::Ellipse;
pub use hertz::{Hertz, HertzError, Radii};
pub use solid::{Solid, SolidPair};

/// The guide's page on calling this library, whose programs run with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../../../book/pages/how-to/rust.md")]
struct Guide;
