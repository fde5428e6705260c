//! Contacts of unlike bodies.

use creepage::coulomb::{Coupled, Prescribed, Resolution};
use creepage::{Contact, Creepage, Ellipse, Force, Hertz, Solid, SolidPair};

pub(crate) fn at([xi, eta, chi]: [f64; 3]) -> Creepage {
    Creepage::new(xi, eta, chi).unwrap()
}

pub(crate) fn components(force: Force) -> [f64; 3] {
    [force.fx, force.fy, force.mz]
}

pub(crate) fn contact(upper: Solid, lower: Solid, ratio: f64, friction: f64) -> Contact {
    let ellipse = Ellipse::from_ratio(ratio).unwrap();
    let pair = SolidPair::new(upper, lower);
    Hertz::from_ellipse(pair, ellipse, 1.0).unwrap().with_friction(friction).unwrap()
}

pub(crate) fn steel() -> Solid {
    Solid::new(82e9, 0.28).unwrap()
}

pub(crate) fn aluminium() -> Solid {
    Solid::new(23e9, 0.31).unwrap()
}

pub(crate) fn polymer() -> Solid {
    Solid::new(0.5e9, 0.25).unwrap()
}

pub(crate) fn coupled(contact: &Contact, resolution: Resolution) -> Coupled {
    Coupled::new(contact, resolution, Prescribed::Load).unwrap()
}
