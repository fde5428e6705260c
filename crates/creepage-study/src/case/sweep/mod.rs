//! Sweep files: a series of cases of the numerical theory, the input of the programme of 1967
//! (5.21).

mod chain;
mod file;
mod loops;
mod solve;

use creepage::halfspace::Polynomial;
use creepage::variational::{
    Chain, Procedure, Settings, Variational, VariationalError, VariationalSolution,
};
use creepage::{Contact, Creepage, Ellipse};

use crate::case::error::CaseError;
use crate::case::keys;

pub use chain::SecondStart;
use chain::Through;
use file::SweepFile;
pub use file::sweep_json_schema;

/// A sweep, every number of it checked.
///
/// ```
/// let sweep = creepage_study::Sweep::read(r#"
///     [contact]
///     a_over_b = 0.5
///     poisson = 0.28
///     [creepage]
///     chi = [2.0]
///     alpha = { from = -30, step = 30, to = 30 }
///     upsilon = [2.5, 2.0, 1.7]
/// "#)?;
/// assert_eq!((sweep.cases(), sweep.chain_length()), (9, 3));
/// assert_eq!(sweep.case(5).alpha, 0.0);
/// assert_eq!(sweep.case(5).upsilon, 1.7);
/// # Ok::<(), creepage_study::CaseError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Ratio `a/b` of the semi-axes.
    pub a_over_b: f64,
    /// Combined Poisson's ratio.
    pub poisson: f64,
    /// How unlike the bodies are: `kappa` of (2.10) over the coefficient of friction.
    pub kappa_over_mu: f64,
    /// Degree, mesh, weight and treatment of the bound.
    pub settings: Settings,
    /// Method and limits.
    pub procedure: Procedure,
    /// Traction polynomials `X'`, `Y'` that the first case of every chain starts from, in place
    /// of full sliding.
    pub starting_values: Option<[Polynomial; 2]>,
    /// The check of every case by a second start.
    pub second_start: Option<SecondStart>,
    /// Lines `y`, in units of the major semi-axis, of which the page lists the points.
    pub page_lines: Vec<f64>,
    chi: Vec<f64>,
    alpha: Vec<f64>,
    upsilon: Vec<f64>,
    through: Through,
}

/// One case of a sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepCase {
    /// Dimensionless spin.
    pub chi: f64,
    /// Angle from the rolling direction to the creepage (degrees).
    pub alpha: f64,
    /// Magnitude of the creepage.
    pub upsilon: f64,
    /// All three as creepage and spin (5.16).
    pub creepage: Creepage,
}

impl Sweep {
    /// Reads the text of a sweep file.
    ///
    /// # Errors
    /// [`CaseError`] that names the section and key of what is wrong.
    pub fn read(text: &str) -> Result<Self, CaseError> {
        keys::check(&text.parse()?, &sweep_json_schema())?;
        let file: SweepFile = toml::from_str(text)?;
        let [chi, alpha, upsilon] = file.creepage.values()?;
        let sweep = Self {
            a_over_b: file.contact.a_over_b,
            poisson: file.contact.poisson,
            kappa_over_mu: file.contact.kappa_over_mu,
            settings: file.solve.settings(file.contact.a_over_b)?,
            procedure: file.solve.procedure()?,
            starting_values: file.chain.starting_values()?,
            second_start: file.chain.second_start,
            page_lines: file.page.lines()?,
            chi,
            alpha,
            upsilon,
            through: file.chain.through,
        };
        sweep.theory()?;
        Ok(sweep)
    }

    /// The theory that solves the cases.
    ///
    /// # Errors
    /// [`CaseError`] when a number of the contact or the mesh is out of range.
    pub fn theory(&self) -> Result<Variational, CaseError> {
        let contact = Ellipse::from_ratio(self.a_over_b)
            .and_then(|ellipse| Contact::new(ellipse, self.poisson))
            .and_then(|contact| contact.with_kappa_over_mu(self.kappa_over_mu))
            .map_err(CaseError::invalid("contact"))?;
        Variational::new(&contact, self.settings).map_err(|source| {
            let in_contact = matches!(source, VariationalError::Invalid(_));
            let section = if in_contact { "contact" } else { "solve" };
            CaseError::Variational { section, source }
        })
    }

    /// The chain that begins with the case of that number, before it is solved.
    ///
    /// # Panics
    /// As [`Sweep::case`].
    #[must_use]
    pub fn chain<'a>(&self, theory: &'a Variational, first: usize) -> Chain<'a> {
        let given = self.starting_values.as_ref();
        match given.and_then(|polynomials| theory.unknowns_of(polynomials).ok()) {
            Some(tau) => Chain::from(theory, self.procedure, self.case(first).creepage, tau),
            None => Chain::new(theory, self.procedure),
        }
    }

    /// By how much the forces differ from those of the second start; NaN where none is asked for.
    #[must_use]
    pub fn second_start_difference(
        &self,
        theory: &Variational,
        creepage: Creepage,
        found: &VariationalSolution,
    ) -> f64 {
        self.second_start
            .map_or(f64::NAN, |second| theory.check_by(creepage, found, &second.start()))
    }

    /// Number of cases.
    #[must_use]
    pub fn cases(&self) -> usize {
        self.chi.len() * self.alpha.len() * self.upsilon.len()
    }

    /// Number of cases in each chain; the chains follow each other.
    #[must_use]
    pub fn chain_length(&self) -> usize {
        match self.through {
            Through::Upsilon => self.upsilon.len(),
            Through::Alpha => self.alpha.len() * self.upsilon.len(),
            Through::Chi => self.cases(),
        }
    }

    /// The case of that number, counted from 0 in the order of (5.16).
    ///
    /// # Panics
    /// Unless `index` is below [`Sweep::cases`].
    #[must_use]
    pub fn case(&self, index: usize) -> SweepCase {
        let (outer, inner) = (index / self.upsilon.len(), index % self.upsilon.len());
        let chi = self.chi[outer / self.alpha.len()];
        let alpha = self.alpha[outer % self.alpha.len()];
        let upsilon = self.upsilon[inner];
        let (sin, cos) = alpha.to_radians().sin_cos();
        // Within the range of creepages, as each loop is.
        let creepage = Creepage::new(upsilon * cos, upsilon * sin, chi).unwrap_or_default();
        SweepCase { chi, alpha, upsilon, creepage }
    }
}
