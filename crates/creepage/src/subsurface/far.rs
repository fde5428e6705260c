//! Far field of the contact: that of point forces on the surface (Boussinesq, Cerruti).
//!
//! Far away the closed forms lose their digits and overflow at last. What a traction looks like from
//! there is a few point forces with its lowest moments; their fields are written in the direction to
//! the point, so that no power of the distance is formed.

use std::f64::consts::PI;
use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;

use super::element::Element;
use super::wave::Source;

/// From so far on, over the reach of the tractions, they are point forces: those of an ellipse err by
/// the fourth power of its inverse, one of an element by the square, beside stresses of the square.
const FAR: f64 = 1e3;
/// Moments of an ellipse's traction that are kept beyond its own degree.
const MOMENTS: usize = 4;

/// A force `[X, Y, Z]` at a place of the surface.
#[derive(Debug, Clone, Copy)]
struct PointForce {
    at: [f64; 2],
    force: [f64; 3],
}

/// Tractions seen from far away.
#[derive(Debug, Clone, Default)]
pub(super) struct PointForces {
    forces: Vec<PointForce>,
    /// Largest distance from the origin at which there is a traction.
    reach: f64,
}

impl PointForces {
    /// Of constant tractions on elements: one in the middle of each.
    pub(super) fn of_elements(elements: &[Element], signs: [f64; 3]) -> Self {
        let force = |element: &Element| {
            let (area, at) = element.area_and_centroid();
            let traction = element.traction();
            PointForce { at, force: [0, 1, 2].map(|k| area * signs[k] * traction[k]) }
        };
        let corners = elements.iter().flat_map(Element::corners);
        Self {
            reach: corners.fold(0.0, |reach: f64, [x, y]| reach.max(x.hypot(*y))),
            forces: elements.iter().map(force).collect(),
        }
    }

    /// Of a polynomial traction on an ellipse: the nodes of a quadrature that is exact for its lowest
    /// moments. The ellipse is the shadow of a half-sphere, over which `(1 - r^2)^(-1/2)` is even.
    pub(super) fn of_source(source: &Source) -> Self {
        let exact = source.degree() + MOMENTS;
        let rule = GaussLegendre::new(NonZeroUsize::MIN.saturating_add(exact / 2));
        let (a, b, turns) = (source.ellipse.a(), source.ellipse.b(), exact + 1);
        let mut forces = Vec::new();
        for (node, weight) in rule.as_node_weight_pairs() {
            let height = 0.5 * (1.0 + node);
            let radius = (1.0 - height * height).max(0.0).sqrt();
            for turn in 0..turns {
                let (sin, cos) = (2.0 * PI * turn as f64 / turns as f64).sin_cos();
                let place = [radius * cos, radius * sin];
                let share = 0.5 * weight * 2.0 * PI / turns as f64 * a * b;
                let force = source.polynomials(place).map(|value| share * value);
                forces.push(PointForce { at: [a * place[0], b * place[1]], force });
            }
        }
        Self { forces, reach: a.max(b) }
    }

    /// Whether a point is far away.
    pub(super) fn is_far(&self, [x, y, z]: [f64; 3]) -> bool {
        x.hypot(y).hypot(z) > FAR * self.reach
    }

    /// `4 pi` times the stress, `[xx, yy, zz, xy, yz, xz]`.
    pub(super) fn stress(&self, point: [f64; 3], poisson: f64) -> [f64; 6] {
        self.sum(|one| one.stress(point, poisson))
    }

    /// `4 pi G` times the displacement.
    pub(super) fn displacement(&self, point: [f64; 3], poisson: f64) -> [f64; 3] {
        self.sum(|one| one.displacement(point, poisson))
    }

    fn sum<const N: usize>(&self, of: impl Fn(&PointForce) -> [f64; N]) -> [f64; N] {
        let mut sum = [0.0; N];
        for one in &self.forces {
            sum.iter_mut().zip(of(one)).for_each(|(sum, part)| *sum += part);
        }
        sum
    }
}

impl PointForce {
    /// The direction to a point and the distance.
    fn seen(&self, [x, y, z]: [f64; 3]) -> ([f64; 3], f64) {
        let [dx, dy] = [x - self.at[0], y - self.at[1]];
        // A distance beyond all numbers gives no field.
        let distance = dx.hypot(dy).hypot(z).min(f64::MAX);
        ([dx, dy, z].map(|part| part / distance), distance)
    }

    fn stress(&self, point: [f64; 3], poisson: f64) -> [f64; 6] {
        let ([x, y, z], distance) = self.seen(point);
        let [along, across, normal] = self.force.map(|part| 2.0 * part / distance / distance);
        let compressible = 1.0 - 2.0 * poisson;
        let below = 1.0 / (1.0 + z);
        let (square, cube) = (below * below, below * below * below);
        // Of a force into the body.
        let outward = (2.0 + z) * square;
        let radial = |n: f64| -3.0 * n * n * z + compressible * (z - below + n * n * outward);
        let pressed = [
            radial(x),
            radial(y),
            -3.0 * z * z * z,
            -3.0 * x * y * z + compressible * x * y * outward,
            -3.0 * y * z * z,
            -3.0 * x * z * z,
        ];
        // Of a force along the surface, `n` the direction cosine along it and `m` that across: stress
        // along both, the shear between them, and the three on planes of constant depth.
        let pushed = |n: f64, m: f64| {
            let bend = square + 2.0 * cube;
            [
                -3.0 * n * n * n + compressible * n * (1.0 - 3.0 * square + n * n * bend),
                -3.0 * n * m * m + compressible * n * (1.0 - square + m * m * bend),
                -3.0 * n * z * z,
                -3.0 * n * n * m + compressible * m * (n * n * bend - square),
                -3.0 * n * m * z,
                -3.0 * n * n * z,
            ]
        };
        let [xx, yy, zz, xy, yz, xz] = pushed(x, y);
        let of_x = [xx, yy, zz, xy, yz, xz];
        let [yy, xx, zz, xy, xz, yz] = pushed(y, x);
        let of_y = [xx, yy, zz, xy, yz, xz];
        std::array::from_fn(|k| normal * pressed[k] + along * of_x[k] + across * of_y[k])
    }

    fn displacement(&self, point: [f64; 3], poisson: f64) -> [f64; 3] {
        let ([x, y, z], distance) = self.seen(point);
        let [along, across, normal] = self.force.map(|part| part / distance);
        let compressible = 1.0 - 2.0 * poisson;
        let below = 1.0 / (1.0 + z);
        let pressed = |n: f64| n * (z - compressible * below);
        let pushed = |n: f64| 1.0 + n * n + compressible * (below - n * n * below * below);
        let cross = x * y * (1.0 - compressible * below * below);
        let sunk = |n: f64| n * (z + compressible * below);
        [
            normal * pressed(x) + along * pushed(x) + across * cross,
            normal * pressed(y) + along * cross + across * pushed(y),
            normal * (z * z + 1.0 + compressible) + along * sunk(x) + across * sunk(y),
        ]
    }
}
