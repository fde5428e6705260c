//! The normal solver: overlap of the undeformed bodies, elements on two lattices, then strips laid into what
//! these find. Strip and element solutions are checked against each other; where the strips do not converge, finer
//! elements are the fallback.

use crate::check;
use crate::gap::Gap;
use crate::solid::SolidPair;

use super::contact::{Estimate, Method, NormalContact, NormalWarmStart, Resolution};
use super::elements;
use super::error::NormalError;
use super::level::{Accuracy, ElementGrid, NormalProblem};
use super::load;
use super::overlap::Overlap;
use super::refinement::{RESIDUAL_TOLERANCES, STIFFNESS_TOLERANCES, Start, by_strips};
use super::solution::{Prescribed, SolvedPair, SolvedPatches, areas, contact, gap_points, scale};
use super::strips::{self, StripOptions};

impl NormalContact {
    /// Presses the bodies together by `approach` (m), counted like the gap: undeformed they
    /// would penetrate by `approach - h`.
    ///
    /// Unlike bodies are solved without what friction adds to their normal displacements.
    ///
    /// # Errors
    /// [`NormalError`] when the bodies do not touch, touch along a line or everywhere, or where
    /// the gap is not known.
    pub fn at_approach(
        gap: &Gap,
        pair: SolidPair,
        approach: f64,
        resolution: Resolution,
    ) -> Result<Self, NormalError> {
        check::finite("approach", approach)?;
        solve(gap, pair, Prescribed::Approach(approach), None, resolution)
    }

    /// Presses the bodies together by a load (N).
    ///
    /// # Errors
    /// As [`NormalContact::at_approach`].
    pub fn under_load(
        gap: &Gap,
        pair: SolidPair,
        load: f64,
        resolution: Resolution,
    ) -> Result<Self, NormalError> {
        check::positive("normal_force", load)?;
        solve(gap, pair, Prescribed::Load(load), None, resolution)
    }

    /// The same bodies in a position close by, at an approach (m): quicker than
    /// [`NormalContact::at_approach`], for it starts from these contact areas.
    ///
    /// # Errors
    /// As [`NormalContact::at_approach`].
    pub fn next(
        &self,
        gap: &Gap,
        approach: f64,
        resolution: Resolution,
    ) -> Result<Self, NormalError> {
        check::finite("approach", approach)?;
        let asked = Prescribed::Approach(approach);
        solve(gap, self.pair, asked, Some(&self.near(approach)), resolution)
    }

    /// The same with as many strips as this one, or on its lattice of elements, and no finer or coarser ones: what
    /// they lack, and the error bars, are taken from here as long as [`NormalContact::keeps_error_bars`] says so. `None` where strips do
    /// not settle or the bodies meet beyond them; [`NormalContact::next`] tells more then.
    #[must_use]
    pub fn follow(&self, gap: &Gap, approach: f64) -> Option<Self> {
        if !approach.is_finite() {
            return None;
        }
        resolve_strips(gap, self, approach).or_else(|| resolve_elements(gap, self, approach))
    }
}

/// `near` is what a contact close by tells, if one is known.
fn solve(
    gap: &Gap,
    pair: SolidPair,
    asked: Prescribed,
    near: Option<&NormalWarmStart<'_>>,
    resolution: Resolution,
) -> Result<NormalContact, NormalError> {
    const COARSE: f64 = 10.0;
    let modulus = pair.shear_modulus() / (1.0 - pair.poisson());
    if let Prescribed::Approach(approach) = asked
        && let Some(near) = near
        // Strips that prove to be all the contact there is need no elements.
        && let Some(found) = {
            let task = NormalProblem { gap, modulus, approach };
            by_strips(task, asked, near, resolution, Start::Close)
        }
    {
        return Ok(contact(gap, pair, asked, found));
    }
    let (task, first) = match asked {
        Prescribed::Approach(approach) => {
            let task = NormalProblem { gap, modulus, approach };
            (task, elements::first(task, &Overlap::find(gap, approach)?)?)
        }
        Prescribed::Load(load) => load::first(gap, modulus, load)?,
    };
    // Strips that prove to be all the contact there is may begin anywhere.
    let complete = task.gap.has_locus();
    let at_first =
        || by_strips(task, asked, &NormalWarmStart::of(areas(&first)), resolution, Start::Rough);
    if complete && let Some(found) = at_first() {
        return Ok(contact(gap, pair, asked, found));
    }
    let coarse = elements::refined(task, &first, COARSE, Accuracy::START)?;
    let (task, coarse) = load::corrected(task, asked, coarse, Accuracy::START)?;
    if let Some(side) = coarse.side_reached(gap) {
        return Err(elements::edge_error(task, &coarse, side));
    }
    let elements = SolvedPatches::by_elements(task, &coarse);
    // Elements across a slender area are too few to agree with.
    let start = Start::Elements;
    let near = NormalWarmStart::of(elements.patches.clone());
    let by_strips = by_strips(task, asked, &near, resolution, start);
    let found = match by_strips.filter(|found| complete || found.fine.agrees_with(&elements)) {
        Some(found) => found,
        None => by_elements(task, asked, &coarse, resolution)?,
    };
    Ok(contact(gap, pair, asked, found))
}

/// By as many strips as a contact close by, which tells what they lack.
fn resolve_strips(gap: &Gap, near: &NormalContact, approach: f64) -> Option<NormalContact> {
    let (rule, NormalWarmStart { areas, factors, .. }) = (near.rule?, near.near(approach));
    let modulus = near.pair.shear_modulus() / (1.0 - near.pair.poisson());
    let options = StripOptions {
        load: None,
        count: rule.count.min(strips::most(&areas)),
        terms: strips::terms(gap, &areas)?,
        // A last step is taken from there.
        residual_tolerance: RESIDUAL_TOLERANCES[0],
        stiffness_tolerance: STIFFNESS_TOLERANCES[1],
        complete: true,
        summit: true,
        attempts: StripOptions::CLOSE_ATTEMPTS,
        settled: 1.0,
    };
    let mut found =
        strips::solve(NormalProblem { gap, modulus, approach }, &areas, factors, options)?;
    let value = rule.load * found.load;
    scale(&mut found.patches, value);
    let summit = found.summit;
    Some(followed(gap, near, (approach, value), summit, found))
}

/// On the lattice of elements of a contact close by: there loads change as continuously as the gap does, from one
/// lattice to another they jump by a thousandth.
fn resolve_elements(gap: &Gap, near: &NormalContact, approach: f64) -> Option<NormalContact> {
    let lattice = near.elements?.lattice;
    let modulus = near.pair.shear_modulus() / (1.0 - near.pair.poisson());
    let task = NormalProblem { gap, modulus, approach };
    let level = ElementGrid::warm_started(task, lattice, |x, y| near.pressure(x, y)).ok()?;
    let is_solved = level.residual <= Accuracy::ANSWER.residual && !level.reaches_side();
    let mut found = is_solved.then(|| SolvedPatches::by_elements(task, &level))?;
    let (value, summit) = (found.load, found.summit);
    scale(&mut found.patches, value);
    Some(followed(gap, near, (approach, value), summit, found))
}

/// What follows a contact close by, with that one's error bars in proportion.
fn followed(
    gap: &Gap,
    near: &NormalContact,
    (approach, load): (f64, f64),
    summit: f64,
    found: SolvedPatches,
) -> NormalContact {
    let scaled = |value: f64, near: Estimate| Estimate {
        value,
        error: near.error * (value / near.value).abs(),
    };
    NormalContact {
        approach: Estimate { value: approach, error: 0.0 },
        load: scaled(load, near.load),
        peak: scaled(summit, near.peak),
        area: scaled(found.area(), near.area),
        stiffness: found.stiffness,
        gap_points: gap_points(gap, &found.patches),
        patches: found.patches,
        factors: found.factors,
        pair: near.pair,
        status: near.status,
        method: near.method,
        rule: near.rule,
        elements: near.elements,
    }
}

fn by_elements(
    task: NormalProblem<'_>,
    asked: Prescribed,
    coarse: &ElementGrid,
    resolution: Resolution,
) -> Result<SolvedPair, NormalError> {
    const COARSER: f64 = 0.6;
    /// Steps in place of pressures that end as a root carry too much: corrugated gaps, at worst.
    const EXCESS: f64 = 0.25;
    let count = resolution.count as f64;
    let accuracy = Accuracy::ANSWER;
    let coarse = elements::refined(task, coarse, COARSER * count, accuracy)?;
    let (task, coarse) = load::corrected(task, asked, coarse, accuracy)?;
    let coarse_found = SolvedPatches::by_elements(task, &coarse);
    let fine = elements::refined(task, &coarse, count, accuracy)?;
    let (task, fine) = load::corrected(task, asked, fine, accuracy)?;
    if let Some(side) = fine.side_reached(task.gap) {
        return Err(elements::edge_error(task, &fine, side));
    }
    Ok(SolvedPair {
        coarse: coarse_found,
        fine: SolvedPatches::by_elements(task, &fine),
        method: Method::Elements,
        count: resolution.count,
        finer: 1.0 / COARSER,
        residual: fine.residual,
        excess: EXCESS / (count * count),
        lattice: Some(fine.lattice),
    })
}
