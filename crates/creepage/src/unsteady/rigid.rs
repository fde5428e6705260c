//! Rigid motion of the bodies against each other, integrated backwards from the present.

use super::history::{Ages, Past};

/// Rigid slip along a way, integrated: `xi`, `eta`, `chi`, and `chi` times the distance back.
pub(crate) type RigidSlip = [f64; 4];

/// The same of a unit of creepage in the present step: its length, and its moment.
type Present = [f64; 2];

/// Rigid displacement of the bodies against each other since the end of every level.
///
/// Between these ends it is interpolated as displacements are: for adhering particles the two are the
/// same, and would differ to first order in the step if the creepage were the mean of a step here and
/// its slope at the end there.
#[derive(Debug, Clone)]
pub(crate) struct RigidMotion<'a> {
    past: &'a Past,
    ages: &'a Ages,
    length: f64,
    /// Since the end of each level, without the present step.
    since: Vec<RigidSlip>,
}

impl<'a> RigidMotion<'a> {
    /// `length` is that of the present step.
    pub(crate) fn new(past: &'a Past, ages: &'a Ages, length: f64) -> Self {
        let mut motion = Self { past, ages, length, since: Vec::with_capacity(past.0.len()) };
        motion.since.extend(ages.back[1..].iter().map(|age| along(past, ages, *age)));
        motion
    }

    /// From a distance back to the present: by the past, and by a unit of creepage in the present step.
    pub(crate) fn back_to(&self, age: f64) -> (RigidSlip, Present) {
        let weights = self.ages.weights(age);
        if !weights.is_curved {
            return (along(self.past, self.ages, age), part(age.min(self.length)));
        }
        let (mut past, mut known) = ([0.0; 4], 0.0);
        for (level, weight) in weights.levels {
            known += weight;
            past.iter_mut().zip(self.since[level]).for_each(|(sum, own)| *sum += weight * own);
        }
        (past, part(self.length).map(|whole| known * whole))
    }
}

/// The past motion from a distance back on.
fn along(past: &Past, ages: &Ages, to: f64) -> RigidSlip {
    let mut sums = [0.0; 4];
    for (level, start) in past.0.iter().zip(&ages.back[1..]) {
        if *start >= to {
            break;
        }
        let end = (start + level.length).min(to);
        let [[length, moment], [before, moment_before]] = [part(end), part(*start)];
        let (length, moment) = (length - before, moment - moment_before);
        let [xi, eta, chi] = level.creep;
        let own = [xi * length, eta * length, chi * length, chi * moment];
        sums.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
    }
    sums
}

/// Length and moment of the way back to some distance.
fn part(age: f64) -> Present {
    [age, 0.5 * age * age]
}
