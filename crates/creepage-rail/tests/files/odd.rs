//! Files as scanners, spreadsheets and old programs write them, and parts of profiles.

use super::*;

/// S1002 every .5 mm, in mm.
fn wheel() -> Vec<[f64; 2]> {
    let profile = Standard::S1002.profile();
    let stations = profile.curve().stations(5e-4).into_iter();
    stations.map(|s| profile.curve().at(s)).map(|p| [1e3 * p.y, 1e3 * p.z]).collect()
}

fn read_wheel(text: &str) -> Result<Reading, FileError> {
    read("w.txt", text.as_bytes(), &wanted(Role::Wheel))
}

/// Two in a row, so that they are no single spikes.
#[test]
fn numbers_that_stand_for_nothing_measured_are_dropped() {
    let plain = read_wheel(&columns(&wheel())).unwrap().profile;
    for nothing in [9999.0, -999.0] {
        let mut points = wheel();
        for index in [100, 101] {
            points[index][1] = nothing;
        }
        let found = read_wheel(&columns(&points)).unwrap();
        for line in [101, 102] {
            let is_it =
                |action: &Action| matches!(action, Action::Outlier { line: at, .. } if *at == line);
            assert!(found.actions.iter().any(is_it), "{:?}", found.actions);
        }
        // A spline over a gap of 1.5 mm.
        assert!(apart(&found.profile, &plain, [-0.03, 0.05]) < 1e-5);
    }
}

#[test]
fn points_in_no_order_are_refused_as_such() {
    let points = wheel();
    // 97 and the number of points have no common divisor: each point once.
    let count = points.len() - usize::from(points.len().is_multiple_of(97));
    let mixed: Vec<_> = (0..count).map(|i| points[97 * i % count]).collect();
    let found = read_wheel(&columns(&mixed));
    assert!(
        matches!(found, Err(FileError::Disorder { line: 1, times }) if times > 20.0),
        "{found:?}"
    );
}

/// All points are taken, and told.
#[test]
fn miniprof_with_more_points_than_it_says() {
    let points = wheel();
    let text = format!("XYPoints=100\n\n{}", columns(&points));
    let found = read("w.whl", text.as_bytes(), &ReadOptions::default()).unwrap();
    assert_eq!(found.points, points.len());
    assert!(found.actions.contains(&Action::MorePoints { said: 100, found: points.len() }));
}

/// Looks like a tread with a flange the other way up.
#[test]
fn a_flange_alone_is_asked_about() {
    let flange: Vec<[f64; 2]> = wheel().into_iter().filter(|[y, _]| *y < -25.0).collect();
    let found = read_wheel(&columns(&flange));
    assert!(matches!(found, Err(FileError::Ask { .. })), "{found:?}");
    let said = ReadOptions { down: Some(true), field_side: Some(true), ..wanted(Role::Wheel) };
    assert!(read("w.txt", columns(&flange).as_bytes(), &said).is_ok());
}

/// The underside is no part of the running surface, and hides the head from nobody.
#[test]
fn a_head_with_its_underside_is_a_rail_either_way_up() {
    let mut points = head();
    let end = points[points.len() - 1];
    for [inwards, down] in [[1.0, 5.0], [10.0, 9.0], [25.0, 13.0]] {
        points.push([end[0] - inwards, end[1] + down]);
        points.insert(0, [inwards - end[0], end[1] + down]);
    }
    let simpack = |sign: f64| {
        let rows = rows(&points, |[y, z]| format!("{y} {}", sign * z));
        format!(
            "header.begin\nversion = 1\ntype = 0\nheader.end\nspline.begin\nunits.len.f = 1000\npoint.begin\n\
             {rows}point.end\nspline.end\n"
        )
    };
    let [up, down] = [-1.0, 1.0]
        .map(|sign| read("r.prr", simpack(sign).as_bytes(), &ReadOptions::default()).unwrap());
    assert!(apart(&up.profile, &down.profile, [-0.03, 0.03]) < 1e-12);
    let against = |reading: &Reading| {
        reading.actions.iter().any(|action| matches!(action, Action::AgainstFormat { what: "z" }))
    };
    assert_eq!([&up, &down].map(against), [true, false]);
}

/// Two columns say neither role nor what is up: a head that comes back under itself half as wide as its crown does.
#[test]
fn a_wide_underside_shows_a_rail_by_itself() {
    let mut points = head();
    let end = points[points.len() - 1];
    points.push([8.0, end[1] + 14.0]);
    points.insert(0, [-8.0, end[1] + 14.0]);
    let head = read("h.txt", columns(&head()).as_bytes(), &wanted(Role::Rail)).unwrap().profile;
    for sign in [-1.0, 1.0] {
        let turned: Vec<[f64; 2]> = points.iter().map(|[y, z]| [*y, sign * z]).collect();
        let found = read("r.txt", columns(&turned).as_bytes(), &ReadOptions::default()).unwrap();
        assert_eq!(found.profile.role(), Role::Rail);
        // Where no underside lies below.
        let off = apart(&found.profile, &head, [-7e-3, 7e-3]);
        assert!(off < 1e-12, "{off:e} {:?}", found.actions);
    }
}

/// A point that somebody added to the end of a side makes a sharp corner, 126 degrees, between long stretches; one that
/// goes back by more than 150 is refused.
#[test]
fn a_sharp_corner_between_long_stretches_is_kept() {
    let points = head();
    let end = points[points.len() - 1];
    let with = |by: [f64; 2]| {
        let points: Vec<_> =
            points.iter().copied().chain([[end[0] + by[0], end[1] + by[1]]]).collect();
        read("r.txt", columns(&points).as_bytes(), &wanted(Role::Rail))
    };
    let plain = read("h.txt", columns(&points).as_bytes(), &wanted(Role::Rail)).unwrap().profile;
    let off = apart(&with([-3.0, -2.0]).unwrap().profile, &plain, [-0.03, 0.03]);
    assert!(off < 1e-12, "{off:e}");
    let back = with([-1.0, -8.0]);
    assert!(
        matches!(back, Err(FileError::TurnsBack { .. } | FileError::Overlap { .. })),
        "{back:?}"
    );
}

#[test]
fn quotes_fortrans_exponents_and_long_minuses_are_numbers() {
    let points = wheel();
    let plain = read_wheel(&columns(&points)).unwrap().profile;
    for text in [
        rows(&points, |[y, z]| format!("\"{y}\",\"{z}\"")),
        rows(&points, |[y, z]| format!("{y:e} {z:e}").replace('e', "D")),
        columns(&points).replace('-', "\u{2212}"),
    ] {
        let found = read_wheel(&text).unwrap_or_else(|error| panic!("{error}: {}", &text[..40]));
        assert!(apart(&found.profile, &plain, [-0.03, 0.05]) < 1e-12);
    }
}

/// Of a notch of turns half a millimetre apart none is a corner by itself, and all are where nothing beside them is
/// looked at.
#[test]
fn corners_are_those_that_are_asked_for() {
    let mut points = head();
    let top = points.iter().position(|point| point[0] >= 0.0).unwrap();
    // Of one point alone it would be a spike.
    for point in &mut points[top..top + 2] {
        point[1] += 0.5;
    }
    let text = columns(&points);
    let turns = |corners: Option<CornerSearch>| {
        let wanted = ReadOptions { corners, ..wanted(Role::Rail) };
        let actions = read("rail.txt", text.as_bytes(), &wanted).unwrap().actions;
        let count = |is: fn(&Action) -> bool| actions.iter().filter(|action| is(action)).count();
        [
            count(|action| matches!(action, Action::Corner { .. })),
            count(|action| matches!(action, Action::Rough { .. })),
        ]
    };
    assert_eq!(turns(None), [0, 4]);
    let alone = CornerSearch { reach: 0.0, ..CornerSearch::default() };
    assert_eq!(turns(Some(alone)), [4, 0]);
    // A turn of 45 degrees and back is below a threshold of 100.
    assert_eq!(turns(Some(CornerSearch { turn: 1.75, ..alone })), [0, 0]);
}
