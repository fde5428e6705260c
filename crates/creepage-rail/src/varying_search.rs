//! Contact search between a wheel and a rail that vary along rolling: the vertical gap over the wheel's surface, its
//! least places, and the regions on which the bodies overlap.

use crate::meeting::WheelRailPair;
use crate::pair_surfaces::RailBelow;
use crate::search::crossing;
use crate::slices::patch_of;

/// Angle from straight down up to which a wheel is looked at (rad): a rail may rise by a third.
const AROUND: f64 = 0.35;
/// Steps of the first look, around the wheel and along its profile (m), and how many to the shortest wave.
const ALONG: f64 = 3e-3;
const ACROSS: usize = 2;
const STEPS_OF_WAVE: f64 = 8.0;
/// Rounding of a slope where the gap is least.
const ROUNDING: f64 = 1e-13;
/// The lattice of a region, and how often it is laid anew.
const CELLS: usize = 40;
const LOOKS: usize = 24;
/// A rail that ends nearer than this (m) to where it is met ends there.
const END: f64 = 3e-4;

/// A place at which the vertical gap is least around it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Low {
    pub(crate) v: f64,
    pub(crate) b: f64,
    pub(crate) gap: f64,
    pub(crate) place: [f64; 3],
    pub(crate) y_wheel: f64,
    pub(crate) rail: RailBelow,
}

/// A piece of an overlap.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OverlapCell {
    pub(crate) at: [f64; 2],
    /// On the wheel (m).
    pub(crate) place: [f64; 3],
    pub(crate) depth: f64,
    pub(crate) rail: RailBelow,
    /// Its share of the surface (m rad).
    pub(crate) area: f64,
}

/// A stretch of both surfaces on which the bodies overlap.
#[derive(Debug, Clone)]
pub(crate) struct OverlapRegion {
    pub(crate) cells: Vec<OverlapCell>,
    /// Whether a part of the rail begins or ends in it.
    pub(crate) is_cut: bool,
    /// `y` at which a profile ends within it.
    pub(crate) end: Option<f64>,
    /// Steps of the lattice: along the wheel's profile (m), around the wheel (rad).
    pub(crate) steps: [f64; 2],
}

impl WheelRailPair<'_> {
    fn low(&self, v: f64, b: f64) -> Option<Low> {
        let (gap, _, wheel, rail) = self.vertical_gap(v, b)?;
        Some(Low { v, b, gap, place: wheel.place, y_wheel: wheel.y, rail })
    }

    /// Parameters of the wheel's paths that look downwards.
    fn paths(&self) -> Vec<f64> {
        let looks_down =
            |v: &f64| self.posed.varying(*v, 0.0).is_some_and(|point| point.by[0][1] < -1e-9);
        let all: Vec<f64> = match self.posed.wheel.slices() {
            Some(slices) => slices.stations().collect(),
            None => self.posed.wheel.stations().iter().map(|(s, _)| *s).collect(),
        };
        all.into_iter().step_by(ACROSS).filter(looks_down).collect()
    }

    /// Angles at which the wheel is looked at.
    fn angles(&self) -> Vec<f64> {
        let radius = self.posed.wheel.radius();
        let shortest = self.posed.wheel.shortest().min(self.rail.shortest());
        let step = ALONG.min(shortest / STEPS_OF_WAVE).max(2e-4) / radius;
        let count = crate::curve::whole((AROUND / step).ceil());
        let last = count as f64;
        (0..=2 * count).map(|k| AROUND * (k as f64 - last) / last).collect()
    }

    /// All places at which the vertical gap is least around and at most by so much above the least of all (m).
    pub(crate) fn lows(&self, above: f64) -> Vec<Low> {
        let (paths, angles) = (self.paths(), self.angles());
        let columns = angles.len();
        let gap = |v: f64, b: f64| self.vertical_gap(v, b).map_or(f64::INFINITY, |found| found.0);
        let gaps: Vec<f64> =
            paths.iter().flat_map(|&v| angles.iter().map(move |&b| gap(v, b))).collect();
        let least = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        if !least.is_finite() {
            return Vec::new();
        }
        // Between two places of the lattice the gap of a wheel falls by no more than this.
        let step = angles.get(1).zip(angles.first()).map_or(0.0, |(b, a)| b - a);
        let between = self.posed.wheel.radius() * step * step + 5e-5;
        let at = |i: usize, k: usize| gaps.get(i * columns + k).copied().unwrap_or(f64::INFINITY);
        let mut lows: Vec<Low> = Vec::new();
        for i in 0..paths.len() {
            for k in 0..columns {
                let here = at(i, k);
                if here > least + above + between || !is_least(&at, [i, k], [paths.len(), columns])
                {
                    continue;
                }
                if let Some(low) = self.refined_low([&paths, &angles], [i, k]) {
                    let is_known = |known: &Low| {
                        (known.v - low.v).abs() < 1e-7 && (known.b - low.b).abs() < 1e-7
                    };
                    if !lows.iter().any(is_known) {
                        lows.push(low);
                    }
                }
            }
        }
        let least = lows.iter().map(|low| low.gap).fold(f64::INFINITY, f64::min);
        lows.retain(|low| low.gap <= least + above);
        lows
    }

    /// The least gap about a place of the lattice: where its slope around the wheel vanishes, and there, that
    /// along the profile.
    fn refined_low(&self, [paths, angles]: [&[f64]; 2], [i, k]: [usize; 2]) -> Option<Low> {
        let near = |values: &[f64], index: usize, reach: usize| -> Option<[f64; 3]> {
            let low = values.get(index.saturating_sub(reach))?;
            let high = values.get((index + reach).min(values.len() - 1))?;
            Some([*low, *values.get(index)?, *high])
        };
        let [first_v, v, last_v] = near(paths, i, 1)?;
        let [first_b, b, last_b] = near(angles, k, 3)?;
        // Where there is no rail the gap rises.
        let slope = |v: f64, at: f64, which: usize, middle: f64, value: f64| {
            let wall = if value < middle { f64::NEG_INFINITY } else { f64::INFINITY };
            self.vertical_gap(v, at).map_or(wall, |found| found.1[which])
        };
        let angle = |v: f64| crossing([first_b, last_b], ROUNDING, |at| slope(v, at, 1, b, at));
        let path = crossing([first_v, last_v], ROUNDING, |at| slope(at, angle(at), 0, v, at));
        let station = self.low(v, b)?;
        let found = self.low(path, angle(path));
        Some(found.filter(|found| found.gap <= station.gap + ROUNDING).unwrap_or(station))
    }

    /// `y` of the end of a profile where the least gap lies at one.
    pub(crate) fn end_at(&self, low: &Low) -> Option<f64> {
        let wheel = self.posed.wheel;
        let [first, last] = match wheel.slices() {
            Some(slices) => {
                let mut all = slices.stations();
                let first = all.next()?;
                [first, all.last()?]
            }
            None => [0.0, wheel.profile().curve().length()],
        };
        let is_end =
            low.v - first < END || last - low.v < END || self.ends_across(&low.rail, low.place[1]);
        is_end.then_some(low.place[1])
    }

    /// Whether a rail's profile ends at a place, without a wall there.
    fn ends_across(&self, rail: &RailBelow, y: f64) -> bool {
        let Some(slices) = self.rail.slices() else {
            let [low, high] = self.rail.range();
            return (y - low < END && !self.rail.beyond_wall(y - 2.0 * END))
                || (high - y < END && !self.rail.beyond_wall(y + 2.0 * END));
        };
        let ends = slices.patch_slices().map(|(_, v)| v);
        let mut ends = ends.filter_map(|v| Some([*v.first()?, *v.last()?]));
        let Some([first, last]) = ends.next() else { return true };
        let last = ends.last().map_or(last, |[_, end]| end);
        rail.v - first < END || last - rail.v < END
    }

    /// The region about a low place in which the bodies overlap, by a lattice that is laid anew until it fits.
    pub(crate) fn region(&self, low: &Low) -> Option<OverlapRegion> {
        let mut sides = self.first_box(low);
        let mut lattice = self.lattice(low, sides);
        for _ in 0..LOOKS {
            let next = lattice.fitting(sides);
            let Some(next) = next else { break };
            sides = next;
            lattice = self.lattice(low, sides);
        }
        let end = lattice.inside().find(|cell| self.ends_across(&cell.rail, cell.place[1]));
        let end = end.map(|cell| cell.place[1]).or_else(|| self.end_at(low));
        let cells: Vec<OverlapCell> = lattice.inside().copied().collect();
        let is_cut = lattice.is_cut();
        (!cells.is_empty()).then_some(OverlapRegion { cells, is_cut, end, steps: lattice.steps })
    }

    /// Distances from a low place in which the overlap may end: along the profile back and forth (m), and around
    /// the wheel (rad).
    fn first_box(&self, low: &Low) -> [f64; 4] {
        let radius = self.posed.wheel.radius();
        let slope = |dv: f64, db: f64, which: usize| {
            self.vertical_gap(low.v + dv, low.b + db).map(|found| found.1[which])
        };
        let half = |bend: Option<f64>, [least, most]: [f64; 2]| {
            let bend = bend.filter(|bend| *bend > 0.0);
            let half = bend.map_or(least, |bend| 1.3 * (2.0 * low.gap.abs() / bend).sqrt());
            half.clamp(least, most)
        };
        let (dv, db) = (2e-4, 1e-3 / radius);
        let bend = |one: Option<f64>, other: Option<f64>, step: f64| {
            one.zip(other).map(|(one, other)| (one - other) / (2.0 * step))
        };
        let across = half(bend(slope(dv, 0.0, 0), slope(-dv, 0.0, 0), dv), [2e-4, 0.02]);
        let around = half(bend(slope(0.0, db, 1), slope(0.0, -db, 1), db), [2e-4, 0.05]);
        [across, across, around, around]
    }

    fn lattice(&self, low: &Low, sides: [f64; 4]) -> OverlapLattice {
        let [back, front, behind, ahead] = sides;
        let steps = [back + front, behind + ahead].map(|side| side / CELLS as f64);
        let corner = [low.v - back, low.b - behind];
        let cell = |index: usize| {
            let (row, column) = (index / (CELLS + 1), index % (CELLS + 1));
            let at = [corner[0] + row as f64 * steps[0], corner[1] + column as f64 * steps[1]];
            let is_other =
                self.posed.wheel.slices().is_some() && patch_of(at[0]) != patch_of(low.v);
            let found = if is_other { None } else { self.low(at[0], at[1]) };
            let found = found.filter(|_| self.is_on_wheel(at[0]));
            found.map(|found| OverlapCell {
                at,
                place: found.place,
                depth: -found.gap,
                rail: found.rail,
                area: steps[0] * steps[1],
            })
        };
        let cells: Vec<Option<OverlapCell>> = (0..(CELLS + 1) * (CELLS + 1)).map(cell).collect();
        let start =
            [(back / steps[0]).round(), (behind / steps[1]).round()].map(crate::curve::whole);
        OverlapLattice::flooded(cells, start[0] * (CELLS + 1) + start[1], steps)
    }

    fn is_on_wheel(&self, v: f64) -> bool {
        match self.posed.wheel.slices() {
            Some(slices) => slices.holds(v, self.posed.pitch),
            None => (0.0..=self.posed.wheel.profile().curve().length()).contains(&v),
        }
    }
}

/// Whether no neighbour on the lattice is lower.
fn is_least(
    at: &impl Fn(usize, usize) -> f64,
    [i, k]: [usize; 2],
    [rows, columns]: [usize; 2],
) -> bool {
    let here = at(i, k);
    let mut neighbours = (-1i32..=1).flat_map(|di| (-1i32..=1).map(move |dk| [di, dk]));
    here.is_finite()
        && neighbours.all(|[di, dk]| {
            let row = i.checked_add_signed(di as isize).filter(|row| *row < rows);
            let column = k.checked_add_signed(dk as isize).filter(|column| *column < columns);
            match (row, column) {
                (Some(row), Some(column)) if [di, dk] != [0, 0] => {
                    let other = at(row, column);
                    // Of equal neighbours the first counts.
                    if (di, dk) < (0, 0) { here < other } else { here <= other }
                }
                _ => true,
            }
        })
}

/// Cells of a lattice, and which of them belong to one overlap.
#[derive(Debug)]
struct OverlapLattice {
    cells: Vec<Option<OverlapCell>>,
    inside: Vec<bool>,
    steps: [f64; 2],
}

impl OverlapLattice {
    const SIDE: usize = CELLS + 1;

    /// The cells that hang together with the start and are deeper than nought.
    fn flooded(cells: Vec<Option<OverlapCell>>, start: usize, steps: [f64; 2]) -> Self {
        let mut inside = vec![false; cells.len()];
        let deep =
            |at: usize| cells.get(at).is_some_and(|cell| cell.is_some_and(|c| c.depth > 0.0));
        // The start lies between cells: the deepest near it will do.
        let near =
            [0, 1, Self::SIDE, Self::SIDE + 1].map(|by| [start + by, start.saturating_sub(by)]);
        let mut stack: Vec<usize> = near.into_iter().flatten().filter(|at| deep(*at)).collect();
        for at in &stack {
            inside[*at] = true;
        }
        while let Some(at) = stack.pop() {
            for next in neighbours(at) {
                if deep(next) && !inside[next] {
                    inside[next] = true;
                    stack.push(next);
                }
            }
        }
        Self { cells, inside, steps }
    }

    fn inside(&self) -> impl Iterator<Item = &OverlapCell> {
        let pairs = self.cells.iter().zip(&self.inside);
        pairs.filter(|(_, inside)| **inside).filter_map(|(cell, _)| cell.as_ref())
    }

    /// Whether a cell inside has none beside it.
    fn is_cut(&self) -> bool {
        let is_inside = |at: &usize| self.inside.get(*at).copied().unwrap_or(false);
        (0..self.cells.len())
            .filter(is_inside)
            .any(|at| neighbours(at).any(|next| self.cells.get(next).is_some_and(Option::is_none)))
    }

    /// Sides that hold the overlap more closely; `None` where these do.
    fn fitting(&self, sides: [f64; 4]) -> Option<[f64; 4]> {
        /// Cells beside the overlap on each side, and the most of them.
        const MARGIN: [usize; 2] = [1, 8];
        const WIDER: f64 = 1.7;
        let [back, front, behind, ahead] = sides;
        let mut ends = [usize::MAX, 0, usize::MAX, 0];
        let inside = self.inside.iter().enumerate().filter(|(_, inside)| **inside);
        for (at, _) in inside {
            let (row, column) = (at / Self::SIDE, at % Self::SIDE);
            ends = [ends[0].min(row), ends[1].max(row), ends[2].min(column), ends[3].max(column)];
        }
        if ends[0] > ends[1] {
            // Nothing overlaps as far as the lattice tells: look closer.
            return Some(sides.map(|side| 0.5 * side));
        }
        let is_open = |at: usize| self.cells.get(at).is_some_and(Option::is_some);
        let row_open = |row: usize| (0..Self::SIDE).any(|k| is_open(row * Self::SIDE + k));
        let column_open = |column: usize| (0..Self::SIDE).any(|k| is_open(k * Self::SIDE + column));
        let side = |length: f64, free: usize, step: f64, is_open: bool| {
            if free < MARGIN[0] && is_open {
                Some(length * WIDER)
            } else if free > MARGIN[1] {
                Some((length - (free - 4) as f64 * step).max(0.2 * length))
            } else {
                None
            }
        };
        let next = [
            side(back, ends[0], self.steps[0], row_open(0)),
            side(front, CELLS - ends[1], self.steps[0], row_open(CELLS)),
            side(behind, ends[2], self.steps[1], column_open(0)),
            side(ahead, CELLS - ends[3], self.steps[1], column_open(CELLS)),
        ];
        let is_other = next.iter().any(Option::is_some);
        is_other.then(|| std::array::from_fn(|k| next[k].unwrap_or(sides[k])))
    }
}

/// The cells beside one, of a square lattice.
fn neighbours(at: usize) -> impl Iterator<Item = usize> {
    let side = OverlapLattice::SIDE;
    let (row, column) = (at / side, at % side);
    let along = [column.checked_sub(1), Some(column + 1).filter(|c| *c < side)];
    let across = [row.checked_sub(1), Some(row + 1).filter(|r| *r < side)];
    let along = along.into_iter().flatten().map(move |column| row * side + column);
    along.chain(across.into_iter().flatten().map(move |row| row * side + column))
}
