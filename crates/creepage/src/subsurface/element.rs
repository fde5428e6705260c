//! Elements of constant traction on polygons.

use super::edges::EdgeLoad;
use crate::check::{self, InvalidValue};

/// A flat polygon of the surface that carries a constant traction.
#[derive(Debug, Clone, PartialEq)]
pub struct Element {
    corners: Vec<[f64; 2]>,
    traction: [f64; 3],
}

/// Error of a polygon that cannot carry a traction.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ElementError {
    /// A coordinate or a traction is not finite.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// Fewer than three corners.
    #[error("an element has three corners or more, not {given}")]
    Corners {
        /// How many corners were given.
        given: usize,
    },
}

impl Element {
    /// A polygon by its corners, all around either way, with the traction `[X, Y, Z]` of the upper
    /// body on the lower. It must not cross itself; corners may coincide.
    ///
    /// # Errors
    /// [`ElementError`] for fewer than three corners and for numbers that are not finite.
    pub fn new(corners: &[[f64; 2]], traction: [f64; 3]) -> Result<Self, ElementError> {
        if corners.len() < 3 {
            return Err(ElementError::Corners { given: corners.len() });
        }
        for [x, y] in corners {
            check::finite("corner_x", *x)?;
            check::finite("corner_y", *y)?;
        }
        for (name, value) in ["traction_x", "traction_y", "traction_z"].into_iter().zip(traction) {
            check::finite(name, value)?;
        }
        Ok(Self { corners: corners.to_vec(), traction })
    }

    /// A rectangle with sides along the axes: its centre, its lengths, its traction.
    ///
    /// # Errors
    /// [`ElementError`] for numbers that are not finite.
    pub fn rectangle(
        [x, y]: [f64; 2],
        [length, width]: [f64; 2],
        traction: [f64; 3],
    ) -> Result<Self, ElementError> {
        let corner = |i: f64, j: f64| [x + 0.5 * i * length, y + 0.5 * j * width];
        let corners = [corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0)];
        Self::new(&corners, traction)
    }

    /// Corners, all around.
    #[must_use]
    pub fn corners(&self) -> &[[f64; 2]] {
        &self.corners
    }

    /// The traction `[X, Y, Z]` of the upper body on the lower.
    #[must_use]
    pub fn traction(&self) -> [f64; 3] {
        self.traction
    }

    /// The sides with the element on their left, each with the traction times `signs`.
    pub(super) fn sides(&self, signs: [f64; 3]) -> impl Iterator<Item = EdgeLoad> {
        let count = self.corners.len();
        let turn = if self.area() < 0.0 { -1.0 } else { 1.0 };
        let load = [0, 1, 2].map(|k| turn * signs[k] * self.traction[k]);
        (0..count)
            .map(move |i| EdgeLoad { ends: [self.corners[i], self.corners[(i + 1) % count]], load })
    }

    /// Area, and centroid; the first corner where the area is zero.
    pub(super) fn area_and_centroid(&self) -> (f64, [f64; 2]) {
        let ([x0, y0], area) = (self.corners[0], self.area());
        let next = self.corners.iter().cycle().skip(1);
        let mut moment = [0.0; 2];
        for ([x, y], [u, v]) in self.corners.iter().zip(next) {
            let cross = (x - x0) * (v - y0) - (u - x0) * (y - y0);
            moment[0] += cross * (x - x0 + u - x0) / 6.0;
            moment[1] += cross * (y - y0 + v - y0) / 6.0;
        }
        let [x, y] = moment.map(|part| if area == 0.0 { 0.0 } else { part / area });
        (area.abs(), [x0 + x, y0 + y])
    }

    /// The same element in another unit of length.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        let corners = self.corners.iter().map(|corner| corner.map(|x| factor * x)).collect();
        Self { corners, traction: self.traction }
    }

    /// Whether its corners go from `x` to `-y`.
    pub(super) fn is_clockwise(&self) -> bool {
        self.area() < 0.0
    }

    /// Area, negative when the corners go clockwise (from `x` to `-y`).
    fn area(&self) -> f64 {
        let [x0, y0] = self.corners[0];
        let next = self.corners.iter().cycle().skip(1);
        let cross = self
            .corners
            .iter()
            .zip(next)
            .map(|(one, two)| (one[0] - x0) * (two[1] - y0) - (two[0] - x0) * (one[1] - y0));
        0.5 * cross.sum::<f64>()
    }
}
