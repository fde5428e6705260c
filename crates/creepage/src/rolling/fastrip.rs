//! FaStrip: strip theory in the adhesion area, FASTSIM for the direction in the slip area.
//!
//! M. S. Sichani, R. Enblom, M. Berg, An alternative to FASTSIM for tangential solution of the
//! wheel-rail contact, Vehicle System Dynamics 54 (2016) 748-764. The adhesion area and the
//! traction in it are those of strip theory, with creepages and spin scaled so that the linear
//! theory's `C11`, `C22` and `C23` come out; in the slip area the traction is `mu` times the
//! Hertz pressure, in the direction of FASTSIM's.
//!
//! The paper was not at hand: [`Variant::Original`] follows its usual coding. Verified by strip
//! theory, to which both variants reduce for the strips' coefficients, by the linear forces for
//! small creepage, and by independent implementations.
//!
//! # Quadrature
//! The grid is that of [FASTSIM](super::fastsim). The strip's own traction, continued with its
//! direction into the slip area, is integrated along the strip in closed form; cells add only
//! what the turned direction changes, in parts where the border of the slip area crosses them.
//! So the force has no jumps as the border moves over the grid, and its derivative is exact.

use super::dual::{self, Dual, Real};
use super::fastsim::{
    Block, Flexibilities, Flexibility, Grid, Increments, LANES, Lanes, Place, Profile, Settings,
    Slopes, State, Sums, Trace, TractionBound, march,
};
use super::linear::CreepageCoefficients;
use super::strip::{Strip, StripNumbers, strip_slope, unit};
use super::{Creepage, FieldPoint, Region, Solution, Status, Theory};
use crate::Ellipse;
use crate::check::{self, InvalidValue};

/// The original FaStrip, or the one whose defects are mended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Variant {
    /// As published in 2016. FASTSIM runs with three flexibilities and a parabolic bound, that
    /// for `a < b` is raised by `1 + (1 - a/b)^4`; with one flexibility in strips that slip from
    /// the leading edge on, which is decided here by the slopes at the edge and not by the first
    /// cell, whose size would matter. Strip theory is used even beyond its bound in spin, where
    /// errors reach 0.7 of `mu N`; and its traction is not quite such that slip vanishes when
    /// spin and Poisson's ratio are not zero.
    Original,
    /// FASTSIM runs with blended flexibilities and the elliptic bound; beyond the bound in spin
    /// (`|psi| >= 1`) the whole contact slides; and the direction of the strip's traction is the
    /// one for which slip vanishes in the adhesion area for every Poisson's ratio. The most
    /// accurate of the approximate theories: about 2.6 % of `mu N`.
    #[default]
    Modified,
}

/// FaStrip, prepared for one ratio of semi-axes, one Poisson's ratio and one grid.
///
/// ```
/// use creepage::rolling::fastrip::{Fastrip, Variant};
/// use creepage::rolling::{Creepage, Theory, linear::CreepageCoefficients};
/// // Circle, Poisson's ratio 0.28.
/// let coefficients =
///     CreepageCoefficients { c11: 4.2194, c22: 3.7036, c23: 1.484, c32: -1.484, c33: 1.1814 };
/// let theory = Fastrip::new(1.0, 0.28, &coefficients, Variant::Modified, [50, 50])?;
/// let force = theory.solve(Creepage::new(0.9, 0.0, 0.0)?).force;
/// assert!((force.fx - 0.733).abs() < 0.02); // the full theory's value is 0.733
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Fastrip {
    ellipse: Ellipse,
    poisson: f64,
    variant: Variant,
    flexibilities: Flexibilities,
    profile: Profile,
    march: Grid,
    hertz: Grid,
    /// Strip theory's creepages and spin per `xi`, `eta`, `chi`.
    scales: [f64; 3],
}

impl Fastrip {
    /// Prepares the theory for the ratio `a/b` (`a` along the rolling direction), Poisson's
    /// ratio, the linear theory's coefficients that belong to them, and `[nx, ny]` cells.
    ///
    /// # Errors
    /// [`InvalidValue`] as of [`Fastsim::new`](super::fastsim::Fastsim::new).
    pub fn new(
        a_over_b: f64,
        poisson: f64,
        coefficients: &CreepageCoefficients,
        variant: Variant,
        grid: [usize; 2],
    ) -> Result<Self, InvalidValue> {
        use std::f64::consts::PI;
        let ellipse = Ellipse::from_ratio(a_over_b)?;
        check::poisson(poisson)?;
        let slope = strip_slope(&ellipse, poisson);
        let CreepageCoefficients { c11, c22, c23, .. } = *coefficients;
        let profile = match variant {
            Variant::Original => {
                TractionBound::Parabolic.profile(1.0 + (1.0 - a_over_b).max(0.0).powi(4))
            }
            Variant::Modified => TractionBound::Elliptic.profile(1.0),
        };
        Ok(Self {
            flexibilities: Flexibilities::new(&ellipse, slope, coefficients)?,
            profile,
            march: Grid::new(&ellipse, grid, profile)?,
            hertz: Grid::new(&ellipse, grid, Profile::Elliptic)?,
            scales: [4.0 / (PI * PI) * c11, 4.0 / (PI * PI) * c22, 3.0 / PI * c23]
                .map(|v| v * slope),
            ellipse,
            poisson,
            variant,
        })
    }

    /// Exact derivative of the force (of its discrete value): rows `fx`, `fy`, `mz`; columns
    /// `xi`, `eta`, `chi`. At a kink it is one of the one-sided values.
    #[must_use]
    pub fn derivative(&self, creepage: Creepage) -> [[f64; 3]; 3] {
        let (_, tangents) = self.force::<Dual, 3>(dual::variables(creepage));
        [0, 1, 2].map(|i| tangents.map(|column| column[i]))
    }

    fn numbers<R: Real>(&self, [xi, eta, chi]: [R; 3]) -> StripNumbers<R> {
        StripNumbers {
            longitudinal: xi * self.scales[0],
            lateral: eta * self.scales[1],
            spin: chi * self.scales[2],
            shear: self.ellipse.b() / (self.ellipse.a() * (1.0 - self.poisson)),
        }
    }

    /// The strip at `t = y/b`, or `None` where strip theory has no answer: it slides.
    fn strip<R: Real>(&self, numbers: &StripNumbers<R>, t: f64) -> Option<Strip<R>> {
        let strip = numbers.strip(t);
        let psi = numbers.spin.value().abs();
        match self.variant {
            Variant::Modified => (psi < 1.0).then_some(strip),
            Variant::Original => {
                // Near one the published algorithm lets all strips slide.
                let defined = (psi - 1.0).abs() >= 1e-6 && strip.depth.value() >= 0.0;
                defined.then(|| strip.with_published_direction(1.0 - self.poisson))
            }
        }
    }

    /// Slopes of FASTSIM's traction in the strip at `y` of half-length `half_length`.
    fn slopes<R: Real>(&self, slopes: &[Slopes<R>; 2], y: f64, s: f64) -> Slopes<R> {
        let [usual, one] = *slopes;
        let half_length = self.ellipse.a() * s;
        let [x, y] = usual.at([half_length, y]).map(R::value);
        // The parabola's slope at the leading edge; an ellipse's is infinite.
        let slips = x.hypot(y) * half_length > 2.0 * self.profile.peak(s);
        if self.variant == Variant::Original && slips { one } else { usual }
    }

    fn usual_and_one<R: Real>(&self, creepage: [R; 3]) -> [Slopes<R>; 2] {
        let usual = match self.variant {
            Variant::Original => Flexibility::Three,
            Variant::Modified => Flexibility::Blended,
        };
        [usual, Flexibility::One].map(|use_of| self.flexibilities.slopes(use_of, creepage))
    }

    /// Force, and its derivative by each of the `K` tangents of `creepage`.
    fn force<R: Real, const K: usize>(&self, creepage: [R; 3]) -> ([f64; 3], [[f64; 3]; K]) {
        let (mut force, mut tangents) = ([0.0; 3], [[0.0; 3]; K]);
        let slopes = self.usual_and_one(creepage);
        let numbers = self.numbers(creepage);
        let width = 2.0 / self.strips();
        for (block, hertz) in self.march.blocks.iter().zip(&self.hertz.blocks) {
            let rows: [Row<R>; LANES] =
                std::array::from_fn(|l| self.row(&numbers, block.y[l] / self.ellipse.b()));
            for (row, _) in rows.iter().zip(hertz.weight).filter(|(_, weight)| *weight > 0.0) {
                for i in 0..3 {
                    force[i] += 0.75 * width * row.force[i].value();
                    for k in 0..K {
                        tangents[k][i] += 0.75 * width * row.force[i].tangent(k);
                    }
                }
            }
            let increments = Increments::new(
                block,
                &std::array::from_fn(|l| {
                    self.slopes(&slopes, block.y[l], block.half_length[l] / self.ellipse.a())
                }),
            );
            self.turn(&increments, &Turn::new(&rows), hertz, &mut force, &mut tangents);
        }
        (force, tangents)
    }

    fn strips(&self) -> f64 {
        let weighty = |block: &Block| block.weight.iter().filter(|w| **w > 0.0).count();
        self.hertz.blocks.iter().map(weighty).sum::<usize>() as f64
    }

    fn row<R: Real>(&self, numbers: &StripNumbers<R>, t: f64) -> Row<R> {
        let zero = R::constant(0.0);
        let Some(strip) = self.strip(numbers, t) else {
            // The border lies ahead of the leading edge: all slides.
            return Row { force: [zero; 3], direction: [zero; 2], border: R::constant(3.0) };
        };
        let s = ((1.0 - t) * (1.0 + t)).sqrt();
        let axes = [self.ellipse.a(), self.ellipse.b()];
        let direction = strip.direction();
        let force = if strip.depth.value() < s {
            strip.force([R::constant(t), R::constant(s)], axes)
        } else {
            let [fx, fy] = direction.map(|n| n * (s * s));
            [fx, fy, fx * (-t * axes[1])]
        };
        Row { force, direction, border: strip.depth * (2.0 / s) + -1.0 }
    }

    /// Adds what the slip areas' cells change: there the traction has FASTSIM's direction.
    fn turn<const K: usize>(
        &self,
        increments: &Increments<K>,
        turn: &Turn<K>,
        hertz: &Block,
        force: &mut [f64; 3],
        tangents: &mut [[f64; 3]; K],
    ) {
        let mut sums = Sums::default();
        let mut tangent_sums = [Sums::default(); K];
        let mut bounds = self.hertz.cells.iter().map(|cell| cell.bound);
        let cells_per_length = 0.5 * self.hertz.cells.len() as f64;
        march(&self.march, increments, |cell, state| {
            let bound = bounds.next().unwrap_or(0.0);
            let change = turn.at(cell.x, cells_per_length, bound, state);
            sums.add(cell.x, &change.x, &change.y);
            for k in 0..K {
                tangent_sums[k].add(cell.x, &change.dx[k], &change.dy[k]);
            }
        });
        sums.collect(hertz, force);
        for k in 0..K {
            tangent_sums[k].collect(hertz, &mut tangents[k]);
        }
    }

    fn field_point(&self, creepage: [f64; 3], position: [f64; 2]) -> FieldPoint {
        let outside =
            FieldPoint { position, traction: [0.0; 2], slip: [0.0; 2], region: Region::Slip };
        let Some(place) = Place::new(&self.ellipse, position) else { return outside };
        let strip = self.strip(&self.numbers(creepage), place.t);
        let u = place.along * place.s;
        if let Some(strip) = strip.filter(|strip| strip.inside(u, place.s) > 0.0) {
            let traction = strip.traction(u, place.s);
            return FieldPoint { traction, region: Region::Adhesion, ..outside };
        }
        let slopes = self.slopes(&self.usual_and_one(creepage), place.y, place.s);
        let trace = Trace::new(&self.march, self.profile, &slopes, &place);
        let bound = place.s * Profile::Elliptic.along(place.along);
        let traction = unit(trace.traction).map(|n| n * bound);
        FieldPoint { traction, slip: [f64::NAN; 2], ..outside }
    }
}

impl Theory for Fastrip {
    fn solve(&self, creepage: Creepage) -> Solution {
        let (force, []) = self.force::<f64, 0>(dual::plain(creepage));
        Solution { force: dual::force(force), status: Status::Solved }
    }

    /// The theory does not give the slip in the slip area.
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let plain = dual::plain(creepage);
        positions.iter().map(|&position| self.field_point(plain, position)).collect()
    }
}

/// A strip as strip theory has it, continued with the direction of its traction.
#[derive(Debug, Clone, Copy)]
struct Row<R> {
    force: [R; 3],
    direction: [R; 2],
    /// Where its slip area ends, in units of the half-length; -1 is the trailing edge.
    border: R,
}

/// Eight rows, as lanes.
#[derive(Debug)]
struct Turn<const K: usize> {
    direction: [Lanes; 2],
    border: Lanes,
    direction_tangent: [[Lanes; 2]; K],
    border_tangent: [Lanes; K],
}

impl<const K: usize> Turn<K> {
    fn new<R: Real>(rows: &[Row<R>; LANES]) -> Self {
        let [x, y] = [0, 1].map(|i| rows.map(|row| row.direction[i]));
        let border = rows.map(|row| row.border);
        Self {
            direction: [x.map(R::value), y.map(R::value)],
            border: border.map(R::value),
            direction_tangent: std::array::from_fn(|k| [x, y].map(|n| n.map(|v| v.tangent(k)))),
            border_tangent: std::array::from_fn(|k| border.map(|v| v.tangent(k))),
        }
    }

    /// Change of the traction at the cell with centre `x`, in units of the strip's largest
    /// bound, given FASTSIM's traction there.
    #[inline]
    fn at(&self, x: f64, cells_per_length: f64, bound: f64, fastsim: &State<K>) -> State<K> {
        let mut change = State::zero();
        for l in 0..LANES {
            let size = (fastsim.x[l] * fastsim.x[l] + fastsim.y[l] * fastsim.y[l]).sqrt();
            let inverse = if size > 0.0 { 1.0 / size } else { 0.0 };
            let (ux, uy) = (fastsim.x[l] * inverse, fastsim.y[l] * inverse);
            // The part of the cell that lies in the slip area.
            let part = (self.border[l] - x) * cells_per_length + 0.5;
            let split = part > 0.0 && part < 1.0;
            let part = bound * part.clamp(0.0, 1.0);
            let turn = [ux - self.direction[0][l], uy - self.direction[1][l]];
            change.x[l] = part * turn[0];
            change.y[l] = part * turn[1];
            for k in 0..K {
                let (dx, dy) = (fastsim.dx[k][l] * inverse, fastsim.dy[k][l] * inverse);
                let turning = ux * dy - uy * dx;
                let shift = if split { self.border_tangent[k][l] } else { 0.0 };
                let shift = shift * bound * cells_per_length;
                let [nx, ny] = self.direction_tangent[k];
                change.dx[k][l] = shift * turn[0] + part * (-uy * turning - nx[l]);
                change.dy[k][l] = shift * turn[1] + part * (ux * turning - ny[l]);
            }
        }
        change
    }
}
