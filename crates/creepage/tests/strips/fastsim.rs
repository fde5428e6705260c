//! FASTSIM.

use std::f64::consts::{FRAC_PI_2, PI};

use creepage::approximate::fastsim::{Fastsim, Flexibility, Settings, TractionBound};
use creepage::approximate::linear::CreepageCoefficients;
use creepage::{Creepage, Region, Theory};

use super::cases::{
    self, CREEPAGES, Case, array, coefficients, contact, creepage, kappa, largest_difference,
    sum_of_field,
};

fn fastsim(a_over_b: f64, poisson: f64, settings: Settings) -> Fastsim {
    Fastsim::new(&contact(a_over_b, poisson), settings).unwrap()
}

fn force(case: &Case, settings: Settings) -> [f64; 3] {
    array(fastsim(case.a_over_b, case.poisson, settings).solve(case.creepage).force)
}

const THREE: Settings = Settings {
    flexibility: Flexibility::Three,
    bound: TractionBound::Parabolic,
    grid: [50, 50],
    reduction: Settings::CLEAN,
};

/// Forces without spin, in closed form; `slope` is `|(upsilon_x/L1, upsilon_y/L2)|`, `a` and `G`
/// and `mu N` as units.
fn closed_form(bound: TractionBound, a: f64, slope: f64) -> f64 {
    match bound {
        TractionBound::Elliptic => {
            let e = 2.0 * PI / 3.0 * a * slope;
            2.0 / PI * (e / (1.0 + e * e) + e.atan())
        }
        TractionBound::Parabolic => {
            let q = PI * a * slope / 4.0;
            if q >= 1.0 {
                return 1.0;
            }
            let s = (1.0 - q * q).sqrt();
            2.0 / PI
                * (8.0 * q * s
                    - 8.0 / 3.0 * q * s.powi(3)
                    - 4.0 / 3.0 * q.powi(3) * s
                    - 4.0 * q * q * s.asin()
                    + FRAC_PI_2
                    - 2.0 / 3.0 * s * q.powi(3)
                    - s * q
                    - s.asin())
        }
    }
}

/// The largest error against the closed form over several creepages and ratios.
fn error_without_spin(bound: TractionBound, n: usize) -> f64 {
    let mut worst = 0.0_f64;
    for (a_over_b, poisson) in [(0.2, 0.28), (1.0, 0.5), (5.0, 0.0)] {
        let settings = Settings { bound, grid: [n, n], ..THREE };
        let theory = fastsim(a_over_b, poisson, settings);
        let CreepageCoefficients { c11, c22, .. } = coefficients(a_over_b, poisson);
        let a = a_over_b.sqrt();
        for (xi, eta) in [(0.1, 0.0), (0.0, 0.6), (0.5, 0.5), (-1.0, 0.7), (3.0, 0.0)] {
            let kappa = kappa(a_over_b, poisson);
            let slopes = [xi * c11, eta * c22].map(|v| 3.0 * kappa * v / (8.0 * a));
            let size = slopes[0].hypot(slopes[1]);
            let f = closed_form(bound, a, size);
            let force = theory.solve(creepage(xi, eta, 0.0)).force;
            worst = worst.max((force.fx - f * slopes[0] / size).abs());
            worst = worst.max((force.fy - f * slopes[1] / size).abs());
        }
    }
    worst
}

#[test]
fn forces_without_spin_converge_to_the_closed_forms() {
    // Observed orders: 1.8 to 2 for the smooth parabola; 1.5 for the ellipse, whose slope at the
    // edges is infinite.
    for (bound, order, fine) in
        [(TractionBound::Parabolic, 1.7, 1e-5), (TractionBound::Elliptic, 1.4, 5e-5)]
    {
        let [coarse, middle, finest] = [20, 80, 320].map(|n| error_without_spin(bound, n));
        assert!(finest < fine, "{bound:?} {finest}");
        let order_seen = [(coarse / middle).log2() / 2.0, (middle / finest).log2() / 2.0];
        assert!(order_seen.iter().all(|seen| *seen > order), "{bound:?} {order_seen:?}");
    }
}

/// `C11`, `C22`, `C23` of the linear theory, whatever the variant; and the moments that follow
/// from the simplified theory itself.
#[test]
fn small_creepage_is_linear() {
    let (a_over_b, poisson) = (0.5, 0.25);
    let kappa = kappa(a_over_b, poisson);
    let c = coefficients(a_over_b, poisson);
    let ratio = a_over_b.sqrt();
    let c32 = -3.0 * PI / 32.0 * c.c22 * ratio;
    let c33 = 32.0 / (15.0 * PI) * c.c23 / ratio.powi(3);
    let expected = [[c.c11, 0.0, 0.0], [0.0, c.c22, c.c23], [0.0, c32, c33]];
    for flexibility in [Flexibility::One, Flexibility::Three, Flexibility::Blended] {
        for bound in [TractionBound::Parabolic, TractionBound::Elliptic] {
            let theory = fastsim(
                a_over_b,
                poisson,
                Settings { flexibility, bound, grid: [400, 400], ..Settings::default() },
            );
            for column in 0..3 {
                let mut small = [0.0; 3];
                small[column] = 1e-7;
                let force = theory.solve(creepage(small[0], small[1], small[2])).force;
                for row in 0..3 {
                    let slope = array(force)[row] / (kappa * 1e-7);
                    // The midpoint rules at 400 x 400, mostly at the trailing edge.
                    assert!((slope - expected[row][column]).abs() < 1e-4, "{row} {column} {slope}");
                }
            }
        }
    }
}

#[test]
fn reference_values_of_every_variant() {
    use Flexibility::{Blended, One, Three};
    use TractionBound::{Elliptic, Parabolic};
    for (name, flexibility, bound) in [
        ("3L_par", Three, Parabolic),
        ("3L_ell", Three, Elliptic),
        ("1L_par", One, Parabolic),
        ("1L_ell", One, Elliptic),
        ("blend_par", Blended, Parabolic),
        ("blend_ell", Blended, Elliptic),
    ] {
        let converged = Settings { flexibility, bound, grid: [400, 400], ..Settings::default() };
        let (error, case) = cases::largest_error(
            &format!("fastsim_{name}_conv"),
            |_| true,
            |case| force(case, converged),
        );
        // What the grids leave: both are converged to 0.001.
        assert!(error < 0.002, "{name}: {error} {case}");
    }
}

/// At equal grids the other implementation differs in one thing, the exact spin over each step.
#[test]
fn reference_values_without_spin_at_the_same_grid() {
    let without_spin = |case: &Case| case.creepage.chi() == 0.0;
    for n in [10, 50] {
        let (error, case) =
            cases::largest_error(&format!("fastsim_3L_par_{n}"), without_spin, |case| {
                force(case, Settings { grid: [n, n], ..THREE })
            });
        // Six digits in the table; coefficients interpolated between Poisson's ratios.
        assert!(error < 5e-5, "{error} {case}");
    }
}

/// Root mean square and largest error of the force, root mean square error of the moment, over
/// 132 cases of the full theory. Expected is what the other implementation has at 50 x 50; it
/// differs in the spin over a step.
#[test]
fn errors_against_the_full_theory() {
    for (settings, expected) in
        [(Settings::default(), [0.0352, 0.0995, 0.0158]), (THREE, [0.0493, 0.1326, 0.0537])]
    {
        let seen = cases::error_against_full_theory(|a_over_b, poisson| {
            fastsim(a_over_b, poisson, settings)
        });
        assert!(largest_difference(seen, expected) < 3e-4, "{seen:?}");
    }
}

#[test]
fn field_agrees_with_the_forces() {
    let (a_over_b, n) = (0.5, 40);
    for flexibility in [Flexibility::One, Flexibility::Three, Flexibility::Blended] {
        for bound in [TractionBound::Parabolic, TractionBound::Elliptic] {
            let theory = fastsim(
                a_over_b,
                0.25,
                Settings { flexibility, bound, grid: [n, n], ..Settings::default() },
            );
            for [xi, eta, chi] in CREEPAGES {
                let at = creepage(xi, eta, chi);
                let sum = sum_of_field(&theory, a_over_b, n, at);
                let difference = largest_difference(sum, array(theory.solve(at).force));
                // The same sums in another order.
                assert!(difference < 1e-12, "{difference}");
            }
        }
    }
}

/// Slip appears at the bound only, and never against the traction. With one flexibility, or in
/// full blending, it is parallel to it.
#[test]
fn slip_and_adhesion_areas() {
    let settings = Settings { flexibility: Flexibility::One, grid: [60, 60], ..THREE };
    let theory = fastsim(1.0, 0.25, settings);
    let mut seen = [0, 0];
    for [xi, eta, chi] in CREEPAGES {
        for k in 0..400 {
            let (radius, angle) = (f64::from(k) / 401.0, f64::from(k) * 2.4);
            let position = [radius * angle.cos(), radius * angle.sin()];
            let point = theory.field(creepage(xi, eta, chi), &[position])[0];
            let [tx, ty] = point.traction;
            // Kalker's paraboloid in units of the Hertz peak.
            let bound = 4.0 / 3.0 * (1.0 - radius * radius);
            let [sx, sy] = point.slip;
            if point.region == Region::Slip {
                seen[0] += 1;
                assert!((tx.hypot(ty) - bound).abs() < 1e-12);
                assert!((sx * ty - sy * tx).abs() < 1e-9 * sx.hypot(sy).max(1.0));
                assert!(sx * tx + sy * ty >= 0.0);
            } else {
                seen[1] += 1;
                assert!(tx.hypot(ty) <= bound && [sx, sy] == [0.0, 0.0]);
            }
        }
    }
    assert!(seen[0] > 500 && seen[1] > 500, "{seen:?}");
}

#[test]
fn nonsense_is_an_error() {
    let new = |a_over_b, grid| {
        Fastsim::new(&contact(a_over_b, 0.25), Settings { grid, ..Settings::default() })
    };
    let name = |result: Result<Fastsim, creepage::InvalidValue>| result.unwrap_err().quantity;
    assert_eq!(name(new(2e3, [10, 10])), "a_over_b");
    assert_eq!(name(new(1.0, [0, 10])), "grid along");
    assert_eq!(name(new(1.0, [10, 1_000_000])), "grid across");
}

/// Outside the contact there is neither traction nor slip.
#[test]
fn outside_the_contact() {
    let point = fastsim(1.0, 0.25, THREE).field(Creepage::default(), &[[0.8, 0.8]])[0];
    assert_eq!((point.traction, point.slip, point.region), ([0.0; 2], [0.0; 2], Region::Outside));
}
