//! Sweep files: a series of cases of the numerical theory, the input of the programme of 1967
//! (5.21).

use creepage::halfspace::Polynomial;
use creepage::rolling::Creepage;
use creepage::rolling::variational::{
    Limits, Method, Procedure, Settings, Start, TractionBound, Variational, VariationalError,
};
use creepage::{Ellipse, InvalidValue};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

use crate::error::CaseError;
use crate::keys;
use crate::schema::schema_of;
use crate::solve::{Weight, two_numbers};
use crate::sweep_loops::Loops;

/// A series of cases, in the dimensionless quantities of the thesis.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "creepage sweep file")]
struct SweepFile {
    /// The contact that all cases share.
    contact: ContactSection,
    /// How the cases are solved.
    #[serde(default)]
    solve: SolveSection,
    /// Creepage and spin of the cases.
    creepage: Loops,
    /// What a case starts from.
    #[serde(default)]
    chain: ChainSection,
    /// What the printed page of a case shows.
    #[serde(default)]
    page: PageSection,
}

#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ContactSection {
    /// Ratio a/b of the contact's semi-axes, along over across the rolling direction.
    a_over_b: f64,
    /// Combined Poisson's ratio.
    poisson: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SolveSection {
    /// Formulation and method; "damped" by default.
    #[serde(default)]
    method: MethodName,
    /// Degree M of the traction polynomials, 0 to 12; 3 by default.
    degree: Option<usize>,
    /// Mesh lengths [along, across] in units of the major semi-axis; each divides the box around
    /// the ellipse. By default a tenth of the box, finer for degrees above 3.
    #[serde(default, deserialize_with = "two_numbers")]
    mesh_length: Option<[f64; 2]>,
    /// Weight of the points of the mesh; "elliptic" by default.
    weight: Option<Weight>,
    /// What is done about tractions above their bound; "automatic" by default.
    #[serde(default)]
    bound: BoundName,
    /// The iteration ends when the largest change is below delta times the largest unknown;
    /// 1e-6 by default, 1e-3 for "newton".
    delta: Option<f64>,
    /// Most iterations of a case; 200 by default, 12 for "newton".
    max_iterations: Option<usize>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum MethodName {
    /// The integral (5.9), by Newton's method with damping.
    #[default]
    Damped,
    /// The integral (5.9), by Newton's method as in 1967.
    Newton,
    /// Least squares with explicit areas of adhesion and slip (5.15).
    Areas,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum BoundName {
    /// "kept" where a/b is 3 or more.
    #[default]
    Automatic,
    /// Verified afterwards only, as in 1967.
    Unchecked,
    /// Kept: by the least loss of power in place of the integral (5.9).
    Kept,
}

#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ChainSection {
    /// The outermost loop that a chain runs through; several chains run in parallel. "upsilon" by
    /// default: a chain for every chi and alpha; "chi" is one chain of all cases, as in 1967.
    #[serde(default)]
    through: Through,
    /// Coefficients of X', then of Y', in 1, x, y, x^2, xy, y^2, ..., with the major semi-axis as
    /// unit of length: what the first case of every chain starts from. By default full sliding.
    starting_values: Option<Vec<f64>>,
    /// Solve every case from a second start as well, and tell by how much the forces differ.
    second_start: Option<SecondStart>,
}

/// The outermost loop that a chain runs through.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Through {
    /// A chain for every chi and alpha.
    #[default]
    Upsilon,
    /// A chain for every chi.
    Alpha,
    /// One chain.
    Chi,
}

/// Where the check of a case starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SecondStart {
    /// From full sliding.
    FullSliding,
    /// From full adhesion.
    Adhesion,
    /// From no traction.
    Zero,
}

impl SecondStart {
    /// The start itself.
    #[must_use]
    pub fn start(self) -> Start<'static> {
        match self {
            Self::FullSliding => Start::FullSliding,
            Self::Adhesion => Start::Adhesion,
            Self::Zero => Start::Zero,
        }
    }
}

#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct PageSection {
    /// Lines y, in units of the major semi-axis, of which the page lists the points: those of the
    /// mesh in x.
    #[serde(default)]
    lines: Vec<f64>,
}

impl PageSection {
    fn lines(self) -> Result<Vec<f64>, CaseError> {
        let Some(&value) = self.lines.iter().find(|y| !y.is_finite()) else {
            return Ok(self.lines);
        };
        let invalid = InvalidValue { quantity: "lines", value, valid: "finite numbers" };
        Err(CaseError::invalid("page")(invalid))
    }
}

/// A sweep, every number of it checked.
///
/// ```
/// let sweep = creepage_case::Sweep::read(r#"
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
/// # Ok::<(), creepage_case::CaseError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Ratio `a/b` of the semi-axes.
    pub a_over_b: f64,
    /// Combined Poisson's ratio.
    pub poisson: f64,
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

/// The JSON schema (draft 2020-12) of a sweep file, for editors and validators.
///
/// ```
/// let schema = creepage_case::sweep_json_schema();
/// assert!(schema["properties"]["creepage"]["properties"]["chi"].is_object());
/// ```
#[must_use]
pub fn sweep_json_schema() -> Value {
    schema_of::<SweepFile>()
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
            settings: file.solve.settings(file.contact.a_over_b)?,
            procedure: file.solve.procedure()?,
            starting_values: file.chain.starting_values.map(polynomials).transpose()?,
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
        Variational::new(self.a_over_b, self.poisson, self.settings).map_err(|source| {
            let in_contact = matches!(source, VariationalError::Invalid(_));
            let section = if in_contact { "contact" } else { "solve" };
            CaseError::Variational { section, source }
        })
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
        let creepage = Creepage { xi: upsilon * cos, eta: upsilon * sin, chi };
        SweepCase { chi, alpha, upsilon, creepage }
    }
}

impl SolveSection {
    fn settings(&self, a_over_b: f64) -> Result<Settings, CaseError> {
        let usual = self.degree.map_or_else(Settings::default, Settings::of_degree);
        let mesh = self.mesh_length.map(|lengths| cells(lengths, a_over_b)).transpose()?;
        Ok(Settings {
            mesh: mesh.unwrap_or(usual.mesh),
            weight: self.weight.map_or(usual.weight, Into::into),
            bound: match self.bound {
                BoundName::Automatic => TractionBound::Automatic,
                BoundName::Unchecked => TractionBound::Unchecked,
                BoundName::Kept => TractionBound::Kept,
            },
            ..usual
        })
    }

    fn procedure(&self) -> Result<Procedure, CaseError> {
        let (method, usual) = match self.method {
            MethodName::Damped => (Method::Damped, Limits::default()),
            MethodName::Newton => (Method::Newton, Limits::OF_1967),
            MethodName::Areas => (Method::Areas, Limits::default()),
        };
        let delta = self.delta.unwrap_or(usual.delta);
        if !(delta.is_finite() && delta > 0.0) {
            return Err(in_solve("delta", delta, "finite and greater than zero"));
        }
        let max_iterations = self.max_iterations.unwrap_or(usual.max_iterations);
        Ok(Procedure { method, limits: Limits { delta, max_iterations } })
    }
}

/// Cells of the box around the ellipse, whose major semi-axis is 1.
// A length that gives absurdly many cells ends as one too many, which the theory refuses.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn cells(lengths: [f64; 2], a_over_b: f64) -> Result<[usize; 2], CaseError> {
    let ellipse = Ellipse::from_ratio(a_over_b).map_err(CaseError::invalid("contact"))?;
    let mut cells = [0; 2];
    for (cells, (length, semi_axis)) in
        cells.iter_mut().zip(lengths.into_iter().zip([ellipse.a(), ellipse.b()]))
    {
        let count = 2.0 * semi_axis / ellipse.major() / length;
        // As near to a whole number as decimals of 1/3 written with seven digits.
        if !(length > 0.0 && (count - count.round()).abs() < 1e-5 && count >= 1.0) {
            let valid = "a length that divides the box around the ellipse, 2 along its major axis";
            return Err(in_solve("mesh_length", length, valid));
        }
        *cells = count.round().min(Settings::MAX_CELLS as f64 + 1.0) as usize;
    }
    Ok(cells)
}

fn in_solve(quantity: &'static str, value: f64, valid: &'static str) -> CaseError {
    CaseError::invalid("solve")(InvalidValue { quantity, value, valid })
}

/// `X'` and `Y'` from the list of their coefficients.
fn polynomials(mut values: Vec<f64>) -> Result<[Polynomial; 2], CaseError> {
    let wrong = |source| CaseError::StartingValues { source };
    let y = values.split_off(values.len() / 2);
    Ok([Polynomial::new(values).map_err(wrong)?, Polynomial::new(y).map_err(wrong)?])
}
