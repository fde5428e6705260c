//! Contacts found from those of a position close by.

use creepage::gap::{Gap, Rolling};
use creepage::normal::{Estimate, Method, NormalContact, Resolution};

use crate::support::{MM, function, steel};

/// Two bumps of radius 0.3 m, 12 mm apart, the second one higher by `more` (m): `h` is the lower.
fn bumps(more: f64) -> Gap {
    let y: Vec<f64> = (-240..=240).map(|i| f64::from(i) * 0.05 * MM).collect();
    let bump = |y: f64, at: f64| (y - at).powi(2) / 0.6;
    let h: Vec<f64> =
        y.iter().map(|y| bump(*y, -6.0 * MM).min(bump(*y, 6.0 * MM) + more)).collect();
    Gap::section(&y, &h, Rolling::Radius(0.46)).unwrap()
}

/// The road does not matter beyond the error bars, and a second area that appears is not lost.
#[test]
fn a_neighbour_leads_to_the_same_contact() {
    let resolution = Resolution::STANDARD;
    let at = |gap: &Gap, approach| NormalContact::at_approach(gap, steel(), approach, resolution);
    let mut known = at(&bumps(15e-6), 14e-6).unwrap();
    assert_eq!(known.patches().len(), 1);
    for approach in [15e-6, 20e-6, 30e-6, 31e-6] {
        let gap = bumps(15e-6);
        known = known.next(&gap, approach, resolution).unwrap();
        let alone = at(&gap, approach).unwrap();
        let (load, cold) = (known.load(), alone.load());
        let apart = (load.value - cold.value).abs();
        assert!(apart < load.error + cold.error, "{approach}: {load:?} {cold:?}");
        assert_eq!(known.patches().len(), alone.patches().len(), "{approach}");
    }
    assert_eq!(known.patches().len(), 2);
}

/// Two smooth bumps, 12 mm apart, with a saddle between that lies 30 micrometres deeper.
fn saddle() -> Gap {
    let y: Vec<f64> = (-240..=240).map(|i| f64::from(i) * 0.05 * MM).collect();
    let h: Vec<f64> = y.iter().map(|y| 30e-6 * ((y / (6.0 * MM)).powi(2) - 1.0).powi(2)).collect();
    Gap::section(&y, &h, Rolling::Radius(0.46)).unwrap()
}

/// Two areas become one as the bodies come nearer, and one becomes two as they part: strips go through
/// it, from a contact close by and from nothing, and carry the same.
#[test]
fn areas_join_and_part() {
    let (gap, resolution) = (saddle(), Resolution::STANDARD);
    let at = |approach| NormalContact::at_approach(&gap, steel(), approach, resolution).unwrap();
    let way = |from: f64, to: f64| (1..=30).map(move |i| from + (to - from) * f64::from(i) / 30.0);
    for ([from, to], areas) in [([30e-6, 70e-6], [2, 1]), ([70e-6, 30e-6], [1, 2])] {
        let mut known = at(from);
        let mut patches = vec![known.patches().len()];
        for approach in way(from, to) {
            known = known.next(&gap, approach, resolution).unwrap();
            let alone = at(approach);
            let (load, cold) = (known.load(), alone.load());
            let apart = (load.value - cold.value).abs();
            assert!(apart < load.error + cold.error, "{approach}: {load:?} {cold:?}");
            assert_eq!([known.method(), alone.method()], [Method::Strips; 2], "{approach}");
            patches.push(known.patches().len());
        }
        patches.dedup();
        assert_eq!(patches, areas);
    }
}

/// A contact that follows another is the one found by itself, within the bars it takes over; it says so where
/// the load is another, however small the steps to there, and there is none where the bodies meet beyond the
/// areas.
#[test]
fn a_contact_follows_where_no_other_area_appears() {
    let (gap, resolution) = (bumps(15e-6), Resolution::STANDARD);
    let at = |approach| NormalContact::at_approach(&gap, steel(), approach, resolution).unwrap();
    let known = at(14e-6);
    for approach in [13.9e-6, 14.1e-6, 14.2e-6] {
        let followed = known.follow(&gap, approach).unwrap();
        assert!(followed.keeps_error_bars(), "{approach}");
        let (load, alone) = (followed.load(), at(approach).load());
        assert!((load.value - alone.value).abs() < load.error, "{approach}: {load:?} {alone:?}");
        let part = |load: Estimate| load.error / load.value;
        // A load by 2 % another has a bar that is 4 % another part of it.
        assert!((part(load) / part(alone) - 1.0).abs() < 0.06, "{approach}: {load:?} {alone:?}");
        let stiffness = followed.stiffness() / at(approach).stiffness();
        // What a search needs.
        assert!((stiffness - 1.0).abs() < 0.05, "{approach}: {stiffness}");
    }
    let steps = known.follow(&gap, 14.2e-6).and_then(|step| step.follow(&gap, 14.4e-6)).unwrap();
    assert!(!steps.keeps_error_bars());
    // From there they are found anew.
    assert!(steps.next(&gap, 14.4e-6, resolution).unwrap().keeps_error_bars());
    assert_eq!(known.follow(&gap, 25e-6), None);
}

/// A coarse contact carries the load to a percent.
#[test]
fn a_coarse_contact_is_near() {
    for more in [0.0, 4e-6, 40e-6] {
        let gap = bumps(more);
        let [coarse, fine] = [Resolution::COARSE, Resolution::FINE]
            .map(|resolution| NormalContact::at_approach(&gap, steel(), 30e-6, resolution));
        let [coarse, fine] = [coarse.unwrap(), fine.unwrap()].map(|contact| contact.load().value);
        assert!((coarse / fine - 1.0).abs() < 0.01, "{more}: {coarse} {fine}");
    }
}

/// The lower of two bumps, which lies elsewhere by `by` (m).
fn bump_moved(by: f64) -> Gap {
    let y: Vec<f64> = (-240..=240).map(|i| f64::from(i) * 0.05 * MM).collect();
    let h: Vec<f64> = y.iter().map(|y| (y - by).powi(2) / 0.6).collect();
    Gap::section(&y, &h, Rolling::Radius(0.46)).unwrap()
}

/// Where a contact moves on as on the last step, its area is foreseen, and the contact found from there.
#[test]
fn a_contact_drifts() {
    let (approach, resolution, step) = (14e-6, Resolution::STANDARD, 0.3 * MM);
    let at = |steps: f64| {
        let gap = bump_moved(steps * step);
        NormalContact::at_approach(&gap, steel(), approach, resolution).unwrap()
    };
    let [first, second, third] = [0.0, 1.0, 2.0].map(at);
    let beyond = second.sides_beyond(&first).unwrap();
    let [[low, high]] = beyond[..] else { panic!("{beyond:?}") };
    let foreseen = second.with_sides_moved(&beyond, 1.0);
    let side = |contact: &NormalContact, k: usize| contact.patches()[0].bands()[0].y()[k];
    // To where strips lay their tips: .4 of the width of one.
    let enough = 0.02 * (side(&first, 1) - side(&first, 0));
    assert!((low + step).abs() < enough && (high - step).abs() < enough, "{beyond:?}");
    assert!([0, 1].iter().all(|k| (side(&foreseen, *k) - side(&third, *k)).abs() < enough));
    let followed = foreseen.follow(&bump_moved(2.0 * step), approach).unwrap();
    let apart = followed.load().value - third.load().value;
    assert!(apart.abs() < third.load().error, "{apart}");
}

/// Waves along rolling, too short for strips, on a ball of radius 0.3 m.
fn waves() -> Gap {
    function([-8.0, 8.0], [-8.0, 8.0], |x, y| (x * x + y * y) / 600.0 + 1e-3 * (2.5 * x).sin())
}

/// Elements that follow keep their lattice, so that loads change by the stiffness. Over such steps pressures that are
/// solved to 1e-6 of the depth tell the change to 1e-3, and cells that come into contact change the stiffness by as
/// much; from one lattice to another a load jumps by a thousandth, a quarter of its change here. Followed loads are
/// those found alone, within the bars.
#[test]
fn elements_follow_on_their_lattice() {
    const STEP: f64 = 5e-8;
    let (gap, resolution) = (waves(), Resolution::FAST);
    let at = |approach| NormalContact::at_approach(&gap, steel(), approach, resolution).unwrap();
    let mut known = at(20e-6);
    assert_eq!(known.method(), Method::Elements);
    for step in 1..=5 {
        let approach = 20e-6 + STEP * f64::from(step);
        let followed = known.follow(&gap, approach).unwrap();
        let rise = followed.load().value - known.load().value;
        let stiffness = followed.stiffness().midpoint(known.stiffness());
        assert!((rise / (stiffness * STEP) - 1.0).abs() < 5e-3, "{step}: {rise} {stiffness}");
        let (load, alone) = (followed.load(), at(approach).load());
        let apart = (load.value - alone.value).abs();
        assert!(apart < load.error + alone.error, "{step}: {load:?} {alone:?}");
        assert!(followed.keeps_error_bars());
        known = followed;
    }
    // Beyond the lattice it does not follow, and where the load is another it says so.
    assert_eq!(known.follow(&gap, 60e-6), None);
    assert!(known.follow(&gap, 21e-6).is_none_or(|other| !other.keeps_error_bars()));
    // Nor where the bodies touch beside it alone, as where a wheel has gone over to its flange.
    let away = function([-8.0, 22.0], [-8.0, 8.0], |x, y| ((x - 15.0).powi(2) + y * y) / 600.0);
    assert_eq!(known.follow(&away, 20e-6), None);
}
