//! A profile is looked at before it is believed: shape beside words, odd texts, odd scans.

use creepage_rail::file::{Action, FileError, ReadOptions, Reading, read, write};
use creepage_rail::{Profile, Role, Side, Standard};

use super::{Format, Moved, apart, columns, head, read_rail, rows, wanted};

const WHEEL: [f64; 2] = [-0.040, 0.050];
const RAIL: [f64; 2] = [-0.033, 0.033];

/// S1002 from the rim to the flange's back, every half millimetre, in mm.
fn wheel() -> Vec<[f64; 2]> {
    let profile = Standard::S1002.profile();
    let stations = profile.curve().stations(5e-4).into_iter();
    stations.map(|s| profile.curve().at(s)).map(|p| [1e3 * p.y, 1e3 * p.z]).collect()
}

fn open(name: &str, text: &str) -> Result<Reading, FileError> {
    read(name, text.as_bytes(), &ReadOptions::default())
}

fn simpack(kind: u8, keys: &str, points: &[[f64; 2]]) -> String {
    format!(
        "header.begin\n type = {kind}\nheader.end\nspline.begin\n{keys}\n units.len.f = 1000\n\
         point.begin\n{}point.end\nspline.end\n",
        columns(points)
    )
}

fn moved(points: &[[f64; 2]], by: Moved) -> Vec<[f64; 2]> {
    points.iter().map(|&point| by(point)).collect()
}

fn plain_wheel() -> Profile {
    open("w.prw", &simpack(1, "", &wheel())).unwrap().profile
}

/// Every sense of both axes and of the order, by format with and without a convention of its own:
/// one wheel, since its flange hangs down on the track side.
#[test]
fn a_wheel_is_the_same_however_it_is_turned() {
    let plain = plain_wheel();
    let senses: [Moved; 4] = [|p| p, |[y, z]| [-y, z], |[y, z]| [y, -z], |[y, z]| [-y, -z]];
    for sense in senses {
        for reversed in [false, true] {
            let mut points = moved(&wheel(), sense);
            if reversed {
                points.reverse();
            }
            let ban = format!("ProgramName=x\nColumnDef=X,Y\n\n{}", columns(&points));
            for (name, text) in [
                ("w.prw", simpack(1, "", &points)),
                ("w.wheel", columns(&points)),
                ("w.txt", columns(&points)),
                ("w.whl", ban),
            ] {
                let found = open(name, &text).unwrap();
                assert_eq!(found.profile.role(), Role::Wheel, "{name}");
                assert!(
                    apart(&found.profile, &plain, WHEEL) < 1e-12,
                    "{name} {:?}",
                    sense([1.0; 2])
                );
            }
        }
    }
    let half_turn = open("w.prw", &simpack(1, "", &moved(&wheel(), senses[3]))).unwrap();
    for action in [Action::AgainstFormat { what: "z" }, Action::TurnedOver, Action::Mirrored] {
        assert!(half_turn.actions.contains(&action), "{action}");
    }
}

/// A rail's head shows what is up, also against the format.
#[test]
fn a_rail_upside_down_is_turned_over() {
    let plain = open("r.prr", &simpack(0, "", &head())).unwrap().profile;
    let over = open("r.prr", &simpack(0, "", &moved(&head(), |[y, z]| [y, -z]))).unwrap();
    assert!(over.actions.contains(&Action::AgainstFormat { what: "z" }));
    assert!(apart(&over.profile, &plain, RAIL) < 1e-12);
    // A disc of a roller rig bulges down: no rail, whatever its name.
    let disc: Vec<[f64; 2]> =
        (-40..=40).rev().map(f64::from).map(|y| [y, -y * y / 400.0]).collect();
    let disc = open("w.prw", &simpack(1, "", &disc)).unwrap();
    assert!(!disc.actions.contains(&Action::TurnedOver), "{:?}", disc.actions);
}

#[test]
fn a_shape_that_contradicts_the_role_names_both() {
    let ban = |points: &[[f64; 2]]| format!("ProgramName=x\nColumnDef=X,Y\n\n{}", columns(points));
    let both = [
        open("w.ban", &ban(&wheel())),
        open("w.prw", &simpack(0, "", &wheel())),
        read("w.txt", columns(&wheel()).as_bytes(), &wanted(Role::Rail)),
    ];
    for found in both {
        let error = found.unwrap_err();
        assert!(matches!(error, FileError::Role { said: Role::Rail, shown: Role::Wheel, .. }));
        let words = error.to_string();
        assert!(
            words.contains("says rail") && words.contains("shape is that of a wheel"),
            "{words}"
        );
    }
    for found in [open("r.whl", &ban(&head())), open("r.prr", &simpack(1, "", &head()))] {
        let is_role = |e: &FileError| matches!(e, FileError::Role { shown: Role::Rail, .. });
        assert!(found.as_ref().is_err_and(is_role), "{found:?}");
    }
    // Who says the right role is heard before the name.
    let found = read("w.ban", ban(&wheel()).as_bytes(), &wanted(Role::Wheel)).unwrap();
    assert!(found.actions.contains(&Action::RoleAsked { role: Role::Wheel }));
    let senses = [
        (ReadOptions { down: Some(false), ..ReadOptions::default() }, "z = up"),
        (ReadOptions { field_side: Some(false), ..ReadOptions::default() }, "y = track-side"),
    ];
    for (wanted, words) in senses {
        let error = read("w.txt", columns(&wheel()).as_bytes(), &wanted).unwrap_err().to_string();
        assert!(error.contains(words) && error.contains("flange"), "{error}");
    }
}

/// A nose of a crossing on its wide foot looks like a wheel upside down; the file says rail.
#[test]
fn a_head_on_a_foot_stays_a_rail() {
    let nose = [[-8.0, 34.0], [-2.0, 2.0], [0.0, 0.0], [20.0, 0.0], [22.0, 2.0], [28.0, 34.0]];
    let steps = nose.windows(2).flat_map(|pair| {
        let [a, b] = [pair[0], pair[1]];
        (0..20).map(f64::from).map(move |i| [0, 1].map(|k| a[k] + (b[k] - a[k]) * i / 20.0))
    });
    let foot = (0..=60).map(f64::from).map(|y| [28.0 + y, 34.0]);
    let points: Vec<[f64; 2]> = steps.chain(foot).collect();
    let found = open("nose.prr", &simpack(0, "", &points)).unwrap();
    assert_eq!(found.profile.role(), Role::Rail);
    assert!(!found.actions.contains(&Action::TurnedOver), "{:?}", found.actions);
}

/// How a profile is moved, its points, and the distance of its origin.
type Far<'a> = (Moved, &'a [[f64; 2]], [f64; 2]);

/// Where the origin lies far off the report gives its distance, and says what counts from it.
#[test]
fn a_far_origin_is_told_with_its_distance() {
    let far: [Far<'_>; 4] = [
        (|[y, z]| [y, z + 460.0], &wheel(), [-0.070, 0.460]),
        (|[y, z]| [y + 70.0, z], &wheel(), [0.0, 0.0]),
        (|[y, z]| [y + 750.0, z], &wheel(), [0.680, 0.0]),
        (|[y, z]| [y + 750.0, z], &head(), [0.750, 0.0]),
    ];
    for (by, points, [y, z]) in far {
        let found = open("p.txt", &columns(&moved(points, by))).unwrap();
        let told = found.actions.iter().find_map(|action| match action {
            Action::FarOrigin { y, z, .. } => Some([*y, *z]),
            _ => None,
        });
        let told = told.unwrap();
        // The level of a tread or a head is within a millimetre of its origin.
        assert!((told[0] - y).abs() < 1e-3 && (told[1] - z).abs() < 2e-3, "{told:?}");
    }
    for points in [wheel(), head()] {
        let found = open("p.txt", &columns(&points)).unwrap();
        assert!(!found.actions.iter().any(|a| matches!(a, Action::FarOrigin { .. })));
    }
}

/// One text in every encoding and dress: one wheel.
#[test]
fn texts_are_read_in_any_dress() {
    let plain = plain_wheel();
    let points = wheel();
    let text = columns(&points);
    let comma = |text: &str| text.replace('.', ",");
    let utf16 = |text: &str, bytes: fn(u16) -> [u8; 2]| {
        text.encode_utf16().flat_map(bytes).collect::<Vec<u8>>()
    };
    let semicolons = comma(&rows(&points, |[y, z]| format!("{y};{z}")));
    let tabs = comma(&rows(&points, |[y, z]| format!("{y}\t{z}")));
    let named = rows(&points, |[y, z]| format!("0,{z},{y}"));
    let dressed: Vec<(&str, Vec<u8>, Option<Action>)> = vec![
        ("w.txt", comma(&text).into(), Some(Action::DecimalCommas)),
        ("w.csv", semicolons.into(), Some(Action::DecimalCommas)),
        ("w.txt", tabs.into(), Some(Action::DecimalCommas)),
        ("w.csv", format!("\u{feff}y;z\n{text}").into(), None),
        ("w.txt", utf16(&format!("\u{feff}{text}"), u16::to_le_bytes), Some(Action::Utf16)),
        ("w.txt", utf16(&format!("\u{feff}{text}"), u16::to_be_bytes), Some(Action::Utf16)),
        ("w.txt", utf16(&text, u16::to_le_bytes), Some(Action::Utf16)),
        ("w.txt", text.replace('\n', "\r").into(), None),
        ("w.txt", text.replace('\n', "\r\n").into(), None),
        ("w.txt", format!("Wheel 12, 2024-03-01\nOperator: 7 3\n y  z\n{text}").into(), None),
        ("w.txt", format!("{}\n{text}", points.len()).into(), None),
        (
            "w.txt",
            format!("% a\n# b\n! c\n// d\n{}", text.replacen('\n', " // e\n", 3)).into(),
            None,
        ),
        ("w.csv", format!("s,z [mm],y [mm]\n{named}").into(), None),
        ("w.whe", format!("WHEEL\nmeasured 2024\n{text}").into(), None),
    ];
    for (index, (name, content, action)) in dressed.into_iter().enumerate() {
        let found = read(name, &content, &ReadOptions::default());
        let found = found.unwrap_or_else(|error| panic!("{index}: {error}"));
        assert_eq!(found.points, points.len(), "{index}: {:?}", found.actions);
        assert!(apart(&found.profile, &plain, WHEEL) < 1e-12, "{index}");
        assert!(action.is_none_or(|action| found.actions.contains(&action)), "{index}");
    }
    // Commas of both kinds, and no decimal commas at all.
    let both = comma(&rows(&points[1..], |[y, z]| format!("{y:.3},{z:.3}")));
    assert!(matches!(open("w.txt", &both), Err(FileError::Commas { line: 1 })), "{both}");
    let whole = rows(&points, |[y, z]| format!("{},{}", y.round(), z.round()));
    let found = open("w.txt", &whole).map(|found| found.actions);
    assert!(!found.as_ref().is_ok_and(|a| a.contains(&Action::DecimalCommas)), "{found:?}");
}

/// `MiniProf` in inches, said or by its size; with a key in quotes; in sections; with columns that
/// are no lengths.
#[test]
fn miniprof_in_more_layouts() {
    let plain = plain_wheel();
    let up = moved(&wheel(), |[y, z]| [y, -z]);
    let inches = columns(&moved(&up, |[y, z]| [y / 25.4, z / 25.4]));
    let key = "\"Program Name\"=MINIPROF\nColumnDef=X,Y\n";
    let large = rows(&up, |[y, z]| format!("{y} {z} 0 0 663810000.0"));
    let texts = [
        format!("{key}\n{inches}"),
        format!("{key}Units=inch\n\n{inches}"),
        format!("[FileInfo]\nProgram=x\n[Profile1]\nUnit=mm\n[Profile1Points]\n{}", columns(&up)),
        format!("{key}MPDC=3\nMPDN=a name\n\n{large}"),
        format!("{key}{}", columns(&up)),
    ];
    for (index, text) in texts.iter().enumerate() {
        let found = open("w.whl", text);
        let found = found.unwrap_or_else(|error| panic!("{index}: {error}"));
        assert!(apart(&found.profile, &plain, WHEEL) < 1e-9, "{index}");
    }
    let found = open("w.whl", &texts[0]).unwrap();
    assert!(found.actions.contains(&Action::UnitFound { metres: 0.0254 }));
}

/// A head of three arcs and two lines, given by them.
#[test]
fn miniprof_by_segments_is_their_arcs() {
    // A crown of 300 mm from 88 to 92 degrees, corners of 13 mm down to upright sides.
    let [sin, cos] = [88f64, 92.0].map(|a| 300.0 * a.to_radians().cos());
    let z = 300.0 * (88f64.to_radians().sin() - 1.0);
    let corner = |sense: f64| {
        let turn = 88f64.to_radians();
        [sense * (sin - 13.0 * turn.cos()), z - 13.0 * turn.sin()]
    };
    let ([right, low], [left, _]) = (corner(1.0), corner(-1.0));
    assert!((sin + cos).abs() < 1e-9);
    let side = right + 13.0;
    let text = format!(
        "MPDC=5\nMPDN=head\nMPD1=L {0} {low} {0} {1}\nMPD2=A {right} {low} 13 0 88\n\
         MPD3=A 0 -300 300 88 92\nMPD4=A {left} {low} 13 92 180\nMPD5=L -{0} {low} -{0} {1}\n\n",
        side,
        low - 15.0
    );
    let found = open("r.ban", &text).unwrap();
    assert!(found.actions.contains(&Action::Segments { count: 5 }));
    let curvature = |y: f64| found.profile.at_y(y).unwrap().curvature;
    // Points on an arc of 300 mm every quarter of a millimetre make it to 1e-5.
    assert!((curvature(0.002) * 0.3 - 1.0).abs() < 1e-3, "{}", curvature(0.002));
    let apart = text.replace("MPD5=L -", "MPD5=L -1");
    assert!(matches!(open("r.ban", &apart), Err(FileError::Apart { line: 7, .. })));
    let wrong = text.replace("MPD3=A 0", "MPD3=B 0");
    assert!(matches!(open("r.ban", &wrong), Err(FileError::Key { line: 5, .. })));
}

#[test]
fn json_of_points_and_of_coordinates() {
    let plain = plain_wheel();
    let list = |axis: usize, scale: f64| {
        let values: Vec<String> = wheel().iter().map(|p| (scale * p[axis]).to_string()).collect();
        format!("[{}]", values.join(","))
    };
    let pairs = rows(&wheel(), |[y, z]| format!("[{y},{z}],"));
    let named = rows(&wheel(), |[y, z]| format!("{{\"y\":{y},\"z\":{z}}},"));
    let [pairs, named] =
        [pairs, named].map(|text| text.trim_end().trim_end_matches(',').to_owned());
    for text in [
        format!("[{pairs}]"),
        format!("{{\"data\": {{\"points\": [{named}]}}}}"),
        format!("{{\"y\": {}, \"z\": {}}}", list(0, 1.0), list(1, 1.0)),
        format!(
            "{{\"profile_role\": \"wheel\", \"lateral_meters\": {}, \"vertical_meters\": {}}}",
            list(0, 1e-3),
            list(1, 1e-3)
        ),
    ] {
        let found = open("w.json", &text).unwrap();
        assert_eq!(found.format, Format::Json);
        assert!(apart(&found.profile, &plain, WHEEL) < 1e-9);
    }
    for wrong in ["{\"y\": [1, 2]}", "[1, 2", "{\"a\": [[1,2],[3,4]], \"b\": [[1,2],[3,4]]}"] {
        assert!(matches!(open("w.json", wrong), Err(FileError::Json { .. })), "{wrong}");
    }
}

/// The outline of a whole rail from anywhere on it, either way round: its head.
#[test]
fn of_a_whole_rail_the_head_is_taken() {
    let head: Vec<[f64; 2]> = head();
    let plain = read_rail(&head).unwrap().profile;
    let [[left, depth], [right, _]] = [head[0], head[head.len() - 1]];
    let below = [
        [right - 0.5, depth + 12.0],
        [8.0, 51.0],
        [8.0, 140.0],
        [75.0, 160.0],
        [75.0, 172.0],
        [-75.0, 172.0],
        [-75.0, 160.0],
        [-8.0, 140.0],
        [-8.0, 51.0],
        [left + 0.5, depth + 12.0],
    ];
    let outline: Vec<[f64; 2]> = head.iter().copied().chain(below).collect();
    for start in [0, 40, head.len() / 2, head.len() + 4] {
        for reversed in [false, true] {
            let mut points = outline.clone();
            points.rotate_left(start);
            points.push(points[0]);
            if reversed {
                points.reverse();
            }
            let found = read_rail(&points).unwrap();
            let taken = |a: &Action| matches!(a, Action::Outline { .. });
            assert!(found.actions.iter().any(taken), "{:?}", found.actions);
            // The cubics of a spline depend on their ends by less than a nanometre 5 mm on.
            assert!(apart(&found.profile, &plain, [-0.025, 0.025]) < 1e-9, "{start}");
        }
    }
    let mut rim = wheel();
    rim.extend([[-69.0, -40.0], [59.0, -40.0], [60.0, -2.0]]);
    let found = read("w.txt", columns(&rim).as_bytes(), &wanted(Role::Wheel));
    assert!(matches!(found, Err(FileError::Outline { .. })), "{found:?}");
}

#[test]
fn values_that_are_no_numbers_are_dropped_with_a_note() {
    let mut lines: Vec<String> = columns(&head()).lines().map(str::to_owned).collect();
    lines[70] = "NaN NaN".into();
    lines[90] = "-10.0 nan".into();
    let found = read("r.txt", lines.join("\n").as_bytes(), &wanted(Role::Rail)).unwrap();
    for line in [71, 91] {
        assert!(found.actions.contains(&Action::Unmeasured { line }));
    }
    assert_eq!(found.points, lines.len() - 2);
}

/// Spikes of a millimetre to a metre at spacings of half a millimetre to three.
#[test]
fn a_spike_is_dropped_and_named_by_its_point() {
    for every in [1, 3, 6] {
        let clean: Vec<[f64; 2]> = wheel().into_iter().step_by(every).collect();
        let plain = open("w.txt", &columns(&clean)).unwrap().profile;
        for height in [1.5, 6.0, 1000.0] {
            let mut points = clean.clone();
            let index = clean.len() / 3;
            points[index][1] -= height;
            let found = open("w.txt", &columns(&points)).unwrap();
            let named = found.actions.iter().any(|action| {
                matches!(action, Action::Spike { point, line, .. } if *point == index + 1 && *line == index + 1)
            });
            assert!(named, "{every} {height}: {:?}", found.actions);
            // A tread's spline without one of its points: its curvature changes slowly.
            assert!(apart(&found.profile, &plain, [-0.025, 0.050]) < 2e-6, "{every} {height}");
        }
    }
}

/// Two scans that overlap: what the second measures again is dropped, or refused where it differs.
#[test]
fn overlapping_scans_keep_the_first() {
    let points = wheel();
    let plain = open("w.txt", &columns(&points)).unwrap().profile;
    let seam = points.len() / 2;
    let twice = |apart: f64, from: usize| {
        let again = points[from..].iter().map(|[y, z]| [*y, z + apart]);
        points[..seam].iter().copied().chain(again).collect::<Vec<_>>()
    };
    for (apart_mm, from) in [(0.0, seam - 20), (0.02, seam - 20), (0.0, seam - 40)] {
        let found = open("w.txt", &columns(&twice(apart_mm, from))).unwrap();
        let overlap = found.actions.iter().find_map(|action| match action {
            Action::Overlap { count, apart, .. } => Some((*count, *apart)),
            _ => None,
        });
        let (count, off) = overlap.unwrap_or_else(|| panic!("{:?}", found.actions));
        assert!(count.abs_diff(seam - from) <= 1, "{count}");
        assert!((off - 1e-3 * apart_mm).abs() < 2e-6, "{off}");
        assert!(found.actions.iter().all(|a| !matches!(a, Action::Corner { .. })));
        let tolerance = 2e-6 + 1.1e-3 * apart_mm;
        let off = apart(&found.profile, &plain, [-0.025, 0.050]);
        assert!(off < tolerance, "{apart_mm} {from} {off}");
    }
    let found = open("w.txt", &columns(&twice(0.5, seam - 20)));
    assert!(matches!(found, Err(FileError::Overlap { .. })), "{found:?}");
    // The second pass before the first, with an overlap and without.
    for from in [seam - 20, seam] {
        let swapped = [&points[from..], &points[..seam]].concat();
        let found = open("w.txt", &columns(&swapped)).unwrap();
        let is_swap = |action: &Action| matches!(action, Action::PassesSwapped { .. });
        assert_eq!(found.actions.iter().filter(|action| is_swap(action)).count(), 1);
        let off = apart(&found.profile, &plain, [-0.025, 0.050]);
        assert!(off < 2e-6, "{from} {off}");
    }
    // There and back again.
    let back = points.iter().chain(points.iter().rev().skip(1)).copied().collect::<Vec<_>>();
    let found = open("w.txt", &columns(&back[..points.len() + 60])).unwrap();
    assert!(apart(&found.profile, &plain, WHEEL) < 1e-9);
}

#[test]
fn a_lone_bound_of_simpack_bounds_one_side() {
    let count = |keys: &str| open("r.prr", &simpack(0, keys, &head())).unwrap().points;
    let least = |axis: usize, limit: f64, sense: f64| {
        head().iter().filter(|p| sense * p[axis] <= sense * limit).count()
    };
    assert_eq!(count("bound.z.max = 10"), least(1, 10.0, 1.0));
    assert_eq!(count("bound.y.max = 30"), least(0, 30.0, 1.0));
    assert_eq!(count("bound.y.min = -30"), least(0, -30.0, -1.0));
    assert_eq!(count("bound.z.min = -5\n bound.z.max = 12"), least(1, 12.0, 1.0));
    assert_eq!(count("bound.z.min = 1\n bound.z.max = 0"), head().len());
    let clipped = open("r.prr", &simpack(0, "bound.z.max = 10", &head())).unwrap();
    assert!(!clipped.actions.iter().any(|a| matches!(a, Action::Bridged { .. })));
}

#[test]
fn unknown_keys_of_simpack_are_told_or_refused() {
    for key in ["rotate.x = 0.1", "scale.y = 2", "rot = 0.05", "shift.x = 1", "mirror = 1"] {
        let name = key.split_once(' ').unwrap().0;
        let error = open("r.prr", &simpack(0, key, &head())).unwrap_err();
        let known = matches!(&error, FileError::UnknownKey { line: 5, key } if key == name);
        assert!(known, "{error}");
    }
    for key in ["rotate.x = 0.0", "scale.y = 1.0", "author = 'me'"] {
        let found = open("r.prr", &simpack(0, key, &head())).unwrap();
        let name = key.split_once(' ').unwrap().0;
        let told = |a: &Action| matches!(a, Action::UnknownKey { line: 5, key } if key == name);
        assert!(found.actions.iter().any(told), "{:?}", found.actions);
    }
    // Points that other programs mark as comments.
    let text = simpack(0, "", &head()).replacen("point.begin\n", "point.begin\n% 1 2\n# 3 4\n", 1);
    let found = open("r.prr", &text).unwrap();
    assert!(found.actions.contains(&Action::Skipped { count: 2 }));
}

/// A unit that the file itself says is not put right silently.
#[test]
fn a_wrong_unit_is_refused_with_the_one_that_fits() {
    let text = simpack(1, "", &wheel()).replace("units.len.f = 1000", "units.len.f = 1");
    let error = open("w.prw", &text).unwrap_err();
    assert!(matches!(error, FileError::Length { fitting: Some(1e-3), .. }), "{error}");
    assert!(error.to_string().contains("a unit of 0.001 m would fit"), "{error}");
    // Centimetres are no inches.
    let found = open("w.txt", &columns(&moved(&wheel(), |[y, z]| [y / 10.0, z / 10.0]))).unwrap();
    assert!(found.actions.contains(&Action::UnitFound { metres: 0.01 }), "{:?}", found.actions);
}

/// Sides of VAMPIRE's two columns, under titles of any kind.
#[test]
fn vampire_under_other_titles() {
    let both = write(&Standard::Uic60.profile(), Format::Vampire, 5e-4);
    let data: Vec<&str> = both.lines().skip(4).collect();
    let text = format!("R 60\n left right\n{}\n", data.join("\n"));
    let plain = read("r.rai", both.as_bytes(), &wanted(Role::Rail)).unwrap().profile;
    for side in [Side::Left, Side::Right] {
        let wanted = ReadOptions { side: Some(side), ..ReadOptions::default() };
        let found = read("r.rai", text.as_bytes(), &wanted).unwrap();
        assert!(apart(&found.profile, &plain, RAIL) < 1e-9);
    }
    assert!(matches!(open("r.rai", &text), Err(FileError::Ask { .. })));
}
