//! Transient rolling: a contact that remembers.
//!
//! With `q` the distance rolled, the slip of the upper body over the lower is (4.15b)
//!
//! ```math
//! s_x = \upsilon_x - \phi y + \frac{\partial u}{\partial x} - \frac{\partial u}{\partial q},
//! \qquad
//! s_y = \upsilon_y + \phi x + \frac{\partial v}{\partial x} - \frac{\partial v}{\partial q}
//! ```
//!
//! which is the change of a particle's displacement on its way through the contact. [`Rolling`] is
//! the full theory: it follows the particles from the centre of one element to that of the next,
//! with the displacements at all centres remembered. Where nothing changes any more it is steady
//! rolling by [`Exact`](crate::coulomb::Exact), element by element.

mod area;
mod carry;
mod control;
mod elements;
mod fastsim;
mod history;
mod jump;
mod level;
mod line;
mod load;
mod motion;
mod particle;
mod predictor;
mod prescribed_forces;
mod rigid;
mod rolling;
mod saved;
mod system;
mod variational;
mod wave;

pub use carry::Before;
pub use fastsim::RollingFastsim;
pub use motion::{Motion, Prescribed};
pub use rolling::{Rolled, Rolling};
pub use saved::{Saved, SavedError};
pub use variational::RollingVariational;
pub use wave::{Harmonic, HarmonicCoefficients, HarmonicCreepage};
