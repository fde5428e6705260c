//! FASTSIM: the elastic bodies replaced by a bed of springs, marched through from the leading
//! to the trailing edge.
//!
//! J. J. Kalker, A fast algorithm for the simplified theory of rolling contact, Vehicle System
//! Dynamics 11 (1982) 1-13. In his simplified theory the surface yields in proportion to the
//! traction at the same point only, `(u, v) = (L1 X, L2 Y)`. The flexibilities `L` are chosen
//! such that forces agree with the linear theory's `C11`, `C22` and `C23`; see [`Flexibility`].
//! In the adhesion area, from zero at the leading edge on,
//!
//! ```math
//! \frac{\partial X}{\partial x} = -\left( \frac{\upsilon_x}{L_1} - \frac{\phi y}{L_3} \right),
//! \qquad
//! \frac{\partial Y}{\partial x} = -\left( \frac{\upsilon_y}{L_2} + \frac{\phi x}{L_3} \right)
//! ```
//!
//! and where a step leads beyond the bound the traction is shortened to it.
//!
//! [Sources](crate::approximate). Verified by the closed forms without spin for both
//! [traction bounds](TractionBound), by the linear theory in the limit of small creepage, and
//! by independent implementations.
//!
//! # Errors to expect
//! Against the full theory the default is off by 3.5 % of `mu N` in root mean square over 132
//! cases with and without spin, and by 10 % at worst; three flexibilities and the parabolic bound
//! of 1982 by 4.9 % and 13 %. The moment is not that of the linear theory even for small creepage:
//! `C32 = -(3 pi / 32) C22 sqrt(a/b)` and `C33 = 32 / (15 pi) C23 (b/a)^(3/2)`.
//!
//! # Friction and layers
//! Where friction depends on the speed of slip ([`Contact::with_rolling_friction`]) it is that of the
//! rigid slip, as in Polach's law of 2005: the springs' own slip would make the traction jump from
//! cell to cell. A [`Layer`](crate::Layer) adds its flexibility to all three, and bounds the traction
//! where it yields.
//!
//! # Surfaces that are not clean and dry
//! [`Settings::reduction`] is Kalker's reduction factor in the form of M. Spiryagin, O. Polach, C. Cole, Creep force
//! modelling for rail traction vehicles based on the Fastsim algorithm, Vehicle System Dynamics 51 (2013)
//! 1765-1783: all three flexibilities are divided by `k = k0 (alpha + (1 - alpha)/(1 + beta eps))`, with Polach's
//! `eps = (pi/4) k0 F / (mu N)`, `F` the linear theory's force by the creepages (spin does not count), and `mu` the
//! friction at the speed of the rigid slip. As there, this friction is that of the whole contact, and a spring slides
//! once it cannot hold it. A layer's own flexibility stays as it is.
//!
//! # Grid
//! `ny` strips of equal width, each cut into `nx` cells over its own length; traction at the
//! cells' centres, so that the first step is half a cell; spin at the middle of each step. Of
//! the usual schemes this one has the least error. The sum of the bound over the cells is not
//! exactly `mu N`, because of the midpoint rule across: it is larger by 1.5 % (elliptic) or
//! 0.65 % (parabolic) at 10 x 10, and by 0.1 % or 0.02 % at 50 x 50. A force beyond `mu N` is brought
//! back to it, with its direction.

mod flexibility;
pub(crate) mod friction_bound;
mod grid;
mod march;
mod settings;
mod sums;
mod trace;

use super::dual::{self, Dual, Real};
use super::linear::CreepageCoefficients;
use crate::approximate::strip::strip_slope;
use crate::check::InvalidValue;
use crate::contact::Contact;
use crate::theory::{Jacobian, Solved, Stateless, differences};
use crate::{Creepage, FieldPoint, Force, Region, Solution, Status, Theory};

use flexibility::Reduction;
pub(crate) use flexibility::{Flexibilities, Slopes};
use friction_bound::{FrictionBound, Step, Walk};
pub(crate) use grid::{Block, Grid, LANES, Lanes, Profile};
pub(crate) use march::{Increments, State, march};
pub use settings::{Flexibility, Settings, TractionBound};
pub(crate) use sums::{Sums, Totals};
pub(crate) use trace::{Place, Trace};

/// FASTSIM, prepared for one ratio of semi-axes, one Poisson's ratio and one grid.
///
/// ```
/// use creepage::approximate::fastsim::{Fastsim, Settings};
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let circle = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
/// let theory = Fastsim::new(&circle, Settings::default())?;
/// let force = theory.solve(Creepage::new(0.9, 0.0, 0.0)?).force;
/// assert!((force.fx - 0.73).abs() < 0.05); // the full theory's value is 0.733
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Fastsim {
    contact: Contact,
    flexibilities: Flexibilities,
    flexibility: Flexibility,
    bound: TractionBound,
    grid: Grid,
    resistance: Option<FrictionBound>,
}

impl Fastsim {
    /// Prepares the theory; interpolates the creepage coefficients of the contact.
    ///
    /// # Errors
    /// [`InvalidValue`] unless the ratio `a/b` lies within [`CreepageCoefficients::RATIO_RANGE`],
    /// the grid has at least one cell and no more than [`Settings::MAX_CELLS`] either way, and the factors of
    /// the reduction are in their range.
    pub fn new(contact: &Contact, settings: Settings) -> Result<Self, InvalidValue> {
        let coefficients = CreepageCoefficients::interpolated(contact)?;
        let (ellipse, poisson) = (contact.ellipse(), contact.poisson());
        let grid = Grid::new(&ellipse, settings.grid, settings.bound.profile(1.0))?;
        let layer = contact.layer().map(|l| l.dimensionless_flexibility(contact.scaling()));
        let reduction = Reduction::new(settings.reduction, contact)?;
        let flexibilities =
            Flexibilities::new(&ellipse, strip_slope(&ellipse, poisson), &coefficients)?
                .with_layer(layer.unwrap_or(0.0))
                .with_reduction(reduction);
        let resistance = FrictionBound::new(contact);
        // Soft springs would stand long between friction of sliding and at rest.
        let eager = resistance.filter(|_| reduction.is_some()).map(FrictionBound::eager);
        Ok(Self {
            contact: contact.clone(),
            flexibilities,
            flexibility: settings.flexibility,
            bound: settings.bound,
            grid,
            resistance: eager.or(resistance),
        })
    }

    /// Force, and its derivative by each of the `K` tangents of `slopes`.
    fn force<R: Real, const K: usize>(&self, slopes: Slopes<R>) -> Totals<K> {
        let mut totals = Totals::zero();
        for block in &self.grid.blocks {
            let mut sums = Sums::zero();
            let increments = Increments::new(block, &[slopes; LANES]);
            march(&self.grid, &increments, |cell, state| sums.add(cell.x, state));
            sums.collect(block, &mut totals);
        }
        totals.within_friction()
    }

    /// Force where the bound depends on the slip.
    fn resisted_force(&self, resistance: &FrictionBound, creepage: Creepage) -> Force {
        let plain = dual::plain(creepage);
        let slopes = self.flexibilities.slopes(self.flexibility, plain);
        let mut force = Force::default();
        let lanes = self.grid.blocks.iter().flat_map(|block| (0..LANES).map(move |l| (block, l)));
        for (block, l) in lanes.filter(|(block, l)| block.weight[*l] > 0.0) {
            let (y, half_length) = (block.y[l], block.half_length[l]);
            let peak = half_length / block.gain[l];
            let share = resistance.share(y);
            // The weight is the cell's area times the peak.
            let weight = block.weight[l] / peak;
            let mut walk = Walk::start();
            for cell in &self.grid.cells {
                let ends = [cell.middle + 0.5 * cell.step, cell.x].map(|x| half_length * x);
                let step = self.step(&slopes, plain, ends, y, share * peak * cell.bound);
                resistance.advance(&mut walk, &step);
                let [p, q] = walk.traction.map(|t| weight * t);
                force.fx += p;
                force.fy += q;
                force.mz += half_length * cell.x * q - y * p;
            }
        }
        let totals = Totals::<0> { force: force.components(), tangents: [] };
        dual::force(totals.within_friction().force)
    }

    fn step(
        &self,
        slopes: &Slopes<f64>,
        creepage: [f64; 3],
        [from, to]: [f64; 2],
        y: f64,
        bound: f64,
    ) -> Step {
        let length = from - to;
        let [l1, l2, _] = self.flexibilities.effective(self.flexibility, creepage);
        let [xi, eta, chi] = creepage;
        Step {
            length,
            growth: slopes.at([0.5 * (from + to), y]).map(|slope| length * slope),
            bound,
            rigid_slip: [xi - chi * y, eta + chi * to],
            flexibility: 0.5 * (l1 + l2) / self.flexibilities.kappa(),
        }
    }

    /// The end of the march to a place, and what its last step lost by length.
    fn trace(&self, slopes: &Slopes<f64>, plain: [f64; 3], place: &Place) -> Trace {
        let profile = self.bound.profile(1.0);
        let Some(resistance) = &self.resistance else {
            return Trace::new(&self.grid, profile, slopes, place);
        };
        let peak = resistance.share(place.y) * profile.peak(place.s);
        let (mut walk, mut length) = (Walk::start(), 1.0);
        for (from, to) in self.grid.walk(place.along) {
            let ends = [from, to].map(|x| place.half_length * x);
            let step = self.step(slopes, plain, ends, place.y, peak * profile.along(to));
            resistance.advance(&mut walk, &step);
            length = step.length;
        }
        Trace { traction: walk.traction, lost: walk.lost.map(|lost| lost / length) }
    }

    fn field_point(&self, slopes: &Slopes<f64>, plain: [f64; 3], position: [f64; 2]) -> FieldPoint {
        let outside = FieldPoint::outside(position);
        let Some(place) = Place::new(&self.contact.ellipse(), position) else { return outside };
        let trace = self.trace(slopes, plain, &place);
        // Spin has springs of its own: the flexibility is that by which the rigid slip as a whole loads them.
        let ([xi, eta, chi], [x, y]) = (plain, position);
        let rigid = (xi - chi * y).hypot(eta + chi * x);
        let [p, q] = slopes.at(position);
        let flexibility = if p.hypot(q) > 0.0 { rigid / p.hypot(q) } else { 0.0 };
        FieldPoint {
            traction: trace.traction.map(|v| v / Profile::HERTZ_PEAK),
            slip: trace.lost.map(|lost| flexibility * lost),
            region: if trace.slides() { Region::Slip } else { Region::Adhesion },
            ..outside
        }
    }
}

impl Theory for Fastsim {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        if let Some(resistance) = &self.resistance {
            let force = self.resisted_force(resistance, creepage);
            return Solution::closed_form(force, Status::Solved);
        }
        let slopes = self.flexibilities.slopes(self.flexibility, dual::plain(creepage));
        let totals = self.force::<f64, 0>(slopes);
        Solution::closed_form(dual::force(totals.force), Status::Solved)
    }

    /// The strip through each position is marched with the grid's `nx` cells, and a last shorter
    /// step that ends at the position.
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let plain = dual::plain(creepage);
        let slopes = self.flexibilities.slopes(self.flexibility, plain);
        positions.iter().map(|&position| self.field_point(&slopes, plain, position)).collect()
    }

    /// Exact derivative of the force (of its discrete value): rows `fx`, `fy`, `mz`; columns
    /// `xi`, `eta`, `chi`.
    ///
    /// At a kink (a cell that just begins to slip; the end of the blending; zero creepage, where
    /// [`Flexibility::One`] has no derivative) it is one of the one-sided values, at zero
    /// creepage that of [`Flexibility::Three`]. Where the bound depends on the slip the force jumps
    /// as cells begin to slide: differences over a hundredth of the creepage are given.
    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        if let Some(resistance) = &self.resistance {
            let force = |creepage| self.resisted_force(resistance, creepage).components();
            return Some(differences(creepage, 0.01, force));
        }
        let slopes = self.flexibilities.slopes(self.flexibility, dual::variables(creepage));
        Some(self.force::<Dual, 3>(slopes).jacobian())
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Stateless::boxed(self, creepage)
    }
}
