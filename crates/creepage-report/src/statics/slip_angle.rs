//! How far a solution with partial slip is from the law of friction.

use std::f64::consts::TAU;

use creepage::Ellipse;
use creepage::statics::PartialSlip;

use crate::contact_view::magnitude;

/// Rings in the area of slip, and points on each.
const RINGS: u32 = 24;
const POINTS: u32 = 120;
/// Slip below this share of the shift is lost in rounding, and has no direction.
const NOISE: f64 = 1e-8;

/// The largest slip [m] in the area of slip, and the largest angle between slip and traction
/// [degrees]; the angle is NaN where slip is lost in rounding everywhere.
pub(super) fn largest(contact: Ellipse, partial: &PartialSlip) -> (f64, f64) {
    let inner = partial.adhesion().a() / contact.a();
    let shift = magnitude(partial.shift());
    let (mut slip, mut angle) = (0.0_f64, f64::NAN);
    for point in rings(contact, inner) {
        let size = partial.slip(point).map_or(0.0, magnitude);
        slip = slip.max(size);
        if size > NOISE * shift {
            angle = angle.max(partial.disagreement(point).map_or(f64::NAN, f64::abs));
        }
    }
    (slip, angle.to_degrees())
}

/// Points between the edge of adhesion, where there is no slip, and the contact's edge.
fn rings(contact: Ellipse, inner: f64) -> impl Iterator<Item = [f64; 2]> {
    // A hair inside: a point on the edge itself may be rounded out of the contact.
    let radius = move |ring: u32| {
        (inner + (1.0 - inner) * f64::from(ring) / f64::from(RINGS)) * (1.0 - 4.0 * f64::EPSILON)
    };
    (1..=RINGS).flat_map(move |ring| {
        (0..POINTS).map(move |k| {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(POINTS)).sin_cos();
            [radius(ring) * contact.a() * cos, radius(ring) * contact.b() * sin]
        })
    })
}

#[cfg(test)]
mod tests {
    use creepage::{Hertz, Solid, SolidPair};

    use super::*;

    fn angle(poisson: f64, share: f64) -> f64 {
        let solid = Solid::new(82e9, poisson).unwrap();
        let ellipse = Ellipse::new(5e-3, 5e-3).unwrap();
        let contact = Hertz::from_ellipse(SolidPair::new(solid, solid), ellipse, 10e3).unwrap();
        let partial = PartialSlip::new(&contact, 0.3, [share * 3e3, 0.0]).unwrap();
        largest(ellipse, &partial).1
    }

    #[test]
    fn at_the_limit_of_friction_the_angles_on_a_circle_are_those_of_the_thesis() {
        // The points are 3 degrees apart about a maximum: short of it by some thousandths.
        assert!((angle(0.25, 1.0 - 1e-9) - 4.10).abs() < 0.01);
        assert!((angle(0.5, 1.0 - 1e-9) - 9.59).abs() < 0.02);
    }

    #[test]
    fn without_poissons_ratio_slip_opposes_nothing() {
        assert!(angle(0.0, 0.5) < 1e-4);
    }
}
