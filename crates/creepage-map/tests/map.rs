//! A map of made-up contacts: symmetries, bounds, continuity, derivatives, its file.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::float_cmp)]
#![allow(unreachable_pub)] // what tests and benchmarks share

mod common;

use creepage::Creepage;
use creepage::table::Axis;
use creepage_map::{
    CellError, ContactMap, Contour, HeightOrLoad, MapError, Quantity, RollingNode, Sample, Side,
    State, WheelMap, fit, slopes,
};

use common::{LOADS, RADIUS, map, node, state, table, table_over};

fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// `SplitMix64`: between -1 and 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        2.0 * (((bits ^ (bits >> 31)) >> 11) as f64) / (1_u64 << 53) as f64 - 1.0
    }
}

/// Forces of an ellipse are met by the two of the fit at creepages that it has not seen: to a thousandth of
/// `mu N`, some times what the table's own interpolation along the ratio leaves.
#[test]
fn an_ellipse_is_found_again() {
    let table = table();
    let (ratio, kx, kp, s) = (1.7, 240.0, 0.9, 5e-4);
    let force = |[x, y, spin]: [f64; 3]| {
        let at = Creepage::new(kx * (x - spin * s), kx * y, kp * spin).unwrap();
        let found = table.at(ratio, 0.28).unwrap().force(at);
        [found.fx, found.fy, 4e-3 * found.mz - s * found.fx]
    };
    let mut random = Random(7);
    let mut draw = |count: usize| -> Vec<Sample> {
        let one = |_| {
            let creepage = [8e-3 * random.next(), 8e-3 * random.next(), 1.5 * random.next()];
            Sample::new(creepage, force(creepage))
        };
        (0..count).map(one).collect()
    };
    let contour = Contour { scale: [200.0, 1.2], length: 12e-3, across: [-4e-3, 5e-3] };
    let found = fit(&table, 0.28, &draw(30), &contour).unwrap();
    assert!(found.residual < 5e-4, "{found:?}");
    let mut worst = 0.0_f64;
    for Sample { creepage: [x, y, spin], force, .. } in draw(200) {
        let mut sum = [0.0; 3];
        for e in found.ellipses {
            let xi = e.by_creepage * (x - spin * e.offset);
            let at = Creepage::new(xi, e.by_creepage * y, e.by_spin * spin).unwrap();
            let own = table.at(e.ratio, 0.28).unwrap().force(at);
            sum[0] += e.weight * own.fx;
            sum[1] += e.weight * own.fy;
        }
        worst = worst.max((sum[0] - force[0]).hypot(sum[1] - force[1]));
    }
    assert!(worst < 2e-3, "{worst}");
    // Neither is far from the ellipse where it counts.
    let heavy = found.ellipses.iter().max_by(|a, b| a.weight.total_cmp(&b.weight)).unwrap();
    assert!((heavy.by_creepage / kx - 1.0).abs() < 0.05 && (heavy.ratio / ratio - 1.0).abs() < 0.1);
}

#[test]
fn samples_of_no_sense_are_refused() {
    let contour = Contour { scale: [200.0, 1.2], length: 12e-3, across: [-4e-3, 5e-3] };
    let wrong = Sample::new([f64::NAN; 3], [0.0; 3]);
    assert!(fit(&table(), 0.28, &[wrong; 12], &contour).is_err());
    assert!(fit(&table(), 0.28, &[], &contour).is_err());
    // Nor is a table of one ratio of axes, which is named.
    let samples = [Sample::new([1e-3, 0.0, 0.0], [0.1, 0.0, 0.0]); 12];
    let refused = fit(&table_over(Axis::fixed(1.0)), 0.28, &samples, &contour).unwrap_err();
    assert!(refused.to_string().starts_with("a_over_b = 1 "), "{refused}");
}

/// The tangential force over `mu N` depends on creepage over `mu` alone, to rounding.
#[test]
fn friction_scales_creepage() {
    let map = map();
    let wheel = |times: f64| {
        // With twice the slip and twice the spin: the whole turning and drifting scaled about rolling.
        let state = State { friction: 0.2 * times, ..state() };
        map.solve_wheel(Side::Right, &state).unwrap()
    };
    let (one, two) = (wheel(1.0), wheel(2.0));
    let reduced = |w: &creepage_map::WheelAnswer, mu: f64| {
        let patch = w.patches[0];
        (patch.creepage.map(|part| part / mu), patch.normal_force)
    };
    // Same load whatever the friction: it does not act on the heights.
    assert_eq!(reduced(&one, 0.2).1.to_bits(), reduced(&two, 0.4).1.to_bits());
    // At one place and load the two ellipses are asked with the ratio: compare a motion scaled by hand.
    let heights = map.wheel(Side::Right).heights().clone();
    let of = (map.table(), 0.28);
    let wheel =
        WheelMap::new(heights, &[node(0.0), node(7e-4)], &LOADS, vec![CellError::default()], of)
            .unwrap();
    let flat = |times: f64| {
        let still = State {
            y: 0.0,
            yaw: 0.0,
            roll: Some(0.0),
            pressed: HeightOrLoad::Height(0.0),
            speed: 1.0,
            vertical_velocity: 0.0,
            roll_rate: 0.0,
            friction: 0.15 * times,
            ..state()
        };
        // Pure yaw rate and drift without the axle's turning: `u` is linear in both at constant slip speed.
        let state = State {
            pitch_rate: Some(1.0 / RADIUS),
            lateral_velocity: 1e-3 * times,
            yaw_rate: 0.0,
            ..still
        };
        wheel.forces_under((map.head(), map.table()), &state, [0.0, 40e3]).unwrap()
    };
    let lateral = |times: f64| flat(times).patches[0].creepage[1] / (0.15 * times);
    assert!((lateral(1.0) - lateral(3.0)).abs() < 1e-9);
}

/// A wheelset and its mirror image: to rounding.
#[test]
fn the_left_wheel_is_the_right_one_in_a_mirror() {
    let map = map();
    let own = state();
    let image = State {
        y: -own.y,
        yaw: -own.yaw,
        roll: own.roll.map(|roll| -roll),
        lateral_velocity: -own.lateral_velocity,
        roll_rate: -own.roll_rate,
        yaw_rate: -own.yaw_rate,
        ..own
    };
    let (one, other) = (map.solve(&own).unwrap(), map.solve(&image).unwrap());
    let [x, y, z] = other.left.force;
    assert!(apart(one.right.force, [x, -y, z]) < 1e-9 * one.right.force[2]);
    let [x, y, z] = other.left.moment;
    assert!(apart(one.right.moment, [-x, y, -z]) < 1e-9 * one.right.force[2]);
    for k in 0..6 {
        let sense = if k == 1 || k == 3 || k == 5 { -1.0 } else { 1.0 };
        assert!((one.wrench[k] - sense * other.wrench[k]).abs() < 1e-6, "{k}");
    }
}

/// States all over the map; in an optimized build a million of them takes a second.
#[test]
fn friction_stays_below_its_bound() {
    let map = map();
    let mut random = Random(3);
    let mut solved = 0;
    for _ in 0..100_000 {
        let y = 4e-3 * random.next();
        let state = State {
            y,
            yaw: 0.01 * random.next(),
            roll: Some(0.02 * y + 3e-4 * random.next()),
            pressed: HeightOrLoad::Height(30.0 * y * y + 3e-5 * random.next()),
            pitch_rate: Some(20.0 / RADIUS * (1.0 + 0.02 * random.next())),
            lateral_velocity: 0.3 * random.next(),
            yaw_rate: 0.3 * random.next(),
            friction: 0.3 + 0.2 * random.next(),
            ..state()
        };
        let Ok(wheel) = map.solve_wheel(Side::Right, &state) else { continue };
        solved += 1;
        for patch in wheel.patches {
            let [x, s, _] = patch.friction;
            assert!(x.hypot(s) <= state.friction * patch.normal_force * (1.0 + 1e-12));
            // Friction never drives.
            assert!(patch.dissipation() >= -1e-2 * state.friction * patch.normal_force * 1e-3);
        }
    }
    assert!(solved > 50_000, "{solved}");
}

/// Across every edge of cells forces and their derivatives go on: no more of a jump than the slope over the
/// step, 1e-9 m, allows, with a derivative of some 1e9 N/m.
#[test]
fn forces_and_derivatives_are_continuous() {
    let map = map();
    let places: Vec<f64> = map.wheel(Side::Right).places().to_vec();
    for place in places.iter().filter(|place| place.abs() < 3e-3) {
        // The `y` at which the right wheel has this place: by halving.
        let at = |y: f64| State {
            y,
            roll: Some(0.02 * y),
            pressed: HeightOrLoad::Height(30.0 * y * y),
            ..state()
        };
        let own = |y: f64| map.height_under(Side::Right, &at(y), 40e3).unwrap()[1] - place;
        let (mut low, mut high) = (place - 5e-4, place + 5e-4);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            if own(middle) < 0.0 { low = middle } else { high = middle }
        }
        let (before, by_before) = map.solve_with_derivatives(&at(low - 1e-9)).unwrap();
        let (after, by_after) = map.solve_with_derivatives(&at(low + 1e-9)).unwrap();
        assert!(apart(before.right.force, after.right.force) < 10.0);
        for (one, other) in by_before[1].iter().zip(&by_after[1]) {
            for (one, other) in one.iter().zip(other) {
                assert!((one - other).abs() < 1e-3 * (one.abs() + 1e6), "{one} {other}");
            }
        }
    }
}

/// Between nodes forces are those of a node built there, and so are their slopes at a node: to a fifth and a tenth
/// of what nodes without slopes of their ellipses miss. Half-way between two nodes slopes cancel, and both err alike.
#[test]
fn slopes_of_nodes_meet_what_lies_between() {
    let table = table();
    let built = |places: &[f64], sloped: bool| {
        let mut nodes: Vec<RollingNode> = places.iter().map(|place| changing(*place)).collect();
        slopes(&mut nodes, &LOADS, RADIUS, (&table, 0.28)).unwrap();
        if !sloped {
            for patch in nodes.iter_mut().flat_map(|node| &mut node.loads).flatten() {
                for ellipse in &mut patch.ellipses {
                    (ellipse.by_place, ellipse.by_load) = Default::default();
                }
            }
        }
        let errors = vec![CellError::default(); places.len() - 1];
        let heights = map().wheel(Side::Right).heights().clone();
        WheelMap::new(heights, &nodes, &LOADS, errors, (&table, 0.28)).unwrap()
    };
    let head = *map().head();
    let state = State { y: 0.0, roll: Some(0.0), pressed: HeightOrLoad::Height(0.0), ..state() };
    let force = |wheel: &WheelMap, place: f64| {
        wheel.forces_under((&head, &table), &state, [place, 40e3]).unwrap().force
    };
    let grid = [-8e-4, -4e-4, 0.0, 3e-4, 7e-4];
    let (sloped, level) = (built(&grid, true), built(&grid, false));
    let mut squares = [0.0; 2];
    for place in [-3e-4, -2e-4, -1e-4, 0.5e-4, 1.5e-4, 2.5e-4] {
        let right = force(&built(&[place, 6e-4], true), place);
        for (sum, map) in squares.iter_mut().zip([&sloped, &level]) {
            *sum += apart(force(map, place), right).powi(2);
        }
    }
    let [with, without] = squares.map(f64::sqrt);
    assert!(with < 0.2 * without, "{with} {without}");
    let slope = |of: &dyn Fn(f64) -> [f64; 3]| {
        let (one, other) = (of(-2e-6), of(2e-6));
        [0, 1, 2].map(|k: usize| (other[k] - one[k]) / 4e-6)
    };
    let right = slope(&|place| force(&built(&[place, 6e-4], true), place));
    let [with, without] =
        [&sloped, &level].map(|map| apart(slope(&|place| force(map, place)), right));
    assert!(with < 0.1 * without, "{with} {without}");
}

/// A node whose ellipses change along the place.
fn changing(place: f64) -> RollingNode {
    let mut node = node(place);
    for patch in node.loads.iter_mut().flatten() {
        let [one, other] = &mut patch.ellipses;
        one.by_creepage *= (400.0 * place).exp();
        one.offset += 0.5 * place;
        other.by_spin *= (-300.0 * place).exp();
        one.weight += 100.0 * place;
        other.weight -= 100.0 * place;
    }
    node
}

/// Derivatives are those of central differences: to the fourth digit, for the table holds numbers of single
/// precision.
#[test]
fn derivatives_are_those_of_differences() {
    let map = map();
    let own = state();
    let (answer, by) = map.solve_with_derivatives(&own).unwrap();
    assert_eq!(answer, map.solve(&own).unwrap());
    let moved = |k: usize, h: f64| {
        let mut state = own;
        match k {
            0 => state.y += h,
            1 => state.pressed = HeightOrLoad::Height(-2e-6 + h),
            2 => state.roll = state.roll.map(|roll| roll + h),
            3 => state.yaw += h,
            4 => state.speed += h,
            5 => state.pitch_rate = state.pitch_rate.map(|rate| rate + h),
            6 => state.lateral_velocity += h,
            _ => state.yaw_rate += h,
        }
        map.solve(&state).unwrap()
    };
    let steps = [1e-8, 1e-9, 1e-8, 1e-6, 1e-3, 1e-4, 1e-4, 1e-4];
    for (k, h) in steps.into_iter().enumerate() {
        let (ahead, behind) = (moved(k, h), moved(k, -h));
        for (w, [one, other]) in
            [[ahead.left, behind.left], [ahead.right, behind.right]].into_iter().enumerate()
        {
            for i in 0..3 {
                let difference = (one.force[i] - other.force[i]) / (2.0 * h);
                let scale = by[w].iter().map(|row| row[k].abs()).fold(1.0, f64::max);
                assert!(
                    (difference - by[w][i][k]).abs() < 2e-3 * scale,
                    "{k} {w} {i}: {difference} {}",
                    by[w][i][k]
                );
            }
        }
    }
}

/// What is found meets what was given, and its derivatives follow.
#[test]
fn a_load_is_found() {
    let map = map();
    let own =
        State { roll: None, pressed: HeightOrLoad::AxleLoad(90e3), pitch_rate: None, ..state() };
    let found = map.solve(&own).unwrap();
    assert!((found.wrench[2] + 90e3).abs() < 1.0);
    assert!((found.left.force[2] - found.right.force[2]).abs() < 1.0);
    let (_, by) = map.solve_with_derivatives(&own).unwrap();
    let h = 1e-7;
    let [ahead, behind] =
        [h, -h].map(|h| map.solve(&State { y: own.y + h, ..own }).unwrap().right.force[1]);
    assert!(((ahead - behind) / (2.0 * h) / by[1][1][0] - 1.0).abs() < 1e-2);
    assert!(by[0][0][1].is_nan() && by[0][0][2].is_nan() && by[0][0][5].is_nan());
    // Both wheels keep their load.
    assert!(by[1][2][0].abs() < 1e-3 * by[1][1][0].abs());
}

#[test]
fn outside_is_an_error_that_names_the_bound() {
    let map = map();
    let quantity = |state: State| match map.solve(&state).unwrap_err() {
        MapError::Outside { quantity, .. } => quantity,
        MapError::Wheel { error, .. } => match *error {
            MapError::Outside { quantity, .. } => quantity,
            other => panic!("{other}"),
        },
        other => panic!("{other}"),
    };
    assert_eq!(quantity(State { y: 0.02, ..state() }), Quantity::Place);
    assert_eq!(quantity(State { y: f64::NAN, ..state() }), Quantity::Finite);
    assert_eq!(quantity(State { yaw: 0.02, ..state() }), Quantity::Yaw);
    assert_eq!(quantity(State { friction: 0.9, ..state() }), Quantity::Friction);
    assert_eq!(quantity(State { speed: 0.0, ..state() }), Quantity::Speed);
    assert_eq!(
        quantity(State { pressed: HeightOrLoad::Height(1e-3), ..state() }),
        Quantity::Height
    );
    assert_eq!(quantity(State { roll: Some(0.004), y: 0.0, ..state() }), Quantity::Roll);
    let light =
        State { pressed: HeightOrLoad::Height(-9.5e-5), y: 0.0, roll: Some(0.0), ..state() };
    assert_eq!(quantity(light), Quantity::Load);
    // A wheelset in the air is no error.
    let hanging =
        State { pressed: HeightOrLoad::Height(-1e-3), y: 0.0, roll: Some(0.0), ..state() };
    assert_eq!(map.solve(&hanging).unwrap().wrench, [0.0; 6].map(|zero: f64| -zero));
}

/// The same bits from its file; a damaged one is none.
#[test]
fn a_file_is_the_map() {
    let map = map();
    let bytes = map.to_bytes().unwrap();
    let read = ContactMap::from_bytes(bytes.clone()).unwrap();
    assert_eq!(read.head(), map.head());
    assert_eq!(read.source(), "x = 1");
    assert_eq!(read.solve(&state()).unwrap(), map.solve(&state()).unwrap());
    for at in [10, bytes.len() / 2, bytes.len() - 1] {
        let mut wrong = bytes.clone();
        wrong[at] ^= 1;
        assert_eq!(ContactMap::from_bytes(wrong).unwrap_err(), MapError::Damaged);
    }
    assert_eq!(ContactMap::from_bytes(Vec::new()).unwrap_err(), MapError::Damaged);
}
