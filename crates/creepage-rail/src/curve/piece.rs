//! Piece of a curve: a line, an arc, a graph or a cubic, by its own arc length.

use super::{Cubic, CurvePoint, Graph};

/// One piece of a curve, by its own arc length from 0 to [`Piece::length`].
#[derive(Debug, Clone, PartialEq)]
pub enum Piece {
    /// A straight line.
    Line(Line),
    /// An arc of a circle.
    Arc(Arc),
    /// The graph `z(y)` of a polynomial.
    Graph(Graph),
    /// A parametric cubic: what a spline is made of.
    Cubic(Cubic),
}

impl Piece {
    /// Length (m).
    #[must_use]
    pub fn length(&self) -> f64 {
        match self {
            Self::Line(line) => line.length,
            Self::Arc(arc) => (arc.radius * arc.sweep).abs(),
            Self::Graph(graph) => graph.length(),
            Self::Cubic(cubic) => cubic.length(),
        }
    }

    /// Whether it turns one way only, so that its tangents lie between those of its ends.
    pub(crate) fn turns_one_way(&self) -> bool {
        matches!(self, Self::Line(_) | Self::Arc(_))
    }

    /// The point at arc length `s` from the piece's start.
    #[must_use]
    pub fn at(&self, s: f64) -> CurvePoint {
        match self {
            Self::Line(line) => line.at(s),
            Self::Arc(arc) => arc.at(s),
            Self::Graph(graph) => graph.at(s),
            Self::Cubic(cubic) => cubic.at(s),
        }
    }
}

/// A straight line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    start: [f64; 2],
    tangent: [f64; 2],
    length: f64,
}

impl Line {
    /// The line between two points `(y, z)` (m).
    #[must_use]
    pub fn between(start: [f64; 2], end: [f64; 2]) -> Piece {
        let [dy, dz] = [end[0] - start[0], end[1] - start[1]];
        let length = dy.hypot(dz);
        let tangent = if length > 0.0 { [dy / length, dz / length] } else { [1.0, 0.0] };
        Piece::Line(Self { start, tangent, length })
    }

    fn at(&self, s: f64) -> CurvePoint {
        let [y, z] = self.start;
        let [ty, tz] = self.tangent;
        CurvePoint { y: y + s * ty, z: z + s * tz, tangent: self.tangent, curvature: 0.0 }
    }
}

/// An arc of a circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    centre: [f64; 2],
    radius: f64,
    from: f64,
    sweep: f64,
}

impl Arc {
    /// The arc about `centre` (m) from the direction of one point to that of another, the
    /// shorter way.
    #[must_use]
    pub fn between(centre: [f64; 2], radius: f64, start: [f64; 2], end: [f64; 2]) -> Piece {
        let seen = |point: [f64; 2]| [point[0] - centre[0], point[1] - centre[1]];
        let [y, z] = seen(start);
        let sweep = super::turn([y, z], seen(end));
        Piece::Arc(Self { centre, radius, from: z.atan2(y), sweep })
    }

    fn at(&self, s: f64) -> CurvePoint {
        let sense = self.sweep.signum();
        let (sin, cos) = (self.from + sense * s / self.radius).sin_cos();
        CurvePoint {
            y: self.centre[0] + self.radius * cos,
            z: self.centre[1] + self.radius * sin,
            tangent: [-sense * sin, sense * cos],
            curvature: sense / self.radius,
        }
    }
}
