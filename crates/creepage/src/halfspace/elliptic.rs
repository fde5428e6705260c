//! Nodes for integrals over all directions whose integrand has the ellipse's square root.
//!
//! In `u`, with `sin psi = sn(u)`, `d psi / sqrt(1 - e^2 sin^2 psi) = du`, an integrand that is
//! smooth in `psi` has its poles a quarter period off the real axis. The midpoint rule over
//! the period `2 K` then converges geometrically, for slender ellipses too: the number of
//! nodes grows as `log(1/g)`, where in `psi` it would grow as `1/g`.

use std::f64::consts::FRAC_PI_2;

use crate::ellipse::Ellipse;

/// Jacobi's elliptic functions at one node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node {
    /// `sn u = sin psi`.
    pub(super) sn: f64,
    /// `cn u = cos psi`.
    pub(super) cn: f64,
    /// `dn u = sqrt(1 - e^2 sin^2 psi)`.
    pub(super) dn: f64,
}

impl Node {
    /// The direction on the unit disc at `psi` from the major axis, and the true direction:
    /// `Q` of the load-displacement equations is then `dn` times the major semi-axis.
    pub(super) fn directions(&self, ellipse: Ellipse) -> ([f64; 2], [f64; 2]) {
        let (major, minor) = (self.cn / self.dn, ellipse.g() * self.sn / self.dn);
        if ellipse.a() > ellipse.b() {
            ([self.cn, self.sn], [major, minor])
        } else {
            ([self.sn, self.cn], [minor, major])
        }
    }
}

/// The midpoints of `count` equal parts of `0 < u < 2 K`, where `psi` runs from 0 to pi.
pub(super) fn nodes(g: f64, count: usize) -> impl Iterator<Item = Node> {
    let functions = Jacobi::new(g);
    (0..count).map(move |i| functions.at(2.0 * (i as f64 + 0.5) / count as f64))
}

/// How many nodes resolve a trigonometric polynomial in `psi` of degree `order` to rounding.
///
/// `k` is the complete elliptic integral. The rule is measured: rounding is reached with
/// `k (10 + order/2)` nodes, at every ratio and up to order 80.
// A few thousand at most, positive by construction.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(super) fn node_count(k: f64, order: usize) -> usize {
    (k * (12.0 + 0.6 * order as f64)).ceil() as usize
}

/// The arithmetic-geometric mean of 1 and `g`, all steps.
struct Jacobi {
    g: f64,
    steps: Vec<[f64; 2]>,
    mean: f64,
}

impl Jacobi {
    fn new(g: f64) -> Self {
        let (mut a, mut b) = (1.0_f64, g);
        let mut steps = vec![];
        // Every step squares the difference: one that starts below 1e-8 ends in rounding.
        let mut difference = 1.0;
        while difference > 1e-8 {
            difference = (a - b).abs() / a;
            steps.push([a, b]);
            (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
        }
        Self { g, steps, mean: a }
    }

    /// The functions at `u = fraction K`, `0 < fraction < 2`.
    fn at(&self, fraction: f64) -> Node {
        let mirrored = fraction.min(2.0 - fraction);
        let Node { sn, cn, dn } = if mirrored <= 0.5 {
            self.first_half(mirrored)
        } else {
            // Near u = K the small cn keeps its digits as the sn of the complement.
            let Node { sn, cn, dn } = self.first_half(1.0 - mirrored);
            Node { sn: cn / dn, cn: self.g * sn / dn, dn: self.g / dn }
        };
        Node { sn, cn: cn.copysign(1.0 - fraction), dn }
    }

    /// Gauss's transformation, from the circular functions up, for `fraction` up to one half:
    /// it carries `cn/sn`, and adds positive numbers only.
    fn first_half(&self, fraction: f64) -> Node {
        if fraction <= 0.0 {
            return Node { sn: 0.0, cn: 1.0, dn: 1.0 };
        }
        let mut ratio = self.mean / (FRAC_PI_2 * fraction).tan();
        let mut dn = 1.0;
        let mut square = ratio * ratio / self.mean;
        for [a, b] in self.steps.iter().rev() {
            ratio *= dn;
            let next = (b + square) / (a + square);
            square = ratio * ratio / a;
            dn = next;
        }
        let sn = 1.0 / (1.0 + ratio * ratio).sqrt();
        Node { sn, cn: ratio * sn, dn }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::special::CompleteIntegrals;

    #[test]
    fn the_functions_satisfy_their_identities_and_integrate_to_e() {
        for g in [1e-6, 1e-3, 0.05, 0.5, 0.999, 1.0] {
            let integrals = CompleteIntegrals::new(g);
            let count = node_count(integrals.k, 2);
            let mut sum = 0.0;
            for Node { sn, cn, dn } in nodes(g, count) {
                // A few roundings.
                assert!((sn * sn + cn * cn - 1.0).abs() < 2e-15);
                assert!((dn / cn.hypot(g * sn) - 1.0).abs() < 4e-15, "{g} {dn}");
                sum += dn * dn;
            }
            // E is the integral of dn^2 over half the period.
            let e = sum * integrals.k / count as f64;
            assert!((e / integrals.e - 1.0).abs() < 1e-14, "g = {g}: {e} against {}", integrals.e);
        }
    }

    /// sn(K/2) = 1/sqrt(1 + g), and K/2 is the first node of two.
    #[test]
    fn quarter_period() {
        for g in [1e-6_f64, 0.1, 0.7, 1.0] {
            let node = nodes(g, 2).next().unwrap();
            assert!((node.sn * (1.0 + g).sqrt() - 1.0).abs() < 1e-15);
            assert!((node.dn / g.sqrt() - 1.0).abs() < 1e-14);
        }
    }
}
