//! Transfer of a rolling contact's state to other areas: a contact that moves over its bodies, grows, splits or joins.
//!
//! What a contact remembers are displacements of the surfaces. On other areas those of the tractions before are
//! computed at the new points, by the same sums over elements as everywhere: tractions are carried, displacements
//! follow from them, and nothing is interpolated. Where areas split, each element's traction goes with one of them;
//! where they join, displacements add.

use std::collections::VecDeque;

use super::history::{Creep, TimeLevel};
use super::level::TransientLevel;
use super::motion::Motion;
use super::rolling::Rolling;
use crate::coulomb::boussinesq_cerruti::Cuts;
use crate::{Creepage, Scaling};

/// A contact that rolled before, seen from the one that goes on.
#[derive(Clone, Copy)]
pub struct Before<'a> {
    /// How it rolled.
    pub rolling: &'a Rolling,
    /// Its units.
    pub scaling: Scaling,
    /// Where its origin of coordinates lies in the new coordinates (m).
    pub origin: [f64; 2],
    /// Whether the traction of an element whose centre lies there, in its own coordinates (m), goes with the new
    /// contact.
    pub goes_on: &'a (dyn Fn([f64; 2]) -> bool + Sync),
}

impl std::fmt::Debug for Before<'_> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { scaling, origin, .. } = self;
        formatter
            .debug_struct("Before")
            .field("scaling", scaling)
            .field("origin", origin)
            .finish_non_exhaustive()
    }
}

impl Rolling {
    /// Goes on, just pressed together on areas of any shape in units `scaling`, from what rolled before on others of
    /// the same like bodies, in planes that differ by small turns: components of tractions are kept.
    ///
    /// Where one contact goes on as one, all that it did since it began counts; where areas split or join, what it
    /// is at. Memories of friction and layers are not carried.
    pub fn carry(&mut self, scaling: Scaling, before: &[Before<'_>]) {
        let is_alone = matches!(before, [one] if one.keeps_all());
        for (level, track) in self.tracks.iter_mut().enumerate() {
            let mut all: Option<VecDeque<TimeLevel>> = None;
            for one in before {
                let old = &one.rolling.tracks[level];
                let levels = if is_alone { old.tractions.len().max(1) } else { 1 };
                let own = one.levels(old, track, scaling, levels);
                all = Some(match all {
                    None => own,
                    Some(sum) => added(sum, own),
                });
            }
            if let Some(levels) = all {
                track.past.0 = levels;
            }
        }
        let [one, ..] = before else { return };
        if is_alone {
            let ratio = one.scaling.length / scaling.length;
            self.control.next = self.control.next.max(ratio * one.rolling.control.next);
            let creep = one.creep(one.rolling.tracks[1].creep, scaling);
            self.tracks.iter_mut().for_each(|track| track.creep = creep);
            let [xi, eta, chi] = creep;
            let motion = Motion::from(Creepage { xi, eta, chi });
            self.travel.motion = one.rolling.travel.motion.map(|_| motion);
        }
        let (travel, length) = (one.rolling.travel, one.scaling.length / scaling.length);
        self.travel.distance = travel.distance * length;
        self.travel.force = [0, 1, 2].map(|k: usize| {
            let unit = if k == 2 { length } else { 1.0 };
            let part = |one: &Before<'_>| one.rolling.travel.force[k] * one.scaling.force;
            unit * before.iter().map(part).sum::<f64>() / scaling.force
        });
    }
}

impl Before<'_> {
    /// Whether all of its tractions go on.
    fn keeps_all(&self) -> bool {
        let centroids = &self.rolling.tracks[1].grid.pressure.centroids;
        centroids.iter().all(|at| (self.goes_on)(at.map(|x| x * self.scaling.length)))
    }

    /// A creepage of its own about the new origin, in the new units.
    fn creep(&self, [xi, eta, chi]: Creep, to: Scaling) -> Creep {
        let slip = self.scaling.slip / to.slip;
        let chi = chi * slip * to.length / self.scaling.length;
        let [x, y] = self.origin.map(|at| at / to.length);
        [xi * slip + chi * y, eta * slip - chi * x, chi]
    }

    /// What one of its grids remembers of so many levels, at the points of a grid of the new contact.
    fn levels(
        &self,
        old: &TransientLevel,
        new: &TransientLevel,
        to: Scaling,
        count: usize,
    ) -> VecDeque<TimeLevel> {
        let own = self.scaling;
        let centroids = &old.grid.pressure.centroids;
        let goes_on: Vec<bool> =
            centroids.iter().map(|at| (self.goes_on)(at.map(|x| x * own.length))).collect();
        let mut tractions: Vec<[Vec<f64>; 2]> = old.tractions.iter().take(count).cloned().collect();
        if tractions.is_empty() {
            tractions.push(old.state.traction.own.clone());
        }
        for values in tractions.as_flattened_mut() {
            values.iter_mut().zip(&goes_on).filter(|(_, on)| !**on).for_each(|(t, _)| *t = 0.0);
        }
        let unit = own.slip * own.length / (to.slip * to.length);
        let points = new.elements.points();
        let mut displacements: Vec<[Vec<f64>; 2]> =
            tractions.iter().map(|_| [vec![0.0; points], vec![0.0; points]]).collect();
        let mut cuts = Cuts::new(&old.grid.mesh, old.elements.units.clone());
        let mut by: [Vec<f64>; 3] = std::array::from_fn(|_| vec![0.0; old.grid.mesh.len()]);
        for row in &new.elements.rows {
            for (k, x) in row.x.iter().enumerate() {
                let at = [*x * to.length - self.origin[0], row.y * to.length - self.origin[1]];
                let at = at.map(|x| x / own.length);
                cuts.displace(old.elements.poisson, at, by.each_mut().map(Vec::as_mut_slice));
                for (displacement, [px, py]) in displacements.iter_mut().zip(&tractions) {
                    let sum = |a: &[f64], p: &[f64], b: &[f64], q: &[f64]| -> f64 {
                        let one = a.iter().zip(p).map(|(a, p)| a * p);
                        one.zip(b.iter().zip(q)).map(|(one, (b, q))| one + b * q).sum()
                    };
                    displacement[0][row.first + k] = unit * sum(&by[0], px, &by[1], py);
                    displacement[1][row.first + k] = unit * sum(&by[1], px, &by[2], py);
                }
            }
        }
        let length = own.length / to.length;
        let steps = old.past.0.iter().map(|level| (level.length, level.creep, level.smooth));
        let steps = steps.chain(std::iter::repeat((0.0, old.creep, false)));
        displacements
            .into_iter()
            .zip(steps)
            .map(|(displacement, (step, creep, smooth))| TimeLevel {
                length: step * length,
                scale: 1.0,
                creep: self.creep(creep, to),
                smooth,
                displacement,
                friction: [vec![], vec![], vec![]],
            })
            .collect()
    }
}

/// Displacements of two contacts that go on as one.
fn added(mut sum: VecDeque<TimeLevel>, other: VecDeque<TimeLevel>) -> VecDeque<TimeLevel> {
    for (sum, other) in sum.iter_mut().zip(other) {
        let parts = sum.displacement.iter_mut().zip(&other.displacement);
        for (sum, other) in parts {
            sum.iter_mut().zip(other).for_each(|(sum, other)| *sum += other);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coulomb::Resolution;
    use crate::gap::{Gap, Term};
    use crate::normal::{self, NormalContact};
    use crate::{Solid, SolidPair};

    const FRICTION: f64 = 0.3;
    const KEEPS: &(dyn Fn([f64; 2]) -> bool + Sync) = &|_| true;

    /// A crowned roller whose crown lies at `y` (m), under a load (N).
    fn roller(y: f64, load: f64) -> NormalContact {
        let term = |x, y, coefficient| Term { x, y, coefficient };
        let curvature = 1.0 / (2.0 * 0.3);
        let terms = [
            term(2, 0, 1.0 / (2.0 * 0.46)),
            term(0, 2, curvature),
            term(0, 1, -2.0 * curvature * y),
            term(0, 0, curvature * y * y),
        ];
        let steel = Solid::new(82e9, 0.28).unwrap();
        let gap = Gap::polynomial(&terms).unwrap();
        let pair = SolidPair::new(steel, steel);
        NormalContact::under_load(&gap, pair, load, normal::Resolution::STANDARD).unwrap()
    }

    fn pressed(contact: &NormalContact) -> (Rolling, Scaling) {
        let rolling = Rolling::on_areas(contact, FRICTION, None, Resolution::FAST).unwrap();
        (rolling, contact.scaling(FRICTION).unwrap())
    }

    /// Creepage and spin in SI units about a point at `y`, where those at zero are given.
    fn motion(scaling: Scaling, [along, across, spin]: [f64; 3], y: f64) -> Motion {
        let length = scaling.length;
        let [xi, eta] = [along - spin * y, across].map(|part| part / scaling.slip);
        Motion::from(Creepage { xi, eta, chi: spin * length / scaling.slip })
    }

    const GIVEN: [f64; 3] = [-1e-3, 5e-4, 0.1];
    const STEP_LENGTH: f64 = 2e-3;

    /// Forces (N) after a step of the length, from where a contact is.
    fn rolled(rolling: &mut Rolling, scaling: Scaling, y: f64, length: f64) -> [f64; 2] {
        let force = rolling.step(length / scaling.length, &motion(scaling, GIVEN, y));
        let force = force.unwrap().solution.force;
        [force.fx, force.fy].map(|part| scaling.force * part)
    }

    fn apart([x, y]: [f64; 2], [u, v]: [f64; 2], scaling: Scaling) -> f64 {
        (x - u).hypot(y - v) / scaling.force
    }

    #[test]
    fn the_same_contact_goes_on_as_it_did() {
        let contact = roller(0.0, 40e3);
        let (mut before, scaling) = pressed(&contact);
        rolled(&mut before, scaling, 0.0, STEP_LENGTH);
        let (mut after, _) = pressed(&contact);
        let of = Before { rolling: &before, scaling, origin: [0.0; 2], goes_on: KEEPS };
        after.carry(scaling, &[of]);
        assert!((after.distance() - before.distance()).abs() < 1e-12);
        let [carried, gone_on] =
            [&mut after, &mut before].map(|one| rolled(one, scaling, 0.0, STEP_LENGTH));
        // The same past, whose displacements are summed in another order; iterations stop at 1e-7.
        let missed = apart(carried, gone_on, scaling);
        assert!(missed < 1e-5, "{missed}: {carried:?} {gone_on:?}");
    }

    /// Moved coordinates are the same contact.
    #[test]
    fn coordinates_do_not_matter() {
        let (old, new) = (roller(0.0, 40e3), roller(4e-3, 40e3));
        let (mut before, scaling) = pressed(&old);
        rolled(&mut before, scaling, 0.0, STEP_LENGTH);
        let (mut after, to) = pressed(&new);
        let of = Before { rolling: &before, scaling, origin: [0.0, 4e-3], goes_on: KEEPS };
        after.carry(to, &[of]);
        let carried = rolled(&mut after, to, -4e-3, STEP_LENGTH);
        let gone_on = rolled(&mut before, scaling, 0.0, STEP_LENGTH);
        // The pressing finds the area on another grid: to 1e-3.
        let missed = apart(carried, gone_on, scaling);
        assert!(missed < 2e-3, "{missed}: {carried:?} {gone_on:?}");
    }

    /// A contact that moves over the rail and is loaded more has, just after, the force that it had.
    #[test]
    fn forces_do_not_jump() {
        let (mut before, scaling) = pressed(&roller(0.0, 40e3));
        let last = rolled(&mut before, scaling, 0.0, STEP_LENGTH);
        for (shift, load, most) in [(0.0, 40e3, 1e-3), (5e-5, 40.2e3, 1e-2), (5e-6, 40.02e3, 2e-3)]
        {
            let (mut after, to) = pressed(&roller(0.0, load));
            let of = Before { rolling: &before, scaling, origin: [0.0, shift], goes_on: KEEPS };
            after.carry(to, &[of]);
            let next = rolled(&mut after, to, 0.0, 1e-6);
            let missed = apart(next, last, scaling);
            assert!(missed < most, "{shift} {load}: {missed}: {next:?} {last:?}");
        }
    }

    /// Parts of an area add up to all of it.
    #[test]
    fn parts_join() {
        let contact = roller(0.0, 40e3);
        let (mut before, scaling) = pressed(&contact);
        rolled(&mut before, scaling, 0.0, STEP_LENGTH);
        let [low, high] = [|[_, y]: [f64; 2]| y < 0.0, |[_, y]: [f64; 2]| y >= 0.0];
        let of = |goes_on| Before { rolling: &before, scaling, origin: [0.0; 2], goes_on };
        let (mut joined, _) = pressed(&contact);
        joined.carry(scaling, &[of(&low), of(&high)]);
        let (mut alone, _) = pressed(&contact);
        alone.carry(scaling, &[of(KEEPS)]);
        let [parts, whole] = [&joined, &alone].map(|one| one.tracks[1].past.0[0].clone());
        let largest =
            whole.displacement.iter().flatten().fold(0.0, |most: f64, u| most.max(u.abs()));
        for (one, other) in
            parts.displacement.iter().flatten().zip(whole.displacement.iter().flatten())
        {
            assert!((one - other).abs() < 1e-12 * largest);
        }
        let [one, other] =
            [&mut joined, &mut alone].map(|one| rolled(one, scaling, 0.0, STEP_LENGTH));
        // Of parts only what they are at counts, and particles look back to there.
        let missed = apart(one, other, scaling);
        assert!(missed < 2e-3, "{missed}: {one:?} {other:?}");
    }

    /// Rows of an equal motion, each on areas pressed for themselves, go to steady rolling.
    #[test]
    fn equal_rows_go_to_steady_rolling() {
        let contact = roller(0.0, 40e3);
        let (mut rolling, scaling) = pressed(&contact);
        for row in 0..30 {
            // The load alternates by a thousandth, so that no row has the area of the one before.
            let (mut next, to) = pressed(&roller(0.0, if row % 2 == 0 { 40e3 } else { 40.04e3 }));
            next.carry(
                to,
                &[Before { rolling: &rolling, scaling, origin: [0.0; 2], goes_on: KEEPS }],
            );
            rolled(&mut next, to, 0.0, 1e-3);
            rolling = next;
        }
        let last = rolled(&mut rolling, scaling, 0.0, 1e-3);
        let (mut steady, _) = pressed(&contact);
        let force = steady.start_steady(&motion(scaling, GIVEN, 0.0)).unwrap().solution.force;
        let steady = [force.fx, force.fy].map(|part| scaling.force * part);
        // Loads differ by 1e-3, elements as the coarse grid has them.
        let missed = apart(last, steady, scaling);
        assert!(missed < 3e-3, "{missed}: {last:?} {steady:?}");
    }
}
