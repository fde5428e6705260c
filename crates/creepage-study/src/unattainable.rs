//! Error of prescribed forces that no creepage gives.

use std::error::Error;
use std::fmt;

use creepage::{Creepage, Force, Scaling};

/// Error of prescribed forces that no creepage gives.
#[derive(Debug, Clone, PartialEq)]
pub struct UnattainableForce {
    /// Which of `fx`, `fy`, `mz` are prescribed.
    pub prescribed: [bool; 3],
    /// The force that came nearest.
    pub nearest: Force,
    /// Its creepage.
    pub at: Creepage,
    /// The units of both; the message is in SI units.
    pub scaling: Scaling,
}

impl Error for UnattainableForce {}

impl fmt::Display for UnattainableForce {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (force, at) = (self.scaling.si_force(self.nearest), self.scaling.si_creepage(self.at));
        let forces = [
            format!("longitudinal_force = {:?} N", rounded(force.longitudinal)),
            format!("lateral_force = {:?} N", rounded(force.lateral)),
            format!("moment = {:?} N m", rounded(force.moment)),
        ];
        let prescribed = forces.into_iter().zip(self.prescribed);
        let reached: Vec<_> = prescribed.filter_map(|(force, on)| on.then_some(force)).collect();
        write!(
            f,
            "[wanted] is not reachable: at most {} was reached, at longitudinal = {:?}, \
             lateral = {:?}, spin = {:?} rad/m",
            reached.join(", "),
            rounded(at.longitudinal),
            rounded(at.lateral),
            rounded(at.spin)
        )
    }
}

/// To six digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
