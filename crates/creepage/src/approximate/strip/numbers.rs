//! Dimensionless numbers of strip theory, and the solution in one strip.
//!
//! A strip is named by its place across, `t = y/b`; its half-length is `a s`,
//! `s = sqrt(1 - t^2)`. With the plane-strain kernels, the traction
//!
//! `(X, Y) = mu p0 / a * [n S(x) - m S'(x)]`, `S = sqrt((a s)^2 - x^2)`,
//! `S' = sqrt((a s - d)^2 - (x - d)^2)` within its interval next to the leading edge,
//!
//! leaves no slip in that interval when `m D = (X1, E)` and `n - m = (0, psi)`, `D = d/a`; and
//! its magnitude is the bound behind it when `|n| = 1`, which determines `D`.

use super::sliding::unit;
use crate::approximate::dual::Real;

/// The numbers of all strips of one contact at one creepage.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StripNumbers<R> {
    /// `X1` at the middle strip: longitudinal creepage.
    pub(crate) longitudinal: R,
    /// `E`: lateral creepage.
    pub(crate) lateral: R,
    /// `psi`: spin, `|psi| < 1`.
    pub(crate) spin: R,
    /// `X1` falls by `shear * psi` from the middle strip to the edge: `b / (a (1 - nu))`.
    pub(crate) shear: f64,
}

/// A strip: its creepage, how far slip reaches into it, and the directions of its tractions.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Strip<R> {
    /// `(X1, E)`.
    pub(crate) creepage: [R; 2],
    /// `D = d/a`: the slip area has length `2 d`; all of the strip slides when `D >= s`.
    pub(crate) depth: R,
    spin: R,
}

impl<R: Real> StripNumbers<R> {
    /// The strip at `t = y/b`.
    pub(crate) fn strip(&self, t: f64) -> Strip<R> {
        self.strip_at(R::constant(t))
    }

    pub(crate) fn strip_at(&self, t: R) -> Strip<R> {
        let creepage = [self.longitudinal - self.spin * self.shear * t, self.lateral];
        Strip { creepage, depth: self.depth(creepage), spin: self.spin }
    }

    /// `D = (root + E psi) / (1 - psi^2)`, `root^2 = E^2 + (1 - psi^2) X1^2`, in the form that
    /// does not cancel. NaN where there is none, which takes `|psi| > 1`.
    fn depth(&self, [x1, e]: [R; 2]) -> R {
        let free = -(self.spin * self.spin) + 1.0;
        let root = (e * e + free * x1 * x1).sqrt();
        let product = e * self.spin;
        if product.value() > 0.0 {
            (root + product) / free
        } else if root.value() - product.value() == 0.0 {
            R::constant(0.0)
        } else {
            (e * e + x1 * x1) / (root - product)
        }
    }

    /// The strips `[from, to]` in `t` that have an adhesion area, or `None` when all slide.
    ///
    /// `D` is a convex function of `t` and `s` a concave one, so that they are neighbours.
    pub(crate) fn adhering(&self) -> Option<[R; 2]> {
        Some([self.edge(-1.0)?, self.edge(1.0)?])
    }

    /// Where adhesion begins, coming from `start` (-1 or 1): Newton's iteration for
    /// `s^2 - D^2 = 0`. The function is concave, so that from its second step on the iteration
    /// comes from outside and cannot overshoot; where the function falls inwards, it has no zero.
    fn edge(&self, start: f64) -> Option<R> {
        let numbers = self.value();
        // Exact without spin.
        let depth = numbers.strip(start).depth.min(1.0);
        let guess = start * ((1.0 - depth) * (1.0 + depth)).sqrt();
        let mut t = guess;
        let (mut gap, mut slope) = numbers.gap(t);
        if slope * start >= 0.0 {
            t = start;
            (gap, slope) = numbers.gap(t);
        }
        // Halving the error, which is the worst (a double zero), 30 times is enough.
        for _ in 0..30 {
            if slope * start >= 0.0 {
                return None;
            }
            let step = gap / slope;
            t = (t - step).clamp(-1.0, 1.0);
            // Twice as many digits are right after the step that follows.
            if step.abs() <= 1e-8 {
                break;
            }
            (gap, slope) = numbers.gap(t);
            if gap >= 0.0 {
                break;
            }
        }
        // One more step, now with derivatives: the implicit function theorem.
        let (gap, slope) = self.gap(R::constant(t));
        if slope.value() == 0.0 { Some(R::constant(t)) } else { Some(-(gap / slope) + t) }
    }

    fn value(&self) -> StripNumbers<f64> {
        StripNumbers {
            longitudinal: self.longitudinal.value(),
            lateral: self.lateral.value(),
            spin: self.spin.value(),
            shear: self.shear,
        }
    }

    /// `s^2 - D^2` and its derivative by `t`.
    fn gap(&self, t: R) -> (R, R) {
        let strip = self.strip_at(t);
        let [x1, e] = strip.creepage;
        let free = -(self.spin * self.spin) + 1.0;
        let root = (e * e + free * x1 * x1).sqrt();
        let steepness = if root.value() > 0.0 { x1 / root } else { R::constant(0.0) };
        let depth_slope = -(steepness * self.spin * self.shear);
        let gap = -(t * t) + 1.0 - strip.depth * strip.depth;
        (gap, (t + strip.depth * depth_slope) * -2.0)
    }
}

impl<R: Real> Strip<R> {
    /// The strip without its derivatives.
    pub(crate) fn value(&self) -> Strip<f64> {
        Strip {
            creepage: self.creepage.map(R::value),
            depth: self.depth.value(),
            spin: self.spin.value(),
        }
    }

    /// `n`: direction of the traction in the slip area. Of length one; zero where nothing slips.
    pub(crate) fn direction(&self) -> [R; 2] {
        if self.depth.value() > 0.0 {
            let [x1, e] = self.creepage;
            [x1 / self.depth, e / self.depth + self.spin]
        } else {
            [R::constant(0.0); 2]
        }
    }

    /// The strip with the direction `n` that the FaStrip algorithm publishes, along
    /// `(X1, E + psi D / (1 - nu))`: it leaves slip when `psi` and `nu` (`free = 1 - nu`) are not
    /// zero.
    pub(crate) fn with_published_direction(self, free: f64) -> Self {
        if self.depth.value() == 0.0 {
            return self;
        }
        let [x1, e] = self.creepage;
        let turn = self.spin * self.depth;
        let [nx, ny] = unit([x1, e + turn * free.recip()]);
        Self { creepage: [nx * self.depth, ny * self.depth - turn], ..self }
    }

    /// Force and moment of the strip at `t = y/b` of half-length `a s` with `D <= s`, such that
    /// the contact's are `3/4` of the integral over `t`; `a` and `b` in units of `c`.
    pub(crate) fn force(&self, [t, s]: [R; 2], [a, b]: [f64; 2]) -> [R; 3] {
        let [x1, e] = self.creepage;
        let adhering = s - self.depth;
        let sliding_share = s + adhering;
        let fx = x1 * sliding_share;
        let fy = self.spin * s * s + e * sliding_share;
        [fx, fy, -(e * adhering * adhering * a) - t * fx * b]
    }
}

impl Strip<f64> {
    /// Traction at `x = a u` in the strip of half-length `a s`, in units of `mu p0`.
    pub(crate) fn traction(&self, u: f64, s: f64) -> [f64; 2] {
        let bound = ((s - u) * (s + u)).max(0.0).sqrt();
        let adhering = self.inside(u, s).max(0.0).sqrt();
        let [nx, ny] = self.direction();
        if self.depth > 0.0 {
            [nx * (bound - adhering), ny * bound - (ny - self.spin) * adhering]
        } else {
            [0.0, self.spin * bound]
        }
    }

    /// Slip at `x = a u` behind the adhesion area, in units of `2 mu p0 / G`.
    pub(crate) fn slip(&self, u: f64, s: f64, poisson: f64) -> [f64; 2] {
        let distance = (-self.inside(u, s)).max(0.0).sqrt();
        let [nx, ny] = self.direction();
        [(1.0 - poisson) * nx * distance, (ny - self.spin) * distance]
    }

    /// `(s - D)^2 - (u - D)^2`: positive inside the adhesion area, negative behind it.
    pub(crate) fn inside(&self, u: f64, s: f64) -> f64 {
        (s - u) * (s + u - 2.0 * self.depth)
    }
}
