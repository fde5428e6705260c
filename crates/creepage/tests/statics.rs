//! The classical problems of section 3.2 against closed forms, limits and each other.
#![allow(clippy::unwrap_used)] // Tests may fail by unwrapping.

use std::f64::consts::PI;

use creepage::halfspace::{Edge, LoadDisplacement, Polynomial, Traction};
use creepage::rolling::{Region, SiForce};
use creepage::statics::{Bonded, Die, DieError, PartialSlip, PartialSlipError};
use creepage::{Ellipse, Hertz, Solid, SolidPair};
use gauss_quad::GaussLegendre;
use proptest::prelude::*;

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} against {expected}");
}

fn pair(poisson: f64) -> SolidPair {
    let solid = Solid::new(82e9, poisson).unwrap();
    SolidPair::new(solid, solid)
}

/// Point at `(r, f)` on the disc of an ellipse.
fn point(ellipse: Ellipse, r: f64, f: f64) -> [f64; 2] {
    [ellipse.a() * r * f.cos(), ellipse.b() * r * f.sin()]
}

/// The integral of `f` times `(1 - r^2)^(1/2)` over the ellipse, without that factor's root.
fn over_ellipse(ellipse: Ellipse, f: impl Fn([f64; 2]) -> f64) -> f64 {
    let (rays, radial) = (48, GaussLegendre::new(24.try_into().unwrap()));
    let sum: f64 = (0..rays)
        .map(|ray| {
            let angle = 2.0 * PI * (f64::from(ray) + 0.5) / f64::from(rays);
            radial.integrate(0.0, 1.0, |z| z * f(point(ellipse, (1.0 - z * z).sqrt(), angle)))
        })
        .sum();
    sum * ellipse.a() * ellipse.b() * 2.0 * PI / f64::from(rays)
}

// The die.

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

// Shift and twist without slip.

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

// Shift with slip.

fn contact(ratio: f64, poisson: f64) -> Hertz {
    let c = 4e-3;
    let ellipse = Ellipse::new(c * ratio.sqrt(), c / ratio.sqrt()).unwrap();
    Hertz::from_ellipse(pair(poisson), ellipse, 8e4).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]
    /// The laws that the solution satisfies: bound, balance, no slip in the adhesion area.
    #[test]
    fn partial_slip_keeps_the_bound_and_sticks_in_the_adhesion_area(
        log_ratio in -1.3_f64..1.3, poisson in 0.0_f64..=0.5, share in 0.001_f64..0.999,
        angle in 0.0_f64..6.3, radii in proptest::array::uniform8(0.0_f64..1.0),
    ) {
        let contact = contact(10.0_f64.powf(log_ratio), poisson);
        let (mu, ellipse) = (0.3, contact.ellipse());
        let size = share * mu * contact.normal_force();
        let force = [size * angle.cos(), size * angle.sin()];
        let partial = PartialSlip::new(&contact, mu, force).unwrap();
        let unit = partial.shift()[0].hypot(partial.shift()[1]);
        for (i, r) in radii.into_iter().enumerate() {
            let p = point(ellipse, r, i as f64);
            let [x, y] = partial.traction(p);
            let bound = partial.bound(p);
            // Rounding of the bound itself.
            prop_assert!(x.hypot(y) <= bound * (1.0 + 1e-14));
            let [sx, sy] = partial.slip(p).unwrap();
            match partial.region(p).unwrap() {
                Region::Adhesion => {
                    prop_assert!(sx.hypot(sy) < 1e-10 * unit, "slip {sx} {sy} of {unit}");
                    prop_assert!(partial.disagreement(p).is_none());
                }
                Region::Slip => {
                    prop_assert!((x.hypot(y) / bound - 1.0).abs() < 1e-14);
                    // Slip has the sense of the traction, but for the angle.
                    let miss = partial.disagreement(p).unwrap();
                    prop_assert!(sx.hypot(sy) < 1e-9 * unit || miss.abs() < PI / 4.0);
                }
            }
        }
        prop_assert!(partial.region(point(ellipse, 1.01, angle)).is_none());
        prop_assert!(partial.slip(point(ellipse, 1.01, angle)).is_none());
    }
}

/// The traction's sum is the force: both roots integrate exactly, each over its own ellipse.
#[test]
fn partial_slip_balances_the_force() {
    let contact = contact(0.5, 0.28);
    let force = [11e3, -9e3];
    let partial = PartialSlip::new(&contact, 0.3, force).unwrap();
    let (radial, rays) = (GaussLegendre::new(40.try_into().unwrap()), 7);
    let scale = partial.adhesion().a() / contact.ellipse().a();
    let sum = |i: usize| {
        let along = |f: f64| {
            let value = |r: f64| r * partial.traction(point(contact.ellipse(), r, f))[i];
            // Substitutions that make the roots smooth in both parts.
            let stick =
                radial.integrate(0.0, PI / 2.0, |t: f64| scale * t.cos() * value(scale * t.sin()));
            stick + radial.integrate(scale.asin(), PI / 2.0, |t: f64| t.cos() * value(t.sin()))
        };
        let sum: f64 = (0..rays).map(|ray| along(f64::from(ray))).sum();
        2.0 * PI / f64::from(rays) * sum * contact.ellipse().a() * contact.ellipse().b()
    };
    close(sum(0), force[0], 1e-10);
    close(sum(1), force[1], 1e-10);
}

/// For a small force: the shift of the bonded contact (3.34).
#[test]
fn partial_slip_tends_to_no_slip() {
    for ratio in [0.1, 1.0, 6.0] {
        let contact = contact(ratio, 0.28);
        let limit = 0.3 * contact.normal_force();
        for share in [1e-2, 1e-5, 1e-12] {
            let force = [0.6 * share * limit, 0.8 * share * limit];
            let partial = PartialSlip::new(&contact, 0.3, force).unwrap();
            let si = SiForce { longitudinal: force[0], lateral: force[1], moment: 0.0 };
            let bonded = Bonded::new(contact.pair(), contact.ellipse(), si).unwrap();
            for i in 0..2 {
                // 1 - (1 - f)^(2/3) = (2/3) f (1 + f/6 + ...)
                let expected = bonded.shift()[i] * (1.0 + share / 6.0);
                close(partial.shift()[i], expected, share * share + 1e-14);
                let inner = point(contact.ellipse(), 0.5, 1.0);
                let [loose, stuck] = [partial.traction(inner)[i], bonded.traction(inner)[i]];
                close(loose, stuck, share + 1e-12);
            }
        }
        let still = PartialSlip::new(&contact, 0.3, [0.0, 0.0]).unwrap();
        assert_eq!(still.adhesion(), contact.ellipse());
        assert!(still.traction([0.0, 0.0])[0].abs() < f64::MIN_POSITIVE);
    }
}

/// After (3.65): 4.1 and 9.6 degrees on a circle, `tan = sigma/sqrt((4 - 3 sigma)(4 - sigma))`.
#[test]
fn slip_and_traction_disagree_by_the_thesis_s_angles() {
    for (sigma, degrees) in [(0.0, 0.0), (0.25, 4.10), (0.5, 9.59)] {
        let contact = contact(1.0, sigma);
        let almost = 0.3 * contact.normal_force() * (1.0 - 1e-9);
        let partial = PartialSlip::new(&contact, 0.3, [0.0, almost]).unwrap();
        let exact = (sigma / ((4.0 - 3.0 * sigma) * (4.0 - sigma)).sqrt()).atan();
        assert!((partial.largest_disagreement() - exact).abs() < 1e-14);
        assert!((exact.to_degrees() - degrees).abs() < 0.005);
        let found = (0..720)
            .map(|i| point(contact.ellipse(), 0.9, f64::from(i) * PI / 360.0))
            .filter_map(|p| partial.disagreement(p))
            .fold(0.0_f64, |largest, angle| largest.max(angle.abs()));
        // A maximum on a grid of half degrees; adhesion has a thousandth of the axes left.
        assert!((found - exact).abs() < 1e-4, "{found} {exact}");
    }
}

/// The largest angle on ellipses, against a search, for forces of any direction.
#[test]
fn largest_disagreement_on_ellipses() {
    for (ratio, angle) in [(0.2, 0.0), (0.2, 1.0), (5.0, 0.4), (2.0, 2.0)] {
        let contact = contact(ratio, 0.4);
        let almost = 0.3 * contact.normal_force() * (1.0 - 1e-12);
        let force = [almost * f64::cos(angle), almost * f64::sin(angle)];
        let partial = PartialSlip::new(&contact, 0.3, force).unwrap();
        let found = (0..3600)
            .map(|i| point(contact.ellipse(), 0.9, f64::from(i) * PI / 1800.0))
            .filter_map(|p| partial.disagreement(p))
            .fold(0.0_f64, |largest, angle| largest.max(angle.abs()));
        // Grid of a tenth of a degree; adhesion has a ten-thousandth of the axes left.
        assert!((found / partial.largest_disagreement() - 1.0).abs() < 1e-4, "{ratio} {angle}");
    }
}

/// The displacements of complete sliding are those of Hertz's pressure turned sideways.
#[test]
fn displacement_of_partial_slip_by_the_equations() {
    let contact = contact(3.0, 0.28);
    let partial = PartialSlip::new(&contact, 0.3, [1.2e4, 1.6e4]).unwrap();
    let peak = 0.3 * contact.peak_pressure() / contact.pair().shear_modulus();
    let displacement = |ellipse: Ellipse, peak: f64| {
        let [x, y] = [0.6, 0.8].map(|part| Polynomial::new(vec![part * peak]).unwrap());
        let traction =
            Traction::new(ellipse, Edge::Vanishing, [&x, &y, &Polynomial::zero(0)]).unwrap();
        LoadDisplacement::new(ellipse, 0.28, 2).unwrap().displacement(&traction).unwrap()
    };
    let full = displacement(contact.ellipse(), peak);
    let relief =
        displacement(partial.adhesion(), peak * partial.adhesion().a() / contact.ellipse().a());
    let p = point(partial.adhesion(), 0.7, 0.4);
    for i in 0..2 {
        close(partial.displacement(p)[i], full[i].at(p) - relief[i].at(p), 1e-13);
        close(partial.displacement(p)[i], partial.shift()[i], 1e-12);
    }
}

#[test]
fn too_large_a_force_is_an_error() {
    let contact = contact(1.0, 0.28);
    let limit = 0.3 * contact.normal_force();
    for force in [[limit, 0.0], [limit, limit], [0.0, f64::MAX]] {
        let error = PartialSlip::new(&contact, 0.3, force).unwrap_err();
        assert!(matches!(error, PartialSlipError::Sliding { .. }), "{error}");
    }
    assert!(matches!(
        PartialSlip::new(&contact, 0.3, [f64::NAN, 0.0]),
        Err(PartialSlipError::Invalid(_))
    ));
    assert!(PartialSlip::new(&contact, 0.0, [0.0, 0.0]).is_err());
}
