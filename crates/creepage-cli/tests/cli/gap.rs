//! Case files with `[gap]`: contact areas of any shape.

use std::fmt::Write as _;

use serde_json::Value;

use crate::place::{Place, json};

pub(crate) const CASE: &str = r#"
[upper]
shear_modulus = 82e9
poisson = 0.28

[lower]
shear_modulus = 82e9
poisson = 0.28

[gap]
polynomial = [[2, 0, 1.0869565217391304], [0, 2, 1.6666666666666667]]

[contact]
normal_force = 80e3
friction = 0.3

[creepage]
longitudinal = -1.5e-3
lateral = 1e-3
spin = 0.2

[solve]
resolution = "fast"
"#;

pub(crate) const POLYNOMIAL: &str =
    "polynomial = [[2, 0, 1.0869565217391304], [0, 2, 1.6666666666666667]]";

fn solved(place: &Place, case: &str) -> Value {
    place.write("case.toml", case);
    json(&place.run(&["solve", "case.toml", "--json"]).done())
}

fn number(report: &Value, section: &str, key: &str) -> f64 {
    report[section][key].as_f64().unwrap_or_else(|| panic!("{section}.{key} in {report}"))
}

/// Solves the case with `old` replaced by `new` in a directory with nothing else; it must be
/// refused, and nothing written.
#[track_caller]
fn refused(old: &str, new: &str, parts: &[&str]) {
    refused_beside("", old, new, parts);
}

/// The same beside a file `gap.csv`.
#[track_caller]
fn refused_beside(csv: &str, old: &str, new: &str, parts: &[&str]) {
    assert!(CASE.contains(old), "{old} is not in the case");
    let place = Place::new();
    place.write("case.toml", CASE.replacen(old, new, 1));
    place.write("gap.csv", csv);
    place.run(&["solve", "case.toml", "--out", "out"]).refused(parts);
    assert_eq!(place.files(), ["case.toml", "gap.csv"]);
}

/// `h = y^2/0.6` at 41 points, 0.5 mm apart, in an order that is not sorted.
fn parabola() -> String {
    let points = (-20..=20).map(|k| f64::from((k * 7) % 41) * 0.5e-3).collect::<Vec<_>>();
    let mut text = String::from("y,gap\n");
    for y in points {
        let y = if y > 10e-3 {
            y - 20.5e-3
        } else if y < -10e-3 {
            y + 20.5e-3
        } else {
            y
        };
        writeln!(text, "{y},{}", y * y / 0.6).unwrap();
    }
    text
}

/// `h = x^2/0.92 + y^2/0.6` at the points of a grid.
fn grid(half: f64) -> String {
    let mut text = String::from("x,y,gap\n");
    for i in -12..=12 {
        for k in -12..=12 {
            let (x, y) = (f64::from(i) / 12.0 * half, f64::from(k) / 12.0 * half);
            writeln!(text, "{x},{y},{}", x * x / 0.92 + y * y / 0.6).unwrap();
        }
    }
    text
}

#[test]
fn an_ellipse_agrees_with_the_same_case_by_radii() {
    let place = Place::new();
    let standard = CASE.replace("\"fast\"", "\"standard\"");
    let report = solved(&place, &standard);
    let by_radii = CASE
        .replacen(
            "poisson = 0.28",
            "poisson = 0.28\nradius_rolling = 0.46\nradius_lateral = 'flat'",
            1,
        )
        .replace("\n\n[gap]", "\nradius_rolling = 'flat'\nradius_lateral = 0.3\n\n[gap]")
        .replace(&format!("[gap]\n{POLYNOMIAL}\n"), "")
        .replace("\"fast\"", "\"fine\"");
    let hertz = solved(&place, &by_radii);
    for (key, error) in
        [("peak_pressure_pa", "peak_pressure_error_pa"), ("approach_m", "approach_error_m")]
    {
        let [one, other] = [&report, &hertz].map(|report| number(report, "contact", key));
        assert!((one - other).abs() < number(&report, "contact", error), "{key}: {one} {other}");
    }
    let [a, b] =
        ["semi_axis_rolling_m", "semi_axis_lateral_m"].map(|k| number(&hertz, "contact", k));
    let area = std::f64::consts::PI * a * b;
    let off = (number(&report, "contact", "area_m2") - area).abs();
    assert!(off < number(&report, "contact", "area_error_m2"), "{off}");
    for (key, error, full) in [
        ("longitudinal_n", "longitudinal_error_n", 24e3),
        ("lateral_n", "lateral_error_n", 24e3),
        ("moment_n_m", "moment_error_n_m", 24e3 * (a * b).sqrt()),
    ] {
        let [one, other] = [&report, &hertz].map(|report| number(report, "lower_body", key));
        // The ellipse's own error at the fine resolution is some 0.03 % of mu N at worst.
        let bar = number(&report, "lower_body", error) + 3e-4 * full;
        assert!((one - other).abs() < bar, "{key}: {one} {other} +- {bar}");
    }
    let shares = [&report, &hertz].map(|report| number(report, "areas", "adhesion_share"));
    // Counted by some 400 elements: the boundary passes through 20 of them, each half wrong.
    assert!((shares[0] - shares[1]).abs() < 0.025, "{shares:?}");
}

#[test]
fn section_grid_and_polynomial_are_the_same_bodies() {
    let place = Place::new();
    let polynomial = solved(&place, CASE);
    place.write("section.csv", parabola());
    place.write("grid.csv", grid(10e-3));
    let section = "section = 'section.csv'\nradius_rolling = 0.46";
    for shape in [section, "grid = 'grid.csv'"] {
        let report = solved(&place, &CASE.replace(POLYNOMIAL, shape));
        for (key, full) in [("longitudinal_n", 24e3), ("lateral_n", 24e3), ("moment_n_m", 139.0)] {
            let [one, other] = [&polynomial, &report].map(|r| number(r, "lower_body", key));
            // In parts of mu N and mu N c: cubics through points of a parabola are this parabola,
            // but for a grid the pressure along x is solved with more terms.
            assert!((one - other).abs() < 2e-3 * full, "{shape} {key}: {one} {other}");
        }
    }
}

#[test]
fn the_approach_that_was_found_carries_the_load() {
    let place = Place::new();
    let report = solved(&place, CASE);
    let approach = number(&report, "contact", "approach_m");
    let again =
        solved(&place, &CASE.replace("normal_force = 80e3", &format!("approach = {approach}")));
    let load = number(&again, "contact", "normal_force_n");
    let bar = number(&again, "contact", "normal_force_error_n");
    assert!(bar > 0.0 && (load - 80e3).abs() < bar, "{load} +- {bar}");
    assert!(number(&again, "contact", "approach_error_m").abs() < 1e-300);
}

#[test]
fn a_wanted_force_is_met() {
    let place = Place::new();
    let wanted =
        CASE.replace("longitudinal = -1.5e-3\n", "") + "\n[wanted]\nlongitudinal_force = 9000\n";
    let report = solved(&place, &wanted);
    // The inverse problem is solved to 1e-7 of mu N.
    assert!((number(&report, "lower_body", "longitudinal_n") - 9000.0).abs() < 0.01);
    assert_eq!(report["known"], serde_json::json!(["lateral", "spin", "longitudinal_force"]));
    assert!(number(&report, "creepage", "longitudinal") > 1e-4);
    place.write("case.toml", wanted.replace("9000", "25e3"));
    place
        .run(&["solve", "case.toml"])
        .refused(&["[wanted] longitudinal_force = 25000", "at most 24000"]);
    let both = "longitudinal_force = 20e3\nlateral_force = 20e3";
    let beyond = wanted.replace("lateral = 1e-3\n", "");
    place.write("case.toml", beyond.replace("longitudinal_force = 9000", both));
    let parts = ["[wanted] is not reachable", "longitudinal_force", "lateral_force"];
    place.run(&["solve", "case.toml"]).refused(&parts);
}

/// Each of them on the ellipse of the case, near its own result by radii; `report.json` has no error
/// bars for them, and the picture and the field are written.
#[test]
fn simplified_theories_take_a_gap() {
    let place = Place::new();
    let by_radii = CASE
        .replacen(
            "poisson = 0.28",
            "poisson = 0.28\nradius_rolling = 0.46\nradius_lateral = 'flat'",
            1,
        )
        .replace("\n\n[gap]", "\nradius_rolling = 'flat'\nradius_lateral = 0.3\n\n[gap]")
        .replace(&format!("[gap]\n{POLYNOMIAL}\n"), "");
    for theory in ["fastsim", "fastrip", "linear", "saturated"] {
        let with = |case: &str| {
            let theory = format!("theory = '{theory}'");
            solved(&place, &case.replace("resolution = \"fast\"", &theory))
        };
        let [report, hertz] = [CASE, &by_radii].map(with);
        assert_eq!(report["theory"], theory);
        assert!(report["lower_body"]["longitudinal_error_n"].is_null());
        for key in ["longitudinal_n", "lateral_n"] {
            let [one, other] = [&report, &hertz].map(|report| number(report, "lower_body", key));
            // One flexibility in place of the blended three makes fastsim and fastrip differ.
            let most = if matches!(theory, "fastsim" | "fastrip") { 0.05 } else { 0.003 };
            assert!((one - other).abs() < most * 24e3, "{theory} {key}: {one} {other}");
        }
        place.write("case.toml", CASE);
        place.run(&["solve", "case.toml", "--theory", theory, "--out", "out"]).done();
        let vtk = place.read("out/contact.vtk");
        assert!(vtk.contains("DATASET POLYDATA") && vtk.contains("VECTORS traction_pa"));
    }
}

#[test]
fn two_patches_carry_the_load_together() {
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/gap/two-patches.toml");
    let place = Place::new();
    let report = json(&place.run(&["solve", example, "--json", "--out", "out"]).done());
    let files = ["contact.png", "contact.svg", "contact.vtk", "points.csv", "report.json"];
    assert_eq!(place.files_in("out"), files);
    assert_eq!(json(&place.read("out/report.json")), report);
    let patches = report["contact"]["patches"].as_array().unwrap();
    assert_eq!(patches.len(), 2);
    let loads = patches.iter().map(|patch| patch["load_n"].as_f64().unwrap());
    assert!((loads.sum::<f64>() / 80e3 - 1.0).abs() < 1e-9);
    // The elements carry the forces too; they are not extrapolated.
    let mut sums = [0.0; 2];
    for line in place.read("out/points.csv").lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let at = |k: usize| cells[k].parse::<f64>().unwrap();
        sums[0] += at(2) * at(8);
        sums[1] += at(7) * at(8);
    }
    assert!((sums[0] - 10e3).abs() < 0.01 * 24e3, "{sums:?}");
    assert!((sums[1] / 80e3 - 1.0).abs() < 0.01, "{sums:?}");
}

#[test]
fn a_report_in_words_names_all_of_it() {
    let place = Place::new();
    place.write("case.toml", CASE);
    let text = place.run(&["solve", "case.toml"]).done();
    assert!(text.starts_with("Theory exact: solved"), "{text}");
    for words in ["area", "error bar", "Patches", "about the origin", "adhesion", "found by"] {
        assert!(text.contains(words), "`{words}` is not in {text}");
    }
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
}

#[test]
fn few_points_and_unlike_bodies_are_cautions() {
    let place = Place::new();
    place.write("grid.csv", grid(40e-3));
    let case = CASE.replace(POLYNOMIAL, "grid = 'grid.csv'").replacen("0.28", "0.1", 1);
    let report = solved(&place, &case);
    let caution = report["caution"].as_str().unwrap();
    assert!(caution.contains("points along x") && caution.contains("kappa/mu"), "{caution}");
}

/// The examples of rollers: the load along the length has the load for its sum, the tilted one a peak by its end.
#[test]
fn rollers_tell_what_happens_along_them() {
    let place = Place::new();
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/gap");
    for (name, load) in [("roller-tilted", 5e3), ("twin-disc", 7.3e3)] {
        let case = format!("{examples}/{name}.toml");
        let report = json(&place.run(&["solve", &case, "--out", name, "--json"]).done());
        assert!(report["caution"].as_str().unwrap().contains("by the end at y"), "{report}");
        for file in ["along.csv", "along.svg", "along.png"] {
            assert!(place.path(name).join(file).is_file(), "{name} {file}");
        }
        let table = place.read(&format!("{name}/along.csv"));
        let rows: Vec<Vec<f64>> = table
            .lines()
            .skip(1)
            .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
            .collect();
        // Rows have one width: the sum by the trapezoid rule, but for half of it at both ends.
        let width = rows[1][0] - rows[0][0];
        let sum: f64 = rows.iter().map(|row| row[3] * width).sum();
        assert!((sum / load - 1.0).abs() < 1e-6, "{name} {sum}");
        let heat: f64 = rows.iter().map(|row| row[6] * width).sum();
        let power = report["frictional_power_per_metre_j_per_m"].as_f64().unwrap();
        // The elements' balance of energy.
        assert!((heat / power - 1.0).abs() < 0.02, "{name} {heat} {power}");
    }
}

#[test]
fn not_one_shape() {
    refused(
        POLYNOMIAL,
        "",
        &["[gap]", "exactly one of polynomial, section, grid, groove and roller", "none"],
    );
    let two = format!("{POLYNOMIAL}\ngrid = 'gap.csv'");
    refused(POLYNOMIAL, &two, &["[gap]", "given are polynomial and grid"]);
}

#[test]
fn keys_of_other_case_files() {
    let radius = "poisson = 0.28\nradius_rolling = 0.46";
    refused("poisson = 0.28", radius, &["[upper] radius_rolling", "materials only"]);
    refused("friction", "angle = 1\nfriction", &["[contact] angle", "[gap]"]);
    refused("spin = 0.2", "xi = 1.0", &["[creepage] xi has no meaning", "longitudinal"]);
    refused("[solve]", "[wanted]\nfx = 0.5\n[solve]", &["[wanted] fx has no meaning", "(N)"]);
    let strip = ["strip", "needs an ellipse", "exact, fastsim, fastrip, linear, saturated"];
    refused("resolution = \"fast\"", "theory = 'strip'", &strip);
    let three = "theory = 'fastsim'\nflexibility = 'three'";
    refused("resolution = \"fast\"", three, &["flexibility of fastsim", "blended ones"]);
    let parabolic = "theory = 'fastsim'\nbound = 'parabolic'";
    refused("resolution = \"fast\"", parabolic, &["bound of fastsim", "true pressure"]);
    let place = Place::new();
    place.write("case.toml", CASE.replace("resolution = \"fast\"", ""));
    place
        .run(&["solve", "case.toml", "--theory", "polach"])
        .refused(&["polach", "needs an ellipse"]);
}

#[test]
fn other_commands_take_it_and_the_schema_knows() {
    let place = Place::new();
    place.write("case.toml", CASE);
    let solved = json(&place.run(&["solve", "case.toml", "--json"]).stdout);
    let pressed = json(&place.run(&["hertz", "case.toml", "--json"]).done());
    for key in ["area_m2", "peak_pressure_pa", "stiffness_n_per_m", "patches"] {
        assert_eq!(pressed[key], solved["contact"][key], "{key}");
    }
    let curve = place.run(&["curve", "case.toml", "--theory", "fastsim", "--points", "5"]);
    assert_eq!(curve.done().lines().count(), 6);
    let stresses = json(&place.run(&["stresses", "case.toml", "--json"]).done());
    let largest = stresses["largest_von_mises"][0]["von_mises"].as_f64().unwrap();
    // Between that of a line contact and of full sliding.
    let share = largest / pressed["peak_pressure_pa"].as_f64().unwrap();
    assert!((0.5..0.8).contains(&share), "{share}");
    let schema = json(&place.run(&["schema", "--of", "gap"]).done());
    assert!(schema["properties"]["gap"]["properties"]["section"].is_object());
    let theories = schema["properties"]["solve"]["oneOf"].as_array().unwrap();
    // exact, and four on its pressure.
    assert_eq!(theories.len(), 5);
}

#[test]
fn load_and_approach() {
    let both = "normal_force = 80e3\napproach = 1e-5";
    refused("normal_force = 80e3", both, &["[contact] normal_force", "approach exclude"]);
    refused("normal_force = 80e3", "", &["[contact] needs normal_force or approach"]);
    refused("80e3", "-1.0", &["[contact] normal_force = -1", "greater than zero"]);
    refused("80e3", "nan", &["[contact] normal_force = NaN"]);
    refused("friction = 0.3", "friction = 0", &["[contact] friction = 0", "greater than zero"]);
    let apart = "approach = -1e-6";
    refused("normal_force = 80e3", apart, &["[contact] approach = -0.000001", "no contact"]);
}

#[test]
fn gaps_without_a_contact_area() {
    refused(POLYNOMIAL, "polynomial = [[2, 0, 1.0]]", &["[gap] polynomial", "along a line"]);
    refused(POLYNOMIAL, "polynomial = [[0, 0, 0.0]]", &["[gap] polynomial", "everywhere"]);
    refused(POLYNOMIAL, "polynomial = [[2, 0, nan]]", &["[gap] polynomial", "coefficient = NaN"]);
    refused(POLYNOMIAL, "polynomial = [[99, 0, 1.0]]", &["[gap] polynomial", "at most 24"]);
    let twice = "polynomial = [[2, 0, 1.0], [2, 0, 1.0]]";
    refused(POLYNOMIAL, twice, &["[gap] polynomial", "two terms x^2 y^0"]);
}

#[test]
fn a_grid_that_the_contact_outgrows() {
    let shape = "grid = 'gap.csv'";
    let csv = grid(4e-3);
    refused_beside(
        &csv,
        POLYNOMIAL,
        shape,
        &["[gap] grid = \"gap.csv\"", "must go on for at least"],
    );
}

#[test]
fn files_of_points() {
    let section = "section = 'gap.csv'\nradius_rolling = 0.46";
    let wrong = |csv: &str, parts: &[&str]| {
        refused_beside(csv, POLYNOMIAL, section, &[&["[gap] section"], parts].concat());
    };
    wrong("", &["column y is missing"]);
    wrong("y,h\n0,0\n", &["column gap is missing"]);
    wrong("y,gap,z\n0,0,0\n", &["unknown column `z`", "radius_rolling"]);
    wrong("y,gap,gap\n0,0,0\n", &["gap stands there twice"]);
    wrong("y,gap\n0,0\n1e-3,nan\n", &["line 3", "gap = \"nan\"", "finite number"]);
    wrong("y,gap\n0,0\n1e-3,\n", &["line 3", "gap = \"\""]);
    wrong("y,gap\n0,0\n1e-3\n", &["line: 3"]);
    wrong("y,gap\n0,0\n0,1\n1,1\n", &["two points at y = 0"]);
    wrong("y,gap\n0,0\n1,1\n", &["2 different values of y"]);
    refused(POLYNOMIAL, "grid = 'none.csv'", &["[gap] grid = \"none.csv\"", "cannot read"]);
    let two = format!("{section}\n");
    refused_beside("y,gap,radius_rolling\n0,0,1\n", POLYNOMIAL, &two, &["exclude each other"]);
    refused_beside("y,gap\n0,0\n", POLYNOMIAL, "section = 'gap.csv'", &["needs a rolling radius"]);
    let beside = format!("{POLYNOMIAL}\nradius_rolling = 1.0");
    refused(POLYNOMIAL, &beside, &["radius_rolling goes with section alone"]);
    let hole = "x,y,gap\n0,0,0\n1,0,0\n0,1,0\n";
    refused_beside(hole, POLYNOMIAL, "grid = 'gap.csv'", &["[gap] grid"]);
}

#[test]
fn numbers_in_other_units_are_cautions() {
    let place = Place::new();
    // A ball of 6 mm on a plane: h = (x^2 + y^2)/(2 R).
    let case = |modulus: &str, lateral: &str| {
        format!(
            "[upper]\nshear_modulus = {modulus}\npoisson = 0.28\n[lower]\nshear_modulus = {modulus}\n\
             poisson = 0.28\n[gap]\npolynomial = [[2, 0, 83.33], [0, 2, 83.33]]\n[contact]\n\
             normal_force = 100\nfriction = 0.3\n[creepage]\nlateral = {lateral}\n\
             [solve]\nresolution = \"fast\"\n"
        )
    };
    for (modulus, lateral, expected) in [
        ("82e9", "1e-3", &[][..]),
        ("82e3", "1e-3", &["of the smallest radius, 0.006 m", "exceeds the shear modulus"][..]),
        ("82e9", "2.0", &["the lateral creepage of 2 is above 0.3"][..]),
    ] {
        place.write("case.toml", case(modulus, lateral));
        let ran = place.run(&["solve", "case.toml", "--json"]);
        let report = json(&ran.stdout);
        let caution = report["caution"].as_str().unwrap_or_default();
        assert_eq!(caution.is_empty(), expected.is_empty(), "{caution}");
        let text = place.run(&["solve", "case.toml"]).stdout.replace('\n', " ");
        for words in expected {
            assert!(caution.contains(words) && ran.stderr.contains(words), "{caution}");
            assert!(text.contains("CAUTION: ") && text.contains(words), "{text}");
        }
    }
}

/// Arrows stand on a regular raster, but for that of the largest traction, which is as long as the raster allows.
#[test]
fn arrows_stand_on_a_raster_and_the_largest_is_drawn() {
    const LONGEST: f64 = 0.92; // of the distance between nodes
    let place = Place::new();
    place.write("case.toml", CASE.replace("friction = 0.3", "friction = 0.25"));
    place.run(&["solve", "case.toml", "--out", "out"]).done();
    let picture = place.read("out/contact.svg");
    let arrows: Vec<([f64; 2], f64)> = picture.lines().filter_map(arrow).collect();
    assert!(arrows.len() > 40, "{}", arrows.len());
    let mut columns: Vec<f64> = arrows.iter().map(|(middle, _)| middle[0]).collect();
    columns.sort_by(f64::total_cmp);
    let mut steps: Vec<f64> = columns.windows(2).map(|two| two[1] - two[0]).collect();
    steps.retain(|step| *step > 0.1); // coordinates have two decimals
    steps.sort_by(f64::total_cmp);
    let pitch = steps[steps.len() / 2];
    let [x, y] = arrows[arrows.len() / 2].0;
    let off = |(middle, _): &&([f64; 2], f64)| {
        let apart = [middle[0] - x, middle[1] - y].map(|part| part / pitch);
        apart.iter().any(|part| (part - part.round()).abs() > 0.02)
    };
    // The largest, and the sample in the key.
    assert!(arrows.iter().filter(off).count() <= 2, "{arrows:?}");
    let longest = arrows.iter().map(|(_, length)| *length).fold(0.0, f64::max);
    assert!((longest / (LONGEST * pitch) - 1.0).abs() < 0.01, "{longest} {pitch}");
}

/// The middle and the length of an arrow in a line of a picture: seven corners, from the tail along one side to the
/// tip and back.
fn arrow(line: &str) -> Option<([f64; 2], f64)> {
    let path = line.strip_prefix("<path d=\"M")?.split('"').next()?;
    let corners: Vec<[f64; 2]> = path
        .trim_end_matches('Z')
        .split('L')
        .map(|corner| corner.split_once(' ').map(|(x, y)| [x.parse().ok(), y.parse().ok()]))
        .map(|corner| corner.and_then(|[x, y]| Some([x?, y?])))
        .collect::<Option<_>>()?;
    let is_arrow = line.contains("#10243a") && corners.len() >= 7 && corners.len() <= 8;
    is_arrow.then(|| {
        let tail = [0, 1].map(|k: usize| f64::midpoint(corners[0][k], corners[6][k]));
        let tip = corners[3];
        let middle = [0, 1].map(|k: usize| f64::midpoint(tail[k], tip[k]));
        (middle, (tip[0] - tail[0]).hypot(tip[1] - tail[1]))
    })
}
