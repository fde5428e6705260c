//! Slip stencils: the elastic slip of a strip's elements from displacements on its middle line.
//!
//! The elastic slip over the step between the centres of two elements is the difference of their
//! displacements over its length. Where an element takes it from steps upstream only, nothing
//! downstream decides whether it adheres, and adhesion is the same equation everywhere: two
//! steps, extrapolated to the element's centre, are of second order.

use super::mesh::Strip;

/// Points of displacement of one strip, and the elements' slip by them.
#[derive(Debug)]
pub(crate) struct SlipStencil {
    /// The leading edge, then the elements' centres.
    pub points: Vec<[f64; 2]>,
    /// Weights of each element's slip: points of displacement and factors.
    pub weights: Vec<[(usize, f64); 3]>,
    /// Where each element's slip is the one so found.
    pub places: Vec<[f64; 2]>,
}

impl SlipStencil {
    /// The slip of steady rolling: the displacement's derivative along the strip.
    pub(crate) fn steady(strip: &Strip) -> Self {
        let points: Vec<[f64; 2]> = std::iter::once(strip.middle_cut(0))
            .chain((0..strip.len()).map(|i| centre(strip, i)))
            .collect();
        let x = |k: usize| points[k][0];
        let middle = |step: usize| 0.5 * (x(step) + x(step + 1));
        let weights = (0..strip.len()).map(|i| {
            let last = 1.0 / (x(i) - x(i + 1));
            if i == 0 {
                return [(0, last), (1, -last), (1, 0.0)];
            }
            let by = (middle(i) - x(i + 1)) / (middle(i - 1) - middle(i));
            let before = by / (x(i - 1) - x(i));
            let last = last + by * last;
            [(i - 1, -before), (i, last + before), (i + 1, -last)]
        });
        let first = [middle(0), points[0][1]];
        let places = std::iter::once(first).chain(points.iter().skip(2).copied()).collect();
        Self { weights: weights.collect(), places, points }
    }

    /// Factors of the step that ends at each element and of the one before it, in its slip.
    pub(crate) fn of_steps(&self) -> impl Iterator<Item = [f64; 2]> {
        let first = |[(_, own), ..]: &[(usize, f64); 3]| [*own, 0.0];
        let other = |[(_, before), _, (_, own)]: &[(usize, f64); 3]| [-own, *before];
        let weights = self.weights.iter().enumerate();
        weights.map(move |(i, weights)| if i == 0 { first(weights) } else { other(weights) })
    }

    /// Slip of each element by a displacement.
    pub(crate) fn slip(
        &self,
        displacement: impl Fn([f64; 2]) -> [f64; 2],
    ) -> impl Iterator<Item = [f64; 2]> {
        let at: Vec<[f64; 2]> = self.points.iter().map(|point| displacement(*point)).collect();
        self.weights.iter().map(move |weights| {
            [0, 1].map(|k| weights.iter().map(|(point, weight)| weight * at[*point][k]).sum())
        })
    }
}

/// Centre of an element on the middle line.
fn centre(strip: &Strip, i: usize) -> [f64; 2] {
    let [[front, y], [rear, _]] = [strip.middle_cut(i), strip.middle_cut(i + 1)];
    [0.5 * (front + rear), y]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coulomb::mesh::Mesh;
    use crate::ellipse::Ellipse;

    /// A parabola's slope is exact behind the first element, which has one step only.
    #[test]
    fn slip_is_of_second_order() {
        let mesh = Mesh::ellipse(Ellipse::from_ratio(1.4).unwrap(), 7, 4);
        let stencil = SlipStencil::steady(&mesh.strips[1]);
        let slip = stencil.slip(|[x, _]| [1.0 - 2.0 * x, 3.0 * x * x]);
        for (i, (slip, [x, _])) in slip.zip(&stencil.places).enumerate() {
            // Rounding over steps of a twentieth.
            assert!((slip[0] + 2.0).abs() < 1e-13 && (slip[1] - 6.0 * x).abs() < 1e-12, "{i}");
        }
    }
}
