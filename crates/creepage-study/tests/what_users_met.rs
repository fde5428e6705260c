//! Inputs that users brought: each is solved, or refused by its true cause, with a warning where one is due.

#![allow(clippy::unwrap_used)]

use std::path::Path;

use creepage::{Status, TheorySpec};
use creepage_study::{
    AnyCaseFile, BulkCase, CaseFile, Caution, GapCaseError, SolvedCase, Solver, Varied,
    WheelsetFile,
};

const STEEL: &str = "[upper]\nshear_modulus = 82e9\npoisson = 0.28\n\
    [lower]\nshear_modulus = 82e9\npoisson = 0.28\n";

fn solve(text: &str) -> Result<SolvedCase, GapCaseError> {
    AnyCaseFile::read(text)?.case(Path::new(""))?.solve(None)
}

fn gap(shape: &str, pressed: &str) -> String {
    format!(
        "{STEEL}[gap]\n{shape}\n[contact]\n{pressed}\nfriction = 0.3\n[creepage]\nlongitudinal = 1e-3\n\
         [solve]\ntheory = \"fastsim\"\n"
    )
}

/// `x^2 - 3 y^2 + 8000 y^4`: two wells at `y = +-13.7 mm`, 281 um deep.
#[test]
fn two_wells_between_higher_places_are_both_found() {
    let shape = "polynomial = [[2, 0, 1.0], [0, 2, -3.0], [0, 4, 8000.0]]";
    let by_load = solve(&gap(shape, "normal_force = 12e3")).unwrap();
    let approach = by_load.approach().value;
    assert!(approach > -2.8125e-4 && approach < -2.3e-4, "{approach}");
    let by_approach = solve(&gap(shape, &format!("approach = {approach:e}"))).unwrap();
    for solved in [&by_load, &by_approach] {
        // Loads alike by symmetry, to the error bars of a load.
        let loads: Vec<f64> =
            solved.areas().unwrap().patches().iter().map(creepage::normal::Patch::load).collect();
        assert_eq!(loads.len(), 2);
        assert!((loads[0] / loads[1] - 1.0).abs() < 1e-3, "{loads:?}");
        assert!((solved.load().value / 12e3 - 1.0).abs() < 5e-3, "{}", solved.load().value);
    }
}

/// A cylinder that is given as far as it is pressed: its ends would bear an infinite pressure.
#[test]
fn a_gap_that_ends_in_the_contact_says_so() {
    let points: Vec<String> = (-30..=30).map(|i| format!("{:e}", 1e-4 * f64::from(i))).collect();
    let flat = vec!["0.0"; points.len()].join(", ");
    let shape = format!(
        "section = {{ y = [{}], gap = [{flat}] }}\nradius_rolling = 5e-3",
        points.join(", ")
    );
    let words = solve(&gap(&shape, "normal_force = 3e3")).unwrap_err().to_string();
    assert!(words.contains("side of the given gap: it does not rise there"), "{words}");
}

fn ball(radius: f64) -> String {
    format!(
        "[upper]\nyoung_modulus = 208e9\npoisson = 0.3\nradius_rolling = 5e-3\nradius_lateral = 5e-3\n\
         [lower]\nyoung_modulus = 208e9\npoisson = 0.3\nradius_rolling = 20e-3\nradius_lateral = {radius:e}\n\
         [contact]\nnormal_force = 400.0\nfriction = 0.07\n[creepage]\nspin = 15.0\n\
         [solve]\nresolution = \"fast\"\n"
    )
}

#[test]
fn a_ball_in_a_close_groove_lacks_the_slip_of_its_curvature() {
    for radius in [-5.2e-3, -5.05e-3] {
        let solved = solve(&ball(radius)).unwrap();
        let slip = solved.cautions.iter().find_map(|caution| match caution {
            Caution::Groove { slip, .. } => Some(*slip),
            _ => None,
        });
        // Half of b^2 times the mean curvature, over both rolling radii: by hand.
        let b = solved.case.hertz().unwrap().ellipse().b();
        let by_hand = 0.25 * b * b * (1.0 / 5e-3 + 1.0 / -radius) * (1.0 / 5e-3 + 1.0 / 20e-3);
        assert!((slip.unwrap() / by_hand - 1.0).abs() < 1e-12, "{slip:?} {by_hand}");
        let units = |caution: &Caution| caution.to_string().contains("check the units");
        assert!(!solved.cautions.iter().any(units), "{:?}", solved.cautions);
    }
    let on_rail = solve(&wheel(80e3, "")).unwrap();
    assert!(!on_rail.cautions.iter().any(|caution| matches!(caution, Caution::Groove { .. })));
}

fn wheel(load: f64, more: &str) -> String {
    format!(
        "[upper]\nshear_modulus = 82e9\npoisson = 0.28\nradius_rolling = 0.46\nradius_lateral = \"flat\"\n\
         [lower]\nshear_modulus = 82e9\npoisson = 0.28\nradius_rolling = \"flat\"\nradius_lateral = 0.3\n\
         [contact]\nnormal_force = {load:e}\nfriction = 0.3\n[creepage]\nlongitudinal = 1e-3\n\
         [solve]\ntheory = \"linear\"\n{more}"
    )
}

#[test]
fn steel_that_flows_is_a_warning_with_its_yield_stress() {
    let yields = |text: &str| {
        let solved = solve(text).unwrap();
        solved.cautions.into_iter().find(|caution| matches!(caution, Caution::Yields { .. }))
    };
    assert_eq!(yields(&wheel(80e3, "")), None);
    let words = yields(&wheel(2e6, "")).unwrap().to_string();
    assert!(words.contains("of a typical rail steel, 300 MPa"), "{words}");
    // 3.33 GPa: 7.8 times 427 MPa.
    assert!(yields(&wheel(2e6, "[damage]\nshear_yield = 420e6\n")).is_some());
    assert_eq!(yields(&wheel(2e6, "[damage]\nshear_yield = 435e6\n")), None);
}

#[test]
fn a_row_without_load_is_no_contact_and_no_force() {
    let file = CaseFile::read(&wheel(80e3, "")).unwrap();
    let case = BulkCase::new(&file, vec![Varied::NormalForce]).unwrap();
    for name in ["polach", "exact"] {
        let solver = Solver::new(TheorySpec::named(name).unwrap());
        let rows = [[80e3], [0.0], [-0.0]];
        let rows: Vec<&[f64]> = rows.iter().map(|row| &row[..]).collect();
        let answers = case.solve(&solver, &rows);
        let status = |k: usize| answers[k].as_ref().unwrap().reply.solution.status;
        assert_eq!([0, 1, 2].map(status), [Status::Solved, Status::NoContact, Status::NoContact]);
        let lifted = answers[1].as_ref().unwrap();
        assert_eq!(lifted.force(), creepage::SiForce::default());
        assert!(lifted.power_per_metre().abs() < f64::MIN_POSITIVE);
        assert!(case.solve_one(&solver, &[-5.0]).is_err());
    }
}

fn wheelset(position: &str, motion: &str) -> Result<creepage_study::WheelsetReport, String> {
    let text = format!(
        "[wheel]\nprofile = \"S1002\"\nradius = 0.46\n[rail]\nprofile = \"UIC60\"\ncant = 0.025\n\
         [track]\ngauge = 1.435\ngauge_height = 0.014\n[wheelset]\nback_to_back = 1.36\n{position}\n\
         [motion]\n{motion}\n[contact]\nfriction = 0.3\n[materials]\nshear_modulus = 82e9\npoisson = 0.28\n\
         [solve]\ntheory = \"fastsim\"\n"
    );
    let file = WheelsetFile::read(&text).map_err(|error| error.to_string())?;
    let case = file.case(Path::new("")).map_err(|error| error.to_string())?;
    case.solve().map_err(|error| error.to_string())
}

#[test]
fn a_wheelset_that_is_none_is_said_to_be_none() {
    let words = |position: &str, motion: &str| {
        wheelset(position, motion).unwrap().caution_words().join("; ")
    };
    let tread = words("y = 0.001\naxle_load = 180e3", "speed = 30.0");
    assert_eq!(tread, "");
    let throat = words("y = 0.0064\naxle_load = 180e3", "speed = 30.0");
    assert!(throat.contains("the surfaces turn by"), "{throat}");
    let riding = words("y = 0.038\nroll = 0.0\naxle_load = 180e3", "speed = 30.0");
    assert!(riding.contains("the flange rides on the rail"), "{riding}");
    let deep = words("y = 0.0\nroll = 0.0\nz = 0.008", "speed = 30.0");
    assert!(deep.contains("mm into each other"), "{deep}");
    let locked = words("y = 0.0\naxle_load = 180e3", "speed = 30.0\npitch_rate = 0.0");
    assert!(locked.contains("spins or is locked") && !locked.contains("per cent"), "{locked}");
}

#[test]
fn rest_is_refused_with_what_to_do() {
    let words = wheelset("y = 0.0\naxle_load = 180e3", "speed = 0.0").unwrap_err();
    assert!(words.contains("at rest nothing rolls") && words.contains("creepage roll"), "{words}");
}

/// Slopes of `fastrip` on areas at creepages too small for a cell to slide: they were 0 at none, and thirty times
/// too large at 1e-8. Its own forces at a hundred times as much are right; slip takes a few per cent of them.
#[test]
fn slopes_of_fastrip_hold_down_to_no_creepage() {
    use creepage::approximate::non_hertzian::{NonHertzianSimplified, Simplified};
    use creepage::gap::{Gap, Term};
    use creepage::normal::{NormalContact, Resolution};
    use creepage::theory::Solved;
    use creepage::{Creepage, Solid, SolidPair};
    let term = |x, y, coefficient| Term { x, y, coefficient };
    let gap = Gap::polynomial(&[term(2, 0, 1.087), term(0, 2, 0.35)]).unwrap();
    let steel = Solid::new(82e9, 0.28).unwrap();
    let pair = SolidPair::new(steel, steel);
    let contact = NormalContact::under_load(&gap, pair, 60e3, Resolution::STANDARD).unwrap();
    let theory = NonHertzianSimplified::new(&contact, 0.3, Simplified::Fastrip, [50, 50]).unwrap();
    let slopes = |size: f64| {
        let creepage = Creepage::new(0.6 * size, 0.8 * size, 0.0).unwrap();
        theory.solve(creepage).jacobian().unwrap()
    };
    let step = 0.04;
    let along = |creepage: [f64; 2]| {
        let creepage = Creepage::new(creepage[0], creepage[1], 0.0).unwrap();
        theory.solve(creepage).solution().force
    };
    let right = [along([step, 0.0]).fx / step, along([0.0, step]).fy / step];
    for size in [0.0, 1e-9, 1e-6, 1e-3, 1e-2] {
        let found = slopes(size);
        for (k, right) in right.into_iter().enumerate() {
            assert!((found[k][k] / right - 1.0).abs() < 0.06, "{size}: {found:?} {right}");
        }
    }
}
