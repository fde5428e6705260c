//! Rails on springs whose wheels run on their flanges.
#![allow(missing_docs, clippy::unwrap_used)]

use creepage::theory::{AreaTheory, ExactOptions, NamedResolution, ResolutionSpec};
use creepage::{Solid, SolidPair};
use creepage_rail::{Place, Side, Standard, Track, Wheelset};
use creepage_wheelset::{
    Load, RailFriction, RailSprings, WheelsetPose, WheelsetSolver, WheelsetVelocity,
};

/// From the tread to a flange that climbs: springs carry what wheels press on their rails, to within what loads
/// scatter (a part 1e-4 and a fifth of the error bar), and a rail without a force of its own goes down by load over
/// stiffness.
#[test]
fn springs_carry_flanges() {
    let track = Track::new(&Standard::Uic60.profile(), 0.025f64.atan(), Place::gauge(1.435, 0.014));
    let wheelset = Wheelset::like(&Standard::S1002.profile(), 0.46, 1.360).unwrap();
    let running = wheelset.on(track.unwrap());
    let steel = Solid::new(82e9, 0.28).unwrap();
    let friction = [RailFriction::Constant(0.3), RailFriction::Constant(0.3)];
    let resolution = ResolutionSpec::Named(NamedResolution::Fast);
    let theory = AreaTheory::Exact(ExactOptions { resolution, ..ExactOptions::default() });
    let pair = SolidPair::new(steel, steel);
    let solver = WheelsetSolver::new(&running, pair, friction, theory).unwrap();
    let velocity = WheelsetVelocity { speed: 30.0, ..WheelsetVelocity::default() };
    let springs = RailSprings { stiffness: [5e7, 4e7], force: [0.0, 0.0] };
    for (side, y) in [
        (None, 0.0),
        (None, -0.0065),
        (Some(Side::Right), 0.0055),
        (Some(Side::Right), 0.0075),
        (Some(Side::Left), -0.009),
    ] {
        let load = if side.is_some() { Load::Wheel(50e3) } else { Load::Axle(100e3) };
        let pose = WheelsetPose { side, y, yaw: 0.002, roll: None, load: Some(load) };
        let solved = solver.solve_on_springs(&[Some(springs); 2], &pose, &velocity).unwrap();
        for wheel in solved.wheels() {
            let on_rail = wheel.on_rail();
            let [across, down] = wheel.deflection.unwrap();
            let [_, lateral, vertical] = on_rail.force;
            let within =
                (0.2 * on_rail.force_error.unwrap()[1]).max(1e-4 * vertical.max(lateral.abs()));
            assert!((5e7 * across - lateral).abs() <= within, "{side:?} {y}: {across} {lateral}");
            assert!((4e7 * down - 50e3).abs() < 1e-6, "{side:?} {y}: {down}");
        }
        // A wheel that climbs by 9 mm, whose rail slides away, is not found by its height.
        if y < -0.008 {
            continue;
        }
        // At the height and roll that were found the forces are the same, within both error bars and what springs may
        // miss on either side.
        let (z, roll) = (solved.position().z, solved.position().roll);
        let given = WheelsetPose { roll: Some(roll), load: Some(Load::Height(z)), ..pose };
        let again = solver.solve_on_springs(&[Some(springs); 2], &given, &velocity).unwrap();
        for (one, other) in solved.wheels().zip(again.wheels()) {
            let (one, other) = (one.on_rail(), other.on_rail());
            let [bars, again] = [one, other].map(|wheel| wheel.force_error.unwrap());
            let pairs = one.force.iter().zip(other.force).zip(bars.iter().zip(again));
            for ((first, second), (bar, other_bar)) in pairs {
                let within = bar + other_bar + 2e-4 * one.force[2];
                assert!(
                    (first - second).abs() <= within,
                    "{side:?} {y}: {first} {second} {within}"
                );
            }
        }
    }
}
