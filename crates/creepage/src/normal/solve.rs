//! From a gap to its contact: the overlap, elements on two lattices, and strips laid into what
//! these find. Each way checks the other; where the strips do not settle, finer elements speak.

use crate::check;
use crate::gap::Gap;
use crate::solid::SolidPair;

use super::contact::{Estimate, Method, Near, NormalContact, Resolution};
use super::elements;
use super::error::NormalError;
use super::found::{Asked, Found, Pair, areas, contact, gap_points, scale};
use super::level::{Accuracy, Level, Task};
use super::load;
use super::overlap::Overlap;
use super::patch::Patch;
use super::start;
use super::strips::{self, Wanted};

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
        solve(gap, pair, Asked::Approach(approach), None, resolution)
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
        solve(gap, pair, Asked::Load(load), None, resolution)
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
        let asked = Asked::Approach(approach);
        solve(gap, self.pair, asked, Some(&self.near(approach)), resolution)
    }

    /// The same with as many strips as this one and no finer or coarser ones: what they lack, and the error
    /// bars, are taken from here as long as [`NormalContact::keeps_error_bars`] says so. `None` where strips do
    /// not settle or the bodies meet beyond them; [`NormalContact::next`] tells more then.
    #[must_use]
    pub fn follow(&self, gap: &Gap, approach: f64) -> Option<Self> {
        if approach.is_finite() { follow(gap, self, approach) } else { None }
    }
}

/// `near` is what a contact close by tells, if one is known.
fn solve(
    gap: &Gap,
    pair: SolidPair,
    asked: Asked,
    near: Option<&Near<'_>>,
    resolution: Resolution,
) -> Result<NormalContact, NormalError> {
    const COARSE: f64 = 10.0;
    let modulus = pair.shear_modulus() / (1.0 - pair.poisson());
    if let Asked::Approach(approach) = asked
        && let Some(found) = without_elements(Task { gap, modulus, approach }, near, resolution)
    {
        return Ok(contact(gap, pair, asked, found));
    }
    let (task, first) = match asked {
        Asked::Approach(approach) => {
            let task = Task { gap, modulus, approach };
            (task, elements::first(task, &Overlap::find(gap, approach)?)?)
        }
        Asked::Load(load) => load::first(gap, modulus, load)?,
    };
    // Strips that prove to be all the contact there is may begin anywhere.
    let complete = task.gap.is_parabola_along();
    let at_first = || by_strips(task, asked, &Near::of(areas(&first)), resolution, Start::Rough);
    if complete && let Some(found) = at_first() {
        return Ok(contact(gap, pair, asked, found));
    }
    let coarse = elements::refined(task, &first, COARSE, Accuracy::START)?;
    let (task, coarse) = load::corrected(task, asked, coarse, Accuracy::START)?;
    if let Some(side) = coarse.side_reached(gap) {
        return Err(elements::edge_error(task, &coarse, side));
    }
    let elements = Found::by_elements(task, &coarse);
    // Elements across a slender area are too few to agree with.
    let start = Start::Elements;
    let near = Near::of(elements.patches.clone());
    let by_strips = by_strips(task, asked, &near, resolution, start);
    let found = match by_strips.filter(|found| complete || found.fine.agrees_with(&elements)) {
        Some(found) => found,
        None => by_elements(task, asked, &coarse, resolution)?,
    };
    Ok(contact(gap, pair, asked, found))
}

/// By as many strips as a contact close by, which tells what they lack.
fn follow(gap: &Gap, near: &NormalContact, approach: f64) -> Option<NormalContact> {
    let (rule, Near { areas, factors, .. }) = (near.rule?, near.near(approach));
    let modulus = near.pair.shear_modulus() / (1.0 - near.pair.poisson());
    let wanted = Wanted {
        load: None,
        count: rule.count.min(strips::most(&areas)),
        terms: strips::terms(gap, &areas)?,
        // A last step is taken from there.
        enough: ENOUGH[0],
        nearly: NEARLY[1],
        complete: true,
        summit: true,
        attempts: Wanted::ATTEMPTS,
        settled: 1.0,
    };
    let mut found = strips::solve(Task { gap, modulus, approach }, &areas, factors, wanted)?;
    let value = rule.load * found.load;
    let scaled = |value: f64, near: Estimate| Estimate {
        value,
        error: near.error * (value / near.value).abs(),
    };
    let area = scaled(found.area(), near.area);
    scale(&mut found.patches, value);
    Some(NormalContact {
        approach: Estimate { value: approach, error: 0.0 },
        load: scaled(value, near.load),
        peak: scaled(found.summit, near.peak),
        area,
        stiffness: found.stiffness,
        gap_points: gap_points(gap, &found.patches),
        patches: found.patches,
        factors: found.factors,
        pair: near.pair,
        status: near.status,
        method: near.method,
        rule: near.rule,
    })
}

/// Tips by a few strips decide where more are laid, so that these hardly depend on the start: parts of a
/// strip's width, coarse and fine.
const SETTLED: [f64; 2] = [0.05, 0.4];
/// Largest residual over the depth, coarse and fine.
const ENOUGH: [f64; 2] = [1e-5, 1e-6];
/// Stiffness: of an answer, and where one only searches.
const NEARLY: [f64; 2] = [2e-3, 0.05];

/// By strips laid into areas close by or guessed, where these turn out to be all.
fn without_elements(
    task: Task<'_>,
    near: Option<&Near<'_>>,
    resolution: Resolution,
) -> Option<Pair> {
    let asked = Asked::Approach(task.approach);
    let from = |near: &Near<'_>, start| by_strips(task, asked, near, resolution, start);
    // A guess lays the tips less well than elements do: good enough to search with.
    let guess = || if resolution.with_errors { None } else { start::by_virtual_penetration(task) };
    let guessed = || from(&Near::of(guess()?), Start::Elements);
    near.and_then(|near| from(near, Start::Close)).or_else(guessed)
}

fn by_elements(
    task: Task<'_>,
    asked: Asked,
    coarse: &Level,
    resolution: Resolution,
) -> Result<Pair, NormalError> {
    const COARSER: f64 = 0.6;
    /// Steps in place of pressures that end as a root carry too much: corrugated gaps, at worst.
    const EXCESS: f64 = 0.25;
    let count = resolution.count as f64;
    let accuracy = Accuracy::ANSWER;
    let coarse = elements::refined(task, coarse, COARSER * count, accuracy)?;
    let (task, coarse) = load::corrected(task, asked, coarse, accuracy)?;
    let coarse_found = Found::by_elements(task, &coarse);
    let fine = elements::refined(task, &coarse, count, accuracy)?;
    let (task, fine) = load::corrected(task, asked, fine, accuracy)?;
    if let Some(side) = fine.side_reached(task.gap) {
        return Err(elements::edge_error(task, &fine, side));
    }
    Ok(Pair {
        coarse: coarse_found,
        fine: Found::by_elements(task, &fine),
        method: Method::Elements,
        count: resolution.count,
        finer: 1.0 / COARSER,
        residual: fine.residual,
        excess: EXCESS / (count * count),
    })
}

/// Where the areas come from in which strips begin.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Start {
    /// A first look, which is to be improved if strips do not settle at once.
    Rough,
    /// Elements or a guess.
    Elements,
    /// A contact so close by that the finer strips may begin there.
    Close,
}

/// Strips of the finer solution for each of the coarser.
const HALVES: f64 = 2.0;

/// From areas that are rough ones, or so close that the finer strips may begin there.
///
/// `None` when waves along rolling are too short, a strip vanishes, the equations stay unsolved, or the
/// bodies overlap elsewhere: strips that are pressed everywhere and nowhere overlapped beyond solve the
/// problem, whatever they began with.
fn by_strips(
    task: Task<'_>,
    asked: Asked,
    near: &Near<'_>,
    resolution: Resolution,
    kind: Start,
) -> Option<Pair> {
    /// Of the peak pressure: with more between strips, waves across are too short for them.
    const UNSEEN: f64 = 0.02;
    let Near { areas: start, factors, taken } = near;
    let [half, whole, more] = wanted(task, asked, start, resolution, kind)?;
    let next = |start: &[Patch], approach: f64, wanted: Wanted| {
        strips::solve(Task { approach, ..task }, start, *factors, wanted)
    };
    if !resolution.with_errors {
        let only = next(start, task.approach, whole)?;
        return Some(Pair::of_strips(only.clone(), (only, whole.count), HALVES));
    }
    let finest = |fine: Found, finer: Found| {
        let times = more.count as f64 / whole.count as f64;
        Pair::of_strips(fine, (finer, more.count), times)
    };
    if *taken == Some(more.count)
        && let Some(finer) = next(start, task.approach, more)
        && let Some(fine) = next(&finer.patches, finer.approach, whole)
    {
        let is_even = !is_uneven(&fine, &finer, UNEVEN[1]);
        let halved = if is_even { next(&fine.patches, fine.approach, half) } else { None };
        return Some(match halved {
            Some(coarse) => Pair::of_strips(coarse, (fine, whole.count), HALVES),
            None => finest(fine, finer),
        });
    }
    let ladder = || {
        let coarse = next(start, task.approach, half)?;
        let fine = next(&coarse.patches, coarse.approach, whole)?;
        Some((Some(coarse), fine))
    };
    let at_once = || {
        let fine = next(start, task.approach, whole)?;
        Some((next(&fine.patches, fine.approach, half), fine))
    };
    let (coarse, fine) = match kind {
        Start::Rough => ladder(),
        Start::Elements => ladder().or_else(at_once),
        Start::Close => at_once().or_else(ladder),
    }?;
    let halved = coarse.map(|coarse| (is_uneven(&fine, &coarse, UNEVEN[0]), coarse));
    if let Some((false, coarse)) = halved {
        return Some(Pair::of_strips(coarse, (fine, whole.count), HALVES));
    }
    if let Some(finer) = next(&fine.patches, fine.approach, more) {
        return Some(finest(fine, finer));
    }
    let (_, coarse) = halved.filter(|_| fine.unseen <= UNSEEN * fine.peak)?;
    Some(Pair::of_strips(coarse, (fine, whole.count), HALVES))
}

/// What is asked of half the strips, of them, and of more where they are not enough; `None` where waves along
/// rolling are too short for any.
fn wanted(
    task: Task<'_>,
    asked: Asked,
    start: &[Patch],
    resolution: Resolution,
    kind: Start,
) -> Option<[Wanted; 3]> {
    let whole = Wanted {
        load: if let Asked::Load(load) = asked { Some(load) } else { None },
        count: resolution.count.min(strips::most(start)),
        terms: strips::terms(task.gap, start)?,
        enough: ENOUGH[1],
        nearly: NEARLY[usize::from(!resolution.with_errors)],
        complete: true,
        summit: resolution.with_errors,
        attempts: Wanted::ATTEMPTS,
        settled: SETTLED[1],
    };
    let half = Wanted {
        count: whole.count.div_ceil(2),
        enough: ENOUGH[0],
        // Their stiffness is not used.
        nearly: f64::INFINITY,
        complete: false,
        // Better areas cost less than many attempts, and finer strips tell the error as well.
        attempts: match kind {
            Start::Rough => 1,
            Start::Close => 2,
            Start::Elements => Wanted::ATTEMPTS,
        },
        settled: SETTLED[usize::from(kind != Start::Rough)],
        ..whole
    };
    Some([half, whole, Wanted { count: whole.count * 8 / 5, ..whole }])
}

/// How much the peak pressure may change with half and with 8/5 of the strips. The latter is less than such a
/// change with an error that falls with the square of their number: more strips that served are kept.
const UNEVEN: [f64; 2] = [0.02, 0.002];

/// Whether more strips are needed than found a contact: the peak pressure is another by others, or changes where
/// they are cut at the summit, waves across put a part of it between them, or the area is so skew that its
/// edge is a stair.
fn is_uneven(found: &Found, by_others: &Found, most: f64) -> bool {
    let change = |other: f64| (found.peak / other - 1.0).abs();
    change(by_others.peak) > most
        || change(found.summit) > 0.005
        || found.unseen > 0.005 * found.peak
        || found.stairs() > 0.1
}
