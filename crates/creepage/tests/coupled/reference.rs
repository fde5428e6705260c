//! Against CONTACT (open source, v25.2) with its full Panagiotopoulos process: six grids each,
//! extrapolated, with the uncertainty of that.

use creepage::coulomb::{Constraints, Exact, Resolution};
use creepage::theory::Solved;
use creepage::{Contact, Solid, Status};

use crate::support::{aluminium, at, components, contact, coupled, polymer, steel};

/// Steel on another solid; values and their uncertainties.
struct Case {
    name: &'static str,
    lower: fn() -> Solid,
    ratio: f64,
    friction: f64,
    creepage: [f64; 3],
    one_way: [[f64; 3]; 2],
    coupled: [[f64; 3]; 2],
    peak: [f64; 2],
    area: [f64; 2],
}

#[rustfmt::skip]
const CASES: [Case; 10] = [
    Case { name: "Al01", lower: aluminium, ratio: 1.0, friction: 0.3, creepage: [0.0, 0.0, 0.0], one_way: [[-0.29569, 0.0, 0.0], [0.00185, 0.0001, 0.0001]], coupled: [[-0.29572, 0.0, 0.0], [0.00201, 0.0001, 0.0001]], peak: [1.01342, 0.00019], area: [0.99589, 0.00521] },
    Case { name: "Al03", lower: aluminium, ratio: 0.5, friction: 0.3, creepage: [0.0, 0.0, 0.0], one_way: [[-0.35039, 0.0, 0.0], [0.00185, 0.0001, 0.0001]], coupled: [[-0.35061, 0.0, 0.0], [0.00206, 0.0001, 0.0001]], peak: [1.01426, 0.00015], area: [0.9932, 0.00609] },
    Case { name: "Al05", lower: aluminium, ratio: 1.0, friction: 0.3, creepage: [0.5, 0.0, 0.0], one_way: [[0.20699, 0.0, 0.0], [0.00283, 0.0001, 0.0001]], coupled: [[0.20481, 0.0, 0.0], [0.00285, 0.0001, 0.0001]], peak: [1.00705, 0.00015], area: [0.99959, 0.00418] },
    Case { name: "Al07", lower: aluminium, ratio: 1.0, friction: 0.05, creepage: [0.5, 0.0, 0.0], one_way: [[-0.71124, 0.0, 0.0], [0.00139, 0.0001, 0.0001]], coupled: [[-0.71226, 0.0, 0.0], [0.00103, 0.0001, 0.0001]], peak: [1.00254, 0.00015], area: [1.00159, 0.0048] },
    Case { name: "Al09", lower: aluminium, ratio: 0.5, friction: 0.3, creepage: [0.0, 0.0, 1.0], one_way: [[-0.23744, 0.23038, 0.32828], [0.00163, 0.00033, 0.00088]], coupled: [[-0.23429, 0.23059, 0.32544], [0.00163, 0.00036, 0.00068]], peak: [1.0152, 0.00015], area: [0.99667, 0.00233] },
    Case { name: "Po01", lower: polymer, ratio: 1.0, friction: 0.3, creepage: [0.0, 0.0, 0.0], one_way: [[-0.54555, 0.0, 0.0], [0.00222, 0.0001, 0.0001]], coupled: [[-0.54569, 0.0, 0.0], [0.00178, 0.0001, 0.0001]], peak: [1.07972, 0.00071], area: [0.97959, 0.00283] },
    Case { name: "Po03", lower: polymer, ratio: 0.5, friction: 0.3, creepage: [0.0, 0.0, 0.0], one_way: [[-0.62118, 0.0, 0.0], [0.0023, 0.0001, 0.0001]], coupled: [[-0.62339, 0.0, 0.0], [0.00183, 0.0001, 0.0001]], peak: [1.08285, 0.00355], area: [0.98179, 0.00189] },
    Case { name: "Po05", lower: polymer, ratio: 1.0, friction: 0.3, creepage: [0.5, 0.0, 0.0], one_way: [[-0.21741, 0.0, 0.0], [0.00344, 0.0001, 0.0001]], coupled: [[-0.22981, 0.0, 0.0], [0.0033, 0.0001, 0.0001]], peak: [1.059, 0.00021], area: [0.9712, 0.00296] },
    Case { name: "Po07", lower: polymer, ratio: 1.0, friction: 0.05, creepage: [0.5, 0.0, 0.0], one_way: [[-0.89445, 0.0, 0.0], [0.00182, 0.0001, 0.0001]], coupled: [[-0.89732, 0.0, 0.0], [0.00151, 0.0001, 0.0001]], peak: [1.00088, 0.00015], area: [1.00212, 0.00481] },
    Case { name: "Po09", lower: polymer, ratio: 0.5, friction: 0.3, creepage: [0.0, 0.0, 1.0], one_way: [[-0.50415, 0.18437, 0.24956], [0.00208, 0.00047, 0.00142]], coupled: [[-0.50771, 0.18585, 0.23388], [0.00173, 0.00052, 0.00129]], peak: [1.07268, 0.00145], area: [0.98471, 0.00207] },
];

/// The creepage of free rolling.
struct Free {
    lower: fn() -> Solid,
    ratio: f64,
    friction: f64,
    one_way: [f64; 2],
    coupled: [f64; 2],
    peak: [f64; 2],
    area: [f64; 2],
}

#[rustfmt::skip]
const FREE: [Free; 4] = [
    Free { lower: aluminium, ratio: 1.0, friction: 0.3, one_way: [0.30617, 0.00245], coupled: [0.30894, 0.00255], peak: [1.00931, 0.00015], area: [0.99912, 0.00463] },
    Free { lower: aluminium, ratio: 0.5, friction: 0.3, one_way: [0.38195, 0.00269], coupled: [0.38512, 0.00277], peak: [1.00836, 0.00016], area: [0.99901, 0.00435] },
    Free { lower: polymer, ratio: 1.0, friction: 0.3, one_way: [0.73467, 0.0035], coupled: [0.75647, 0.00429], peak: [1.05, 0.00036], area: [0.97353, 0.01051] },
    Free { lower: polymer, ratio: 0.5, friction: 0.3, one_way: [0.91339, 0.00424], coupled: [0.93949, 0.00491], peak: [1.04513, 0.00031], area: [0.97724, 0.00418] },
];

/// What a difference is beyond a multiple of the uncertainty.
fn beyond(found: f64, [value, uncertainty]: [f64; 2], times: f64) -> f64 {
    ((found - value).abs() - times * uncertainty).max(0.0)
}

fn case_contact(case: &Case) -> Contact {
    contact(steel(), (case.lower)(), case.ratio, case.friction)
}

#[test]
#[allow(clippy::print_stdout)]
fn one_way_forces_are_met() {
    let (mut sum, mut count) = (0.0, 0.0);
    for case in &CASES {
        let theory = Exact::new(&case_contact(case), Resolution::STANDARD).unwrap();
        let found = components(theory.solve_contact(at(case.creepage)).solution().force);
        let [value, unc] = case.one_way;
        for k in 0..3 {
            sum += beyond(found[k], [value[k], unc[k]], 1.0).powi(2);
            count += 1.0;
        }
    }
    let rms = f64::sqrt(sum / count);
    println!("one way: rms {rms:.5} beyond the uncertainty");
    assert!(rms < 0.003, "{rms}");
}

/// The bound is half a per cent of `mu N` beyond twice the uncertainty, for the moment in `mu N c` twice
/// that. The peak is met within half a per cent too, and its error bar tells by how much.
#[allow(clippy::print_stdout)]
fn is_met(case: &Case) {
    let theory = coupled(&case_contact(case), Resolution::STANDARD);
    let solved = theory.solve_contact(at(case.creepage));
    assert_eq!(solved.solution().status, Status::Solved, "{}", case.name);
    let (found, [value, unc]) = (components(solved.solution().force), case.coupled);
    for (k, most) in [0.005, 0.005, 0.01].into_iter().enumerate() {
        let beyond = beyond(found[k], [value[k], unc[k]], 2.0);
        assert!(beyond < most, "{} {found:?}", case.name);
    }
    println!(
        "{} {found:.5?} peak {:.5} +- {:.5}, {:?} area {:.5}, {:?}",
        case.name,
        solved.peak(),
        solved.peak_error(),
        case.peak,
        solved.area(),
        case.area
    );
    assert!(beyond(solved.peak(), case.peak, 2.0) < 5e-3, "{} {}", case.name, solved.peak());
    let covered = [case.peak[0], solved.peak_error() + case.peak[1]];
    assert!(beyond(solved.peak(), covered, 1.0) == 0.0, "{} {}", case.name, solved.peak());
    assert!(beyond(solved.area(), case.area, 2.0) < 2e-3, "{} {}", case.name, solved.area());
}

#[test]
fn steel_on_aluminium_is_met() {
    CASES.iter().filter(|case| case.name.starts_with("Al")).for_each(is_met);
}

#[test]
fn steel_on_a_polymer_is_met() {
    CASES.iter().filter(|case| case.name.starts_with("Po")).for_each(is_met);
}

/// Creepage within a per cent beyond twice the uncertainty.
#[allow(clippy::print_stdout)]
fn rolls_freely(case: &Free) {
    let contact = contact(steel(), (case.lower)(), case.ratio, case.friction);
    let free =
        Constraints { eta: Some(0.0), chi: Some(0.0), fx: Some(0.0), ..Constraints::default() };
    let one_way = Exact::new(&contact, Resolution::STANDARD).unwrap();
    let one_way = one_way.find(free).unwrap().creepage().xi();
    let theory = coupled(&contact, Resolution::STANDARD);
    let solved = theory.find(free).unwrap();
    let xi = solved.creepage().xi();
    assert!(beyond(one_way, case.one_way, 2.0) < 0.01 * case.one_way[0], "{one_way}");
    assert!(beyond(xi, case.coupled, 2.0) < 0.01 * case.coupled[0], "{xi}");
    println!(
        "{} one way {one_way:.5}, {:?}; xi {xi:.5}, {:?}; peak {:.5} +- {:.5}, {:?}",
        case.ratio,
        case.one_way,
        case.coupled,
        solved.peak(),
        solved.peak_error(),
        case.peak
    );
    assert!(beyond(solved.peak(), case.peak, 2.0) < 5e-3, "{}", solved.peak());
    assert!(beyond(solved.area(), case.area, 2.0) < 2e-3, "{}", solved.area());
}

#[test]
fn free_rolling_on_aluminium_is_met() {
    FREE[..2].iter().for_each(rolls_freely);
}

#[test]
fn free_rolling_on_a_polymer_is_met() {
    FREE[2..].iter().for_each(rolls_freely);
}
