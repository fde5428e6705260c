//! Shift and twist without slip (3.212).

use creepage::SiForce;
use creepage::statics::Bonded;
use creepage::{Ellipse, Solid, SolidPair};

use super::support::{close, over_ellipse, pair, point};

#[test]
fn bonded_bodies_move_as_one_and_carry_the_force() {
    let unlike = SolidPair::new(Solid::new(82e9, 0.28).unwrap(), Solid::new(26e9, 0.33).unwrap());
    let force = SiForce { longitudinal: 900.0, lateral: -400.0, moment: 3.0 };
    for axes in [[2e-3, 5e-3], [5e-3, 2e-3], [4e-3, 4e-3]] {
        let ellipse = Ellipse::new(axes[0], axes[1]).unwrap();
        let bonded = Bonded::new(unlike, ellipse, force).unwrap();
        let component = |i: usize, arm: &dyn Fn([f64; 2]) -> f64| {
            over_ellipse(ellipse, |p| arm(p) * bonded.traction(p)[i])
        };
        // (3.34) against the equations: the traction of that shift and twist has these sums.
        close(component(0, &|_| 1.0), 900.0, 1e-13);
        close(component(1, &|_| 1.0), -400.0, 1e-13);
        close(component(1, &|[x, _]| x) - component(0, &|[_, y]| y), 3.0, 1e-12);
        for (r, f) in [(0.2, 1.0), (0.9, -2.0)] {
            let [x, y] = point(ellipse, r, f);
            let [u, v, w] = bonded.displacement([x, y]);
            let [dx, dy] = bonded.shift();
            close(u, dx - bonded.twist() * y, 1e-12);
            close(v, dy + bonded.twist() * x, 1e-12);
            assert!(w != 0.0, "unlike bodies open or close");
        }
    }
    let nothing = SiForce { moment: f64::NAN, ..SiForce::default() };
    assert!(Bonded::new(unlike, Ellipse::new(1.0, 1.0).unwrap(), nothing).is_err());
}

/// Mindlin: a circle's shift `(2 - sigma) F/(4 G a)` and twist `3 M/(8 G a^3)`, in the combined
/// modulus (each body's half is doubled by both).
#[test]
fn bonded_circle() {
    let (a, sigma, g) = (3e-3, 0.3, 82e9);
    let force = SiForce { longitudinal: 900.0, lateral: 500.0, moment: 3.0 };
    let bonded = Bonded::new(pair(sigma), Ellipse::new(a, a).unwrap(), force).unwrap();
    let [dx, dy] = bonded.shift();
    close(dx, (2.0 - sigma) * 900.0 / (4.0 * g * a), 1e-14);
    close(dy, (2.0 - sigma) * 500.0 / (4.0 * g * a), 1e-14);
    close(bonded.twist(), 3.0 * 3.0 / (8.0 * g * a.powi(3)), 1e-14);
}
