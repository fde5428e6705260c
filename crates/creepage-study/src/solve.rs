//! Solution of a case by a theory: [`SolvedCase`], whatever its contact.

use std::fmt;
use std::sync::OnceLock;

use creepage::coulomb::{Constraints, ElementField, InverseError};
use creepage::normal::{Estimate, NormalContact};
use creepage::theory::{Diagnostic, TheoryError, TheoryFacts};
use creepage::{
    Contact, Creepage, Ellipse, FieldPoint, Force, Hertz, Region, Scaling, SiForce, Solution,
    Solved, Theory, TheorySpec,
};
use creepage_plot::Contour;
use self_cell::self_cell;

use crate::stresses::StressError;
use crate::{AnyCase, Case, Caution, CurvedJson, Damage, Given, Heat, UnattainableForce};

/// Solves a case by its own theory, or by another one.
///
/// ```
/// use creepage_study::{CaseFile, solve};
/// # let text = "
/// # upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46, radius_lateral = 'flat' }
/// # lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 'flat', radius_lateral = 0.3 }
/// # contact = { normal_force = 80e3, friction = 0.3 }
/// # creepage = { longitudinal = 1e-3 }
/// # [solve]
/// # resolution = 'fast'
/// # ";
/// let case = CaseFile::read(text)?.case()?;
/// let exact = solve(&case, None)?;
/// let fastsim = solve(&case, Some(&case.theory_named("fastsim")?))?;
/// let [one, other] = [&exact, &fastsim].map(|solved| solved.solution().force.fx);
/// assert!((one - other).abs() < 0.05);
/// assert!(exact.text().starts_with("Theory exact: solved"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`SolveError`] for a contact or options out of the theory's range, and for constraints that the
/// theory cannot meet.
pub fn solve(case: &Case, other: Option<&TheorySpec>) -> Result<SolvedCase, SolveError> {
    let spec = other.unwrap_or(&case.theory);
    let theory = spec.prepare(&case.contact)?;
    let held = SolvedTheory::try_new(theory, |theory| {
        solve_constraints(&**theory, case, spec.facts().name)
    })?;
    let of = AnyCase::Ellipse(case.clone());
    let solved = SolvedCase::new(of, &case.contact, spec.facts(), held, |solution, creepage| {
        let mut cautions = Caution::all(spec, &case.contact, solution);
        let creepage = case.contact.scaling().si_creepage(creepage);
        cautions.extend(Caution::units(&case.hertz, case.smallest_radius, creepage));
        let groove =
            Caution::groove(case.slip_by_groove, case.hertz.ellipse(), case.contact.scaling());
        if groove.is_some() {
            // A groove that fits closely is no number in another unit.
            cautions.retain(|caution| !matches!(caution, Caution::LargeContact { .. }));
        }
        cautions.extend(groove);
        let (peak, shear_modulus) = (case.hertz.peak_pressure(), case.hertz.pair().shear_modulus());
        let shear_yield = case.damage.as_ref().map(|damage| damage.constants.shear_yield);
        if !cautions.iter().any(Caution::is_of_units) {
            cautions.extend(Caution::yields(peak, shear_modulus, shear_yield));
        }
        cautions
    });
    Ok(solved.with_heat())
}

fn solve_constraints<'t>(
    theory: &'t dyn Theory,
    case: &Case,
    name: &'static str,
) -> Result<BoxedSolved<'t>, SolveError> {
    match case.given {
        Given::Creepage(creepage) => Ok(theory.solved(creepage)),
        Given::Constraints(constraints) => theory
            .solved_for(constraints)
            .ok_or(SolveError::FindsNothing { name })?
            .map_err(|error| {
                let Constraints { fx, fy, mz, .. } = constraints;
                let prescribed = [fx, fy, mz].map(|force| force.is_some());
                in_si_units(error, prescribed, case.contact.scaling())
            }),
    }
}

/// The error of a search, with what it names in SI units.
pub(crate) fn in_si_units(
    error: InverseError,
    prescribed: [bool; 3],
    scaling: Scaling,
) -> SolveError {
    match error {
        InverseError::NotReachable { nearest, at } => {
            UnattainableForce { prescribed, nearest, at, scaling }.into()
        }
        other => other.into(),
    }
}

/// Error of a case that was not solved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SolveError {
    /// The theory cannot be prepared.
    #[error("[solve] {0}")]
    Theory(#[from] TheoryError),
    /// The theory does not find creepages.
    #[error("[wanted] needs the theory exact: {name} does not find creepages")]
    FindsNothing {
        /// Its name.
        name: &'static str,
    },
    /// No creepage meets the constraints.
    #[error(transparent)]
    UnattainableForce(#[from] UnattainableForce),
    /// The constraints make no sense.
    #[error(transparent)]
    Inverse(#[from] InverseError),
}

type BoxedTheory = Box<dyn Theory>;
type BoxedSolved<'t> = Box<dyn Solved + 't>;

self_cell! {
    /// A theory, and the contact that it solved.
    pub(crate) struct SolvedTheory {
        owner: BoxedTheory,
        #[covariant]
        dependent: BoxedSolved,
    }
}

/// A case and its solution, ready to be shown, whatever its contact. What takes time, as the field in the
/// contact, is computed when it is asked for.
pub struct SolvedCase {
    /// The case.
    pub case: AnyCase,
    /// What touches, with its friction.
    pub contact: Contact,
    /// The theory that solved it.
    pub theory: &'static TheoryFacts,
    /// Warnings.
    pub cautions: Vec<Caution>,
    solution: Solution,
    creepage: Creepage,
    held: SolvedTheory,
    adhesion: OnceLock<Contour>,
    elements: OnceLock<Vec<ElementField>>,
    pub(crate) damage: OnceLock<Result<Option<Damage>, StressError>>,
    pub(crate) heat: Option<Heat>,
    /// What a contact along a curve has besides.
    pub(crate) curved: Option<CurvedJson>,
}

impl SolvedCase {
    pub(crate) fn new(
        case: AnyCase,
        contact: &Contact,
        theory: &'static TheoryFacts,
        held: SolvedTheory,
        cautions: impl Fn(&Solution, Creepage) -> Vec<Caution>,
    ) -> Self {
        let solved = held.borrow_dependent();
        let (solution, creepage) = (solved.solution(), solved.creepage());
        Self {
            case,
            contact: contact.clone(),
            theory,
            cautions: cautions(&solution, creepage),
            solution,
            creepage,
            held,
            adhesion: OnceLock::new(),
            elements: OnceLock::new(),
            damage: OnceLock::new(),
            heat: None,
            curved: None,
        }
    }

    /// The pressed areas of any shape; `None` for Hertz's ellipse.
    #[must_use]
    pub fn areas(&self) -> Option<&NormalContact> {
        self.contact.areas().map(|areas| &**areas)
    }

    /// The elements of the theory, with the heat of each; none where it has none.
    #[must_use]
    pub fn elements(&self) -> &[ElementField] {
        self.elements.get_or_init(|| self.solved().elements().unwrap_or_default())
    }

    /// Normal force (N).
    #[must_use]
    pub fn load(&self) -> Estimate {
        self.estimate(Hertz::normal_force, NormalContact::load)
    }

    /// Approach of the bodies (m); of a gap counted like the gap.
    #[must_use]
    pub fn approach(&self) -> Estimate {
        self.estimate(Hertz::approach, NormalContact::approach)
    }

    /// Largest pressure (Pa).
    #[must_use]
    pub fn peak_pressure(&self) -> Estimate {
        self.estimate(Hertz::peak_pressure, NormalContact::peak_pressure)
    }

    /// Area of the contact (m2); what a theory changes about it is in [`SolvedCase::contact_area`].
    #[must_use]
    pub fn area(&self) -> Estimate {
        self.estimate(|hertz| hertz.ellipse().area(), NormalContact::area)
    }

    /// What Hertz has in closed form, and areas of any shape with an error bar.
    fn estimate(
        &self,
        closed_form: impl Fn(&Hertz) -> f64,
        pressed: impl Fn(&NormalContact) -> Estimate,
    ) -> Estimate {
        let unknown = Estimate { value: f64::NAN, error: f64::NAN };
        let closed = |hertz| Estimate { value: closed_form(hertz), error: 0.0 };
        self.areas().map(pressed).or(self.case.hertz().map(closed)).unwrap_or(unknown)
    }

    /// Contact stiffness `dN/d(approach)` (N/m).
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        let pressed = self.areas().map(NormalContact::stiffness);
        pressed.or(self.case.hertz().map(Hertz::stiffness)).unwrap_or(f64::NAN)
    }

    /// Force on the lower body, its moment about the contact's origin.
    #[must_use]
    pub fn force(&self) -> SiForce {
        self.scaling().si_force(self.solution.force)
    }

    /// Error bars of that force, where the theory has them: those of rolling, and of a load that was found
    /// its own in proportion.
    #[must_use]
    pub fn force_error(&self) -> Option<SiForce> {
        let (load, force, error) = (self.load(), self.solution.force, self.solution.error?);
        let part = load.error / load.value;
        Some(self.scaling().si_force(Force {
            fx: error.fx + part * force.fx.abs(),
            fy: error.fy + part * force.fy.abs(),
            mz: error.mz + part * force.mz.abs(),
        }))
    }

    /// Force, error bars, status.
    #[must_use]
    pub fn solution(&self) -> Solution {
        self.solution
    }

    /// The creepage, given or found.
    #[must_use]
    pub fn creepage(&self) -> Creepage {
        self.creepage
    }

    /// The units of creepage and force.
    #[must_use]
    pub fn scaling(&self) -> Scaling {
        self.contact.scaling()
    }

    /// Pressure at a position in units of `c` (Pa).
    #[must_use]
    pub fn pressure(&self, position: [f64; 2]) -> f64 {
        match self.areas() {
            Some(areas) => {
                let [x, y] = position.map(|at| at * self.scaling().length);
                areas.pressure(x, y)
            }
            None => self.peak_pressure().value * self.bound(position),
        }
    }

    /// Traction and slip at `positions` in units of `c`.
    #[must_use]
    pub fn field(&self, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.solved().field(positions)
    }

    /// Traction and slip at the theory's own points; where it has none, at the midpoints of 40 x 40
    /// cells of the box around the ellipse, those inside it.
    #[must_use]
    pub fn points(&self) -> Vec<FieldPoint> {
        let usual = || self.field(&usual_mesh(self.contact.ellipse()));
        self.solved().points().unwrap_or_else(usual)
    }

    /// How many these are.
    pub(crate) fn point_count(&self) -> usize {
        let own = self.solved().points().map(|points| points.len());
        own.unwrap_or_else(|| usual_mesh(self.contact.ellipse()).len())
    }

    /// The theory's own figures.
    #[must_use]
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        self.solved().diagnostics()
    }

    /// What was given, where the creepage of an ellipse was to be found.
    pub(crate) fn constraints(&self) -> Option<Constraints> {
        match &self.case {
            AnyCase::Ellipse(Case { given: Given::Constraints(constraints), .. }) => {
                Some(*constraints)
            }
            _ => None,
        }
    }

    /// Adhesion area over contact area, 0 to 1; traced when it is first asked for, at some fifteen
    /// thousand points.
    #[must_use]
    pub fn adhesion_share(&self) -> f64 {
        match self.areas() {
            Some(_) => creepage::coulomb::adhesion_share(self.elements()),
            None => self.adhesion().share,
        }
    }

    /// The edge of the adhesion area.
    pub(crate) fn adhesion(&self) -> &Contour {
        self.adhesion.get_or_init(|| {
            Contour::trace(|disc| {
                let regions = self.solved().regions(&self.positions(disc));
                regions.iter().map(|region| *region == Region::Adhesion).collect()
            })
        })
    }

    /// Contact area (m^2).
    #[must_use]
    pub fn contact_area(&self) -> f64 {
        let hertz = |hertz: &Hertz| self.solved().relative_area() * hertz.ellipse().area();
        let pressed = self.areas().map(|areas| areas.area().value);
        pressed.or(self.case.hertz().map(hertz)).unwrap_or(f64::NAN)
    }

    /// Middle of the contact and its half-lengths along and across (m); of several areas those of the most
    /// loaded one.
    pub(crate) fn box_around(&self) -> [[f64; 2]; 2] {
        if let Some(hertz) = self.case.hertz() {
            return [[0.0; 2], [hertz.ellipse().a(), hertz.ellipse().b()]];
        }
        let patches = self.areas().map_or(&[][..], NormalContact::patches);
        let most = patches.iter().max_by(|one, two| one.load().total_cmp(&two.load()));
        most.map_or([[0.0; 2]; 2], |patch| {
            let extent = patch.extent();
            let ends = [extent.x, extent.y];
            [
                ends.map(|[low, high]| f64::midpoint(low, high)),
                ends.map(|[low, high]| 0.5 * (high - low)),
            ]
        })
    }

    /// Energy turned to heat per metre rolled (J/m), from force and creepage.
    #[must_use]
    pub fn power_per_metre(&self) -> f64 {
        self.scaling().force * self.scaling().slip * self.solved().power()
    }

    /// The same energy (J/m) from traction and slip all over the contact, where the theory gives
    /// it. The two differ by the error of the theory's discretization.
    #[must_use]
    pub fn dissipation_per_metre(&self) -> Option<f64> {
        let unit = self.scaling().force * self.scaling().slip;
        self.solved().dissipation().map(|power| unit * power)
    }

    /// Frictional power (W), where the rolling velocity is known.
    #[must_use]
    pub fn power(&self) -> Option<f64> {
        self.case.speed().map(|speed| speed * self.power_per_metre())
    }

    /// Frictional power over an area at a point, over the rolling velocity: the energy turned to
    /// heat per metre rolled and square metre of contact (J/m^3). NaN where slip is not given.
    pub(crate) fn power_density(&self, point: &FieldPoint) -> f64 {
        let ([x, y], [u, v]) = (point.traction, point.slip);
        (x * u + y * v) * self.scaling().traction * self.scaling().slip
    }

    /// Places `(x/a, y/b)` in units of `c`, as a theory takes them; moved with the contact area, where it
    /// moves.
    pub(crate) fn positions(&self, disc: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let [a, b] = self.semi_axes();
        disc.iter().map(|[x, y]| self.solved().moved([a * x, b * y])).collect()
    }

    /// Semi-axes in units of `c`.
    pub(crate) fn semi_axes(&self) -> [f64; 2] {
        let ellipse = self.contact.ellipse();
        [ellipse.a() / ellipse.c(), ellipse.b() / ellipse.c()]
    }

    pub(crate) fn solved(&self) -> &dyn Solved {
        &**self.held.borrow_dependent()
    }
}

/// Midpoints of 40 x 40 cells of the box around the ellipse, those inside it, in units of `c`:
/// line by line from `-y`, each from `-x`.
fn usual_mesh(ellipse: Ellipse) -> Vec<[f64; 2]> {
    const CELLS: u8 = 40;
    let [a, b] = [ellipse.a() / ellipse.c(), ellipse.b() / ellipse.c()];
    let places = (0..CELLS).map(|i| (2.0 * f64::from(i) + 1.0) / f64::from(CELLS) - 1.0);
    let pairs = places.clone().flat_map(|y| places.clone().map(move |x| (x, y)));
    pairs.filter(|(x, y)| x.hypot(*y) < 1.0).map(|(x, y)| [a * x, b * y]).collect()
}

impl fmt::Debug for SolvedCase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SolvedCase")
            .field("case", &self.case)
            .field("theory", &self.theory.name)
            .field("cautions", &self.cautions)
            .field("creepage", &self.creepage)
            .field("solution", &self.solution)
            .finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{CURVE, SLIDING, STICK, Trial, case, report};

    #[test]
    fn the_adhesion_share_is_that_of_the_inner_ellipse() {
        for a_over_b in [0.05, 1.0, 20.0] {
            let share = report(a_over_b, Trial::Sticking, CURVE).adhesion_share();
            // Chords over cells of 2/96, and a pointed gap at the leading edge: 0.1 %.
            assert!((share - STICK * STICK).abs() < 1e-3, "{share}");
        }
        assert!(report(1.0, SLIDING, CURVE).adhesion_share().abs() < 1e-300);
    }

    #[test]
    fn heat_is_force_times_creepage() {
        let report = report(1.5, SLIDING, CURVE);
        let (creepage, force) = (report.scaling().si_creepage(report.creepage()), report.force());
        let power = force.longitudinal * creepage.longitudinal
            + force.lateral * creepage.lateral
            + force.moment * creepage.spin;
        let given = report.power_per_metre();
        // The same three products in another order: rounding only.
        assert!((given - power).abs() < 1e-12 * power.abs());
    }

    #[test]
    fn the_usual_mesh_lies_in_the_ellipse_of_any_size() {
        let mesh = usual_mesh(Ellipse::new(9e-3, 4e-3).unwrap());
        // pi/4 of 1600 cells; those on the edge fall to one side or the other.
        assert!((mesh.len() as f64 - 1256.6).abs() < 20.0, "{}", mesh.len());
        assert!(mesh.iter().all(|[x, y]| (x / 1.5).hypot(y * 1.5) < 1.0));
    }

    #[test]
    fn every_theory_solves_as_when_it_is_asked_alone() {
        let case = case(1.3, [0.4, -0.3, 0.2]);
        for theory in TheorySpec::all() {
            let solved = solve(&case, Some(&theory)).unwrap();
            let alone = theory.prepare(&case.contact).unwrap();
            assert_eq!(solved.solution(), alone.solve(solved.creepage()));
            assert_eq!(solved.theory.name, theory.facts().name);
            let positions = solved.positions(&[[0.1, 0.2], [-0.7, 0.1], [0.0, -0.6], [2.0, 0.0]]);
            let field = alone.field(solved.creepage(), &positions);
            assert_eq!(solved.field(&positions).len(), field.len());
            let regions: Vec<_> = field.iter().map(|point| point.region).collect();
            assert_eq!(alone.regions(solved.creepage(), &positions), regions);
            assert_eq!(solved.points().len(), solved.point_count());
        }
    }

    #[test]
    fn constraints_are_met_by_the_full_theory_alone() {
        let constraints =
            Constraints { eta: Some(0.0), chi: Some(0.2), fx: Some(0.5), ..Constraints::default() };
        let case = Case { given: Given::Constraints(constraints), ..case(1.0, CURVE) };
        let solved = solve(&case, None).unwrap();
        assert!((solved.solution().force.fx - 0.5).abs() < 1e-6);
        let linear = case.theory_named("linear").unwrap();
        let error = solve(&case, Some(&linear)).unwrap_err().to_string();
        assert_eq!(error, "[wanted] needs the theory exact: linear does not find creepages");
        let beyond = Constraints { fx: Some(1.5), ..constraints };
        let case = Case { given: Given::Constraints(beyond), ..case };
        let error = solve(&case, None).unwrap_err().to_string();
        assert!(error.starts_with("[wanted] is not reachable: at most long"), "{error}");
    }

    #[test]
    fn another_theory_has_its_own_options() {
        let coarse = crate::theory_spec("fastsim", &["grid=[5, 5]"]).unwrap();
        let case = Case { theory: coarse.clone(), ..case(1.0, CURVE) };
        assert_eq!(case.theory_named("fastsim").unwrap(), coarse);
        let fastrip = case.theory_named("fastrip").unwrap();
        assert_eq!(fastrip, TheorySpec::named("fastrip").unwrap());
        assert!(case.gives_up_options(std::slice::from_ref(&fastrip)));
        assert!(!case.gives_up_options(&[fastrip, coarse]));
    }
}
