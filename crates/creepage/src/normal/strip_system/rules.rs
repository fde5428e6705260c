//! Quadrature rules on a strip, with the weights of each polynomial of its pressure.

// So that all is compiled for each kind of processor.
#![allow(clippy::inline_always)]

use std::f64::consts::PI;
use std::sync::LazyLock;

use gauss_quad::GaussLegendre;

use crate::numerics::simd_math::{LANES, Lanes, each};

/// Most polynomials in a strip's pressure.
pub(crate) const MAX_TERMS: usize = 8;
/// Terms of the one-term basis: symmetric pressure, centre fixed.
pub(in crate::normal) const CENTRED: usize = 1;
/// Largest number of terms that need only the smaller quadrature rules.
pub(super) const FEW_TERMS: usize = 4;

/// Points of quadrature on the strip, and weights with each polynomial.
#[derive(Debug, Clone)]
pub(super) struct Block {
    pub(super) s: Lanes,
    pub(super) weights: [Lanes; MAX_TERMS],
}

/// Gauss-Legendre points and weights on (-1, 1).
type Legendre = Vec<(Lanes, Lanes)>;

/// All rules of quadrature.
#[derive(Debug)]
pub(super) struct Rules {
    /// Gauss-Chebyshev rules of the second kind, each from a hyperbolic cosine of the depth of the
    /// singularity on: with few polynomials, and with many.
    chebyshev: Vec<([f64; 2], Vec<Block>)>,
    /// The same for few polynomials, point by point.
    few: Vec<(f64, Vec<Node>)>,
    /// Of rising order.
    legendre: Vec<Legendre>,
}

/// A point of quadrature, and its weight with each polynomial.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub(super) s: f64,
    pub(super) weights: [f64; FEW_TERMS],
}

pub(super) static RULES: LazyLock<Rules> = LazyLock::new(|| Rules {
    chebyshev: [8, 16, 24].map(chebyshev).into(),
    few: [4, 6, 8].map(few).into(),
    legendre: [16, 24, 40, 56].map(legendre).into(),
});

impl Rules {
    /// The smallest rule good for a mean distance from the two ends.
    #[inline(always)]
    pub(super) fn reaching<const T: usize>(&self, mean: f64) -> Option<&[Block]> {
        let many = usize::from(T > FEW_TERMS);
        self.chebyshev.iter().find(|(least, _)| mean >= least[many]).map(|(_, blocks)| &blocks[..])
    }

    /// The points of the smallest rule good for a mean distance from the two ends, where few do.
    #[inline(always)]
    pub(super) fn few(&self, mean: f64) -> Option<&[Node]> {
        self.few.iter().find(|(least, _)| mean >= *least).map(|(_, nodes)| &nodes[..])
    }

    /// A rule good for half a range in the variable `v`.
    #[inline(always)]
    pub(super) fn legendre<const T: usize>(&self, half: f64) -> &[(Lanes, Lanes)] {
        let order = usize::from(half > 3.0) + usize::from(half > 5.0) + usize::from(T > FEW_TERMS);
        self.legendre.get(order).map_or(&[], |points| points)
    }
}

/// Gauss-Chebyshev points of the second kind; the error falls as `exp(-2 count depth)`, and a
/// polynomial of high degree takes as many points as it has waves.
fn chebyshev(count: usize) -> ([f64; 2], Vec<Block>) {
    let block = |first: usize| {
        let nodes: [(f64, [f64; MAX_TERMS]); LANES] =
            std::array::from_fn(|l| node(first + l, count));
        Block { s: each(|l| nodes[l].0), weights: std::array::from_fn(|k| each(|l| nodes[l].1[k])) }
    };
    let least = [0, MAX_TERMS].map(|lost| least(count, lost));
    (least, (0..count).step_by(LANES).map(block).collect())
}

/// The same for few polynomials.
fn few(count: usize) -> (f64, Vec<Node>) {
    let nodes = (0..count).map(|k| {
        let (s, weights) = node(k, count);
        Node { s, weights: std::array::from_fn(|k| weights[k]) }
    });
    (least(count, 0), nodes.collect())
}

/// Point `k` of so many, and its weights.
fn node(k: usize, count: usize) -> (f64, [f64; MAX_TERMS]) {
    let angle = PI * (k + 1) as f64 / (count + 1) as f64;
    let (sin, s) = angle.sin_cos();
    let weight = PI / (count + 1) as f64 * sin * sin;
    (s, polynomials::<MAX_TERMS>(s).map(|u| weight * u))
}

/// The hyperbolic cosine of the depth of the singularity from which on so many points do, some of which
/// waves take.
fn least(count: usize, lost: usize) -> f64 {
    const DIGITS: f64 = 13.0;
    (DIGITS / (2 * count - lost) as f64).cosh()
}

fn legendre(count: usize) -> Legendre {
    let Some(count) = std::num::NonZeroUsize::new(count) else { return Vec::new() };
    let rule = GaussLegendre::new(count);
    let pairs: Vec<(f64, f64)> = rule.as_node_weight_pairs().to_vec();
    pairs.chunks_exact(LANES).map(|c| (each(|l| c[l].0), each(|l| c[l].1))).collect()
}

/// `U_k(s)`.
#[inline(always)]
pub(super) fn polynomials<const T: usize>(s: f64) -> [f64; T] {
    let (mut before, mut last) = (0.0, 1.0);
    std::array::from_fn(|_| {
        let own = last;
        (before, last) = (last, 2.0 * s * last - before);
        own
    })
}
