//! March of one transient step of FASTSIM at a creepage: every particle from where it was to the cell where it is.

use super::super::history::{Ages, Creep, TimeLevel};
use super::{RollingFastsim, Strip};
use crate::approximate::fastsim::friction_bound::{Step, Walk};

/// Force and moment of tractions.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sum {
    pub force: [f64; 3],
    pub adhesion: f64,
    pub area: f64,
    pub dissipation: f64,
}

/// March of one step.
pub(super) struct March<'a> {
    pub of: &'a RollingFastsim,
    pub ages: Ages,
    /// Size of the contact at its end.
    pub scale: f64,
}

impl RollingFastsim {
    /// A step of some length to some size, at a creepage.
    pub(super) fn march(&self, [length, scale]: [f64; 2], creep: Creep) -> (TimeLevel, Sum) {
        let ages = self.past.seen_after(length, scale, true);
        let march = March { of: self, ages, scale };
        let level = super::level(length, scale, self.size(), self.resistance.is_some());
        let (mut level, mut sum) = (TimeLevel { creep, smooth: true, ..level }, Sum::default());
        for strip in 0..self.strips.len() {
            march.strip(strip, &mut level, &mut sum);
        }
        (level, sum)
    }
}

impl March<'_> {
    fn strip(&self, number: usize, level: &mut TimeLevel, sum: &mut Sum) {
        let (strip, cells) = (&self.of.strips[number], self.of.cells);
        let step = 2.0 * strip.half_length / cells as f64;
        for i in 0..cells {
            let cell = number * cells + i;
            let x = self.scale * (strip.half_length - (i as f64 + 0.5) * step);
            let (mut walk, back) = self.arriving([number, i], x, level);
            let creep = self.mean(level, back);
            let slides = self.advance(&mut walk, strip, [x, back], strip.along[i], creep);
            (0..2).for_each(|k| level.displacement[k][cell] = walk.traction[k]);
            for (values, value) in level.friction.iter_mut().zip([walk.friction, walk.slip]) {
                values.get_mut(cell).into_iter().for_each(|known| *known = value);
            }
            self.add(sum, strip, x, &walk, slides.then_some((creep, back)));
        }
    }

    /// Adds a cell; where it slides, with the creepage and the way there.
    fn add(&self, sum: &mut Sum, strip: &Strip, x: f64, walk: &Walk, slides: Option<(Creep, f64)>) {
        let (area, y) = (self.scale.powi(2) * strip.area, self.scale * strip.y);
        let [p, q] = walk.traction;
        let parts = [p, q, x * q - y * p];
        sum.force.iter_mut().zip(parts).for_each(|(sum, part)| *sum += area * part);
        sum.area += area;
        let Some((creep, back)) = slides else {
            sum.adhesion += area;
            return;
        };
        let flexibilities = &self.of.flexibilities;
        let [l1, l2, _] = flexibilities.effective(self.of.flexibility, self.own(creep));
        let factor = self.scale / (flexibilities.kappa() * back);
        let slip = [l1 * walk.lost[0], l2 * walk.lost[1]].map(|s| factor * s);
        sum.dissipation += area * (p * slip[0] + q * slip[1]);
    }

    /// A creepage in the units of the contact's present size, for which the flexibilities are.
    fn own(&self, [xi, eta, chi]: Creep) -> Creep {
        [xi / self.scale, eta / self.scale, chi]
    }

    /// Takes a particle over the last `back` of its way to `x`; whether it slides then.
    fn advance(
        &self,
        walk: &mut Walk,
        strip: &Strip,
        [x, back]: [f64; 2],
        along: f64,
        creep: Creep,
    ) -> bool {
        let slopes = self.of.flexibilities.slopes(self.of.flexibility, self.own(creep));
        let y = self.scale * strip.y;
        let place = [(x + 0.5 * back) / self.scale, strip.y];
        let growth = slopes.at(place).map(|slope| back * slope);
        let bound = self.scale * strip.peak * along;
        let Some(resistance) = &self.of.resistance else {
            let trial = [0, 1].map(|k| walk.traction[k] + growth[k]);
            let size = trial[0].hypot(trial[1]);
            let part = if size > bound { bound / size } else { 1.0 };
            walk.traction = trial.map(|t| t * part);
            walk.lost = [0, 1].map(|k| trial[k] - walk.traction[k]);
            return size > bound;
        };
        let [xi, eta, chi] = creep;
        let rigid_slip = [xi - chi * y, eta + chi * x];
        let bound = resistance.share(y) * bound;
        let step = Step { length: back, growth, bound, rigid_slip, flexibility: 0.0 };
        resistance.advance(walk, &step);
        walk.slip > 0.0
    }

    /// Creepage averaged over a way back.
    fn mean(&self, present: &TimeLevel, back: f64) -> Creep {
        let mut sums = present.creep.map(|part| part * back.min(present.length));
        for (level, start) in self.of.past.0.iter().zip(&self.ages.back[1..]) {
            let part = (start + level.length).min(back) - start;
            if part > 0.0 {
                sums.iter_mut().zip(level.creep).for_each(|(sum, creep)| *sum += part * creep);
            }
        }
        sums.map(|sum| sum / back)
    }
}
