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
//! The papers were not at hand. Verified by the closed forms without spin for both
//! [traction bounds](TractionBound), by the linear theory in the limit of small creepage, and
//! by independent implementations.
//!
//! # Errors to expect
//! Against the full theory the default is off by 3.5 % of `mu N` in root mean square over 132
//! cases with and without spin, and by 10 % at worst; three flexibilities and the parabolic bound
//! of 1982 by 4.9 % and 13 %. The moment is not that of the linear theory even for small creepage:
//! `C32 = -(3 pi / 32) C22 sqrt(a/b)` and `C33 = 32 / (15 pi) C23 (b/a)^(3/2)`.
//!
//! # Grid
//! `ny` strips of equal width, each cut into `nx` cells over its own length; traction at the
//! cells' centres, so that the first step is half a cell; spin at the middle of each step. Of
//! the usual schemes this one has the least error. The sum of the bound over the cells is not
//! exactly `mu N`, because of the midpoint rule across: it is larger by 1.5 % (elliptic) or
//! 0.65 % (parabolic) at 10 x 10, and by 0.1 % or 0.02 % at 50 x 50.

mod flexibility;
mod grid;
mod march;
mod profile;
mod settings;
mod sums;
mod trace;

use super::dual::{self, Dual, Real};
use super::linear::CreepageCoefficients;
use crate::approximate::strip::strip_slope;
use crate::check::InvalidValue;
use crate::contact::Contact;
use crate::theory::{Evaluated, Jacobian, Solved};
use crate::{Creepage, FieldPoint, Region, Solution, Status, Theory};

pub(crate) use flexibility::{Flexibilities, Slopes};
pub(crate) use grid::{Block, Grid, LANES, Lanes};
pub(crate) use march::{Increments, State, march};
pub(crate) use profile::Profile;
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
}

impl Fastsim {
    /// Prepares the theory; computes the creepage coefficients of the contact.
    ///
    /// # Errors
    /// [`InvalidValue`] unless the ratio `a/b` lies within [`CreepageCoefficients::RATIO_RANGE`],
    /// and the grid has at least one cell and no more than [`Settings::MAX_CELLS`] either way.
    pub fn new(contact: &Contact, settings: Settings) -> Result<Self, InvalidValue> {
        let coefficients = CreepageCoefficients::new(contact)?;
        let (ellipse, poisson) = (contact.ellipse(), contact.poisson());
        let grid = Grid::new(&ellipse, settings.grid, settings.bound.profile(1.0))?;
        let flexibilities =
            Flexibilities::new(&ellipse, strip_slope(&ellipse, poisson), &coefficients)?;
        let (flexibility, bound) = (settings.flexibility, settings.bound);
        Ok(Self { contact: *contact, flexibilities, flexibility, bound, grid })
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
        totals
    }

    fn field_point(&self, slopes: &Slopes<f64>, plain: [f64; 3], position: [f64; 2]) -> FieldPoint {
        let outside = FieldPoint::outside(position);
        let Some(place) = Place::new(&self.contact.ellipse(), position) else { return outside };
        let trace = Trace::new(&self.grid, self.bound.profile(1.0), slopes, &place);
        let [l1, l2, _] = self.flexibilities.effective(self.flexibility, plain);
        let kappa = self.flexibilities.kappa();
        FieldPoint {
            traction: trace.traction.map(|v| v / Profile::HERTZ_PEAK),
            slip: [l1 * trace.lost[0] / kappa, l2 * trace.lost[1] / kappa],
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
    /// creepage that of [`Flexibility::Three`].
    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        let slopes = self.flexibilities.slopes(self.flexibility, dual::variables(creepage));
        Some(self.force::<Dual, 3>(slopes).jacobian())
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Evaluated::boxed(self, creepage)
    }
}
