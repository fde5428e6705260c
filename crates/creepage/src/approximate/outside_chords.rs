//! Chords of the contact ellipse through a point outside it.
//!
//! In coordinates that make the ellipse the unit circle, `1/kappa` is the point's distance from
//! the centre. A chord at the angle `delta` from the line to the centre passes the centre at
//! `p = sin(delta)/kappa`. Along a chord both the kernels of the half-space and the direction
//! of a rotation about the point are constant, which leaves integrals of analytic functions
//! over `|delta| < asin kappa`: no less so for a point on the edge, or at infinity.

use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;

use crate::ellipse::Ellipse;

/// Quadrature over the chords of an ellipse of `c = 1`.
#[derive(Debug, Clone)]
pub(super) struct OutsideChords {
    ellipse: Ellipse,
    rule: GaussLegendre,
}

/// One chord.
pub(super) struct Chord {
    /// Of the quadrature over `delta/kappa`.
    pub(super) weight: f64,
    /// `cos delta`.
    pub(super) cos_delta: f64,
    /// `p`.
    pub(super) offset: f64,
    /// Direction where the ellipse is the unit circle.
    pub(super) circle: [f64; 2],
    /// Direction `(c, s)` in the ellipse.
    pub(super) direction: [f64; 2],
    /// `Q`: length in the ellipse over length in the circle.
    pub(super) q: f64,
    /// `1/Q`.
    pub(super) per_q: f64,
}

impl OutsideChords {
    /// As many nodes as the most slender ellipses need for 1e-11.
    // Some thousand at most, positive by construction.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub(super) fn new(ellipse: Ellipse) -> Self {
        Self::with_nodes(ellipse, 24 + (36.0 / ellipse.g().sqrt()) as usize)
    }

    pub(super) fn with_nodes(ellipse: Ellipse, nodes: usize) -> Self {
        Self { ellipse, rule: GaussLegendre::new(NonZeroUsize::MIN.saturating_add(nodes)) }
    }

    /// The chords through the point from which the centre is seen in the direction
    /// `(cos0, sin0)`, and whose distance from it is `1/kappa`, where the ellipse is a circle.
    ///
    /// The substitution `tan = sqrt(a/b) tan(theta)` for the chord's direction moves the poles of
    /// `1/Q` as far from the path as they go. All angles are taken relative to the line to
    /// the centre, so that a far point costs no digits.
    pub(super) fn through(
        &self,
        [cos0, sin0]: [f64; 2],
        kappa: f64,
    ) -> impl Iterator<Item = Chord> {
        let (a, b) = (self.ellipse.a(), self.ellipse.b());
        let stretch = self.ellipse.ratio().sqrt();
        // theta of the line to the centre.
        let scale0 = cos0.hypot(sin0 / stretch);
        let (theta_cos0, theta_sin0) = (cos0 / scale0, sin0 / (stretch * scale0));
        let [first, last] = [-kappa, kappa].map(|delta| self.turn([cos0, sin0], delta));
        let (middle, half) = (0.5 * (first + last), 0.5 * (last - first));
        let (middle_sin, middle_cos) = middle.sin_cos();
        let last_t = (0.5 * half).tan();
        let (weight_scale, offset_scale) =
            (2.0 * last_t * stretch / kappa, stretch * scale0 / kappa);
        self.rule.iter().map(move |&(x, weight)| {
            // Tangent of half the angle from the middle; sines and cosines times 1 + t^2.
            let t = last_t * x;
            let (sin, cos, secant) = (2.0 * t, (1.0 - t) * (1.0 + t), 1.0 + t * t);
            let turn_sin = middle_sin * cos + middle_cos * sin;
            let turn_cos = middle_cos * cos - middle_sin * sin;
            let along = theta_cos0 * turn_cos - theta_sin0 * turn_sin;
            let across = stretch * (theta_sin0 * turn_cos + theta_cos0 * turn_sin);
            let per_norm = (along * along + across * across).sqrt().recip();
            let [cos, sin] = [along * per_norm, across * per_norm];
            let q = (a * a * cos * cos + b * b * sin * sin).sqrt();
            let per_q = q.recip();
            Chord {
                weight: weight * weight_scale * secant * per_norm * per_norm,
                cos_delta: cos * cos0 + sin * sin0,
                offset: turn_sin * offset_scale * per_norm,
                circle: [cos, sin],
                direction: [a * cos * per_q, b * sin * per_q],
                q,
                per_q,
            }
        })
    }

    /// By how much `theta` differs from that of the line to the centre, for the chord at the angle
    /// `delta` from it.
    fn turn(&self, [cos0, sin0]: [f64; 2], sin_delta: f64) -> f64 {
        let stretch = self.ellipse.ratio().sqrt();
        let cos_delta = ((1.0 - sin_delta) * (1.0 + sin_delta)).sqrt();
        let cos = cos0 * cos_delta - sin0 * sin_delta;
        let sin = sin0 * cos_delta + cos0 * sin_delta;
        (sin_delta / stretch).atan2(cos * cos0 + sin * sin0 / (stretch * stretch))
    }
}

impl Chord {
    /// Half the length in the circle, squared.
    pub(super) fn half_squared(&self) -> f64 {
        (1.0 - self.offset) * (1.0 + self.offset)
    }
}
