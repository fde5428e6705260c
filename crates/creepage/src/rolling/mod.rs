//! Steady rolling with friction: creepage and spin in, tangential force and moment out.
//!
//! Every theory works in the thesis's dimensionless quantities (4.20); [`Scaling`] is the one
//! place where they meet SI units.
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

pub mod carter;
pub mod exact;
pub mod fastrip;
pub mod fastsim;
pub mod linear;
pub mod polach;
pub mod saturated;
pub mod shen_hedrick_elkins;
pub mod strip;
pub mod variational;
pub mod vermeulen_johnson;

mod creepage;
mod cubic;
mod dual;
mod field;
mod outside_chords;
mod scaling;
mod theory;

pub use creepage::{Creepage, Force};
pub use field::{FieldPoint, Region};
pub use scaling::{Scaling, SiCreepage, SiForce};
pub use theory::{Solution, Status, Theory};
