//! Coulomb's law and the symmetries, on contacts and creepages at random.

use creepage::coulomb::Resolution;
use creepage::theory::Solved;
use creepage::{Region, Status};
use proptest::prelude::*;

use crate::common::at;
use crate::support::{exact, solve};

fn contact() -> impl Strategy<Value = (f64, f64)> {
    ((-1.9..1.8_f64).prop_map(f64::exp), 0.0..0.5_f64)
}

fn creepage() -> impl Strategy<Value = [f64; 3]> {
    [-3.0..3.0_f64, -3.0..3.0_f64, -8.0..8.0_f64]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// (4.28): reversing all, or mirroring at y = 0.
    #[test]
    fn symmetries((ratio, poisson) in contact(), [xi, eta, chi] in creepage()) {
        let theory = exact(ratio, poisson, Resolution::FAST);
        let force = solve(&theory, [xi, eta, chi]).force;
        let reversed = solve(&theory, [-xi, -eta, -chi]).force;
        let mirrored = solve(&theory, [xi, -eta, -chi]).force;
        let pairs = [
            (reversed.fx, -force.fx), (reversed.fy, -force.fy), (reversed.mz, -force.mz),
            (mirrored.fx, force.fx), (mirrored.fy, -force.fy), (mirrored.mz, -force.mz),
        ];
        for (a, b) in pairs {
            prop_assert!((a - b).abs() < 1e-10);
        }
    }

    /// In the area of slip the traction is at its bound and along the slip; in adhesion it is
    /// below; no element gives energy back.
    #[test]
    fn coulombs_law_holds((ratio, poisson) in contact(), [xi, eta, chi] in creepage()) {
        let theory = exact(ratio, poisson, Resolution::FAST);
        let solved = theory.solve_contact(at([xi, eta, chi]));
        prop_assert_eq!(solved.solution().status, Status::Solved);
        let elements = solved.elements();
        prop_assert!((elements.iter().map(|e| e.share).sum::<f64>() - 1.0).abs() < 1e-12);
        for element in &elements {
            let ([p, q], [u, v]) = (element.point.traction, element.point.slip);
            let (size, slip) = (p.hypot(q), u.hypot(v));
            // Rounding: the law holds to the last bits at what the solver leaves as residual.
            prop_assert!(size <= element.bound * (1.0 + 1e-12));
            prop_assert!(element.power >= -1e-9);
            if element.point.region == Region::Slip {
                prop_assert!(size >= element.bound * (1.0 - 1e-12));
                prop_assert!((p * v - q * u).abs() <= 1e-12 * (1.0 + slip), "{p} {q} {u} {v}");
                prop_assert!(p * u + q * v >= 0.0);
            } else {
                prop_assert!(slip <= 0.0);
            }
        }
        // Between the elements' middles the field is interpolated, and stays below the bound.
        let positions: Vec<_> = elements.iter().map(|e| e.point.position).collect();
        for point in solved.field(&positions) {
            let [x, y] = point.position;
            let bound = (1.0 - x * x / ratio - y * y * ratio).sqrt();
            prop_assert!(point.traction[0].hypot(point.traction[1]) <= bound * (1.0 + 1e-6));
            if point.region == Region::Adhesion {
                prop_assert!(point.slip[0].hypot(point.slip[1]) <= 0.0);
            }
        }
    }

    /// What is turned to heat is so in some element.
    #[test]
    fn the_elements_give_all_the_heat((ratio, poisson) in contact(), creepage in creepage()) {
        let theory = exact(ratio, poisson, Resolution::FAST);
        let solved = theory.solve_contact(at(creepage));
        let dissipation = solved.dissipation().unwrap();
        let sum: f64 = solved.elements().iter().map(|e| e.power).sum();
        // Rounding.
        prop_assert!((dissipation - sum).abs() < 1e-12 * dissipation.max(1.0));
    }
}
