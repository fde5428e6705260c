//! Friction that follows the slip with a delay: what particles bring along from upstream.

use super::elements::Elements;
use super::history::{Ages, Past, Weights};
use crate::coulomb::friction_bound::Arriving;

impl Elements {
    /// Friction and slip of the particles now at all elements, one step of elements upstream, in a step
    /// of `length` to the size `scale`. What enters the contact has friction at rest.
    pub(crate) fn arriving(&self, past: &Past, length: f64, scale: f64) -> Vec<Arriving> {
        let ages = past.seen_after(length, scale, true);
        let arriving = |(index, element): (usize, &super::elements::Element)| {
            let back = (element.steps[0] * scale).min(ages.origin());
            let upstream = (element.steps[1] > 0.0).then(|| index - 1);
            before(past, &ages, back, upstream)
        };
        self.all.iter().enumerate().map(arriving).collect()
    }
}

fn before(past: &Past, ages: &Ages, back: f64, upstream: Option<usize>) -> Arriving {
    let (scale, weights) = (ages.scales[0], ages.weights(back));
    let Weights { present, levels, .. } = weights;
    let mut arriving = Arriving { present, friction: 0.0, slip: 0.0, step: back / scale };
    if upstream.is_none() {
        arriving.friction = present;
    }
    for (level, weight) in levels {
        let known = |of: usize| past.0[level].friction[of].get(upstream?).copied();
        arriving.friction += weight * known(0).unwrap_or(1.0);
        arriving.slip += weight / scale * known(1).unwrap_or(0.0);
    }
    if upstream.is_none() {
        arriving.present = 0.0;
    }
    arriving
}
