//! What the tests share.

use creepage::halfspace::{Edge, Polynomial, Traction};
use creepage::subsurface::{Body, Interior, Stress};
use creepage::{Ellipse, Hertz, Solid, SolidPair};

/// The numbers of a table, row by row, without its comments and its heading.
pub(crate) fn rows(table: &str) -> Vec<Vec<f64>> {
    let lines = table.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect()
}

/// Two bodies of shear modulus one, pressed together to the peak pressure one on `a = 1`.
pub(crate) fn contact(a_over_b: f64, poisson: f64) -> (Hertz, Solid) {
    let solid = Solid::new(1.0, poisson).unwrap();
    let ellipse = Ellipse::new(1.0, 1.0 / a_over_b).unwrap();
    let load = 2.0 / 3.0 * ellipse.area();
    (Hertz::from_ellipse(SolidPair::new(solid, solid), ellipse, load).unwrap(), solid)
}

pub(crate) fn sliding(a_over_b: f64, poisson: f64, friction: [f64; 2], body: Body) -> Interior {
    let (contact, solid) = contact(a_over_b, poisson);
    Interior::sliding(&contact, friction, solid, body).unwrap()
}

/// A traction of degree three with all its terms, on `a = 1`.
pub(crate) fn cubic(a_over_b: f64, edge: Edge) -> Traction {
    let ellipse = Ellipse::new(1.0, 1.0 / a_over_b).unwrap();
    let polynomial = |phase: f64| {
        let terms = (0..10).map(|i| (1.7 * f64::from(i) + phase).sin());
        Polynomial::new(terms.collect()).unwrap()
    };
    let [x, y, z] = [0.3, 1.1, 2.3].map(polynomial);
    Traction::new(ellipse, edge, [&x, &y, &z]).unwrap()
}

/// The largest difference of two states' components.
pub(crate) fn apart(one: &Stress, two: &Stress) -> f64 {
    one.plus(-1.0, two).components().iter().fold(0.0, |max, value| max.max(value.abs()))
}
