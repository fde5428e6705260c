//! Outline of patches from pressures on a lattice, with ends between its lines.
//!
//! The force on the outer two cells of a row is `2/3 p D` of the pressure `p` at their inner side
//! if pressure rises as a root over the distance `D` to the true end; so `D` follows from both.
//! A tip is found in the same way from the column through it.

use super::chord::{Chord, place};
use super::level::ElementGrid;
use super::patch_strip::Band;

/// A run of pressed cells in one row.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Run {
    row: usize,
    first: usize,
    last: usize,
    patch: usize,
    below: Links,
    above: Links,
}

/// How many runs of the neighbouring row a run touches, and one of them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Links {
    count: usize,
    one: usize,
}

impl Run {
    fn touches(&self, other: &Self) -> bool {
        self.first <= other.last && other.first <= self.last
    }
}

/// The patches of a level, each as its bands.
pub(super) fn patches(level: &ElementGrid) -> Vec<Vec<Band>> {
    let mut runs = runs(level);
    link(&mut runs);
    let count = number_patches(&mut runs);
    let mut patches = vec![Vec::new(); count];
    for start in 0..runs.len() {
        if continues(&runs, &runs[start].below, |run| &run.above) {
            continue;
        }
        let chain = chain(&runs, start);
        patches[runs[start].patch].extend(band(level, &chain));
    }
    patches.retain(|bands: &Vec<Band>| !bands.is_empty());
    patches
}

fn runs(level: &ElementGrid) -> Vec<Run> {
    let columns = level.lattice.count[0];
    let mut runs = Vec::new();
    for (row, line) in level.pressures.chunks(columns).enumerate() {
        let mut first = None;
        for column in 0..=columns {
            let pressed = line.get(column).is_some_and(|&p| p > 0.0);
            match (pressed, first) {
                (true, None) => first = Some(column),
                (false, Some(begin)) => {
                    let (patch, links) = (runs.len(), Links::default());
                    let last = column - 1;
                    runs.push(Run { row, first: begin, last, patch, below: links, above: links });
                    first = None;
                }
                _ => {}
            }
        }
    }
    runs
}

/// Finds which runs of neighbouring rows touch.
fn link(runs: &mut [Run]) {
    let mut low = 0;
    for upper in 0..runs.len() {
        while runs[low].row + 1 < runs[upper].row {
            low += 1;
        }
        for lower in low..upper {
            if runs[lower].row + 1 == runs[upper].row && runs[lower].touches(&runs[upper]) {
                let above = runs[lower].above.count + 1;
                runs[lower].above = Links { count: above, one: upper };
                let below = runs[upper].below.count + 1;
                runs[upper].below = Links { count: below, one: lower };
                join(runs, lower, upper);
            }
        }
    }
}

/// The run that stands for a patch.
fn root(runs: &[Run], mut at: usize) -> usize {
    while runs[at].patch != at {
        at = runs[at].patch;
    }
    at
}

fn join(runs: &mut [Run], one: usize, other: usize) {
    let (one, other) = (root(runs, one), root(runs, other));
    runs[one.max(other)].patch = one.min(other);
}

/// Numbers the patches from 0; returns how many there are.
fn number_patches(runs: &mut [Run]) -> usize {
    let roots: Vec<usize> = (0..runs.len()).map(|at| root(runs, at)).collect();
    let mut number = vec![0; runs.len()];
    let mut count = 0;
    for at in 0..runs.len() {
        if roots[at] == at {
            number[at] = count;
            count += 1;
        }
        runs[at].patch = number[roots[at]];
    }
    count
}

/// Whether a run touches exactly one run on a side, and that one touches no other.
fn continues(runs: &[Run], links: &Links, back: impl Fn(&Run) -> &Links) -> bool {
    links.count == 1 && back(&runs[links.one]).count == 1
}

/// The runs of one band and whether it ends in a tip below and above.
struct Chain {
    runs: Vec<Run>,
    tips: [bool; 2],
}

fn chain(runs: &[Run], start: usize) -> Chain {
    let mut at = start;
    let mut found = vec![runs[at]];
    while continues(runs, &runs[at].above, |run| &run.below) {
        at = runs[at].above.one;
        found.push(runs[at]);
    }
    Chain { tips: [runs[start].below.count == 0, runs[at].above.count == 0], runs: found }
}

/// `None` only if no cell of the chain is pressed.
fn band(level: &ElementGrid, chain: &Chain) -> Option<Band> {
    let lattice = &level.lattice;
    let chords: Vec<Chord> = chain.runs.iter().map(|run| chord(level, run)).collect();
    let loads: Vec<f64> = chain.runs.iter().map(|run| run_sum(level, run)).collect();
    let (first, last) = (chain.runs.first()?, chain.runs.last()?);
    let low = lattice.corner[1] + first.row as f64 * lattice.step[1];
    let high = lattice.corner[1] + (last.row + 1) as f64 * lattice.step[1];
    let shift = |runs: &mut dyn Iterator<Item = &Run>, tip: bool| {
        let runs: Vec<&Run> = runs.take(3).collect();
        if tip { tip_shift(level, &runs, chain.runs.len()) * lattice.step[1] } else { 0.0 }
    };
    let y = [
        low - shift(&mut chain.runs.iter(), chain.tips[0]),
        high + shift(&mut chain.runs.iter().rev(), chain.tips[1]),
    ];
    // A row may be pressed a little beyond the tip: it adds its load but no chord.
    let margin = 0.2 * lattice.step[1];
    let inside = |chord: &Chord| chord.y > y[0] + margin && chord.y < y[1] - margin;
    let (most, few) = (chords.iter().filter(|&chord| inside(chord)).count(), chords.len() / 2);
    let chords: Vec<Chord> = if most > 0 {
        chords.into_iter().filter(inside).collect()
    } else {
        chords.into_iter().skip(few).take(1).collect()
    };
    let y = if most > 0 { y } else { [low, high] };
    let mut band = Band::new(chords, y, chain.tips);
    let total: f64 = loads.iter().sum::<f64>() * lattice.cell_area();
    let force = band.total().force;
    if force > 0.0 {
        band.scale(total / force);
    }
    Some(band)
}

fn run_sum(level: &ElementGrid, run: &Run) -> f64 {
    line(level, run).iter().sum()
}

fn line<'a>(level: &'a ElementGrid, run: &Run) -> &'a [f64] {
    let start = run.row * level.lattice.count[0];
    &level.pressures[start + run.first..=start + run.last]
}

/// How far a tip lies beyond the outer side of its outermost row, in rows.
fn tip_shift(level: &ElementGrid, outer: &[&Run], rows: usize) -> f64 {
    let columns = level.lattice.count[0];
    let in_row = |run: &Run, column: usize| level.pressures[run.row * columns + column];
    let Some(tip) = outer.first() else { return 0.0 };
    let highest = (tip.first..=tip.last)
        .max_by(|&one, &other| in_row(tip, one).total_cmp(&in_row(tip, other)));
    let column = highest.unwrap_or(tip.first);
    let values: Vec<f64> = outer.iter().map(|run| in_row(run, column)).collect();
    end_shift(&values, rows)
}

/// How far the true end lies beyond the outer side of the outermost of `count` cells, in cells;
/// `values` are those of the outer three, from outside. The far end corrects the root a little.
fn end_shift(values: &[f64], count: usize) -> f64 {
    const SHIFT_OF_FEW_CELLS: f64 = -0.1;
    let &[outer, second, third] = values else { return SHIFT_OF_FEW_CELLS };
    let inner = f64::midpoint(second * second, third * third).sqrt();
    if inner == 0.0 {
        return SHIFT_OF_FEW_CELLS;
    }
    let distance = 1.5 * (outer + second) / inner;
    let distance = distance / (1.0 + 0.2 * distance / count as f64);
    (distance - 2.0).clamp(-1.2, 0.5)
}

fn chord(level: &ElementGrid, run: &Run) -> Chord {
    let lattice = &level.lattice;
    let values = line(level, run);
    let count = values.len();
    let outer: Vec<f64> = values.iter().take(3).copied().collect();
    let other: Vec<f64> = values.iter().rev().take(3).copied().collect();
    let step = lattice.step[0];
    let low = lattice.corner[0] + step * (run.first as f64 - end_shift(&outer, count));
    let high = lattice.corner[0] + step * ((run.last + 1) as f64 + end_shift(&other, count));
    let (centre, half) = (f64::midpoint(low, high), 0.5 * (high - low));
    // The outermost cells are covered in part: their values say little of the profile.
    let skip = usize::from(count > 4);
    let known: Vec<[f64; 2]> = (skip..count - skip)
        .filter_map(|i| {
            let s = (lattice.x(run.first + i) - centre) / half;
            let root = (1.0 - s * s).max(0.0).sqrt();
            (root > 0.2).then(|| [s, values[i] / (half * root)])
        })
        .collect();
    let density = std::array::from_fn(|i| between(&known, place(i)));
    let mut chord = Chord { y: lattice.y(run.row), half, centre, density };
    let (wanted, found) = (run_sum(level, run) * step, chord.line_load());
    if found > 0.0 {
        chord.scale(wanted / found);
    }
    chord
}

/// Straight lines through points of increasing `s`, level beyond them; one without any.
fn between(known: &[[f64; 2]], s: f64) -> f64 {
    let after = known.partition_point(|point| point[0] <= s);
    match (after.checked_sub(1).and_then(|i| known.get(i)), known.get(after)) {
        (Some(low), Some(high)) => low[1] + (high[1] - low[1]) * (s - low[0]) / (high[0] - low[0]),
        (Some(only), None) | (None, Some(only)) => only[1],
        (None, None) => 1.0,
    }
}
