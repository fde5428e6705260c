//! Full theory on contact areas of any shape: extrapolation from two grids, with warm starts.

use std::sync::Arc;

use super::dissipation::{self, Unresolved};
use super::extrapolation::{Extrapolation, error_bar, error_bar_of_one_area, extrapolate};
use super::field_interpolation::{ElementField, FieldInterpolation};
use super::grid::Grid;
use super::inverse::{Resolve, search};
use super::mesh::Strip;
use super::patch_mesh::{Bands, Frame};
use super::resolution::Resolution;
use super::solution::{error_bars_and_elements, power_of, quarters};
use super::workspace::{Pool, Workspace};
use super::{Constraints, InverseError};
use crate::added_slip::AddedSlip;
use crate::check::InvalidValue;
use crate::contact::Contact;
use crate::friction_law::RollingFriction;
use crate::layer::Layer;
use crate::normal::NormalContact;
use crate::theory::field::mean;
use crate::theory::{
    Diagnostic, FieldPoint, Jacobian, Patch, Solution, Solved, Status, Theory, differences,
};
use crate::{Creepage, Force, Scaling};

/// Change of the creepage to differentiate by, where friction depends on the slip.
const CREEPAGE_STEP: f64 = 1e-4;

/// The full theory of steady rolling, prepared for a contact of any shape: one or more areas, all
/// in one half-space.
///
/// Creepages, forces and positions are in the units of [`NonHertzian::scaling`]; the origin of
/// coordinates, of the spin and of the moment is that of the gap, and the rolling direction its
/// `x`. Like bodies: between dissimilar ones the slip by the pressure (6.4) is neglected.
///
/// ```
/// use creepage::coulomb::{NonHertzian, Resolution};
/// use creepage::gap::{Gap, Term};
/// use creepage::normal::{self, NormalContact};
/// use creepage::theory::Solved;
/// use creepage::{SiCreepage, Solid, SolidPair};
/// // A crowned roller: h = x^2/920 + y^4/20000 in millimetres.
/// let term = |x, y, coefficient| Term { x, y, coefficient };
/// let gap = Gap::polynomial(&[term(2, 0, 1e3 / 920.0), term(0, 4, 1e9 / 20_000.0)])?;
/// let steel = Solid::new(82e9, 0.28)?;
/// let pair = SolidPair::new(steel, steel);
/// let contact = NormalContact::under_load(&gap, pair, 40e3, normal::Resolution::STANDARD)?;
/// let theory = NonHertzian::new(&contact, 0.3, Resolution::FAST)?;
/// let creepage = SiCreepage { longitudinal: 1e-3, ..SiCreepage::default() };
/// let solved = theory.solve(theory.scaling().creepage(creepage)?);
/// let force = theory.scaling().si_force(solved.solution().force);
/// assert!(force.longitudinal > 5e3 && force.longitudinal < 12e3); // newtons
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct NonHertzian {
    contact: Contact,
    areas: Arc<NormalContact>,
    frame: Frame,
    scaling: Scaling,
    /// In the frame: its origin is the centre of pressure, for accuracy.
    grids: Arc<[Grid; 2]>,
    /// The same under constant friction without a layer: they depend on no coefficient of friction.
    bare: Arc<[Grid; 2]>,
    pool: Pool,
}

impl NonHertzian {
    /// Prepares for a solved normal contact and a coefficient of friction.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive.
    pub fn new(
        contact: &NormalContact,
        friction: f64,
        resolution: Resolution,
    ) -> Result<Self, InvalidValue> {
        Self::on(&Contact::of_areas(contact.clone(), friction)?, resolution)
    }

    /// Prepares for areas of any shape, with the law of friction and the layer of the contact.
    ///
    /// # Errors
    /// [`InvalidValue`] for a contact that is Hertz's ellipse: [`Exact`](super::Exact) takes that.
    pub fn on(contact: &Contact, resolution: Resolution) -> Result<Self, InvalidValue> {
        let valid = "at least one: Hertz's ellipse has a theory of its own";
        let none = InvalidValue { quantity: "areas of any shape", value: 0.0, valid };
        let areas = Arc::clone(contact.areas().ok_or(none)?);
        let scaling = contact.scaling();
        let frame = Frame { origin: areas.centroid(), length: scaling.length };
        let bands = Bands::new(&areas, frame, resolution);
        let grids = Arc::new(Grid::pair(|times| bands.grid(times)));
        let (bare, pool) = (Arc::clone(&grids), Pool::default());
        let (law, layer) = (contact.rolling_friction(), contact.layer());
        let theory = Self { contact: contact.clone(), areas, frame, scaling, grids, bare, pool };
        Ok(theory.with_resistance(law, layer))
    }

    /// The same with friction that depends on the speed of slip or on the place, whose largest value is
    /// the friction given, and with a layer between the bodies.
    #[must_use]
    pub fn with_resistance(
        mut self,
        friction: Option<RollingFriction>,
        layer: Option<Layer>,
    ) -> Self {
        self.contact = self.contact.with_resistance(friction, layer);
        let (scaling, [_, y]) = (self.scaling, self.frame.origin);
        let friction = friction.map(|friction| friction.seen_from(y));
        if friction.is_some() || layer.is_some() {
            let own = |grid: Grid| grid.with_resistance(friction, layer, scaling);
            self.grids = Arc::new(self.bare.as_ref().clone().map(own));
        }
        self
    }

    /// The same with a rigid slip beside creepage and spin, as of [`Contact::with_added_slip`].
    #[must_use]
    pub fn with_added_slip(mut self, slip: Arc<AddedSlip>) -> Self {
        self.contact = self.contact.with_added_slip(slip);
        self
    }

    /// The same contact with another, constant coefficient of friction and without a layer, as
    /// [`NonHertzian::new`] prepares it, at no cost: what is prepared depends on the areas alone.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive.
    pub fn with_friction(&self, friction: f64) -> Result<Self, InvalidValue> {
        let contact = self.contact.with_friction_on_areas(friction)?;
        let scaling = contact.scaling();
        Ok(Self { contact, scaling, grids: Arc::clone(&self.bare), ..self.clone() })
    }

    /// The units of creepage, force and position.
    #[must_use]
    pub fn scaling(&self) -> Scaling {
        self.scaling
    }

    /// Elements on the finer grid.
    #[must_use]
    pub fn elements(&self) -> usize {
        self.grids[1].mesh.len()
    }

    /// Solves for creepage and spin.
    #[must_use]
    pub fn solve(&self, creepage: Creepage) -> NonHertzianSolved<'_> {
        self.solve_curved(creepage, |_| [0.0; 2])
    }

    /// Solves for creepage and spin, to which `more` adds creepages `[xi, eta]` that vary with the
    /// position `[x, y]`: on curved contact areas neither the rolling radius nor the direction of
    /// the tangent plane is the same everywhere.
    #[must_use]
    pub fn solve_curved(
        &self,
        creepage: Creepage,
        more: impl Fn([f64; 2]) -> [f64; 2],
    ) -> NonHertzianSolved<'_> {
        NonHertzianSolved::new(self, creepage, self.slips(more))
    }

    /// As [`NonHertzian::solve_curved`] from the tractions of a contact close by: quicker, and the same to
    /// the solver's tolerance. Where the contact has other elements than that one, or friction depends
    /// on the slip so that there may be several solutions, it starts from nothing.
    #[must_use]
    pub fn solve_near(
        &self,
        creepage: Creepage,
        more: impl Fn([f64; 2]) -> [f64; 2],
        near: &TangentialWarmStart,
    ) -> NonHertzianSolved<'_> {
        if self.grids[0].resistance.is_some() || near.elements != self.strips() {
            return self.solve_curved(creepage, more);
        }
        let (mut workspace, more) = (self.pool.take(&self.grids), self.slips(more));
        workspace.start_from(&near.tractions);
        let mut answer = self.answer(&mut workspace, true, creepage, &more);
        if answer.solution.status == Status::NotConverged {
            answer = self.answer(&mut workspace, false, creepage, &more);
        }
        NonHertzianSolved { theory: self, workspace, creepage, more, answer }
    }

    /// Elements in each strip of both grids.
    fn strips(&self) -> [Vec<usize>; 2] {
        [0, 1].map(|k: usize| self.grids[k].mesh.strips.iter().map(Strip::len).collect())
    }

    /// What is added to the creepage at the places of each grid, the contact's own slip among it.
    fn slips(&self, more: impl Fn([f64; 2]) -> [f64; 2]) -> [Vec<[f64; 2]>; 2] {
        let at = |place: &[f64; 2]| {
            let place = self.outward(*place);
            let ([x, y], [own_x, own_y]) = (more(place), self.contact.slip_beside(place));
            [x + own_x, y + own_y]
        };
        [0, 1].map(|k: usize| self.grids[k].places.iter().map(at).collect())
    }

    /// Solves from nothing or from the tractions of the last solution.
    fn answer(
        &self,
        workspace: &mut Workspace,
        warm: bool,
        creepage: Creepage,
        more: &[Vec<[f64; 2]>; 2],
    ) -> Answer {
        let (grids, inward) = (&self.grids, self.inward(creepage));
        workspace.solve(grids, warm, |k, forcing| {
            grids[k].set_forcing(inward, 0.0, forcing);
            forcing.add(&more[k]);
        });
        let [coarse, fine] = workspace.sums(grids, 0.0);
        let forces = [coarse.force, fine.force];
        let force = self.moved(Extrapolation::PLAIN.force(forces));
        let error = match self.areas.patches() {
            [_] => error_bar_of_one_area(forces, self.elements()),
            // Two areas in one plane may stick and slide apart from each other.
            _ => error_bar(forces, self.elements()),
        };
        let mut solution = workspace.solution(force, self.moved_error(error));
        if solution.status == Status::Solved && workspace.has_another(grids, 0.0) {
            solution.status = Status::SeveralSolutions;
        }
        let states = workspace.states();
        let [on_coarse, on_fine] =
            [0, 1].map(|k: usize| states[k].work(&grids[k], forces[k], &more[k]));
        let power = power_of(force, creepage) + extrapolate(on_coarse, on_fine);
        let work = power_of(fine.force, inward) + on_fine;
        let dissipation = dissipation::dissipation(power, &fine, work);
        Answer { solution, power, dissipation, by_elements: fine.dissipation }
    }

    /// Finds the creepage at which the constraints hold, as [`Exact::find`](super::Exact::find).
    ///
    /// # Errors
    /// [`InverseError`] unless three quantities are prescribed, all finite, and within reach.
    pub fn find(&self, constraints: Constraints) -> Result<NonHertzianSolved<'_>, InverseError> {
        Ok(search(constraints, 1.0, |creepage| self.solve(creepage))?.0)
    }

    /// The frame's origin.
    fn origin(&self) -> [f64; 2] {
        self.frame.origin.map(|at| at / self.frame.length)
    }

    /// A position of the frame.
    fn outward(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [a, b] = self.origin();
        [x + a, y + b]
    }

    /// Creepage at the frame's origin.
    fn inward(&self, creepage: Creepage) -> Creepage {
        let [xi, eta] = creepage.rigid_slip(self.origin());
        Creepage { xi, eta, ..creepage }
    }

    /// The force with the moment about the origin of coordinates, from that about the frame's.
    fn moved(&self, Force { fx, fy, mz }: Force) -> Force {
        let [x, y] = self.origin();
        Force { fx, fy, mz: mz + x * fy - y * fx }
    }

    /// Error bars of [`NonHertzian::moved`].
    fn moved_error(&self, Force { fx, fy, mz }: Force) -> Force {
        let [x, y] = self.origin().map(f64::abs);
        Force { fx, fy, mz: mz + x * fy + y * fx }
    }
}

/// What a solve gives.
#[derive(Debug, Clone, Copy)]
struct Answer {
    solution: Solution,
    /// From force and creepage, and from the tractions' work on what is added to the creepage.
    power: f64,
    dissipation: f64,
    /// What the tractions of the finer grid's elements give of it.
    by_elements: f64,
}

/// Tractions of a solved contact, from which one close by may start: [`NonHertzian::solve_near`].
#[derive(Debug, Clone, PartialEq)]
pub struct TangentialWarmStart {
    /// Elements in each strip of both grids.
    elements: [Vec<usize>; 2],
    tractions: [Vec<[f64; 2]>; 2],
}

/// A contact of any shape solved; made by [`NonHertzian::solve`].
///
/// A field between elements is bounded by the pressure at the position.
#[derive(Debug)]
pub struct NonHertzianSolved<'a> {
    theory: &'a NonHertzian,
    workspace: Workspace,
    creepage: Creepage,
    /// What is added to the slip of each grid's elements.
    more: [Vec<[f64; 2]>; 2],
    answer: Answer,
}

impl<'a> NonHertzianSolved<'a> {
    fn new(theory: &'a NonHertzian, creepage: Creepage, more: [Vec<[f64; 2]>; 2]) -> Self {
        let mut workspace = theory.pool.take(&theory.grids);
        let answer = theory.answer(&mut workspace, false, creepage, &more);
        Self { theory, workspace, creepage, more, answer }
    }

    /// Goes on to a creepage nearby, with `more` as of [`NonHertzian::solve_curved`]: quicker than a
    /// solution from nothing, for it starts from these tractions, and the same to the solver's
    /// tolerance. Where friction depends on the slip and several solutions exist, it may stay
    /// with this one.
    pub fn resolve_at(&mut self, creepage: Creepage, more: impl Fn([f64; 2]) -> [f64; 2]) {
        let theory = self.theory;
        (self.creepage, self.more) = (creepage, theory.slips(more));
        let (room, more) = (&mut self.workspace, &self.more);
        let mut answer = theory.answer(room, true, creepage, more);
        if answer.solution.status == Status::NotConverged {
            answer = theory.answer(room, false, creepage, more);
        }
        self.answer = answer;
    }

    /// The force with its moment about a point.
    #[must_use]
    pub fn force_about(&self, [x, y]: [f64; 2]) -> Force {
        let Force { fx, fy, mz } = self.answer.solution.force;
        Force { fx, fy, mz: mz - x * fy + y * fx }
    }

    /// Its tractions, for contacts close by.
    #[must_use]
    pub fn tractions(&self) -> TangentialWarmStart {
        let tractions = self.workspace.states().map(|state| {
            let elements = 0..state.traction.own[0].len();
            elements.map(|element| state.traction.at(element)).collect()
        });
        TangentialWarmStart { elements: self.theory.strips(), tractions }
    }

    /// The elements of the finer grid, strip by strip, each from the leading edge.
    #[must_use]
    pub fn elements(&self) -> Vec<ElementField> {
        let (view, outward) = (self.view(), |at| self.theory.outward(at));
        let (grid, state) = (&self.theory.grids[1], self.workspace.states()[1]);
        let unresolved =
            Unresolved::new(grid, state, self.answer.dissipation, self.answer.by_elements);
        let element = |(strip, i)| {
            let element = view.element(strip, i);
            let point = FieldPoint { position: outward(element.point.position), ..element.point };
            let power = unresolved.power(grid, state, strip, i);
            ElementField { point, power, corners: element.corners.map(outward), ..element }
        };
        self.theory.grids[1].mesh.all().map(element).collect()
    }

    fn view(&self) -> FieldInterpolation<'_> {
        self.view_of(1)
    }

    /// The coarser grid, 0, or the finer one, 1, as it is seen.
    fn view_of(&self, level: usize) -> FieldInterpolation<'_> {
        FieldInterpolation::new(&self.theory.grids[level], self.workspace.states()[level])
    }

    fn at(&self, level: usize, view: &FieldInterpolation, position: [f64; 2]) -> FieldPoint {
        let theory = self.theory;
        let [x, y] = position.map(|at| theory.scaling.length * at);
        let [a, b] = theory.origin();
        let inward = [position[0] - a, position[1] - b];
        let pressure = theory.areas.pressure(x, y);
        match theory.grids[level].mesh.locate(inward) {
            Some((strip, along)) if pressure > 0.0 => {
                let bound = pressure / theory.areas.peak_pressure().value;
                FieldPoint { position, ..view.at(strip, inward, along, bound) }
            }
            _ => FieldPoint::outside(position),
        }
    }
}

impl Resolve for NonHertzianSolved<'_> {
    fn resolve(&self, creepage: Creepage) -> Self {
        Self::new(self.theory, creepage, self.more.clone())
    }
}

impl Solved for NonHertzianSolved<'_> {
    fn creepage(&self) -> Creepage {
        self.creepage
    }

    fn solution(&self) -> Solution {
        self.answer.solution
    }

    fn jacobian(&mut self) -> Option<Jacobian> {
        let theory = self.theory;
        if theory.grids[1].resistance.is_some() {
            let force = |creepage| self.resolve(creepage).answer.solution.force.components();
            return Some(differences(self.creepage, CREEPAGE_STEP, force));
        }
        let forces = self.workspace.sums(&theory.grids, 0.0).map(|sum| sum.force);
        let by = self.workspace.derivatives(&theory.grids);
        let columns = Extrapolation::PLAIN.derivative(forces, by);
        let unit = |k: usize| [0, 1, 2].map(|i| if i == k { 1.0 } else { 0.0 });
        let by = [0, 1, 2].map(|k| {
            let [xi, eta, chi] = unit(k);
            let weights = theory.inward(Creepage { xi, eta, chi }).components();
            let mut sum = Force::default();
            for (column, weight) in columns.iter().zip(weights) {
                sum.fx += weight * column.fx;
                sum.fy += weight * column.fy;
                sum.mz += weight * column.mz;
            }
            theory.moved(sum).components()
        });
        Some(std::array::from_fn(|i| std::array::from_fn(|k| by[k][i])))
    }

    fn field(&self, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let view = self.view();
        positions.iter().map(|at| self.at(1, &view, *at)).collect()
    }

    fn points(&self) -> Option<Vec<FieldPoint>> {
        Some(self.elements().iter().map(|element| element.point).collect())
    }

    fn elements(&self) -> Option<Vec<ElementField>> {
        Some(Self::elements(self))
    }

    /// The quarters of the finer grid's elements. The traction is extrapolated from the two grids, as
    /// the force is.
    fn patches(&self) -> Option<Vec<Patch>> {
        let views = [0, 1].map(|level| self.view_of(level));
        let elements = Self::elements(self);
        let quarters = elements.into_iter().flat_map(|element| quarters(element.corners));
        let patch = |corners: [[f64; 2]; 4]| {
            let at = |k: usize| self.at(k, &views[k], mean(&corners)).traction;
            let [coarse, fine] = [0, 1].map(at);
            Patch { corners, traction: [0, 1].map(|k| extrapolate(coarse[k], fine[k])) }
        };
        Some(quarters.map(patch).collect())
    }

    /// With the tractions' work on creepages that are added.
    fn power(&self) -> f64 {
        self.answer.power
    }

    /// As of [`ExactSolved`](super::ExactSolved): the power, and what traction times slip gives beyond it;
    /// the heat of slip areas narrower than an element, along the trailing edge, is in it.
    fn dissipation(&self) -> Option<f64> {
        Some(self.answer.dissipation)
    }

    fn diagnostics(&self) -> Vec<Diagnostic> {
        let [_, added] = self.theory.slips(|_| [0.0; 2]);
        error_bars_and_elements(
            &added,
            &self.theory.contact,
            self.answer.solution.error,
            self.theory.elements(),
        )
    }
}

impl Theory for NonHertzian {
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

impl Drop for NonHertzianSolved<'_> {
    fn drop(&mut self) {
        self.theory.pool.give_back(std::mem::take(&mut self.workspace));
    }
}
