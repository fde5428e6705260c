//! Predictor of a step's solution: tractions and creepages from which it is sought.
//!
//! They go on as in the last step, in proportion to its length; on the finer grid comes what the coarser
//! has found to differ from that, so that a jump of the motion is foreseen too.

use std::sync::Arc;

use super::history::{Creep, Past};
use crate::coulomb::influence::Tractions;
use crate::coulomb::mesh::Mesh;

/// Change of the contact in the last step.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Trend {
    pub length: f64,
    /// Of tractions, all `x` before all `y`.
    pub change: Vec<f64>,
    /// Of forces by the creepages that were sought for them, as last known.
    pub slope: Option<Slope>,
}

/// Derivatives of `(fx, fy, mz)`, row after row, by `(xi, eta, chi)`; zero where none was sought.
pub(crate) type Slope = [[f64; 3]; 3];

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
    /// The creepage predicted.
    creep: Creep,
    /// Of this step, as last known.
    pub slope: Option<Slope>,
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

    /// The creepage in the middle of a step, if it goes on as in the last two; `coarse` is the prediction
    /// for the coarser grid and what that has found.
    pub(crate) fn predict_creep(
        &mut self,
        (length, smooth): (f64, bool),
        past: &Past,
        coarse: Option<(&Self, Creep)>,
        from: Creep,
    ) -> Creep {
        self.creep = from;
        let mut levels = past.0.iter();
        if let (true, Some(last), Some(before)) = (smooth, levels.next(), levels.next())
            && last.smooth
            && length <= LONGER * last.length
        {
            let times = (length + last.length) / (last.length + before.length);
            self.creep = [0, 1, 2].map(|k| from[k] + times * (last.creep[k] - before.creep[k]));
        }
        if let Some((coarse, found)) = coarse {
            (0..3).for_each(|k| self.creep[k] += found[k] - coarse.creep[k]);
        }
        self.creep
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
            // Tractions of adhesion grow with the way.
            self.slope = last.slope.map(|slope| slope.map(|row| row.map(|by| times * by)));
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

    /// Goes back to the tractions at the beginning of the step.
    pub(crate) fn take_back(&mut self, traction: &mut Tractions) {
        self.slope = None;
        let [x, y] = [0, self.begin.len() / 2];
        traction.set(|element| [self.begin[x + element], self.begin[y + element]]);
    }

    /// Learns how a step of `length` has changed the tractions, where one was predicted.
    pub(crate) fn record_step(&mut self, length: f64, traction: &Tractions) {
        let mut change = std::mem::take(&mut self.begin);
        let now = traction.own.iter().flatten();
        change.iter_mut().zip(now).for_each(|(change, now)| *change = now - *change);
        self.trend = Some(Trend { length, change, slope: self.slope });
    }
}
