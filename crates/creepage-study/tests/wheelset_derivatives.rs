//! Derivatives of a wheelset's forces: against differences of positions that were solved, the mirror,
//! what motion cannot change, and limits.
#![allow(clippy::unwrap_used)]

use std::path::Path;

use creepage_rail::Side;
use creepage_study::{
    Load, PitchRate, SolvedWheelset, StateVariable, WheelsetCase, WheelsetDerivatives,
    WheelsetFile, WheelsetPose, WheelsetVelocity,
};

/// S1002 on UIC 60 with 200 kN, by FASTSIM on exact pressures: quick, and its motion derivative exact.
fn case(theory: &str) -> WheelsetCase {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/wheelset");
    let text = std::fs::read_to_string(examples.join("s1002-on-uic60.toml")).unwrap();
    let text = format!("{text}\n[solve]\n{theory}\n");
    WheelsetFile::read(&text).unwrap().case(&examples).unwrap()
}

const FASTSIM: &str = "theory = \"fastsim\"";
const SIDES: [Side; 2] = [Side::Left, Side::Right];

fn derivatives(case: &WheelsetCase) -> (SolvedWheelset, WheelsetDerivatives) {
    let solved = case.solve().unwrap();
    let derivatives = case.derivatives(&solved).unwrap();
    (solved.solved, derivatives)
}

/// Force and moment on both rails.
fn forces(solved: &SolvedWheelset) -> [[f64; 6]; 2] {
    [&solved.left, &solved.right].map(|wheel| {
        let on_rail = wheel.as_ref().unwrap().on_rail();
        let ([x, y, z], [mx, my, mz]) = (on_rail.force, on_rail.moment);
        [x, y, z, mx, my, mz]
    })
}

fn moved(case: &WheelsetCase, by: StateVariable, step: f64) -> (WheelsetPose, WheelsetVelocity) {
    let (mut stance, mut travel) = (case.stance, case.travel.unwrap());
    match by {
        StateVariable::Y => stance.y += step,
        StateVariable::Z => {
            if let Some(Load::Height(z)) = &mut stance.load {
                *z += step;
            }
        }
        StateVariable::Roll => stance.roll = stance.roll.map(|roll| roll + step),
        StateVariable::Yaw => stance.yaw += step,
        StateVariable::Speed => travel.speed += step,
        StateVariable::PitchRate => {
            if let PitchRate::Rigid(Some(rate)) = &mut travel.pitch {
                *rate += step;
            }
        }
        StateVariable::LateralVelocity => travel.lateral_velocity += step,
        StateVariable::YawRate => travel.yaw_rate += step,
    }
    (stance, travel)
}

/// Differences of wheelsets solved in full, load, roll and pitch rate anew: what total derivatives are.
fn differences(
    case: &WheelsetCase,
    solved: &SolvedWheelset,
    by: StateVariable,
    step: f64,
) -> [[f64; 6]; 2] {
    let solver = case.solver().unwrap();
    let [ahead, behind] = [step, -step].map(|step| {
        let (stance, travel) = moved(case, by, step);
        forces(&solver.next(solved, &stance, &travel).unwrap())
    });
    std::array::from_fn(|w| std::array::from_fn(|i| (ahead[w][i] - behind[w][i]) / (2.0 * step)))
}

/// The largest difference of two arrays of forces, and the largest of the second.
fn apart(one: &[[f64; 6]; 2], other: &[[f64; 6]; 2], parts: std::ops::Range<usize>) -> [f64; 2] {
    let mut found = [0.0_f64; 2];
    for (one, other) in one.iter().zip(other) {
        for i in parts.clone() {
            found[0] = found[0].max((one[i] - other[i]).abs());
            found[1] = found[1].max(other[i].abs());
        }
    }
    found
}

fn by(derivatives: &WheelsetDerivatives, by: StateVariable) -> [[f64; 6]; 2] {
    let k = StateVariable::ALL.iter().position(|other| *other == by).unwrap();
    derivatives.values().map(|rows| rows.map(|row| row[k]))
}

#[test]
fn under_a_load_they_are_those_of_the_solved_wheelset() {
    for y in [0.001, 0.004] {
        let mut case = case(FASTSIM);
        case.stance.y = y;
        case.stance.yaw = 1e-3;
        let (solved, found) = derivatives(&case);
        // The loads are met to 1e-5: over these steps a hundredth of the largest change. As much may
        // come from a kink of curvature within the longer of the steps.
        for (coordinate, step) in [
            (StateVariable::Y, 5e-6),
            (StateVariable::Yaw, 3e-5),
            (StateVariable::LateralVelocity, 1e-3),
            (StateVariable::YawRate, 3e-3),
        ] {
            let expected = differences(&case, &solved, coordinate, step);
            // Along and across, and their moments; the vertical force is the load, kept.
            for parts in [0..2, 3..6] {
                let [off, most] = apart(&by(&found, coordinate), &expected, parts.clone());
                assert!(off < 0.02 * most, "{y} {coordinate:?} {parts:?}: {off} of {most}");
            }
        }
    }
}

/// What is prescribed is what is differentiated by; the rest has none.
#[test]
fn what_is_given_decides() {
    let mut free = case(FASTSIM);
    free.stance.y = 1e-3;
    let (solved, found) = derivatives(&free);
    for by in [StateVariable::Z, StateVariable::Roll, StateVariable::PitchRate] {
        assert!(found.of(Side::Left, by).is_none(), "{by:?}");
    }
    let position = solved.position();
    let mut held = free.clone();
    held.stance.load = Some(Load::Height(position.z));
    held.stance.roll = Some(position.roll);
    held.travel = Some(WheelsetVelocity {
        pitch: PitchRate::Rigid(Some(solved.motion.pitch_rate)),
        ..held.travel.unwrap()
    });
    let (solved, found) = derivatives(&held);
    // Pressures scatter by some 1e-5, and a stiffness of moments is a small difference of large ones.
    for (coordinate, step) in [
        (StateVariable::Y, 2e-6),
        (StateVariable::Z, 2e-6),
        (StateVariable::Roll, 2e-6),
        (StateVariable::Yaw, 2e-5),
        (StateVariable::Speed, 3e-3),
        (StateVariable::PitchRate, 6e-3),
    ] {
        let expected = differences(&held, &solved, coordinate, step);
        for parts in [0..3, 3..6] {
            let [off, most] = apart(&by(&found, coordinate), &expected, parts.clone());
            assert!(off < 0.03 * most, "{coordinate:?} {parts:?}: {off} of {most}");
        }
    }
    // A contact is stiffer the deeper it is: the load rises by 3/2 F / depth, as of Hertz, or more
    // slowly where it widens.
    for wheel in solved.wheels() {
        let by_z = found.of(wheel.side, StateVariable::Z).unwrap().force[2];
        let hertz = 1.5 * wheel.on_rail().force[2] / wheel.contacts()[0].normal.approach().value;
        assert!((0.8..1.3).contains(&(by_z / hertz)), "{by_z} {hertz}");
    }
}

/// In the middle of the track: what moves to the right does to the right wheel what it does to the left
/// one in the mirror.
#[test]
fn in_the_middle_the_sides_are_mirrored() {
    let mut case = case(FASTSIM);
    case.stance.y = 0.0;
    let (_, found) = derivatives(&case);
    // A vector's y and a moment's x and z change sign, and so do y, yaw and their rates.
    let signs = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];
    for coordinate in [
        StateVariable::Y,
        StateVariable::Yaw,
        StateVariable::LateralVelocity,
        StateVariable::YawRate,
    ] {
        let [left, right] = by(&found, coordinate);
        let mirrored = std::array::from_fn(|i| -signs[i] * right[i]);
        for parts in [0..3, 3..6] {
            let [off, most] = apart(&[left; 2], &[mirrored; 2], parts);
            // The two sides are solved apart, each to some 1e-7 of mu N.
            assert!(off < 1e-3 * most, "{coordinate:?}: {left:?} {right:?}");
        }
    }
}

/// Loads are kept; creepages are ratios, which a film played faster does not change.
#[test]
fn what_is_kept_has_none() {
    for theory in [FASTSIM, "resolution = \"fast\""] {
        let mut case = case(theory);
        case.stance.y = 3e-3;
        case.travel = Some(WheelsetVelocity {
            lateral_velocity: 0.02,
            yaw_rate: 0.01,
            ..case.travel.unwrap()
        });
        let (_, found) = derivatives(&case);
        let WheelsetVelocity { speed, lateral_velocity, yaw_rate, .. } = case.travel.unwrap();
        for coordinate in StateVariable::ALL {
            for side in SIDES {
                let Some(derivative) = found.of(side, coordinate) else { continue };
                // Rounding of stiffnesses of 1e9 N/m.
                assert!(derivative.force[2].abs() < 1e-3, "{coordinate:?} {derivative:?}");
            }
        }
        for wheel in 0..2 {
            for i in 0..6 {
                let [faster, sideways, turning] =
                    [StateVariable::Speed, StateVariable::LateralVelocity, StateVariable::YawRate]
                        .map(|coordinate| by(&found, coordinate)[wheel][i]);
                let parts = [speed * faster, lateral_velocity * sideways, yaw_rate * turning];
                let largest = parts.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
                // To the differences of the creepage.
                let sum: f64 = parts.iter().sum();
                assert!(sum.abs() < 1e-5 * largest.max(1.0), "{theory} {wheel} {i}: {parts:?}");
            }
        }
    }
}

/// Sliding the wheelset sideways by `v` and turning it by `-v / speed` is the same motion for linear
/// theory at small angles, where all but creepage is second order.
#[test]
fn yaw_steers_as_sideways_motion_does() {
    let mut case = case("theory = \"linear\"");
    case.stance.y = 0.0;
    let (_, found) = derivatives(&case);
    let speed = case.travel.unwrap().speed;
    let (yaw, sideways) =
        (by(&found, StateVariable::Yaw), by(&found, StateVariable::LateralVelocity));
    for wheel in 0..2 {
        // Yaw moves the contact lengthwise and tilts the load: parts in a thousand of the creep force.
        let ratio = -yaw[wheel][1] / (speed * sideways[wheel][1]);
        assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
    }
}

/// Slip that varies over a curved contact has its own way to differentiate: on the tread, nearly
/// flat, it comes to nearly the same.
#[test]
fn curved_slip_is_near_the_flat_one_on_the_tread() {
    let flat = case("resolution = \"fast\"");
    let mut curved = flat.clone();
    curved.slip = creepage_study::RigidSlip::Curved;
    let [(_, flat), (_, curved)] = [derivatives(&flat), derivatives(&curved)];
    for coordinate in [StateVariable::LateralVelocity, StateVariable::YawRate] {
        let [off, most] = apart(&by(&curved, coordinate), &by(&flat, coordinate), 0..3);
        // Spin that varies by a tenth across the contact.
        assert!(off < 0.05 * most, "{coordinate:?} {off} of {most}");
    }
}

/// A wheel that hangs has no pitch rate to be found: derivatives are those of the wheel that carries.
#[test]
fn a_wheel_that_hangs_leaves_the_other_its_derivatives() {
    let mut case = case(FASTSIM);
    case.stance = WheelsetPose { roll: Some(2e-3), ..case.stance };
    if let Some(travel) = &mut case.travel {
        travel.pitch = PitchRate::Independent([None; 2]);
    }
    let (solved, found) = derivatives(&case);
    assert!(solved.left.as_ref().unwrap().contacts().is_empty());
    for (coordinate, step) in [(StateVariable::Y, 5e-6), (StateVariable::LateralVelocity, 1e-3)] {
        let [left, right] = differences(&case, &solved, coordinate, step);
        let [own_left, own_right] = by(&found, coordinate);
        assert!(left.iter().chain(&own_left).all(|part| *part == 0.0));
        // Loads are met to 1e-5, which is a hundredth of the change over such steps; a kink of curvature within the
        // longer of the steps may make as much.
        assert!(
            (own_right[1] / right[1] - 1.0).abs() < 0.02,
            "{coordinate:?}: {own_right:?} {right:?}"
        );
    }
}
