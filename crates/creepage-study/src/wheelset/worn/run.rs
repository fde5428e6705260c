//! Run of wear: contacts, depth, profiles, in adaptive steps.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::error::WearError;
use super::limits::{self, WearEnd};
use super::rates::Rates;
use super::section::WearPlan;
use super::state::{Noted, State, WearStop};
use crate::wheelset::WheelsetCase;

/// A step after which contacts wear by this much otherwise, by root mean square, is halved.
const CHANGE: f64 = 0.2;
/// After a step with less change than this the next one may be twice as long.
const CALM: f64 = 0.05;
/// Steps are not halved below this part of the greatest.
const MIN_STEP_FRACTION: f64 = 1.0 / 16.0;
/// Part of the limit of stability that a step keeps.
const SAFE: f64 = 0.7;

/// The volume that is gone is that of the contacts, to this part.
const BALANCE: f64 = 1e-6;

/// Callback of a run's progress: part of the distance, and the stops so far; false stops it.
pub type WearProgress<'a> = &'a mut dyn FnMut(f64, &[WearStop]) -> bool;

/// Wear over a distance: profiles at every stop, from new on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Wear {
    /// The stops, the new profiles first.
    pub stops: Vec<WearStop>,
    /// Why it ended before its distance: the first limit that was reached.
    pub ended: Option<WearEnd>,
    /// Cautions about it.
    pub cautions: Vec<String>,
    /// Whether all situations of all steps converged.
    pub is_solved: bool,
}

/// Runs a wheelset over the distance of a plan. With a file `state` a run that was killed goes on where it
/// was, to the same bits; the file may be removed when the run has ended.
///
/// Each step takes the depth of all situations off along the normals, by the mean of the rates of wear at
/// its start and at its end (Heun). The depth is smoothed along the profile, not the profile.
///
/// # Errors
/// [`WearError`]: what was run so far stays in `state`.
pub fn wear(
    case: &WheelsetCase,
    plan: &WearPlan,
    state: Option<&Path>,
    progress: WearProgress<'_>,
) -> Result<Wear, WearError> {
    let mut run = match state {
        Some(path) => State::resume(case, plan, path)?,
        None => State::new(case, plan),
    };
    if run.stops.is_empty() {
        let new = run.now(case, plan)?;
        limits::check(&plan.limits, &new)?;
        run.stops.push(new);
    }
    let stops = plan.stops as usize;
    while run.stops.len() <= stops && run.ended.is_none() {
        if !progress(run.part, &run.stops) {
            return Err(WearError::Stopped);
        }
        let target = run.stops.len() as f64 / stops as f64;
        step_to_limit(case, plan, &mut run, target)?;
        if run.part >= target || run.ended.is_some() {
            run.stops.push(run.now(case, plan)?);
        }
        if let Some(path) = state {
            run.save(path)?;
        }
    }
    progress(if run.ended.is_some() { 1.0 } else { run.part }, &run.stops);
    let cautions = cautions(plan, &run);
    Ok(Wear { is_solved: run.doubtful == 0, stops: run.stops, ended: run.ended, cautions })
}

/// One step, to `target` at most, and no farther than to the first limit.
fn step_to_limit(
    case: &WheelsetCase,
    plan: &WearPlan,
    run: &mut State,
    target: f64,
) -> Result<(), WearError> {
    if plan.limits.is_empty() {
        return step(case, plan, run, target);
    }
    let before = run.clone();
    step(case, plan, run, target)?;
    let (old, new) = (before.now(case, plan)?, run.now(case, plan)?);
    if let Some((end, part)) = limits::reached(&plan.limits, &old, &new) {
        // The same step again, to where its measure, taken as linear within it, meets the limit.
        let met = before.part + part * (run.part - before.part);
        if part < 1.0 && met > before.part {
            *run = before;
            while run.part < met {
                step(case, plan, run, met)?;
            }
        }
        run.ended = Some(end);
    }
    Ok(())
}

/// One step, to `target` (part of the whole distance) at most.
pub(super) fn step(
    case: &WheelsetCase,
    plan: &WearPlan,
    run: &mut State,
    target: f64,
) -> Result<(), WearError> {
    let reached = |part: f64| [part * plan.distance, part * plan.passages];
    let (first, solved) = Rates::new(case, plan, &run.bodies, (reached(run.part), &[]))?;
    let greatest = first.greatest;
    let allowed = stable(case, plan, first.peak);
    // Stability cuts the step, unless the distance ends before.
    if allowed < run.trial && greatest * (target - run.part) > allowed {
        run.cut += 1;
    }
    loop {
        let depth = run.trial.min(allowed);
        let left = target - run.part;
        let part = if greatest * left > depth { depth / greatest } else { left };
        let is_last = part >= left;
        let predicted = run.bodies.worn(&first, part)?;
        let end = (reached(run.part + part), &solved[..]);
        let (second, _) = Rates::new(case, plan, &predicted, end)?;
        let change = first.change(&second);
        let taken = greatest * part;
        if change > CHANGE && taken > 1.01 * MIN_STEP_FRACTION * plan.step_depth {
            run.trial = (0.5 * taken).max(MIN_STEP_FRACTION * plan.step_depth);
            continue;
        }
        run.bodies = run.bodies.worn(&first.mean(&second), part)?.even(plan.spacing);
        run.rough += usize::from(change > CHANGE);
        run.doubtful += first.doubtful + second.doubtful;
        if change < CALM {
            run.trial = (2.0 * run.trial).min(plan.step_depth);
        }
        for (situation, words) in first.cautions.iter().chain(&second.cautions) {
            run.note(*situation, words);
        }
        run.part = if is_last { target } else { run.part + part };
        run.steps += 1;
        return Ok(());
    }
}

/// The depth of a step (m) below which ripples do not grow: pressure answers a ripple of the wave number `k`
/// by `k E*/2` over its height, and the bell damps it.
fn stable(case: &WheelsetCase, plan: &WearPlan, peak: f64) -> f64 {
    let Some(pair) = case.solids else { return f64::INFINITY };
    let modulus = pair.shear_modulus() / (1.0 - pair.poisson());
    let limit = 4.0 * 0.5f64.exp() * peak * plan.smoothing_length / modulus;
    if peak > 0.0 { SAFE * limit } else { f64::INFINITY }
}

fn cautions(plan: &WearPlan, run: &State) -> Vec<String> {
    let mut all = Vec::new();
    let usual = creepage::damage::Archard::default();
    if plan.law == super::section::WearLaw::Archard && plan.constants.archard == usual {
        all.push(
            "Archard's constants are unverified, and wear coefficients spread by 3 to 10"
                .to_owned(),
        );
    }
    let steps = run.steps;
    if run.rough > 0 {
        all.push(format!(
            "{} of {steps} steps: the contacts change by more than 20 % within the shortest step: give a lower \
             step_depth, or more situations",
            run.rough
        ));
    }
    if run.cut > 0 {
        all.push(format!(
            "{} of {steps} steps were shorter than step_depth, so that ripples do not grow: a longer \
             smoothing_length allows longer ones",
            run.cut
        ));
    }
    if run.doubtful > 0 {
        all.push(format!("{} solutions of situations did not converge", run.doubtful));
    }
    let off = run.bodies.imbalance();
    if off > BALANCE {
        all.push(format!(
            "the volume that is gone differs from that of the contacts by {off:.1e} of it"
        ));
    }
    all.extend(run.cautions.iter().map(Noted::words));
    all
}
