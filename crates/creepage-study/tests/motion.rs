//! `[motion]` in place of `[creepage]`.

use creepage_study::{AnyCaseFile, GapCaseError};

const BODIES: &str = "
    upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46, radius_lateral = 'flat' }
    lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 'flat', radius_lateral = 0.3 }
    contact = { normal_force = 80e3, friction = 0.3 }
    solve = { theory = 'fastsim' }
";

fn force(text: &str) -> Result<[f64; 3], GapCaseError> {
    let solved = AnyCaseFile::read(text)?.case(".".as_ref())?.solve(None)?;
    let force = solved.force();
    Ok([force.longitudinal, force.lateral, force.moment])
}

#[test]
fn a_wheel_s_motion_is_its_creepage() {
    // The centre goes without saying: it is the radius above the contact.
    let (speed, turn) = (20.0_f64, 20.0 / 0.46 * 1.001_f64);
    let motion = format!(
        "{BODIES}
        [motion]
        contact_velocity = [{speed}, 0, 0]
        upper = {{ velocity = [{speed}, 0.02, 0], angular_velocity = [0, {}, 0.5] }}\n",
        -turn
    );
    let surface = speed - turn * 0.46;
    let mean = (speed - 0.5 * surface).hypot(0.01);
    let creepage = format!(
        "{BODIES}
        [creepage]
        longitudinal = {:e}
        lateral = {:e}
        spin = {:e}\n",
        surface / mean,
        0.02 / mean,
        0.5 / mean
    );
    let [one, two] = [force(&motion).unwrap(), force(&creepage).unwrap()];
    // The creepage by hand is rounded to the same number of digits.
    assert!(
        one.iter().zip(two).all(|(one, two)| (one - two).abs() < 1e-9 * two.abs()),
        "{one:?} {two:?}"
    );
    let case = AnyCaseFile::read(&motion).unwrap().case(".".as_ref()).unwrap();
    assert!((case.speed().unwrap() / mean - 1.0).abs() < 1e-12);
}

#[test]
fn contradictions_and_what_does_not_roll_are_refused() {
    let error = |rest: &str| force(&format!("{BODIES}\n{rest}\n")).unwrap_err().to_string();
    let both = error("motion = { contact_velocity = [1, 0, 0] }\ncreepage = { spin = 0.1 }");
    assert!(both.contains("[motion] upper and [creepage] spin exclude each other"), "{both}");
    let still = error("motion = {}");
    assert!(still.starts_with("[motion] rolling velocity = 0 is not valid"), "{still}");
    let back = error("motion = { contact_velocity = [-1, 0, 0] }");
    assert!(back.contains("rolling direction"), "{back}");
    let key = error("motion = { uper = {} }");
    assert!(key.contains("did you mean `upper`?"), "{key}");
    let inner = error("motion = { upper = { spin = 1 } }");
    assert!(inner.contains("unknown field `spin`"), "{inner}");
}

#[test]
fn bodies_of_any_shape_need_their_centres() {
    let text = "
        upper = { shear_modulus = 82e9, poisson = 0.28 }
        lower = { shear_modulus = 82e9, poisson = 0.28 }
        gap = { polynomial = [[2, 0, 1.1], [0, 4, 5e4]] }
        contact = { normal_force = 40e3, friction = 0.3 }
        solve = { theory = 'fastsim' }
        [motion]
        contact_velocity = [20, 0, 0]
        upper = { velocity = [20, 0, 0], angular_velocity = [0, -43.522, 0] }
    ";
    let error = force(text).unwrap_err().to_string();
    assert_eq!(error, "[motion] upper point is missing");
    let placed = text.replace("upper = { velocity", "upper = { point = [0, 0, -0.46], velocity");
    // 43.522 x .46 = 20.02: the wheel turns a thousandth too fast, and pushes the rail back.
    assert!(force(&placed).unwrap()[0] < -3e3);
}
