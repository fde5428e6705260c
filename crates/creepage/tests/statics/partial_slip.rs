//! Shift with slip (3.222).

use std::f64::consts::PI;

use creepage::halfspace::{Edge, LoadDisplacement, Polynomial, Traction};
use creepage::statics::{Bonded, PartialSlip, PartialSlipError};
use creepage::{Ellipse, Hertz};
use creepage::{Region, SiForce};
use gauss_quad::GaussLegendre;
use proptest::prelude::*;

use super::support::{close, pair, point};

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
                Region::Outside => prop_assert!(false, "{p:?} is inside"),
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
