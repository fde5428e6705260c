//! Heights of a wheel under its loads at one place, and how roll and yaw move it.

use creepage::normal::Resolution;
use creepage_map::{HEIGHTS, HeightNode, ROLLS, TURNS, Turned, YAWS, interpolated};
use creepage_rail::{Position, Side};
use creepage_wheelset::{PressedContacts, WheelsetSolver};

use super::image::Image;
use creepage_wheelset::WheelsetError;

/// A turn moves a contact no farther along the map than this (m).
const ASIDE: f64 = 2e-3;
/// Where a contact hardly moves along the map, the nearer place is taken: so much of its distance counts.
const FAR: f64 = 0.05;

/// Wheel at one depth: height, load, and where the load acts on the rail, lateral and vertical.
#[derive(Debug, Clone, Copy)]
struct PressedDepth {
    z: f64,
    load: f64,
    centre: [f64; 2],
}

impl PressedDepth {
    fn of(image: Image, z: f64, pressed: &PressedContacts<'_>) -> Self {
        let mut level = Self { z, load: 0.0, centre: [0.0; 2] };
        for (contact, normal) in pressed {
            let (load, (sin, cos)) = (normal.load().value, contact.angle.sin_cos());
            let [_, s] = normal.centroid();
            let [_, y, z] = contact.reference;
            level.load += load * cos;
            level.centre[0] += image.sense() * load * cos * (y + s * cos);
            level.centre[1] += load * cos * (z + s * sin);
        }
        level.centre = level.centre.map(|part| part / level.load);
        level
    }
}

/// Heights of a wheel under the map's loads, and where these act on the rail (m).
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Column {
    pub(super) heights: [f64; HEIGHTS],
    pub(super) centres: [[f64; 2]; HEIGHTS],
}

/// A place pressed as it is, and at the map's rolls and yaws: [`nodes`] makes [`HeightNode`]s of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct PressedPlace {
    pub(super) place: f64,
    pub(super) roll: f64,
    pub(super) own: Column,
    pub(super) turned: [Column; TURNS],
}

impl PressedPlace {
    /// Its numbers in a row, as journals have them.
    pub(super) fn numbers(&self) -> Vec<f64> {
        let columns = std::iter::once(&self.own).chain(&self.turned);
        let of = |column: &Column| -> Vec<f64> {
            let centres = column.centres.as_flattened();
            column.heights.iter().chain(centres).copied().collect()
        };
        [self.place, self.roll].into_iter().chain(columns.flat_map(of)).collect()
    }

    /// From its numbers; `None` where these are not as many.
    pub(super) fn of_numbers(all: &[f64]) -> Option<Self> {
        const COLUMN: usize = 3 * HEIGHTS;
        let ([place, roll], rest) = all.split_first_chunk::<2>()?;
        let (columns, []) = rest.as_chunks::<COLUMN>() else { return None };
        let column = |all: &[f64; COLUMN]| {
            let centre = |k: usize| [all[HEIGHTS + 2 * k], all[HEIGHTS + 2 * k + 1]];
            let centres = std::array::from_fn(centre);
            Column { heights: std::array::from_fn(|k| all[k]), centres }
        };
        let (own, turned) = columns.split_first()?;
        let turned: &[[f64; COLUMN]; TURNS] = turned.try_into().ok()?;
        Some(Self {
            place: *place,
            roll: *roll,
            own: column(own),
            turned: turned.map(|all| column(&all)),
        })
    }

    pub(super) fn is_finite(&self) -> bool {
        self.numbers().iter().all(|number| number.is_finite())
    }
}

/// Heights of a wheel at `y`, roll and yaw of its right-hand image, under loads of which the first is zero.
fn column<'a>(
    (solver, image): (&WheelsetSolver<'a>, Image),
    at: [f64; 3],
    loads: &[f64; HEIGHTS],
    near: &mut PressedContacts<'a>,
) -> Result<Column, WheelsetError> {
    let rest = image.touch(at)?;
    let most = loads[HEIGHTS - 1];
    // The depth that carries a little more than the largest load.
    let mut depth = 120e-6;
    for _ in 0..12 {
        let level = level((solver, image), at, rest + depth, near)?;
        if (1.02 * most..1.3 * most).contains(&level.load) {
            break;
        }
        let times = if level.load > 0.0 { (1.1 * most / level.load).cbrt().powi(2) } else { 2.0 };
        depth *= times.clamp(0.3, 3.0);
    }
    let mut levels: Vec<PressedDepth> = Vec::with_capacity(HEIGHTS);
    for k in 1..HEIGHTS {
        let deep = depth * k as f64 / (HEIGHTS - 1) as f64;
        let level = level((solver, image), at, rest + deep, near)?;
        if level.load > levels.last().map_or(0.0, |last| last.load) {
            levels.push(level);
        }
    }
    if levels.last().is_none_or(|level| level.load < most) {
        return Err(WheelsetError::LoadNotFound { load: most });
    }
    let powers: Vec<f64> = levels.iter().map(|level| power(level.load)).collect();
    let depths: Vec<f64> = levels.iter().map(|level| level.z - rest).collect();
    let from_rest = |values: &[f64]| [&[0.0], values].concat();
    let (ends, deep) = (from_rest(&powers), from_rest(&depths));
    let heights = loads.map(|load| rest + interpolated(&ends, &deep, power(load)));
    let parts = [0, 1].map(|k: usize| levels.iter().map(|level| level.centre[k]).collect());
    let centre =
        |parts: &Vec<f64>, load: f64| interpolated(&powers, parts, power(load).max(powers[0]));
    let centres = loads.map(|load| parts.each_ref().map(|parts| centre(parts, load)));
    Ok(Column { heights, centres })
}

fn power(load: f64) -> f64 {
    (load * load).cbrt()
}

/// A wheel at `y` and `roll` of its right-hand image, and at the further rolls and yaws of the map, of which the largest
/// are given.
pub(super) fn press_place(
    solver: &WheelsetSolver<'_>,
    (image, half_distance): (Image, f64),
    [y, roll]: [f64; 2],
    [most_roll, most_yaw]: [f64; 2],
    loads: &[f64; HEIGHTS],
) -> Result<PressedPlace, WheelsetError> {
    let radius = image.radius();
    let mut near = Vec::new();
    let mut pressed = |at: [f64; 3]| column((solver, image), at, loads, &mut near);
    let own = pressed([y, roll, 0.0])?;
    let mut turned = [own; TURNS];
    // All at the same coordinate of the map.
    for (column, part) in turned.iter_mut().zip(ROLLS) {
        let further = part * most_roll;
        *column = pressed([y + radius * further, roll + further, 0.0])?;
    }
    if most_yaw > 0.0 {
        for (column, part) in turned[ROLLS.len()..].iter_mut().zip(YAWS) {
            let square = part * most_yaw * most_yaw;
            *column = pressed([y + 0.5 * half_distance * square, roll, square.sqrt()])?;
        }
    }
    Ok(PressedPlace { place: y - radius * roll, roll, own, turned })
}

fn level<'a>(
    (solver, image): (&WheelsetSolver<'a>, Image),
    [y, roll, yaw]: [f64; 3],
    z: f64,
    near: &mut PressedContacts<'a>,
) -> Result<PressedDepth, WheelsetError> {
    let position = image.track(Position { y, z, roll, yaw });
    let side: Side = image.side();
    *near = solver.press_at((side, position), Resolution::STANDARD, near)?;
    Ok(PressedDepth::of(image, z, near))
}

/// The nodes: each finds its contact under a turn where, without it, the load lies nearest to it on the rail.
pub(super) fn nodes(places: &[PressedPlace]) -> Vec<HeightNode> {
    let node = |(at, place_there): (usize, &PressedPlace)| {
        let PressedPlace { place, roll, own, turned } = place_there;
        let turned = turned.map(|column| Turned {
            aside: std::array::from_fn(|k| aside(places, (at, k), column.centres[k])),
            lowered: std::array::from_fn(|k| column.heights[k] - own.heights[k]),
        });
        HeightNode { place: *place, roll: *roll, heights: own.heights, turned }
    };
    places.iter().enumerate().map(node).collect()
}

/// How far along the map (m) from the node `at` the load number `k` lies nearest to `centre` on the rail.
fn aside(places: &[PressedPlace], (at, k): (usize, usize), centre: [f64; 2]) -> f64 {
    let place = places[at].place;
    let first = places.partition_point(|one| one.place < place - ASIDE);
    let last = places.partition_point(|one| one.place <= place + ASIDE);
    let (mut found, mut nearest) = (0.0, f64::INFINITY);
    for pair in places[first..last].windows(2) {
        let [low, high] = [pair[0].place, pair[1].place];
        let [from, to] = [pair[0].own.centres[k], pair[1].own.centres[k]];
        let along = [to[0] - from[0], to[1] - from[1]];
        let off = [centre[0] - from[0], centre[1] - from[1]];
        let square = (along[0] * along[0] + along[1] * along[1]).max(f64::MIN_POSITIVE);
        let part = ((off[0] * along[0] + off[1] * along[1]) / square).clamp(0.0, 1.0);
        let left: f64 = (off[0] - part * along[0]).hypot(off[1] - part * along[1]);
        let aside = low + part * (high - low) - place;
        let cost = left.hypot(FAR * aside);
        if cost < nearest {
            (nearest, found) = (cost, aside);
        }
    }
    found
}
