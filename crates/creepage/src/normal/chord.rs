//! Pressure along one chord of a contact area: `a sqrt(1 - s^2) rho(s)`, as [`Band`](super::patch_strip::Band) has it.

use super::lattice::whole;
use crate::numerics::gauss::GAUSS_4;

/// Places in `s` at which a chord knows `rho`: equal steps from -1 to 1, straight lines between.
pub(super) const PLACES: usize = 65;

/// `rho` at the places of a chord.
pub(super) type Density = [f64; PLACES];

/// The place number `i` in `s`.
pub(super) fn place(i: usize) -> f64 {
    2.0 * i as f64 / (PLACES - 1) as f64 - 1.0
}

/// The section of a band at one y.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chord {
    pub(super) y: f64,
    pub(super) half: f64,
    pub(super) centre: f64,
    pub(super) density: Density,
}

impl Chord {
    /// Force per length across (N/m).
    pub(super) fn line_load(&self) -> f64 {
        self.half * self.half * self.load(&arc_nodes([-1.0, 1.0]))[0]
    }

    /// Force per length across over the square of the half length, between the two s of a quadrature,
    /// and the same times `s`.
    pub(super) fn load(&self, nodes: &[(f64, f64)]) -> [f64; 2] {
        nodes.iter().fold([0.0; 2], |[load, by_s], &(s, weight)| {
            let part = weight * ChordPoint::new(s).of(&self.density);
            [load + part, by_s + part * s]
        })
    }

    pub(super) fn scale(&mut self, factor: f64) {
        self.density.iter_mut().for_each(|density| *density *= factor);
    }
}

/// Chord of a band at one y: where it lies, and the pressure along it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ChordProfile {
    /// Middle between the ends (m).
    pub(crate) centre: f64,
    /// Half of its length (m).
    pub(crate) half: f64,
    pub(super) density: Density,
}

impl ChordProfile {
    /// Pressure at `s` (Pa).
    pub(crate) fn pressure(&self, s: f64) -> f64 {
        self.pressure_at(&ChordPoint::new(s))
    }

    /// The same where it is known which places are next.
    pub(crate) fn pressure_at(&self, spot: &ChordPoint) -> f64 {
        self.half * spot.root * spot.of(&self.density)
    }
}

/// A place in `s`, and between which two places of a chord it lies.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ChordPoint {
    pub(crate) s: f64,
    /// `sqrt(1 - s^2)`.
    root: f64,
    low: usize,
    /// How far from the lower to the upper place.
    part: f64,
}

impl ChordPoint {
    pub(crate) fn new(s: f64) -> Self {
        const LAST: f64 = (PLACES - 1) as f64;
        let at = (0.5 * LAST * (s + 1.0)).clamp(0.0, LAST);
        let low = whole(at).min(PLACES - 2);
        Self { s, root: (1.0 - s * s).max(0.0).sqrt(), low, part: at - low as f64 }
    }

    /// `sqrt(1 - s^2)`.
    pub(super) fn root(&self) -> f64 {
        self.root
    }

    /// `rho` here, on straight lines between its places.
    pub(super) fn of(&self, density: &Density) -> f64 {
        (1.0 - self.part) * density[self.low] + self.part * density[self.low + 1]
    }
}

/// Quadrature of `sqrt(1 - s^2) f(s)` between two s, by the angle whose sine is s: places and weights.
pub(super) fn arc_nodes([low, high]: [f64; 2]) -> [(f64, f64); ARC_PARTS * GAUSS_4.len()] {
    let (from, to) = (low.clamp(-1.0, 1.0).asin(), high.clamp(-1.0, 1.0).asin());
    let half = 0.5 * (to - from) / ARC_PARTS as f64;
    std::array::from_fn(|i| {
        let (t, weight) = GAUSS_4[i % GAUSS_4.len()];
        let part = (i / GAUSS_4.len()) as f64;
        let (sin, cos) = (from + half * (2.0 * part + 1.0 + t)).sin_cos();
        (sin, weight * half * cos * cos)
    })
}

/// Parts of the angle with a Gauss rule each.
const ARC_PARTS: usize = 3;
