//! Rigid slip from place to place: what is creepage and spin in other words, contacts solved in two ways, rolling
//! that becomes steady.

#![allow(clippy::unwrap_used, clippy::panic)]

use creepage::coulomb::Resolution;
use creepage::gap::{Gap, Term};
use creepage::normal::{self, NormalContact};
use creepage::unsteady::{Motion, Rolling, RollingFastsim, RollingVariational};
use creepage::{
    AddedSlip, Contact, Creepage, Ellipse, Force, Hertz, Solid, SolidPair, Theory, TheorySpec,
};

/// Semi-axes (m), load (N) and friction.
const AXES: [f64; 2] = [6e-3, 4e-3];
const LOAD: f64 = 80e3;
const FRICTION: f64 = 0.3;

fn pair() -> SolidPair {
    let steel = Solid::new(82e9, 0.28).unwrap();
    SolidPair::new(steel, steel)
}

fn ellipse() -> Contact {
    let [a, b] = AXES;
    let hertz = Hertz::from_ellipse(pair(), Ellipse::new(a, b).unwrap(), LOAD).unwrap();
    hertz.with_friction(FRICTION).unwrap()
}

/// The same contact pressed as bodies of any shape: those paraboloids whose ellipse it is.
fn areas() -> Contact {
    let radii = Hertz::from_ellipse(pair(), Ellipse::new(AXES[0], AXES[1]).unwrap(), LOAD).unwrap();
    let [along, across] = radii.relative_curvatures();
    let term = |x, y, coefficient| Term { x, y, coefficient };
    let gap = Gap::polynomial(&[term(2, 0, along), term(0, 2, across)]).unwrap();
    let pressed = NormalContact::under_load(&gap, pair(), LOAD, normal::Resolution::FINE).unwrap();
    Contact::of_areas(pressed, FRICTION).unwrap()
}

/// The slip of a function of place (in units of `c`) in units of the contact, on a fine grid.
fn added(contact: &Contact, slip: impl Fn(f64, f64) -> [f64; 2]) -> AddedSlip {
    let scaling = contact.scaling();
    let mut points = Vec::new();
    for i in -40..=40 {
        for j in -40..=40 {
            let (x, y) = (f64::from(i) * 0.05, f64::from(j) * 0.05);
            let [along, across] = slip(x, y).map(|slip| slip * scaling.slip);
            points.push([x * scaling.length, y * scaling.length, along, across]);
        }
    }
    AddedSlip::new(&points).unwrap()
}

fn exact(contact: &Contact) -> Box<dyn Theory> {
    TheorySpec::named("exact").unwrap().prepare(contact).unwrap()
}

fn apart(one: Force, other: Force) -> f64 {
    let pairs = one.components().into_iter().zip(other.components());
    pairs.map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

/// A slip that is the same everywhere is a creepage, one that turns is a spin; both on an ellipse and on areas.
#[test]
fn creepage_and_spin_in_other_words_are_the_same() {
    let creepage = Creepage::new(0.4, -0.3, 0.5).unwrap();
    for contact in [ellipse(), areas()] {
        let plain = exact(&contact);
        let whole = plain.solved(creepage);
        let error = whole.solution().error.unwrap();
        let slip = added(&contact, |_, _| [0.3, -0.5]);
        let shifted = exact(&contact.clone().with_added_slip(slip));
        let rest = Creepage::new(0.1, 0.2, 0.5).unwrap();
        let found = shifted.solved(rest);
        // Both are solved to some 5e-8 of a traction bound.
        assert!(apart(found.solution().force, whole.solution().force) < 1e-6);
        let power = [&found, &whole].map(|solved| solved.power());
        assert!((power[0] - power[1]).abs() < 1e-6, "{power:?}");
        let dissipated = [&found, &whole].map(|solved| solved.dissipation().unwrap());
        assert!((dissipated[0] - dissipated[1]).abs() < 1e-6, "{dissipated:?}");

        let slip = added(&contact, |x, y| [-0.5 * y, 0.5 * x]);
        let turning = exact(&contact.clone().with_added_slip(slip));
        let found = turning.solved(Creepage::new(0.4, -0.3, 0.0).unwrap()).solution();
        // Corners are rounded by the spin that is named as such: within the error bars.
        let pairs = found.force.components().into_iter().zip(whole.solution().force.components());
        for ((found, expected), bar) in pairs.zip(error.components()) {
            assert!((found - expected).abs() < 2.0 * bar, "{found} {expected} {bar}");
        }
    }
}

/// A slip that no creepage has: that of a groove, and one that goes to and fro along the contact.
fn uneven(x: f64, y: f64) -> [f64; 2] {
    [0.8 * y * y - 0.2, 0.4 * (2.0 * x).sin()]
}

/// The ellipse by its own elements and as an area of any shape by other ones: within both error bars. What friction
/// turns to heat is the power.
#[test]
fn an_ellipse_is_an_area_of_any_shape() {
    let (units, slip) = (ellipse().scaling(), added(&ellipse(), uneven));
    let creepage = Creepage::new(0.2, 0.1, 0.3).unwrap();
    // In the units of the ellipse: forces over mu N, moments over mu N c.
    let [one, other] = [ellipse(), areas()].map(|contact| {
        let own = contact.scaling();
        let theory = exact(&contact.with_added_slip(slip.clone()));
        let solved = theory.solved(own.creepage(units.si_creepage(creepage)).unwrap());
        let (power, heat) = (solved.power(), solved.dissipation().unwrap());
        assert!(power > 0.0 && (power - heat).abs() < 0.02 * heat, "{power} {heat}");
        [solved.solution().force, solved.solution().error.unwrap()].map(|force| {
            let [fx, fy, mz] = force.components();
            [fx, fy, mz * own.length / units.length]
        })
    });
    for k in 0..3 {
        let ([one, bar], [other, own]) = ([one[0][k], one[1][k]], [other[0][k], other[1][k]]);
        // Two thousandths of mu N besides: the pressure of the areas is found to that.
        assert!((one - other).abs() < bar + own + 2e-3, "{one} {other}");
    }
    let plain = exact(&ellipse()).solve(creepage).force;
    assert!((one[0][0] - plain.fx).abs() > 0.02, "the slip does something");
}

/// It rolls on until it is steady, on an ellipse and on areas; a uniform slip is a creepage at every step.
#[test]
fn rolling_with_it_becomes_steady() {
    let creepage = Creepage::new(0.2, 0.1, 0.3).unwrap();
    let motion = Motion::from(creepage);
    let contact = ellipse();
    let slip = added(&contact, uneven);
    let slipping = contact.clone().with_added_slip(slip.clone());
    let mut rolling = Rolling::new(&slipping, Resolution::FAST).unwrap();
    let steady = exact(&slipping).solve(creepage).force;
    let last = rolling.step(12.0, &motion).unwrap().solution;
    let error = last.error.unwrap();
    let bar = error.fx.max(error.fy).max(error.mz);
    assert!(apart(last.force, steady) < bar + 2e-3, "{:?} {steady:?}", last.force);
    let mut from_steady = Rolling::new(&slipping, Resolution::FAST).unwrap();
    let begun = from_steady.start_steady(&motion).unwrap().solution.force;
    assert!(apart(begun, steady) < bar + 2e-3, "{begun:?} {steady:?}");

    let uniform = contact.clone().with_added_slip(added(&contact, |_, _| [0.3, -0.1]));
    let mut one = Rolling::new(&uniform, Resolution::FAST).unwrap();
    let mut other = Rolling::new(&contact, Resolution::FAST).unwrap();
    let whole = Motion::from(Creepage::new(0.5, 0.0, 0.3).unwrap());
    for _ in 0..4 {
        // The same steps: those that step control would choose depend on the motion alone.
        let [one, other] = [(&mut one, &motion), (&mut other, &whole)]
            .map(|(rolling, motion)| rolling.advance(0.3, motion).unwrap().solution.force);
        assert!(apart(one, other) < 1e-6, "{one:?} {other:?}");
    }
}

/// The slip of a contact that grows stands where it is, in metres.
#[test]
fn under_another_load_it_stays_where_it_is() {
    let contact = ellipse();
    let slip = added(&contact, uneven);
    let creepage = Creepage::new(0.2, 0.1, 0.3).unwrap();
    let mut rolling =
        Rolling::new(&contact.with_added_slip(slip.clone()), Resolution::FAST).unwrap();
    let motion = Motion::from(creepage);
    rolling.press(1.728).unwrap();
    rolling.step(1.0, &motion).unwrap();
    let grown = rolling.step(13.0, &motion).unwrap().solution.force;
    let [a, b] = AXES.map(|axis| 1.2 * axis);
    let larger = Hertz::from_ellipse(pair(), Ellipse::new(a, b).unwrap(), 1.728 * LOAD).unwrap();
    let larger = larger.with_friction(FRICTION).unwrap().with_added_slip(slip);
    let (nominal, units) = (ellipse().scaling(), larger.scaling());
    let same = units.creepage(nominal.si_creepage(creepage)).unwrap();
    let found = exact(&larger).solve(same).force;
    // Forces over mu N of the larger load, moments over that times its length too.
    let [fx, fy] = [grown.fx, grown.fy].map(|force| force / 1.728);
    assert!((fx - found.fx).abs() < 4e-3 && (fy - found.fy).abs() < 4e-3, "{grown:?} {found:?}");
}

#[test]
fn theories_of_one_creepage_refuse_it() {
    for contact in [ellipse(), areas()] {
        let slipping = contact.clone().with_added_slip(added(&contact, uneven));
        for spec in TheorySpec::all() {
            let name = spec.facts().name;
            let plain = spec.prepare(&contact).is_ok();
            match spec.prepare(&slipping) {
                Ok(_) => assert_eq!(name, "exact"),
                Err(error) => {
                    let told = error.to_string();
                    assert!(!plain || told.contains("exact, without coupling"), "{name}: {told}");
                }
            }
        }
    }
    let contact = ellipse();
    let slipping = contact.clone().with_added_slip(added(&contact, uneven));
    assert!(
        RollingFastsim::new(&slipping, creepage::approximate::fastsim::Settings::default())
            .is_err()
    );
    assert!(
        RollingVariational::new(&slipping, creepage::variational::Settings::default()).is_err()
    );
}
