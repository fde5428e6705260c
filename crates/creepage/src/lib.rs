//! Rolling contact of two elastic bodies with dry friction: creepage and spin in, tangential
//! force and moment out.
//!
//! Data flows one way, **bodies -> [`Hertz`] -> [`Contact`] -> [`Theory`] -> [`Solution`]**, and
//! each arrow is a type:
//!
//! | room | what it holds |
//! |---|---|
//! | [`Solid`], [`SolidPair`], [`Hertz`], [`Ellipse`] | materials and radii to the contact ellipse (2.10), (3.36)-(3.52) |
//! | [`gap`], [`normal`] | bodies of any shape: their undeformed distance, and contact areas and pressures of it |
//! | [`Contact`] | all that a theory is prepared for |
//! | [`Creepage`], [`Force`], [`Scaling`] | the dimensionless quantities (4.20), and their units |
//! | [`theory`] | what every theory can be asked; every theory by name, [`TheorySpec`] |
//! | [`coulomb`] | the full theory, `exact` |
//! | [`approximate`], [`variational`], [`table`] | the other theories |
//! | [`subsurface`], [`damage`] | stresses inside the bodies; wear, fatigue and shakedown |
//! | [`friction_law`] | friction that depends on the speed of slip |
//! | [`unsteady`] | rolling that is not steady: a contact that remembers |
//! | [`statics`] | the classical problems without rolling |
//! | [`halfspace`], [`special`] | the elastic answer to tractions, and the elliptic integrals, on which all rest |
//!
//! A theory is prepared once for a contact, and asked many times. Equation numbers are those of
//! J.J. Kalker, *On the rolling contact of two elastic bodies in the presence of dry friction*,
//! thesis, Delft, 1967.
//!
//! A driven wheel on a rail:
//!
//! ```
//! use creepage::coulomb::{Exact, Resolution};
//! use creepage::{Hertz, Radii, SiCreepage, Solid, SolidPair, Theory};
//!
//! let steel = Solid::new(82e9, 0.28)?;
//! let wheel = Radii { rolling: 0.46, lateral: f64::INFINITY };
//! let rail = Radii { rolling: f64::INFINITY, lateral: 0.30 };
//! let contact =
//!     Hertz::new(SolidPair::new(steel, steel), wheel, rail, 0.0, 80e3)?.with_friction(0.3)?;
//!
//! let theory = Exact::new(&contact, Resolution::STANDARD)?;
//! let slipping = SiCreepage { longitudinal: -1.5e-3, ..SiCreepage::default() };
//! let solution = theory.solve(contact.scaling().creepage(slipping)?);
//! let on_the_rail = contact.scaling().si_force(solution.force);
//! assert!((on_the_rail.longitudinal + 14.56e3).abs() < 20.0); // newtons, against the motion
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Sign convention
//! `x` is the rolling direction, `z` points into the lower body; material flows through the
//! contact towards `-x`, so the leading edge is at `x > 0`. Creepage and spin are the velocity
//! of the **upper** body relative to the **lower**, over the rolling velocity. Tractions,
//! forces and the moment are exerted **by the upper body on the lower**, and have the sense of
//! the slip.
//!
//! # The problem
//! With `u = u+ - u-` the difference of the displacements, the slip over the rolling velocity is
//! (4.15)
//!
//! ```math
//! s_x = \upsilon_x - \phi y + \frac{\partial u}{\partial x}, \qquad
//! s_y = \upsilon_y + \phi x + \frac{\partial v}{\partial x}
//! ```
//!
//! and by Coulomb's law, at the pressure `Z`, either there is no slip and the traction is within
//! its bound, or the traction is at its bound in the direction of the slip (4.16):
//!
//! ```math
//! s = 0, \quad |(X, Y)| \le \mu Z \qquad \text{or} \qquad (X, Y) = \mu Z \, \frac{s}{|s|}
//! ```
//!
//! In the dimensionless quantities (4.20), `c = sqrt(a b)`:
//!
//! ```math
//! \xi = \frac{\upsilon_x \rho}{\mu c}, \quad \eta = \frac{\upsilon_y \rho}{\mu c}, \quad
//! \chi = \frac{\phi \rho}{\mu}; \qquad
//! f_x = \frac{F_x}{\mu N}, \quad f_y = \frac{F_y}{\mu N}, \quad m_z = \frac{M_z}{\mu N c}
//! ```

pub mod approximate;
pub mod coulomb;
pub mod curved;
pub mod damage;
pub mod friction_law;
pub mod gap;
pub mod halfspace;
pub mod motion;
pub mod normal;
pub mod numerics;
pub mod special;
pub mod statics;
pub mod subsurface;
pub mod table;
pub mod temperature;
pub mod theory;
pub mod unsteady;
pub mod variational;
pub mod viscoelastic;

mod added_slip;
mod check;
mod contact;
mod creepage;
mod ellipse;
mod hertz;
mod layer;
mod scaling;
mod solid;

pub use added_slip::AddedSlip;
pub use check::InvalidValue;
pub use contact::Contact;
pub use creepage::{Creepage, Force};
pub use ellipse::Ellipse;
pub use hertz::{Hertz, HertzError, Radii};
pub use layer::{Layer, Plasticity};
pub use scaling::{Scaling, SiCreepage, SiForce};
pub use solid::{Solid, SolidPair};
pub use theory::{
    FieldPoint, Jacobian, Region, Solution, Solved, Statistics, Status, Theory, TheorySpec,
};

/// The guide's page on calling this library, whose programs run with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../pages/rust.md")]
struct Guide;

/// The README, for its lines of Rust.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;

/// The guide's page on the half-space.
#[cfg(doctest)]
#[doc = include_str!("../pages/half-space.md")]
struct HalfSpacePage;
