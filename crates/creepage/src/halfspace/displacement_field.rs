//! Displacement differences at any point of the surface, of one traction.
//!
//! Along a chord of the ellipse the mean of a harmonic, weighted by `(1 - r^2)^(-1/2)`, is
//! `P_n(h) Y_nm(n)`: the chord lifts to half a small circle of the sphere, about the axis `n`
//! on the edge, at distance `h` from the centre. So the displacement at *any* point is one
//! integral over the directions of the lines through it that meet the ellipse. Inside, the
//! addition theorem makes a polynomial of it: the load-displacement equations.

use super::coupling::HalfChords;
use super::lines::{Line, Lines};
use super::{LoadDisplacement, Traction, harmonics};
use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;

/// The displacement differences `u+ - u-` that one traction causes on the surface.
///
/// ```
/// use creepage::Ellipse;
/// use creepage::halfspace::{DisplacementField, Edge, Polynomial, Traction};
/// // A flat die on a circle: outside, w falls as (2/pi) asin(a/r).
/// let (none, f00) = (Polynomial::zero(0), Polynomial::new(vec![0.1])?);
/// let die = Traction::new(Ellipse::new(1.0, 1.0)?, Edge::Singular, [&none, &none, &f00])?;
/// let field = DisplacementField::new(&die, 0.3, 0.0)?;
/// let [_, _, under] = field.at([0.0, 0.5]);
/// let [_, _, beside] = field.at([2.0, 0.0]);
/// assert!((beside / under - 1.0 / 3.0).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct DisplacementField {
    ellipse: Ellipse,
    poisson: f64,
    kappa: f64,
    degree: usize,
    traction: [Vec<f64>; 3],
    inside: [Vec<f64>; 3],
    lines: Lines,
    half_chords: HalfChords,
}

impl DisplacementField {
    /// The field of `traction` on bodies with the combined Poisson's ratio `poisson` and the
    /// measure of dissimilarity `kappa` of (2.10).
    ///
    /// With `kappa` not zero, pressure adds to `u` and `v` by (2.11a,b) and tangential traction
    /// to `w` by (2.15c). Of [`Traction::x_derivative`] of Hertz's pressure that is (6.4).
    ///
    /// # Errors
    /// [`InvalidValue`] unless `0 <= poisson <= 0.5` and `-0.5 <= kappa <= 0.5`.
    pub fn new(traction: &Traction, poisson: f64, kappa: f64) -> Result<Self, InvalidValue> {
        let valid = "between -0.5 and 0.5";
        check::require((-0.5..=0.5).contains(&kappa), "kappa", kappa, valid)?;
        let (ellipse, degree) = (traction.ellipse(), traction.singular_degree());
        let response = LoadDisplacement::new(ellipse, poisson, degree)?;
        let [x, y, z] = traction.singular();
        let [u, v] = response.tangential([x, y]);
        Ok(Self {
            ellipse,
            poisson,
            kappa,
            degree,
            traction: [x, y, z].map(<[f64]>::to_vec),
            inside: [u, v, response.normal(z)],
            lines: Lines::new(ellipse),
            half_chords: HalfChords::new(degree),
        })
    }

    /// `[u, v, w]` at `[x, y]`, in the ellipse's unit of length.
    ///
    /// Inside like bodies cost the evaluation of a polynomial; outside, and for unlike bodies,
    /// it is a quadrature with some hundred nodes. Relative accuracy is 1e-12 for ratios `a/b`
    /// between 1e-3 and 1e3 and 1e-10 beyond; at `r` semi-axes from the centre `1e-16 r` besides.
    #[must_use]
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let point = [x / self.ellipse.a(), y / self.ellipse.b()];
        let radius = point[0].hypot(point[1]);
        if radius > 1.0 {
            return if radius.is_finite() { self.outside(point) } else { [0.0; 3] };
        }
        let [u, v, w] = self.inside.each_ref().map(Vec::as_slice);
        let like = harmonics::sum(self.degree, point, [u, v, w]);
        if self.kappa == 0.0 {
            return like;
        }
        let unlike = self.unlike_inside(point);
        [0, 1, 2].map(|i| like[i] + self.kappa * unlike[i])
    }

    /// What is to be multiplied with kappa inside: (2.11a,b), (2.15c).
    fn unlike_inside(&self, point: [f64; 2]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for line in self.lines.through(point) {
            let odd = self.half_chords.difference(self.tables(), point, line.direction);
            add(&mut sum, line.weight, coupled(odd, line.cosines));
        }
        sum
    }

    fn outside(&self, point: [f64; 2]) -> [f64; 3] {
        let mut legendre = vec![0.0; self.degree + 1];
        let mut sum = [0.0; 3];
        for line in self.lines.towards(point) {
            let mean = self.chord_mean(point, &line, &mut legendre);
            add(&mut sum, line.weight, like(self.poisson, mean, line.cosines));
            add(&mut sum, self.kappa * line.weight, coupled(mean, line.cosines));
        }
        sum
    }

    /// The means of the three components over a chord, over pi.
    fn chord_mean(&self, [x, y]: [f64; 2], line: &Line, legendre: &mut [f64]) -> [f64; 3] {
        let axis = [-line.direction[1], line.direction[0]];
        fill_legendre((x * axis[0] + y * axis[1]).clamp(-1.0, 1.0), legendre);
        let mut mean = [0.0; 3];
        harmonics::visit(self.degree, axis, |n, m, value| {
            if n.wrapping_add_signed(m).is_multiple_of(2) {
                let position = harmonics::position(n, m);
                for (mean, table) in mean.iter_mut().zip(&self.traction) {
                    *mean += legendre[n] * value * table[position];
                }
            }
        });
        mean
    }

    fn tables(&self) -> [&[f64]; 3] {
        self.traction.each_ref().map(Vec::as_slice)
    }
}

/// The kernels of (2.11c), (2.15a,b) on the tractions along one line.
fn like(poisson: f64, [x, y, z]: [f64; 3], [cos, sin]: [f64; 2]) -> [f64; 3] {
    let shear = poisson * sin * cos;
    [
        (1.0 - poisson * sin * sin) * x + shear * y,
        (1.0 - poisson * cos * cos) * y + shear * x,
        (1.0 - poisson) * z,
    ]
}

/// The kernels of (2.11a,b), (2.15c) over kappa, on the tractions along one line.
fn coupled([x, y, z]: [f64; 3], [cos, sin]: [f64; 2]) -> [f64; 3] {
    [cos * z, sin * z, -(cos * x + sin * y)]
}

fn add(sum: &mut [f64; 3], weight: f64, values: [f64; 3]) {
    sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
}

/// Legendre's polynomials at `h`, from degree zero up.
fn fill_legendre(h: f64, values: &mut [f64]) {
    let (mut previous, mut current) = (0.0, 1.0);
    for (n, value) in values.iter_mut().enumerate() {
        *value = current;
        let n = n as f64;
        let next = ((2.0 * n + 1.0) * h * current - n * previous) / (n + 1.0);
        (previous, current) = (current, next);
    }
}
