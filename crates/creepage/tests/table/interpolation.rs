//! Between its nodes a table is symmetric, smooth, monotone and finite.

use creepage::approximate::linear::Linear;
use creepage::{Creepage, Force, Theory};
use proptest::prelude::*;

use super::common::{contact, creepage};
use super::fixtures::{FASTSIM, RANGES, fastsim};

#[test]
fn at_a_node_the_table_is_the_theory() {
    let theory = fastsim(&contact(1.0, 0.28)).unwrap();
    let slice = FASTSIM.at(1.0, 0.28).unwrap();
    // By the scales of a circle t = 1/2 and phi = 0, pi/2; pi/4 is a node of both angles, too.
    let (pure, half) = (2.0, 2.0_f64.sqrt());
    for [xi, eta, chi] in [[pure, 0.0, 0.0], [0.0, pure, 0.0], [0.0, 0.0, pure], [half, 0.0, half]]
    {
        let creepage = creepage(xi, eta, chi);
        let (found, right) = (slice.force(creepage), theory.solve(creepage).force);
        let off = [found.fx - right.fx, found.fy - right.fy, found.mz - right.mz];
        // Nodes are kept to seven digits.
        assert!(off.iter().all(|off| off.abs() < 1e-6), "{off:?}");
    }
}

fn any_creepage() -> impl Strategy<Value = Creepage> {
    let size = || (-3.0..3.0_f64, any::<bool>());
    let signed = |(power, negative): (f64, bool)| {
        if negative { -(10_f64.powf(power)) } else { 10_f64.powf(power) }
    };
    (size(), size(), size()).prop_map(move |(x, y, z)| creepage(signed(x), signed(y), signed(z)))
}

proptest! {
    /// (4.28), to the last bit.
    #[test]
    fn mirror_images_have_mirror_forces(at in any_creepage()) {
        for table in [&FASTSIM, &RANGES] {
            let slice = table.at(1.0, 0.28).unwrap();
            let force = slice.force(at);
            let along = slice.force(creepage(-at.xi(), at.eta(), at.chi()));
            prop_assert_eq!(along, Force { fx: -force.fx, ..force });
            let across = slice.force(creepage(at.xi(), -at.eta(), -at.chi()));
            prop_assert_eq!(across, Force { fy: -force.fy, mz: -force.mz, ..force });
        }
    }

    /// Central differences; their own error is of order `h^2` times the third derivative, which
    /// jumps from cell to cell, but for creepages near zero a relative step keeps it small.
    #[test]
    fn the_derivative_is_that_of_the_force(at in any_creepage()) {
        for table in [&FASTSIM, &RANGES] {
            let slice = table.at(1.0, 0.28).unwrap();
            let (force, derivative) = slice.force_and_derivative(at);
            prop_assert_eq!(force, slice.force(at));
            let v = [at.xi(), at.eta(), at.chi()];
            for k in 0..3 {
                let h = 1e-5 * v[k].abs();
                let side = |h: f64| {
                    let mut moved = v;
                    moved[k] += h;
                    let f = slice.force(creepage(moved[0], moved[1], moved[2]));
                    [f.fx, f.fy, f.mz]
                };
                let (ahead, behind) = (side(h), side(-h));
                for i in 0..3 {
                    let difference = (ahead[i] - behind[i]) / (2.0 * h);
                    let off = (derivative[i][k] - difference).abs() * v[k].abs();
                    prop_assert!(off < 1e-4, "{i} {k} {} {difference}", derivative[i][k]);
                }
            }
        }
    }

    /// A continuous derivative: across the planes without spin and without `xi`, and across the
    /// axis of pure spin, it is the same from either side.
    #[test]
    fn the_derivative_does_not_jump(x in 0.01..20.0_f64, y in 0.01..20.0_f64, angle in 0.0..6.2_f64) {
        let slice = FASTSIM.at(1.0, 0.28).unwrap();
        let small = 1e-9;
        let (sin, cos) = angle.sin_cos();
        for [one, two] in [
            [[x, y, small], [x, y, -small]],
            [[small, x, y], [-small, x, y]],
            [[small * cos, small * sin, x], [small, 0.0, x]],
            // At zero.
            [[small * cos, small * sin, small], [small, 0.0, -small]],
        ] {
            let [one, two] = [one, two].map(|[xi, eta, chi]| {
                slice.force_and_derivative(creepage(xi, eta, chi)).1
            });
            for (one, two) in one.as_flattened().iter().zip(two.as_flattened()) {
                // Nodes are kept to seven digits; near zero slopes are divided by t.
                prop_assert!((one - two).abs() < 2e-5 * (1.0 + one.abs()), "{one} {two}");
            }
        }
    }

    #[test]
    fn any_creepage_has_a_finite_force(
        xi in -Creepage::MAX..Creepage::MAX, eta in -1e-300..1e-300_f64, chi in -1e9..1e9_f64,
    ) {
        let slice = FASTSIM.at(1.0, 0.28).unwrap();
        for at in [[xi, eta, chi], [eta, xi, chi], [eta, chi, xi], [0.0, eta, 0.0]] {
            let at = creepage(at[0], at[1], at[2]);
            let (force, derivative) = slice.force_and_derivative(at);
            prop_assert!(force.magnitude() < 1.01 && force.mz.abs() < 2.0);
            prop_assert!(derivative.as_flattened().iter().all(|d| d.is_finite()));
        }
    }
}

/// Without spin the force along a ray rises to full sliding: between nodes too.
#[test]
fn without_spin_the_force_rises_with_creepage() {
    let slice = FASTSIM.at(1.0, 0.28).unwrap();
    let mut last = [0.0; 2];
    for k in 1..20_000 {
        let size = 0.0005 * f64::from(k);
        let along = slice.force(creepage(size, 0.0, 0.0));
        let across = slice.force(creepage(0.0, size, 0.0));
        assert!([along.fy, along.mz, across.fx].iter().all(|zero| *zero == 0.0));
        // Rounding of a sum of terms of order one.
        assert!(along.fx > last[0] - 1e-15 && across.fy > last[1] - 1e-15, "{size}");
        last = [along.fx, across.fy];
    }
    let end = creepage(10.0, 0.0, 0.0);
    let right = fastsim(&contact(1.0, 0.28)).unwrap().solve(end).force.fx;
    // The slope of the error between nodes, here where the force hardly changes.
    assert!((last[0] - right).abs() < 1e-4, "{last:?} {right}");
}

/// For vanishing creepage a table of FASTSIM is linear theory, whose coefficients are FASTSIM's
/// to the error of its cells.
#[test]
fn near_zero_the_derivative_is_that_of_linear_theory() {
    let linear = Linear::new(&contact(1.0, 0.28)).unwrap().jacobian(Creepage::default()).unwrap();
    let slice = FASTSIM.at(1.0, 0.28).unwrap();
    let (force, found) = slice.force_and_derivative(Creepage::default());
    assert_eq!(force, Force::default());
    for [i, k] in [[0, 0], [1, 1], [1, 2]] {
        assert!((found[i][k] / linear[i][k] - 1.0).abs() < 0.01, "{found:?} {linear:?}");
    }
}
