//! Elements taken together far from a point: against their closed forms.

use creepage::coulomb::{Exact, Resolution};
use creepage::subsurface::{Body, Element, Interior};
use creepage::{Creepage, Solid, Theory};

use crate::support::{apart, contact, sliding};

/// Whole numbers in disorder (Marsaglia's xorshift), as numbers from 0 to 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Points in and around a contact of these semi-axes: below it at all depths, on the surface, at the edge and
/// far away.
fn points(count: usize, [a, b]: [f64; 2]) -> Vec<[f64; 3]> {
    let mut random = Random(88_172_645_463_325_252);
    let point = |k: usize| {
        let [s, t, u] = [(); 3].map(|()| 2.0 * random.next() - 1.0);
        let deep = a.min(b) * random.next();
        match k % 5 {
            0 => [1.5 * a * s, 1.5 * b * t, 2.0 * deep],
            1 => [1.5 * a * s, 1.5 * b * t, 0.0],
            2 => {
                let (sin, cos) = (3.2 * s).sin_cos();
                [a * cos * (1.0 + 0.05 * t), b * sin * (1.0 + 0.05 * t), 0.1 * deep]
            }
            3 => [a * s, b * t, 0.3 * deep],
            _ => [10.0 * a * s, 10.0 * b * t, 10.0 * a.max(b) * u.abs()],
        }
    };
    (0..count).map(point).collect()
}

/// The largest differences of stress and of displacement between both ways, the latter over the largest.
fn differences(interior: &Interior, points: &[[f64; 3]]) -> [f64; 2] {
    let (mut worst, mut moved) = ([0.0_f64; 2], 0.0_f64);
    for (point, found) in points.iter().zip(interior.at_all(points).unwrap()) {
        worst[0] = worst[0].max(apart(&found.stress, &interior.stress(*point).unwrap()));
        let expected = interior.displacement(*point).unwrap();
        for (found, expected) in found.displacement.into_iter().zip(expected) {
            worst[1] = worst[1].max((found - expected).abs());
            moved = moved.max(expected.abs());
        }
    }
    [worst[0], worst[1] / moved]
}

/// 10,000 points below the elements of the standard resolution, of rolling contacts whose peak pressure
/// is one.
#[test]
fn below_rolling_contacts() {
    let cases = [(1.0, [0.5, 0.2, 0.3], Body::Lower), (0.2, [0.1, 0.6, 1.0], Body::Upper)];
    for (a_over_b, creepage, body) in cases {
        let (hertz, solid) = contact(a_over_b, 0.28);
        let contact = hertz.with_friction(0.3).unwrap();
        let theory = Exact::new(&contact, Resolution::STANDARD).unwrap();
        let [xi, eta, chi] = creepage;
        let solved = theory.solved(Creepage::new(xi, eta, chi).unwrap());
        let interior = Interior::rolling(&hertz, &contact, &*solved, solid, body).unwrap();
        let points = points(5000, [1.0, 1.0 / a_over_b]);
        let [stress, displacement] = differences(&interior, &points);
        // A tenth of what is promised.
        assert!(stress < 1e-5 && displacement < 1e-6, "{stress:e} {displacement:e}");
    }
}

/// Tractions without any order, each of three components up to one: the worst that a box of elements is
/// asked to stand for.
#[test]
fn below_disorder() {
    let mut random = Random(2_463_534_242);
    let mut elements = vec![];
    for k in 0..1600_u32 {
        let middle = [f64::from(k % 40) - 19.5, f64::from(k / 40) - 19.5].map(|x| x / 20.0);
        let traction = [(); 3].map(|()| 2.0 * random.next() - 1.0);
        elements.push(Element::rectangle(middle, [0.05, 0.05], traction).unwrap());
    }
    let interior =
        Interior::new(Solid::new(1.0, 0.2).unwrap(), Body::Lower).with_elements(&elements);
    let [stress, displacement] = differences(&interior, &points(3000, [1.0, 1.0]));
    // What is promised.
    assert!(stress < 1e-4 && displacement < 1e-5, "{stress:e} {displacement:e}");
}

/// Hertz's pressure and full sliding, from the surface to far away, at the edge too: two ways of the same
/// integral over directions.
#[test]
fn below_hertz_pressure() {
    for (a_over_b, body) in [(1.0, Body::Lower), (0.3, Body::Upper), (5.0, Body::Lower)] {
        let interior = sliding(a_over_b, 0.3, [0.3, -0.1], body);
        let [stress, displacement] = differences(&interior, &points(2000, [1.0, 1.0 / a_over_b]));
        // That to which the sums over directions agree.
        assert!(stress < 1e-9 && displacement < 1e-9, "{stress:e} {displacement:e}");
    }
}

/// Elements of any shape and order, some of them without area, seen from above and from a corner; where
/// there are none there is no field.
#[test]
fn odd_elements() {
    let solid = Solid::new(1.0, 0.3).unwrap();
    let none = Interior::new(solid, Body::Lower).at([0.0, 0.0, 1.0]).unwrap();
    assert_eq!(none, creepage::subsurface::Inside::default());
    let corner = |k: u32, turn: f64| {
        let (sin, cos) = (f64::from(k) * turn).sin_cos();
        [cos, sin]
    };
    // Arrowheads and pentagons, both ways around, a line and a point.
    let mut elements = vec![];
    for k in 0..40_u32 {
        let [x, y] = corner(k, 0.7).map(|part| 3.0 * part);
        let size = 0.02 * f64::from(1 + k % 7);
        let count = 3 + k % 4;
        let mut corners: Vec<_> = (0..count)
            .map(|i| corner(i, std::f64::consts::TAU / f64::from(count)))
            .map(|[u, v]| [x + size * u, y + size * v])
            .collect();
        if k % 3 == 0 {
            corners[0] = [x - 0.3 * size, y];
        }
        if k % 2 == 0 {
            corners.reverse();
        }
        elements.push(Element::new(&corners, [1.0, -0.5, 0.7]).unwrap());
    }
    elements.push(Element::new(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]], [1.0; 3]).unwrap());
    elements.push(Element::new(&[[0.1, 0.2]; 3], [1.0; 3]).unwrap());
    let interior = Interior::new(solid, Body::Lower).with_elements(&elements);
    let mut points = points(1000, [3.0, 3.0]);
    points.push([4e3, 0.0, 1.0]);
    for point in [[0.1, 0.2, 0.0], [1.0, 1.0, 0.0]] {
        let stress = interior.at(point).unwrap().stress;
        assert!(stress.components().iter().all(|part| part.is_finite()), "{point:?}");
    }
    let [stress, displacement] = differences(&interior, &points);
    assert!(stress < 1e-4 && displacement < 1e-5, "{stress:e} {displacement:e}");
    // Other units of length, no other stresses.
    let small: Vec<_> = elements
        .iter()
        .map(|one| {
            let corners: Vec<_> = one.corners().iter().map(|at| at.map(|x| 1e-9 * x)).collect();
            Element::new(&corners, one.traction()).unwrap()
        })
        .collect();
    let small = Interior::new(solid, Body::Lower).with_elements(&small);
    for point in points {
        let (one, other) =
            (interior.at(point).unwrap(), small.at(point.map(|x| 1e-9 * x)).unwrap());
        // Rounding of corners that are near the point.
        assert!(apart(&one.stress, &other.stress) < 1e-4, "{point:?}");
    }
}
