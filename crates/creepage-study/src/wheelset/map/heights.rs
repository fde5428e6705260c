//! Where a wheel stands under its loads: heights at one place, and how roll and yaw move it.

use creepage::normal::Resolution;
use creepage_map::{HEIGHTS, HeightNode, YAWS, Yawed, interpolated};
use creepage_rail::{Position, Side};
use creepage_wheelset::{PressedContacts, WheelsetSolver};

use super::image::Image;
use creepage_wheelset::WheelsetError;

/// Steps aside (m) and of roll (rad) by which it is found how roll moves a wheel.
const STEPS: [f64; 2] = [5e-5, 1.5e-4];
/// Loads of the heights, by number, under which it is found.
const ROLLED: [usize; 5] = [1, 3, 5, 8, HEIGHTS - 1];
/// The local part of the shift by roll is kept within these (m/rad).
const SHIFTS: [f64; 2] = [-0.3, 0.6];
/// Yaw moves a contact no farther along the map than this (m).
const ASIDE: f64 = 2e-3;
/// Where a contact hardly moves along the map, the nearer place is taken: so much of its distance counts.
const FAR: f64 = 0.05;

/// The wheel at one depth: height, load, and where the load acts on the rail, lateral and vertical.
#[derive(Debug, Clone, Copy)]
struct Level {
    z: f64,
    load: f64,
    centre: [f64; 2],
}

impl Level {
    fn of(image: Image, z: f64, stood: &PressedContacts<'_>) -> Self {
        let mut level = Self { z, load: 0.0, centre: [0.0; 2] };
        for (contact, normal) in stood {
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

/// A place pressed without yaw and at the map's yaws, with the centres of its reference load on the rail, of which
/// [`put_aside`] makes [`Yawed::aside`].
#[derive(Debug, Clone, Copy)]
pub(super) struct Stood {
    pub(super) node: HeightNode,
    pub(super) centres: [[f64; 2]; 1 + YAWS],
}

/// Heights under loads, and where the middle one of these acts.
struct Column {
    /// Height at which the wheel touches.
    rest: f64,
    levels: Vec<Level>,
    heights: [f64; HEIGHTS],
    centre: [f64; 2],
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
    let mut levels: Vec<Level> = Vec::with_capacity(HEIGHTS);
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
    let middle = power(loads[HEIGHTS / 2]);
    let centre = [0, 1].map(|k: usize| {
        let parts: Vec<f64> = levels.iter().map(|level| level.centre[k]).collect();
        interpolated(&powers, &parts, middle)
    });
    Ok(Column { rest, levels, heights, centre })
}

fn power(load: f64) -> f64 {
    (load * load).cbrt()
}

/// A wheel at `y` and `roll` of its right-hand image, where roll goes along `y` by `roll_slope`, without yaw and at
/// yaws up to `most_yaw`.
pub(super) fn node(
    solver: &WheelsetSolver<'_>,
    (image, [most_yaw, half_distance]): (Image, [f64; 2]),
    [y, roll, roll_slope]: [f64; 3],
    loads: &[f64; HEIGHTS],
) -> Result<Stood, WheelsetError> {
    let radius = image.radius();
    let mut near = Vec::new();
    let own = column((solver, image), [y, roll, 0.0], loads, &mut near)?;
    let mut yawed = [Yawed::default(); YAWS];
    let mut centres = [own.centre; 1 + YAWS];
    if most_yaw > 0.0 {
        for (k, yawed) in yawed.iter_mut().enumerate() {
            let square = (k + 1) as f64 / YAWS as f64 * most_yaw * most_yaw;
            // At the same coordinate of the map.
            let at = [y + 0.5 * half_distance * square, roll, square.sqrt()];
            let turned = column((solver, image), at, loads, &mut Vec::new())?;
            yawed.lowered = std::array::from_fn(|k| turned.heights[k] - own.heights[k]);
            centres[k + 1] = turned.centre;
        }
    }
    // How roll goes along the map's places.
    let along = roll_slope / (1.0 - radius * roll_slope);
    let at = [y, roll, along];
    let mut rolled = [[0.0; 2]; ROLLED.len()];
    for (one, load) in rolled.iter_mut().zip(ROLLED) {
        *one = by_roll((solver, image), at, (&own, load, loads[load]), &mut near)?;
    }
    let steps = ROLLED.map(|k| k as f64);
    let of = |part: usize| -> [f64; HEIGHTS] {
        let values = rolled.map(|one| one[part]);
        std::array::from_fn(|k| interpolated(&steps, &values, (k as f64).max(steps[0])))
    };
    let (shift, fall) = (of(0), of(1));
    let place = y - radius * roll;
    let node = HeightNode { place, roll, shift, fall, heights: own.heights, yawed };
    Ok(Stood { node, centres })
}

/// Shift and fall by a further roll under the load number `k`: from the height and the place of the load on the
/// rail, a little aside and rolled a little.
fn by_roll<'a>(
    (solver, image): (&WheelsetSolver<'a>, Image),
    [y, roll, along]: [f64; 3],
    (own, k, reference): (&Column, usize, f64),
    near: &mut PressedContacts<'a>,
) -> Result<[f64; 2], WheelsetError> {
    let radius = image.radius();
    let deep = own.heights[k] - own.rest;
    let softness = {
        let powers: Vec<f64> = own.levels.iter().map(|level| power(level.load)).collect();
        let depths: Vec<f64> = own.levels.iter().map(|level| level.z - own.rest).collect();
        let beside = interpolated(&powers, &depths, power(1.01 * reference));
        (beside - interpolated(&powers, &depths, power(reference))) / (0.01 * reference)
    };
    let mut beside = |by: [f64; 2]| -> Result<[f64; 2], WheelsetError> {
        let at = [y + by[0], roll + by[1], 0.0];
        let z = image.touch(at)? + deep;
        let level = level((solver, image), at, z, near)?;
        Ok([level.z + (reference - level.load) * softness, level.centre[0]])
    };
    let [dy, dr] = STEPS;
    let slope = |[one, other]: [[f64; 2]; 2], step: f64| {
        [0, 1].map(|k: usize| 0.5 * (other[k] - one[k]) / step)
    };
    let [z_y, place_y] = slope([beside([-dy, 0.0])?, beside([dy, 0.0])?], dy);
    let [z_roll, place_roll] = slope([beside([0.0, -dr])?, beside([0.0, dr])?], dr);
    let lever = -place_roll / place_y;
    // On usual profiles the load goes against the wheel (`place_y < 0`), and no local shift is taken: with it
    // places are better, but heights worse (normal force 3.3 for .9 % rms where areas join).
    let lever = if place_y > 0.3 && lever.is_finite() { lever } else { radius };
    let local = lever - radius;
    let shift = (local / (1.0 - along * local)).clamp(SHIFTS[0], SHIFTS[1]);
    let (a, b) = (1.0 + shift * along, radius + shift * (1.0 + radius * along));
    let fall = (z_roll + b / a * z_y) / (b * along / a - (1.0 + radius * along));
    Ok([shift, fall])
}

fn level<'a>(
    (solver, image): (&WheelsetSolver<'a>, Image),
    [y, roll, yaw]: [f64; 3],
    z: f64,
    near: &mut PressedContacts<'a>,
) -> Result<Level, WheelsetError> {
    let position = image.track(Position { y, z, roll, yaw });
    let side: Side = image.side();
    *near = solver.stand((side, position), Resolution::STANDARD, near)?;
    Ok(Level::of(image, z, near))
}

/// The nodes, with how far aside each finds its contact at the map's yaws: where, without yaw, the load lies nearest to
/// it on the rail.
pub(super) fn put_aside(stood: &[Stood]) -> Vec<HeightNode> {
    let mut nodes: Vec<HeightNode> = stood.iter().map(|stood| stood.node).collect();
    let of_place: Vec<(f64, [f64; 2])> =
        stood.iter().map(|stood| (stood.node.place, stood.centres[0])).collect();
    for (node, stood) in nodes.iter_mut().zip(stood) {
        for (yawed, centre) in node.yawed.iter_mut().zip(&stood.centres[1..]) {
            let mut nearest = f64::INFINITY;
            for pair in of_place.windows(2) {
                let ((low, from), (high, to)) = (pair[0], pair[1]);
                if (low.midpoint(high) - node.place).abs() > ASIDE {
                    continue;
                }
                let along = [to[0] - from[0], to[1] - from[1]];
                let off = [centre[0] - from[0], centre[1] - from[1]];
                let square = (along[0] * along[0] + along[1] * along[1]).max(f64::MIN_POSITIVE);
                let part = ((off[0] * along[0] + off[1] * along[1]) / square).clamp(0.0, 1.0);
                let left: f64 = (off[0] - part * along[0]).hypot(off[1] - part * along[1]);
                let aside = low + part * (high - low) - node.place;
                let cost = left.hypot(FAR * aside);
                if cost < nearest {
                    (nearest, yawed.aside) = (cost, aside);
                }
            }
        }
    }
    nodes
}
