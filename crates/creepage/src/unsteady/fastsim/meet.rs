//! The creepage at which FASTSIM gives the prescribed forces.

use super::super::history::Level;
use super::super::meet::{Accuracy, meet};
use super::super::motion::Motion;
use super::RollingFastsim;
use super::march::Sum;

impl RollingFastsim {
    /// The step at the creepage that meets the prescribed forces, from the last creepage.
    pub(super) fn meet(&self, length: f64, scale: f64, motion: &Motion) -> (Level, Sum, bool) {
        let accuracy = Accuracy { tolerance: 1e-9 * scale.powi(3), difference: 1e-6 };
        let march = |creep| {
            let (level, sum) = self.march([length, scale], creep);
            ((level, sum), sum.force)
        };
        let (_, (level, sum), solved) =
            meet(motion.components(), self.travel.creep, accuracy, march);
        (level, sum, solved)
    }
}
