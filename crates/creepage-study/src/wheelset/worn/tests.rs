//! The loop against closed forms.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;
use std::path::Path;

use super::*;
use crate::wheelset::{WheelsetCase, WheelsetFile};

/// One wheel of a straight profile on a round head of 300 mm, pressed by 100 kN; cone and pitch rate to be
/// set. Little friction, so that all slides.
fn read(cone: f64, contact: &str, motion: &str, rest: &str) -> (WheelsetCase, WearPlan) {
    let wheel = format!("[[0.06, {:?}], [-0.06, {:?}]]", -0.06 * cone, 0.06 * cone);
    let head: Vec<String> = (-80..=80)
        .map(|k: i32| f64::from(k) / 80.0 * 0.12)
        .map(|t: f64| format!("[{:.15}, {:.15}]", 0.3 * t.sin(), 0.3 * (1.0 - t.cos())))
        .collect();
    let text = format!(
        "wheel = {{ points = {wheel}, radius = 0.46, flange_back = -0.07 }}
        rail = {{ points = [{}] }}
        track = {{ rail_position = 0.75 }}
        wheelset = {{ back_to_back = 1.36, side = 'right', roll = 0.0, wheel_load = 100e3 }}
        motion = {{ speed = 10.0, {motion} }}
        contact = {{ {contact} }}
        materials = {{ shear_modulus = 82e9, poisson = 0.28 }}
        damage = {{ archard = {{ mild = 3e-4, hardness = 2.7e9 }} }}
        solve = {{ theory = 'fastsim', grid = [30, 50] }}
        wear = {{ {rest} }}",
        head.join(", ")
    );
    let file = WheelsetFile::read(&text).unwrap();
    let case = file.case(Path::new("")).unwrap();
    let plan = file.wear(&case, Path::new("")).unwrap();
    (case, plan)
}

fn run(case: &WheelsetCase, plan: &WearPlan) -> Wear {
    wear(case, plan, None, &mut |_, _| true).unwrap()
}

fn worn(wear: &Wear, body: WornBody) -> &WornProfile {
    wear.stops.last().unwrap().bodies[body as usize].as_ref().unwrap()
}

/// Full sliding at `ups` = .002 of a cylinder R .46 on a head of .3: `d(0) = (pi/2) a (k ups/H) p0` for each
/// passage, volume `k ups N/H` for each metre.
#[test]
fn a_cylinder_wears_as_the_closed_form_says() {
    let rest = "body = 'both', distance = 1e3, passages = 1e3, stops = 1, smoothing_length = 1e-4";
    // 10 m/s less 2 parts of a thousand.
    let (case, plan) = read(0.0, "friction = 0.005", "pitch_rate = 21.695652173913043", rest);
    let wear = run(&case, &plan);
    let (rail, wheel) = (worn(&wear, WornBody::RailRight), worn(&wear, WornBody::WheelRight));
    let peak = |found: &WornProfile, right: f64| {
        let part = found.greatest() / right - 1.0;
        // Strips and their smoothing over .1 mm (b is 5.4 mm), and 60 cells: parts of a thousand.
        assert!(part.abs() < 0.01, "{} {right}", found.greatest());
    };
    peak(rail, 1e3 * 3.080_343e-9);
    peak(wheel, 3.080_343e-9 * 1e3 / (TAU * 0.46));
    // The sum of the pressure is the load, to the accuracy of the pressure.
    let volume = 3e-4 * 2e-3 * 100e3 / 2.7e9;
    assert!((rail.area / (1e3 * volume) - 1.0).abs() < 5e-3, "{}", rail.area);
    assert!((wheel.volume / (1e3 * volume) - 1.0).abs() < 5e-3, "{}", wheel.volume);
    assert!((wheel.area * TAU * 0.46 / wheel.volume - 1.0).abs() < 1e-4);
}

/// Positions spread over 3 mm and evenly weighted: the depth is their mean, and the volume the same.
#[test]
fn shares_of_many_places_add_up() {
    let places = [-6.0, -3.0, 0.0, 3.0, 6.0].map(|y: f64| {
        let share = (-0.5 * (y / 3.0) * (y / 3.0)).exp();
        format!("{{ y = {}, share = {share} }}", 1e-3 * y)
    });
    let rest = format!(
        "body = 'rail', passages = 1e3, stops = 1, smoothing_length = 1e-4, situation = [{}]",
        places.join(", ")
    );
    let (case, plan) = read(0.0, "friction = 0.005", "pitch_rate = 21.695652173913043", &rest);
    let spread = run(&case, &plan);
    let rail = worn(&spread, WornBody::RailRight);
    // The wheel is a cylinder: the place on the rail stays wherever the wheelset stands, on the rail.
    let volume = 3e-4 * 2e-3 * 100e3 / 2.7e9;
    assert!((rail.area / (1e3 * volume) - 1.0).abs() < 5e-3, "{}", rail.area);
    let sum: f64 = plan.situations.iter().map(|situation| situation.share).sum();
    assert!((sum - 1.0).abs() < 1e-12);
}

/// Over many steps the volume of a fully sliding contact is `k ups N L/H` however the profile has become;
/// `ups` grows as the radius falls, for the pitch rate is given.
#[test]
fn a_cone_loses_what_slides_over_many_steps() {
    let rest = "distance = 1.5e6, stops = 2, step_depth = 1e-4";
    let (case, plan) = read(0.05, "friction = 0.005", "pitch_rate = 21.3", rest);
    let wear = run(&case, &plan);
    let wheel = worn(&wear, WornBody::WheelRight);
    assert!(wear.stops[2].steps >= 4 && wheel.greatest() > 5e-4, "{:e}", wheel.greatest());
    let ups = |depth: f64| 1.0 - 21.3 * (0.46 - depth) / 10.0;
    let volume = |depth: f64| 3e-4 * ups(depth) * 100e3 * 1.5e6 / 2.7e9;
    // Between the slip at no depth and at the greatest; spin adds some, pressure is found to parts of a hundred.
    let (least, most) = (volume(0.0), volume(wheel.greatest()));
    assert!(
        wheel.volume > 0.98 * least && wheel.volume < 1.03 * most,
        "{} {least} {most}",
        wheel.volume
    );
}

/// By energy: the mass of mild wear is 5.3e-9 kg/J of what slip turns to heat.
#[test]
fn by_energy_a_free_cone_loses_its_heat() {
    let rest = "law = 'usfd', distance = 1e6, stops = 1";
    let (case, plan) = read(0.05, "friction = 0.3", "pitch_rate = 'free'", rest);
    let solved = case.solve().unwrap();
    let heat: f64 =
        solved.wheels().flat_map(|w| w.contacts()).map(|c| c.dissipation.unwrap()).sum();
    let wear = run(&case, &plan);
    let wheel = worn(&wear, WornBody::WheelRight);
    let right = 5.3e-9 * heat * 1e6 / 7850.0;
    // A few steps of a small depth: the profile is nearly new all along.
    assert!((wheel.volume / right - 1.0).abs() < 0.02, "{:e} {right:e}", wheel.volume);
}

#[test]
fn a_killed_run_goes_on_to_the_same_bits() {
    let rest = "distance = 6e5, stops = 2, step_depth = 1e-4";
    let (case, plan) = read(0.05, "friction = 0.005", "pitch_rate = 21.3", rest);
    let whole = run(&case, &plan);
    assert_eq!(whole.stops.len(), 3);
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join(Wear::STATE);
    // Stopped before every second step.
    let mut stopped = 0;
    let resumed = loop {
        let mut steps = 0;
        let went = wear(&case, &plan, Some(&path), &mut |_, _| {
            steps += 1;
            steps < 2
        });
        match went {
            Err(WearError::Stopped) => stopped += 1,
            other => break other.unwrap(),
        }
        assert!(stopped < 100);
    };
    assert!(stopped >= 2);
    assert_eq!(resumed, whole);
    // A file of somebody else's stays.
    std::fs::write(&path, "my notes").unwrap();
    let refused = wear(&case, &plan, Some(&path), &mut |_, _| true);
    assert!(matches!(refused, Err(WearError::State { .. })));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "my notes");
}

/// Depth after the same distance by steps of half the depth: less than 2 % of the greatest, everywhere.
#[test]
fn half_the_step_leaves_the_same_profile() {
    let depths = [1e-4, 5e-5].map(|step| {
        let rest = format!("distance = 8e5, stops = 1, step_depth = {step:e}");
        let (case, plan) = read(0.05, "friction = 0.005", "pitch_rate = 21.3", &rest);
        let wear = run(&case, &plan);
        let wheel = worn(&wear, WornBody::WheelRight).clone();
        (wheel, wear.stops[1].steps)
    });
    let [(one, steps), (two, more)] = depths;
    assert!(steps >= 2 && more > steps, "{steps} {more}, {:e} m", one.greatest());
    let apart = one.depth.iter().zip(&two.depth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 0.02 * one.greatest(), "{apart:e} of {:e}", one.greatest());
}

/// Second differences of the depth over steps of 1.5 mm, in parts of the greatest depth: how rough it is.
fn roughness(worn: &WornProfile) -> f64 {
    let d = &worn.depth;
    let rough = (6..d.len() - 6).map(|k| (d[k - 6] - 2.0 * d[k] + d[k + 6]).abs());
    rough.fold(0.0, f64::max) / worn.greatest()
}

#[test]
fn ripples_do_not_grow_over_fifty_steps() {
    let (case, plan) = read(
        0.05,
        "friction = 0.005",
        "pitch_rate = 21.3",
        "distance = 4e6, stops = 2, step_depth = 4e-5, smoothing_length = 2e-3",
    );
    let wear = run(&case, &plan);
    assert!(wear.stops[2].steps >= 50, "{}", wear.stops[2].steps);
    let [half, whole] = [1, 2]
        .map(|k| roughness(wear.stops[k].bodies[WornBody::WheelRight as usize].as_ref().unwrap()));
    // Ripples that grow do so by a part in each step: 25 steps would show. The profiles only grow wider.
    assert!(whole <= 1.05 * half, "{half} {whole}");
}
