//! The field of a polynomial traction on the ellipse, direction by direction.
//!
//! With `D = (i cos, i sin, 1)` of the direction's normal, `w` the complex variable of Whittaker's
//! integral, `S = D . (X, Y, Z)`, and `< >` the integral over directions:
//!
//! ```math
//! 4 \pi G u_k = \left\langle \frac{2 T_k - D_k Z + 2 \sigma D_k S
//!   + \delta_{kz} (1 - 4 \sigma) S}{w} + \frac{z D_k S}{w^2} \right\rangle
//! ```
//!
//! and by Hooke's law the stress, in which Poisson's ratio 1/2 is an ordinary number.

use nalgebra::Complex;

use super::directions::{Directions, DiscPoint};
use super::far::PointForces;
use super::hertz_waves::HertzWaves;
use super::many::Field;
use super::wave::{ComplexTriple, Potentials, Source, Wave};
use crate::halfspace::Traction;

/// A polynomial traction, prepared.
#[derive(Debug, Clone)]
pub(super) struct Waves {
    source: Source,
    directions: Directions,
    far: PointForces,
    hertz: Option<HertzWaves>,
}

const I: Complex<f64> = Complex::new(0.0, 1.0);

impl Waves {
    /// `factors` are the unit of each component, with the sign of the body.
    pub(super) fn new(traction: &Traction, factors: [f64; 3]) -> Self {
        let source = Source::new(traction, factors);
        let far = PointForces::of_source(&source);
        let hertz = HertzWaves::new(&source);
        Self { directions: Directions::new(&source), source, far, hertz }
    }

    /// `4 pi` times the stress, `[xx, yy, zz, xy, yz, xz]`.
    pub(super) fn stress(&self, point: [f64; 3], poisson: f64) -> [f64; 6] {
        if self.far.is_far(point) {
            return self.far.stress(point, poisson);
        }
        self.integrate(point, |wave, potentials| stress(wave, &potentials, point[2], poisson))
    }

    /// `4 pi G` times the displacement.
    pub(super) fn displacement(&self, point: [f64; 3], poisson: f64) -> [f64; 3] {
        if self.far.is_far(point) {
            return self.far.displacement(point, poisson);
        }
        self.integrate(point, |wave, potentials| displacement(wave, &potentials, point[2], poisson))
    }

    /// Both, stress first.
    pub(super) fn field(&self, point: [f64; 3], poisson: f64) -> Field {
        let join = |[a, b, c, d, e, f]: [f64; 6], [u, v, w]: [f64; 3]| [a, b, c, d, e, f, u, v, w];
        if self.far.is_far(point) {
            return join(self.far.stress(point, poisson), self.far.displacement(point, poisson));
        }
        if let Some(field) = self.hertz.as_ref().and_then(|hertz| hertz.field(point, poisson)) {
            return field;
        }
        self.integrate(point, |wave, potentials| {
            let stress = stress(wave, &potentials, point[2], poisson);
            join(stress, displacement(wave, &potentials, point[2], poisson))
        })
    }

    /// `4 pi G` times `(du/dx, dv/dx)` on the surface of one body.
    pub(super) fn surface_slope(&self, [x, y]: [f64; 2], poisson: f64) -> [f64; 2] {
        self.integrate([x, y, 0.0], |wave, potentials| surface_slope(wave, &potentials, poisson))
    }

    /// `(X', Y')` of (4.40) at the edge's point in direction `[cos, sin]` of the disc.
    pub(super) fn edge_strength(&self, toward: [f64; 2]) -> [f64; 2] {
        self.source.edge_strength(toward)
    }

    fn integrate<const N: usize>(
        &self,
        [x, y, z]: [f64; 3],
        mut field: impl FnMut(&Wave, Potentials) -> [f64; N],
    ) -> [f64; N] {
        let position = [x / self.source.ellipse.a(), y / self.source.ellipse.b()];
        let radius = position[0].hypot(position[1]);
        let at = DiscPoint { position, radius, depth: z / self.source.ellipse.minor() };
        // Beside a contact with a singular edge the integrand has a pole on the surface; as close
        // below it, the double exponential rule takes both its sides and its residue.
        let beside = self.source.is_singular() && radius > 1.0;
        let seen_from = if beside { z.max(1e-13 * self.source.ellipse.minor()) } else { z };
        let mut q = vec![Complex::new(0.0, 0.0); self.source.terms()];
        self.directions.integrate(&self.source, at, |wave, toward_end| {
            field(wave, wave.potentials(wave.variable(toward_end, seen_from), &mut q))
        })
    }
}

/// `S`.
fn source([x, y, z]: ComplexTriple, [cos, sin]: [f64; 2]) -> Complex<f64> {
    I * (x * cos + y * sin) + z
}

fn stress(wave: &Wave, potentials: &Potentials, depth: f64, poisson: f64) -> [f64; 6] {
    let [cos, sin] = wave.normal;
    // Over w^2, and over w^3 times the depth.
    let t = potentials.slope.map(|value| 2.0 * value);
    let s = source(t, wave.normal);
    let deep = source(potentials.bend, wave.normal) * I * (depth / wave.half_width);
    let ([ix, iy], pressure) = ([I * cos, I * sin], t[2]);
    let in_plane = |first: Complex<f64>, second: Complex<f64>, t: Complex<f64>, own: bool| {
        // -(D_j A_k + D_k A_j), with A_k = 2 T_k - D_k Z + 2 sigma D_k S.
        let product = first * second;
        let mean = if own { 4.0 * poisson * s } else { Complex::new(0.0, 0.0) };
        (-2.0 * t + 2.0 * product * pressure
            - 4.0 * poisson * product * s
            - mean
            - 4.0 * product * deep)
            .re
    };
    [
        in_plane(ix, ix, 2.0 * ix * t[0], true),
        in_plane(iy, iy, 2.0 * iy * t[1], true),
        (-2.0 * t[2] - 4.0 * deep).re,
        in_plane(ix, iy, ix * t[1] + iy * t[0], false),
        (-2.0 * t[1] - 4.0 * iy * deep).re,
        (-2.0 * t[0] - 4.0 * ix * deep).re,
    ]
}

fn displacement(wave: &Wave, potentials: &Potentials, depth: f64, poisson: f64) -> [f64; 3] {
    let [cos, sin] = wave.normal;
    // Over w.
    let t = potentials.value.map(|value| -2.0 * wave.half_width * I * value);
    let s = source(t, wave.normal);
    let deep = 2.0 * source(potentials.slope, wave.normal) * depth;
    let [ix, iy] = [I * cos, I * sin];
    let along = |d: Complex<f64>, t_k: Complex<f64>| {
        (2.0 * t_k - d * t[2] + 2.0 * poisson * d * s + d * deep).re
    };
    [along(ix, t[0]), along(iy, t[1]), (t[2] + (1.0 - 2.0 * poisson) * s + deep).re]
}

fn surface_slope(wave: &Wave, potentials: &Potentials, poisson: f64) -> [f64; 2] {
    let [ix, iy] = wave.normal.map(|cosine| I * cosine);
    let t = potentials.slope.map(|value| 2.0 * value);
    let s = source(t, wave.normal);
    let along = |d: Complex<f64>, t_k: Complex<f64>| {
        (-ix * (2.0 * t_k - d * t[2] + 2.0 * poisson * d * s)).re
    };
    [along(ix, t[0]), along(iy, t[1])]
}
