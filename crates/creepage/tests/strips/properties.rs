//! What holds for every input.

use std::sync::LazyLock;

use creepage::approximate::fastrip::{Fastrip, Variant};
use creepage::approximate::fastsim::{Fastsim, Flexibility, Settings, TractionBound};
use creepage::approximate::strip::StripTheory;
use creepage::{Contact, Creepage, Force, Status, Theory};
use proptest::prelude::*;

use super::cases::{array, contact, creepage, largest_difference};

const GRID: [usize; 2] = [12, 9];

fn component() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -3.0..3.0,
        1 => Just(0.0),
        1 => Just(1e-300),
        1 => Just(-1e-9),
        1 => Just(1e6),
        1 => Just(-1e6),
        1 => Just(f64::MAX),
    ]
}

fn any_creepage() -> impl Strategy<Value = Creepage> {
    [component(), component(), component()].prop_map(|components| {
        let [xi, eta, chi] = components.map(|v| v.clamp(-Creepage::MAX, Creepage::MAX));
        creepage(xi, eta, chi)
    })
}

fn ratio() -> impl Strategy<Value = f64> {
    (-3.0..3.0).prop_map(|exponent| 10_f64.powf(exponent))
}

fn finite(force: Force) -> bool {
    array(force).iter().all(|f| f.is_finite())
}

fn finite_rows(derivative: [[f64; 3]; 3]) -> bool {
    derivative.iter().flatten().all(|d| d.is_finite())
}

/// Some positions within the contact, on its edge, and outside.
fn positions(a_over_b: f64) -> Vec<[f64; 2]> {
    let (a, b) = (a_over_b.sqrt(), a_over_b.sqrt().recip());
    [[0.0, 0.0], [0.5, -0.6], [-0.3, 0.9], [1.0, 0.0], [0.0, -1.0], [2.0, 0.0]]
        .map(|[u, t]| [a * u, b * t])
        .to_vec()
}

/// Contacts of every shape and Poisson's ratio: a theory is prepared for each once, for its
/// creepage coefficients cost up to fifty milliseconds.
fn contacts() -> impl Iterator<Item = Contact> {
    let shapes = (-6..=6).map(|k| 10_f64.powf(0.5 * f64::from(k)));
    shapes.zip([0.0, 0.28, 0.5].into_iter().cycle()).map(|(ratio, nu)| contact(ratio, nu))
}

static FASTSIM: LazyLock<Vec<(TractionBound, Fastsim)>> = LazyLock::new(|| {
    let mut all = Vec::new();
    for contact in contacts() {
        for flexibility in [Flexibility::One, Flexibility::Three, Flexibility::Blended] {
            for bound in [TractionBound::Parabolic, TractionBound::Elliptic] {
                let settings = Settings { flexibility, bound, grid: GRID, ..Settings::default() };
                all.push((bound, Fastsim::new(&contact, settings).unwrap()));
            }
        }
    }
    all
});

static FASTRIP: LazyLock<Vec<(Variant, Fastrip)>> = LazyLock::new(|| {
    let variants = [Variant::Original, Variant::Modified, Variant::Consistent];
    let prepared = contacts().flat_map(|contact| {
        variants.map(|variant| (variant, Fastrip::new(&contact, variant, GRID).unwrap()))
    });
    prepared.collect()
});

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn strip_theory_takes_anything(a_over_b in ratio(), poisson in 0.0..=0.5, at in any_creepage()) {
        let theory = StripTheory::new(&contact(a_over_b, poisson));
        let solution = theory.solve(at);
        prop_assert!(finite(solution.force), "{:?}", solution);
        // Quadrature where the spin pole lies in a sliding strip.
        prop_assert!(solution.force.magnitude() < 1.0 + 1e-3, "{:?}", solution);
        let moderate = at.chi().abs() < theory.spin_bound();
        prop_assert_eq!(solution.status == Status::Solved, moderate);
        prop_assert!(finite_rows(theory.jacobian(at).unwrap()), "{:?}", theory.jacobian(at).unwrap());
        for point in theory.field(at, &positions(a_over_b)) {
            prop_assert!(point.traction.iter().chain(&point.slip).all(|v| v.is_finite()));
            prop_assert!(point.traction[0].hypot(point.traction[1]) < 1.0 + 1e-12);
        }
    }

    #[test]
    fn fastsim_takes_anything(which in any::<prop::sample::Index>(), at in any_creepage()) {
        let (bound, theory) = which.get(&FASTSIM);
        let force = theory.solve(at).force;
        prop_assert!(finite(force), "{:?}", force);
        // No more than friction gives, whatever the grid: rounding of the sum.
        prop_assert!(force.magnitude() < 1.0 + 1e-12, "{:?} {:?}", bound, force);
        prop_assert!(finite_rows(theory.jacobian(at).unwrap()), "{:?}", theory.jacobian(at).unwrap());
        for point in theory.field(at, &positions(theory.contact().ellipse().ratio())) {
            prop_assert!(point.traction.iter().chain(&point.slip).all(|v| v.is_finite()));
            prop_assert!(point.traction[0].hypot(point.traction[1]) < 4.0 / 3.0 + 1e-12);
        }
    }

    #[test]
    fn fastrip_takes_anything(which in any::<prop::sample::Index>(), at in any_creepage()) {
        let (variant, theory) = which.get(&FASTRIP);
        let force = theory.solve(at).force;
        prop_assert!(finite(force), "{:?}", force);
        // The others use strip theory even where its traction exceeds the bound.
        if *variant == Variant::Consistent {
            prop_assert!(force.magnitude() < 1.0 + 1e-12, "{:?}", force);
        }
        prop_assert!(finite_rows(theory.jacobian(at).unwrap()), "{:?}", theory.jacobian(at).unwrap());
        for point in theory.field(at, &positions(theory.contact().ellipse().ratio())) {
            prop_assert!(point.traction.iter().all(|v| v.is_finite()), "{:?}", point);
        }
    }
}

/// The sum of the bound over the cells is beyond the force of friction by its quadrature; the force is not.
#[test]
fn full_sliding_is_the_force_of_friction_on_any_grid() {
    let at = Creepage::new(3e9, -4e9, 0.0).unwrap();
    for grid in [[3, 2], [7, 10], [50, 50], [10, 200]] {
        for ratio in [0.3, 1.0, 4.0] {
            let contact = contact(ratio, 0.28);
            let mut forces = vec![];
            for bound in [TractionBound::Parabolic, TractionBound::Elliptic] {
                let settings = Settings { bound, grid, ..Settings::default() };
                forces.push(Fastsim::new(&contact, settings).unwrap().solve(at).force);
            }
            forces.push(Fastrip::new(&contact, Variant::Consistent, grid).unwrap().solve(at).force);
            for force in forces {
                // Rounding.
                assert!((force.magnitude() - 1.0).abs() < 1e-12, "{grid:?} {ratio}: {force:?}");
            }
        }
    }
}

/// The theories under test, for one contact.
fn theories(a_over_b: f64, poisson: f64) -> Vec<(String, Box<dyn Theory>)> {
    let mut all: Vec<(String, Box<dyn Theory>)> =
        vec![("strip".to_owned(), Box::new(StripTheory::new(&contact(a_over_b, poisson))))];
    for flexibility in [Flexibility::One, Flexibility::Three, Flexibility::Blended] {
        for bound in [TractionBound::Parabolic, TractionBound::Elliptic] {
            let settings = Settings { flexibility, bound, grid: [20, 15], ..Settings::default() };
            let theory = Fastsim::new(&contact(a_over_b, poisson), settings).unwrap();
            all.push((format!("{settings:?}"), Box::new(theory)));
        }
    }
    for variant in [Variant::Original, Variant::Modified, Variant::Consistent] {
        let theory = Fastrip::new(&contact(a_over_b, poisson), variant, [20, 15]).unwrap();
        all.push((format!("{variant:?}"), Box::new(theory)));
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// (4.28): reversing all creepages reverses all forces; mirrored about the rolling
    /// direction, `eta`, `chi`, `fy` and `mz` change sign.
    #[test]
    fn symmetries(
        a_over_b in prop_oneof![Just(0.2), Just(1.0), Just(5.0)],
        xi in -2.0..2.0,
        eta in -2.0..2.0,
        chi in -3.0..3.0,
    ) {
        for (name, theory) in theories(a_over_b, 0.25) {
            let solve = |xi, eta, chi| array(theory.solve(creepage(xi, eta, chi)).force);
            let [fx, fy, mz] = solve(xi, eta, chi);
            let reversed = solve(-xi, -eta, -chi);
            prop_assert!(largest_difference(reversed, [-fx, -fy, -mz]) < 1e-12, "{}", name);
            let mirrored = solve(xi, -eta, -chi);
            prop_assert!(largest_difference(mirrored, [fx, -fy, -mz]) < 1e-12, "{}", name);
        }
    }

    /// Friction takes energy: `f_x xi + f_y eta + m_z chi >= 0`. True of every theory whose
    /// traction follows from its slip; the originals' mixtures are left out.
    #[test]
    fn friction_dissipates(xi in -2.0..2.0, eta in -2.0..2.0, chi in -3.0..3.0) {
        for (name, theory) in theories(0.5, 0.25) {
            let force = theory.solve(creepage(xi, eta, chi)).force;
            let power = force.fx * xi + force.fy * eta + force.mz * chi;
            prop_assert!(power >= 0.0 || name == "Original", "{}: {}", name, power);
        }
    }
}

/// Without spin, the force tends to `mu N` along the creepage.
#[test]
fn large_creepage_is_full_sliding() {
    for (name, theory) in theories(0.5, 0.25) {
        for angle in [0.0, 0.4, 1.2, 2.5, 4.0] {
            let (sin, cos) = f64::sin_cos(angle);
            let force = theory.solve(creepage(1e5 * cos, 1e5 * sin, 0.0)).force;
            let across = force.fx * sin - force.fy * cos;
            // With three flexibilities the direction is (C11 xi, C22 eta) for ever, which is the
            // variant's known defect; the sum of the bound on this grid exceeds one.
            // FaStrip's closed form along the strip and the sum over its cells differ by 1e-3.
            let defect = if name.contains("Three") { 0.1 } else { 1e-3 };
            assert!(across.abs() < defect, "{name} {across}");
            assert!((force.magnitude() - 1.0).abs() < 0.01, "{name} {}", force.magnitude());
            assert!(force.mz.abs() < 2e-3, "{name} {}", force.mz);
        }
    }
}
