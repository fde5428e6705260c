//! Friction fitted to points that a theory made, with noise whose size is known.
#![allow(clippy::unwrap_used)]

use std::fmt::Write as _;

use creepage_study::{AnyCaseFile, Fit, FitCaution, FitError, FitOptions, MeasuredPoints};

const CASE: &str = "
    upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46, radius_lateral = 'flat' }
    lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 'flat', radius_lateral = 0.3 }
    contact = { normal_force = 80e3, friction = 0.3 }
    creepage = { longitudinal = 0.0, spin = 0.2 }
    solve = { theory = 'fastsim' }
";
const MU: f64 = 0.24;
const SLOPE: f64 = 0.6;
/// Of the normal force.
const NOISE: f64 = 0.004;

fn file(friction: f64) -> AnyCaseFile {
    AnyCaseFile::read(&CASE.replace("friction = 0.3", &format!("friction = {friction}"))).unwrap()
}

/// Normal deviates, the same each time: sums of twelve numbers of a linear congruence.
fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        let mut sum = -6.0;
        for _ in 0..12 {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            sum += (state >> 11) as f64 / (1_u64 << 53) as f64;
        }
        sum
    }
}

/// Forces over the normal force at so many creepages up to `last`, by the theory at `MU`.
fn table(count: u32, last: f64, slope: f64, scatter: f64, seed: u64) -> Vec<[f64; 3]> {
    let case = file(MU).case(".".as_ref()).unwrap();
    let contact = case.contact().unwrap();
    let theory = case.theory().prepare(&contact).unwrap();
    let (scaling, mut deviate) = (contact.scaling(), noise(seed));
    (1..=count)
        .map(|k| {
            let creepage = last * f64::from(k) / f64::from(count);
            let si = creepage::SiCreepage {
                longitudinal: slope * creepage,
                lateral: 0.0,
                spin: slope * 0.2,
            };
            let force = theory.solve(scaling.creepage(si).unwrap()).force;
            [creepage, MU * force.fx + scatter * deviate(), MU * force.fy + scatter * deviate()]
        })
        .collect()
}

fn csv(rows: &[[f64; 3]]) -> MeasuredPoints {
    let rows: Vec<_> = rows.iter().map(|[x, fx, fy]| format!("{x:e},{fx:e},{fy:e}\n")).collect();
    let head = "longitudinal,longitudinal_coefficient,lateral_coefficient\n";
    MeasuredPoints::read(&format!("{head}{}", rows.concat())).unwrap()
}

fn fit(points: &MeasuredPoints, slope: bool) -> Result<Fit, FitError> {
    let file = file(0.3);
    let spec = file.case(".".as_ref()).unwrap().theory().clone();
    Fit::new(&file, ".".as_ref(), &spec, points, FitOptions { slope }, &mut || true)
}

#[test]
fn without_noise_friction_and_slope_are_those_that_made_the_points() {
    let found = fit(&csv(&table(12, 6e-3, SLOPE, 0.0, 1)), true).unwrap();
    // What the last Gauss-Newton step leaves open, of a theory with kinks at its elements.
    assert!((found.friction.value / MU - 1.0).abs() < 1e-4, "{:?}", found.friction);
    let slope = found.slope.unwrap();
    assert!((slope.value / SLOPE - 1.0).abs() < 1e-3, "{slope:?}");
    assert!(found.cautions.is_empty(), "{:?}", found.cautions);
}

#[test]
fn the_interval_holds_the_truth_as_often_as_it_says() {
    const DRAWS: u64 = 60;
    let (mut mu, mut slope) = (0, 0);
    for seed in 0..DRAWS {
        let found = fit(&csv(&table(10, 6e-3, SLOPE, NOISE, seed)), true).unwrap();
        let holds = |interval: [f64; 2], truth: f64| {
            u32::from(interval[0] <= truth && truth <= interval[1])
        };
        mu += holds(found.friction.interval, MU);
        slope += holds(found.slope.unwrap().interval, SLOPE);
    }
    // 95 % of 60 is 57; fewer than 52 has a probability of 3 in 1000. Points left out as bad, one in
    // 16,000 by chance, do not count.
    assert!(mu >= 52 && slope >= 52, "{mu} {slope} of {DRAWS}");
}

#[test]
fn a_bad_point_is_named_and_does_not_move_the_rest() {
    let rows = table(12, 6e-3, 1.0, NOISE, 7);
    let good = fit(&csv(&rows), false).unwrap();
    let mut spoilt = rows.clone();
    spoilt[8][1] = 0.05; // a sensor that hung
    let found = fit(&csv(&spoilt), false).unwrap();
    let bad: Vec<_> =
        found.points.iter().filter(|point| point.bad).map(|point| point.row).collect();
    assert_eq!(bad, [9]);
    assert!(
        matches!(found.cautions[0], FitCaution::Bad { row: 9, deviations } if deviations > 10.0)
    );
    let error = good.friction.standard_error;
    // One point of twelve is missing: its weight is a twelfth.
    assert!((found.friction.value - good.friction.value).abs() < error, "{:?}", found.friction);
    assert!(found.text().contains("row 9"));
}

#[test]
fn points_that_say_nothing_are_refused_or_cautioned() {
    // Nearly without slip: the slope alone is measured, and mu rests on the theory's bend.
    let low = fit(&csv(&table(8, 3e-4, 1.0, 2e-4, 3)), false).unwrap();
    assert!(
        low.cautions.iter().any(|caution| matches!(caution, FitCaution::FarFromSliding { .. }))
    );
    // With the slope free little holds mu: the bend alone.
    let both = fit(&csv(&table(8, 1e-4, 1.0, 1e-3, 3)), true);
    let is_honest = match &both {
        Err(FitError::Undetermined { .. }) => true,
        Ok(found) => {
            let [low, high] = found.friction.interval;
            let is_told =
                |caution: &FitCaution| matches!(caution, FitCaution::FarFromSliding { .. });
            // Wide, and right.
            low < MU && MU < high && high > 1.5 * low && found.cautions.iter().any(is_told)
        }
        Err(_) => false,
    };
    assert!(is_honest, "{both:?}");
    let linear = creepage::TheorySpec::named("linear").unwrap();
    let points = csv(&table(6, 1e-4, 1.0, 0.0, 1));
    let options = FitOptions::default();
    let refused = Fit::new(&file(0.3), ".".as_ref(), &linear, &points, options, &mut || true);
    assert!(matches!(refused, Err(FitError::Undetermined { what: "mu", .. })), "{refused:?}");
    let few = csv(&table(1, 1e-3, 1.0, 0.0, 1));
    assert!(matches!(fit(&few, false), Err(FitError::TooFew { least: 3, .. })));
}

#[test]
fn numbers_in_other_units_are_told() {
    let rows = table(8, 6e-3, 1.0, 0.0, 1);
    let scaled = |creepage: f64, force: f64| {
        let rows: Vec<_> =
            rows.iter().map(|[x, fx, fy]| [creepage * x, force * fx, force * fy]).collect();
        fit(&csv(&rows), false)
    };
    // Forces in kN over a load in N.
    let found = scaled(1.0, 1e-3).unwrap();
    let words = |fit: &Fit| fit.cautions.iter().map(ToString::to_string).collect::<String>();
    assert!(words(&found).contains("check the units of forces and loads"), "{}", found.text());
    // A load in kN under forces in N.
    assert!(matches!(scaled(1.0, 1e3), Err(FitError::BeyondFriction { share }) if share > 100.0));
    // Creepages in per cent; as they are nothing is told.
    let found = scaled(100.0, 1.0).unwrap();
    assert!(words(&found).contains("is above 0.3: it is a ratio"), "{}", found.text());
    let is_of_units = |caution: &FitCaution| {
        matches!(caution, FitCaution::Friction { .. } | FitCaution::Creepage { .. })
    };
    assert!(!scaled(1.0, 1.0).unwrap().cautions.iter().any(is_of_units));
}

#[test]
fn of_three_points_none_is_left_out() {
    let mut rows = table(3, 6e-3, 1.0, 0.0, 1);
    rows[0][1] += 0.02;
    let few: Vec<_> = rows.iter().map(|[x, fx, _]| format!("{x:e},{fx:e}\n")).collect();
    let few = few.concat();
    let measured = MeasuredPoints::read(&format!("longitudinal,longitudinal_coefficient\n{few}"));
    let found = fit(&measured.unwrap(), false).unwrap();
    assert!(found.points.iter().all(|point| !point.bad), "{:?}", found.points);
}

#[test]
fn a_given_uncertainty_counts() {
    // One standard deviation up and down by turns: no point is farther off than another.
    let rows = table(12, 6e-3, 1.0, 0.0, 1);
    let row =
        |([x, fx, _], sign): (&[f64; 3], &f64)| format!("{x:e},{:e},{NOISE}\n", fx + sign * NOISE);
    let text: String = rows.iter().zip([1.0, -1.0].iter().cycle()).map(row).collect();
    let head = "longitudinal,longitudinal_coefficient,uncertainty\n";
    let points = MeasuredPoints::read(&format!("{head}{text}")).unwrap();
    let known = fit(&points, false).unwrap();
    assert!(known.cautions.is_empty(), "{:?}", known.cautions);
    let less = text.replace(&format!(",{NOISE}\n"), &format!(",{}\n", NOISE / 10.0));
    let proud = fit(&MeasuredPoints::read(&format!("{head}{less}")).unwrap(), false).unwrap();
    let scatter = |fit: &Fit| fit.cautions.iter().any(|c| matches!(c, FitCaution::Scatter { .. }));
    assert!(scatter(&proud), "{:?}", proud.cautions);
    // Enlarged to what the points scatter: 12 points on one parameter leave eleven degrees of freedom.
    let share = proud.friction.standard_error / known.friction.standard_error;
    assert!((share - 1.0).abs() < 0.06, "{share}");
}

#[test]
fn another_load_in_each_row_is_its_own_contact() {
    let case = file(MU).case(".".as_ref()).unwrap();
    let mut text = String::from("longitudinal,longitudinal_force,normal_force\n");
    for (k, load) in [40e3, 60e3, 80e3, 100e3, 120e3].into_iter().enumerate() {
        let creepage = 1e-3 * (1 + k) as f64;
        let of_row = CASE
            .replace("friction = 0.3", &format!("friction = {MU}"))
            .replace("longitudinal = 0.0", &format!("longitudinal = {creepage}"))
            .replace("80e3", &format!("{load}"));
        let solved = AnyCaseFile::read(&of_row).unwrap().case(".".as_ref()).unwrap();
        let force = solved.solve(Some(case.theory())).unwrap().force();
        writeln!(text, "{creepage:e},{:e},{load}", force.longitudinal).unwrap();
    }
    let found = fit(&MeasuredPoints::read(&text).unwrap(), false).unwrap();
    assert!((found.friction.value / MU - 1.0).abs() < 1e-4, "{:?}", found.friction);
    assert!(found.svg().contains("theory"));
}

#[test]
fn what_is_stopped_says_so() {
    let (file, points) = (file(0.3), csv(&table(6, 6e-3, 1.0, 0.0, 1)));
    let spec = file.case(".".as_ref()).unwrap().theory().clone();
    let stopped =
        Fit::new(&file, ".".as_ref(), &spec, &points, FitOptions::default(), &mut || false);
    assert!(matches!(stopped, Err(FitError::Interrupted)));
}
