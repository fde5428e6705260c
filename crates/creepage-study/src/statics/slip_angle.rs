//! Angle between slip and traction: how far a solution with partial slip is from the law of friction.

use std::f64::consts::TAU;

use creepage::Ellipse;
use creepage::statics::PartialSlip;

use super::field::magnitude;

/// Rings in the area of slip, and points on each.
const RINGS: u32 = 24;
const POINTS_PER_RING: u32 = 120;
/// Slip below this share of the shift is lost in rounding, and has no direction.
const NOISE: f64 = 1e-8;

/// Slip and its angle to the traction, by which the solution fails the law of friction.
pub(super) struct Slip {
    /// The largest slip (m).
    pub(super) largest: f64,
    /// The largest angle (degrees); it is found where slip begins.
    pub(super) angle: f64,
    /// The largest angle on the edge of the contact (degrees).
    pub(super) angle_at_edge: f64,
}

impl Slip {
    /// The angles are NaN where slip is lost in rounding.
    pub(super) fn of(contact: Ellipse, partial: &PartialSlip) -> Self {
        let inner = partial.adhesion().a() / contact.a();
        let mut all = Self { largest: 0.0, angle: f64::NAN, angle_at_edge: f64::NAN };
        for ring in 1..=RINGS {
            // Close together where slip begins.
            let part = (f64::from(ring) / f64::from(RINGS)).powi(3);
            // A hair inside: a point on the edge itself may be rounded out of the contact.
            let radius = (inner + (1.0 - inner) * part) * (1.0 - 4.0 * f64::EPSILON);
            let (slip, angle) = on_ring(contact, partial, radius);
            all.largest = all.largest.max(slip);
            all.angle = all.angle.max(angle);
            all.angle_at_edge = angle;
        }
        all
    }
}

/// The largest slip and the largest angle on an ellipse `radius` times the contact.
fn on_ring(contact: Ellipse, partial: &PartialSlip, radius: f64) -> (f64, f64) {
    let noise = NOISE * magnitude(partial.shift());
    directions(contact).fold((0.0, f64::NAN), |(slip, angle): (f64, f64), [cos, sin]| {
        let point = [radius * contact.a() * cos, radius * contact.b() * sin];
        let size = partial.slip(point).map_or(0.0, magnitude);
        let seen = partial.disagreement(point).filter(|_| size > noise);
        (slip.max(size), seen.map_or(angle, |seen| angle.max(seen.abs().to_degrees())))
    })
}

/// `(x/a, y/b)` on the unit circle: evenly, and again so that the normals to the ellipse turn
/// evenly, of which a slender one has most at its ends.
fn directions(contact: Ellipse) -> impl Iterator<Item = [f64; 2]> {
    (0..POINTS_PER_RING).flat_map(move |k| {
        let (sin, cos) = (TAU * f64::from(k) / f64::from(POINTS_PER_RING)).sin_cos();
        let (x, y) = (contact.a() * cos, contact.b() * sin);
        let length = x.hypot(y);
        [[cos, sin], [x / length, y / length]]
    })
}

#[cfg(test)]
mod tests {
    use creepage::{Hertz, Solid, SolidPair};

    use super::*;

    fn slip(a: f64, poisson: f64, share: f64) -> Slip {
        let solid = Solid::new(82e9, poisson).unwrap();
        let ellipse = Ellipse::new(a, 5e-3).unwrap();
        let contact = Hertz::from_ellipse(SolidPair::new(solid, solid), ellipse, 10e3).unwrap();
        let partial = PartialSlip::new(&contact, 0.3, [share * 3e3, 0.0]).unwrap();
        Slip::of(ellipse, &partial)
    }

    #[test]
    fn at_the_limit_of_friction_the_angles_on_a_circle_are_those_of_the_thesis() {
        // The points are 3 degrees apart about a maximum: short of it by some thousandths.
        assert!((slip(5e-3, 0.25, 1.0 - 1e-9).angle_at_edge - 4.10).abs() < 0.01);
        assert!((slip(5e-3, 0.5, 1.0 - 1e-9).angle_at_edge - 9.59).abs() < 0.02);
    }

    /// At the edge of adhesion the bodies part like the faces of a crack: by `1 - sigma` across
    /// the edge to one along it. So the angle's tangent is at most `sigma/(2 sqrt(1 - sigma))`,
    /// for every ellipse.
    #[test]
    fn where_slip_begins_the_angle_is_that_of_a_crack() {
        let cases = [(5e-3, 0.5, 0.7), (5e-3, 0.25, 0.3), (9e-3, 0.3, 0.9), (0.1, 0.28, 0.5)];
        for (a, poisson, share) in cases {
            let crack = (0.5 * poisson / (1.0_f64 - poisson).sqrt()).atan().to_degrees();
            let angle = slip(a, poisson, share).angle;
            // The innermost ring lies 1/13824 of the way from the edge.
            assert!((angle / crack - 1.0).abs() < 5e-3, "{angle} {crack}");
        }
    }

    #[test]
    fn without_poissons_ratio_slip_has_the_direction_of_the_traction() {
        let slip = slip(7e-3, 0.0, 0.5);
        // Rounding of the displacements, over the slip of the innermost ring.
        assert!(slip.angle < 1e-3 && slip.largest > 0.0, "{}", slip.angle);
    }
}
