//! How fast profiles wear where they are: the contacts of all situations, summed along the profiles.

use creepage::{SiCreepage, Status};
use creepage_rail::{Role, RollingCreepage, Side};
use rayon::prelude::*;

use super::error::WearError;
use super::nodes::{deposit, smoothed};
use super::section::{WearLaw, WearPlan, WearSituation, WornSides};
use super::state::{Bodies, WornBody};
use crate::damage::of_elements;
use crate::wheelset::Travel;
use crate::wheelset::solved::SolvedContact;
use crate::wheelset::{SolvedWheelset, WheelsetCase, WheelsetSolver};

/// Depth over the whole of the distance at each point of each body (m), if it wore on as it does.
#[derive(Debug, Clone)]
pub(super) struct Rates {
    pub(super) of: [Option<Vec<f64>>; 4],
    /// Peak pressure (Pa), by the wear of each contact.
    pub(super) peak: f64,
    /// Situations that did not converge.
    pub(super) doubtful: usize,
    /// What is to be held against the solutions, each with its situation.
    pub(super) cautions: Vec<String>,
}

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

/// How far a run has come (m, passages), for messages.
pub(super) type Reached = [f64; 2];

impl Rates {
    /// The rates of wear where the bodies are as they are.
    pub(super) fn new(
        case: &WheelsetCase,
        plan: &WearPlan,
        bodies: &Bodies,
        reached: Reached,
    ) -> Result<Self, WearError> {
        let worn = WheelsetCase { running: bodies.running(&case.running)?, ..case.clone() };
        let solver = worn.solver()?;
        let solve = |(k, situation): (usize, &WearSituation)| {
            let solved = solve(&worn, &solver, situation).map_err(|source| {
                let [distance, passages] = reached;
                let source = Box::new(source);
                WearError::Situation { number: k + 1, distance, passages, source }
            })?;
            let strips = strips(plan, &solved);
            if strips.iter().any(|strip| !strip.depth.is_finite()) {
                return Err(WearError::NoWear { number: k + 1 });
            }
            let words = solved.caution_words().into_iter();
            let words: Vec<String> =
                words.map(|words| format!("situation {}: {words}", k + 1)).collect();
            Ok((strips, solved.status() != Status::Solved, words))
        };
        let all: Vec<_> = plan.situations.par_iter().enumerate().map(solve).collect();
        let mut rates =
            Self { of: [const { None }; 4], peak: 0.0, doubtful: 0, cautions: Vec::new() };
        let arcs: [Option<Vec<f64>>; 4] =
            WornBody::ALL.map(|body| bodies.of(body).map(super::nodes::Nodes::arcs));
        for (rate, arcs) in rates.of.iter_mut().zip(&arcs) {
            *rate = arcs.as_ref().map(|arcs| vec![0.0; arcs.len()]);
        }
        let mut weight = 0.0;
        // In the order of the situations: the same sums on any number of cores.
        for (situation, found) in plan.situations.iter().zip(all) {
            let (strips, doubtful, words) = found?;
            rates.doubtful += usize::from(doubtful);
            rates.cautions.extend(words);
            for strip in &strips {
                let worn = situation.share * strip.depth * strip.width;
                (weight, rates.peak) = (weight + worn, rates.peak + worn * strip.peak);
                rates.add(plan, bodies, &arcs, situation.share, strip, case)?;
            }
        }
        if weight > 0.0 {
            rates.peak /= weight;
        }
        rates.smooth(plan, &arcs);
        Ok(rates)
    }

    fn add(
        &mut self,
        plan: &WearPlan,
        bodies: &Bodies,
        arcs: &[Option<Vec<f64>>; 4],
        share: f64,
        strip: &Strip,
        case: &WheelsetCase,
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
            // The wheel's curve runs to the flange, the rail's to the field side.
            let (y, along, passages) = match body.role() {
                Role::Wheel => (strip.y[0], -sense, plan.distance),
                Role::Rail => (strip.y[1], sense, plan.passages),
            };
            let s = nodes.place(arcs, body.role(), y);
            let s = s.ok_or(WearError::OffProfile { body: body.name(), y })? + along * strip.across;
            let times = match body.role() {
                Role::Wheel => {
                    let radius = case.running.wheelset().wheel(strip.side).radius();
                    passages / (std::f64::consts::TAU * (radius + nodes.height(arcs, s)))
                }
                Role::Rail => passages,
            };
            deposit(arcs, rate, s, strip.width, share * times * strip.depth);
        }
        Ok(())
    }

    fn smooth(&mut self, plan: &WearPlan, arcs: &[Option<Vec<f64>>; 4]) {
        for (rate, arcs) in self.of.iter_mut().zip(arcs) {
            if let (Some(rate), Some(arcs)) = (rate, arcs) {
                *rate = smoothed(arcs, rate, plan.smoothing_length);
            }
        }
        if plan.sides == WornSides::Mean {
            for pair in self.of.chunks_mut(2) {
                if let [Some(left), Some(right)] = pair {
                    for (left, right) in left.iter_mut().zip(right) {
                        *left = left.midpoint(*right);
                        *right = *left;
                    }
                }
            }
        }
    }

    /// The greatest depth over the whole of the distance (m).
    pub(super) fn greatest(&self) -> f64 {
        self.of.iter().flatten().flatten().copied().fold(0.0, f64::max)
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

    /// The mean of these and others, over a part of the whole distance (m).
    pub(super) fn mean(&self, other: &Self, part: f64) -> [Option<Vec<f64>>; 4] {
        let mut of = self.of.clone();
        for (mean, other) in of.iter_mut().zip(&other.of) {
            if let (Some(mean), Some(other)) = (mean, other) {
                mean.iter_mut().zip(other).for_each(|(a, b)| *a = part * a.midpoint(*b));
            }
        }
        of
    }

    /// The depth over a part of the whole distance (m).
    pub(super) fn over(&self, part: f64) -> [Option<Vec<f64>>; 4] {
        let mut of = self.of.clone();
        of.iter_mut().flatten().flatten().for_each(|depth| *depth *= part);
        of
    }
}

fn solve(
    case: &WheelsetCase,
    solver: &WheelsetSolver<'_>,
    situation: &WearSituation,
) -> Result<SolvedWheelset, crate::WheelsetError> {
    let (stance, travel) = case.asked(&situation.asked)?;
    let curvature = situation.curvature;
    let curvature = if curvature.is_nan() { travel.curvature } else { curvature };
    let travel = Travel { curvature, ..travel };
    if situation.friction.is_nan() {
        return solver.solve(&stance, &travel);
    }
    solver.with_friction(situation.friction).solve(&stance, &travel)
}

fn strips(plan: &WearPlan, solved: &SolvedWheelset) -> Vec<Strip> {
    let speed = solved.motion.speed.abs();
    let contacts = solved.wheels().flat_map(|wheel| wheel.contacts());
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
