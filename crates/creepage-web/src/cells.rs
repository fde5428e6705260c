//! Cells of the contact ellipse to draw: strips along the rolling direction, each cut over its own length.

use std::f64::consts::PI;

use creepage::Ellipse;

const ALONG: usize = 96;
const STRIPS: usize = 56;

/// A quadrilateral of the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    /// All around, in the ellipse's unit of length.
    pub(crate) corners: [[f64; 2]; 4],
    pub(crate) middle: [f64; 2],
}

/// Cells that fill the ellipse, strip by strip; strips are narrower towards the ends.
pub(crate) fn cells(ellipse: Ellipse) -> impl Iterator<Item = Cell> {
    let side = move |strip: f64| -ellipse.b() * (PI * strip / STRIPS as f64).cos();
    let point = move |along: f64, y: f64| {
        let half_length = ellipse.a() * (1.0 - (y / ellipse.b()).powi(2)).max(0.0).sqrt();
        [half_length * (2.0 * along / ALONG as f64 - 1.0), y]
    };
    let cell = move |strip: usize, along: usize| {
        let (j, i) = (strip as f64, along as f64);
        let [below, above] = [side(j), side(j + 1.0)];
        let corners =
            [point(i, below), point(i + 1.0, below), point(i + 1.0, above), point(i, above)];
        Cell { corners, middle: point(i + 0.5, 0.5 * (below + above)) }
    };
    (0..STRIPS).flat_map(move |strip| (0..ALONG).map(move |along| cell(strip, along)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Chords cut off less than a part in 500 of strips that are narrower towards the ends.
    #[test]
    fn cells_fill_the_ellipse() {
        let ellipse = Ellipse::from_ratio(3.0).unwrap();
        let area = |[a, b, c, d]: [[f64; 2]; 4]| {
            let ([p, q], [r, s]) = ([c[0] - a[0], c[1] - a[1]], [d[0] - b[0], d[1] - b[1]]);
            0.5 * (p * s - q * r)
        };
        let filled: f64 = cells(ellipse).map(|cell| area(cell.corners)).sum();
        assert!((filled / ellipse.area() - 1.0).abs() < 2e-3, "{filled}");
        for Cell { middle: [x, y], .. } in cells(ellipse) {
            assert!((x / ellipse.a()).powi(2) + (y / ellipse.b()).powi(2) < 1.0);
        }
    }
}
