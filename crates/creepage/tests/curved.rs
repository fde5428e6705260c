//! Curved contacts: grooves against own elements and CONTACT's, and the plane as the groove opens.

#![allow(clippy::unwrap_used, clippy::print_stdout)] // helpers of tests, which show their numbers

use creepage::coulomb::Resolution;
use creepage::curved::CurvedGap;
use creepage::normal;
use creepage::{Hertz, Radii, SiCreepage, Solid, SolidPair};

/// The bodies of formula sheet 9, E: a wheel of 10 mm across and 420 mm along in a groove, 10 kN, G 80 `GPa`.
fn pair() -> SolidPair {
    let body = Solid::new(80e9, 0.28).unwrap();
    SolidPair::new(body, body)
}

fn groove(outer: f64) -> CurvedGap {
    CurvedGap::groove(10e-3, 1e-3 * outer, 420e-3).unwrap()
}

/// Sheet 9: own elements on exact gaps without friction, uncertain by .1 % in pressure and approach.
#[test]
fn grooves_without_friction() {
    for [outer, peak, approach, hertz] in [
        [10.25, 532.6, 0.022_61, 517.7],
        [10.10, 412.5, 0.019_73, 391.4],
        [10.05, 352.6, 0.017_80, 324.9],
        [10.02, 300.9, 0.015_80, 260.6],
    ] {
        let contact = groove(outer).under_load(pair(), 10e3, normal::Resolution::FINE).unwrap();
        let found = contact.normal().peak_pressure().value / 1e6;
        println!(
            "{outer}: {found} {} {} deg",
            1e3 * contact.approach(),
            0.5 * contact.turn().to_degrees()
        );
        assert!((contact.vertical() / 10e3 - 1.0).abs() < 2e-5 && contact.lateral().abs() < 1.0);
        assert!((found / peak - 1.0).abs() < 2.5e-3, "{outer} {found}");
        assert!((1e3 * contact.approach() / approach - 1.0).abs() < 1.5e-3, "{outer}");
        // Hertz, in a plane, is lower.
        assert!(found > 1.02 * hertz);
    }
}

/// Half the contact angle at 10.02: 43.6 degrees, by elements of 1.4 degrees.
#[test]
fn the_narrowest_groove_is_touched_over_87_degrees() {
    let contact = groove(10.02).under_load(pair(), 10e3, normal::Resolution::FINE).unwrap();
    assert!((0.5 * contact.turn().to_degrees() - 43.6).abs() < 1.4);
    // All pressure along the normals: 10631 N.
    assert!((contact.normal().load().value / 10_631.0 - 1.0).abs() < 2e-3);
}

/// Sheet 9, rolling without longitudinal force, half-space: peak, approach and all pressure by CONTACT's elements, to
/// .2 %; and by how much the middle turns faster than a wheel of its radius (`examples_conformal/groove_li`, VPITCH):
/// 2 % by its grid, and ours another.
#[test]
fn grooves_that_are_rolled_through() {
    let free = SiCreepage::default();
    let press = (normal::Resolution::STANDARD, Resolution::STANDARD);
    for [outer, peak, approach, normal, faster] in [
        [10.25, 530.0, 0.022_37, 9915.0, 2.301e-4],
        [10.10, 409.1, 0.019_39, 9931.0, 4.411e-4],
        [10.05, 348.7, 0.017_42, 10_010.0, 6.495e-4],
        [10.02, 296.9, 0.015_40, 10_260.0, 9.761e-4],
    ] {
        let (contact, rolling, found) =
            groove(outer).rolled(pair(), 10e3, 0.3, free, Some(0.0), press).unwrap();
        let solved = rolling.solve(found).unwrap();
        let force = rolling.force(&solved);
        println!(
            "{outer}: {} {} {} {:e} {force:?}",
            contact.normal().peak_pressure().value / 1e6,
            1e3 * contact.approach(),
            contact.normal().load().value,
            found.longitudinal
        );
        assert!((contact.vertical() + force.vertical - 10e3).abs() < 2.0);
        // The force of two grids, extrapolated, is none; that of the finer one's elements errs by .3 % of mu N.
        assert!(force.longitudinal.abs() < 9.0, "{force:?}");
        assert!((contact.normal().peak_pressure().value / (1e6 * peak) - 1.0).abs() < 6e-3);
        assert!((1e3 * contact.approach() / approach - 1.0).abs() < 5e-3);
        assert!((contact.normal().load().value / normal - 1.0).abs() < 5e-3);
        assert!((-found.longitudinal / faster - 1.0).abs() < 0.04, "{:e}", found.longitudinal);
    }
}

/// As the groove opens the contact becomes Hertz's: in 40 mm the normals turn by 1.6 degrees.
#[test]
fn an_open_groove_is_a_plane() {
    let radii = |rolling, lateral| Radii { rolling, lateral };
    let mut before = f64::INFINITY;
    for outer in [12.0, 20.0, 30.0] {
        let contact = groove(outer).under_load(pair(), 100.0, normal::Resolution::FINE).unwrap();
        let hertz = Hertz::new(
            pair(),
            radii(420e-3, 10e-3),
            radii(f64::INFINITY, -1e-3 * outer),
            0.0,
            100.0,
        )
        .unwrap();
        let away = (contact.normal().peak_pressure().value / hertz.peak_pressure() - 1.0).abs();
        println!("{outer}: {away:e}");
        assert!(away < before.min(2e-3));
        before = away.max(2e-4);
    }
}

#[test]
fn nonsense_is_an_error_that_names_the_quantity() {
    let quantity =
        |inner, outer, rolling| CurvedGap::groove(inner, outer, rolling).unwrap_err().quantity;
    assert_eq!(quantity(1.0, 0.9, 1.0), "inner");
    assert_eq!(quantity(-1.0, 0.9, 1.0), "inner");
    assert_eq!(quantity(1.0, 2.0, f64::NAN), "rolling");
    assert!(groove(10.1).under_load(pair(), -1.0, normal::Resolution::FAST).is_err());
    let creepage = SiCreepage { longitudinal: f64::NAN, ..SiCreepage::default() };
    let contact = groove(10.1).under_load(pair(), 1e3, normal::Resolution::FAST).unwrap();
    assert!(contact.rolling(0.3, Resolution::FAST).unwrap().solve(creepage).is_err());
}
