//! `creepage map`.

use crate::place::Place;

const WHEELSET: &str = "
[wheel]
profile = \"S1002\"
radius = 0.46
[rail]
profile = \"UIC60\"
cant = 0.024994793618920
[track]
gauge = 1.435
gauge_height = 0.014
[wheelset]
back_to_back = 1.360
y = 0.0
roll = \"free\"
axle_load = 100e3
[motion]
speed = 20.0
[contact]
friction = 0.3
[materials]
shear_modulus = 82e9
poisson = 0.28
";

fn place() -> Place {
    let place = Place::new();
    place.write("wheelset.toml", WHEELSET);
    place
}

/// About the middle of the track, coarse: built, and its error is told.
#[test]
fn a_small_map_is_built_and_says_its_error() {
    let place = place();
    let table =
        ["table", "build", "--a-over-b", "0.15,30", "--shapes", "7", "--intervals", "8,8,16"];
    let more = ["--resolution", "fast", "--places", "10", "--out", "ellipses.nc"];
    place.run(&[&table[..], &more].concat()).done();
    let arguments = [
        "map",
        "wheelset.toml",
        "--out",
        "map.nc",
        "--y",
        "0.0008",
        "--ellipses",
        "ellipses.nc",
        "--loads",
        "20e3,50e3,100e3",
        "--resolution",
        "fast",
        "--tolerance",
        "0.05",
        "--states",
        "1",
    ];
    let text = place.run(&arguments).done();
    assert!(
        text.contains("right wheel: places") && text.contains("tangential force, of mu N"),
        "{text}"
    );
    assert!(place.path("map.nc").exists() && !place.path("map.nc.journal").exists());
    // The map itself is no table.
    place
        .run(&["map", "wheelset.toml", "--out", "other.nc", "--ellipses", "map.nc"])
        .refused(&["map.nc is a contact map, not a table of creep force"]);
    place.run(&["table", "info", "map.nc"]).refused(&["map.nc is a contact map"]);
    place
        .run(&["fmu", "ellipses.nc", "--out", "wheelset.fmu"])
        .refused(&["ellipses.nc is a table of creep force, not a contact map"]);
    place
        .run(&["fmu", "map.nc", "--exact", "--out", "wheelset.fmu"])
        .refused(&["map.nc is a contact map; --exact takes the wheelset's file"]);
    assert_eq!(place.files(), ["ellipses.nc", "map.nc", "wheelset.toml"]);
}

/// By the names of options, and before a table of ellipses is begun.
#[test]
fn wrong_numbers_of_a_plan_are_refused_by_their_options() {
    let place = place();
    for (option, value, words) in [
        ("--y", "-1", "--y must be above 0 m, at most 0.05 m, got -1"),
        ("--y", "nan", "--y must be above 0 m, at most 0.05 m, got NaN"),
        ("--yaw", "-1", "--yaw must be 0 to 0.05 rad, got -1"),
        ("--yaw", "2", "--yaw must be 0 to 0.05 rad, got 2"),
        ("--tolerance", "0", "--tolerance must be positive and finite, got 0"),
        ("--tolerance", "-1", "--tolerance must be positive and finite, got -1"),
        ("--narrowest", "0", "--narrowest must be 5e-6 m to the width of the widest cells, got 0"),
        ("--narrowest", "-1", "--narrowest must be 5e-6 m to"),
        ("--loads", "5,4", "--loads must be rising, each above the one before, got 4"),
        ("--loads", "5,5", "--loads must be rising, each above the one before, got 5"),
        ("--loads", "-1,4", "--loads must be positive and finite, got -1"),
        ("--loads", "4,nan", "--loads must be positive and finite, got NaN"),
        ("--loads", "5", "--loads must be two or more in number, got 1"),
        ("--states", "-1", "invalid value '-1' for '--states <N>'"),
    ] {
        let ran = place.run(&["map", "wheelset.toml", "--out", "map.nc", option, value]);
        ran.refused(&[words]);
        assert!(!ran.stderr.contains("wheelset.toml"), "{}", ran.stderr);
    }
    assert_eq!(place.files(), ["wheelset.toml"]);
}

#[test]
fn wrong_plans_are_refused_and_nothing_is_written() {
    let place = place();
    let map = |more: &[&str]| {
        place.run(&[&["map", "wheelset.toml", "--out", "map.nc"][..], more].concat())
    };
    map(&["--ellipses", "none.nc"]).refused(&["cannot read none.nc"]);
    place.write("none.nc", "no table");
    map(&["--ellipses", "none.nc"]).refused(&["none.nc", "no table of creep force"]);
    place.run(&["map", "none.toml", "--out", "map.nc"]).refused(&["cannot read none.toml"]);
    place.run(&["map", "wheelset.toml", "--out", "wheelset.toml"]).refused(&["written over"]);
    place.write("height.toml", WHEELSET.replace("axle_load = 100e3", "z = 0.0"));
    place
        .run(&["map", "height.toml", "--out", "map.nc"])
        .refused(&["needs axle_load or wheel_load"]);
    // Before a table of ellipses is begun.
    for (from, to, words) in [
        ("axle_load = 100e3", "axle_load = 0.0", "axle_load = 0 is not valid"),
        ("axle_load = 100e3", "axle_load = 1e5\nroll_moment = 1e3", "roll_moment"),
        ("speed = 20.0", "speed = -20.0", "[motion] speed below zero"),
    ] {
        place.write("other.toml", WHEELSET.replace(from, to));
        let ran = place.run(&["map", "other.toml", "--out", "map.nc"]);
        ran.refused(&["other.toml", words]);
        assert!(!ran.stderr.contains("ellipses"), "{}", ran.stderr);
    }
    assert!(!place.path("map.nc").exists() && !place.path("map.nc.journal").exists());
}

/// What an FMU of the solver has no input for is named, and a file that is not the library.
#[test]
fn a_solver_in_an_fmu_refuses_what_its_inputs_cannot_say() {
    let place = place();
    place.write("library", "fmi3DoStep");
    let fmu = ["fmu", "wheelset.toml", "--out", "W.fmu", "--library", "library"];
    place.run(&fmu).refused(&["solve it in the FMU itself by --exact"]);
    for (from, to, words) in [
        ("axle_load = 100e3", "axle_load = 1e5\nroll_moment = 1e3", "roll_moment"),
        ("roll = \"free\"", "roll = 1e-4", "roll = a number under a load"),
        ("friction = 0.3", "friction = [[0.0, 0.3], [1.0, 0.2]]", "friction"),
        ("axle_load = 100e3", "y_ = 1.0", "y_"),
    ] {
        place.write("wheelset.toml", WHEELSET.replace(from, to));
        place.run(&[&fmu[..], &["--exact"]].concat()).refused(&["wheelset.toml", words]);
    }
    place.write("wheelset.toml", WHEELSET);
    let another = [&fmu[..5], &["wheelset.toml", "--exact"]].concat();
    place.run(&another).refused(&["it is not that of creepage-fmu"]);
    assert_eq!(place.files(), ["library", "wheelset.toml"]);
}
