//! Numbers of reports against hand formulas, and their keys.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::fmt::Write as _;
use std::path::Path;

use creepage::TheorySpec;
use creepage::coulomb::Constraints;

use crate::testing::{CURVE, SLIDING, case, report, solved};
use crate::{
    ANSWERS, AnyCaseFile, BearingFile, BearingReport, BulkCase, BulkColumn, Case, CaseFile, Given,
    LineFile, Quantity, Report, Solver, StaticsFile, StaticsReport, TableAxis, Varied,
    WheelsetCase, WheelsetFile, WheelsetTable,
};

fn close(value: &serde_json::Value, expected: f64) {
    // A handful of roundings.
    assert!((value.as_f64().unwrap() / expected - 1.0).abs() < 1e-12, "{value} {expected}");
}

#[test]
fn the_numbers_are_those_of_hand_formulas() {
    let json = serde_json::to_value(report(2.25, SLIDING, CURVE).report()).unwrap();
    // c = 6 mm, so a = 9 mm and b = 4 mm; mu N = 24 kN.
    close(&json["contact"]["semi_axis_rolling_m"], 9e-3);
    close(&json["contact"]["semi_axis_lateral_m"], 4e-3);
    close(&json["contact"]["peak_pressure_pa"], 1.5 * 80e3 / (PI * 36e-6));
    close(&json["lower_body"]["longitudinal_n"], 0.6 * 24e3);
    close(&json["lower_body"]["lateral_n"], 0.5 * 24e3);
    close(&json["lower_body"]["moment_n_m"], -0.1 * 24e3 * 6e-3);
    close(&json["upper_body"]["longitudinal_n"], -0.6 * 24e3);
    close(&json["upper_body"]["moment_n_m"], 0.1 * 24e3 * 6e-3);
    let rho = json["contact"]["rho_m"].as_f64().unwrap();
    close(&json["creepage"]["longitudinal"], CURVE[0] * 0.3 * 6e-3 / rho);
    close(&json["creepage"]["lateral"], CURVE[1] * 0.3 * 6e-3 / rho);
    close(&json["creepage"]["spin_rad_per_m"], CURVE[2] * 0.3 / rho);
    close(&json["dimensionless"]["friction_used"], 0.61_f64.sqrt());
    close(&json["areas"]["slip_m2"], PI * 36e-6);
}

#[test]
fn what_is_known_besides() {
    let plain = serde_json::to_value(report(1.0, SLIDING, CURVE).report()).unwrap();
    for key in ["caution", "known", "rolling_velocity_m_per_s", "frictional_power_w"] {
        assert!(plain[key].is_null(), "{key}");
    }
    let given =
        Constraints { chi: Some(1.5), fx: Some(0.6), fy: Some(0.5), ..Constraints::default() };
    let like = case(1.0, CURVE);
    let contact = like.contact.with_kappa_over_mu(0.5).unwrap();
    let case = Case { contact, speed: Some(20.0), given: Given::Constraints(given), ..like };
    let json = serde_json::to_value(solved(&case, SLIDING).report()).unwrap();
    assert!(json["caution"].as_str().unwrap().contains("kappa/mu = 0.5"), "{json}");
    assert_eq!(json["known"], serde_json::json!(["chi", "fx", "fy"]));
    let per_metre = json["frictional_power_per_metre_j_per_m"].as_f64().unwrap();
    close(&json["frictional_power_w"], 20.0 * per_metre);
    let slip = json["contact"]["rho_m"].as_f64().map(|rho| 0.3 * 6e-3 / rho).unwrap();
    close(&json["frictional_power_per_metre_by_slip_j_per_m"], 0.5 * 24e3 * slip);
}

#[test]
fn words_and_details() {
    let json = serde_json::to_value(report(1.0, SLIDING, CURVE).report()).unwrap();
    assert_eq!(json["status"], "spin_too_large");
    assert_eq!(json["theory"], "test & trial");
    assert_eq!(json["creepage_version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(json["details"]["mean_integrand"]["value"], 1.25e-3);
    assert!(json["details"]["unknown"]["value"].is_null());
    assert_eq!(json["areas"]["points"], 3);
}

/// An ellipse and areas of any shape have the same keys, but for what only one of them has.
#[test]
fn both_kinds_of_contact_have_the_same_keys() {
    let [ellipse, areas] = [on_ellipse(), on_areas()].map(|report| {
        let keys = |one: &Quantity| [Some(one.path()), one.error_key()];
        report.own().flat_map(keys).flatten().collect::<BTreeSet<_>>()
    });
    let only = |own: &BTreeSet<String>, other: &BTreeSet<String>| {
        own.difference(other).map(String::as_str).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(
        only(&ellipse, &areas),
        "contact.a_over_b contact.angle_rad contact.approach_constant_m_per_n_2_3 \
         contact.relative_curvature_lateral_per_m contact.relative_curvature_rolling_per_m contact.rho_m \
         contact.semi_axis_lateral_m contact.semi_axis_rolling_m"
    );
    // Where it stood before there were dimensionless forces of areas.
    assert_eq!(only(&areas, &ellipse), "friction_used");
}

/// The guide's table of keys is that of the reports: `CREEPAGE_WRITE_GUIDE=1 cargo test -p creepage-study --lib the_guide`
/// writes it again.
#[test]
fn the_guide_has_all_keys() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/pages/facts/report.md");
    let text = std::fs::read_to_string(page).unwrap();
    let [from, to] = ["<!-- keys -->\n", "<!-- end of keys -->\n"];
    let start = text.find(from).unwrap() + from.len();
    let end = text.find(to).unwrap();
    let table = table_of_keys();
    if std::env::var_os("CREEPAGE_WRITE_GUIDE").is_some() {
        std::fs::write(page, format!("{}{table}{}", &text[..start], &text[end..])).unwrap();
    } else {
        assert_eq!(&text[start..end], table, "see the words above this test");
    }
}

const HEAD: &str = "\n| key | meaning | unit |\n|---|---|---|\n";

fn table_of_keys() -> String {
    let mut table = String::from(HEAD);
    let (ellipse, areas) = (on_ellipse(), on_areas());
    let mut written = BTreeSet::new();
    for one in ellipse.own().chain(areas.own()) {
        let path = one.path();
        if !written.insert(path.clone()) {
            continue;
        }
        let only = match [&ellipse, &areas].map(|report| report.find(&path).is_some()) {
            [true, false] => "; of an ellipse",
            [false, true] => "; of areas of any shape",
            _ => "",
        };
        row(&mut table, &path, one, only);
    }
    for (words, report) in [
        ("Of a line contact, per metre of its length:", line()),
        (
            "Of a wheelset; `right` is like `left`, `patches.0` the most loaded contact of a wheel:",
            wheelset(),
        ),
        ("Of a bearing; `outer` is like `inner`:", bearing()),
    ] {
        write!(table, "\n{words}\n{HEAD}").unwrap();
        for (path, one) in report.quantities() {
            let is_like_another = path.starts_with("right.") || path.contains(".outer.");
            let is_first = path.split('.').all(|part| part.parse::<usize>().unwrap_or(0) == 0);
            if !is_like_another && is_first {
                row(&mut table, &path, one, "");
            }
        }
    }
    write!(table, "\nWithout rolling, each of the problems that have it:\n{HEAD}").unwrap();
    let mut written = BTreeSet::new();
    for report in STATICS.map(statics) {
        for (path, one) in report.quantities() {
            let is_first = !path.starts_with("steps.") || path.starts_with("steps.0.");
            if is_first && written.insert(path.clone()) {
                row(&mut table, &path, one, "");
            }
        }
    }
    table.push('\n');
    table
}

fn row(table: &mut String, path: &str, one: &Quantity, only: &str) {
    let error = one.error_key().map_or(String::new(), |key| format!(", `{key}`"));
    let (label, unit) = (one.label.trim(), one.unit.symbol());
    writeln!(table, "| `{path}`{error} | {label}{only} | {unit} |").unwrap();
}

/// Rows of ellipses have numbers of the report of their case, under its keys.
#[test]
fn columns_of_rows_are_quantities() {
    let text = include_str!("../../../../examples/wheel-on-rail.toml");
    let text = text.replace("longitudinal = -1.5e-3", "longitudinal = -1.5e-3\nspeed = 20.0");
    let spec = TheorySpec::named("fastsim").unwrap();
    let case = AnyCaseFile::read(&text).unwrap().case(Path::new("")).unwrap();
    let report = case.solve(Some(&spec)).unwrap().report();
    let bulk = BulkCase::new(&CaseFile::read(&text).unwrap(), vec![Varied::Speed]).unwrap();
    let answer = bulk.solve_one(&Solver::new(spec), &[20.0]).unwrap();
    assert_eq!(bulk.columns(), BulkColumn::ALL.map(|column| column.name));
    assert_eq!(answer.numbers(None).count(), BulkColumn::ALL.len());
    for (column, number) in BulkColumn::ALL.iter().zip(answer.numbers(None)) {
        let own = report.find(column.path).unwrap();
        assert_eq!(own.key(), column.name);
        // A rounding or two: the one is scaled before, the other after it is summed.
        assert!((number / own.value.unwrap() - 1.0).abs() < 1e-14 || number == 0.0, "{column:?}");
    }
}

/// Rows and tables of a wheelset have numbers of its report, under its keys, but for what a report has as no number of
/// its own: the wrench of both rails, how many contacts there are, and how far they reach.
#[test]
fn columns_of_wheelsets_are_quantities() {
    let case = wheelset_case();
    let solved = case.solve().unwrap();
    let report = solved.report();
    let own = ["contacts", "length_m", "width_m"];
    let of_wheel = [
        "longitudinal_n",
        "lateral_n",
        "vertical_n",
        "moment_x_n_m",
        "moment_y_n_m",
        "moment_z_n_m",
    ];
    let check = |name: &str, k: usize, number: f64| {
        let (side, rest) = ["left", "right"]
            .into_iter()
            .find_map(|side| Some((side, name.strip_prefix(side)?.strip_prefix('_')?)))
            .unwrap_or(("", name.strip_prefix("found_").unwrap_or(name)));
        let of_contact = rest.strip_prefix("contact_").filter(|rest| *rest != "angle_rad");
        let path = match (side, of_contact) {
            ("", _) => rest.to_owned(),
            (_, Some(rest)) => format!("{side}.patches.{k}.{rest}"),
            (_, None) if of_wheel.contains(&rest) => format!("{side}.force.{rest}"),
            (_, None) if rest == "pitch_rate_rad_per_s" => format!("{side}.{rest}"),
            (_, None) => format!("{side}.patches.{k}.{rest}"),
        };
        let key = path.rsplit('.').next().unwrap();
        if own.contains(&key) || name.starts_with("wrench_") {
            return false;
        }
        let found = report.find(&path).and_then(|one| one.value).unwrap_or(f64::NAN);
        // Both by one solver from one start.
        assert!(
            number.to_bits() == found.to_bits() || number.is_nan() && found.is_nan(),
            "{name}: {number} {path} {found}"
        );
        true
    };
    let answers = ANSWERS.iter().zip(solved.solved.answers());
    assert_eq!(answers.filter(|(name, number)| check(name, 0, *number)).count(), ANSWERS.len() - 6);
    let axis = TableAxis { name: "y", values: vec![solved.solved.position().y] };
    let table = WheelsetTable::solve(&case, &[axis], || true).unwrap();
    let numbers = table.columns().filter(|(name, values)| check(name, 0, values[0]));
    assert_eq!(numbers.count(), table.columns().count() - 2);
    for (name, values) in table.contact_columns() {
        for (k, number) in values.into_iter().enumerate() {
            assert!(
                check(&name, k, number) || name.ends_with("length_m") || name.ends_with("width_m")
            );
        }
    }
}

fn line() -> Report {
    let text = include_str!("../../../../examples/line/aluminium-on-steel.toml");
    LineFile::read(text).unwrap().case().unwrap().solve().unwrap().report()
}

fn wheelset() -> Report {
    wheelset_case().solve().unwrap().report()
}

fn wheelset_case() -> WheelsetCase {
    let directory = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/wheelset");
    let text = include_str!("../../../../examples/wheelset/s1002-on-uic60.toml");
    let mut case = WheelsetFile::read(text).unwrap().case(Path::new(directory)).unwrap();
    case.theory = TheorySpec::named("saturated").unwrap();
    case
}

fn bearing() -> Report {
    let text = include_str!("../../../../examples/bearing/angular-contact-7208.toml");
    BearingReport::solve(BearingFile::read(text).unwrap().case().unwrap()).unwrap().report()
}

/// A problem without rolling of each kind.
const STATICS: [&str; 7] = [
    include_str!("../../../../examples/statics/die-offset-load.toml"),
    include_str!("../../../../examples/statics/anchor-plate-shift.toml"),
    include_str!("../../../../examples/statics/bolt-twist.toml"),
    include_str!("../../../../examples/statics/wheel-standing-on-slope.toml"),
    include_str!("../../../../examples/statics/fretting-path.toml"),
    include_str!("../../../../examples/statics/soft-ball-pressed.toml"),
    include_str!("../../../../examples/statics/clay-sheared.toml"),
];

fn statics(text: &str) -> Report {
    let case = StaticsFile::read(text).unwrap().solve().unwrap();
    StaticsReport::new(&case).unwrap().report()
}

/// Numbers of parts, each found by its path, are those of the JSON.
#[test]
fn numbers_of_parts_have_paths() {
    for report in [wheelset(), bearing(), line()].into_iter().chain(STATICS.map(statics)) {
        let json = serde_json::to_value(&report).unwrap();
        let all = report.quantities();
        assert!(all.len() > 8);
        for (path, one) in all {
            let place = path.split('.').fold(&json, |place, part| match part.parse::<usize>() {
                Ok(k) => &place[k],
                Err(_) => &place[part],
            });
            assert_eq!(place.as_f64(), one.value.filter(|value| value.is_finite()), "{path}");
            assert_eq!(report.find(&path), Some(one));
        }
    }
}

fn on_ellipse() -> Report {
    report(2.25, SLIDING, CURVE).report()
}

fn on_areas() -> Report {
    let text = "[upper]\nshear_modulus = 82e9\npoisson = 0.28\n[lower]\nshear_modulus = 82e9\npoisson = 0.28\n\
        [gap]\npolynomial = [[2, 0, 1.0], [0, 2, 2.0]]\n[contact]\nnormal_force = 1e4\nfriction = 0.3\n\
        [creepage]\nlongitudinal = 1e-3\n[solve]\ntheory = \"saturated\"\n";
    let file = AnyCaseFile::read(text).unwrap();
    file.case(Path::new("")).unwrap().solve(None).unwrap().report()
}
