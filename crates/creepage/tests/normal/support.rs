//! Gaps in millimetres, as the literature gives them, and a pair of steel bodies.

use creepage::gap::{Gap, Rectangle, Term};
use creepage::{Solid, SolidPair};

pub(crate) const MM: f64 = 1e-3;

/// `G = 82 GPa`, `sigma = 0.28`: the bodies of all reference cases.
pub(crate) fn steel() -> SolidPair {
    let steel = Solid::new(82e9, 0.28).unwrap();
    SolidPair::new(steel, steel)
}

/// A polynomial from powers of x and y and coefficients in millimetres.
pub(crate) fn polynomial(terms: &[(u32, u32, f64)]) -> Gap {
    let terms: Vec<Term> = terms
        .iter()
        .map(|&(x, y, c)| Term {
            x,
            y,
            coefficient: c * MM.powi(1 - i32::try_from(x + y).unwrap()),
        })
        .collect();
    Gap::polynomial(&terms).unwrap()
}

/// A function of millimetres on a rectangle in millimetres.
pub(crate) fn function(
    x: [f64; 2],
    y: [f64; 2],
    h: impl Fn(f64, f64) -> f64 + Send + Sync + 'static,
) -> Gap {
    let domain = Rectangle { x: x.map(|x| x * MM), y: y.map(|y| y * MM) };
    Gap::function(domain, move |x, y| MM * h(x / MM, y / MM)).unwrap()
}

/// A deterministic sequence of numbers in (0, 1) (splitmix64).
pub(crate) struct Sequence(pub(crate) u64);

impl Sequence {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// The number in a variable of the environment, or the usual one.
pub(crate) fn number(variable: &str, usual: u64) -> u64 {
    std::env::var(variable).ok().and_then(|n| n.parse().ok()).unwrap_or(usual)
}
