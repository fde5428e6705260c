//! Friction with memory and yielding layers in transient rolling: what particles bring along from upstream.

use super::elements::Elements;
use super::history::{Ages, Past, TimeLevel, Weights};
use crate::coulomb::friction_bound::Arriving;

impl Elements {
    /// Friction, slip and plastic displacement of the particles now at all elements, one step of elements
    /// upstream, in a step of `length` to the size `scale`. What enters the contact has friction at rest and
    /// a layer that has not yielded.
    pub(crate) fn arriving(&self, past: &Past, length: f64, scale: f64) -> Vec<Arriving> {
        let ages = past.seen_after(length, scale, true);
        let arriving = |(index, element): (usize, &super::elements::Element)| {
            let step = element.steps[0] * scale;
            let back = step.min(ages.origin());
            let upstream = (element.steps[1] > 0.0).then(|| index - 1);
            before(past, &ages, (back, back / step), (index, upstream))
        };
        self.all.iter().enumerate().map(arriving).collect()
    }

    /// The same while the bodies are shifted: particles stay where they are.
    pub(crate) fn staying(&self, level: &TimeLevel) -> Vec<Arriving> {
        let of = |element: usize| {
            let plastic = level.friction[2].get(element).copied().unwrap_or(0.0);
            Arriving { present: 0.0, friction: 1.0, slip: 0.0, plastic, step: 0.0 }
        };
        (0..self.all.len()).map(of).collect()
    }
}

/// A particle now at element `index`, where it was `back`, `ahead` of the way to the element `upstream`.
fn before(
    past: &Past,
    ages: &Ages,
    (back, ahead): (f64, f64),
    (index, upstream): (usize, Option<usize>),
) -> Arriving {
    let (scale, weights) = (ages.scales[0], ages.weights(back));
    let Weights { present, levels, .. } = weights;
    let step = back / scale;
    let mut arriving = Arriving { present, friction: 0.0, slip: 0.0, plastic: 0.0, step };
    if upstream.is_none() {
        arriving.friction = present;
    }
    for (level, weight) in levels {
        let of = |of: usize, element: usize| past.0[level].friction[of].get(element).copied();
        let known = |k: usize| of(k, upstream?);
        arriving.friction += weight * known(0).unwrap_or(1.0);
        arriving.slip += weight / scale * known(1).unwrap_or(0.0);
        let [here, there] = [of(2, index), known(2)].map(|plastic| plastic.unwrap_or(0.0));
        arriving.plastic += weight * (ahead * there + (1.0 - ahead) * here);
    }
    if upstream.is_none() {
        arriving.present = 0.0;
    }
    arriving.plastic = arriving.plastic.max(0.0);
    arriving
}
