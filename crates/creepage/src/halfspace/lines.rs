//! The straight lines through a surface point that meet the ellipse, and quadrature over them.
//!
//! Boussinesq-Cerruti's kernels depend on the direction of the line only (2.26). Directions
//! are those of the unit disc, `(x/a, y/b)`; true directions follow by stretching.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::ellipse::Ellipse;

/// One line with its share in the integral over all directions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    /// Unit vector on the disc.
    pub(super) direction: [f64; 2],
    /// Cosine and sine of the true direction.
    pub(super) cosines: [f64; 2],
    /// `ab/Q df`, see [`super::LoadDisplacement`].
    pub(super) weight: f64,
}

/// Quadrature over directions, prepared for one ellipse.
#[derive(Debug, Clone)]
pub(super) struct Lines {
    ellipse: Ellipse,
    rule: Vec<RuleNode>,
}

/// A node of the rule on the interval from 0 to 1.
#[derive(Debug, Clone, Copy)]
struct RuleNode {
    from_left: f64,
    from_right: f64,
    weight: f64,
}

impl Lines {
    pub(super) fn new(ellipse: Ellipse) -> Self {
        Self { ellipse, rule: double_exponential() }
    }

    /// The lines through the disc point `point` inside the ellipse, every line once. The
    /// integrand may change fast near the lines across the radius to the point.
    pub(super) fn through(&self, [x, y]: [f64; 2]) -> impl Iterator<Item = Line> {
        let across = self.angle([-y, x]);
        self.between(if across > 0.0 { across - PI } else { across }, PI, 1.0)
    }

    /// The lines through the disc point `point` outside the ellipse that meet it, directed from
    /// the point to the ellipse.
    pub(super) fn towards(&self, [x, y]: [f64; 2]) -> impl Iterator<Item = Line> {
        let radius = x.hypot(y);
        let half = 1.0_f64.atan2(((radius - 1.0) * (radius + 1.0)).sqrt());
        // Turned by half a turn, if need be, to have the one peak at zero within reach.
        let centre = self.angle([-x, -y]);
        let (turn, sign) =
            if centre.abs() > FRAC_PI_2 { (PI.copysign(centre), -1.0) } else { (0.0, 1.0) };
        self.between(centre - turn - half, 2.0 * half, sign)
    }

    /// The lines in an interval of directions, cut at zero, where the weight has its peak.
    fn between(&self, start: f64, length: f64, sign: f64) -> impl Iterator<Item = Line> {
        let end = start + length;
        let parts = if start < 0.0 && end > 0.0 {
            [[start, 0.0, -start], [0.0, end, end]]
        } else {
            [[start, end, length], [end, end, 0.0]]
        };
        parts.into_iter().filter(|[.., length]| *length > 0.0).flat_map(
            move |[start, end, length]| {
                self.rule.iter().map(move |node| {
                    let angle = start * node.from_right + end * node.from_left;
                    self.line(angle, sign, length * node.weight)
                })
            },
        )
    }

    /// The angle of a disc direction, measured from the minor axis, where `Q` is least.
    fn angle(&self, [x, y]: [f64; 2]) -> f64 {
        if self.minor_along_x() { y.atan2(x) } else { (-x).atan2(y) }
    }

    fn line(&self, angle: f64, sign: f64, share: f64) -> Line {
        let g = self.ellipse.g();
        let (sin, cos) = angle.sin_cos();
        // Q over the major semi-axis.
        let q = sin.hypot(g * cos);
        let (sin_disc, cos_disc) = (sign * sin, sign * cos);
        let (sin_true, cos_true) = (sin_disc / q, g * cos_disc / q);
        let [direction, cosines] = if self.minor_along_x() {
            [[cos_disc, sin_disc], [cos_true, sin_true]]
        } else {
            [[-sin_disc, cos_disc], [-sin_true, cos_true]]
        };
        Line { direction, cosines, weight: share * self.ellipse.minor() / q }
    }

    fn minor_along_x(&self) -> bool {
        self.ellipse.a() <= self.ellipse.b()
    }
}

/// The double exponential rule: it clusters at the ends, and converges geometrically when the
/// integrand is singular at them or has poles close by.
fn double_exponential() -> Vec<RuleNode> {
    // Beyond 3.2 steps the weights are below rounding; the step resolves poles at a distance
    // of 1e-6 from an end to eleven digits, and poles further off to rounding.
    const RULE_STEP: f64 = 1.0 / 40.0;
    const HALF: i32 = 128;
    (-HALF..=HALF)
        .map(|i| {
            let t = RULE_STEP * f64::from(i);
            let growth = (PI * t.sinh()).exp();
            let (from_left, from_right) = (growth / (1.0 + growth), 1.0 / (1.0 + growth));
            let weight = RULE_STEP * PI * t.cosh() * from_left * from_right;
            RuleNode { from_left, from_right, weight }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The integral of ab/Q over half a turn is 2 s K.
    #[test]
    fn all_directions_make_the_complete_integral() {
        for (ratio, tolerance) in
            [(1.0, 1e-14), (0.3, 1e-14), (20.0, 1e-14), (1e-3, 1e-13), (1e6, 1e-11)]
        {
            let ellipse = Ellipse::from_ratio(ratio).unwrap();
            let lines = Lines::new(ellipse);
            for point in [[0.3, 0.2], [-0.5, 0.8], [0.0, 0.4], [0.9, 0.0], [1e-3, -0.3]] {
                let sum: f64 = lines.through(point).map(|line| line.weight).sum();
                let expected = 2.0 * ellipse.minor() * ellipse.integrals().k;
                // As the comment at the step says.
                assert!((sum / expected - 1.0).abs() < tolerance, "{ratio} {point:?} {sum}");
            }
        }
    }
}
