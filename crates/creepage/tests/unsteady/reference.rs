use creepage::coulomb::Resolution;
use creepage::statics::PartialSlip;
use creepage::unsteady::{Prescribed, Rolled, Rolling};
use creepage::{Ellipse, Hertz, Solid, SolidPair, Status};

use super::cases::{CASES, Case, POISSON, SHIFTS, STATIONS, Shift};
use super::support::{contact, creeping};

fn histories(ids: &str) {
    let mut wrong = Vec::new();
    for case in CASES.iter().filter(|case| case.id.starts_with(ids)) {
        let contact = contact(case.a_over_b, POISSON);
        let mut rolling = Rolling::new(&contact, Resolution::STANDARD).unwrap();
        if case.shift != 0.0 {
            assert_eq!(rolling.shift(case.shift, 0.0).unwrap().solution.status, Status::Solved);
        }
        let [xi, eta, chi] = case.creepage;
        let mut motion = creeping(xi, eta, chi);
        if case.force != 0.0 {
            motion.longitudinal = Prescribed::Force(case.force);
        }
        let mut last = 0.0;
        for (k, q) in STATIONS.iter().enumerate() {
            let rolled = rolling.step((q - last) * contact.ellipse().a(), &motion).unwrap();
            assert_eq!(rolled.solution.status, Status::Solved, "{} {q}", case.id);
            wrong.extend(off(case, k, &rolled));
            last = *q;
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What is further off than half a per cent of `mu N` beyond the uncertainty; a creepage than .01
/// beyond twice that.
fn off(case: &Case, station: usize, rolled: &Rolled) -> Vec<String> {
    let force = rolled.solution.force;
    let judge = |row: &super::cases::Row| {
        let uncertainty = row.uncertainty[station];
        let (found, allowed) = match row.name {
            "fx" => (force.fx, 0.005 + uncertainty),
            "fy" => (force.fy, 0.005 + uncertainty),
            "mz" => (force.mz, 0.005 + uncertainty),
            _ => (rolled.creepage.xi(), 0.01 + 2.0 * uncertainty),
        };
        let off = found - row.values[station];
        (off.abs() > allowed).then(|| {
            let q = STATIONS[station];
            format!("{} at {q}: {} = {found:.4}, off {off:+.4} of {allowed:.4}", case.id, row.name)
        })
    };
    case.rows.iter().filter_map(judge).collect()
}

#[test]
fn a_circle_from_zero_traction() {
    histories("T1_zero");
}

#[test]
fn a_circle_from_a_shift() {
    histories("T1_shift");
}

#[test]
fn an_ellipse_from_zero_traction() {
    histories("T0.5_zero");
}

#[test]
fn an_ellipse_at_a_constant_force() {
    histories("T0.5_shift");
}

/// On the finest of the named grids shifts are within the uncertainty of the reference; the share of
/// adhesion by the area of the elements along its border besides, 2 %.
#[test]
fn shifts_are_those_of_square_grids() {
    let wrong: Vec<String> = SHIFTS.iter().flat_map(shift_off).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn shift_off(case: &Shift) -> Vec<String> {
    let rolled = shifted(case, Resolution::FINE);
    let unit = unit_over_a(case.a_over_b, case.poisson);
    let name = format!("{} {} {:?}", case.a_over_b, case.poisson, case.force);
    let shift = [rolled.creepage.xi(), rolled.creepage.eta()].map(|shift| unit * shift);
    let mut wrong = Vec::new();
    for (k, found) in shift.into_iter().enumerate() {
        let (expected, uncertainty) = (case.moved[k], case.uncertainty[k]);
        // What is zero by symmetry is so to the solver's tolerance.
        if (found - expected).abs() > uncertainty + 1e-9 {
            wrong.push(format!("{name} {k}: {found:.5e} {expected:.5e} +- {uncertainty:.1e}"));
        }
    }
    let [share, uncertainty] = case.adhesion;
    if (rolled.adhesion_share - share).abs() > uncertainty + 0.02 {
        wrong.push(format!("{name}: adhesion {} {share}", rolled.adhesion_share));
    }
    wrong
}

fn shifted(case: &Shift, resolution: Resolution) -> Rolled {
    let contact = contact(case.a_over_b, case.poisson);
    let mut rolling = Rolling::new(&contact, resolution).unwrap();
    let rolled = rolling.shift(case.force[0], case.force[1]).unwrap();
    assert_eq!(rolled.solution.status, Status::Solved);
    rolled
}

/// With Poisson's ratio zero the closed form of Cattaneo and Mindlin is exact. The standard grid is
/// within 1e-3 of it, the fine one within 2e-4.
#[test]
fn shifts_are_those_of_cattaneo_and_mindlin() {
    let body = Solid::new(82e9, 0.0).unwrap();
    for case in SHIFTS.iter().filter(|case| case.poisson == 0.0) {
        let ellipse = Ellipse::from_ratio(case.a_over_b).unwrap();
        let ellipse = Ellipse::new(5e-3 * ellipse.a(), 5e-3 * ellipse.b()).unwrap();
        let hertz = Hertz::from_ellipse(SolidPair::new(body, body), ellipse, 5e4).unwrap();
        let scaling = hertz.with_friction(0.3).unwrap().scaling();
        let force = case.force.map(|force| force * scaling.force);
        let exact = PartialSlip::new(&hertz, 0.3, force).unwrap().shift()[0];
        for (resolution, tolerance) in [(Resolution::STANDARD, 1e-3), (Resolution::FINE, 2e-4)] {
            let found = scaling.slip * scaling.length * shifted(case, resolution).creepage.xi();
            assert!((found / exact - 1.0).abs() < tolerance, "{force:?}: {found} {exact}");
        }
    }
}

/// The unit of shift `mu c^2/rho` over `a`, for the reference's mu = .3 and f00 = .0125.
fn unit_over_a(a_over_b: f64, poisson: f64) -> f64 {
    let ellipse = Ellipse::from_ratio(a_over_b).unwrap();
    let rho = 2.0 * ellipse.minor() / ((1.0 - poisson) * ellipse.integrals().e * 0.0125);
    0.3 / (rho * ellipse.a())
}
