//! FASTSIM with a memory: forces that are prescribed, and loads that change.

use creepage::approximate::fastsim::{Fastsim, Settings};
use creepage::unsteady::{Motion, Prescribed, RollingFastsim};
use creepage::{Creepage, Status, Theory};

use super::support::{contact, creeping};

fn rolling(load: f64) -> RollingFastsim {
    with_grid(load, Settings::default().grid)
}

fn with_grid(load: f64, grid: [usize; 2]) -> RollingFastsim {
    let settings = Settings { grid, ..Settings::default() };
    let mut rolling = RollingFastsim::new(&contact(1.5, 0.28), settings).unwrap();
    rolling.start_with_load(load).unwrap();
    rolling
}

/// Eight times the load makes a contact twice as large: the same in its own units.
#[test]
fn another_load_is_another_unit() {
    let small = rolling(1.0).step(0.7, &creeping(0.5, 0.1, 0.3)).unwrap();
    let large = rolling(8.0).step(1.4, &creeping(1.0, 0.2, 0.3)).unwrap();
    let (one, other) = (small.solution.force, large.solution.force);
    assert!((8.0 * one.fx - other.fx).abs() < 1e-9, "{one:?} {other:?}");
    assert!((16.0 * one.mz - other.mz).abs() < 1e-9, "{one:?} {other:?}");
    let (one, other) = (16.0 * small.dissipation, large.dissipation);
    assert!((one - other).abs() < 1e-9, "{one} {other}");
}

/// Whatever the load did before, it is forgotten after a contact length.
#[test]
fn it_ends_at_the_steady_force() {
    let creepage = Creepage::new(0.6, -0.2, 0.4).unwrap();
    let steady =
        Fastsim::new(&contact(1.5, 0.28), Settings::default()).unwrap().solve(creepage).force;
    for load in [0.0, 0.1, 5.0, 50.0] {
        let mut rolling = rolling(load);
        rolling.step(1.0, &Motion::from(creepage)).unwrap();
        rolling.press(1.0).unwrap();
        rolling.step(0.3, &Motion::from(creepage)).unwrap();
        let end = rolling.step(4.0, &Motion::from(creepage)).unwrap().solution.force;
        assert!((end.fx - steady.fx).abs() < 1e-3, "{load}: {end:?} {steady:?}");
        assert!((end.fy - steady.fy).abs() < 1e-3, "{load}: {end:?} {steady:?}");
    }
}

/// Pressed harder at once, each particle keeps its traction.
#[test]
fn a_press_at_rest_keeps_the_force() {
    let motion = creeping(0.5, 0.2, 0.3);
    let mut rolling = rolling(1.0);
    let before = rolling.step(2.0, &motion).unwrap().solution.force;
    rolling.press(4.0).unwrap();
    let pressed = rolling.step(1e-4, &motion).unwrap().solution.force;
    // Interpolated from cells of a fortieth of the contact's width, parts of 4 % one after the other.
    assert!((pressed.fx - before.fx).abs() < 0.02, "{pressed:?} {before:?}");
    assert!((pressed.fy - before.fy).abs() < 0.02, "{pressed:?} {before:?}");
}

/// A row in which the load changes, at once or row by row on the same straight line.
#[test]
fn a_row_may_be_cut_into_many() {
    let motion = creeping(0.5, 0.2, 0.3);
    for [from, to] in [[1.0, 2.0], [4.0, 1.0], [1.0, 50.0], [0.0, 1.0]] {
        let end = |rows: u32| {
            let mut rolling = rolling(from);
            rolling.step(2.0, &motion).unwrap();
            let row = |row: u32| {
                rolling.press(from + (to - from) * f64::from(row) / f64::from(rows)).unwrap();
                rolling.step(1.0 / f64::from(rows), &motion).unwrap().solution.force
            };
            (1..=rows).map(row).last().unwrap()
        };
        let (once, often) = (end(1), end(40));
        let off = (once.fx - often.fx).hypot(once.fy - often.fy);
        assert!(off < 5e-3 * to, "{from} {to}: {once:?} {often:?}");
    }
}

/// Forces that are prescribed while the load changes, also to nothing and back.
#[test]
fn it_meets_forces_under_any_load() {
    let mut rolling = rolling(1.0);
    for (load, force) in [(1.0, 0.5), (4.0, 3.0), (0.5, -0.3), (0.0, 0.0), (2.0, 1.5)] {
        rolling.press(load).unwrap();
        let longitudinal = Prescribed::Force(force);
        let motion = Motion { longitudinal, ..creeping(0.0, 0.2, 0.1) };
        let rolled = rolling.step(0.8, &motion).unwrap();
        assert_eq!(rolled.solution.status, Status::Solved, "{load}: {rolled:?}");
        // To 1e-9 of the friction force.
        assert!((rolled.solution.force.fx - force).abs() < 1e-8, "{load}: {rolled:?}");
        assert!(rolled.solution.force.magnitude() <= load * (1.0 + 1e-9), "{load}: {rolled:?}");
    }
}

/// Rolls to a distance at once, or row by row on the same straight line of the load.
fn rolled(
    [from, to]: [f64; 2],
    distance: f64,
    rows: u32,
    motion: &Motion,
) -> creepage::unsteady::Rolled {
    let mut rolling = with_grid(from, [12, 8]);
    let row = |row: u32| {
        rolling.press(from + (to - from) * f64::from(row) / f64::from(rows)).unwrap();
        rolling.step(distance / f64::from(rows), motion).unwrap()
    };
    (1..=rows).map(row).last().unwrap()
}

/// Rows that are marched whole, against one of which the beginning is left out: the memory fades by
/// more than `1e-6 mu N` over the contact lengths that are marched. A force near `mu N` settles slowest.
#[test]
fn a_long_row_ends_as_if_it_were_marched() {
    let forces = |fx: f64, fy: f64| Motion::forces(fx, fy);
    let motions = [creeping(0.5, 0.2, 0.3), forces(0.3, -0.2), forces(0.6, 0.5)];
    for (loads, tolerance) in [([1.0, 1.0], 1e-6), ([0.85, 1.0], 1e-6), ([1.3, 1.0], 1e-6)] {
        for motion in &motions {
            // A row of 3 c is marched whole: the contact length is 2.4 c.
            let [once, often] = [1, 20].map(|rows| rolled(loads, 60.0, rows, motion));
            assert_eq!(once.solution.status, Status::Solved);
            assert_eq!(often.solution.status, Status::Solved);
            let (one, other) = (once.solution.force, often.solution.force);
            for (one, other) in one.components().into_iter().zip(other.components()) {
                assert!((one - other).abs() < tolerance * loads[1], "{loads:?}: {one} {other}");
            }
            let [one, other] = [once, often].map(|end| end.creepage);
            let off = (one.xi() - other.xi()).hypot(one.eta() - other.eta());
            assert!(off < 10.0 * tolerance, "{loads:?}: {one:?} {other:?}");
            assert!((once.distance - often.distance).abs() < 1e-9);
        }
    }
}

#[test]
fn a_row_of_any_length_ends() {
    for motion in [creeping(0.5, 0.2, 0.3), Motion::forces(0.5, 0.3)] {
        let known = rolled([1.0, 1.0], 100.0, 1, &motion);
        if motion == creeping(0.5, 0.2, 0.3) {
            let apart = rolled([1.0, 0.0], 1e25, 1, &motion);
            assert_eq!((apart.solution.force.fx, apart.distance), (0.0, 1e25));
        }
        for distance in [1e6, 1e25, 1e300] {
            let end = rolled([1.0, 1.0], distance, 1, &motion);
            assert_eq!(end.solution.force, known.solution.force, "{distance}");
            for loads in [[0.0, 1.0], [0.3, 1.0]] {
                let end = rolled(loads, distance, 1, &motion);
                // The load still changes by 3e-5 over the last contact lengths of the shortest.
                let off = (end.solution.force.fx - known.solution.force.fx).abs();
                assert!(off < 1e-4, "{loads:?} {distance}: {end:?}");
            }
        }
    }
}
