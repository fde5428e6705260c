//! Viscoelastic cylinders against the formula sheet, their limits, and Carter's line contact.

#![allow(clippy::unwrap_used, clippy::print_stdout)] // helpers of tests, which show their numbers

use std::f64::consts::PI;

use creepage::viscoelastic::{Relaxation, ViscoelasticCylinders};

const LOAD: f64 = 600e3;

fn polymer(distance: f64) -> ViscoelasticCylinders {
    let soft = Relaxation { ratio: 1.0, time: distance };
    ViscoelasticCylinders::new(1143e6, 0.4, soft, 50e-3, 1.0).unwrap()
}

/// Formula sheet B4, "good to the last digit or two": lead, trail, peak and its place, centre, creepage at .6 mu N.
#[test]
fn the_polymer_cylinders_of_the_sheet() {
    for [distance, lead, trail, peak, at, centre, creepage] in [
        [0.5, 6.329_078, 6.086_491, 60.395_94, 0.259_07, 0.235_217, 0.013_976_6],
        [3.0, 6.229_914, 5.008_630, 65.793_21, 2.297_81, 0.992_015, 0.014_173_2],
        [9.0, 5.837_944, 3.907_191, 78.733_63, 2.024_98, 1.222_176, 0.013_806_0],
        [45.0, 5.050_744, 3.970_297, 84.718_02, 0.762_79, 0.595_816, 0.011_714_1],
        [2000.0, 4.509_042, 4.446_706, 85.302_08, 0.036_18, 0.032_421, 0.009_981_7],
    ] {
        let cylinders = polymer(1e-3 * distance);
        let pressure = cylinders.pressed(LOAD).unwrap();
        let [trailing, leading] = pressure.ends().map(|x| 1e3 * x);
        let [largest, place] = pressure.largest();
        let found = cylinders.creepage(LOAD, 0.3, 0.6 * 0.3 * LOAD).unwrap();
        println!(
            "{distance}: {leading} {trailing} {largest} {place} {} {found}",
            pressure.centre()
        );
        assert!((leading - lead).abs() < 3e-6 && (trailing + trail).abs() < 3e-6, "{distance}");
        assert!((largest / 1e6 - peak).abs() < 3e-5, "{distance} {largest}");
        // The summit is flat: its place is less certain.
        assert!((1e3 * place - at).abs() < 3e-4, "{distance} {place}");
        assert!((1e3 * pressure.centre() - centre).abs() < 3e-6, "{distance}");
        assert!((found - creepage).abs() < 2e-7, "{distance} {found}");
    }
}

/// Slow: rubbery Hertz moved ahead by `D f/(1 + f)`; fast: glassy Hertz, and the sheet's B3 for the centre.
#[test]
fn slow_and_fast_bodies_are_elastic() {
    let slow = polymer(1e-5).pressed(LOAD).unwrap();
    let [glassy, rubbery] = polymer(1e-5).elastic_half_widths(LOAD);
    assert!((1e3 * rubbery - 6.332_617).abs() < 1e-6 && (1e3 * glassy - 4.477_836).abs() < 1e-6);
    assert!((slow.largest()[0] / 60.318_17e6 - 1.0).abs() < 1e-5);
    assert!((slow.centre() / 0.5e-5 - 1.0).abs() < 1e-2, "{}", slow.centre());
    let fast = polymer(10.0).pressed(LOAD).unwrap();
    assert!((fast.largest()[0] / 85.302_78e6 - 1.0).abs() < 1e-5);
    let ratio = glassy / 10.0;
    let centre = 0.5 * glassy * ratio * ((2.0 / ratio).ln() + 0.25 - 0.577_215_664_9);
    assert!((fast.centre() / centre - 1.0).abs() < 2e-3, "{} {centre}", fast.centre());
}

/// Without relaxation it is Carter's: creepage `mu a/R (1 - sqrt(1 - F/mu N))`.
#[test]
fn without_relaxation_it_is_carters() {
    let stiff = Relaxation { ratio: 0.0, time: 5e-3 };
    let cylinders = ViscoelasticCylinders::new(571.5e6, 0.4, stiff, 50e-3, 1.0).unwrap();
    let found = cylinders.creepage(LOAD, 0.3, 0.6 * 0.3 * LOAD).unwrap();
    let carter = 0.3 * 6.332_617e-3 / 50e-3 * (1.0 - 0.4_f64.sqrt());
    assert!((found / carter - 1.0).abs() < 1e-6, "{found} {carter}");
    let pressure = cylinders.pressed(LOAD).unwrap();
    assert!(pressure.centre().abs() < 1e-12 && (pressure.at(0.0) / 60.318_17e6 - 1.0).abs() < 1e-6);
}

/// The load is the integral of the pressure, which is nowhere negative; 300 cases are solved.
#[test]
fn any_speed_and_softness_is_solved() {
    for i in 0..30_u16 {
        for j in 0..10_u16 {
            let distance = 1e-6 * 10.0_f64.powf(0.28 * f64::from(i));
            let ratio = 0.05 * 2.0_f64.powi(i32::from(j));
            let soft = Relaxation { ratio, time: distance };
            let cylinders = ViscoelasticCylinders::new(1e9, 0.45, soft, 0.1, 1.0).unwrap();
            let relative = distance / cylinders.elastic_half_widths(LOAD)[1];
            if !(1e-4..=1e5).contains(&relative) {
                assert!(cylinders.pressed(LOAD).is_err());
                continue;
            }
            let pressure =
                cylinders.pressed(LOAD).unwrap_or_else(|e| panic!("{relative} {ratio}: {e}"));
            // Midpoints of even angles: the pressure is smooth in the angle but for its ends.
            let [from, to] = pressure.ends();
            let (middle, half, n) = (0.5 * (from + to), 0.5 * (to - from), 2000_u16);
            let part = |k: u16| {
                let angle = PI * (f64::from(k) + 0.5) / f64::from(n);
                pressure.at(middle + half * angle.cos()) * half * angle.sin() * PI / f64::from(n)
            };
            let load: f64 = (0..n).map(part).sum();
            assert!((load / LOAD - 1.0).abs() < 1e-5, "{relative} {ratio}: {load}");
            assert!(pressure.centre() > 0.0 && pressure.rolling_resistance().is_finite());
        }
    }
}

#[test]
fn nonsense_is_an_error_that_names_the_quantity() {
    let soft = Relaxation { ratio: -0.1, time: 1.0 };
    let error = ViscoelasticCylinders::new(1e9, 0.3, soft, 0.1, 1.0).unwrap_err();
    assert_eq!(error.quantity, "relaxation ratio");
    assert!(polymer(1e-3).pressed(f64::NAN).is_err());
    assert!(polymer(1e-3).creepage(LOAD, 0.3, LOAD).is_err());
}
