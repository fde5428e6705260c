//! Slip forcing: creepage, spin and, between dissimilar bodies, the pressure (6.4).
//!
//! The pressure's part has a closed form. By (2.11a,b) `u - iv`, as a function of `z = x + iy`, is
//! the plane field of attraction of a mass of density `Z`, times `-kappa / (pi G)`. Newton's shells
//! make one integral of it: a thin shell between similar ellipses attracts only what lies outside
//! of it, and there as its mass does along the focal segment. For Hertz's pressure
//! `Z = G f00 (1 - t)^(1/2)` on the ellipses `t = x^2/a^2 + y^2/b^2`, with the focal distance
//! `f^2 = a^2 - b^2`:
//!
//! ```math
//! u - i v = -\kappa f_{00} \, a b \int_0^t \frac{\sqrt{1 - t'} \, dt'}{\sqrt{z^2 - f^2 t'}}
//! ```

use nalgebra::Complex;

use super::stencil::SlipStencil;
use crate::Creepage;
use crate::ellipse::Ellipse;

/// Nearer to the centre than this (as `t`), the displacement is linear: its slope changes as `t`.
const CENTRE: f64 = 1e-7;
/// Size of `f^2/z^2` below which a power series is exact to rounding.
const NEARLY_CIRCULAR: f64 = 0.05;

/// The slip of every element before any tangential traction acts.
#[derive(Debug, Clone, Default)]
pub(crate) struct SlipForcing {
    pub slip: Vec<[f64; 2]>,
    /// The spin in it, for positions between the elements.
    pub spin: f64,
    /// Compliance of each element's adhesion, and its derivative by the spin; empty where adhesion is rigid:
    /// [`super::spin_pole`].
    pub compliance: Vec<[f64; 2]>,
}

impl SlipForcing {
    /// Rigid slip at `places`, and `factor` times the slip by the pressure.
    pub(crate) fn set(
        &mut self,
        creepage: Creepage,
        places: &[[f64; 2]],
        factor: f64,
        by_pressure: &[[f64; 2]],
    ) {
        self.spin = creepage.chi;
        self.slip.clear();
        self.slip.extend(places.iter().zip(by_pressure).map(|(place, by_pressure)| {
            let rigid = creepage.rigid_slip(*place);
            [0, 1].map(|k| rigid[k] + factor * by_pressure[k])
        }));
    }

    /// Adds slips, as many as there are elements, or none.
    pub(crate) fn add(&mut self, more: &[[f64; 2]]) {
        for (slip, more) in self.slip.iter_mut().zip(more) {
            *slip = [slip[0] + more[0], slip[1] + more[1]];
        }
    }

    /// So many times the slip.
    pub(crate) fn scale(&mut self, factor: f64) {
        for slip in &mut self.slip {
            *slip = slip.map(|s| factor * s);
        }
    }

    /// No slip.
    pub(crate) fn clear(&mut self) {
        self.slip.fill([0.0; 2]);
        self.compliance.clear();
        self.spin = 0.0;
    }

    /// How adhesion of an element gives way, and the derivative of that by the spin.
    pub(crate) fn spin_compliance(&self, element: usize) -> [f64; 2] {
        self.compliance.get(element).copied().unwrap_or_default()
    }

    /// The largest slip.
    pub(crate) fn largest(&self) -> f64 {
        self.slip.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max)
    }
}

/// Slip of every element by Hertz's pressure between dissimilar bodies, over `kappa f00`.
pub(crate) fn by_hertz_pressure(ellipse: Ellipse, stencils: &[SlipStencil]) -> Vec<[f64; 2]> {
    stencils.iter().flat_map(|stencil| stencil.slip(|at| displacement(ellipse, at))).collect()
}

/// The derivatives `[du/dx, dv/dx]` of (6.4), over `kappa f00`, at a position inside the ellipse: central
/// differences of the closed form, with an error of some 1e-8.
pub(crate) fn hertz_slip(ellipse: Ellipse, [x, y]: [f64; 2]) -> [f64; 2] {
    let step = 1e-4 * ellipse.a();
    let [ahead, behind] = [step, -step].map(|step| displacement(ellipse, [x + step, y]));
    [0, 1].map(|k| (ahead[k] - behind[k]) / (2.0 * step))
}

/// The displacement differences `[u, v]` by Hertz's pressure, over `kappa f00`, at a position inside
/// the ellipse.
pub(crate) fn displacement(ellipse: Ellipse, [x, y]: [f64; 2]) -> [f64; 2] {
    let (a, b) = (ellipse.a(), ellipse.b());
    let t = (x / a).powi(2) + (y / b).powi(2);
    if t < CENTRE {
        return [-2.0 * b * x / (a + b), -2.0 * a * y / (a + b)];
    }
    let root = (1.0 - t).max(0.0).sqrt();
    let z = Complex::new(x.abs(), y.abs());
    // The root of z^2 - f^2 t.
    let w = Complex::new(b / a * x.abs(), a / b * y.abs());
    let field = a * b * shells(a * a - b * b, z, w, root);
    [-field.re * x.signum(), field.im * y.signum()]
}

/// The integral over the shells, by parts; `root` is that of `1 - t`.
fn shells(f_squared: f64, z: Complex<f64>, w: Complex<f64>, root: f64) -> Complex<f64> {
    let [p, r] = [f_squared / (z * z), f_squared * root * root / (w * w)];
    let rest = z * z - f_squared;
    if p.norm() < NEARLY_CIRCULAR && r.norm() < NEARLY_CIRCULAR {
        let own = (root / w).powu(3);
        return 1.0 / z - own * w * w - rest * (tail(p) / z.powu(3) - own * tail(r));
    }
    let f = Complex::new(f_squared, 0.0).sqrt();
    let logarithm = ((f + z) / (f * root + w)).ln();
    (z - root * w - rest / f * logarithm) / f_squared
}

/// `1/3 + q/5 + q^2/7 + ...`: what is left of the arc tangent.
fn tail(q: Complex<f64>) -> Complex<f64> {
    const TERMS: u8 = 14;
    (0..TERMS).rev().fold(Complex::new(0.0, 0.0), |sum, k| {
        sum * q + Complex::new(1.0 / f64::from(2 * k + 3), 0.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::halfspace::{DisplacementField, Edge, Polynomial, Traction};

    fn hertz(ellipse: Ellipse) -> Traction {
        let (none, one) = (Polynomial::zero(0), Polynomial::new(vec![1.0]).unwrap());
        Traction::new(ellipse, Edge::Vanishing, [&none, &none, &one]).unwrap()
    }

    fn places(ellipse: Ellipse) -> impl Iterator<Item = [f64; 2]> {
        let disc = [0.0, 0.002, 0.3, 0.7, 0.95, 0.9999];
        disc.into_iter().flat_map(move |r| {
            (0..16).map(move |k| {
                let (sin, cos) = (f64::from(k) * std::f64::consts::PI / 8.0).sin_cos();
                [r * cos * ellipse.a(), r * sin * ellipse.b()]
            })
        })
    }

    /// Against the quadrature over chords, which is good to 1e-12.
    #[test]
    fn the_closed_form_is_the_displacement_field() {
        for ratio in [1.0 / 64.0, 0.3, 0.98, 0.999_999, 1.0, 1.01, 1.04, 5.0, 64.0] {
            let ellipse = Ellipse::from_ratio(ratio).unwrap();
            let field = DisplacementField::new(&hertz(ellipse), 0.3, 0.5).unwrap();
            for at in places(ellipse) {
                let [u, v, _] = field.at(at).map(|value| value / 0.5);
                let found = displacement(ellipse, at);
                let error = (found[0] - u).abs().max((found[1] - v).abs());
                assert!(error < 1e-11, "{ratio} {at:?}: {found:?} {u} {v}");
            }
        }
    }

    /// Central differences of step 1e-5 against (6.4) by the derivative of the pressure: their
    /// error is of order 1e-9.
    #[test]
    fn its_slope_is_the_field_of_the_pressures_slope() {
        let (ellipse, h) = (Ellipse::from_ratio(0.6).unwrap(), 1e-5);
        let slope = hertz(ellipse).x_derivative().unwrap();
        let field = DisplacementField::new(&slope, 0.3, 0.5).unwrap();
        for at in [[0.2, 0.3], [-0.5, 0.4], [0.1, -1.1], [0.0, 0.0]] {
            let [ahead, behind] = [h, -h].map(|h| displacement(ellipse, [at[0] + h, at[1]]));
            let found = field.at(at);
            for k in 0..2 {
                let slope = (ahead[k] - behind[k]) / (2.0 * h);
                assert!((slope - found[k] / 0.5).abs() < 1e-8, "{at:?}: {found:?} {slope}");
            }
        }
    }
}
