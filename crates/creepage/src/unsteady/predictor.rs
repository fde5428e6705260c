//! Where the solution of a step is likely to be: the tractions from which it is sought.
//!
//! They go on as in the last step, in proportion to its length; on the finer grid comes what the coarser
//! has found to differ from that, so that a jump of the motion is foreseen too.

use std::sync::Arc;

use crate::coulomb::influence::Tractions;
use crate::coulomb::mesh::Mesh;

/// How tractions, all `x` before all `y`, changed in the last step.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Trend {
    pub length: f64,
    pub change: Vec<f64>,
}

/// A step so many times longer than the last is not like it.
const LONGER: f64 = 2.0;

/// The prediction for one grid.
#[derive(Debug, Clone, Default)]
pub(crate) struct Predictor {
    /// Of the last step, unless something has jumped since.
    pub trend: Option<Trend>,
    /// Tractions at the beginning of the step, and those predicted for its end.
    begin: Vec<f64>,
    predicted: Vec<f64>,
    /// For each element, those of the coarser grid to interpolate between, with their weights; none on
    /// the coarser grid itself.
    coarser: Arc<[[(usize, f64); 4]]>,
}

impl Predictor {
    /// Of the finer of two grids.
    pub(crate) fn of_finer(coarse: &Mesh, fine: &Mesh) -> Self {
        let times = fine.strips.len() / coarse.strips.len().max(1);
        let around = fine.all().map(|(j, i)| {
            let strip = &fine.strips[j];
            coarse.around(j / times.max(1), strip.y(), strip.along.middles[i])
        });
        Self { coarser: around.collect(), ..Self::default() }
    }

    /// Forgets the last step.
    pub(crate) fn restart(&mut self) {
        self.trend = None;
    }

    /// Replaces the tractions at the beginning of a step by those predicted for its end, within the
    /// limits of friction; `coarse` are the tractions that the coarser grid has ended with, and its
    /// prediction.
    pub(crate) fn predict(
        &mut self,
        (length, smooth): (f64, bool),
        coarse: Option<(&Self, &Tractions)>,
        limits: &[f64],
        traction: &mut Tractions,
    ) {
        let n = limits.len();
        self.begin.resize(2 * n, 0.0);
        traction.copy_to(&mut self.begin);
        self.predicted.clone_from(&self.begin);
        if let Some(last) =
            self.trend.as_ref().filter(|last| smooth && length <= LONGER * last.length)
        {
            let times = length / last.length;
            let all = self.predicted.iter_mut().zip(&last.change);
            all.for_each(|(predicted, change)| *predicted += times * change);
        }
        if let Some((coarse, found)) = coarse {
            for (k, predicted) in self.predicted.chunks_exact_mut(n).enumerate() {
                let before = &coarse.predicted[k * found.own[k].len()..];
                let missed = |from: usize| found.own[k][from] - before[from];
                for (predicted, from) in predicted.iter_mut().zip(&*self.coarser) {
                    *predicted +=
                        from.iter().map(|(from, weight)| weight * missed(*from)).sum::<f64>();
                }
            }
        }
        for (element, limit) in limits.iter().enumerate() {
            let size = self.predicted[element].hypot(self.predicted[n + element]);
            if size > *limit {
                self.predicted[element] *= limit / size;
                self.predicted[n + element] *= limit / size;
            }
        }
        traction.set(|element| [self.predicted[element], self.predicted[n + element]]);
    }

    /// Learns how a step of `length` has changed the tractions, where one was predicted.
    pub(crate) fn learn(&mut self, length: f64, traction: &Tractions) {
        let mut change = std::mem::take(&mut self.begin);
        let now = traction.own.iter().flatten();
        change.iter_mut().zip(now).for_each(|(change, now)| *change = now - *change);
        self.trend = Some(Trend { length, change });
    }
}
