//! Bentall and Johnson's cylinders.

use std::f64::consts::PI;

use creepage::approximate::carter::Carter;
use creepage::coulomb::Cylinders;
use creepage::{Solid, SolidPair, Status};

use crate::support::{aluminium, polymer, steel};

/// The example of CONTACT (aluminium above steel, rolling to the left, a/R = 0.004): friction, force over
/// `mu N`, creepage, peak pressure in `MPa`.
const PRINTED: [[f64; 4]; 4] = [
    [1e-3, 0.0, 5.252_98e-4, 103.1466],
    [0.05, 0.0, 4.294_07e-4, 103.6284],
    [0.05, 0.75, 2.108_64e-4, 103.2250],
    [0.05, -0.75, 5.392_02e-4, 103.2777],
];

#[test]
fn the_printed_example() {
    let pair = SolidPair::new(aluminium(), steel());
    for [friction, force, creepage, peak] in PRINTED {
        // Rolling to +x turns the creepage about; the force of CONTACT is that on the upper body.
        let found = Cylinders::new(pair, friction).unwrap().find(force).unwrap();
        assert_eq!(found.status(), Status::Solved);
        // `rho = 4 R` where the undeformed distance is `x^2/(2 R)`.
        let upsilon = -found.creepage() * friction * 0.004 / 4.0;
        // 128 elements, of which two or three are the border of slip.
        assert!((upsilon / creepage - 1.0).abs() < 1e-3, "{friction} {force}: {upsilon}");
        let places = (-200..200).map(|k| found.pressure(f64::from(k) / 200.0));
        let highest = 103.144_653_6 * places.fold(0.0, f64::max);
        assert!((highest / peak - 1.0).abs() < 1e-4, "{friction} {force}: {highest}");
    }
}

#[test]
fn like_cylinders_are_carters() {
    let cylinders = Cylinders::new(SolidPair::new(steel(), steel()), 0.3).unwrap();
    for creepage in [-5.0, -1.0, 0.3, 2.0, 3.5] {
        let found = cylinders.solve(creepage).unwrap();
        let carter = Carter::new(creepage).unwrap();
        assert_eq!(found.status(), Status::Solved);
        // The border of slip falls between two of 128 elements.
        assert!((found.force() - carter.force()).abs() < 1e-4, "{creepage}");
        assert!((found.adhesion() - carter.adhesion_half_width()).abs() < 0.013, "{creepage}");
    }
}

/// The upper body rigid, `sigma = 0`: `kappa = 1/2`, as unlike as bodies can be.
fn rigid_on_cork() -> SolidPair {
    SolidPair::new(Solid::new(1e15, 0.0).unwrap(), Solid::new(1e6, 0.0).unwrap())
}

/// Without slip `p + i T` is a multiple of `(1 - s)^(1/2 + i e) (1 + s)^(1/2 - i e)`, with
/// `tanh(pi e) = kappa/(1 - sigma)`, on a half-width `l`: `l^2 (1 + 4 e^2) = 1` at the same load, and
/// `xi = 8 e l/mu`. With friction of one only the rims slip, with more nothing but the last elements.
#[test]
fn without_slip_it_is_the_exact_solution() {
    let frictions = [1.0, 10.0, 1000.0];
    let bodies = [aluminium(), polymer()];
    for (lower, friction) in bodies.into_iter().flat_map(|body| frictions.map(|mu| (body, mu))) {
        let pair = SolidPair::new(steel(), lower);
        let beta = pair.kappa() / (1.0 - pair.poisson());
        let e = beta.atanh() / PI;
        let half = (1.0 + 4.0 * e * e).sqrt().recip();
        let found = Cylinders::new(pair, friction).unwrap().find(0.0).unwrap();
        assert_eq!(found.status(), Status::Solved);
        let [trailing, leading] = found.ends();
        assert!(
            (0.5 * (leading - trailing) / half - 1.0).abs() < 2e-3,
            "{half} {trailing} {leading}"
        );
        let ratio = found.creepage() * friction / (8.0 * e * half);
        assert!((ratio - 1.0).abs() < 5e-3, "{beta}: {ratio}");
    }
}

#[test]
fn vanishing_friction_slides_on_both_sides_of_two_points() {
    let friction = 1e-4;
    let free = Cylinders::new(rigid_on_cork(), friction).unwrap().find(0.0).unwrap();
    assert_eq!(free.status(), Status::Solved);
    // 4 k (1 - x0^2)^(1/2), where x0 halves the load: Bentall and Johnson's limit.
    let x0: f64 = 0.403_972_753_3;
    let limit = 4.0 * 0.5 / friction * (1.0 - x0 * x0).sqrt();
    // Half an element in x0.
    assert!((free.creepage() / limit - 1.0).abs() < 6e-3, "{} {limit}", free.creepage());
}
