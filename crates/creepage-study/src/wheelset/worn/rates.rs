//! Wear rates of the profiles as they are: the contacts of all situations, summed along the profiles.

use creepage::{SiCreepage, Status};
use creepage_rail::{Role, RollingCreepage, Side};
use rayon::prelude::*;

use super::error::WearError;
use super::nodes::{deposit, smoothed};
use super::section::{WearLaw, WearPlan, WearSituation, WornSides};
use super::state::{Bodies, WornBody};
use crate::damage::of_elements;
use crate::wheelset::{WheelsetCase, wheelset_caution_words};
use creepage_wheelset::{SolvedContact, SolvedWheel};
use creepage_wheelset::{SolvedWheelset, WheelsetSolver};

/// Volume over the whole of the distance at each point of each body (m3, of a rail m3/m), if it wore on as it
/// does.
#[derive(Debug, Clone)]
pub(super) struct Rates {
    pub(super) of: [Option<Vec<f64>>; 4],
    /// The sum of each as contacts gave it, before it was laid on points and smoothed.
    pub(super) by_law: [f64; 4],
    /// The greatest depth over the whole of the distance (m).
    pub(super) greatest: f64,
    /// Peak pressure (Pa), by the wear of each contact.
    pub(super) peak: f64,
    /// Situations that did not converge.
    pub(super) doubtful: usize,
    /// Cautions about the solutions, each with the number of its situation.
    pub(super) cautions: Vec<(usize, String)>,
}

/// Solved situations are kept for the end of a step, where they are no more than this.
const KEPT: usize = 2000;

/// One row of elements of a contact after one passage.
struct Strip {
    side: Side,
    /// `y` of the contact in the profiles of wheel and rail (m), place across from there, width, depth (m).
    y: [f64; 2],
    across: f64,
    width: f64,
    depth: f64,
    peak: f64,
}

/// Distance of a run so far (m, passages), for messages.
pub(super) type Reached = [f64; 2];

impl Rates {
    /// The rates of wear where the bodies are as they are, and the situations solved; from those of profiles nearby
    /// where they are known.
    pub(super) fn new(
        case: &WheelsetCase,
        plan: &WearPlan,
        bodies: &Bodies,
        (reached, before): (Reached, &[SolvedWheelset]),
    ) -> Result<(Self, Vec<SolvedWheelset>), WearError> {
        let worn = WheelsetCase { running: bodies.running(&case.running)?, ..case.clone() };
        let solver = worn.solver()?;
        let is_kept = before.is_empty() && plan.situations.len() <= KEPT;
        let solve = |(k, situation): (usize, &WearSituation)| {
            let solved = solve(&worn, &solver, situation, before.get(k)).map_err(|source| {
                let [distance, passages] = reached;
                let source = Box::new(source);
                WearError::Situation { number: k + 1, distance, passages, source }
            })?;
            let strips = strips(plan, &solved);
            if strips.iter().any(|strip| !strip.depth.is_finite()) {
                return Err(WearError::NoWear { number: k + 1 });
            }
            let words = wheelset_caution_words(&solved).into_iter().map(|words| (k + 1, words));
            let (doubtful, words) = (solved.status() != Status::Solved, words.collect::<Vec<_>>());
            Ok((strips, doubtful, words, is_kept.then_some(solved)))
        };
        let all: Vec<_> = plan.situations.par_iter().enumerate().map(solve).collect();
        let mut rates = Self {
            of: [const { None }; 4],
            by_law: [0.0; 4],
            greatest: 0.0,
            peak: 0.0,
            doubtful: 0,
            cautions: Vec::new(),
        };
        let arcs: [Option<Vec<f64>>; 4] =
            WornBody::ALL.map(|body| bodies.of(body).map(super::nodes::Nodes::arcs));
        for (rate, arcs) in rates.of.iter_mut().zip(&arcs) {
            *rate = arcs.as_ref().map(|arcs| vec![0.0; arcs.len()]);
        }
        let mut weight = 0.0;
        // In the order of the situations: the same sums on any number of cores.
        let mut kept = Vec::new();
        for (situation, found) in plan.situations.iter().zip(all) {
            let (strips, doubtful, words, solved) = found?;
            kept.extend(solved);
            rates.doubtful += usize::from(doubtful);
            rates.cautions.extend(words);
            for strip in &strips {
                let worn = situation.share * strip.depth * strip.width;
                (weight, rates.peak) = (weight + worn, rates.peak + worn * strip.peak);
                rates.add(plan, bodies, &arcs, situation.share, strip)?;
            }
        }
        if weight > 0.0 {
            rates.peak /= weight;
        }
        rates.smooth(plan, bodies, &arcs);
        Ok((rates, kept))
    }

    fn add(
        &mut self,
        plan: &WearPlan,
        bodies: &Bodies,
        arcs: &[Option<Vec<f64>>; 4],
        share: f64,
        strip: &Strip,
    ) -> Result<(), WearError> {
        let sense = strip.side.sense();
        for (k, body) in
            WornBody::ALL.into_iter().enumerate().filter(|(_, b)| b.side() == strip.side)
        {
            let (Some(nodes), Some(arcs), Some(rate)) =
                (bodies.of(body), &arcs[k], &mut self.of[k])
            else {
                continue;
            };
            // The wheel's curve runs to the flange, the rail's to the field side. A wheel has a passage in each
            // revolution: depth, length round it and revolutions make depth times distance.
            let (y, along, times) = match body.role() {
                Role::Wheel => (strip.y[0], -sense, plan.distance),
                Role::Rail => (strip.y[1], sense, plan.passages),
            };
            let s = nodes.place(arcs, body.role(), y);
            let s = s.ok_or(WearError::OffProfile { body: body.name(), y })? + along * strip.across;
            let volume = share * times * strip.depth * strip.width;
            self.by_law[k] += volume;
            deposit(arcs, rate, s, strip.width, volume);
        }
        Ok(())
    }

    fn smooth(&mut self, plan: &WearPlan, bodies: &Bodies, arcs: &[Option<Vec<f64>>; 4]) {
        let surfaces: Vec<Option<Vec<f64>>> = WornBody::ALL
            .into_iter()
            .zip(arcs)
            .map(|(body, arcs)| Some(bodies.of(body)?.surfaces(arcs.as_ref()?)))
            .collect();
        for ((rate, arcs), surfaces) in self.of.iter_mut().zip(arcs).zip(&surfaces) {
            if let (Some(rate), Some(arcs), Some(surfaces)) = (rate, arcs, surfaces) {
                *rate = smoothed(arcs, surfaces, rate, plan.smoothing_length);
            }
        }
        if plan.sides == WornSides::Mean {
            for (pair, sums) in self.of.chunks_mut(2).zip(self.by_law.chunks_mut(2)) {
                if let [Some(left), Some(right)] = pair {
                    for (left, right) in left.iter_mut().zip(right) {
                        *left = left.midpoint(*right);
                        *right = *left;
                    }
                    sums.fill(0.5 * (sums[0] + sums[1]));
                }
            }
        }
        let depths = self.of.iter().zip(&surfaces).filter_map(|(rate, surfaces)| {
            let pairs = rate.as_ref()?.iter().zip(surfaces.as_ref()?);
            Some(pairs.map(|(volume, surface)| volume / surface).fold(0.0, f64::max))
        });
        self.greatest = depths.fold(0.0, f64::max);
    }

    /// By how much others differ, in parts of these, by root mean squares.
    pub(super) fn change(&self, other: &Self) -> f64 {
        let (mut apart, mut own) = (0.0, 0.0);
        let pairs = self.of.iter().flatten().zip(other.of.iter().flatten());
        for (one, two) in pairs.flat_map(|(one, two)| one.iter().zip(two)) {
            apart += (two - one) * (two - one);
            own += one * one;
        }
        if own > 0.0 { (apart / own).sqrt() } else { 0.0 }
    }

    /// The mean of these and others, by volumes.
    pub(super) fn mean(&self, other: &Self) -> Self {
        let mut mean = self.clone();
        for (mean, other) in mean.of.iter_mut().flatten().zip(other.of.iter().flatten()) {
            mean.iter_mut().zip(other).for_each(|(a, b)| *a = a.midpoint(*b));
        }
        mean.by_law.iter_mut().zip(&other.by_law).for_each(|(a, b)| *a = a.midpoint(*b));
        mean
    }
}

fn solve(
    case: &WheelsetCase,
    solver: &WheelsetSolver<'_>,
    situation: &WearSituation,
    before: Option<&SolvedWheelset>,
) -> Result<SolvedWheelset, crate::WheelsetFileError> {
    let (stance, travel) = case.asked_in_curve(&situation.asked, situation.curvature)?;
    let solver = match situation.friction {
        own if own.is_nan() => solver.clone(),
        friction => solver.with_friction(friction),
    };
    let near = before.and_then(|before| solver.next(before, &stance, &travel).ok());
    match near {
        Some(solved) if solved.status() == Status::Solved => Ok(solved),
        _ => Ok(solver.solve(&stance, &travel)?),
    }
}

fn strips(plan: &WearPlan, solved: &SolvedWheelset) -> Vec<Strip> {
    let speed = solved.motion.speed.abs();
    let contacts = solved.wheels().flat_map(SolvedWheel::contacts);
    contacts.flat_map(|contact| strips_of(plan, contact, speed)).collect()
}

fn strips_of(plan: &WearPlan, contact: &SolvedContact, speed: f64) -> Vec<Strip> {
    let RollingCreepage { longitudinal, lateral, spin, .. } = contact.creepage;
    let creepage = SiCreepage { longitudinal, lateral, spin };
    let rows = of_elements(&contact.elements(), contact.scaling, contact.load(), creepage);
    let peak = contact.normal.peak_pressure().value;
    let constants = &plan.constants;
    let strip = |row: &creepage::damage::Row| Strip {
        side: contact.side,
        y: [contact.y_wheel, contact.y_rail],
        across: row.y,
        width: row.width,
        depth: match plan.law {
            WearLaw::Archard if speed == 0.0 => f64::NAN,
            WearLaw::Archard => constants.archard.wear(&row.elements, speed).depth,
            WearLaw::Usfd => constants.usfd.depth(&row.elements, constants.density),
        },
        peak,
    };
    rows.iter().map(strip).collect()
}
