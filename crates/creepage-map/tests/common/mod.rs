//! A map of made-up contacts.

use std::sync::Arc;

use creepage::approximate::polach::Polach;
use creepage::table::{Axis, Intervals, Provenance, Spec, Table, build};
use creepage::{Contact, InvalidValue, Theory};
use creepage_map::{
    CellError, ContactMap, Ellipse, HEIGHTS, Head, HeightNode, HeightOrLoad, Heights, MapAccuracy,
    Patch, ROLLS, RollingNode, Sloped, State, TURNS, Turned, WheelMap,
};

pub const RADIUS: f64 = 0.46;
pub const LOADS: [f64; 3] = [10e3, 40e3, 120e3];

/// Of a closed theory, which is quick to build; what is tested holds for any table.
pub fn table() -> Arc<Table> {
    table_over(Axis { low: 0.2, high: 6.0, nodes: 7 })
}

/// The same over other ratios of axes.
pub fn table_over(a_over_b: Axis) -> Arc<Table> {
    let spec = Spec {
        a_over_b,
        poisson: Axis::fixed(0.28),
        intervals: Intervals { theta: 10, phi: 12, t: 24 },
        places: 50,
        provenance: Provenance { theory: "polach".into(), ..Provenance::default() },
    };
    let prepare = |contact: &Contact| -> Result<Box<dyn Theory>, InvalidValue> {
        Ok(Box::new(Polach::new(contact)?))
    };
    Arc::new(build(&spec, prepare, &|| {}).unwrap())
}

pub fn ellipse(ratio: f64, offset: f64, weight: f64) -> Ellipse {
    Ellipse {
        ratio,
        by_creepage: 260.0,
        by_spin: 1.1,
        offset,
        weight,
        moment: [weight * 3e-3, -weight * offset, 1e-4],
        ..Ellipse::default()
    }
}

/// A contact that goes along the rail, steeper and steeper, as the wheel does.
pub fn node(place: f64) -> RollingNode {
    let patch = |load: f64| {
        let heavier = (load / LOADS[1]).cbrt();
        let angle = -0.05 - 40.0 * place * place.max(0.0) - 5.0 * place;
        Patch {
            share: Sloped::level(angle.cos().recip()),
            angle: Sloped { value: angle, by_place: -5.0, by_load: 0.0 },
            y: Sloped { value: 0.75 + 2.0 * place, by_place: 2.0, by_load: 1e-4 },
            z: Sloped { value: 0.1 * place, by_place: 0.1, by_load: 0.0 },
            approach: 60e-6 * heavier * heavier,
            centroid: [0.0, 1e-4],
            peak_pressure: 1e9 * heavier,
            area: 1e-4 * heavier * heavier,
            ellipses: [ellipse(1.3 + 100.0 * place, 2e-3, 0.6), ellipse(0.8, -1e-3, 0.4)],
            residual: 1e-3,
        }
    };
    RollingNode { place, loads: LOADS.iter().map(|load| vec![patch(*load)]).collect() }
}

pub fn map() -> ContactMap {
    let table = table();
    let height = |place: f64| HeightNode {
        place,
        roll: 0.02 * place,
        heights: std::array::from_fn(|k| {
            30.0 * place * place - 1e-4 + 15e-6 * k as f64 * (1.0 + 20.0 * place)
        }),
        turned: std::array::from_fn(|turn| {
            if let Some(part) = ROLLS.get(turn) {
                let roll = 1e-3 * part;
                Turned {
                    aside: std::array::from_fn(|k| -roll * (0.09 + 0.002 * k as f64)),
                    lowered: [-0.75 * roll; HEIGHTS],
                }
            } else {
                let square = if turn + 1 < TURNS { 0.5 } else { 1.0 };
                Turned {
                    aside: [square * 1e-5 * (1.0 + 100.0 * place); HEIGHTS],
                    lowered: std::array::from_fn(|k| -square * 2e-7 * (1.0 + 0.02 * k as f64)),
                }
            }
        }),
    };
    let height_loads = std::array::from_fn(|k| 130e3 * (k as f64 / (HEIGHTS - 1) as f64).powf(1.5));
    let places = |count: i32, step: f64| (-count..=count).map(move |k| f64::from(k) * step);
    let heights = Heights::new(places(60, 1e-4).map(height).collect(), height_loads).unwrap();
    let nodes: Vec<RollingNode> = places(8, 7e-4).map(node).collect();
    let errors = (1..nodes.len()).map(|k| CellError {
        states: 2,
        tangential: 1e-3 * k as f64,
        normal: 1e-3,
    });
    let wheel = WheelMap::new(heights, &nodes, &LOADS, errors.collect(), (&table, 0.28)).unwrap();
    let head = Head {
        radius: RADIUS,
        half_distance: 0.75,
        rail_origins: [[0.76, 0.001]; 2],
        poisson: 0.28,
        friction: [0.05, 0.6],
        yaw: 0.01,
        roll: 1e-3,
        own: state(),
    };
    let wheel = Arc::new(wheel);
    ContactMap::new(
        head,
        table,
        [Arc::clone(&wheel), wheel],
        MapAccuracy::default(),
        "x = 1".into(),
    )
}

pub fn state() -> State {
    State {
        y: 0.0013,
        yaw: 0.003,
        roll: Some(0.000_1),
        pressed: HeightOrLoad::Height(-2e-6),
        speed: 20.0,
        pitch_rate: Some(20.0 / RADIUS),
        lateral_velocity: 0.02,
        vertical_velocity: 0.003,
        roll_rate: 0.002,
        yaw_rate: 0.004,
        friction: 0.3,
    }
}
