//! A profile zone by zone, as the standards print it: `z(y)` in mm between breaks in `y`.

use crate::curve::{Arc, Graph, Line};
use crate::{Curve, Piece, Profile, Role};

const MM: f64 = 1e-3;

/// The formula of a zone, in mm.
#[derive(Debug, Clone, Copy)]
pub(super) enum Zone {
    /// `z = z_c + sqrt(R^2 - (y - y_c)^2)`: the side of a circle that looks down.
    Down(f64, f64, f64),
    /// `z = z_c - sqrt(R^2 - (y - y_c)^2)`: the side that looks up.
    Up(f64, f64, f64),
    /// `z = z_0 + slope y`.
    Line(f64, f64),
    /// Coefficients of rising powers of `y`, and the `y` about which they are evaluated.
    Polynomial(&'static [f64], f64),
}

/// Zones in rising `y`, zone `k` from break `k` to break `k + 1`.
pub(super) fn profile(role: Role, breaks: &[f64], zones: &[Zone]) -> Profile {
    let mut pieces: Vec<Piece> = breaks
        .windows(2)
        .zip(zones)
        .map(|(ends, zone)| match role {
            Role::Rail => zone.piece(ends[0], ends[1]),
            Role::Wheel => zone.piece(ends[1], ends[0]),
        })
        .collect();
    if role == Role::Wheel {
        pieces.reverse();
    }
    Profile::known(role, Curve::chain(pieces))
}

impl Zone {
    fn piece(self, from: f64, to: f64) -> Piece {
        let point = |y: f64| [y * MM, self.height(y) * MM];
        match self {
            Self::Down(y, z, radius) | Self::Up(y, z, radius) => {
                Arc::between([y * MM, z * MM], radius * MM, point(from), point(to))
            }
            Self::Line(..) => Line::between(point(from), point(to)),
            Self::Polynomial(coefficients, centre) => {
                let about = about(coefficients, centre);
                let in_metres = about.iter().zip(0..).map(|(a, k)| a * MM * 1e3f64.powi(k));
                Graph::between(in_metres.collect(), centre * MM, [from * MM, to * MM])
            }
        }
    }

    fn height(self, y: f64) -> f64 {
        let rise = |centre: f64, radius: f64| {
            ((radius - y + centre) * (radius + y - centre)).max(0.0).sqrt()
        };
        match self {
            Self::Down(centre, z, radius) => z + rise(centre, radius),
            Self::Up(centre, z, radius) => z - rise(centre, radius),
            Self::Line(z, slope) => z + slope * y,
            Self::Polynomial(coefficients, _) => {
                coefficients.iter().rev().fold(0.0, |z, a| z * y + a)
            }
        }
    }
}

/// The same polynomial by powers of `y - centre`: repeated synthetic division.
fn about(coefficients: &[f64], centre: f64) -> Vec<f64> {
    let mut shifted = coefficients.to_vec();
    for first in 0..shifted.len() {
        let mut carried = 0.0;
        for a in shifted.iter_mut().skip(first).rev() {
            carried = *a + centre * carried;
            *a = carried;
        }
    }
    shifted
}
