//! Field of a statics problem over the contact, for points and pictures.

use creepage::statics::{
    Bonded, Compression, Die, PartialSlip, ShearedRectangle, ShiftAxis, ShiftPath,
};

/// Length of a vector.
pub(super) fn magnitude([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

/// A vector along an axis.
fn along(axis: ShiftAxis, value: f64) -> [f64; 2] {
    match axis {
        ShiftAxis::X => [value, 0.0],
        ShiftAxis::Y => [0.0, value],
    }
}

/// The solution whose field is shown.
#[derive(Debug, Clone, Copy)]
pub(super) enum Field<'a> {
    Die { die: &'a Die, offset: [f64; 2] },
    Bonded(&'a Bonded),
    PartialSlip(&'a PartialSlip),
    ShiftPath(&'a ShiftPath, ShiftAxis),
    Compression(&'a Compression),
    Rectangle(&'a ShearedRectangle),
}

impl Field<'_> {
    /// Pressure of the die, or magnitude of the traction (Pa).
    pub(super) fn intensity(&self, point: [f64; 2]) -> f64 {
        match self {
            Self::Die { die, .. } => die.pressure(point),
            _ => magnitude(self.traction(point)),
        }
    }

    /// Tangential traction on the lower body (Pa); the die has none.
    pub(super) fn traction(&self, point: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Die { .. } => [0.0; 2],
            Self::Bonded(bonded) => bonded.traction(point),
            Self::PartialSlip(partial) => partial.traction(point),
            Self::ShiftPath(path, axis) => along(*axis, path.traction(point)),
            Self::Rectangle(path) => along(path.axis(), path.traction()),
            Self::Compression(compression) => {
                let radius = magnitude(point);
                let [_, traction] = compression.at(radius);
                if radius > 0.0 { point.map(|part| part / radius * traction) } else { [0.0; 2] }
            }
        }
    }

    /// Whether the intensity grows without bound towards the edge.
    pub(super) fn is_singular(&self) -> bool {
        matches!(self, Self::Die { .. } | Self::Bonded(_))
    }

    /// What the intensity is.
    pub(super) fn name(&self) -> &'static str {
        match self {
            Self::Die { .. } => "pressure",
            _ => "traction",
        }
    }

    /// Names of the numbers of [`Field::row`].
    pub(super) fn header(&self) -> &'static [&'static str] {
        match self {
            Self::Die { .. } => &["pressure_pa", "u_m", "v_m", "w_m"],
            Self::Bonded(_) => &["traction_x_pa", "traction_y_pa", "u_m", "v_m", "w_m"],
            Self::ShiftPath(..) => &["traction_x_pa", "traction_y_pa"],
            Self::Compression(_) | Self::Rectangle(_) => {
                &["traction_x_pa", "traction_y_pa", "pressure_pa"]
            }
            Self::PartialSlip(_) => &[
                "traction_x_pa",
                "traction_y_pa",
                "u_m",
                "v_m",
                "w_m",
                "bound_pa",
                "slip_x_m",
                "slip_y_m",
                "slip_to_traction_deg",
            ],
        }
    }

    /// The field at a point inside the contact; NaN where a number does not exist.
    pub(super) fn row(&self, point: [f64; 2]) -> Vec<f64> {
        let [x, y] = self.traction(point);
        match self {
            Self::Die { die, .. } => {
                let [u, v, w] = die.displacement(point);
                vec![die.pressure(point), u, v, w]
            }
            Self::Bonded(bonded) => {
                let [u, v, w] = bonded.displacement(point);
                vec![x, y, u, v, w]
            }
            Self::ShiftPath(..) => vec![x, y],
            Self::Compression(compression) => vec![x, y, compression.at(magnitude(point))[0]],
            Self::Rectangle(path) => vec![x, y, path.pressure()],
            Self::PartialSlip(partial) => {
                let [u, v, w] = partial.displacement(point);
                let [sx, sy] = partial.slip(point).unwrap_or([f64::NAN; 2]);
                let angle = partial.disagreement(point).map_or(f64::NAN, f64::to_degrees);
                vec![x, y, u, v, w, partial.bound(point), sx, sy, angle]
            }
        }
    }
}
