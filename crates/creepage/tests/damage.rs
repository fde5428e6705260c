//! Wear and fatigue numbers: continuity, identities, limits.
// Tests may fail by unwrapping.
#![allow(clippy::float_cmp, clippy::unwrap_used)]

use creepage::coulomb::{Exact, Resolution};
use creepage::damage::{
    Archard, Bre, DamageConstants, DangVan, Ekberg, ElementState, Passage, ShakedownBlock, TGamma,
    Usfd, WearZone, Wlrm, local_surface_index, shakedown, shakedown_and_fatigue, surface_index,
};
use creepage::subsurface::{Body, Interior, Stress};
use creepage::{Contact, Creepage, Scaling, SiCreepage, SiForce, Solved};
use creepage::{Ellipse, Hertz, Solid, SolidPair};
use proptest::prelude::*;

fn contact(a: f64, b: f64, load: f64) -> (Hertz, Solid) {
    let steel = Solid::new(82e9, 0.3).unwrap();
    let ellipse = Ellipse::new(a, b).unwrap();
    (Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, load).unwrap(), steel)
}

/// A circle of radius one under the peak pressure one.
fn circle(friction: f64) -> Interior {
    let solid = Solid::new(1.0, 0.3).unwrap();
    let ellipse = Ellipse::new(1.0, 1.0).unwrap();
    let pair = SolidPair::new(solid, solid);
    let contact = Hertz::from_ellipse(pair, ellipse, 2.0 / 3.0 * ellipse.area()).unwrap();
    Interior::sliding(&contact, [friction, 0.0], solid, Body::Lower).unwrap()
}

proptest! {
    /// Steps of a millionth change a law by no more than its steepest slope allows.
    #[test]
    fn piecewise_laws_are_continuous(t_gamma in 0.0..400.0_f64, joint in 0..6_usize) {
        let joints = [t_gamma, 10.4, 10.377_358_490_566_04, 77.2, 0.0, 100.0];
        let (index, step) = (joints[joint] * 1e6, 1.0);
        let wear = Usfd::default();
        let change = wear.rate(index + step) - wear.rate(index - step);
        prop_assert!((0.0..=2.0 * 61.9e-9 * step * 1.01).contains(&change));

        let at = [t_gamma, 15.0, 65.0, 175.0, 0.0, 100.0][joint];
        let damage = Wlrm::default();
        let change = damage.damage(at + 1e-6) - damage.damage(at - 1e-6);
        prop_assert!(change.abs() <= 1e-5 * 2e-6 / 50.0 * 1.01);
        for force in [-1.0, 1.0] {
            let change = damage.directed_damage(at + 1e-6, force) - damage.directed_damage(at - 1e-6, force);
            prop_assert!(change.abs() <= 1e-5 * 2e-6 / 50.0 * 1.01);
        }

        // As published this one jumps at 200 N, and only there.
        let at = [t_gamma, 100.0, 0.0, 99.0, 101.0, 300.0][joint];
        prop_assume!((at - 200.0).abs() > 1e-5);
        let bre = Bre::default();
        let change = bre.area_rate(at + 1e-6, 1.0) - bre.area_rate(at - 1e-6, 1.0);
        prop_assert!((0.0..=1.19e-12 * 2e-6 * 1.01).contains(&change));
    }

    /// Archard's wear is proportional to pressure and slip within a zone, and adds up along a row.
    #[test]
    fn archard_adds_up(
        pressure in 1e6..2e9_f64, slip in 1e-5..1e-2_f64, speed in 1.0..50.0_f64, length in 1e-4..1e-3_f64,
    ) {
        let map = Archard::default();
        let element = ElementState {
            pressure, traction: [0.3 * pressure, 0.0], slip: [slip, 0.0], area: length * 1e-3, length,
        };
        let one = map.wear(&[element], speed);
        let halves = [ElementState { length: 0.5 * length, ..element }; 2];
        let two = map.wear(&halves, speed);
        prop_assert!((one.depth / two.depth - 1.0).abs() < 1e-14 && one.zone == two.zone);
        let expected = map.coefficient(one.zone) * pressure * slip * length / 3e9;
        prop_assert!((one.depth / expected - 1.0).abs() < 1e-14);
        prop_assert_eq!(one.zone, map.zone(pressure, slip * speed));
    }

    /// `k/p0 = 2 pi a b k/(3 N)`, and in full sliding the local index is the global one.
    #[test]
    fn the_surface_index_of_an_ellipse(
        a in 1e-3..1e-2_f64, b in 1e-3..1e-2_f64, load in 1e4..2e5_f64, mu in 0.05..0.6_f64,
    ) {
        let (contact, _) = contact(a, b, load);
        let k = 300e6;
        let found = surface_index(mu * load, load, contact.peak_pressure(), k);
        let expected = mu - 2.0 * std::f64::consts::PI * a * b * k / (3.0 * load);
        prop_assert!((found - expected).abs() < 1e-13);
        let element = |share: f64| {
            let pressure = share * contact.peak_pressure();
            ElementState { pressure, traction: [0.0, -mu * pressure], ..ElementState::default() }
        };
        let elements: Vec<_> = (0..=10).map(|i| element(f64::from(i) / 10.0)).collect();
        let local = local_surface_index(&elements, k).unwrap();
        prop_assert!((local - found).abs() < 1e-13);
    }
}

#[test]
fn published_points() {
    let wear = Usfd::default();
    for (index, rate) in [(5.0, 26.5), (30.0, 55.0), (77.2, 55.0), (100.0, 61.9 * 100.0 - 4723.68)]
    {
        assert!((wear.rate(index * 1e6) - rate * 1e-3).abs() < 1e-12, "{index}");
    }
    let bre = Bre::default();
    assert!((bre.area_rate(200.0, 1.0) - 84e-12).abs() < 1e-24);
    assert!((bre.area_rate(199.999, 1.0) - 25e-12).abs() < 1e-24);
    let cracks = Wlrm::default();
    for (t_gamma, damage) in [(15.0, 0.0), (40.0, 0.5), (65.0, 1.0), (120.0, 0.5), (285.0, -1.0)] {
        assert!((cracks.damage(t_gamma) - damage * 1e-5).abs() < 1e-20, "{t_gamma}");
    }
    assert_eq!(cracks.directed_damage(65.0, 1e3), 0.0);
    assert_eq!(cracks.directed_damage(65.0, -1e3), 1e-5);
    assert_eq!(Archard::default().zone(2.5e9, 0.1), WearZone::Seizure);
    let wheel = Ekberg::default().index(100e3, 0.3, [6e-3, 6e-3]);
    assert!((wheel - (100e3 * 1.09 / (4.0 * std::f64::consts::PI * 36e-6) - 186e6)).abs() < 1.0);
    assert_eq!(DamageConstants::default().density, 7850.0);
}

/// T gamma of a solution is the frictional power per metre, from forces and from elements.
#[test]
fn t_gamma_is_the_frictional_power_per_metre() {
    let (contact, _) = contact(6e-3, 5e-3, 80e3);
    let scaling = Scaling::new(&contact, 0.3).unwrap();
    let shape = Contact::new(Ellipse::from_ratio(1.2).unwrap(), 0.3).unwrap();
    let theory = Exact::new(&shape, Resolution::FINE).unwrap();
    for (xi, eta, chi) in [(1.5, 0.0, 0.0), (0.9, 0.8, 0.0), (1.0, 1.5, 1.0), (0.2, 2.0, 1.5)] {
        let creepage = Creepage::new(xi, eta, chi).unwrap();
        let solved = theory.solve_contact(creepage);
        let solution = solved.solution();
        let (force, si) = (scaling.si_force(solution.force), scaling.si_creepage(creepage));
        let work = TGamma::new(force, si);
        let power = scaling.power_per_metre(solution.force, creepage);
        assert!((TGamma::power_per_metre(force, si) / power - 1.0).abs() < 1e-13);
        // Every force has the sense of its creepage here.
        assert!((work.with_spin / power - 1.0).abs() < 1e-13, "{force:?} {si:?}");
        let c = scaling.length;
        let elements: Vec<_> = solved
            .elements()
            .iter()
            .map(|element| {
                let [p, q, r, s] = element.corners;
                let cross = (r[0] - p[0]) * (s[1] - q[1]) - (s[0] - q[0]) * (r[1] - p[1]);
                ElementState {
                    pressure: element.bound * contact.peak_pressure(),
                    traction: element.point.traction.map(|part| part * scaling.traction),
                    slip: element.point.slip.map(|part| part * scaling.slip),
                    area: 0.5 * cross.abs() * c * c,
                    length: c * (p[0] - s[0]).abs(),
                }
            })
            .collect();
        let sum = ElementState::power_per_metre(&elements);
        // One traction and one slip an element, and slip areas narrower than these.
        assert!((sum / power - 1.0).abs() < 0.03, "{xi} {eta} {chi}: {sum} {power}");
        assert!(elements.iter().all(|element| element.work() >= -1e-9 * scaling.traction));
    }
}

#[test]
fn signs_do_not_matter_to_t_gamma() {
    let force = SiForce { longitudinal: 3.0, lateral: -4.0, moment: 0.5 };
    let creepage = SiCreepage { longitudinal: -0.1, lateral: 0.2, spin: 2.0 };
    let work = TGamma::new(force, creepage);
    assert!((work.without_spin - 1.1).abs() < 1e-15 && (work.with_spin - 2.1).abs() < 1e-15);
    assert!((TGamma::power_per_metre(force, creepage) + 0.1).abs() < 1e-15);
}

/// Without friction a circle shakes down to 4.63 times the shear yield stress. The largest orthogonal
/// shear stress, .214 of the peak pressure, cannot be helped, so that 4.67 is out of reach; but all else
/// nearly can.
#[test]
fn the_shakedown_limit_of_a_circle() {
    let block = ShakedownBlock { lines: 3, depths: 21, ..ShakedownBlock::of([1.0; 2]) };
    let interior = circle(0.0);
    let limit = shakedown(&interior, &block).unwrap();
    let passage = Passage::below(&interior, 1.0, limit.place, 61).unwrap();
    let shear = passage.states().iter().fold(0.0_f64, |most, state| most.max(state.xz.abs()));
    let factor = limit.load_factor(1.0);
    assert!(factor <= 1.0 / shear + 1e-9);
    assert!(factor >= 0.98 / shear, "{factor} {shear} {limit:?}");
    // The fineness of depths and states.
    assert!((factor - 4.63).abs() < 0.02, "{factor} {limit:?}");
}

/// With much friction it is the surface that governs, at most at `p0/k = 1/mu`.
#[test]
fn friction_brings_the_limit_to_the_surface() {
    let block = ShakedownBlock { lines: 3, ..ShakedownBlock::of([1.0; 2]) };
    let factors = [0.0, 0.2, 0.4, 0.6, 0.8].map(|mu| {
        let limit = shakedown(&circle(mu), &block).unwrap();
        if mu > 0.0 {
            assert!(limit.load_factor(1.0) <= 1.0 / mu + 1e-9, "{mu} {limit:?}");
        }
        if mu > 0.5 {
            assert_eq!(limit.place[1], 0.0, "{mu} {limit:?}");
        }
        limit.load_factor(1.0)
    });
    assert!(factors.windows(2).all(|pair| pair[1] < pair[0]), "{factors:?}");
}

/// The residual stress that is reported does what it should: with it, no state exceeds the amplitude.
#[test]
fn the_residual_stress_is_as_good_as_said() {
    let (mu, block) = (0.3, ShakedownBlock { lines: 2, ..ShakedownBlock::of([1.0; 2]) });
    let interior = circle(mu);
    let limit = shakedown(&interior, &block).unwrap();
    let [xx, yy, xy] = limit.residual;
    let residual = Stress { xx, yy, xy, ..Stress::default() };
    let passage = Passage::below(&interior, 1.0, limit.place, block.states).unwrap();
    let most = passage.states().iter().map(|state| state.plus(1.0, &residual).von_mises());
    let most = most.reduce(f64::max).unwrap();
    assert!((most / limit.amplitude - 1.0).abs() < 1e-9, "{most} {limit:?}");
    // It helps: without it the first yield governs.
    let bare = passage.states().iter().map(Stress::von_mises).reduce(f64::max).unwrap();
    assert!(bare > limit.amplitude);
}

/// Dang Van: a constant deviator is no load, an alternating shear counts in full, a mean stress by its
/// weight; and the residual stress of a constant state changes nothing but the mean.
#[test]
fn dang_van_of_simple_passages() {
    let criterion = DangVan { mean_weight: 0.4, ..DangVan::default() };
    let shear = |size: f64| Stress { xz: size, ..Stress::default() };
    let steady = Passage::new(vec![shear(3.0), shear(3.0)]);
    assert!(criterion.equivalent(&steady).abs() < 1e-12);
    let turning = Passage::new(vec![shear(3.0), shear(-1.0)]);
    assert!((criterion.equivalent(&turning) - 2.0).abs() < 1e-12);
    let mean = Stress { xx: 1.0, yy: 1.0, zz: 1.0, ..Stress::default() };
    let both = Passage::new(vec![shear(3.0).plus(1.0, &mean), shear(-1.0).plus(1.0, &mean)]);
    assert!((criterion.equivalent(&both) - 2.4).abs() < 1e-12);
    assert_eq!(criterion.equivalent(&Passage::new(vec![])), 0.0);
}

#[test]
fn nonsense_is_an_error() {
    let interior = circle(0.1);
    assert_eq!(Passage::below(&interior, 0.0, [0.0; 2], 9).unwrap_err().quantity, "half_length");
    assert_eq!(Passage::below(&interior, 1.0, [0.0; 2], 2).unwrap_err().quantity, "count");
    let block = ShakedownBlock { depths: 0, ..ShakedownBlock::of([1.0; 2]) };
    assert_eq!(shakedown(&interior, &block).unwrap_err().quantity, "depths");
}

/// In a block fatigue is where the criterion says most of all places, and friction, whose stresses swing from pressure to
/// tension, brings it to the surface.
#[test]
fn dang_van_under_a_circle() {
    let block = ShakedownBlock { lines: 2, ..ShakedownBlock::of([1.0; 2]) };
    let criterion = DangVan::default();
    let used = [0.0, 0.3, 0.6].map(|mu| {
        let interior = circle(mu);
        let (limit, used) = shakedown_and_fatigue(&interior, &block, &criterion).unwrap();
        let at = |place| {
            criterion.equivalent(&Passage::below(&interior, 1.0, place, block.states).unwrap())
        };
        assert!((at(used.place) / used.equivalent - 1.0).abs() < 1e-12, "{mu} {used:?}");
        assert!(at(limit.place) <= used.equivalent + 1e-12, "{mu} {used:?}");
        used
    });
    assert!(used[0].place[1] > 0.0 && used[2].place[1] == 0.0, "{used:?}");
    assert!(used[0].equivalent < used[1].equivalent && used[1].equivalent < used[2].equivalent);
}
