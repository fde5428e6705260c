//! Particles that arrive at a cell: traction, friction and slip where they were before.

use super::super::history::TimeLevel;
use super::super::particle::BISECTIONS;
use super::march::March;
use crate::approximate::fastsim::friction_bound::Walk;
use crate::numerics::bisect;

/// Cells and their weights; what is missing to one is the leading edge, without traction.
type Spread = [(usize, f64); 4];

/// Parts of the last step from which a particle that has just entered counts at least.
const SHORTEST: f64 = 0.01;

impl March<'_> {
    /// The particle now at cell `i` of a strip, at `x`, as it was some way back, and that way.
    pub(super) fn arriving(
        &self,
        [strip, i]: [usize; 2],
        x: f64,
        present: &TimeLevel,
    ) -> (Walk, f64) {
        let (own, cells, origin) = (&self.of.strips[strip], self.of.cells, self.ages.origin());
        let way = self.scale * 2.0 * own.half_length / cells as f64;
        let edge = if i == 0 { 0.5 * way } else { way };
        let upstream = (i > 0).then(|| strip * cells + i - 1);
        if self.ages.is_constant(edge.min(origin)) {
            let (back, own) = (edge.min(origin), strip * cells + i);
            let part = back / edge;
            let none = (own, 0.0);
            let cell = (own, 1.0 - part);
            let spread = [cell, upstream.map_or(none, |upstream| (upstream, part)), none, none];
            return (self.known(upstream, &spread, back, present), back);
        }
        let y = self.scale * own.y;
        let place = |age: f64| [(x + age) / self.ages.scale(age), y / self.ages.scale(age)];
        let is_inside = |age: f64| self.is_inside(place(age));
        // Bounds that change fast cut the traction on the way: then it is followed step by step.
        let limit = way.min(origin);
        let is_slow = self.ages.keeps_size(limit);
        let limit = if is_slow { limit } else { limit.min(self.ages.back[1]) };
        if is_inside(limit) {
            let spread = self.spread(place(limit));
            return (self.known(upstream, &spread, limit, present), limit);
        }
        let shortest = SHORTEST * limit.min(self.ages.back[1]);
        (Walk::start(), bisect(0.0, limit, BISECTIONS, is_inside).max(shortest))
    }

    /// Traction, friction and slip of the particle that was between cells some way back.
    fn known(
        &self,
        upstream: Option<usize>,
        spread: &Spread,
        back: f64,
        present: &TimeLevel,
    ) -> Walk {
        let weights = self.ages.weights(back);
        let past = &self.of.past.0;
        let mut walk = Walk::start();
        let rest = walk.friction;
        walk.friction = 0.0;
        for (level, weight) in weights.levels {
            add(&mut walk, &past[level], spread, rest, weight);
        }
        if weights.present != 0.0 {
            // The present one differs from that of the cell upstream as the latest did.
            add(&mut walk, &past[0], spread, rest, weights.present);
            if let Some(cell) = upstream {
                let whole = [(cell, 1.0), (cell, 0.0), (cell, 0.0), (cell, 0.0)];
                add(&mut walk, present, &whole, rest, weights.present);
                add(&mut walk, &past[0], &whole, rest, -weights.present);
            }
        }
        (walk.friction, walk.slip) = (walk.friction.clamp(0.0, rest), walk.slip.max(0.0));
        walk
    }

    /// Whether a place over the contact's size lies within it.
    fn is_inside(&self, [x, y]: [f64; 2]) -> bool {
        let [a, b] = self.of.semi_axes;
        (x / a).powi(2) + (y / b).powi(2) < 1.0
    }

    /// Cells around a place over the contact's size, with the weights of linear interpolation.
    fn spread(&self, [x, y]: [f64; 2]) -> Spread {
        let ([a, b], cells) = (self.of.semi_axes, self.of.cells);
        let half = a * (1.0 - (y / b).powi(2)).max(f64::MIN_POSITIVE).sqrt();
        let along = beside(0.5 * (1.0 - x / half) * cells as f64, cells);
        // In front of the first cell the traction falls to nothing at the edge.
        let edge = ((1.0 - x / half) * cells as f64).clamp(0.0, 1.0);
        let strips = self.of.strips.len();
        let across = beside(0.5 * (1.0 + y / b) * strips as f64, strips);
        let at = |j: usize, i: usize| {
            let ((strip, by_strip), (cell, by_cell)) = (across[j], along[i]);
            (strip * cells + cell, by_strip * by_cell * edge)
        };
        [at(0, 0), at(0, 1), at(1, 0), at(1, 1)]
    }
}

/// The two of `count` cells whose middles are next to a place counted in cells, with their weights.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
fn beside(place: f64, count: usize) -> [(usize, f64); 2] {
    let place = (place - 0.5).clamp(0.0, (count - 1) as f64);
    let first = (place as usize).min(count.saturating_sub(2));
    let part = place - first as f64;
    [(first, 1.0 - part), ((first + 1).min(count - 1), part)]
}

/// Adds a level's tractions, friction and slip, `rest` the friction where a particle enters.
fn add(walk: &mut Walk, level: &TimeLevel, spread: &Spread, rest: f64, weight: f64) {
    let mut friction = rest;
    for (cell, part) in spread {
        let traction = level.at(*cell);
        (0..2).for_each(|k| walk.traction[k] += weight * part * traction[k]);
        if let (Some(known), Some(slip)) =
            (level.friction[0].get(*cell), level.friction[1].get(*cell))
        {
            friction += part * (known - rest);
            walk.slip += weight * part * slip;
        }
    }
    walk.friction += weight * friction;
}
