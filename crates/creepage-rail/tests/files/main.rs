//! Profile files: written and read back, odd, broken and mutated.

#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp)]

use creepage_rail::file::{
    Action, CornerSearch, FileError, Format, ReadOptions, Reading, read, write,
};
use creepage_rail::{Profile, Role, Side, Smoothing, Standard};

mod believed;
mod mutated;
mod odd;

const FORMATS: [(Format, [&str; 2]); 6] = [
    (Format::Simpack, ["a.prr", "a.prw"]),
    (Format::MiniProf, ["a.ban", "a.whl"]),
    (Format::Vampire, ["a.rai", "a.whe"]),
    (Format::Gensys, ["a.rail", "a.wheel"]),
    (Format::Columns, ["a.txt", "a.txt"]),
    (Format::Json, ["a.json", "a.json"]),
];

fn wanted(role: Role) -> ReadOptions {
    ReadOptions { role: Some(role), side: Some(Side::Right), ..ReadOptions::default() }
}

/// Columns of a profile in its own coordinates, one line a point, in mm.
fn columns(points: &[[f64; 2]]) -> String {
    rows(points, |[y, z]| format!("{y} {z}"))
}

fn rows(points: &[[f64; 2]], row: impl Fn([f64; 2]) -> String) -> String {
    points.iter().map(|&point| row(point)).collect::<Vec<_>>().join("\n") + "\n"
}

/// UIC60 every .5 mm, in mm.
fn head() -> Vec<[f64; 2]> {
    let profile = Standard::Uic60.profile();
    let stations = profile.curve().stations(5e-4).into_iter();
    stations.map(|s| profile.curve().at(s)).map(|p| [1e3 * p.y, 1e3 * p.z]).collect()
}

fn read_rail(points: &[[f64; 2]]) -> Result<Reading, FileError> {
    read("rail.txt", columns(points).as_bytes(), &wanted(Role::Rail))
}

type Moved = fn([f64; 2]) -> [f64; 2];

/// Greatest distance in `z` between two profiles over a range of `y`.
fn apart(a: &Profile, b: &Profile, [from, to]: [f64; 2]) -> f64 {
    let places = (0..=300).map(|i| from + (to - from) * f64::from(i) / 300.0);
    places.map(|y| (a.at_y(y).unwrap().z - b.at_y(y).unwrap().z).abs()).fold(0.0, f64::max)
}

/// In each format and back: the shape to the deviation of a spline through points every .2 mm,
/// largest at the jumps of curvature, where it is a fortieth of the jump times the spacing squared; both sides of VAMPIRE alike.
#[test]
fn every_format_is_written_and_read_back() {
    for standard in [Standard::Uic60, Standard::S1002, Standard::Cone40] {
        let profile = standard.profile();
        for (format, names) in FORMATS {
            let text = write(&profile, format, 2e-4);
            let name = names[usize::from(standard.role() == Role::Wheel)];
            for side in [Side::Left, Side::Right] {
                let wanted = ReadOptions { side: Some(side), ..wanted(standard.role()) };
                let found = read(name, text.as_bytes(), &wanted).unwrap();
                assert_eq!(found.format, format);
                assert_eq!(found.profile.role(), standard.role());
                let range =
                    if standard.role() == Role::Rail { [-0.033, 0.033] } else { [-0.040, 0.050] };
                let apart = apart(&found.profile, &profile, range);
                assert!(apart < 80e-9, "{standard:?} {format:?} {apart}");
            }
        }
    }
}

/// The role is told by the content or by the ending, else asked for.
#[test]
fn roles_are_told_or_asked_for() {
    let wheel = Standard::S1002.profile();
    for (format, names) in FORMATS {
        let text = write(&wheel, format, 5e-4);
        let wanted = ReadOptions { side: Some(Side::Left), ..ReadOptions::default() };
        let found = read(names[1], text.as_bytes(), &wanted);
        let found = found.unwrap();
        assert_eq!(found.profile.role(), Role::Wheel, "{format:?}");
        let by_shape = found.actions.contains(&Action::RoleFound { role: Role::Wheel });
        assert_eq!(by_shape, format == Format::Columns, "{format:?}");
    }
    // An arc may be that of a disc or of a rail.
    let arc: Vec<[f64; 2]> = (-30..=30).map(f64::from).map(|y| [y, 0.1 * y * y / 30.0]).collect();
    let found = read("a.txt", columns(&arc).as_bytes(), &ReadOptions::default());
    assert!(matches!(found, Err(FileError::Ask { .. })), "{found:?}");
    let both = write(&wheel, Format::Vampire, 5e-4);
    assert!(matches!(
        read("a.whe", both.as_bytes(), &ReadOptions::default()),
        Err(FileError::Ask { .. })
    ));
}

/// Whatever its order, senses and unit, the same rail comes out and the report says what was done.
#[test]
fn senses_order_and_unit_are_found() {
    let points = head();
    let straight = read_rail(&points).unwrap().profile;
    let variants: [(Moved, Action); 4] = [
        (|[y, z]| [y, -z], Action::TurnedOver),
        (|[y, z]| [y / 1e3, z / 1e3], Action::UnitFound { metres: 1.0 }),
        (|[y, z]| [y / 25.4, z / 25.4], Action::UnitFound { metres: 0.0254 }),
        (|[y, z]| [-y, z], Action::Reversed),
    ];
    for (change, action) in variants {
        let changed: Vec<[f64; 2]> = points.iter().map(|&point| change(point)).collect();
        let found = read_rail(&changed).unwrap();
        assert!(found.actions.contains(&action), "{:?}", found.actions);
        assert!(apart(&found.profile, &straight, [-0.033, 0.033]) < 1e-12);
    }
    // A wheel shows its flange; what the format holds of `y` gives way.
    let wheel = write(&Standard::S1002.profile(), Format::Columns, 5e-4);
    let mirrored =
        wheel.lines().map(|line| line.strip_prefix('-').map_or(format!("-{line}"), str::to_owned));
    let mirrored: Vec<String> = mirrored.skip(1).collect();
    let found = read("w.txt", mirrored.join("\n").as_bytes(), &wanted(Role::Wheel)).unwrap();
    assert!(found.actions.contains(&Action::Mirrored));
    assert!((found.profile.at_z(0.010).unwrap().y + 0.0375).abs() < 1e-7);
}

/// A scan of a whole wheel, from the rim's face to the back of the flange, its origin there.
#[test]
fn whole_wheels_with_their_faces() {
    let wheel = write(&Standard::S1002.profile(), Format::Columns, 5e-4);
    let tread = wheel.lines().skip(1).map(|line| {
        let mut numbers = line.split(' ').map(|number| number.parse::<f64>().unwrap());
        [numbers.next().unwrap() + 70.0, numbers.next().unwrap()]
    });
    let tread: Vec<[f64; 2]> = tread.collect();
    let rim = (1..40).rev().map(|i| [130.0 + 0.01 * f64::from(i), -2.6 - 0.5 * f64::from(i)]);
    let back = (1..40).map(|i| [0.005 - 0.001 * f64::from(i), 9.5 - 0.4 * f64::from(i)]);
    let points: Vec<[f64; 2]> = rim.chain(tread).chain(back).collect();
    let text = format!("#MINIWHEELPROF\nMINIPROF 2020\n\n{}", columns(&points));
    let found = read("x.whl", text.as_bytes(), &ReadOptions::default()).unwrap();
    assert!(!found.actions.contains(&Action::TurnedOver));
    assert!(!found.actions.contains(&Action::Mirrored));
    let height = found.profile.at_y(0.015).unwrap().z;
    assert!((height - 0.028).abs() < 1e-6, "{height}");
}

#[test]
fn simpack_applies_its_keys_in_order() {
    let points = head();
    let text = |keys: &str, rows: &[[f64; 2]]| {
        format!(
            "! comment\nheader.begin\n version = 1\n type = 0\nheader.end\nspline.begin\n \
             comment = 'a ! in quotes'\n{keys}\n units.len.f = 1000\npoint.begin\n! 1 2\n{}point.end\n\
             spline.end\n",
            columns(rows).replace('\n', " 1.0 ! weighted\n")
        )
    };
    let read = |keys: &str, rows: &[[f64; 2]]| {
        read("a.prr", text(keys, rows).as_bytes(), &ReadOptions::default()).unwrap()
    };
    let plain = read("bound.y.min = 1\n bound.y.max = 0", &points);
    assert_eq!(plain.points, points.len());
    assert!(apart(&plain.profile, &Standard::Uic60.profile(), [-0.020, 0.020]) < 100e-9);
    // Shift comes before mirror: y = -(y + 3).
    let shifted: Vec<[f64; 2]> = points.iter().map(|[y, z]| [-y - 3.0, 4.0 - z]).collect();
    let found = read("mirror.y = 1\n mirror.z = 1\n shift.y = 3\n shift.z = -4", &shifted);
    assert!(apart(&found.profile, &plain.profile, [-0.033, 0.033]) < 1e-12);
    let cut = read("bound.z.min = 0\n bound.z.max = 20", &points);
    assert!(cut.profile.at_z(0.0201).is_none() && cut.profile.at_z(0.0193).is_some());
    let turned = read("rotate = 1.5\n units.ang.f = 57.29577951308232", &points);
    let slope = turned.profile.at_y(0.0).unwrap().tangent[1];
    assert!((slope - 1.5f64.to_radians().sin()).abs() < 1e-3, "{slope}");
    let thin = read("point.dist.min = 2.0", &points);
    assert!(thin.points < points.len() / 3);
}

#[test]
fn miniprof_in_its_layouts() {
    let points = head();
    let data = rows(&points, |[y, z]| format!("0.5,{},{}", -y, -z));
    let newer = format!(
        "FileName=x\nXoffset=0.0\nColumnDef=A,X,Y\nXYPoints={}\n\n{data}\nrest of the file",
        points.len()
    );
    let old = rows(&points, |[y, z]| format!("{} {}", -y, -z));
    let old = format!("#MINIRAILPROF\nMINIPROF 2020\nmp.name x\n1.0 2.0 3.0\n\n{old}");
    for text in [&newer, &old] {
        let found = read("a.ban", text.as_bytes(), &ReadOptions::default()).unwrap();
        assert_eq!((found.format, found.points), (Format::MiniProf, points.len()));
        assert!(found.actions.contains(&Action::TurnedOver));
        assert!(apart(&found.profile, &Standard::Uic60.profile(), [-0.020, 0.020]) < 100e-9);
    }
    let last = newer.replace("\n\nrest", " \" remark\n\nrest");
    assert!(read("a.ban", last.as_bytes(), &ReadOptions::default()).is_ok());
    let deselected = newer.replacen("0.5,", "\" 0.5,", 2);
    let found = read("a.ban", deselected.as_bytes(), &ReadOptions::default()).unwrap();
    assert!(found.actions.contains(&Action::Skipped { count: 2 }));
    let short = newer.replace("\nrest of the file", "").replace("XYPoints=", "XYPoints=9");
    assert!(matches!(
        read("a.ban", short.as_bytes(), &ReadOptions::default()),
        Err(FileError::Missing { .. })
    ));
}

#[test]
fn faults_of_scans_are_repaired_and_told() {
    let clean = read_rail(&head()).unwrap().profile;
    let mut points = head();
    points.insert(100, points[100]);
    let found = read_rail(&points).unwrap();
    assert!(found.actions.contains(&Action::Repeated { line: 102 }));
    assert!(apart(&found.profile, &clean, [-0.033, 0.033]) < 1e-12);

    // A stitched scan: two points in the wrong order.
    let mut points = head();
    points.swap(120, 121);
    let found = read_rail(&points).unwrap();
    assert!(found.actions.contains(&Action::ZigZag { line: 121 }), "{:?}", found.actions);
    assert!(apart(&found.profile, &clean, [-0.033, 0.033]) < 1e-6);

    // One that goes back over several points, as at a seam of two scans.
    let mut points = head();
    let seam: Vec<[f64; 2]> = points[118..121].iter().map(|[y, z]| [y + 0.1, z + 0.05]).collect();
    points.splice(121..121, seam);
    let found = read_rail(&points).unwrap();
    let at_seam = |a: &&Action| {
        matches!(a, Action::TurnedBack { line: 119..=125 } | Action::ZigZag { line: 119..=125 })
    };
    assert!(found.actions.iter().any(|a| at_seam(&a)));
    // No further off than the seam itself.
    let off = apart(&found.profile, &clean, [-0.033, 0.033]);
    assert!(off < 112e-6, "{off}");

    // One point far off.
    let mut points = head();
    points[150] = [-36.0, 25.0];
    let down = ReadOptions { down: Some(true), ..wanted(Role::Rail) };
    let found = read("r.txt", columns(&points).as_bytes(), &down).unwrap();
    let spike = |a: &Action| matches!(a, Action::Spike { line: 151, point: 151, .. });
    assert!(found.actions.iter().any(spike), "{:?}", found.actions);
    assert!(apart(&found.profile, &clean, [-0.033, 0.033]) < 1e-6);

    let mut points = head();
    points.drain(90..130);
    let found = read_rail(&points).unwrap();
    let bridged = found.actions.iter().any(|a| matches!(a, Action::Bridged { line: 91, .. }));
    assert!(bridged, "{:?}", found.actions);

    let corner = [
        [-40.0, 30.0],
        [-39.0, 20.0],
        [-38.0, 10.0],
        [-37.0, 0.0],
        [0.0, 0.0],
        [37.0, 0.0],
        [38.0, 10.0],
        [39.0, 20.0],
        [40.0, 30.0],
    ];
    let found = read_rail(&corner).unwrap();
    let kept = |a: &&Action| matches!(a, Action::Corner { turn, line: 4 | 6 } if *turn > 1.0);
    assert_eq!(found.actions.iter().filter(kept).count(), 2);
    assert_eq!(found.profile.curve().kinks(1.0).len(), 2);
}

#[test]
fn what_makes_no_sense_names_its_line() {
    let points = head();
    let swapped: Vec<[f64; 2]> = (0..60).map(f64::from).map(|y| [0.01 * y * y, y]).collect();
    assert!(matches!(read_rail(&swapped), Err(FileError::Axes { line: 1, .. })));
    let round: Vec<[f64; 2]> = (0..200)
        .map(|i| f64::from(i) * 0.05)
        .map(|a: f64| [8.0 * a - 20.0 * a.sin(), 14.0 * a.cos()])
        .collect();
    let crossing = read(
        "r.txt",
        columns(&round).as_bytes(),
        &ReadOptions { down: Some(true), ..wanted(Role::Rail) },
    );
    assert!(matches!(crossing, Err(FileError::Crosses { line: 2.., .. })), "{crossing:?}");
    let inches: Vec<[f64; 2]> = points.iter().map(|[y, z]| [y / 25.4, z / 25.4]).collect();
    let asked = ReadOptions { unit: Some(1e-3), ..wanted(Role::Rail) };
    let found = read("r.txt", columns(&inches).as_bytes(), &asked);
    assert!(matches!(found, Err(FileError::Length { line: 1, .. })), "{found:?}");
    let headed = format!("y,z\n{}", columns(&points).replace(' ', ","));
    let found = read("r.csv", headed.as_bytes(), &wanted(Role::Rail)).unwrap();
    assert!(found.actions.contains(&Action::Ignored { line: 1, what: "heading" }));
    let text = columns(&points);
    let bad = [
        (
            text.replacen(' ', " x", 1),
            FileError::NotANumber { line: 1, column: 2, text: format!("x{}", points[0][1]) },
        ),
        (text.replacen('\n', " 7\n", 3), FileError::Columns { line: 1, found: 3, wanted: 2 }),
        (text.replacen(' ', " 1e7 ", 1), FileError::NotALength { line: 1, column: 2, value: 1e7 }),
        (String::new(), FileError::Count { line: 1, count: 0 }),
    ];
    for (text, error) in bad {
        let found = read("r.txt", text.as_bytes(), &wanted(Role::Rail)).unwrap_err();
        assert_eq!(format!("{found}"), format!("{error}"));
    }
    let flat: Vec<[f64; 2]> = (0..60).map(|i| [f64::from(i), f64::from(i % 2) * 0.1]).collect();
    assert!(matches!(read_rail(&flat), Err(FileError::Ask { .. })));
}

/// Measured noise: waves of a few micrometres every .3 mm spoil curvature; smoothing by 4 mm
/// brings it back.
#[test]
fn smoothing_brings_back_curvature() {
    let noise = |i: usize| 3e-3 * ((i * 2_654_435_761) % 1000) as f64 / 1000.0;
    let points: Vec<[f64; 2]> =
        head().iter().enumerate().map(|(i, [y, z])| [*y, z + noise(i)]).collect();
    let worst = |smoothing: Option<f64>| {
        let smoothing = smoothing.map(Smoothing::Wavelength);
        let wanted = ReadOptions { smoothing, ..wanted(Role::Rail) };
        let profile = read("r.txt", columns(&points).as_bytes(), &wanted).unwrap().profile;
        let off = (-80..=80).map(|i| f64::from(i) * 1e-4);
        off.map(|y| (profile.at_y(y).unwrap().curvature - 1.0 / 0.3).abs()).fold(0.0, f64::max)
    };
    let (rough, smooth) = (worst(None), worst(Some(4e-3)));
    assert!(rough > 10.0 && smooth < 3.0, "{rough} {smooth}");
}
