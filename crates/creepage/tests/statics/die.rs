//! The rigid die (3.211).

use std::f64::consts::PI;

use creepage::statics::{Die, DieError};
use creepage::{Ellipse, Solid};

use super::support::{close, over_ellipse, point};

#[test]
fn pressure_of_the_die_balances_the_load() {
    let solid = Solid::new(3e9, 0.4).unwrap();
    for base in [[2e-3, 5e-3], [5e-3, 2e-3], [4e-3, 4e-3]] {
        let base = Ellipse::new(base[0], base[1]).unwrap();
        let offset = [0.2 * base.a(), -0.1 * base.b()];
        let die = Die::new(solid, base, 700.0, offset).unwrap();
        let moment =
            |arm: &dyn Fn([f64; 2]) -> f64| over_ellipse(base, |p| arm(p) * die.pressure(p));
        close(moment(&|_| 1.0), 700.0, 1e-13);
        close(moment(&|[x, _]| x), 700.0 * offset[0], 1e-12);
        close(moment(&|[_, y]| y), 700.0 * offset[1], 1e-12);
    }
}

#[test]
fn the_die_stays_flat() {
    let solid = Solid::new(3e9, 0.4).unwrap();
    for base in [[2e-3, 5e-3], [5e-3, 2e-3]] {
        let base = Ellipse::new(base[0], base[1]).unwrap();
        let die = Die::new(solid, base, 700.0, [0.1 * base.a(), 0.3 * base.b()]).unwrap();
        for (r, f) in [(0.0, 0.0), (0.5, 1.0), (0.99, 4.0)] {
            let [x, y] = point(base, r, f);
            let [slope_x, slope_y] = die.tilt();
            let expected = die.indentation() + slope_x * x + slope_y * y;
            close(die.displacement([x, y])[2], expected, 1e-13);
        }
        // Beside the die the surface lies higher, and far off as under a point load
        // (1 - sigma) N / (2 pi G+ R).
        assert!(die.displacement(point(base, 1.2, 0.3))[2] < die.indentation());
        let far = 3.0;
        let point_load = 0.6 * 700.0 / (2.0 * PI * 3e9 * far);
        // Next comes the dipole, offset/R.
        close(die.displacement([far, 0.0])[2], point_load, 1e-3);
    }
}

/// Boussinesq: a circular die, `w = (1 - sigma) N / (4 G a)`, `u` as for any load of that kind.
#[test]
fn circular_die() {
    let (a, sigma, g, n) = (3e-3, 0.28, 82e9, 1e4);
    let base = Ellipse::new(a, a).unwrap();
    let die = Die::new(Solid::new(g, sigma).unwrap(), base, n, [0.0, 0.0]).unwrap();
    close(die.indentation(), (1.0 - sigma) * n / (4.0 * g * a), 1e-14);
    close(die.pressure([0.0, 0.0]), n / (2.0 * PI * a * a), 1e-14);
    // The surface moves inward by (1 - 2 sigma)/(4 pi G r) times the load within r.
    let r = 0.6 * a;
    let within = n * (1.0 - 0.8);
    let inward = (1.0 - 2.0 * sigma) * within / (4.0 * PI * g * r);
    close(die.displacement([r, 0.0])[0], -inward, 1e-11);
    close(die.margin(), 1.0, 1e-15);
}

#[test]
fn the_die_lifts_off_beyond_a_third_of_the_axes() {
    let solid = Solid::new(3e9, 0.4).unwrap();
    let base = Ellipse::new(2e-3, 5e-3).unwrap();
    for angle in [0.0, 0.7, 2.0, 5.5] {
        let at = |share: f64| Die::new(solid, base, 700.0, point(base, share / 3.0, angle));
        let limit = at(1.0).unwrap();
        assert!(limit.margin() < 1e-15);
        // (3.27b): the pressure, over the edge's square root, is zero opposite the load.
        let r = 1.0 - 1e-10;
        let [here, opposite] = [angle, angle + PI].map(|f| limit.pressure(point(base, r, f)));
        // 1 - r is what is left of the factor there, against 2 on this side.
        close(opposite / here, 0.5e-10, 1e-4);
        let expected = point(base, 0.4, angle);
        match at(1.2).unwrap_err() {
            DieError::LiftOff { x, y, excess } => {
                assert!((x - expected[0]).hypot(y - expected[1]) < 1e-15 * base.major());
                close(excess, 1.2, 1e-14);
            }
            other => panic!("{other}"),
        }
    }
    let message = Die::new(solid, base, 700.0, [1e-3, 0.0]).unwrap_err().to_string();
    assert!(message.contains("lifts off"), "{message}");
    assert!(Die::new(solid, base, -1.0, [0.0, 0.0]).is_err());
    assert!(Die::new(solid, base, 1.0, [f64::NAN, 0.0]).is_err());
}
