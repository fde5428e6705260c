//! Cases of two bodies (module 3).

use creepage_import::ImportError;

use crate::{ball, has, head, read, text};

#[test]
fn a_ball_that_rolls_has_si_units_and_our_signs() {
    let file =
        ball("203110", "1000. 0.5 .001 .0002", "0.0 0.2 2000. CHI") + " 0 MODULE\n nonsense\n";
    let imported = read(&file).unwrap();
    assert_eq!(imported.cases.len(), 1);
    let case = &imported.cases[0];
    assert_eq!(case.name, "own-1");
    assert_eq!(case.written.as_ref().unwrap().command, "creepage solve own-1.toml");
    has(
        &text(case, 0),
        &[
            "shear_modulus = 82000000000.0",
            "radius_rolling = 0.1",
            "radius_lateral = \"flat\"",
            "normal_force = 1000.0",
            "lateral = 0.001",
            "spin = 0.2",
            "speed = 2.0",
            "fx = -0.5",
        ],
    );
}

#[test]
fn rolling_backwards_turns_the_axes() {
    let file = ball("203100", "1000. .002 .001 .0002", "180d 0.2 2000. CHI");
    let imported = read(&file).unwrap();
    has(&text(&imported.cases[0], 0), &["longitudinal = -0.002", "lateral = -0.001", "spin = 0.2"]);
}

#[test]
fn what_is_left_out_stays_and_the_next_case_may_follow_without_its_module() {
    let first =
        ball("203100", "1000. .002 .0 .0", "0.0 0.2 2000. CHI").replace("0000341", "0000340");
    let file = first + " 203100 PBTNFS\n 100000 LDCMZE\n 0100341 HGIAOWR\n 2000. .003 .0 .0\n";
    let imported = read(&file).unwrap();
    assert_eq!(imported.cases.len(), 2);
    let second = text(&imported.cases[1], 0);
    has(&second, &["normal_force = 2000.0", "longitudinal = 0.003", "radius_rolling = 0.1"]);
    has(&second, &["friction = 0.3"]);
}

#[test]
fn a_shift_goes_to_statics_and_steps_after_it_to_roll() {
    let shift = ball("201120", "1000. -.5 .25 .0", "").replace(" \n", "");
    let step = head("002120", "122020")
        + " 1000. -.5 .25 .0 load\n 0.0 0.1 2000. CHI\n .28 .28 82000. 82000.\n 1 IPOTCN\n \
           9 9 -0.9 -0.9 0.2 0.2\n 1 1\n .005 .0 .005 .0 .0 .0\n";
    let imported = read(&(shift + &step)).unwrap();
    // 0.3 x 1000 N, with the other sign.
    has(&text(&imported.cases[0], 0), &["force_x = 150.0", "force_y = -75.0"]);
    has(&text(&imported.cases[1], 0), &["traction = \"shift\"", "longitudinal_force = 150.0"]);
    let rows = text(&imported.cases[1], 1);
    assert_eq!(rows, "distance,longitudinal_force,lateral_force\n0.0001,150.0,-75.0\n");
}

/// Ways add up from case to case, forces do not; what follows takes the cases before it along.
#[test]
fn shifts_by_ways_and_after_each_other_are_a_path() {
    let one = |first: &str, kinematics: &str| ball(first, kinematics, "").replace(" \n", "");
    let ways = one("201100", "1000. .002 .0 .0") + &one("001100", "1000. -.003 .0 .0");
    let imported = read(&ways).unwrap();
    let keys = ["problem = \"shift-path\"", "along = \"x\""];
    has(&text(&imported.cases[0], 0), &[&keys[..], &["steps = [{ shift = 2e-6 }]"]].concat());
    let steps = "steps = [{ shift = 2e-6 }, { shift = -1e-6 }]";
    has(&text(&imported.cases[1], 0), &[&keys[..], &[steps]].concat());
    let forces = one("201120", "1000. .0 -.5 .0") + &one("001120", "1000. .0 .25 .0");
    let imported = read(&forces).unwrap();
    has(
        &text(&imported.cases[1], 0),
        &["along = \"y\"", "steps = [{ force = 150.0 }, { force = -75.0 }]"],
    );
    // A load that falls meanwhile, or grows before; forces are relative to friction under it.
    for (second, steps) in [
        (
            "900. .0 .25 .0",
            "{ normal_force = 1000.0, force = 0.0 }, { force = 150.0 }, { normal_force = 900.0, force = -67.5 }",
        ),
        (
            "1200. .0 .25 .0",
            "{ normal_force = 1000.0, force = 150.0 }, { normal_force = 1200.0, force = 150.0 }, { force = -90.0 }",
        ),
    ] {
        let file = one("201120", "1000. .0 -.5 .0") + &one("001120", second);
        let imported = read(&file).unwrap();
        let written = text(&imported.cases[1], 0);
        // The first step goes to its own load from that of the last, with nothing to shift.
        has(&written, &[&format!("steps = [{steps}]")[..]]);
    }
    // Another axis.
    let file = one("201120", "1000. .0 -.5 .0") + &one("001120", "1000. .25 .0 .0");
    let imported = read(&file).unwrap();
    let found = imported.cases[1].written.as_ref().unwrap_err().to_string();
    assert!(found.contains("its axis"), "{found}");
}

/// Steps by force, then by creepage; the ellipse by its axes, then by a curvature of four digits.
#[test]
fn rolling_by_forces_goes_on_by_creepages() {
    // Hertz: a = (1.5 N (1 - nu)/G R)^(1/3), R = 1/(2 A).
    let shape = |by: &str| format!(" .28 .28 1. 1. material\n {by}\n");
    let first = head("202110", "022020")
        + " 0.7563 0.657 .0 .0\n .4 .4\n 0. .2 1000. CHI\n"
        + &shape("-3\n 41 41 4.1 4.1 1.17");
    let second = head("002100", "022020")
        + " 0.7563 -.002 .0 .0\n .4 .4\n 0. .8 1000. CHI\n"
        + &shape("-2\n 41 41 .002963 1. 1.17");
    let imported = read(&(first.clone() + &second)).unwrap();
    let rows = text(&imported.cases[1], 1);
    let mut lines = rows.lines();
    assert_eq!(lines.next(), Some("distance,longitudinal_force,longitudinal"));
    let cells: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!([cells[0][0], cells[0][2]], ["0.0002", ""]);
    assert_eq!(cells[1], ["0.001", "", "-0.002"]);
    assert!(imported.cases[1].notes.iter().any(|note| note.contains("to a thousandth")));
    // Another shape is one.
    let other = second.replace(".002963 1.", ".0031 1.");
    let imported = read(&(first + &other)).unwrap();
    let cause = imported.cases[1].written.as_ref().unwrap_err().to_string();
    assert!(cause.contains("the shape changes"), "{cause}");
}

#[test]
fn a_line_that_is_not_what_the_digits_say_is_named() {
    let file =
        ball("203100", "1000. .002 .001 .0002", "0.0 0.2 2000. CHI").replace(" 0.3 0.3", " mu");
    let error = read(&file).unwrap_err();
    assert!(matches!(error, ImportError::Line { line: 7, .. }), "{error}");
    let error = read(" 3 MODULE\n 203100\n").unwrap_err();
    assert!(matches!(error, ImportError::End { .. }), "{error}");
    assert!(matches!(read("% nothing\n"), Err(ImportError::Empty)));
    assert!(matches!(read(" 7 MODULE\n"), Err(ImportError::Line { line: 1, .. })));
}

#[test]
fn a_case_without_a_counterpart_is_named_and_the_others_are_written() {
    let file = ball("201100", "1000. .002 .0 .1", "").replace(" \n", "")
        + &ball("203100", "1000. .002 .001 .0002", "0.0 0.2 2000. CHI");
    let imported = read(&file).unwrap();
    let cause = imported.cases[0].written.as_ref().unwrap_err().to_string();
    assert!(cause.contains("with a twist"), "{cause}");
    assert!(imported.cases[1].written.is_ok());
}

/// A ball whose middle is at a place along x (mm), shifted (T = 1) from rest or from the case before.
fn ball_at(place: f64, first: &str, kinematics: &str) -> String {
    let shape = format!(".005 .0 .005 {:.7} .0 {:.7} shape", -0.01 * place, 0.005 * place * place);
    let ball = ball(first, kinematics, "").replace(" \n", "");
    ball.replace(".005 .0 .005 .0 .0 .0 shape", &shape)
}

/// In axes that stand still, a shape that moves on from shift to shift rolls.
#[test]
fn a_shape_that_moves_from_shift_to_shift_rolls() {
    let start = ball_at(0.0, "201110", "1000. -.5 .0 .0");
    let next = |place: f64| ball_at(place, "001110", "1000. -.5 .0 .0");
    let file = start.clone() + &next(0.25) + &next(0.4);
    let imported = read(&file).unwrap();
    let last = imported.cases.last().unwrap();
    let command = "creepage roll own-3.toml --history own-3.csv";
    assert_eq!(last.written.as_ref().unwrap().command, command);
    let keys = ["traction = \"shift\"", "longitudinal_force = 150.0", "radius_rolling = 0.1"];
    has(&text(last, 0), &keys);
    let table = "distance,longitudinal_force\n0.00025,150.0\n0.0004,150.0\n";
    assert_eq!(text(last, 1), table);

    // Towards -x, our axes turn with it.
    let imported = read(&(start.clone() + &next(-0.25))).unwrap();
    has(&text(&imported.cases[1], 0), &["longitudinal_force = -150.0"]);
    assert_eq!(text(&imported.cases[1], 1), "distance,longitudinal_force\n0.00025,-150.0\n");

    // A shift as a way: over that of the shape it is a creepage.
    let way = ball_at(0.0, "201100", "1000. .0 .0 .0");
    let imported = read(&(way + &ball_at(0.2, "001100", "1000. .001 -.0004 .0"))).unwrap();
    has(&text(&imported.cases[1], 0), &["traction = \"none\""]);
    assert_eq!(text(&imported.cases[1], 1), "distance,longitudinal,lateral\n0.0002,0.005,-0.002\n");

    for (further, cause) in [
        (next(0.25) + &next(0.1), "to and fro"),
        (next(0.25) + &next(0.25), "not one of rolling steps"),
        (next(0.25).replace("0.3 0.3", "0.2 0.2"), "friction or the bodies change"),
    ] {
        let imported = read(&(start.clone() + &further)).unwrap();
        let found = imported.cases.last().unwrap().written.as_ref().unwrap_err().to_string();
        assert!(found.contains(cause), "{found}");
    }
}

/// The first step sets out from the load of the shift before it; shifts that go on add nothing.
#[test]
fn rolling_sets_out_from_the_last_shift() {
    let step = head("002110", "102000")
        + " 900. -.5 .0 .0 load\n 0.0 0.1 2000. CHI\n .28 .28 82000. 82000.\n";
    let first = ball_at(0.0, "201110", "1000. -.2 .0 .0");
    let file = first.clone() + &ball_at(0.0, "001110", "1000. -.5 .0 .0") + &step;
    let imported = read(&file).unwrap();
    let rolls = &imported.cases[2];
    has(&text(rolls, 0), &["normal_force = 1000.0", "longitudinal_force = 150.0"]);
    assert_eq!(text(rolls, 1), "distance,normal_force,longitudinal_force\n0.0001,900.0,135.0\n");
    let back = first + &ball_at(0.0, "001110", "1000. .1 .0 .0") + &step;
    let found = read(&back).unwrap().cases[2].written.clone().unwrap_err().to_string();
    assert!(found.contains("a load path before"), "{found}");
}

#[test]
fn flexibilities_that_fall_with_creepage_are_a_reduction() {
    let simplified = |third: &str, changes: &str| {
        let ball = ball(third, "1000. .002 .0 .0", "0.0 0.2 2000. CHI").replace("022020", "022320");
        ball.replace("82000. material\n", &format!("82000. material\n {changes} K0_MF\n"))
    };
    let written = |file: &str| read(file).unwrap().cases[0].written.clone();
    let imported = read(&simplified("233100", ".54 .02 .62")).unwrap();
    let keys = ["theory = \"fastsim\"", "bound = \"parabolic\"", "reduction = [0.54, 0.02, 0.62]"];
    has(&text(&imported.cases[0], 0), &keys);
    let clean = read(&simplified("233100", "1. 1. 3.")).unwrap();
    assert!(!text(&clean.cases[0], 0).contains("reduction"));
    let found = written(&simplified("233110", ".54 .02 .62")).unwrap_err().to_string();
    assert!(found.contains("to a wanted force"), "{found}");
}

/// Spence: unlike balls under a load that grows are one problem of statics, whatever the steps.
#[test]
fn unlike_balls_pressed_together_are_a_compression() {
    let unlike = |first: &str, load: &str| {
        let ball = ball(first, load, "").replace(" \n", "");
        ball.replace("0.28 0.28 82000. 82000.", "0. 0. .5 100000.")
    };
    let file = unlike("201100", "1. .0 .0 .0") + &unlike("001100", "2. .0 .0 .0");
    let imported = read(&file).unwrap();
    let case = &imported.cases[1];
    assert_eq!(case.written.as_ref().unwrap().command, "creepage statics own-2.toml");
    let keys = ["problem = \"compression\"", "normal_force = 2.0", "friction = 0.3"];
    has(&text(case, 0), &keys);
    let back = file + &unlike("001100", "1.5 .0 .0 .0");
    let found = read(&back).unwrap().cases[2].written.clone().unwrap_err().to_string();
    assert!(found.contains("a load that grows"), "{found}");
    let long = unlike("201100", "1. .0 .0 .0").replace(".005 .0 .005", ".005 .0 .004");
    let found = read(&long).unwrap().cases[0].written.clone().unwrap_err().to_string();
    assert!(found.contains("other than balls"), "{found}");
}

/// Words of a case with a material's second line, `M` = 4.
fn with_layer(first: &str, kinematics: &str, rolling: &str, grid: &str) -> String {
    let rolling = if rolling.is_empty() { String::new() } else { format!(" {rolling}\n") };
    head(first, "022420")
        + &format!(
            " {kinematics} load\n 0.7 0.7 friction\n{rolling} 0.28 0.28 82000. 82000. material\n \
             106.25 .02 200. 435. layer\n {grid}\n"
        )
}

/// One element, of the size of the box around its ellipse, sheared from case to case: ways add up.
#[test]
fn a_single_element_is_sheared_to_and_fro() {
    let square = "-3 IPOTCN\n 1 1 .5 .25 1.2 grid";
    let one = |first: &str, way: &str| with_layer(first, &format!("900. {way} .0 .0"), "", square);
    let imported = read(&(one("201100", "-.04") + &one("001100", ".01"))).unwrap();
    let second = &imported.cases[1];
    assert!(second.written.as_ref().unwrap().command.starts_with("creepage statics"));
    has(
        &text(second, 0),
        &[
            "problem = \"sheared-rectangle\"",
            "half_length_rolling = 0.0006",
            "half_length_lateral = 0.0003",
            "thickness = 2e-5",
            "slope = 435000000000.0",
            "along = \"x\"",
            "steps = [{ shift = -4e-5 }, { shift = -3e-5 }]",
        ],
    );
    // A given force, over mu N, with the other sign.
    let imported = read(&with_layer("201110", "900. .5 .0 .0", "", square)).unwrap();
    has(&text(&imported.cases[0], 0), &["steps = [{ force = -315.0 }]"]);
    for (first, kinematics, rolling, grid, cause) in [
        ("201000", ".001 .01 .0 .0", "", square, "at a given approach"),
        ("203100", "900. .01 .0 .0", "0.0 0.2 2000. CHI", square, "rolling of a single element"),
        ("200100", "900. .0 .0 .0", "", square, "not sheared"),
        ("201100", "900. .01 .01 .0", "", square, "along one axis"),
        (
            "201100",
            "900. .01 .0 .0",
            "",
            "-1 IPOTCN\n 1 1 .5 .25 1.2 grid",
            "an ellipse that is sought",
        ),
    ] {
        let imported = read(&with_layer(first, kinematics, rolling, grid)).unwrap();
        let refused = imported.cases[0].written.as_ref().unwrap_err().to_string();
        assert!(refused.contains(cause), "{refused}");
    }
}

/// A layer is written for rolling in steps and for lines. One of zero thickness yields and does not shear elastically;
/// one without thickness and yield stress is left out.
#[test]
fn a_layer_rolls_in_steps() {
    let line = "1 IPOTCN\n 9 1 -0.9 -50. 0.2 100. grid\n 1 1 kinds\n .001 .0 .0 .0 .0 .0 shape";
    let rolling = "0.0 0.2 2000. CHI";
    for (first, start) in [("203100", "\"steady\""), ("202100", "\"none\"")] {
        let file = with_layer(first, "1000. .002 .0 .0", rolling, line);
        let imported = read(&file).unwrap();
        let case = &imported.cases[0];
        assert!(case.written.as_ref().unwrap().command.starts_with("creepage roll"));
        has(
            &text(case, 0),
            &["[layer]", "yield_stress = 200000000.0", &format!("traction = {start}")],
        );
        let rigid = file.replace("106.25 .02", "106.25 .0");
        has(
            &text(&read(&rigid).unwrap().cases[0], 0),
            &["thickness = 0.0", "yield_stress = 200000000.0"],
        );
        let none = file.replace("106.25 .02 200.", "106.25 .0 .0");
        assert!(!text(&read(&none).unwrap().cases[0], 0).contains("[layer]"));
    }
}

/// Friction that falls at once has a memory of 10 nm in steps and on lines, and the case says so.
#[test]
fn falling_friction_in_steps_has_the_shortest_memory() {
    for memory in [".0 1.", ".02 1."] {
        let file = head("202100", "422020")
            + &format!(
                " 1000. .002 .0 .0 load\n .18 .12 100. .0 .0 friction\n {memory} memory\n 0.0 0.2 2000. CHI\n \
                 0.28 0.28 82000. 82000. material\n 1 IPOTCN\n 9 9 -0.9 -0.9 0.2 0.2 grid\n 1 1 kinds\n \
                 .005 .0 .005 .0 .0 .0 shape\n"
            );
        let imported = read(&file).unwrap();
        let case = &imported.cases[0];
        let is_short = memory.starts_with(".0 ");
        let told = case.notes.iter().any(|note| note.contains("a memory of 10 nm"));
        assert_eq!(told, is_short, "{:?}", case.notes);
        let distance = if is_short { "memory_distance = 1e-8" } else { "memory_distance = 2e-5" };
        assert!(text(case, 0).contains(distance), "{}", text(case, 0));
    }
}

/// Slip that is added element by element stands at the middles of the elements, but where it is zero everywhere; rolling
/// in -x turns places and slips.
#[test]
fn added_slip_is_a_slip_from_place_to_place() {
    let with = |digits: &str, kinematics: &str, rolling: &str, slip: &str| {
        let case = ball(digits, kinematics, rolling);
        let case = case.replace("022020 LDCMZE", "022029 LDCMZE");
        let zeros = ".0 .0\n".repeat(80);
        case + &format!("{slip}\n{zeros} 0 MODULE\n")
    };
    let steady =
        |slip: &str, rolling: &str| with("203100", "1000. .0005 .001 .0002", rolling, slip);
    let written = |file: &str| read(file).unwrap().cases[0].written.clone();
    let ahead = "0.0 0.2 2000. CHI";
    let none = read(&steady(".0 .0", ahead)).unwrap();
    assert!(!text(&none.cases[0], 0).contains("slip"));
    let columns = |file: &str| -> Vec<Vec<f64>> {
        let case = text(&read(file).unwrap().cases[0], 0);
        let slip = case.lines().find_map(|line| line.strip_prefix("slip = { ")).unwrap().to_owned();
        let lists = slip.trim_end_matches(" }").split("], ");
        let numbers = |list: &str| {
            let list = list.split('[').nth(1).unwrap().trim_end_matches(']');
            list.split(", ").map(|number| number.parse().unwrap()).collect()
        };
        lists.map(numbers).collect()
    };
    let [x, y, along, across]: [Vec<f64>; 4] =
        columns(&steady("1e-5 -2e-5", ahead)).try_into().unwrap();
    assert_eq!([x.len(), y.len(), along.len(), across.len()], [81; 4]);
    assert_eq!((along[0], across[0], along[1], across[80]), (1e-5, -2e-5, 0.0, 0.0));
    // The first element is the one in the corner of least x and y; x changes first.
    let least = |all: &[f64]| all.iter().copied().fold(f64::INFINITY, f64::min);
    assert_eq!((x[0], y[0]), (least(&x), least(&y)));
    assert!(x[1] > x[0] && (y[1] - y[0]).abs() < 1e-15 && y[9] > y[0]);
    let turned = columns(&steady("1e-5 -2e-5", "180d 0.2 2000. CHI"));
    assert_eq!((turned[0][0], turned[1][0], turned[2][0]), (-x[0], -y[0], -1e-5));
    let shifted = with("201110", "1000. .1 .0 .0", "", "1e-5 .0").replace("\n \n", "\n");
    let refused = written(&shifted).unwrap_err().to_string();
    assert!(refused.contains("from element to element"), "{refused}");
}

/// Without friction there is nothing to roll with.
#[test]
fn no_friction_is_told_at_once() {
    let case = ball("203100", "1000. .002 .001 .0002", "0.0 0.2 2000. CHI");
    let imported = read(&case.replace(" 0.3 0.3", " 0.0 0.0")).unwrap();
    let cause = imported.cases[0].written.as_ref().unwrap_err().to_string();
    assert!(cause.contains("coefficient of friction of 0.0"), "{cause}");
}
