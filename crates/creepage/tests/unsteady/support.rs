use creepage::coulomb::Resolution;
use creepage::unsteady::{Motion, Rolling};
use creepage::{Contact, Creepage, Ellipse};

pub(crate) fn contact(a_over_b: f64, poisson: f64) -> Contact {
    Contact::new(Ellipse::from_ratio(a_over_b).unwrap(), poisson).unwrap()
}

pub(crate) fn circle(resolution: Resolution) -> Rolling {
    Rolling::new(&contact(1.0, 0.28), resolution).unwrap()
}

pub(crate) fn creeping(xi: f64, eta: f64, chi: f64) -> Motion {
    Motion::from(Creepage::new(xi, eta, chi).unwrap())
}

/// Few elements, for what holds at any resolution.
pub(crate) fn coarse() -> Resolution {
    Resolution::new(10, 8).unwrap()
}
