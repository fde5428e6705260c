//! Map of the Hertz ellipse on the coupled area, and the ratio of the pressures: smooth functions of the place.

use std::sync::Arc;

use super::normal::{Normal, PressedArea};
use crate::coulomb::mesh::{Mesh, Strip};
use crate::coulomb::pressure::{Moments, Pressure};
use crate::coulomb::subdivision::SUBCELLS;
use crate::ellipse::Ellipse;
use crate::gap::Cubic;
use crate::normal::strip_system::{self, MAX_TERMS, profile};

/// Least pressure over that of Hertz: polynomials between strips may dip below zero, and an element
/// without any pressure has no traction to find.
const MIN_PRESSURE_RATIO: f64 = 1e-3;

/// A map of the ellipse on the area: lines along `x` are shifted and stretched, each by itself, and
/// moved and spread across. A place is `(s, t)`, `t` from tip to tip and `s` from the trailing to
/// the leading end, both from -1 to 1.
#[derive(Debug, Clone)]
pub(super) struct Shape {
    ellipse: Ellipse,
    middle: f64,
    stretch: f64,
    /// The outermost places at which the rest is known.
    known: [f64; 2],
    /// Half-length over that without friction.
    longer: Cubic,
    /// Middle of a line between its ends.
    centre: Cubic,
    /// Pressure over that of Hertz, in Chebyshev's polynomials, by the strips with and without
    /// friction.
    pressure: [[Cubic; MAX_TERMS]; 2],
}

impl Shape {
    pub(super) fn new(normal: &Normal, pressed: &PressedArea) -> Self {
        let t: Vec<f64> = normal.middles().collect();
        let pairs = || pressed.strips.iter().zip(&normal.frictionless.strips);
        let curve = |values: Vec<f64>| Cubic::new(t.clone(), values);
        let polynomials =
            |of: fn((&strip_system::Strip, &strip_system::Strip)) -> [f64; MAX_TERMS]| {
                let all: Vec<_> = pairs().map(of).collect();
                std::array::from_fn(|k| curve(all.iter().map(|c| c[k]).collect()))
            };
        Self {
            ellipse: normal.ellipse,
            middle: pressed.middle,
            stretch: pressed.stretch,
            known: [t[0], t[t.len() - 1]],
            longer: curve(pairs().map(|(own, other)| own.half / other.half).collect()),
            centre: curve(pairs().map(|(own, other)| own.centre - other.centre).collect()),
            pressure: [
                polynomials(|(own, other)| own.pressure.map(|p| p / other.pressure[0])),
                polynomials(|(_, other)| other.pressure.map(|p| p / other.pressure[0])),
            ],
        }
    }

    fn within(&self, t: f64) -> f64 {
        t.clamp(self.known[0], self.known[1])
    }

    pub(super) fn longer(&self, t: f64) -> f64 {
        self.longer.at(self.within(t))
    }

    fn centre(&self, t: f64) -> f64 {
        self.centre.at(self.within(t))
    }

    /// Where other strips may begin: in this shape, that of `pressed`; `without` friction it was another.
    pub(super) fn start(
        &self,
        normal: &Normal,
        pressed: &PressedArea,
        without: &PressedArea,
    ) -> PressedArea {
        let own = &normal.frictionless;
        if pressed.is(without) {
            return own.clone();
        }
        let strips = own.strips.iter().zip(normal.middles());
        PressedArea {
            strips: strips.map(|(strip, t)| self.strip(strip, t)).collect(),
            approach: own.approach + pressed.approach - without.approach,
            load: own.load * pressed.load / without.load,
            ..*pressed
        }
    }

    /// The pressure of a strip without friction there, changed as this area's.
    fn strip(&self, frictionless: &strip_system::Strip, t: f64) -> strip_system::Strip {
        let t = self.within(t);
        let pressure =
            self.pressure[0].each_ref().map(|curve| curve.at(t) * frictionless.pressure[0]);
        let (centre, half) =
            (frictionless.centre + self.centre(t), frictionless.half * self.longer(t));
        strip_system::Strip { centre, half, pressure, ..*frictionless }
    }

    /// Pressure over that of Hertz at the same place.
    pub(super) fn more(&self, [s, t]: [f64; 2]) -> f64 {
        let t = self.within(t);
        let [own, other] = self.pressure.each_ref().map(|curves| {
            let coefficients = curves.each_ref().map(|curve| curve.at(t));
            profile(&coefficients, s)
        });
        (own / other).max(MIN_PRESSURE_RATIO)
    }

    /// Where a position of the ellipse is moved.
    pub(super) fn moved(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let t = y / self.ellipse.b();
        [self.centre(t) + self.longer(t) * x, self.middle + self.stretch * y]
    }

    /// The place of a position in the area; `None` outside.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let t = self.across(y);
        let half = self.ellipse.a() * ((1.0 - t) * (1.0 + t)).max(0.0).sqrt() * self.longer(t);
        let s = (x - self.centre(t)) / half;
        (s.abs() < 1.0).then_some([s, t])
    }

    /// The place between the tips, from -1 to 1, of a `y`.
    pub(super) fn across(&self, y: f64) -> f64 {
        (y - self.middle) / (self.stretch * self.ellipse.b())
    }

    /// Pressure at a place over Hertz's peak.
    pub(super) fn pressure(&self, [s, t]: [f64; 2]) -> f64 {
        let root = |t: f64| ((1.0 - t) * (1.0 + t)).max(0.0).sqrt();
        root(s) * root(t) * self.more([s, t])
    }

    /// Area over that of the ellipse.
    pub(super) fn area(&self) -> f64 {
        const QUADRATURE_POINTS: u32 = 64;
        let terms = (1..=QUADRATURE_POINTS).map(|k| {
            let angle = std::f64::consts::PI * f64::from(k) / f64::from(QUADRATURE_POINTS + 1);
            let (sin, cos) = angle.sin_cos();
            sin * sin * self.longer(cos)
        });
        2.0 * self.stretch * terms.sum::<f64>() / f64::from(QUADRATURE_POINTS + 1)
    }

    /// The largest pressure over Hertz's.
    pub(super) fn peak(&self) -> f64 {
        const CELLS: i32 = 60;
        let places = (-CELLS..=CELLS).map(|k| f64::from(k) / f64::from(CELLS));
        let all = places.clone().flat_map(|t| places.clone().map(move |s| [s, t]));
        all.map(|place| self.pressure(place)).fold(0.0, f64::max)
    }

    /// The ends along `x` on the middle line, and the tips.
    pub(super) fn extents(&self) -> [[f64; 2]; 2] {
        let (a, b) = (self.ellipse.a() * self.longer(0.0), self.ellipse.b() * self.stretch);
        let (x, y) = (self.centre(0.0), self.middle);
        [[x - a, x + a], [y - b, y + b]]
    }

    /// The point of the edge at an angle from `+x` on the ellipse, over its semi-axes.
    pub(super) fn edge(&self, angle: f64) -> [f64; 2] {
        let (sin, cos) = angle.sin_cos();
        self.moved([self.ellipse.a() * cos, self.ellipse.b() * sin])
    }

    /// The elements of the ellipse, moved.
    pub(super) fn mesh(&self, hertz: &Mesh) -> Mesh {
        Mesh::new(hertz.strips.iter().map(|strip| self.elements(strip)).collect())
    }

    fn elements(&self, hertz: &Strip) -> Strip {
        let borders = hertz.borders().map(|y| y / self.ellipse.b());
        Strip {
            across: hertz.across.map(|y| self.middle + self.stretch * y),
            middle: borders.map(|t| self.centre(t)),
            half_length: std::array::from_fn(|k| self.longer(borders[k]) * hertz.half_length[k]),
            along: Arc::clone(&hertz.along),
            patch: hertz.patch.clone(),
        }
    }

    /// The pressure on the elements that were moved; `load` over that of Hertz is theirs together.
    pub(super) fn pressed(&self, hertz: &Pressure, load: f64) -> Pressure {
        let mut pressure = hertz.clone();
        for element in 0..hertz.bounds.len() {
            self.press(hertz, element, &mut pressure);
        }
        let factor = load / pressure.shares.iter().sum::<f64>();
        pressure.scale(factor, factor);
        pressure
    }

    fn press(&self, hertz: &Pressure, element: usize, to: &mut Pressure) {
        let (mut share, mut at, mut area) = (0.0, [0.0; 2], 0.0);
        for k in 0..SUBCELLS * SUBCELLS {
            let (i, j) = (k / SUBCELLS, k % SUBCELLS);
            let own = hertz.subcells[element][i][j];
            let t = own.centroid[1] / self.ellipse.b();
            let stretch = self.longer(t) * self.stretch;
            let moved = Moments {
                share: own.share * stretch * self.more([own.along, t]),
                centroid: self.moved(own.centroid),
                along: own.along,
            };
            to.subcells[element][i][j] = moved;
            share += moved.share;
            area += own.share * stretch;
            at = [0, 1].map(|k| at[k] + moved.share * moved.centroid[k]);
        }
        to.shares[element] = share;
        to.bounds[element] = hertz.bounds[element] * share / area;
        to.centroids[element] =
            if share > 0.0 { at.map(|at| at / share) } else { hertz.centroids[element] };
    }
}
