//! The full theory of steady rolling: Coulomb's law holds at every element, no shape of the
//! traction is assumed.
//!
//! Elements fit the ellipse, the slip of each is an upstream difference of displacements of
//! second order, friction is a projection, and Newton solves it, strip by strip at first, then in
//! all strips at once. Every force and the frictional power come from two grids: their difference
//! gives the extrapolated value and its error bar. Forces are smooth in creepage and spin: the
//! projection's corner, where an element changes between adhesion and slip, is rounded over a width
//! that shrinks with the elements. Where strong spin turns the slip about within an element, adhesion
//! gives way to it, so that no element holds the pole of the spin.
//!
//! Between elements the border of adhesion is found by how traction and slip near it, and fields
//! follow it; an island of adhesion narrower than two elements is seen as one or not at all.
//!
//! With `P` the projection on the disc whose radius is the traction bound, Coulomb's law for a
//! traction `p` and slip `s` is one equation, for any `r > 0`:
//!
//! ```math
//! p = P(p + r s)
//! ```

mod automatic;
pub(crate) mod boussinesq_cerruti;
mod coupled;
mod cylinders;
mod dissipation;
pub(crate) mod extrapolation;
mod field_interpolation;
pub(crate) mod forcing;
mod friction;
pub(crate) mod friction_bound;
pub(crate) mod grid;
pub(crate) mod influence;
mod inverse;
pub(crate) mod mesh;
mod non_hertzian;
pub(crate) mod patch_mesh;
pub(crate) mod pressure;
mod product;
pub(crate) mod quadrature;
pub(crate) mod resolution;
mod solution;
pub(crate) mod solver;
mod spin_pole;
pub(crate) mod stencil;
mod stick_slip_boundary;
pub(crate) mod subdivision;
mod workspace;

pub use crate::theory::{Constraints, InverseError};
pub use automatic::{Automatic, NonHertzianAutomatic};
pub use coupled::{Coupled, CoupledSolved, GrossSliding, Prescribed, SlidingError};
pub use cylinders::{Cylinders, CylindersSolved};
pub use extrapolation::hidden_by_border;
pub use field_interpolation::{ElementField, adhesion_share};
pub(crate) use forcing::hertz_slip;
pub use inverse::InverseSolution;
pub use non_hertzian::{NonHertzian, NonHertzianSolved, TangentialWarmStart};
pub use resolution::Resolution;
pub use solution::ExactSolved;

pub(crate) use inverse::{Resolve, search};

use crate::check::{self, InvalidValue};
use crate::theory::Solved;
use crate::{Contact, Creepage, Ellipse, Solution, Theory};
use grid::Grid;
use workspace::Pool;

/// The full theory, prepared for one contact.
///
/// Error of `(fx, fy)` in parts of `mu N` beyond the uncertainty of the 132 reference cases of
/// `creepage-study`, and the cost of a case and of preparation on one core:
///
/// | resolution | median | rms | worst | case | preparation |
/// |---|---|---|---|---|---|
/// | [`Resolution::FAST`] | 0.01 % | 0.08 % | 0.28 % | 0.3 ms | 0.3 ms |
/// | [`Resolution::STANDARD`] | 0.00 % | 0.02 % | 0.13 % | 0.9 ms | 0.9 ms |
/// | [`Resolution::FINE`] | 0.00 % | 0.01 % | 0.04 % | 6 ms | 6 ms |
///
/// The worst at the fine resolution are at `a/b = 5` and `chi = 2`, where grids of up to 182 x 42 and
/// 134 x 74 elements agree with each other, and the reference is off by 0.12 %, beyond its uncertainty.
///
/// Over 1,219 random cases (`a/b` .15 to 6, creepage to 3, spin to 8), against 96 x 80 elements, `fx`, `fy`
/// and `mz` err by 0.14, 0.05 and 0.012 % rms at the three resolutions, 0.7, 0.36 and 0.09 % at worst, and
/// 95 to 97 % are inside their error bars, which are three to four times the error in the median. Between
/// unlike bodies (600 cases, `kappa/mu` to 3) it is 0.14, 0.05 and 0.017 %, 0.8, 0.32 and 0.15 %, 96 to 97 %, and
/// five to six times.
///
/// Over 60 random cases of like bodies the border of adhesion errs along `x` by 0.010, 0.005 and 0.003 `c` in
/// the median, and nine times in ten by less than 0.043, 0.024 and 0.010 `c` (`bench exact -- border 60`);
/// borders of 96 x 80 elements differ by 0.010 `c` rms from those of 109 x 91, nine times in ten by less than
/// 0.002 (`border 24 109 91`).
///
/// Errors are largest with a pole of strong spin inside the contact, and at the fine resolution in `fy` of long
/// contacts that nearly adhere under slight spin, where they fall more slowly. At the fine resolution the
/// limit of small creepage is met for `a/b` from 0.1 to 10 to 0.1 % in every coefficient, but 0.15 % in
/// `C33`; full sliding is met to 0.02 % of `mu N`. Beyond `a/b = 10` small creepage is resolved less well:
/// over 120 random cases of like bodies (`a/b` 10 to 60, slight creepage to full sliding) against 52 x 44
/// elements forces err by 0.37, 0.32 and 0.08 % rms, 3.0, 1.6 and 0.6 % at worst; 99, 95 and 99 % are inside
/// their error bars.
///
/// ```
/// use creepage::coulomb::{Exact, Resolution};
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let contact = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
/// let theory = Exact::new(&contact, Resolution::FAST)?;
/// let solution = theory.solve(Creepage::new(0.9, 0.0, 0.0)?);
/// let error = solution.error.map_or(f64::NAN, |error| error.fx);
/// assert!((solution.force.fx - 0.733).abs() < error + 0.002);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Exact {
    contact: Contact,
    /// The coarser grid, then the finer with twice its elements along and across.
    grids: [Grid; 2],
    /// What is added to the slip of each grid's elements; empty where nothing is.
    added: [Vec<[f64; 2]>; 2],
    pool: Pool,
}

impl Exact {
    /// Smallest and largest `a/b`: beyond, strip theory or a line contact is the better model.
    pub const RATIO_RANGE: [f64; 2] = [1.0 / 64.0, 64.0];

    /// Prepares the theory for a contact. Between dissimilar bodies the pressure adds to the slip
    /// (6.4).
    ///
    /// Contact area and pressure stay those of Hertz: what the tangential traction adds to the
    /// normal displacement (2.15c) is neglected. Without creepage there is a force then, and it
    /// makes a difference whether the upper body pulls or brakes. For large creepage the pressure's
    /// slip does not matter.
    ///
    /// Where friction depends on the speed of slip ([`Contact::with_rolling_friction`]) or a layer
    /// yields, the bound of each element follows its slip, and the solution is the one that is reached
    /// from friction at rest; [`Status::SeveralSolutions`](crate::Status::SeveralSolutions) says where
    /// kinetic friction leads to another one.
    ///
    /// ```
    /// use creepage::coulomb::{Exact, Resolution};
    /// use creepage::{Contact, Creepage, Ellipse, Theory};
    /// // Rubber with a hard body below, as a ball on a plate: kappa < 0 unless incompressible.
    /// let contact = Contact::new(Ellipse::from_ratio(1.0)?, 0.45)?.with_kappa_over_mu(-0.05)?;
    /// let solution = Exact::new(&contact, Resolution::FAST)?.solve(Creepage::default());
    /// assert!(solution.force.fx > 0.0 && solution.force.fy.abs() < 1e-9);
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidValue`] unless the ratio `a/b` lies within [`Exact::RATIO_RANGE`], and there are at most
    /// 12,000 elements on this ellipse.
    pub fn new(contact: &Contact, resolution: Resolution) -> Result<Self, InvalidValue> {
        check::ratio(contact.hertz_ellipse()?.ratio(), Self::RATIO_RANGE, "between 1/64 and 64")?;
        let [along, across] = resolution.elements(contact);
        let (all, valid) = (along * across, "at most 12000 on this ellipse: give fewer");
        check::require(all <= Resolution::MOST_ELEMENTS, "elements", all as f64, valid)?;
        Ok(Self::prepare(contact, resolution))
    }

    /// [`Exact::new`] for a contact that has been checked.
    fn prepare(contact: &Contact, resolution: Resolution) -> Self {
        let (ellipse, poisson) = (contact.ellipse(), contact.poisson());
        let [along, across] = resolution.coarse_steady(ellipse.ratio(), contact.kappa_over_mu());
        let grids = Grid::pair(|k| {
            let mesh = mesh::Mesh::ellipse(ellipse, k * along, k * across);
            let grid =
                Grid::hertz(ellipse, poisson, contact.kappa_over_mu(), mesh).with_spin_compliance();
            let (friction, layer) = (contact.rolling_friction(), contact.layer());
            let is_long = ellipse.ratio() > mesh::LONG;
            Grid { is_long, ..grid.with_resistance(friction, layer, contact.scaling()) }
        });
        let added = grids.each_ref().map(|grid| match contact.added_slip() {
            Some(_) => grid.places.iter().map(|place| contact.slip_beside(*place)).collect(),
            None => Vec::new(),
        });
        Self { contact: contact.clone(), grids, added, pool: Pool::default() }
    }

    /// Elements along and across on the finer grid.
    #[must_use]
    pub fn elements(&self) -> [usize; 2] {
        let strips = &self.grids[1].mesh.strips;
        [strips.first().map_or(0, mesh::Strip::len), strips.len()]
    }

    /// Solves, and keeps what was solved.
    ///
    /// ```
    /// use creepage::coulomb::{Exact, Resolution};
    /// use creepage::theory::Solved;
    /// use creepage::{Contact, Creepage, Ellipse, Region};
    /// let contact = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
    /// let theory = Exact::new(&contact, Resolution::FAST)?;
    /// let solved = theory.solve_contact(Creepage::new(0.3, 0.0, 0.0)?);
    /// let sliding = solved.elements().iter().filter(|e| e.point.region == Region::Slip).count();
    /// assert!(sliding > 0 && solved.power() > 0.0);
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    #[must_use]
    pub fn solve_contact(&self, creepage: Creepage) -> ExactSolved<'_> {
        ExactSolved::new(self, creepage)
    }

    /// Solves along a curve of creepages, each from the one before.
    #[must_use]
    pub fn curve(&self, creepages: &[Creepage]) -> Vec<Solution> {
        let mut solved: Option<ExactSolved> = None;
        let mut next = |creepage: &Creepage| {
            let here = match solved.take() {
                Some(last) => last.next(*creepage),
                None => self.solve_contact(*creepage),
            };
            solved.insert(here).solution()
        };
        creepages.iter().map(&mut next).collect()
    }
}

/// The quadrilaterals of the fine resolution that fill an ellipse, in its unit of length.
pub(crate) fn quadrilaterals(ellipse: Ellipse) -> impl Iterator<Item = [[f64; 2]; 4]> {
    let [along, strips] = Resolution::FINE.coarse(ellipse.ratio());
    let sides = mesh::StripGrading::NARROW;
    let mesh = mesh::Mesh::with_sides(ellipse, 2 * along, 2 * strips, sides);
    let strips = mesh.strips.into_iter();
    strips.flat_map(|strip| (0..strip.len()).map(move |i| strip.corners(i)))
}

impl Theory for Exact {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Box::new(self.solve_contact(creepage))
    }

    fn solved_for(
        &self,
        constraints: Constraints,
    ) -> Option<Result<Box<dyn Solved + '_>, InverseError>> {
        Some(self.find(constraints).map(|found| -> Box<dyn Solved> { Box::new(found.solved) }))
    }
}
