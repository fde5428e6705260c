//! Wheels that roll in steps: where nothing changes they go to steady rolling, and where little does, little follows.

#![allow(clippy::unwrap_used)] // helpers of tests

use creepage::theory::{AreaTheory, ExactOptions, NamedResolution, ResolutionSpec};
use creepage::{Solid, SolidPair};
use creepage_rail::{Place, Side, Standard, Track, Wheelset, WheelsetOnTrack};
use creepage_wheelset::{
    ContactChanges, Load, PitchRate, RailFriction, SolvedContact, SolvedWheelset, StepsStart,
    WheelSteps, WheelsetError, WheelsetPose, WheelsetSolver, WheelsetVelocity,
};

const FRICTION: f64 = 0.3;
const LOAD: f64 = 50e3;

fn running() -> WheelsetOnTrack {
    running_on(Standard::S1002)
}

fn running_on(wheel: Standard) -> WheelsetOnTrack {
    let profile = Standard::Uic60.profile();
    let place = Place::gauge(1.435, 0.014);
    let track = Track::new(&profile, 0.025f64.atan(), place).unwrap();
    Wheelset::like(&wheel.profile(), 0.46, 1.360).unwrap().on(track)
}

fn solver(running: &WheelsetOnTrack) -> WheelsetSolver<'_> {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let resolution = ResolutionSpec::Named(NamedResolution::Fast);
    let theory = AreaTheory::Exact(ExactOptions { resolution, ..ExactOptions::default() });
    let friction = [RailFriction::Constant(FRICTION), RailFriction::Constant(FRICTION)];
    WheelsetSolver::new(running, SolidPair::new(steel, steel), friction, theory).unwrap()
}

fn pose(y: f64, load: Load) -> WheelsetPose {
    WheelsetPose { side: Some(Side::Right), y, yaw: 2e-3, roll: None, load: Some(load) }
}

fn velocity() -> WheelsetVelocity {
    let pitch = PitchRate::Rigid(Some(20.02 / 0.46));
    WheelsetVelocity { speed: 20.0, pitch, ..WheelsetVelocity::default() }
}

/// The force on the right rail in parts of `mu N`, and the wheel's height.
fn force(solved: &SolvedWheelset) -> [f64; 3] {
    let wheel = solved.right.as_ref().unwrap();
    wheel.on_rail().force.map(|part| part / (FRICTION * LOAD))
}

fn apart(one: [f64; 3], other: [f64; 3]) -> f64 {
    one.iter().zip(other).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

#[test]
fn equal_positions_go_to_steady_rolling() {
    let running = running();
    let solver = solver(&running);
    for y in [0.0, 3e-3] {
        let pose = pose(y, Load::Wheel(LOAD));
        let steady = force(&solver.solve(&pose, &velocity()).unwrap());
        let mut wheels = WheelSteps::new(StepsStart::Pressed);
        let rolled = (0..20).map(|_| wheels.step(&solver, &pose, &velocity(), 2e-3).unwrap());
        let rolled: Vec<_> = rolled.collect();
        assert!(rolled.iter().all(|one| one.changes.is_none()));
        let first = apart(force(&rolled[0].solved), steady);
        let last = apart(force(&rolled[19].solved), steady);
        // Elements of both schemes differ by a few thousandths on the coarse grid.
        assert!(first > 0.05 && last < 5e-3, "y {y}: {first} {last}");
    }
}

#[test]
fn steady_rolling_stays() {
    let running = running();
    let solver = solver(&running);
    let pose = pose(1e-3, Load::Wheel(LOAD));
    let steady = force(&solver.solve(&pose, &velocity()).unwrap());
    let mut wheels = WheelSteps::new(StepsStart::Steady);
    for _ in 0..4 {
        let stepped = wheels.step(&solver, &pose, &velocity(), 1e-3).unwrap();
        let missed = apart(force(&stepped.solved), steady);
        assert!(missed < 5e-3, "{missed}");
    }
}

fn load(solved: &SolvedWheelset) -> f64 {
    solved.right.as_ref().unwrap().contacts().iter().map(SolvedContact::load).sum()
}

/// A step of a micrometre changes forces by what the pressing changes them, with one contact and with two. In the
/// reference bank forces jump by 1.4 to 1.8 % over as little.
#[test]
fn a_short_step_changes_little() {
    for (wheel, y, contacts) in [
        (Standard::S1002, 5.2e-3, 1),
        (Standard::S1002, 6.1e-3, 1),
        (Standard::S1002, 6.6e-3, 1),
        (Standard::Cone20, 6.2e-3, 1),
        (Standard::Cone20, 6.4e-3, 2),
        (Standard::Cone20, 6.6e-3, 1),
    ] {
        let running = running_on(wheel);
        let solver = solver(&running);
        let placed = solver.solve(&pose(y, Load::Wheel(LOAD)), &velocity()).unwrap();
        let wheel = placed.right.unwrap();
        assert_eq!(wheel.contacts().len(), contacts, "y {y}");
        let height = Load::Height(wheel.position.z);
        let mut wheels = WheelSteps::new(StepsStart::Steady);
        let before = wheels.step(&solver, &pose(y, height), &velocity(), 2e-3).unwrap().solved;
        let after = wheels.step(&solver, &pose(y + 1e-6, height), &velocity(), 1e-6).unwrap();
        assert!(after.changes.is_none(), "{:?}", after.changes);
        let by_load = (load(&after.solved) / load(&before) - 1.0).abs();
        let jump = apart(force(&after.solved), force(&before));
        // Forces in parts of the friction of 50 kN, loads in parts of what presses: on the flange several times that.
        let size = load(&before) / (FRICTION * LOAD);
        assert!(jump < 2e-3 + 1.5 * size * by_load, "y {y}: {jump}, load {by_load} of {size}");
    }
}

/// A tread contact, then the flange beside it, then the flange alone.
#[test]
fn contacts_appear_and_vanish() {
    let running = running_on(Standard::Cone20);
    let solver = solver(&running);
    let mut wheels = WheelSteps::new(StepsStart::Pressed);
    let mut step = |y: f64| {
        let pose = pose(y, Load::Wheel(LOAD));
        wheels.step(&solver, &pose, &velocity(), 1e-3).unwrap().changes
    };
    assert!(step(6.2e-3).is_none());
    assert_eq!(step(6.4e-3), ContactChanges { appeared: 1, ..ContactChanges::default() });
    assert!(step(6.4e-3).is_none());
    assert_eq!(step(6.6e-3), ContactChanges { vanished: 1, ..ContactChanges::default() });
}

#[test]
fn what_cannot_roll_in_steps_is_told() {
    let running = running();
    let solver = solver(&running);
    let pose = pose(0.0, Load::Wheel(LOAD));
    let mut wheels = WheelSteps::new(StepsStart::Pressed);
    let free = WheelsetVelocity { pitch: PitchRate::Rigid(None), ..velocity() };
    assert!(matches!(wheels.step(&solver, &pose, &free, 1e-3), Err(WheelsetError::Steps { .. })));
    let back = WheelsetVelocity { speed: -20.0, ..velocity() };
    assert!(matches!(wheels.step(&solver, &pose, &back, 1e-3), Err(WheelsetError::Steps { .. })));
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(wheels.step(&solver, &pose, &velocity(), length).is_err());
    }
}
