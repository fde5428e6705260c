//! Numerical methods that theories, and the equilibria of wheelsets and bearings, share: each once, tested by itself.
//!
//! Newton's method where the Jacobian comes by differences ([`newton()`]) and Broyden's update of it
//! ([`broyden_update`]), a residual's size ([`largest_magnitude`]), a bracketed root ([`Root`]) and [`bisect`] for one unknown. For the library alone GMRES,
//! Anderson acceleration, a dense factorization without allocation, rules of Gauss, functions of several numbers at once,
//! and a pool of buffers. What a method knows of its own problem stays with that: the semismooth Newton methods of the
//! tractions and of the strips of pressure, and the trust region of a wheelset's loads.

pub(crate) mod anderson;
pub(crate) mod buffer_pool;
pub(crate) mod gauss;
pub(crate) mod gmres;
pub(crate) mod lu;
mod newton;
mod root;
pub(crate) mod simd_math;

pub use newton::{Newton, NewtonLimits, broyden_update, largest_magnitude, newton};
pub use root::{Root, bisect};
