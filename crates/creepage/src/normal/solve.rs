//! From a gap to its contact: the overlap, elements on two lattices, and strips laid into what
//! these find. Each way checks the other; where the strips do not settle, finer elements speak.

use std::sync::Arc;

use crate::gap::Gap;
use crate::solid::SolidPair;

use super::band::Band;
use super::contact::{Estimate, Method, Near, NormalContact, Patch, Resolution, Status, StripRule};
use super::elements;
use super::error::NormalError;
use super::level::{Accuracy, Level, Task};
use super::load;
use super::outline;
use super::overlap::Overlap;
use super::start;
use super::strips::{self, Factors, Wanted};

/// What is prescribed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Asked {
    Approach(f64),
    Load(f64),
}

/// A solution of either kind.
#[derive(Debug, Clone)]
pub(super) struct Found {
    pub(super) patches: Vec<Patch>,
    pub(super) approach: f64,
    pub(super) load: f64,
    /// The greatest pressure by the strips or elements as they are, and the summit between them.
    pub(super) peak: f64,
    pub(super) summit: f64,
    /// What a summit or waves as narrow as strips or elements may add to the greatest pressure.
    pub(super) unseen: f64,
    pub(super) stiffness: f64,
    /// The matrix of strips.
    pub(super) factors: Option<Arc<Factors>>,
}

impl Found {
    fn by_elements(task: Task<'_>, level: &Level) -> Self {
        let [peak, fall] = summit(level);
        Self {
            patches: areas(level),
            approach: task.approach,
            load: level.load(),
            peak,
            summit: peak,
            unseen: 0.5 * fall,
            stiffness: level.stiffness,
            factors: None,
        }
    }

    /// [`Band::stairs`] of the worst band.
    fn stairs(&self) -> f64 {
        let bands = self.patches.iter().flat_map(Patch::bands);
        bands.map(Band::stairs).fold(0.0, f64::max)
    }

    fn area(&self) -> f64 {
        self.patches.iter().map(Patch::area).sum()
    }

    /// Whether two solutions agree as well as coarse ones can; a summit of pressure as narrow as
    /// an element is off by a tenth and more.
    fn agrees_with(&self, other: &Self) -> bool {
        let near = |one: f64, other: f64, part: f64| (one / other - 1.0).abs() < part;
        let load = self.load + self.stiffness * (other.approach - self.approach);
        near(load, other.load, 0.02)
            && near(self.peak, other.peak, 0.25)
            && near(self.area(), other.area(), 0.15)
    }
}

/// The areas that elements found.
fn areas(level: &Level) -> Vec<Patch> {
    outline::patches(level).into_iter().map(Patch::new).collect()
}

/// A solution, a coarser one, and what they belong to.
struct Pair {
    coarse: Found,
    fine: Found,
    method: Method,
    /// The finer one's number of strips across or elements along, and the same over the coarser one's.
    count: usize,
    finer: f64,
    residual: f64,
    /// By what part elements may carry too much in either solution: zero for strips.
    excess: f64,
}

impl Pair {
    fn of_strips(coarse: Found, (fine, count): (Found, usize), finer: f64) -> Self {
        Self { coarse, fine, method: Method::Strips, count, finer, residual: 0.0, excess: 0.0 }
    }

    /// What the finer one lacks, over what it differs by, of what falls with the square of their number.
    fn lacking(&self) -> f64 {
        1.0 / (self.finer * self.finer - 1.0)
    }
}

/// `near` is what a contact close by tells, if one is known.
pub(super) fn solve(
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
pub(super) fn follow(gap: &Gap, near: &NormalContact, approach: f64) -> Option<NormalContact> {
    let (rule, Near { areas, factors }) = (near.rule?, near.near(approach));
    let modulus = near.pair.shear_modulus() / (1.0 - near.pair.poisson());
    let wanted = Wanted {
        load: None,
        count: rule.count.min(strips::most(&areas)),
        terms: strips::terms(gap, &areas)?,
        enough: ENOUGH[1],
        nearly: NEARLY[1],
        complete: true,
        summit: false,
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
        peak: scaled(rule.peak * found.peak, near.peak),
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

/// Scales the pressures of some areas to their load.
fn scale(patches: &mut [Patch], load: f64) {
    let carried: f64 = patches.iter().map(Patch::load).sum();
    for band in patches.iter_mut().flat_map(Patch::bands_mut) {
        band.scale(load / carried);
    }
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

/// From areas that are rough ones, or so close that the finer strips may begin there.
///
/// `None` when waves along rolling are too short, a strip vanishes, the equations stay unsolved, or the
/// bodies overlap elsewhere: strips that are pressed everywhere and nowhere overlapped beyond solve the
/// problem, whatever they began with.
fn by_strips(
    task: Task<'_>,
    asked: Asked,
    Near { areas: start, factors }: &Near<'_>,
    resolution: Resolution,
    kind: Start,
) -> Option<Pair> {
    /// Of the peak pressure: with more between strips, waves across are too short for them.
    const UNSEEN: f64 = 0.02;
    let terms = strips::terms(task.gap, start)?;
    let load = if let Asked::Load(load) = asked { Some(load) } else { None };
    let count = resolution.count.min(strips::most(start));
    let next = |start: &[Patch], approach: f64, wanted: Wanted| {
        strips::solve(Task { approach, ..task }, start, *factors, wanted)
    };
    let nearly = NEARLY[usize::from(!resolution.with_errors)];
    let summit = resolution.with_errors;
    let (enough, attempts) = (ENOUGH[1], Wanted::ATTEMPTS);
    let whole = Wanted {
        load,
        count,
        terms,
        enough,
        nearly,
        complete: true,
        summit,
        attempts,
        settled: SETTLED[1],
    };
    // The stiffness of the coarser one is not used.
    let half = Wanted {
        count: count.div_ceil(2),
        enough: ENOUGH[0],
        nearly: f64::INFINITY,
        complete: false,
        // Better areas cost less than many attempts.
        attempts: if kind == Start::Rough { 1 } else { attempts },
        settled: SETTLED[usize::from(kind != Start::Rough)],
        ..whole
    };
    if !resolution.with_errors {
        let only = next(start, task.approach, whole)?;
        return Some(Pair::of_strips(only.clone(), (only, count), HALVES));
    }
    let ladder = || {
        let coarse = next(start, task.approach, half)?;
        let fine = next(&coarse.patches, coarse.approach, whole)?;
        Some((coarse, fine))
    };
    let at_once = || {
        let fine = next(start, task.approach, whole)?;
        let coarse = next(&fine.patches, fine.approach, half)?;
        Some((coarse, fine))
    };
    let (coarse, fine) = if kind == Start::Close { at_once().or_else(ladder)? } else { ladder()? };
    let more = Wanted { count: count * 8 / 5, ..whole };
    if !is_uneven(&coarse, &fine) {
        return Some(Pair::of_strips(coarse, (fine, count), HALVES));
    }
    match next(&fine.patches, fine.approach, more) {
        Some(finer) => {
            let times = more.count as f64 / count as f64;
            Some(Pair::of_strips(fine, (finer, more.count), times))
        }
        None if fine.unseen > UNSEEN * fine.peak => None,
        None => Some(Pair::of_strips(coarse, (fine, count), HALVES)),
    }
}

/// Whether more strips are needed: the peak pressure changes with their number or where they are cut at
/// the summit, waves across put a part of it between them, or the area is so skew that its edge is a
/// stair.
fn is_uneven(coarse: &Found, fine: &Found) -> bool {
    let change = |other: f64| (fine.peak / other - 1.0).abs();
    change(coarse.peak) > 0.02
        || change(fine.summit) > 0.005
        || fine.unseen > 0.005 * fine.peak
        || fine.stairs() > 0.1
}

/// Strips of the finer solution for each of the coarser.
const HALVES: f64 = 2.0;

fn contact(gap: &Gap, pair: SolidPair, asked: Asked, found: Pair) -> NormalContact {
    let lacking = found.lacking();
    let bars = Bars::new(&found);
    let Pair { coarse, mut fine, method, residual, count, .. } = found;
    let area = fine.area();
    let peak_error = bars.peak.of(fine.summit, coarse.summit).max(fine.unseen);
    let area_error = bars.area.of(area, coarse.area());
    // What the coarser would carry at the finer one's approach.
    let carried = coarse.load + fine.stiffness * (fine.approach - coarse.approach);
    let load_error = bars.load.of(fine.load, carried);
    let by_strips = method == Method::Strips;
    let at_limit = fine.load + if by_strips { lacking * (fine.load - carried) } else { 0.0 };
    let rule = StripRule { count, load: at_limit / fine.load, peak: fine.summit / fine.peak };
    let rule = by_strips.then_some(rule);
    let (approach, load) = match asked {
        Asked::Load(load) => {
            let value = fine.approach + (fine.load - at_limit) / fine.stiffness;
            (
                Estimate { value, error: load_error / fine.stiffness },
                Estimate { value: load, error: 0.0 },
            )
        }
        Asked::Approach(value) => {
            (Estimate { value, error: 0.0 }, Estimate { value: at_limit, error: load_error })
        }
    };
    scale(&mut fine.patches, load.value);
    let converged = residual <= Accuracy::ANSWER.residual;
    NormalContact {
        pair,
        approach,
        load,
        peak: Estimate { value: fine.summit, error: peak_error },
        area: Estimate { value: area, error: area_error },
        stiffness: fine.stiffness,
        status: if converged { Status::Converged } else { Status::NotConverged { residual } },
        method,
        gap_points: gap_points(gap, &fine.patches),
        patches: fine.patches,
        rule,
        factors: fine.factors,
    }
}

/// How the error bar of a number follows from its value at two resolutions: a part of their
/// difference, and a part of the number.
#[derive(Clone, Copy)]
struct Bar {
    of_difference: f64,
    least: f64,
    stairs: f64,
}

impl Bar {
    fn of(self, fine: f64, coarse: f64) -> f64 {
        let by_difference = self.of_difference * (fine - coarse).abs();
        by_difference.max(self.least * fine.abs()) + self.stairs * fine.abs()
    }
}

/// Factors of the error bars, from random gaps against three times as many strips (`tests/normal/bars.rs`).
struct Bars {
    load: Bar,
    peak: Bar,
    area: Bar,
}

impl Bars {
    fn new(found: &Pair) -> Self {
        // Elements scatter, and may agree by chance.
        let (of_difference, stairs) = match found.method {
            Method::Strips => (found.lacking(), found.fine.stairs().powi(2)),
            Method::Elements => (1.0, 0.0),
        };
        let is_strips = found.method == Method::Strips;
        let bar = |safety: f64, least: f64, by_stairs: f64| Bar {
            of_difference: of_difference * if is_strips { safety } else { 1.0 },
            least,
            stairs: by_stairs * stairs,
        };
        let least = found.excess.max(3e-4);
        Self { load: bar(1.5, least, 0.03), peak: bar(3.0, 4e-3, 0.8), area: bar(3.0, 3e-3, 0.8) }
    }
}

fn gap_points(gap: &Gap, patches: &[Patch]) -> [Option<usize>; 2] {
    let counts: Vec<[Option<usize>; 2]> =
        patches.iter().map(|patch| gap.points_within(&patch.extent())).collect();
    [0, 1].map(|axis| counts.iter().filter_map(|count| count[axis]).min())
}

/// The top of the parabolas along x and y through the greatest pressure and its neighbours, and
/// how much the lowest of these lacks.
fn summit(level: &Level) -> [f64; 2] {
    let [columns, rows] = level.lattice.count;
    let at = |index: usize| level.pressures.get(index).copied().unwrap_or(0.0);
    let highest = |&one: &usize, &other: &usize| at(one).total_cmp(&at(other));
    let top = (0..level.pressures.len()).max_by(highest).unwrap_or(0);
    let (column, row, middle) = (top % columns, top / columns, at(top));
    let along = |step: usize, inside: bool| {
        let (true, Some(below)) = (inside, top.checked_sub(step)) else { return [0.0, middle] };
        let [low, high] = [below, top + step].map(at);
        let (slope, bend) = (0.5 * (high - low), low + high - 2.0 * middle);
        let is_smooth = low > 0.0 && high > 0.0 && bend < 0.0;
        let rise = if is_smooth { -0.5 * slope * slope / bend } else { 0.0 };
        [rise, middle - low.min(high)]
    };
    let [x, y] =
        [along(1, column > 0 && column + 1 < columns), along(columns, row > 0 && row + 1 < rows)];
    [middle + x[0] + y[0], x[1].max(y[1])]
}
