//! History of a rolling contact: displacements at the centres, and how the bodies moved, level by level.

use std::collections::VecDeque;

/// Longitudinal and lateral creepage and spin, dimensionless.
pub(crate) type Creep = [f64; 3];

/// The state of the contact at the end of a step.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TimeLevel {
    /// Distance of the step.
    pub length: f64,
    /// Size of the contact over that of its nominal load, at the end of the step.
    pub scale: f64,
    /// Creepage in the step.
    pub creep: Creep,
    /// Whether the displacements go on smoothly from the step before.
    pub smooth: bool,
    /// Displacements of all points: all `x`, all `y`.
    pub displacement: [Vec<f64>; 2],
    /// Of all elements, where friction or a layer remembers: friction over that at rest, the size of the slip,
    /// and the plastic displacement of the layer.
    pub friction: [Vec<f64>; 3],
}

/// Levels from the latest to the oldest, at which the past begins.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Past(pub VecDeque<TimeLevel>);

/// Interpolation weights at some distance back: the factor of the present one, and levels with theirs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Weights {
    pub present: f64,
    pub levels: [(usize, f64); 3],
    /// Whether three are needed.
    pub is_curved: bool,
}

impl Weights {
    pub(crate) const PRESENT: Self = Self { present: 1.0, levels: [(0, 0.0); 3], is_curved: false };
}

/// The past seen from the end of a step that is being solved.
#[derive(Debug, Clone)]
pub(crate) struct Ages {
    /// Distances back: of the present, and of every level.
    pub back: Vec<f64>,
    /// Size of the contact at each.
    pub scales: Vec<f64>,
    /// Whether what ends at each goes on smoothly from what is before it.
    smooth: Vec<bool>,
}

/// Where the contact changes its size by more than this fraction, displacements change by all of
/// themselves.
const RESIZED: f64 = 0.02;
/// A step so much shorter than the one after it does not tell how that curves.
const TOO_SHORT: f64 = 0.3;

impl Past {
    /// The past at the end of a step of `length` that brings the contact to the size `scale`.
    pub(crate) fn seen_after(&self, length: f64, scale: f64, smooth: bool) -> Ages {
        let mut age = length;
        let (mut ages, mut scales, mut kinks) = (vec![0.0], vec![scale], vec![smooth]);
        for level in &self.0 {
            ages.push(age);
            scales.push(level.scale);
            kinks.push(level.smooth);
            age += level.length;
        }
        Ages { back: ages, scales, smooth: kinks }
    }

    /// Forgets what lies further back than `reach`, but for what interpolation needs.
    pub(crate) fn forget_beyond(&mut self, reach: f64) {
        let mut age = 0.0;
        let mut needed = 0;
        for level in &self.0 {
            needed += 1;
            if age > reach {
                break;
            }
            age += level.length;
        }
        self.0.truncate(needed + 2);
    }
}

impl Ages {
    /// How far back the past begins.
    pub(crate) fn origin(&self) -> f64 {
        self.back.last().copied().unwrap_or(0.0)
    }

    /// Size of the contact at a distance back.
    pub(crate) fn scale(&self, age: f64) -> f64 {
        let k = self.interval(age);
        let t = (age - self.back[k]) / (self.back[k + 1] - self.back[k]);
        self.scales[k] + t * (self.scales[k + 1] - self.scales[k])
    }

    /// Whether the contact had one size all the way back to some distance.
    #[allow(clippy::float_cmp)] // a size that was not changed has the same bits
    pub(crate) fn is_constant(&self, age: f64) -> bool {
        let end = self.interval(age) + 1;
        self.scales[..=end].iter().all(|scale| *scale == self.scales[0])
    }

    /// Interpolation at a distance back: quadratic where there is a smooth step before.
    pub(crate) fn weights(&self, age: f64) -> Weights {
        let k = self.interval(age);
        let [near, far] = [self.back[k], self.back[k + 1]];
        let t = (age - near) / (far - near);
        let Some(&before) = self.back.get(k + 2) else { return self.linear(k, t) };
        let is_short = before - far < TOO_SHORT * (far - near);
        if is_short || !self.is_smooth(k) || (k == 0 && age > far) {
            return self.linear(k, t);
        }
        let own = (age - far) * (age - before) / ((near - far) * (near - before));
        let next = (age - near) * (age - before) / ((far - near) * (far - before));
        let third = (age - near) * (age - far) / ((before - near) * (before - far));
        Weights { is_curved: true, ..self.of(k, [own, next, third]) }
    }

    /// Whether both steps from age `k` on back are one smooth way: of the motion, and of the load.
    fn is_smooth(&self, k: usize) -> bool {
        self.smooth[k] && is_alike(&self.scales[k..=k + 2])
    }

    /// Whether the contact kept its size, but for a smooth change, all the way back to some distance.
    pub(crate) fn keeps_size(&self, age: f64) -> bool {
        is_alike(&self.scales[..=self.interval(age) + 1])
    }

    fn linear(&self, k: usize, t: f64) -> Weights {
        self.of(k, [1.0 - t, t, 0.0])
    }

    /// Ages `k`, `k + 1`, `k + 2` are those of the levels `k - 1`, `k`, `k + 1`.
    fn of(&self, k: usize, [a, b, c]: [f64; 3]) -> Weights {
        let oldest = self.back.len() - 2;
        let (present, levels) = match k {
            0 => (a, [(0, b), (oldest.min(1), c), (0, 0.0)]),
            k => (0.0, [(k - 1, a), (k, b), (oldest.min(k + 1), c)]),
        };
        Weights { present, levels, is_curved: false }
    }

    /// The interval between two ages that holds one; the last beyond the origin.
    fn interval(&self, age: f64) -> usize {
        let later = self.back.partition_point(|known| *known <= age);
        later.clamp(1, self.back.len().max(2) - 1) - 1
    }
}

/// Whether sizes differ little from the first.
fn is_alike(scales: &[f64]) -> bool {
    let [now, before @ ..] = scales else { return true };
    before.iter().all(|scale| (scale - now).abs() <= RESIZED * now)
}
