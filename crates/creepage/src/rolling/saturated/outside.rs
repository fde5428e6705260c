//! The spin pole outside the contact: quadrature over the chords through the pole.
//!
//! In coordinates that make the ellipse the unit circle, `1/kappa` is the pole's distance from
//! the centre. A chord at the angle `delta` from the line to the centre passes the centre at
//! `p = sin(delta)/kappa`. Along it the direction `(c, s)` does not change, so that the integral
//! of the traction is elementary, and what is left is an integral of analytic functions over
//! `|delta| < asin kappa`: no less so for a pole on the edge, or at infinity.

use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;

use crate::ellipse::Ellipse;
use crate::rolling::{Creepage, Force};

#[derive(Debug, Clone)]
pub(super) struct PoleOutside {
    ellipse: Ellipse,
    rule: GaussLegendre,
}

/// One chord through the pole.
struct Chord {
    /// Of the quadrature over `delta/kappa`.
    weight: f64,
    /// `cos delta`.
    cos_delta: f64,
    /// `p`.
    offset: f64,
    /// `1 - p^2`: half the chord's length, squared.
    half_squared: f64,
    /// The chord's direction where the ellipse is the unit circle.
    circle: [f64; 2],
    /// `Q`: length in the ellipse over length in the circle.
    q: f64,
}

/// `|chi|` times the pole's distance from the centre, in coordinates in which the ellipse is the
/// unit circle.
pub(super) fn reach(ellipse: Ellipse, creepage: Creepage) -> f64 {
    (creepage.eta / ellipse.a()).hypot(creepage.xi / ellipse.b())
}

impl PoleOutside {
    // A node count of some hundred, positive by construction.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub(super) fn new(ellipse: Ellipse) -> Self {
        let nodes = 24 + (20.0 / ellipse.g().sqrt()) as usize;
        Self::with_nodes(ellipse, nodes)
    }

    fn with_nodes(ellipse: Ellipse, nodes: usize) -> Self {
        Self { ellipse, rule: GaussLegendre::new(NonZeroUsize::MIN.saturating_add(nodes)) }
    }

    pub(super) fn force(&self, creepage: Creepage) -> Force {
        let (a, b) = (self.ellipse.a(), self.ellipse.b());
        let kappa = kappa(self.ellipse, creepage);
        let mut force = Force::default();
        for chord in self.chords(creepage) {
            let [cos, sin] = chord.circle;
            let share = chord.weight * chord.half_squared;
            force.fx -= share * chord.cos_delta * b * sin / chord.q;
            force.fy += share * chord.cos_delta * a * cos / chord.q;
            // The moment about the middle of the chord, and that of its distance.
            let arm = chord.offset * (b - a) * (b + a) * sin * cos / chord.q;
            force.mz +=
                share * (arm * chord.cos_delta + 0.25 * kappa * chord.q * chord.half_squared);
        }
        let factor = 0.75 * creepage.chi.signum();
        Force { fx: factor * force.fx, fy: factor * force.fy, mz: factor * force.mz }
    }

    /// The sum of `e e^T` over the chords, `e = (c, s, -p ab/Q)` being the derivative of the slip
    /// along the chord.
    pub(super) fn derivative(&self, creepage: Creepage) -> [[f64; 3]; 3] {
        let (a, b) = (self.ellipse.a(), self.ellipse.b());
        // Not below the normal numbers, so that its reciprocal stays finite.
        let factor = 0.75 / reach(self.ellipse, creepage).max(f64::MIN_POSITIVE);
        let mut matrix = [[0.0; 3]; 3];
        for chord in self.chords(creepage) {
            let [cos, sin] = chord.circle;
            let e = [a * cos, b * sin, -chord.offset * a * b].map(|x| x / chord.q);
            let share = factor * chord.weight * chord.half_squared / chord.q;
            for (row, first) in matrix.iter_mut().zip(e) {
                for (entry, second) in row.iter_mut().zip(e) {
                    *entry += share * first * second;
                }
            }
        }
        matrix
    }

    /// The substitution `tan = sqrt(a/b) tan(theta)` for the chord's direction moves the poles of
    /// `1/Q` as far from the path as they go. All angles are taken relative to the line to
    /// the centre, so that a far pole costs no digits.
    fn chords(&self, creepage: Creepage) -> impl Iterator<Item = Chord> {
        let (a, b) = (self.ellipse.a(), self.ellipse.b());
        let stretch = self.ellipse.ratio().sqrt();
        let kappa = kappa(self.ellipse, creepage);
        let to_centre = creepage.chi.signum() / reach(self.ellipse, creepage);
        let (cos0, sin0) = (creepage.eta / a * to_centre, -creepage.xi / b * to_centre);
        let scale0 = cos0.hypot(sin0 / stretch);
        let (theta_cos0, theta_sin0) = (cos0 / scale0, sin0 / (stretch * scale0));
        let end = |sin_delta: f64| {
            let cos_delta = ((1.0 - sin_delta) * (1.0 + sin_delta)).sqrt();
            let (cos, sin) =
                (cos0 * cos_delta - sin0 * sin_delta, sin0 * cos_delta + cos0 * sin_delta);
            (sin_delta / stretch).atan2(cos * cos0 + sin * sin0 / (stretch * stretch))
        };
        let (first, last) = (end(-kappa), end(kappa));
        let (middle, half) = (0.5 * (first + last), 0.5 * (last - first));
        self.rule.iter().map(move |&(x, weight)| {
            let (turn_sin, turn_cos) = (middle + half * x).sin_cos();
            let theta_cos = theta_cos0 * turn_cos - theta_sin0 * turn_sin;
            let theta_sin = theta_sin0 * turn_cos + theta_cos0 * turn_sin;
            let (along, across) = (theta_cos, stretch * theta_sin);
            let norm_squared = along * along + across * across;
            let norm = norm_squared.sqrt();
            let [cos, sin] = [along / norm, across / norm];
            let offset = stretch * turn_sin * scale0 / (norm * kappa);
            Chord {
                weight: weight * half * stretch / (norm_squared * kappa),
                cos_delta: cos * cos0 + sin * sin0,
                offset,
                half_squared: (1.0 - offset) * (1.0 + offset),
                circle: [cos, sin],
                q: (a * a * cos * cos + b * b * sin * sin).sqrt(),
            }
        })
    }
}

/// Not below 1e-30, which stands for a pole at infinity.
fn kappa(ellipse: Ellipse, creepage: Creepage) -> f64 {
    (creepage.chi.abs() / reach(ellipse, creepage)).max(1e-30)
}
