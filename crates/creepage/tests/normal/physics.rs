//! Symmetry, scaling, superposition, and what the pressures must satisfy.

use creepage::gap::{Gap, Rectangle, Term};
use creepage::normal::{NormalContact, Resolution};

use crate::support::{function, polynomial, steel};

fn solve(gap: &Gap, approach: f64) -> NormalContact {
    NormalContact::at_approach(gap, steel(), approach, Resolution::STANDARD).unwrap()
}

/// Turning the skew gap round either axis turns the pressures round.
#[test]
fn mirrored_gaps_have_mirrored_pressures() {
    let skew = |sign: f64| polynomial(&[(2, 0, 1.0 / 920.0), (1, 1, sign / 900.0), (0, 2, 0.004)]);
    let [one, other] = [1.0, -1.0].map(|sign| solve(&skew(sign), 50e-6));
    assert!((one.load().value / other.load().value - 1.0).abs() < 1e-4);
    for (x, y) in [(1e-3, 0.3e-3), (-3e-3, 0.5e-3), (0.0, 1.2e-3), (2e-3, -1e-3)] {
        let (there, mirrored) = (one.pressure(x, y), other.pressure(-x, y));
        let peak = one.peak_pressure().value;
        assert!((there - mirrored).abs() < 5e-3 * peak, "{x} {y}: {there} {mirrored}");
    }
}

/// A shape a million times as large at the same approach over length has the same pressure; with
/// a power of two not a digit may differ but by rounding.
#[test]
fn size_does_not_matter() {
    let at_size = |size: f64| {
        let term = |x: u32, y: u32, c: f64| Term {
            x,
            y,
            coefficient: c * size.powi(1 - i32::try_from(x + y).unwrap()),
        };
        let gap = Gap::polynomial(&[term(2, 0, 1.0), term(0, 4, 300.0), term(0, 3, 1.0)]).unwrap();
        solve(&gap, 1e-3 * size)
    };
    let [small, large] = [0.5_f64.powi(20), 1.0].map(at_size);
    let pressure = small.peak_pressure().value / large.peak_pressure().value;
    assert!((pressure - 1.0).abs() < 1e-9, "{pressure}");
    let load = small.load().value / large.load().value;
    assert!((load * 2.0_f64.powi(40) - 1.0).abs() < 1e-9, "{load}");
}

/// Patches far apart carry what each carries alone, less what either lifts the other by:
/// `N2/(pi E* D)` of the approach.
#[test]
fn far_patches_superpose() {
    let distance = 60.0;
    let bump = |x: f64, y: f64| (x * x + y * y) / 400.0;
    let two = function([-35.0, 35.0], [-4.0, 4.0], move |x, y| {
        bump(x + distance / 2.0, y).min(bump(x - distance / 2.0, y))
    });
    let one = function([-4.0, 4.0], [-4.0, 4.0], bump);
    let (both, alone) = (solve(&two, 20e-6), solve(&one, 20e-6));
    assert_eq!(both.patches().len(), 2);
    let modulus = 82e9 / 0.72;
    let lifted = 0.5 * both.load().value / (std::f64::consts::PI * modulus * distance * 1e-3);
    let expected = 2.0 * (alone.load().value - alone.stiffness() * lifted);
    assert!((both.load().value / expected - 1.0).abs() < 2e-3, "{} {expected}", both.load().value);
}

/// By the solution's own pressures: touching inside, apart outside. Displacements by summing
/// point forces of small pieces, the near ones by a fine subdivision.
#[test]
fn pressed_points_touch_and_others_stay_apart() {
    let gap = polynomial(&[(2, 0, 1.0 / 920.0), (0, 2, 1.0 / 600.0), (0, 3, 1.0 / 25_000.0)]);
    let contact = solve(&gap, 50e-6);
    let extent = contact.patches()[0].extent();
    let distance = |x: f64, y: f64| displacement(&contact, &extent, x, y) + gap.at(x, y) - 50e-6;
    for (s, t) in [(0.0, 0.5), (0.3, 0.4), (-0.5, 0.6), (0.2, 0.75)] {
        let y = extent.y[0] + t * (extent.y[1] - extent.y[0]);
        let [from, to] = contact.patches()[0].bands()[0].ends(y).unwrap();
        let (centre, half) = (0.5 * (from + to), 0.5 * (to - from));
        let inside = distance(centre + s * half, y);
        assert!(inside.abs() < 0.1e-6, "{s} {t}: {inside}");
        let outside = distance(centre + 1.3 * half, y);
        assert!(outside > 0.5e-6, "{s} {t}: {outside}");
    }
}

fn displacement(contact: &NormalContact, extent: &Rectangle, x: f64, y: f64) -> f64 {
    // Polar about the point: the 1/r goes, what is left is a mean of line integrals of pressure.
    let (angles, steps) = (180, 800);
    let reach = extent.size()[0].hypot(extent.size()[1]) * 1.2;
    let mut sum = 0.0;
    for i in 0..angles {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(angles)).sin_cos();
        for k in 0..steps {
            let r = reach * (f64::from(k) + 0.5) / f64::from(steps);
            sum += contact.pressure(x + r * cos, y + r * sin);
        }
    }
    let measure = std::f64::consts::TAU / f64::from(angles) * reach / f64::from(steps);
    sum * measure * 0.72 / (std::f64::consts::PI * 82e9)
}

/// The parts of a band add up to the whole, and the whole to the load.
#[test]
fn moments_of_parts_add_up() {
    let gap = polynomial(&[(2, 0, 1.0 / 920.0), (1, 1, 1.0 / 900.0), (0, 2, 1.0 / 250.0)]);
    let contact = solve(&gap, 50e-6);
    let band = &contact.patches()[0].bands()[0];
    let [low, high] = band.y();
    let (rows, columns) = (13, 9);
    let mut force = 0.0;
    for row in 0..rows {
        let y = |i: i32| low + (high - low) * f64::from(i) / f64::from(rows);
        for column in 0..columns {
            let s = |i: i32| 2.0 * f64::from(i) / f64::from(columns) - 1.0;
            let part = band.moments([y(row), y(row + 1)], [s(column), s(column + 1)]);
            assert!(part.force > 0.0);
            force += part.force;
        }
    }
    assert!((force / contact.load().value - 1.0).abs() < 1e-3, "{force}");
    let [x, y] = contact.centroid();
    // The skew ellipse is its own image under a half turn.
    assert!(x.abs() < 1e-6 && y.abs() < 1e-6, "{x} {y}");
}
