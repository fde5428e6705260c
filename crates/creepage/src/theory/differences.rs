//! Difference quotients for theories that give their force only.

use super::Jacobian;
use crate::Creepage;

/// The derivative of a force by central differences of `part` of each component of the creepage, or of
/// one where that is smaller.
pub(crate) fn differences(
    creepage: Creepage,
    part: f64,
    force: impl Fn(Creepage) -> [f64; 3],
) -> Jacobian {
    let at = creepage.components();
    let columns = [0, 1, 2].map(|k| {
        let step = part * at[k].abs().max(1.0);
        let [ahead, behind] = [step, -step].map(|step| {
            let mut moved = at;
            moved[k] += step;
            let [xi, eta, chi] = moved;
            force(Creepage { xi, eta, chi })
        });
        [0, 1, 2].map(|i| (ahead[i] - behind[i]) / (2.0 * step))
    });
    std::array::from_fn(|i| std::array::from_fn(|k| columns[k][i]))
}
