//! Friction that falls with the speed of slip, follows it with a delay, or differs across the contact.

use creepage::approximate::fastsim::{Fastsim, Settings};
use creepage::coulomb::{Exact, Resolution};
use creepage::friction_law::{
    FrictionAcross, FrictionLaw, FrictionMemory, RollingFriction, Shape, Term,
};
use creepage::unsteady::{Motion, Rolling, RollingFastsim, Saved};
use creepage::{
    Contact, Creepage, Ellipse, Hertz, Layer, SiCreepage, Solid, SolidPair, Status, Theory,
};

use crate::support::coarse;

/// Steel on a circle of 5 mm at a peak pressure of 1.025e9 Pa.
fn hertz() -> Hertz {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let ellipse = Ellipse::new(5e-3, 5e-3).unwrap();
    Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 53_668.874_5).unwrap()
}

/// Distance (m) and speed (m/s).
const MEMORY: Option<[f64; 2]> = Some([2e-5, 1e-3]);

fn law(shape: Shape, half_speed: f64) -> FrictionLaw {
    FrictionLaw::new(shape, 0.18, &[Term { drop: 0.12, half_speed }]).unwrap()
}

fn falling(shape: Shape, memory: Option<[f64; 2]>) -> Contact {
    let memory = memory.map(|[d, s]| FrictionMemory::new(d, s).unwrap());
    let friction = RollingFriction::new(law(shape, 0.1), memory, 30.0).unwrap();
    hertz().with_friction_law(friction).unwrap()
}

fn across() -> Contact {
    let friction = FrictionAcross::new(&[[-4e-3, 0.3], [0.0, 0.25], [4e-3, 0.1]]).unwrap();
    hertz().with_friction_law(RollingFriction::across(friction).unwrap()).unwrap()
}

fn creepage(contact: &Contact, longitudinal: f64, spin: f64) -> Creepage {
    let si = SiCreepage { longitudinal, lateral: 0.0, spin };
    contact.scaling().creepage(si).unwrap()
}

fn motion(contact: &Contact, longitudinal: f64, spin: f64) -> Motion {
    Motion::from(creepage(contact, longitudinal, spin))
}

/// Contacts, with creepage along and spin (rad/m).
fn cases() -> [(Contact, [f64; 2]); 4] {
    [
        (falling(Shape::Exponential, MEMORY), [0.002, 0.0]),
        (falling(Shape::Rational, MEMORY), [0.001, 0.3]),
        (falling(Shape::Linear, Some([2e-6, 1e-3])), [0.0015, -0.2]),
        (across(), [0.0015, 0.2]),
    ]
}

/// After three contact lengths the start is forgotten, and the grids differ within their error bars.
#[test]
fn rolling_on_ends_at_steady_rolling() {
    for (contact, [longitudinal, spin]) in cases() {
        let creepage = creepage(&contact, longitudinal, spin);
        let steady = Exact::new(&contact, Resolution::FAST).unwrap().solve(creepage);
        let mut rolling = Rolling::new(&contact, Resolution::FAST).unwrap();
        let end = rolling.step(6.0, &Motion::from(creepage)).unwrap().solution;
        assert_eq!(end.status, Status::Solved);
        let bars = [end, steady].map(|solution| solution.error.unwrap().components());
        let forces = [end, steady].map(|solution| solution.force.components());
        for k in 0..3 {
            let apart = (forces[0][k] - forces[1][k]).abs();
            assert!(apart < bars[0][k] + bars[1][k], "{forces:?} {bars:?}");
        }
    }
}

/// FASTSIM's cells see the same slip at the end, and friction by it.
#[test]
fn fastsim_ends_at_its_steady_force() {
    for (contact, [longitudinal, spin]) in cases() {
        let creepage = creepage(&contact, longitudinal, spin);
        let settings = Settings { grid: [30, 30], ..Settings::default() };
        let steady = Fastsim::new(&contact, settings).unwrap().solve(creepage).force;
        let mut rolling = RollingFastsim::new(&contact, settings).unwrap();
        let end = rolling.step(4.0, &Motion::from(creepage)).unwrap().solution.force;
        for (end, steady) in end.components().iter().zip(steady.components()) {
            // Equal cells here, cells for a quadrature there: 30 of them err by half a per cent.
            assert!((end - steady).abs() < 5e-3, "{end} {steady}");
        }
    }
}

/// A law without drops is Coulomb's to the last bit.
#[test]
fn constant_friction_is_recovered() {
    let never = FrictionLaw::new(Shape::Rational, 0.3, &[Term { drop: 0.0, half_speed: 0.1 }]);
    let friction = RollingFriction::new(never.unwrap(), None, 30.0).unwrap();
    let contacts =
        [hertz().with_friction_law(friction).unwrap(), hertz().with_friction(0.3).unwrap()];
    let forces = contacts.map(|contact| {
        let motion = motion(&contact, 0.001, 0.2);
        let mut rolling = Rolling::new(&contact, coarse()).unwrap();
        let mut fastsim = RollingFastsim::new(&contact, Settings::default()).unwrap();
        [rolling.step(0.7, &motion).unwrap(), fastsim.step(0.7, &motion).unwrap()]
            .map(|rolled| rolled.solution.force)
    });
    assert_eq!(forces[0], forces[1]);
}

/// While friction is that at rest, for nothing has slipped yet, all begin alike; later friction that
/// forgets sooner has fallen further.
#[test]
fn friction_falls_as_slip_goes_on() {
    let constant = hertz().with_friction(0.3).unwrap();
    let [long, short] = [2e-5, 2e-6].map(|d| falling(Shape::Exponential, Some([d, 1e-3])));
    let forces = [constant, long, short].map(|contact| {
        let motion = motion(&contact, 0.002, 0.0);
        let mut rolling = Rolling::new(&contact, Resolution::FAST).unwrap();
        [0.02, 3.0].map(|distance| rolling.step(distance, &motion).unwrap().solution.force.fx)
    });
    let [at_first, later] = [0, 1].map(|time| forces.map(|force| force[time]));
    // The rim slips from the first step on; it bears little.
    assert!(
        at_first.iter().all(|fx| (fx - at_first[0]).abs() < 0.02 * at_first[0]),
        "{at_first:?}"
    );
    assert!(later[0] > later[1] + 5e-3 && later[1] > later[2] + 5e-3, "{later:?}");
}

/// Dissipation is that of friction by the slip, whatever it falls to.
#[test]
fn slip_takes_energy_while_friction_falls_and_rises() {
    let contact = falling(Shape::Exponential, MEMORY);
    let mut rolling = Rolling::new(&contact, coarse()).unwrap();
    for creepage in [0.001, 0.004, 0.0005, -0.003, 0.0, 0.002] {
        for _ in 0..5 {
            let rolled = rolling.step(0.2, &motion(&contact, creepage, 0.1)).unwrap();
            assert!(rolled.dissipation >= 0.0, "{}", rolled.dissipation);
            let force = rolled.solution.force;
            assert!(force.fx.hypot(force.fy) < 1.0, "{force:?}");
        }
    }
}

/// A history cut anywhere and gone on with from the saved state gives the same bits.
#[test]
fn what_friction_remembers_is_saved() {
    let contact = falling(Shape::Exponential, MEMORY);
    let motion = motion(&contact, 0.002, 0.1);
    let fresh = Rolling::new(&contact, coarse()).unwrap();
    let mut rolling = fresh.clone();
    rolling.step(0.4, &motion).unwrap();
    let bytes = rolling.save().to_bytes();
    let mut later = fresh;
    later.restore(&Saved::from_bytes(&bytes, &later).unwrap()).unwrap();
    let [one, other] =
        [&mut rolling, &mut later].map(|rolling| rolling.step(0.4, &motion).unwrap());
    assert_eq!(one.solution.force, other.solution.force);
    let fresh = RollingFastsim::new(&contact, Settings::default()).unwrap();
    let mut rolling = fresh.clone();
    rolling.step(0.4, &motion).unwrap();
    let mut later = fresh;
    later.restore(&rolling.save()).unwrap();
    let [one, other] =
        [&mut rolling, &mut later].map(|rolling| rolling.step(0.4, &motion).unwrap());
    assert_eq!(one.solution.force, other.solution.force);
}

/// Cylinders that slide everywhere: friction at their speed, once it has forgotten.
#[test]
fn cylinders_slide_with_the_friction_of_their_speed() {
    let scaling = falling(Shape::Exponential, MEMORY).scaling();
    let memory = FrictionMemory::new(2e-6, 1e-3).unwrap();
    let law = law(Shape::Exponential, 0.1);
    let friction = RollingFriction::new(law, Some(memory), 30.0).unwrap();
    let mut rolling = Rolling::line_with_friction(1000.0, 0.28, friction, scaling).unwrap();
    let xi = 40.0;
    let motion = Motion::from(Creepage::new(xi, 0.0, 0.0).unwrap());
    let end = rolling.step(8.0, &motion).unwrap().solution.force.fx;
    let expected = law.at(30.0 * scaling.slip * xi) / 0.3;
    // What has just entered the contact still has friction at rest; it bears little.
    assert!((end - expected).abs() < 0.01, "{end} {expected}");
}

/// Without a memory the tractions of falling friction jump from step to step: it is asked for.
#[test]
fn falling_friction_needs_a_memory() {
    let contact = falling(Shape::Exponential, None);
    assert_eq!(Rolling::new(&contact, coarse()).unwrap_err().quantity, "memory_distance");
    let friction = contact.rolling_friction().unwrap();
    let line = Rolling::line_with_friction(1000.0, 0.28, friction, contact.scaling());
    assert_eq!(line.unwrap_err().quantity, "memory_distance");
}

/// A third body is not known to FASTSIM with a memory, and is not left out silently.
#[test]
fn a_layer_is_refused_by_fastsim() {
    let layer = Layer::elastic(20e-6, 5e9).unwrap();
    let contact = hertz().with_friction(0.3).unwrap().with_layer(layer);
    let fastsim = RollingFastsim::new(&contact, Settings::default());
    assert_eq!(fastsim.unwrap_err().quantity, "layer thickness");
}
