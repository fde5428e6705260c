//! Bulk case, some of whose quantities vary from row to row.

use creepage::{Contact, Creepage, Hertz, TheorySpec};

use super::solver::BulkQuery;
use super::varied::Varied;
use crate::case::sections::{PressedBodies, Sections};
use crate::{CaseError, CaseFile, Caution, DamageWanted};

/// A case some of whose quantities have values of their own in every row.
///
/// ```
/// use creepage_study::{BulkCase, CaseFile, Solver, Varied};
/// # let text = "
/// # upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46, radius_lateral = 'flat' }
/// # lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 'flat', radius_lateral = 0.3 }
/// # contact = { normal_force = 80e3, friction = 0.3 }
/// # creepage = { longitudinal = 1e-3 }
/// # [solve]
/// # theory = 'fastsim'
/// # ";
/// let file = CaseFile::read(text)?;
/// let case = BulkCase::new(&file, vec![Varied::Longitudinal, Varied::NormalForce])?;
/// let solver = Solver::new(case.theory().clone());
/// let history = [[1e-3, 60e3], [2e-3, 80e3], [f64::NAN, 80e3]];
/// let answers = history.map(|row| case.solve_one(&solver, &row));
/// assert!(answers[0].as_ref().is_ok_and(|answer| answer.force().longitudinal > 5e3));
/// let error = answers[2].as_ref().unwrap_err().to_string();
/// assert_eq!(error, "[creepage] longitudinal = NaN is not valid: it must be a finite number");
/// # Ok::<(), creepage_study::CaseError>(())
/// ```
#[derive(Debug, Clone)]
pub struct BulkCase {
    base: Sections,
    /// The bodies pressed together, where rows differ in nothing but the load.
    bodies: Option<Hertz>,
    varied: Vec<Varied>,
    theory: TheorySpec,
    damage: Option<DamageWanted>,
}

/// Row of a bulk case: a contact and its creepage.
#[derive(Debug, Clone, PartialEq)]
pub struct BulkRow {
    /// The contact ellipse and its pressure.
    pub hertz: Hertz,
    /// The same with friction: what a theory is prepared for.
    pub contact: Contact,
    /// The creepage.
    pub creepage: Creepage,
    /// Rolling velocity (m/s), where it is given.
    pub speed: Option<f64>,
    smallest_radius: Option<f64>,
    /// Shear yield stress (Pa), where `[damage]` gives it.
    shear_yield: Option<f64>,
    /// Whether a load presses the bodies together.
    pub touches: bool,
}

impl BulkCase {
    /// The case of a file whose quantities `varied` differ from row to row; a row gives their values
    /// in that order. What does not vary is the file's. Semi-axes that vary replace the file's radii,
    /// and radii its semi-axes.
    ///
    /// # Errors
    /// [`CaseError`] where the file wants forces, or gives a creepage in another form than the rows;
    /// where no creepage is given; where the theory is none.
    pub fn new(file: &CaseFile, varied: Vec<Varied>) -> Result<Self, CaseError> {
        if file.wants() {
            return Err(CaseError::Wanted);
        }
        if file.has_heat() {
            return Err(CaseError::HeatOfRows);
        }
        if file.has_slip() {
            return Err(CaseError::SlipOfRows);
        }
        if file.friction_varies() && varied.contains(&Varied::Friction) {
            return Err(CaseError::FrictionOfRows);
        }
        let (mut base, theory) = (file.sections(), file.theory()?);
        Varied::make_room(&varied, &mut base);
        let bodies = bodies(&base, &varied);
        let case = Self { base, bodies, varied, theory, damage: file.damage()? };
        case.check()?;
        Ok(case)
    }

    /// What is missing from every row, or contradicts it, is an error of the case: one row stands
    /// for all.
    fn check(&self) -> Result<(), CaseError> {
        match self.row(&vec![1.0; self.varied.len()]) {
            Err(
                error @ (CaseError::Missing { .. }
                | CaseError::MissingSection { .. }
                | CaseError::MissingEither { .. }
                | CaseError::Conflict { .. }),
            ) => Err(error),
            _ => Ok(()),
        }
    }

    /// The theory of the file.
    #[must_use]
    pub fn theory(&self) -> &TheorySpec {
        &self.theory
    }

    /// The laws of wear and fatigue, where their numbers are wanted.
    #[must_use]
    pub fn damage(&self) -> Option<&DamageWanted> {
        self.damage.as_ref()
    }

    /// What differs from row to row.
    #[must_use]
    pub fn varied(&self) -> &[Varied] {
        &self.varied
    }

    /// Whether rows have a rolling velocity, and so a frictional power.
    #[must_use]
    pub fn has_speed(&self) -> bool {
        self.base.creepage.speed.is_some() || self.varied.contains(&Varied::Speed)
    }

    /// The row of these values.
    ///
    /// # Errors
    /// [`CaseError`], as of a case file with these values.
    pub fn row(&self, values: &[f64]) -> Result<BulkRow, CaseError> {
        let mut sections = self.base.clone();
        for (varied, value) in self.varied.iter().zip(values) {
            varied.set(*value, &mut sections);
        }
        let touches = sections.contact.normal_force != 0.0;
        if !touches {
            // Any load will do for what is no force.
            sections.contact.normal_force = 1.0;
        }
        let hertz = match &self.bodies {
            Some(bodies) => {
                let load = sections.contact.normal_force;
                bodies.under(load).map_err(CaseError::invalid("contact"))?
            }
            None => sections.hertz()?,
        };
        let PressedBodies { hertz, contact, speed, .. } = sections.touching_by(hertz)?;
        let creepage = sections.creepage.resolve(contact.scaling())?;
        let smallest_radius = sections.smallest_radius();
        let shear_yield = self.damage.as_ref().map(|damage| damage.constants.shear_yield);
        Ok(BulkRow { hertz, contact, creepage, speed, smallest_radius, shear_yield, touches })
    }
}

/// Bodies by their radii, where all rows have the same. An ellipse that is given does not grow with
/// the load.
fn bodies(base: &Sections, varied: &[Varied]) -> Option<Hertz> {
    let by_ellipse = base.contact.semi_axis_rolling.is_some();
    if by_ellipse || varied.iter().any(|quantity| quantity.is_of_shape()) {
        return None;
    }
    let mut base = base.clone();
    if varied.contains(&Varied::NormalForce) {
        base.contact.normal_force = 1.0;
    }
    base.hertz().ok()
}

impl BulkRow {
    /// What it asks a theory.
    #[must_use]
    pub fn query(&self) -> BulkQuery {
        let (contact, creepage, touches) = (self.contact.clone(), self.creepage, self.touches);
        BulkQuery { contact, creepage, touches }
    }

    /// What looks like a number in another unit, and a metal that flows.
    #[must_use]
    pub fn cautions(&self) -> Vec<Caution> {
        if !self.touches {
            return Vec::new();
        }
        let creepage = self.contact.scaling().si_creepage(self.creepage);
        let mut cautions = Caution::units(&self.hertz, self.smallest_radius, creepage);
        let (peak, modulus) = (self.hertz.peak_pressure(), self.hertz.pair().shear_modulus());
        if !cautions.iter().any(Caution::is_of_units) {
            cautions.extend(Caution::yields(peak, modulus, self.shear_yield));
        }
        cautions
    }
}
