//! Side of the track, and the plane of contact in the track's cross-section.

use crate::curve::CurvePoint;

/// A side of the track, seen in the direction of travel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// `y < 0`.
    Left,
    /// `y > 0`.
    Right,
}

impl Side {
    /// The sign of the track's `y` towards the field side.
    #[must_use]
    pub fn sense(self) -> f64 {
        match self {
            Self::Left => -1.0,
            Self::Right => 1.0,
        }
    }
}

/// Axes of a contact plane, on the right-hand image of its side.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    x: f64,
    origin: [f64; 2],
    lateral: [f64; 2],
    rail_s: f64,
}

impl Frame {
    pub(crate) fn new(x: f64, point: CurvePoint, rail_s: f64, angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { x, origin: [point.y, point.z], lateral: [cos, sin], rail_s }
    }

    pub(crate) fn x(&self) -> f64 {
        self.x
    }

    pub(crate) fn rail_s(&self) -> f64 {
        self.rail_s
    }

    /// Lateral coordinate of a point of the cross-section.
    pub(crate) fn lateral_part(&self, [y, z]: [f64; 2]) -> f64 {
        self.facing_tangent([y - self.origin[0], z - self.origin[1]])
    }

    /// Coordinate along the normal into the rail.
    pub(crate) fn normal_part(&self, [y, z]: [f64; 2]) -> f64 {
        self.lateral[0] * (z - self.origin[1]) - self.lateral[1] * (y - self.origin[0])
    }

    /// Part of a direction along the lateral axis.
    pub(crate) fn facing_tangent(&self, [y, z]: [f64; 2]) -> f64 {
        self.lateral[0] * y + self.lateral[1] * z
    }

    /// Cosine of the angle between the plane and a line of the given slope `dz/dy`.
    pub(crate) fn facing(&self, slope: f64) -> f64 {
        self.facing_tangent([1.0, slope]) / slope.hypot(1.0)
    }

    /// Angle of a direction against the plane.
    pub(crate) fn tilt(&self, tangent: [f64; 2]) -> f64 {
        crate::curve::turn(self.lateral, tangent)
    }
}
