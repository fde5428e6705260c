//! Cases of a wheel on a rail (module 1).

use std::fs;
use std::path::Path;

use creepage_import::{Imported, import};

use crate::{ball, has, read, text};

pub(crate) const WHEEL: &str = " 1 MODULE\n 0203100 CPBTNFS\n 1022033 VLDCMZE\n 0001321 HGIAOWR\n 99 99 30 1 1e-5 settings\n 2 NVF\n \
                     -20d .2 .2\n -10d .3 .3\n .28 .28 82000. 82000. material\n .2 .2 1. 90d 8. 4. grid\n \
                     14. 0 1435. 0.025 track\n 'Profiles\\RAIL.prr' 0 1. 0. 0 1 rail\n 0 150d 30d 6d 2. kinks\n \
                     1. 2. .003 4. 5. .006 deviation\n 1360. -70. 460. wheelset\n 'wheel.PRW' 0 1. 1. wheel\n \
                     0. 3. 10000. -.0001 .002 0. position\n 2000. 1. 0. 0. 0. -4.35 velocity\n";

pub(crate) fn read_wheel(text: &str, place: &Path) -> Imported {
    fs::create_dir_all(place.join("profiles")).unwrap();
    fs::write(place.join("profiles/Rail.prr"), "rail").unwrap();
    fs::write(place.join("wheel.prw"), "wheel").unwrap();
    fs::write(place.join("own.inp"), text).unwrap();
    import(&place.join("own.inp"), &place.join("out")).unwrap()
}

#[test]
fn a_wheel_keeps_its_axes_and_its_profiles_are_found_and_copied() {
    let place = tempfile::tempdir().unwrap();
    let imported = read_wheel(WHEEL, place.path());
    let wheel = text(&imported.cases[0], 0);
    has(
        &wheel,
        &[
            "profile = \"Rail.prr\"",
            "profile = \"wheel.prw\"",
            // A weight of 1 mm3.
            "reading = { smooth_weight = 1e-9 }",
            "radius = 0.46",
            "flange_back = -0.07",
            "cant = 0.025",
            "dy = 0.001",
            "dz_rate = 0.005",
            "droll = 0.003",
            "gauge = 1.435",
            "gauge_height = 0.014",
            "back_to_back = 1.36",
            "side = \"left\"",
            "y = 0.003",
            "roll = -0.0001",
            "yaw = 0.002",
            "wheel_load = 10000.0",
            "speed = 2.0",
            "pitch_rate = 4.35",
            "lateral_velocity = 0.001",
            "friction = { angle = [-0.349065850399, -0.174532925199], value = [0.2, 0.3] }",
        ],
    );
    let names: Vec<_> = imported.profiles.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["wheel.prw", "Rail.prr"]);
    assert_eq!(imported.profiles[1].contents, b"rail");
    assert!(!place.path().join("out").exists(), "reading writes nothing");
}

#[test]
fn a_missing_profile_and_slices_are_causes() {
    let cause = |change: [&str; 2]| {
        let place = tempfile::tempdir().unwrap();
        let imported = read_wheel(&WHEEL.replace(change[0], change[1]), place.path());
        imported.cases[0].written.clone().unwrap_err().to_string()
    };
    let missing = cause(["wheel.PRW", "none.prw"]);
    assert_eq!(missing, "file none.prw was not found beside own.inp");
    let slices = cause(["wheel.PRW", "none.slcw"]);
    assert_eq!(slices, "file none.slcw was not found beside own.inp");
}

/// A roller's line ends with its radius, and its turning is a speed of the rim.
#[test]
fn a_roller_is_a_rail_with_a_radius() {
    let place = tempfile::tempdir().unwrap();
    let roller = WHEEL.replace("0203100", "5203100").replace("0.025 track", "300. track");
    let imported = read_wheel(&roller.replace("2000. 1.", "6.5 1."), place.path());
    let wheel = text(&imported.cases[0], 0);
    has(&wheel, &["roller_radius = 0.3", "speed = 1.95", "side = \"right\""]);
    assert!(!wheel.contains("cant") && !wheel.contains("curvature"), "{wheel}");
}

/// A profile with a groove has its guard rail beyond it.
#[test]
fn a_groove_has_a_guard_rail() {
    let place = tempfile::tempdir().unwrap();
    let profile = |depth: f64| -> String {
        let height =
            |y: f64| if y < 0.0 { depth * (-((y + 20.0) / 6.0f64).powi(4)).exp() } else { 0.0 };
        let rows = (-60..=70).map(|y| format!("{y} {:.4}\n", height(f64::from(y))));
        rows.collect()
    };
    for (depth, is_grooved) in [(12.0, true), (2.0, false)] {
        fs::write(place.path().join("groove.txt"), profile(depth)).unwrap();
        let imported = read_wheel(&WHEEL.replace("Profiles\\RAIL.prr", "groove.txt"), place.path());
        let wheel = text(&imported.cases[0], 0);
        assert_eq!(wheel.contains("guard = { grooved = true }"), is_grooved, "{wheel}");
    }
}

/// A list of slices becomes a file of ours whose profiles lie beside the case.
#[test]
fn slices_become_a_file_of_slices() {
    let place = tempfile::tempdir().unwrap();
    let directory = place.path().join("parts");
    fs::create_dir(&directory).unwrap();
    for name in ["one.txt", "Two.txt"] {
        fs::write(directory.join(name), "0 0\n1 0\n").unwrap();
    }
    let list = "% own\n 0.5 2.0 offset, scale\n 2 slices\n 3 1 0 counts\n 2 approximating\n\
        -1.0 'parts/one.txt'\n 9.5 'PARTS/two.txt' % last\n 1 kink\n\
        -1.0 0.0 -1.0 30.0\n 9.5 0.0 12.5 30.0\n";
    fs::write(place.path().join("own.slcs"), list).unwrap();
    let text_of_case = WHEEL.replace("Profiles\\RAIL.prr", "own.slcs");
    let imported = read_wheel(&text_of_case, place.path());
    let case = text(&imported.cases[0], 0);
    has(&case, &["slices = \"own.slices.toml\"", "s = 0.0", "pitch = 0.0"]);
    assert!(imported.cases[0].notes.iter().any(|note| note.contains("INTPOL")));
    let own = imported.profiles.iter().find(|file| file.name == "own.slices.toml").unwrap();
    let own = String::from_utf8(own.contents.clone()).unwrap();
    has(
        &own,
        &[
            "kinks = [2]",
            "    { u = -0.001, profile = \"one.txt\", features = [0.0, -0.001, 0.03] },",
            "    { u = 0.02, profile = \"Two.txt\", features = [0.0, 0.0125, 0.03] },",
        ],
    );
}

/// Broken words anywhere give an error or a case, never a panic.
#[test]
fn no_broken_file_panics() {
    let whole = ball("203110", "1000. 0.5 .001 .0002", "0.0 0.2 2000. CHI") + WHEEL;
    let words: Vec<&str> = whole.split(' ').collect();
    for place in 0..words.len() {
        for change in ["", "-1", "9999999", "1e300", "0", "x", "'a'", "5*2"] {
            let mut words = words.clone();
            words[place] = change;
            let _ = read(&words.join(" "));
        }
    }
}

/// Steps of a wheel are a table of positions; a steady case before them is where they begin.
#[test]
fn steps_of_a_wheel_are_a_table() {
    let place = tempfile::tempdir().unwrap();
    let goes_on = |first: &str| WHEEL.replace("0203100", first) + " 1 MODULE\n";
    let next = |first: &str, position: &str| {
        format!(
            " {first} CPBTNFS\n 1111002 VLDCMZE\n 0101321 HGIAOWR\n {position} position\n 4. 0. 0. 0. 0. -.0087 velocity\n"
        )
    };
    let steps = goes_on("0203100") + &next("0002100", "0. 3.5 10000. 0. .002 0.");
    let imported = read_wheel(&steps, place.path());
    let [steady, step] = &imported.cases[..] else { panic!("{imported:?}") };
    assert_eq!(steady.written.as_ref().unwrap().command, "creepage wheelset own-1.toml");
    let written = step.written.as_ref().unwrap();
    assert_eq!(written.command, "creepage roll own-2.toml --history own-2.csv");
    has(&text(step, 0), &["[start]", "traction = \"steady\""]);
    let table = text(step, 1);
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0][6], "wheel_load");
    // DX times DQREL is .2 mm.
    assert_eq!(rows.iter().skip(1).map(|row| row[0]).collect::<Vec<_>>(), ["0.0002", "0.0004"]);
    assert_eq!(rows.iter().skip(1).map(|row| row[3]).collect::<Vec<_>>(), ["0.003", "0.0035"]);
    assert_eq!(rows[2][8], "0.0087");

    // Shifts: the way is that of the shift along the track.
    let shifts = goes_on("0201100").replace("2000. 1. 0. 0. 0. -4.35", "4. 0. 0. 0. 0. -.0087")
        + &next("0001100", "5. 3. 10000. 0. .002 0.");
    let imported = read_wheel(&shifts, place.path());
    let [_, second] = &imported.cases[..] else { panic!("{imported:?}") };
    has(&text(second, 0), &["traction = \"none\""]);
    let table = text(second, 1);
    let distances: Vec<&str> =
        table.lines().skip(1).filter_map(|line| line.split(',').next()).collect();
    assert_eq!(distances, ["0.004", "0.008"]);
    assert!(second.notes.iter().any(|note| note.contains("SHFT_S")), "{:?}", second.notes);

    let stands = WHEEL.replace("0203100", "0201100").replace("2000. 1. 0.", "0. 1. 0.");
    let imported = read_wheel(&stands, place.path());
    assert!(imported.cases[0].written.as_ref().unwrap_err().to_string().contains("SHFT_S"));
}

/// A wheel that is narrower than a groove runs in it.
#[test]
fn a_disc_in_a_groove_has_no_guard_rail() {
    let place = tempfile::tempdir().unwrap();
    let arc = |radius: f64, most: i32, offset: f64| -> String {
        let rows = (-most..=most).map(|k| {
            let y = f64::from(k) * 0.5;
            format!("{y} {:.5}\n", (radius * radius - y * y).sqrt() - offset)
        });
        rows.collect()
    };
    fs::write(place.path().join("groove.txt"), arc(20.0, 39, 20.0)).unwrap();
    fs::write(place.path().join("disc.txt"), arc(19.0, 36, 19.0)).unwrap();
    let case = WHEEL.replace("Profiles\\RAIL.prr", "groove.txt").replace("wheel.PRW", "disc.txt");
    let imported = read_wheel(&case, place.path());
    let wheel = text(&imported.cases[0], 0);
    assert!(!wheel.contains("guard"), "{wheel}");
}

/// Corners are searched for as the file says, where it says other than usual.
#[test]
fn other_corners_are_searched_for() {
    let place = tempfile::tempdir().unwrap();
    let usual = text(&read_wheel(WHEEL, place.path()).cases[0], 0);
    assert!(!usual.contains("corners"), "{usual}");
    let other = WHEEL.replace("0 150d 30d 6d 2. kinks", "0 150d .5 0. 0. kinks");
    let place = tempfile::tempdir().unwrap();
    let imported = read_wheel(&other, place.path());
    let written = text(&imported.cases[0], 0);
    let corners = "corners = { turn = 0.5, rest = 0.10471975512, reach = 0.0 }";
    assert!(written.contains(corners), "{written}");
    assert!(!imported.cases[0].notes.iter().any(|note| note.contains("ZIGTHRS")));
}
