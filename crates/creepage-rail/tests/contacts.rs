//! Contacts of a wheelset: against reference cases, closed forms and brute force.

#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp)]

use creepage_rail::curve::{Arc, Line};
use creepage_rail::{
    Contact, Curve, GeometryError, Motion, Place, Position, Profile, Revolving, Role,
    RollingCreepage, Side, Standard, SurfaceMotion, Track, Wheelset, WheelsetOnTrack,
};
use proptest::prelude::*;

const MM: f64 = 1e-3;

/// S1002 on UIC60 canted 1:40, gauge 1435.
fn manchester() -> WheelsetOnTrack {
    let rail = Standard::Uic60.profile();
    let track = Track::new(&rail, 0.025f64.atan(), Place::gauge(1.435, 0.014)).unwrap();
    Wheelset::like(&Standard::S1002.profile(), 0.46, 1.36).unwrap().on(track)
}

/// A wheel of straight tread on a rail of one arc of 300 mm, both with their origins in the
/// middle of the track.
fn plain(slope: f64) -> WheelsetOnTrack {
    let wheel = Line::between([0.06, -0.06 * slope], [-0.06, 0.06 * slope]);
    let wheel = Profile::new(Role::Wheel, Curve::new([wheel]).unwrap()).unwrap();
    let half = 0.05f64;
    let depth = 0.3 - (0.09 - half * half).sqrt();
    let rail = Arc::between([0.0, 0.3], 0.3, [-half, depth], [half, depth]);
    let rail = Profile::new(Role::Rail, Curve::new([rail]).unwrap()).unwrap();
    let wheel = creepage_rail::Wheel::new(&wheel, 0.46).unwrap().with_flange_back(0.0).unwrap();
    let track = Track::new(&rail, 0.0, Place::Origin(0.0)).unwrap();
    Wheelset::new(wheel.clone(), wheel, 0.0).unwrap().on(track)
}

fn only(running: &WheelsetOnTrack, side: Side, position: Position) -> Contact<'_> {
    let contacts = running.contacts_of(side, &position).unwrap();
    assert_eq!(contacts.len(), 1, "{position:?}");
    contacts[0]
}

/// 26 positions of the program CONTACT, extrapolated over its grids. The reference point is the
/// same kind of mean there, taken in another direction on steep flanges; the tolerances beyond
/// the printed uncertainty are what that and its profile splines leave, most where the reference
/// joins two lobes.
#[test]
fn contacts_are_those_of_the_reference() {
    let running = manchester();
    for line in include_str!("data/contacts.csv").lines().filter(|line| !line.starts_with('#')) {
        let (side, numbers) = line.split_once(',').unwrap();
        let side = if side == "left" { Side::Left } else { Side::Right };
        let v: Vec<f64> = numbers.split(',').map(|number| number.parse().unwrap()).collect();
        let position = Position { y: v[0] * MM, z: v[1] * MM, roll: v[2], yaw: v[3] };
        let contact = only(&running, side, position);
        let [x, y, _] = contact.reference;
        assert!((x - v[5] * MM).abs() < 3e-6 && (y - v[6] * MM).abs() < 8e-6, "{line}");
        let creepage = contact.creepage(&Motion::straight(2.0, v[4])).unwrap();
        let misses = [
            (contact.angle - v[8]).abs() - v[14],
            (contact.approach - v[9] * MM).abs() - (v[13] + v[15]) * MM,
            (creepage.longitudinal - v[10]).abs() - v[16],
            (creepage.lateral - v[11]).abs() - v[17],
            (creepage.spin * MM - v[12]).abs() - v[18],
        ];
        let limits = [1e-4, 3e-8, 2.1e-6, 5e-7, 1e-7];
        assert!(misses.iter().zip(limits).all(|(miss, limit)| *miss < limit), "{line} {misses:?}");
    }
}

/// A cylinder on a crown: the paraboloids of Hertz with their quartic terms.
#[test]
fn cylinder_on_a_crown() {
    let running = plain(0.0);
    let contact = only(&running, Side::Right, Position { z: 66e-6, ..Position::default() });
    assert!(contact.angle.abs() < 1e-12 && contact.reference[1].abs() < 1e-9);
    assert!((contact.approach - 66e-6).abs() < 1e-12);
    for (x, s) in [(0.0, 0.0f64), (3e-3, 0.0), (0.0, 4e-3), (5e-3, -3e-3)] {
        let expected = 0.3 - (0.09 - s * s).sqrt() + 0.46 - (0.46f64.powi(2) - x * x).sqrt();
        assert!((contact.gap(x, s).unwrap() - expected).abs() < 1e-12, "{x} {s}");
        assert!((contact.at(s).unwrap().rolling_radius - 0.46).abs() < 1e-12);
    }
}

/// A cone 1:40 touches the crown at `-300 sin(atan(1/40))` mm.
#[test]
fn cone_on_a_crown() {
    let running = plain(0.025);
    let touch = running.touch(Side::Right, 0.0, 0.0, 0.0).unwrap();
    let angle = -0.025f64.atan();
    assert!((touch.place[1] - 0.3 * angle.sin()).abs() < 1e-9);
    assert!((touch.angle - angle).abs() < 1e-8);
    assert!((touch.radius - 0.46 + 0.025 * touch.y_wheel).abs() < 1e-12);
    // Moved and yawed by -1 mrad: the locus is x = -R tan(delta) sin(psi).
    let yawed = running.touch(Side::Right, 0.005, 0.0, -0.001).unwrap();
    let locus = yawed.radius * 0.025 * (-0.001f64).sin();
    assert!((yawed.place[0] - yawed.y_wheel * 0.001f64.sin() - locus).abs() < 1e-8);
}

/// A side of 60 degrees with a round flange on it, both with their origins in the middle of the track; with a dent above
/// the contact whose wall overhangs, or without.
fn side(dented: bool) -> WheelsetOnTrack {
    let on_side = |y: f64| [y, 24.0 - (y + 30.0) * 3f64.sqrt()];
    let (foot, dent, head) = (
        [on_side(-30.0)],
        [on_side(-24.0), [-22.0, 14.2], on_side(-22.9)],
        [on_side(-20.0), [0.0, 0.0], [30.0, 5.0]],
    );
    let dent = dent.iter().filter(|_| dented);
    let points: Vec<[f64; 2]> =
        foot.iter().chain(dent).chain(&head).map(|point| point.map(|at| at * MM)).collect();
    let corners: Vec<usize> = (1..points.len() - 1).collect();
    let rail = Profile::through(Role::Rail, &points, &corners).unwrap();
    // Of radius 20 mm, touching the side at y = -27 mm.
    let (sin, cos) = (60f64.to_radians().sin(), 60f64.to_radians().cos());
    let [y, z] = on_side(-27.0);
    let centre = [y - 20.0 * sin, z - 20.0 * cos].map(|at| at * MM);
    let at = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [centre[0] + 0.02 * cos, centre[1] + 0.02 * sin]
    };
    let flange = Arc::between(centre, 0.02, at(10.0), at(70.0));
    let wheel = Profile::new(Role::Wheel, Curve::new([flange]).unwrap()).unwrap();
    let wheel = creepage_rail::Wheel::new(&wheel, 0.46).unwrap().with_flange_back(0.0).unwrap();
    let track = Track::new(&rail, 0.0, Place::Origin(0.0)).unwrap();
    Wheelset::new(wheel.clone(), wheel, 0.0).unwrap().on(track)
}

/// Below the wall of a dent a rail is seen again from above: the contact there is that of the sound rail.
#[test]
fn a_dent_above_a_contact_does_not_hide_it() {
    let (sound, dented) = (side(false), side(true));
    let position = Position { z: 50e-6, ..Position::default() };
    for place in [Side::Left, Side::Right] {
        let [one, other] = [&sound, &dented].map(|running| only(running, place, position));
        // A slope of 60 degrees halves what the wheel goes down.
        assert!((other.approach - 25e-6).abs() < 1e-7, "{}", other.approach);
        assert!((one.approach - other.approach).abs() < 1e-12);
        assert!((one.angle - other.angle).abs() < 1e-9);
        for k in 0..3 {
            assert!((one.reference[k] - other.reference[k]).abs() < 1e-9, "{:?}", other.reference);
        }
        for s in [-5e-4, 0.0, 5e-4] {
            let [one, other] = [one, other].map(|contact| contact.gap(1e-3, s).unwrap());
            assert!((one - other).abs() < 1e-12, "{one} {other}");
        }
    }
    // It still touches the sound parts first where it comes down.
    let [one, other] = [&sound, &dented].map(|running| running.touch(Side::Right, 0.0, 0.0, 0.0));
    assert!((one.unwrap().z - other.unwrap().z).abs() < 1e-9);
}

#[test]
fn the_left_wheel_is_the_mirror_image() {
    let running = manchester();
    let motion = Motion {
        speed: 20.0,
        pitch_rate: 43.3,
        lateral_velocity: 0.03,
        vertical_velocity: -0.01,
        roll_rate: 0.04,
        yaw_rate: 0.02,
        ..Motion::default()
    };
    let mirrored_motion =
        Motion { lateral_velocity: -0.03, roll_rate: -0.04, yaw_rate: -0.02, ..motion };
    let position = Position { y: 0.0047, z: 25e-6, roll: -3e-4, yaw: 0.004 };
    let mirrored = Position { y: -0.0047, roll: 3e-4, yaw: -0.004, ..position };
    for side in [Side::Left, Side::Right] {
        let other = if side == Side::Left { Side::Right } else { Side::Left };
        let a = running.contacts_of(side, &position).unwrap();
        let b = running.contacts_of(other, &mirrored).unwrap();
        assert!(!a.is_empty() && a.len() == b.len());
        for (a, b) in a.iter().zip(&b) {
            assert_eq!(a.reference, [b.reference[0], -b.reference[1], b.reference[2]]);
            assert_eq!((a.angle, a.y_rail, a.approach), (-b.angle, b.y_rail, b.approach));
            assert_eq!(a.extent[1], [-b.extent[1][1], -b.extent[1][0]]);
            assert_eq!(a.gap(1e-3, 5e-4), b.gap(1e-3, -5e-4));
            let slip = a.rigid_slip(&motion, 1e-3, 5e-4).unwrap();
            let image = b.rigid_slip(&mirrored_motion, 1e-3, -5e-4).unwrap();
            assert_eq!(slip, [image[0], -image[1]]);
            let (k, l) = (a.creepage(&motion).unwrap(), b.creepage(&mirrored_motion).unwrap());
            assert_eq!((k.longitudinal, k.lateral, k.spin), (l.longitudinal, -l.lateral, -l.spin));
        }
    }
}

/// The least distance along `x`, its place and its curvature, found from the exact surface.
#[test]
fn locus_and_rolling_radius_are_those_of_the_surface() {
    let running = manchester();
    let cases = [
        (0.001, 0.0024, -5e-5, 0.184e-3),
        (0.007, 0.0168, -6.4e-3, -4.58e-3),
        (0.0, 0.0, 0.0, 0.198e-3),
    ];
    for (y, yaw, roll, z) in cases {
        let contact = only(&running, Side::Right, Position { y, z, roll, yaw });
        for across in contact.section(7, 0.0) {
            let h = 5e-4;
            let gap = |dx: f64| contact.gap(across.x + dx, across.s).unwrap();
            let (a, b, c) = (gap(-h), gap(0.0), gap(h));
            assert!((b - across.gap).abs() < 1e-13);
            let row = contact.row(across.s, &[across.x - h, across.x, across.x + h]).unwrap();
            assert!(row.iter().zip([a, b, c]).all(|(row, gap)| (row - gap).abs() < 1e-13));
            let bend = (a - 2.0 * b + c) / (h * h);
            // The locus: no slope; the difference across is of third order.
            assert!((c - a).abs() / (2.0 * h) < 3e-5 * h / 5e-4, "{y} {across:?}");
            assert!((bend * across.rolling_radius - 1.0).abs() < 2e-3, "{bend} {across:?}");
        }
    }
}

/// On the conical part of a wheel the wheel's surface is flat across: slip is linear in `s`.
#[test]
fn rigid_slip_on_a_flat_contact_is_creepage_and_spin() {
    let running = plain(0.05);
    let contact = only(&running, Side::Right, Position { z: -350e-6, ..Position::default() });
    let motion = Motion {
        speed: 20.0,
        pitch_rate: 43.4,
        lateral_velocity: 0.1,
        yaw_rate: 0.01,
        ..Motion::default()
    };
    let creepage = contact.creepage(&motion).unwrap();
    let at = |x: f64, s: f64| contact.rigid_slip(&motion, x, s).unwrap();
    let origin = at(0.0, 0.0);
    assert!((origin[0] - creepage.longitudinal).abs() < 2e-5);
    for (x, s) in [(1e-3, 0.0), (0.0, 1e-3), (-2e-3, 3e-3)] {
        let [along, across] = at(x, s);
        // The wheel's depth over `x` (x^2 / 2R of its radius) and, beyond the axes, its velocity
        // into the rail seen along the rail's slope, x s / (R r).
        let limit = 1e-5 + (x * s / (0.46 * 0.3)).abs();
        assert!((along - origin[0] + creepage.spin * s).abs() < limit, "{x} {s}");
        assert!((across - origin[1] - creepage.spin * x).abs() < limit, "{x} {s}");
    }
}

/// Pure rolling of the nominal circles: no creepage in the middle of the track but the spin of
/// the contact angle, and a yawed axle slips sideways by its yaw.
#[test]
fn creepages_of_simple_motions() {
    let running = plain(0.0);
    let position = Position { z: 66e-6, ..Position::default() };
    let contact = only(&running, Side::Right, position);
    let rolling = Motion::straight(2.0, 2.0 / 0.46);
    let creepage = contact.creepage(&rolling).unwrap();
    assert!(creepage.longitudinal.abs() < 1e-9 && creepage.spin.abs() < 1e-9);
    let slower = contact.creepage(&Motion { pitch_rate: 0.999 * 2.0 / 0.46, ..rolling }).unwrap();
    assert!((slower.longitudinal - 0.001 / 0.9995).abs() < 1e-9);
    let yawed = only(&running, Side::Right, Position { yaw: 0.002, ..position });
    let creepage = yawed.creepage(&rolling).unwrap();
    assert!((creepage.lateral + 0.002).abs() < 1e-8);
    assert!(contact.creepage(&Motion::straight(-2.0, -4.0)).is_none());
    assert!(contact.creepage(&Motion::straight(f64::NAN, 4.0)).is_none());
}

/// Where a cone just touches, the common normal meets its axle: the thesis's formulas for bodies
/// of revolution say the same as the wheelset's motion.
#[test]
fn bodies_of_revolution_creep_as_the_wheelset_does() {
    let running = plain(0.05);
    for yaw in [0.0, 0.004, -0.012] {
        let touch = running.touch(Side::Right, 0.002, 0.0, yaw).unwrap();
        let position = Position { y: 0.002, z: touch.z + 1e-9, roll: 0.0, yaw };
        let contact = only(&running, Side::Right, position);
        let motion = Motion::straight(2.0, 4.3);
        let creepage = contact.creepage(&motion).unwrap();
        let axle = [-yaw.sin(), yaw.cos()];
        let upper = Revolving {
            radius: touch.radius,
            rate: 4.3,
            yaw: (-axle[0]).atan2(axle[1] * contact.angle.cos()),
            cone: (-axle[1] * contact.angle.sin()).asin(),
        };
        let lower = SurfaceMotion { velocity: [-2.0, 0.0], turn: 0.0 };
        let expected = RollingCreepage::between(upper.as_upper(), lower).unwrap();
        assert!((creepage.longitudinal - expected.longitudinal).abs() < 1e-7, "{yaw}");
        assert!((creepage.lateral - expected.lateral).abs() < 1e-7, "{yaw}");
        assert!((creepage.spin - expected.spin).abs() < 1e-6, "{yaw}");
    }
}

/// From the centre through the range of two lobes into flange contact: the reference moves on
/// without jumps as long as the number of contacts stays.
#[test]
fn contacts_move_smoothly_with_the_wheelset() {
    let running = manchester();
    let mut before: Option<(usize, [f64; 3], f64)> = None;
    let mut changes = 0;
    for i in 0..=600 {
        let y = f64::from(i) * 1e-5;
        let rest = running.resting(y, 0.0, None).unwrap();
        let position = Position { z: rest.z + 80e-6, ..rest };
        let contacts = running.contacts_of(Side::Right, &position).unwrap();
        let now = (contacts.len(), contacts[0].reference, contacts[0].angle);
        if let Some((count, place, angle)) = before {
            changes += usize::from(count != now.0);
            let moved = (place[1] - now.1[1]).abs();
            assert!(
                count != now.0 || (moved < 3e-4 && (angle - now.2).abs() < 0.02),
                "{y} {moved}"
            );
        }
        before = Some(now);
    }
    assert_eq!(changes, 0);
}

#[test]
fn gauge_and_cant() {
    let uic60 = Standard::Uic60.profile();
    let cant = 0.025f64.atan();
    let track = Track::new(&uic60, cant, Place::gauge(1.435, 0.014)).unwrap();
    let [y, z] = track.right.origin();
    // The crown's centre turns about the origin; the highest point lies above it.
    let top = y + 0.3 * cant.sin();
    assert!((z - 0.3 * (1.0 - cant.cos())).abs() < 1e-12);
    // By hand from the corner's centre: 43.0385 from the highest point to the gauge face.
    assert!((top - 0.7175 - 0.043_038_5).abs() < 1e-7, "{top}");
    // Rail A, its origin at 750: 1435.164 between the faces 14 mm below the highest point.
    let rail_a = Standard::En15302RailA.profile();
    let track = Track::new(&rail_a, 0.0, Place::gauge(1.435_164, 0.014)).unwrap();
    assert!((track.right.origin()[0] - 0.750).abs() < 1e-6);
    let deep = Track::new(&rail_a, 0.0, Place::gauge(1.435, 0.020));
    assert!(matches!(deep, Err(GeometryError::HeadTooLow { .. })));
    for (cant, gauge, height) in [(f64::NAN, 1.4, 0.01), (0.0, -1.0, 0.01), (0.0, 1.4, f64::NAN)] {
        assert!(Track::new(&uic60, cant, Place::gauge(gauge, height)).is_err());
    }
    assert!(Track::new(&Standard::S1002.profile(), 0.0, Place::Origin(0.75)).is_err());
    assert!(Wheelset::like(&uic60, 0.46, 1.36).is_err());
    assert!(Wheelset::like(&Standard::S1002.profile(), 0.0, 1.36).is_err());
}

/// Free roll: both wheels touch; in the middle there is none.
#[test]
fn free_roll_lets_both_wheels_touch() {
    let running = manchester();
    assert!(running.resting(0.0, 0.0, None).unwrap().roll.abs() < 1e-12);
    for y in [0.001, 0.004, 0.0055, 0.007] {
        for yaw in [0.0, 0.010] {
            let rest = running.resting(y, yaw, None).unwrap();
            let heights = [Side::Left, Side::Right]
                .map(|side| running.touch(side, y, rest.roll, yaw).unwrap().z);
            assert!((heights[0] - heights[1]).abs() < 1e-11, "{y} {heights:?}");
        }
    }
}

#[test]
fn contact_at_the_end_of_a_profile_is_an_error() {
    let running = plain(0.0);
    let far = Position { y: 0.085, z: 3e-3, ..Position::default() };
    let result = running.contacts_of(Side::Right, &far);
    assert!(matches!(result, Err(GeometryError::End { side: Side::Right, .. })), "{result:?}");
    let apart = running.touch(Side::Right, 0.2, 0.0, 0.0);
    assert!(matches!(apart, Err(GeometryError::Apart { .. })));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]
    /// Any position: contacts with finite numbers, or an error.
    #[test]
    fn any_position_is_answered(
        y in -0.1f64..0.1, z in -0.02f64..0.02, roll in -0.6f64..0.6, yaw in -0.6f64..0.6,
        shrink in 0.0f64..1.0,
    ) {
        let running = manchester();
        let position = Position { y: shrink * y, z, roll: shrink * shrink * roll, yaw: shrink * yaw };
        if let Ok(contacts) = running.contacts(&position) {
            for contact in contacts {
                prop_assert!(contact.approach > 0.0 && contact.angle.is_finite());
                prop_assert!(contact.section(9, 0.1).iter().all(|a| a.gap.is_finite()));
            }
        }
    }
}
