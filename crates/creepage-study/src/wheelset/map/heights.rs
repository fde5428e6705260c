//! Where a wheel stands under its loads: heights at one place, and how roll moves it.

use creepage::normal::Resolution;
use creepage_map::{HEIGHTS, HeightNode, interpolated};
use creepage_rail::{Position, Side};
use creepage_wheelset::{PressedContacts, WheelsetSolver};

use super::image::Image;
use creepage_wheelset::WheelsetError;

/// Steps aside (m) and of roll (rad) by which it is found how roll moves a wheel.
const STEPS: [f64; 2] = [5e-5, 1.5e-4];
/// The local part of the shift by roll is kept within these (m/rad).
const SHIFTS: [f64; 2] = [-0.3, 0.6];

/// The wheel at one depth: height, load, its lateral part, and where the load acts on the rail.
#[derive(Debug, Clone, Copy)]
struct Level {
    z: f64,
    load: f64,
    sideways: f64,
    place: f64,
}

impl Level {
    fn of(image: Image, z: f64, stood: &PressedContacts<'_>) -> Self {
        let mut level = Self { z, load: 0.0, sideways: 0.0, place: 0.0 };
        for (contact, normal) in stood {
            let (load, (sin, cos)) = (normal.load().value, contact.angle.sin_cos());
            let [_, s] = normal.centroid();
            level.load += load * cos;
            level.sideways += image.sense() * load * sin;
            level.place += image.sense() * load * cos * (contact.reference[1] + s * cos);
        }
        level.place /= level.load;
        level
    }
}

/// Heights of a wheel at `y` and `roll` of its right-hand image, under loads of which the first is zero.
pub(super) fn node(
    solver: &WheelsetSolver<'_>,
    image: Image,
    [y, roll, roll_slope]: [f64; 3],
    loads: &[f64; HEIGHTS],
) -> Result<HeightNode, WheelsetError> {
    let radius = image.radius();
    let rest = image.touch(y, roll)?;
    let most = loads[HEIGHTS - 1];
    // The depth that carries a little more than the largest load.
    let mut depth = 120e-6;
    let mut near = Vec::new();
    for _ in 0..12 {
        let level = level(solver, image, [y, rest + depth, roll], &mut near)?;
        if (1.02 * most..1.3 * most).contains(&level.load) {
            break;
        }
        let times = if level.load > 0.0 { (1.1 * most / level.load).cbrt().powi(2) } else { 2.0 };
        depth *= times.clamp(0.3, 3.0);
    }
    let mut levels = vec![Level { z: rest, load: 0.0, sideways: 0.0, place: 0.0 }];
    for k in 1..HEIGHTS {
        let deep = depth * k as f64 / (HEIGHTS - 1) as f64;
        let level = level(solver, image, [y, rest + deep, roll], &mut near)?;
        if level.load > levels[levels.len() - 1].load {
            levels.push(level);
        }
    }
    if levels.last().is_none_or(|level| level.load < most) {
        return Err(WheelsetError::LoadNotFound { load: most });
    }
    let power = |load: f64| (load * load).cbrt();
    let powers: Vec<f64> = levels.iter().map(|level| power(level.load)).collect();
    let depths: Vec<f64> = levels.iter().map(|level| level.z - rest).collect();
    let heights = loads.map(|load| rest + interpolated(&powers, &depths, power(load)));
    let reference = loads[HEIGHTS / 2];
    let middle = heights[HEIGHTS / 2] - rest;
    let softness = {
        let beside = interpolated(&powers, &depths, power(1.01 * reference));
        (beside - middle) / (0.01 * reference)
    };
    // Height and place under the reference load, a little aside and rolled a little.
    let mut beside = |by: [f64; 2]| -> Result<[f64; 2], WheelsetError> {
        let (y, roll) = (y + by[0], roll + by[1]);
        let z = image.touch(y, roll)? + middle;
        let level = level(solver, image, [y, z, roll], &mut near)?;
        Ok([level.z + (reference - level.load) * softness, level.place])
    };
    let [dy, dr] = STEPS;
    let slope = |[one, other]: [[f64; 2]; 2], step: f64| {
        [0, 1].map(|k: usize| 0.5 * (other[k] - one[k]) / step)
    };
    let [z_y, place_y] = slope([beside([-dy, 0.0])?, beside([dy, 0.0])?], dy);
    let [z_roll, place_roll] = slope([beside([0.0, -dr])?, beside([0.0, dr])?], dr);
    // How roll goes along the map's places.
    let along = roll_slope / (1.0 - radius * roll_slope);
    let lever = -place_roll / place_y;
    let lever = if place_y > 0.3 && lever.is_finite() { lever } else { radius };
    let local = lever - radius;
    let shift = (local / (1.0 - along * local)).clamp(SHIFTS[0], SHIFTS[1]);
    let (a, b) = (1.0 + shift * along, radius + shift * (1.0 + radius * along));
    let fall = (z_roll + b / a * z_y) / (b * along / a - (1.0 + radius * along));
    let angle = levels.last().map_or(0.0, |level| level.sideways / level.load);
    Ok(HeightNode { place: y - radius * roll, roll, shift, fall, tangent: angle, heights })
}

fn level<'a>(
    solver: &WheelsetSolver<'a>,
    image: Image,
    [y, z, roll]: [f64; 3],
    near: &mut PressedContacts<'a>,
) -> Result<Level, WheelsetError> {
    let position = image.track(Position { y, z, roll, yaw: 0.0 });
    let side: Side = image.side();
    *near = solver.stand((side, position), Resolution::STANDARD, near)?;
    Ok(Level::of(image, z, near))
}
