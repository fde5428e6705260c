//! Plane curves by arc length, which may overhang and may have kinks.
//!
//! A curve is a chain of pieces: lines, arcs, graphs of polynomials and parametric cubics.
//! Position, tangent and curvature are those of the piece, exactly.

mod cubic;
mod graph;
mod piece;
mod smoothing;
mod spline;

pub use cubic::Cubic;
pub(crate) use cubic::hermite;
pub use graph::Graph;
pub use piece::{Arc, Line, Piece};
pub use smoothing::{Smoothing, smooth};
pub(crate) use spline::spline_slopes;
pub use spline::{SplineError, interpolate};

/// A point of a curve with its tangent and curvature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// Coordinates (m): `y` to the field side, `z` down.
    pub y: f64,
    /// See [`CurvePoint::y`].
    pub z: f64,
    /// Unit tangent `(t_y, t_z)` in the sense of growing arc length; the material lies on its
    /// right hand (`y` to the right, `z` down).
    pub tangent: [f64; 2],
    /// Curvature (1/m), positive where the material is convex.
    pub curvature: f64,
}

impl CurvePoint {
    /// The unit normal that points out of the material.
    #[must_use]
    pub fn normal(&self) -> [f64; 2] {
        [self.tangent[1], -self.tangent[0]]
    }

    /// The point turned about the origin by `(cos, sin)` (from `y` to `z`), then shifted.
    #[must_use]
    pub fn moved(&self, (cos, sin): (f64, f64), shift: [f64; 2]) -> Self {
        let turn = |a: f64, b: f64| [cos * a - sin * b, sin * a + cos * b];
        let [y, z] = turn(self.y, self.z);
        let tangent = turn(self.tangent[0], self.tangent[1]);
        Self { y: y + shift[0], z: z + shift[1], tangent, curvature: self.curvature }
    }
}

/// A chain of pieces by arc length.
///
/// Consecutive pieces need not meet exactly: standards print their joints to a micrometre.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pieces: Vec<Piece>,
    /// Arc length at the start of each piece, and at the end of the last.
    starts: Vec<f64>,
}

impl Curve {
    /// A chain of pieces; those of no length are left out.
    ///
    /// `None` where nothing of positive, finite length is left.
    #[must_use]
    pub fn new(pieces: impl IntoIterator<Item = Piece>) -> Option<Self> {
        let solid = |piece: &Piece| piece.length() > 0.0 && piece.length().is_finite();
        let curve = Self::chain(pieces.into_iter().filter(solid).collect());
        (curve.length() > 0.0).then_some(curve)
    }

    /// Pieces known to have a length.
    pub(crate) fn chain(pieces: Vec<Piece>) -> Self {
        let mut end = 0.0;
        let ends = pieces.iter().map(|piece| {
            end += piece.length();
            end
        });
        let starts = [0.0].into_iter().chain(ends).collect();
        Self { pieces, starts }
    }

    /// Length of the curve (m).
    #[must_use]
    pub fn length(&self) -> f64 {
        self.starts.last().copied().unwrap_or(0.0)
    }

    /// The pieces, each with the arc length at which it starts.
    pub fn pieces(&self) -> impl Iterator<Item = (f64, &Piece)> {
        self.starts.iter().copied().zip(&self.pieces)
    }

    /// The point at arc length `s` (m), which is held to the curve's range.
    ///
    /// At a joint the later piece answers.
    #[must_use]
    pub fn at(&self, s: f64) -> CurvePoint {
        let after = self.starts.partition_point(|&start| start <= s);
        let index = after.saturating_sub(1).min(self.pieces.len().saturating_sub(1));
        self.on_piece(index, s)
    }

    /// The point at arc length `s` just before a joint: the earlier piece answers.
    #[must_use]
    pub fn before(&self, s: f64) -> CurvePoint {
        let after = self.starts.partition_point(|&start| start < s);
        let index = after.saturating_sub(1).min(self.pieces.len().saturating_sub(1));
        self.on_piece(index, s)
    }

    fn on_piece(&self, index: usize, s: f64) -> CurvePoint {
        let start = self.starts.get(index).copied().unwrap_or(0.0);
        match self.pieces.get(index) {
            Some(piece) => piece.at((s - start).clamp(0.0, piece.length())),
            // `new` leaves no empty chain.
            None => CurvePoint { y: 0.0, z: 0.0, tangent: [1.0, 0.0], curvature: 0.0 },
        }
    }

    /// Arc lengths that hold every joint and leave gaps of at most `step` (m) between.
    #[must_use]
    pub fn stations(&self, step: f64) -> Vec<f64> {
        let mut stations = Vec::new();
        for (start, piece) in self.pieces() {
            let count = whole((piece.length() / step).ceil().clamp(1.0, 1e5));
            let spacing = piece.length() / count as f64;
            stations.extend((0..count).map(|i| start + i as f64 * spacing));
        }
        stations.push(self.length());
        stations
    }

    /// Joints at which the tangent turns by more than `least` (rad): arc length and turn,
    /// positive where the corner of the material is convex.
    #[must_use]
    pub fn kinks(&self, least: f64) -> Vec<(f64, f64)> {
        let inner = self.starts.get(1..self.pieces.len()).unwrap_or(&[]);
        inner
            .iter()
            .map(|&s| (s, turn(self.before(s).tangent, self.at(s).tangent)))
            .filter(|(_, turn)| turn.abs() > least)
            .collect()
    }
}

/// The whole part of a number that is not negative.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, as meant")]
pub(crate) fn whole(value: f64) -> usize {
    value as usize
}

/// Angle from one direction to another (rad), in the sense from `y` to `z`.
#[must_use]
pub fn turn(from: [f64; 2], to: [f64; 2]) -> f64 {
    (from[0] * to[1] - from[1] * to[0]).atan2(from[0] * to[0] + from[1] * to[1])
}
