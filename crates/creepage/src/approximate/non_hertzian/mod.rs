//! Simplified theories on contact areas of any shape: their exact pressure, cut into rows along
//! rolling.
//!
//! Every patch has the elasticity of an ellipse of the same area, whose axes are as the longest
//! row of the patch to its width, and of which the creepages are taken at the centre of pressure:
//!
//! - [`Simplified::Fastsim`] marches through the rows of the true area under `mu` times the true
//!   pressure, with the blended flexibilities of [`Flexibility`](crate::approximate::fastsim::Flexibility),
//!   those of an ellipse for small creepage and one for all where it slides.
//! - [`Simplified::Fastrip`] takes strip theory's adhesion area in every row, by the row's own
//!   length and pressure and scaled to the ellipse's coefficients, and FASTSIM's direction in slip.
//!   Where slip is narrower than a cell in every row, its derivatives are those of the linear theory.
//! - [`Simplified::Linear`] is the linear theory of the ellipse: forces by its coefficients, about
//!   the centre of pressure; tractions by three springs, without a bound.
//! - [`Simplified::Saturated`] slides everywhere, with the true pressure: no elasticity at all.
//!
//! Where patches join or part, their ellipses change at once and the forces jump, by some per cent of
//! `mu N`; the full theory has no jump there.
//!
//! The other theories are tied to Hertz's pressure on one ellipse: `variational` by its polynomials
//! on it, `strip` by a solution of all rows in closed form, `polach`, `shen-hedrick-elkins` and
//! `vermeulen-johnson` by formulas for its resultants.

mod row_force;
mod rows;
mod springs;

use crate::approximate::dual::{self, Dual, Real};
use crate::check::{self, InvalidValue};
use crate::coulomb::{ElementField, Resolve, search};
use crate::normal::NormalContact;
use crate::theory::{
    Constraints, FieldPoint, InverseError, Jacobian, Patch, Region, Solution, Solved, Status,
    Theory,
};
use crate::{Contact, Creepage, Force, Scaling};

use row_force::{Cell, RowCreepage};
use rows::{Row, Rows};
use springs::Springs;

/// Which simplified theory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Simplified {
    /// A bed of springs, with friction.
    Fastsim,
    /// Strip theory in adhesion, FASTSIM's direction in slip.
    Fastrip,
    /// No slip.
    Linear,
    /// Slip everywhere.
    Saturated,
}

/// A simplified theory prepared for a contact of any shape.
///
/// Units, origin and signs are those of [`coulomb::NonHertzian`](crate::coulomb::NonHertzian).
/// Unlike bodies are solved without the slip by the pressure.
///
/// ```
/// use creepage::approximate::non_hertzian::{NonHertzianSimplified, Simplified};
/// use creepage::gap::{Gap, Term};
/// use creepage::normal::{NormalContact, Resolution};
/// use creepage::theory::Solved;
/// use creepage::{SiCreepage, Solid, SolidPair};
/// // A crowned roller: h = x^2/920 + y^4/20000 in millimetres.
/// let term = |x, y, coefficient| Term { x, y, coefficient };
/// let gap = Gap::polynomial(&[term(2, 0, 1e3 / 920.0), term(0, 4, 1e9 / 20_000.0)])?;
/// let steel = Solid::new(82e9, 0.28)?;
/// let pair = SolidPair::new(steel, steel);
/// let contact = NormalContact::under_load(&gap, pair, 40e3, Resolution::STANDARD)?;
/// let theory = NonHertzianSimplified::new(&contact, 0.3, Simplified::Fastsim, [50, 50])?;
/// let creepage = SiCreepage { longitudinal: 1e-3, ..SiCreepage::default() };
/// let solved = theory.solve(theory.scaling().creepage(creepage)?);
/// let force = theory.scaling().si_force(solved.solution().force);
/// assert!(force.longitudinal > 5e3 && force.longitudinal < 12e3); // newtons
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct NonHertzianSimplified {
    contact: Contact,
    kind: Simplified,
    scaling: Scaling,
    poisson: f64,
    rows: Rows,
    springs: Vec<Springs>,
    /// Linear force over `mu N` by creepages of one with coefficients and lengths of one.
    gain: f64,
}

impl NonHertzianSimplified {
    /// Prepares for a solved normal contact and a coefficient of friction, with `[nx, ny]` cells: in
    /// each row along rolling, and rows in the widest area.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive, and both numbers of cells lie
    /// between 2 and 1000.
    pub fn new(
        contact: &NormalContact,
        friction: f64,
        kind: Simplified,
        cells: [usize; 2],
    ) -> Result<Self, InvalidValue> {
        Self::on(&Contact::of_areas(contact.clone(), friction)?, kind, cells)
    }

    /// Prepares for areas of any shape. Friction that differs across the contact bounds every row by its
    /// own coefficient; where it depends on the speed of slip it is that at rest, and a layer is left out.
    ///
    /// # Errors
    /// [`InvalidValue`] as [`NonHertzianSimplified::new`], and for a contact that is Hertz's ellipse.
    pub fn on(of: &Contact, kind: Simplified, cells: [usize; 2]) -> Result<Self, InvalidValue> {
        for (name, count) in [("grid along", cells[0]), ("grid across", cells[1])] {
            check::require((2..=1000).contains(&count), name, count as f64, "from 2 to 1000")?;
        }
        let valid = "at least one: Hertz's ellipse has theories of its own";
        let none = InvalidValue { quantity: "areas of any shape", value: 0.0, valid };
        let contact = of.areas().ok_or(none)?;
        let scaling = of.scaling();
        let (poisson, length) = (contact.pair().poisson(), scaling.length);
        let friction = of.rolling_friction();
        let share = |y: f64| friction.map_or(1.0, |friction| friction.share(y * length));
        let rows = Rows::new(contact, length, cells, share);
        let gain = contact.pair().shear_modulus() * length * length * scaling.slip / scaling.force;
        let load = contact.load().value;
        let springs = contact.patches().iter().enumerate().map(|(index, patch)| {
            let own = rows.rows.iter().filter(|row| row.patch == index);
            Springs::new(patch, own, poisson, [length, gain * load / patch.load()])
        });
        let springs = springs.collect::<Result<_, _>>()?;
        Ok(Self { contact: of.clone(), kind, scaling, poisson, rows, springs, gain })
    }

    /// The units of creepage, force and position.
    #[must_use]
    pub fn scaling(&self) -> Scaling {
        self.scaling
    }

    /// Which theory it is.
    #[must_use]
    pub fn kind(&self) -> Simplified {
        self.kind
    }

    /// Solves for creepage and spin at the origin.
    #[must_use]
    pub fn solve(&self, creepage: Creepage) -> SimplifiedSolved<'_> {
        self.solve_curved(creepage, |_| [0.0; 2])
    }

    /// Solves for creepage and spin, to which `more` adds creepages `[xi, eta]` that vary with `y`,
    /// as [`coulomb::NonHertzian::solve_curved`](crate::coulomb::NonHertzian::solve_curved).
    #[must_use]
    pub fn solve_curved(
        &self,
        creepage: Creepage,
        more: impl Fn(f64) -> [f64; 2],
    ) -> SimplifiedSolved<'_> {
        let more = More {
            rows: self.rows.rows.iter().map(|row| more(row.y)).collect(),
            centres: self.springs.iter().map(|springs| more(springs.centroid[1])).collect(),
        };
        SimplifiedSolved::new(self, creepage, more)
    }

    /// Finds the creepage at which the constraints hold.
    ///
    /// # Errors
    /// [`InverseError`] unless three quantities are prescribed, all finite, and within reach.
    pub fn find(&self, constraints: Constraints) -> Result<SimplifiedSolved<'_>, InverseError> {
        Ok(search(constraints, 1.0, |creepage| self.solve(creepage))?.0)
    }

    /// Force about the origin of coordinates.
    fn force<R: Real>(&self, creepage: [R; 3], more: &More) -> [R; 3] {
        if self.kind == Simplified::Linear {
            return self.linear_force(creepage, more);
        }
        let mut sum = [R::constant(0.0); 3];
        for (index, row) in self.rows.rows.iter().enumerate() {
            let mut part = [R::constant(0.0); 3];
            self.march(index, creepage, more, |i, cell| {
                let [x, y] = cell.traction;
                part = [part[0] + x, part[1] + y, part[2] + y * row.middle(i)];
            });
            part[2] = part[2] - part[0] * row.y;
            sum = [0, 1, 2].map(|i| sum[i] + part[i] * row.weight);
        }
        sum
    }

    /// The linear theory's force about the origin of coordinates.
    fn linear_force<R: Real>(&self, creepage: [R; 3], more: &More) -> [R; 3] {
        let patches = self.springs.iter().enumerate();
        patches.fold([R::constant(0.0); 3], |sum, (patch, springs)| {
            let part = self.linear(springs, self.mean_creepage(creepage, patch, more));
            [0, 1, 2].map(|i| sum[i] + part[i])
        })
    }

    /// Whether every row of strip theory slides by less than one of its cells.
    fn hardly_slides(&self, creepage: Creepage, more: &More) -> bool {
        let creepage = creepage.components();
        self.rows.rows.iter().enumerate().all(|(index, row)| {
            let (springs, at) = self.in_row(index, creepage, more);
            let bounds = &self.rows.bounds[row.cells.clone()];
            row_force::slides_less_than_a_cell(row, bounds, springs, &at, self.poisson)
        })
    }

    /// The springs of a row's patch, and its creepages.
    fn in_row<R: Real>(
        &self,
        index: usize,
        creepage: [R; 3],
        more: &More,
    ) -> (&Springs, RowCreepage<R>) {
        let patch = self.rows.rows[index].patch;
        let springs = &self.springs[patch];
        let centre = springs.at_centre(creepage, more.centres[patch]);
        (springs, RowCreepage { centre, creepage, more: more.rows[index] })
    }

    /// Visits the cells of a row with their tractions.
    fn march<R: Real>(
        &self,
        index: usize,
        creepage: [R; 3],
        more: &More,
        visit: impl FnMut(usize, Cell<R>),
    ) {
        let row = &self.rows.rows[index];
        let (springs, at) = self.in_row(index, creepage, more);
        let bounds = &self.rows.bounds[row.cells.clone()];
        match self.kind {
            Simplified::Fastsim => row_force::fastsim(row, bounds, springs, &at, visit),
            Simplified::Fastrip => {
                row_force::fastrip(row, bounds, springs, &at, self.poisson, visit);
            }
            Simplified::Linear => row_force::linear(row, springs, &at, visit),
            Simplified::Saturated => row_force::saturated(row, bounds, &at, visit),
        }
    }

    /// Creepage at a patch's centre of pressure with what varies along `y` as a mean and a slope,
    /// weighted with the load.
    fn mean_creepage<R: Real>(&self, creepage: [R; 3], patch: usize, more: &More) -> [R; 3] {
        let springs = &self.springs[patch];
        let (mut load, mut sums, mut slopes) = (0.0, [0.0; 2], [0.0; 2]);
        let own = self.rows.rows.iter().zip(&more.rows).filter(|(row, _)| row.patch == patch);
        for (row, [x, y]) in own {
            let part = row.weight * self.rows.bounds[row.cells.clone()].iter().sum::<f64>();
            let off = row.y - springs.centroid[1];
            load += part;
            sums = [sums[0] + part * x, sums[1] + part * y];
            slopes = [slopes[0] + part * off * x, slopes[1] + part * off * off];
        }
        let slope = if slopes[1] > 0.0 { slopes[0] / slopes[1] } else { 0.0 };
        let [xi, eta, chi] = springs.at_centre(creepage, sums.map(|sum| sum / load));
        // A longitudinal creepage that falls with y is as spin.
        [xi, eta, chi + -slope]
    }

    /// Linear theory's force of one patch about the origin, from the creepage at its centre.
    fn linear<R: Real>(&self, springs: &Springs, [xi, eta, chi]: [R; 3]) -> [R; 3] {
        let (c, of) = (springs.radius, &springs.coefficients);
        let force = self.gain * c * c;
        let fx = xi * (force * of.c11);
        let fy = eta * (force * of.c22) + chi * (force * c * of.c23);
        let mz = eta * (force * c * of.c32) + chi * (force * c * c * of.c33);
        let [x, y] = springs.centroid;
        [fx, fy, mz + fy * x - fx * y]
    }
}

/// Creepages `[xi, eta]` that are added to the rigid slip.
#[derive(Debug, Clone, PartialEq)]
struct More {
    rows: Vec<[f64; 2]>,
    centres: Vec<[f64; 2]>,
}

/// A contact of any shape solved by a simplified theory; made by [`NonHertzianSimplified::solve`].
#[derive(Debug, Clone)]
pub struct SimplifiedSolved<'a> {
    theory: &'a NonHertzianSimplified,
    creepage: Creepage,
    more: More,
    solution: Solution,
}

impl<'a> SimplifiedSolved<'a> {
    fn new(theory: &'a NonHertzianSimplified, creepage: Creepage, more: More) -> Self {
        let force = dual::force(theory.force(dual::plain(creepage), &more));
        let solution = Solution::closed_form(force, Status::Solved);
        Self { theory, creepage, more, solution }
    }

    /// The force with its moment about a point.
    #[must_use]
    pub fn force_about(&self, [x, y]: [f64; 2]) -> Force {
        let Force { fx, fy, mz } = self.solution.force;
        Force { fx, fy, mz: mz - x * fy + y * fx }
    }

    /// The cells, row by row, each from the leading end.
    ///
    /// Springs are unloaded where material leaves the contact, in slip that is narrower than a cell: by `fastsim` the
    /// last cell of a row has the power of this too, so that the powers of a row are what its traction takes
    /// from the motion of the bodies.
    #[must_use]
    pub fn elements(&self) -> Vec<ElementField> {
        let theory = self.theory;
        let creepage = dual::plain(self.creepage);
        let mut elements = Vec::with_capacity(theory.rows.bounds.len());
        for (index, row) in theory.rows.rows.iter().enumerate() {
            let (_, at) = theory.in_row(index, creepage, &self.more);
            let mut stored = 0.0;
            theory.march(index, creepage, &self.more, |i, cell| {
                let element = self.element(row, i, cell);
                let rigid = at.slip([row.middle(i), row.y]);
                let taken = cell.traction[0] * rigid[0] + cell.traction[1] * rigid[1];
                stored += row.weight * taken - element.power;
                elements.push(element);
            });
            if let (Simplified::Fastsim, Some(last)) = (theory.kind, elements.last_mut()) {
                last.power += stored.max(0.0);
            }
        }
        elements
    }

    fn element(&self, row: &Row, i: usize, cell: Cell<f64>) -> ElementField {
        let bound = self.theory.rows.bounds[row.cells.start + i];
        let Cell { traction, slip, slides } = cell;
        let power = row.weight * (traction[0] * slip[0] + traction[1] * slip[1]);
        let region = if slides { Region::Slip } else { Region::Adhesion };
        ElementField {
            point: FieldPoint { position: [row.middle(i), row.y], traction, slip, region },
            bound,
            share: row.weight * bound,
            power: if slides { power } else { 0.0 },
            corners: row.corners(i),
            beyond: ElementField::whole(region),
        }
    }

    /// The cell that holds a position.
    fn at(&self, position: [f64; 2]) -> FieldPoint {
        let theory = self.theory;
        let [x, y] = position;
        let inside = |row: &&Row| {
            (row.borders[0]..=row.borders[1]).contains(&y) && (x - row.centre).abs() <= row.half
        };
        let Some(index) = theory.rows.rows.iter().position(|row| inside(&row)) else {
            return FieldPoint::outside(position);
        };
        let row = &theory.rows.rows[index];
        let mut found = FieldPoint::outside(position);
        theory.march(index, dual::plain(self.creepage), &self.more, |i, cell| {
            if (x - row.middle(i)).abs() <= 0.5 * row.step() * (1.0 + 1e-9) {
                found = FieldPoint { position, ..self.element(row, i, cell).point };
            }
        });
        found
    }
}

impl Theory for NonHertzianSimplified {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Box::new(self.solve(creepage))
    }

    fn solved_for(
        &self,
        constraints: Constraints,
    ) -> Option<Result<Box<dyn Solved + '_>, InverseError>> {
        Some(self.find(constraints).map(|found| -> Box<dyn Solved> { Box::new(found) }))
    }
}

impl Resolve for SimplifiedSolved<'_> {
    fn resolve(&self, creepage: Creepage) -> Self {
        Self::new(self.theory, creepage, self.more.clone())
    }
}

impl Solved for SimplifiedSolved<'_> {
    fn creepage(&self) -> Creepage {
        self.creepage
    }

    fn solution(&self) -> Solution {
        self.solution
    }

    /// Exact derivative of the force (of its discrete value), at a kink one of the one-sided ones. Where
    /// `fastrip` slides by less than a cell in every row, no cell tells of it: there the derivative is that of the
    /// linear theory, which it has without slip, high by the slipping share of the rows.
    fn jacobian(&mut self) -> Option<Jacobian> {
        let (theory, more) = (self.theory, &self.more);
        let variables: [Dual; 3] = dual::variables(self.creepage);
        if theory.kind == Simplified::Fastrip && theory.hardly_slides(self.creepage, more) {
            return Some(dual::jacobian(theory.linear_force(variables, more)));
        }
        Some(dual::jacobian(theory.force(variables, more)))
    }

    fn field(&self, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        positions.iter().map(|at| self.at(*at)).collect()
    }

    fn points(&self) -> Option<Vec<FieldPoint>> {
        Some(Self::elements(self).iter().map(|element| element.point).collect())
    }

    fn elements(&self) -> Option<Vec<ElementField>> {
        Some(Self::elements(self))
    }

    fn patches(&self) -> Option<Vec<Patch>> {
        let patch = |element: &ElementField| Patch {
            corners: element.corners,
            traction: element.point.traction,
        };
        Some(Self::elements(self).iter().map(patch).collect())
    }
}
