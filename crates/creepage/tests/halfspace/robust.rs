//! Finite input gives finite output, or an error.

use creepage::Ellipse;
use creepage::halfspace::{DisplacementField, Edge, Polynomial, PolynomialError, Traction};
use proptest::prelude::*;

use super::support::Random;

/// Numbers of every size, zero and the edge's neighbourhood among them.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        -2.0_f64..2.0,
        (-300.0_f64..300.0).prop_map(|power| 10.0_f64.powf(power)),
        (-16.0_f64..0.0).prop_map(|power| 1.0 - 10.0_f64.powf(power)),
        (-16.0_f64..0.0).prop_map(|power| -1.0 - 10.0_f64.powf(power)),
    ]
}

proptest! {
    #[test]
    fn fields_are_finite_everywhere(
        log_ratio in -6.0_f64..6.0, degree in 0_usize..4, seed: u64, vanishing: bool,
        x in coordinate(), y in coordinate(), on_edge: bool,
    ) {
        let ellipse = Ellipse::from_ratio(10.0_f64.powf(log_ratio)).unwrap();
        let polynomials = Random(seed).polynomials(ellipse, degree);
        let edge = if vanishing { Edge::Vanishing } else { Edge::Singular };
        let traction = Traction::new(ellipse, edge, polynomials.each_ref()).unwrap();
        let field = DisplacementField::new(&traction, 0.28, 0.2).unwrap();
        // Either anywhere, or on the edge but for rounding.
        let point = if on_edge {
            [ellipse.a() * x.cos(), ellipse.b() * x.sin()]
        } else {
            [ellipse.a() * x, ellipse.b() * y]
        };
        prop_assert!(traction.at(point).iter().all(|value| value.is_finite()));
        let displacement = field.at(point);
        prop_assert!(displacement.iter().all(|value| value.is_finite()), "{displacement:?}");
        if point[0].hypot(point[1]) > 1e12 {
            prop_assert!(displacement.iter().all(|value| value.abs() < 1e-3));
        }
    }
}

#[test]
fn overflow_is_an_error() {
    let ellipse = Ellipse::new(1e200, 1e200).unwrap();
    let huge = Polynomial::new(vec![0.0, 1e200, 0.0]).unwrap();
    let error = Traction::new(ellipse, Edge::Singular, [&huge; 3]).unwrap_err();
    assert!(matches!(error, PolynomialError::Invalid(_)), "{error}");
    let two = Traction::from_harmonics(ellipse, Edge::Singular, [vec![1.0], vec![1.0; 2], vec![]]);
    assert!(matches!(two, Err(PolynomialError::Count { .. })));
}
