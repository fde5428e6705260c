//! The classical contact problems of section 3.2, without rolling, in SI units.
//!
//! | type | problem | section |
//! |---|---|---|
//! | [`Die`] | a rigid, flat, elliptical die pressed into a half-space by an offset load | 3.211 |
//! | [`Bonded`] | two bodies shifted and twisted against each other without slip | 3.212 |
//! | [`Hertz`](crate::Hertz) | two bodies pressed together | 3.221 |
//! | [`PartialSlip`] | two bodies shifted against each other with slip (Cattaneo, Mindlin) | 3.222 |
//! | [`ShiftPath`] | the same to and fro, under a load that may change, with its memory (Mindlin, Deresiewicz) | 3.222 |
//! | [`ShearedRectangle`] | a layer under a rectangle of uniform pressure, sheared to and fro | |
//! | [`Compression`] | two unlike bodies pressed together with friction (Spence), step by step | 6.2 |
//!
//! `x` and `y` are along the semi-axes `a` and `b` of the contact ellipse, `z` points into the
//! lower body. Forces and tractions are exerted by the upper body on the lower.

mod bonded;
mod compression;
mod die;
mod partial_slip;
mod sheared_rectangle;
mod shift_path;

pub use bonded::Bonded;
pub use compression::Compression;
pub use die::{Die, DieError};
pub use partial_slip::{PartialSlip, PartialSlipError};
pub use sheared_rectangle::{ShearError, ShearedRectangle, Shearing};
pub use shift_path::{ShiftAxis, ShiftEnd, ShiftPath};

use crate::ellipse::Ellipse;

/// The shifts `[x, y]` per unit of `F/(pi l G)`, `l` the major semi-axis: `K - sigma D` along
/// the minor axis and `K - sigma B` along the major (3.34).
fn shift_compliances(ellipse: Ellipse, poisson: f64) -> [f64; 2] {
    let integrals = ellipse.integrals();
    let along_minor = integrals.k - poisson * integrals.d;
    let along_major = integrals.k - poisson * integrals.b;
    if ellipse.a() <= ellipse.b() { [along_minor, along_major] } else { [along_major, along_minor] }
}
