//! Tests of the wear loop against closed forms.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::Path;

use creepage::damage::TGamma;
use creepage::{SiCreepage, SiForce};

use super::run::step;
use super::state::State;
use super::*;
use crate::wheelset::{WheelsetCase, WheelsetFile, WheelsetFileError};

/// One right wheel, radius .46 m at the tape circle, on a rail with a round head. Little friction, so that all
/// slides. Wear is mild wherever slip is slower than .2 m/s.
struct Setup<'a> {
    wheel: String,
    /// Radius of the rail's head (m), and how much of it there is to both sides (rad).
    head: [f64; 2],
    load: f64,
    friction: f64,
    motion: &'a str,
    grid: [u32; 2],
    wear: String,
}

impl Setup<'_> {
    /// A cone, its radius falling by `cone` to the field side.
    fn cone(cone: f64, wear: &str) -> Self {
        Self {
            wheel: format!("[[0.06, {:?}], [-0.06, {:?}]]", -0.06 * cone, 0.06 * cone),
            head: [0.08, 0.4],
            load: 20e3,
            friction: 0.005,
            motion: SLIDES,
            grid: [30, 50],
            wear: wear.to_owned(),
        }
    }

    fn read(&self) -> (WheelsetCase, WearPlan) {
        self.plan().unwrap()
    }

    fn tried(&self) -> Result<Wear, WearError> {
        let (case, plan) = self.plan()?;
        wear(&case, &plan, None, &mut |_, _| true)
    }

    fn plan(&self) -> Result<(WheelsetCase, WearPlan), WearError> {
        let ([radius, half], [along, across]) = (self.head, self.grid);
        let mut head = String::new();
        for t in (-80..=80).map(|k: i32| f64::from(k) / 80.0 * half) {
            write!(head, "[{:.15}, {:.15}],", radius * t.sin(), radius * (1.0 - t.cos())).unwrap();
        }
        let text = format!(
            "wheel = {{ points = {}, radius = 0.46, flange_back = -0.07 }}
            rail = {{ points = [{head}] }}
            track = {{ rail_position = 0.75 }}
            wheelset = {{ back_to_back = 1.36, side = 'right', roll = 0.0, wheel_load = {:?} }}
            motion = {{ {} }}
            contact = {{ friction = {:?} }}
            materials = {{ shear_modulus = 82e9, poisson = 0.28 }}
            damage = {{ archard = {{ mild = 3e-4, hardness = 2.7e9 }} }}
            solve = {{ theory = 'fastsim', grid = [{along}, {across}] }}
            wear = {{ {} }}",
            self.wheel, self.load, self.motion, self.friction, self.wear
        );
        let file = WheelsetFile::read(&text).map_err(WheelsetFileError::from)?;
        let case = file.case(Path::new(""))?;
        let plan = file.wear(&case, Path::new(""))?;
        Ok((case, plan))
    }

    fn run(&self) -> Wear {
        self.tried().unwrap()
    }
}

/// Two parts of a hundred of the mean speed less, .02 m/s.
const SLIDES: &str = "speed = 1.0, pitch_rate = 2.130_865_26";

fn worn(wear: &Wear, body: WornBody) -> &WornProfile {
    wear.stops.last().unwrap().of(body).unwrap()
}

/// Linear between the points of a wheel, which run to the flange.
fn depth_at(worn: &WornProfile, y: f64) -> f64 {
    let k = worn.points.partition_point(|point| point[0] > y);
    let ([from, _], [to, _]) = (worn.points[k - 1], worn.points[k]);
    let part = (y - from) / (to - from);
    worn.depth[k - 1] + part * (worn.depth[k] - worn.depth[k - 1])
}

/// The contact of the closed forms: `a` 7.192892, `b` 5.410653 mm, peak 1.22684e9 Pa, a slip of .002 at 10 m/s.
fn on_a_wide_head(wear: &str) -> Setup<'static> {
    let motion = "speed = 10.0, pitch_rate = 21.695673848";
    Setup { head: [0.3, 0.12], load: 100e3, motion, ..Setup::cone(0.0, wear) }
}

/// Full sliding of a cylinder: `d(0) = (pi/2) a (k ups/H) p0 = 3.080343 nm` for each passage, volume
/// `k ups N/H` for each metre. So short a distance that the contact stays what it is: 4 um of depth would flatten
/// the head by a part in twelve.
#[test]
fn a_cylinder_wears_as_the_closed_form_says() {
    let wear =
        "body = 'both', distance = 10.0, passages = 10.0, stops = 1, smoothing_length = 1e-4";
    let wear = on_a_wide_head(wear).run();
    let (rail, wheel) = (worn(&wear, WornBody::RailRight), worn(&wear, WornBody::WheelRight));
    let volume = 10.0 * 3e-4 * 2e-3 * 100e3 / 2.7e9;
    // Of 30 cells the first and the last slide by .2 to .3 % less: elastic slip by differences.
    for (found, right) in [
        (rail.greatest(), 10.0 * 3.080_343e-9),
        (wheel.greatest(), 10.0 * 3.080_343e-9 / (TAU * 0.46)),
        (rail.area, volume),
        (rail.volume, volume),
        (wheel.volume, volume),
        (wheel.area * TAU * 0.46, volume),
    ] {
        assert!((found / right - 1.0).abs() < 4e-3, "{found:e} {right:e} {}", found / right);
    }
}

/// Positions of a cylinder normally distributed, sd 3 mm: the depth of one place spread by the bell, .7301820 of
/// its peak, .2308537 at 6 mm (quadrature), and the same volume.
#[test]
fn spread_positions_spread_the_depth() {
    let wear =
        "distance = 10.0, stops = 1, smoothing_length = 1e-4, spread = { y = 3e-3, places = 25 }";
    let setup = on_a_wide_head(wear);
    let plan = setup.read().1;
    assert_eq!(plan.situations.len(), 25);
    let sum: f64 = plan.situations.iter().map(|situation| situation.share).sum();
    assert!((sum - 1.0).abs() < 1e-12);
    let wear = setup.run();
    let wheel = worn(&wear, WornBody::WheelRight);
    let peak = 3.080_343e-9 * 10.0 / (TAU * 0.46);
    // The bell is cut at three standard deviations, .27 % of it; the depth of one place is off by .3 %.
    for (y, part) in [(0.0, 0.730_182_0), (0.006, 0.230_853_7), (-0.006, 0.230_853_7)] {
        let depth = depth_at(wheel, y);
        assert!((depth / (part * peak) - 1.0).abs() < 6e-3, "{y} {}", depth / (part * peak));
    }
    let volume = 10.0 * 3e-4 * 2e-3 * 100e3 / 2.7e9;
    assert!((wheel.volume / volume - 1.0).abs() < 4e-3, "{}", wheel.volume);
}

/// A cylinder under a constant line load `w`: `2 pi r dr = -k ups(r) w dL/H`. Even positions over 32 mm on a narrow
/// head make the line load in the middle of the band; its edges, which grow round, are far from there.
#[test]
fn a_cylinder_under_a_line_load_loses_what_its_equation_says() {
    let mut places = String::new();
    for k in -16..=16 {
        write!(places, "{{ y = {k}e-3, share = 1.0 }},").unwrap();
    }
    let distance = 1e7;
    let wear = format!("distance = {distance:e}, stops = 1, situation = [{places}]");
    let setup = Setup { head: [0.03, 0.7], load: 2e3, ..Setup::cone(0.0, &wear) };
    let wear = setup.run();
    let wheel = worn(&wear, WornBody::WheelRight);
    assert!(wear.stops[1].steps >= 5, "{}", wear.stops[1].steps);
    let ups = |r: f64| (1.0 - 2.130_865_26 * r) / (0.5 * (1.0 + 2.130_865_26 * r));
    let load = 2e3 / 33.0 / 1e-3;
    // The distance for this depth, by Simpson's rule over a smooth function.
    let depth = depth_at(wheel, 0.0);
    let slope = |r: f64| TAU * r * 2.7e9 / (3e-4 * ups(r) * load);
    let parts = 20;
    let step = depth / f64::from(parts);
    let needed: f64 = (0..parts)
        .map(|k| 0.46 - step * f64::from(k))
        .map(|r| step / 6.0 * (slope(r) + 4.0 * slope(r - 0.5 * step) + slope(r - step)))
        .sum();
    // Elastic slip over 30 cells: .3 %.
    assert!((needed / distance - 1.0).abs() < 4e-3, "{depth:e} {}", needed / distance);
}

/// Mild wear by energy: 5.3e-9 kg/J of what friction turns to heat, the forces times the creepages of a cone that
/// rolls freely, which spins. And the same on cells and points half as large.
#[test]
fn a_free_cone_loses_its_heat() {
    let free = |grid, spacing: f64| Setup {
        friction: 0.3,
        motion: "speed = 10.0, pitch_rate = 'free'",
        grid,
        wear: format!(
            "law = 'usfd', distance = 1e6, stops = 1, spacing = {spacing:e}, spread = {{ y = 2e-3 }}"
        ),
        ..Setup::cone(0.05, "")
    };
    let coarse = free([30, 50], 2.5e-4);
    let (case, _) = coarse.read();
    let solved = case.solve().unwrap();
    let heat = |contact: &crate::SolvedContact| {
        let SiForce { longitudinal, lateral, moment } = contact.force;
        let own = contact.creepage;
        let creepage =
            SiCreepage { longitudinal: own.longitudinal, lateral: own.lateral, spin: own.spin };
        TGamma::power_per_metre(SiForce { longitudinal, lateral, moment }, creepage)
    };
    let heat: f64 = solved.wheels().flat_map(crate::SolvedWheel::contacts).map(heat).sum();
    let [one, two] = [coarse, free([60, 100], 1.25e-4)].map(|setup| setup.run());
    let [one, two] = [&one, &two].map(|wear| worn(wear, WornBody::WheelRight));
    let right = 5.3e-9 * heat * 1e6 / 7850.0;
    // FASTSIM's own balance of energy over 30 cells in rows of which few slide.
    assert!((one.volume / right - 1.0).abs() < 0.05, "{:e} {right:e}", one.volume);
    assert!((one.volume / two.volume - 1.0).abs() < 0.01, "{:e} {:e}", one.volume, two.volume);
    let apart = (one.greatest() / two.greatest() - 1.0).abs();
    assert!(apart < 0.01, "{:e} {:e}", one.greatest(), two.greatest());
}

/// Several steps of a cone in positions that differ.
fn long(rest: &str) -> Setup<'static> {
    Setup::cone(0.05, &format!("spread = {{ y = 4e-3, places = 5 }}, {rest}"))
}

/// Distances (m) for half a millimetre by each law.
const LAWS: [(&str, f64); 2] = [("archard", 6e5), ("usfd", 2e7)];

#[test]
fn a_killed_run_goes_on_to_the_same_bits() {
    let (case, plan) = long("distance = 4e5, stops = 2").read();
    let whole = wear(&case, &plan, None, &mut |_, _| true).unwrap();
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
    // What another case left stays.
    let (other, its_plan) = long("distance = 5e5, stops = 2").read();
    let refused = wear(&other, &its_plan, Some(&path), &mut |_, _| true);
    assert!(matches!(refused, Err(WearError::OtherRun { steps: 1.., .. })), "{refused:?}");
    // A file of somebody else's stays.
    std::fs::write(&path, "my notes").unwrap();
    let refused = wear(&case, &plan, Some(&path), &mut |_, _| true);
    assert!(matches!(refused, Err(WearError::State { .. })));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "my notes");
}

/// Depth after the same distance by steps of half the depth: less than 2 % of the greatest, everywhere.
#[test]
fn half_the_step_leaves_the_same_profile() {
    for (law, distance) in LAWS {
        let [(one, steps), (two, more)] = [3e-5, 1.5e-5].map(|step| {
            let rest =
                format!("law = '{law}', distance = {distance}, stops = 1, step_depth = {step:e}");
            let wear = long(&rest).run();
            (worn(&wear, WornBody::WheelRight).clone(), wear.stops[1].steps)
        });
        assert!(steps >= 2 && more > steps, "{law} {steps} {more}, {:e} m", one.greatest());
        let pairs = one.depth.iter().zip(&two.depth);
        let apart = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 0.02 * one.greatest(), "{law} {apart:e} of {:e}", one.greatest());
    }
}

/// How rough a profile is in the middle of the band: the greatest second difference over 2 mm less their mean,
/// which is that of a round (m).
fn roughness(worn: &WornProfile) -> f64 {
    let inner: Vec<_> = worn.points.iter().filter(|[y, _]| (y + 4e-3).abs() < 4e-3).collect();
    let second = inner.windows(9).map(|w| w[0][1] - 2.0 * w[4][1] + w[8][1]);
    let second: Vec<f64> = second.collect();
    let mean = second.iter().sum::<f64>() / second.len() as f64;
    second.iter().map(|one| (one - mean).abs()).fold(0.0, f64::max)
}

/// A cone whose points are off by up to .5 um, 1 mm apart, through fifty steps: with smoothing that is long enough,
/// and with one that is too short: then steps are shorter, with a caution.
#[test]
fn noise_in_the_profile_does_not_grow_over_fifty_steps() {
    // A linear congruential generator (Knuth's), so that the noise is the same in every run.
    let mut state = 1967_u64;
    let mut noise = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let mut wheel = String::from("[");
    for y in (-60..=60).map(|k: i32| -1e-3 * f64::from(k)) {
        write!(wheel, "[{y:.4}, {:.9}],", -0.05 * y + 1e-6 * noise()).unwrap();
    }
    wheel.push(']');
    // An even band, in whose middle, 4 mm towards the flange, a straight profile stays straight.
    let mut band = String::new();
    for k in -12..=12 {
        write!(band, "{{ y = {k}e-3, share = 1.0 }},").unwrap();
    }
    for (smoothing, step, distance) in [(2e-3, 8e-6, 8e5), (2e-4, 1e-4, 8e5)] {
        let rest = format!(
            "distance = {distance:e}, stops = 2, step_depth = {step:e}, smoothing_length = {smoothing:e}, \
             situation = [{band}]"
        );
        let wear = Setup { wheel: wheel.clone(), ..Setup::cone(0.05, &rest) }.run();
        let [new, half, whole] =
            [0, 1, 2].map(|k| roughness(wear.stops[k].bodies[1].as_ref().unwrap()));
        assert!(wear.stops[2].steps >= 50, "{}", wear.stops[2].steps);
        assert!(new > 5e-7, "{new:e}");
        assert!(half <= 1.02 * new && whole <= 1.02 * new, "{new:e} {half:e} {whole:e}");
        let short = wear.cautions.iter().any(|words| words.contains("smoothing_length"));
        assert_eq!(short, smoothing < 1e-3, "{:?}", wear.cautions);
    }
}

/// What is gone from the profiles is what the contacts took, to rounding, over many steps of both bodies; fully
/// sliding, `k ups N/H` for each metre, with the slip of the depth.
#[test]
fn the_volume_is_that_of_the_contacts() {
    for (law, distance) in LAWS {
        let rest = format!(
            "law = '{law}', body = 'both', distance = {distance}, passages = {}, stops = 2",
            0.05 * distance
        );
        let (case, plan) = long(&rest).read();
        let mut run = State::new(&case, &plan);
        run.stops.push(run.now(&case, &plan).unwrap());
        while run.part < 1.0 {
            step(&case, &plan, &mut run, 1.0).unwrap();
        }
        assert!(run.steps >= 3, "{}", run.steps);
        // 1e-6 is asked for; what is left is rounding.
        let off = run.bodies.imbalance();
        assert!(off < 1e-10, "{off:e}");
        let wheel = run.bodies.of(WornBody::WheelRight).unwrap();
        if law == "archard" {
            // Slip grows with the depth where contact is; radius of the cone over the band, elastic slip: 1 %.
            let ups = |depth: f64| (1.0 - 2.130_865_26 * (0.46 - depth)) / 0.99;
            let volume = |depth: f64| 3e-4 * ups(depth) * 20e3 * distance / 2.7e9;
            let deepest = wheel.depth.iter().copied().fold(0.0, f64::max);
            let (least, most) = (volume(0.0), volume(deepest));
            assert!(
                wheel.volume > 0.99 * least && wheel.volume < 1.01 * most,
                "{} {least} {most}",
                wheel.volume
            );
        }
    }
}

/// Depth grows evenly while the contact stays what it is: the run ends where its limit is met, and says why.
#[test]
fn a_run_ends_at_its_limit() {
    let wear = "distance = 1e4, stops = 4, smoothing_length = 1e-4";
    let whole = on_a_wide_head(wear).run();
    let of = |wear: &Wear| worn(wear, WornBody::WheelRight).greatest();
    assert!(whole.ended.is_none());
    let limit = 0.6 * of(&whole);
    let ended = on_a_wide_head(&format!("{wear}, limits = {{ depth = {limit:e} }}")).run();
    let end = ended.ended.unwrap();
    assert_eq!((end.measure, end.body), (WearMeasure::Depth, Some(WornBody::WheelRight)));
    // The step ends where the depth, linear within it, meets the limit; it bends by a part in a thousand at most,
    // as the rate between its first and its last quarter shows.
    let bend = {
        let depth = |k: usize| whole.stops[k].of(WornBody::WheelRight).unwrap().greatest();
        (depth(1) / (depth(4) - depth(3)) - 1.0).abs()
    };
    assert!((of(&ended) / limit - 1.0).abs() < bend.max(1e-6), "{} {limit} {bend}", of(&ended));
    let way = ended.stops.last().unwrap().distance;
    assert!(way > 5e3 && way < 7.5e3, "{way}");
    assert!(ended.text().contains("depth of wheel_right reaches the limit of"), "{}", ended.text());
    assert_eq!(ended.stops.len(), 4);
}

/// A new wheel that is past its limit, and one without a flange, are told before the run.
#[test]
fn limits_that_cannot_be_kept_are_refused() {
    for (limits, said) in
        [("depth = 0.0", "depth"), ("hollow = 1e-3", "flange"), ("hight = 1.0", "hight")]
    {
        let wear = format!("distance = 10.0, stops = 1, limits = {{ {limits} }}");
        let setup = on_a_wide_head(&wear);
        let refused = setup.tried().unwrap_err();
        assert!(refused.to_string().contains(said), "{refused}");
        assert!(refused.is_wrong_input());
    }
}
