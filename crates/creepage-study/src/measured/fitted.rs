//! Result of a fit of friction to measured forces: estimates and cautions, or an error.

use std::fmt;

use creepage::theory::TheoryError;
use creepage::{InvalidValue, SiCreepage, Status};

use crate::{Caution, GapCaseError, RowError};

/// Error of a fit.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FitError {
    /// The case file is no case with a creepage.
    #[error(transparent)]
    Case(Box<GapCaseError>),
    /// Friction of the case depends on the slip or the place.
    #[error("[contact] friction is a law: one coefficient of friction is fitted; give a number")]
    FrictionLaw,
    /// The load of areas of any shape is the case's.
    #[error(
        "column normal_force: bodies with [gap] are pressed once, by the load of the case file"
    )]
    LoadOfAreas,
    /// The theory is out of its range.
    #[error(transparent)]
    Theory(TheoryError),
    /// A coefficient of friction that a contact cannot have.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// A row that is no case.
    #[error("row {row}: {source}")]
    Row {
        /// From one, without the header.
        row: usize,
        /// Why.
        source: RowError,
    },
    /// Fewer measured forces than it takes.
    #[error("{given} measured forces are too few for {wanted}: at least {least} are needed")]
    TooFew {
        /// How many there are.
        given: usize,
        /// What is to be found.
        wanted: &'static str,
        /// How many it takes to tell how uncertain it is.
        least: usize,
    },
    /// All forces are zero.
    #[error("all measured forces are zero: they say nothing of friction")]
    NoForce,
    /// No friction carries such forces.
    #[error(
        "the measured forces are up to {share:.3} times the normal force, more than any friction: check the units of \
         both (N)"
    )]
    BeyondFriction {
        /// The largest force over its normal force.
        share: f64,
    },
    /// No point slips.
    #[error("all creepages are zero: such points say nothing of friction")]
    NoCreepage,
    /// Any value fits.
    #[error("the points do not determine {what}: {why}")]
    Undetermined {
        /// Which parameter.
        what: &'static str,
        /// How the points lie.
        why: &'static str,
    },
    /// Somebody said stop.
    #[error("interrupted")]
    Interrupted,
}

/// Options of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FitOptions {
    /// A factor of the initial slope too: the creepages count that many times, as where a layer or
    /// rough surfaces yield besides the bodies.
    pub slope: bool,
}

/// Estimate of a parameter, and its uncertainty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fitted {
    /// The number.
    pub value: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// What it lies in with a probability of 95 %, if the points scatter normally about the theory.
    pub interval: [f64; 2],
}

/// A measured point beside the theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedPoint {
    /// Its row of the table, from one, without the header.
    pub row: usize,
    /// Its creepage: what the table does not have is the case's.
    pub creepage: SiCreepage,
    /// Normal force (N).
    pub normal_force: f64,
    /// Measured longitudinal and lateral force (N), where they are.
    pub measured: [Option<f64>; 2],
    /// The same by the theory.
    pub fitted: [f64; 2],
    /// The larger distance of both, in standard deviations of the points.
    pub deviations: f64,
    /// Whether it does not belong to the others, and was left out.
    pub bad: bool,
    /// What the theory says of itself there.
    pub status: Status,
}

/// Caution about a fit.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum FitCaution {
    /// A point was left out.
    Bad {
        /// Its row.
        row: usize,
        /// How far off, in standard deviations.
        deviations: f64,
    },
    /// A number is hardly determined.
    Hardly {
        /// Which.
        what: &'static str,
        /// Its relative standard error.
        part: f64,
    },
    /// No dry bodies have that coefficient of friction.
    Friction {
        /// The coefficient.
        value: f64,
    },
    /// A creepage that no wheel has.
    Creepage {
        /// The row.
        row: usize,
        /// What it looks like.
        caution: Caution,
    },
    /// No point comes near the largest force.
    FarFromSliding {
        /// The largest force over `mu N`.
        share: f64,
    },
    /// The points scatter more than the uncertainty that was given for them.
    Scatter {
        /// By this factor, which the uncertainty of the result is enlarged by.
        factor: f64,
    },
    /// The theory does not hold, or did not converge, at some points.
    Status {
        /// Its words for it.
        status: Status,
        /// The rows.
        rows: Vec<usize>,
    },
}

impl fmt::Display for FitCaution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bad { row, deviations } => write!(
                f,
                "row {row} lies {deviations:.1} standard deviations from the others' fit and was left out"
            ),
            Self::Hardly { what, part } => {
                write!(
                    f,
                    "{what} is hardly determined: its standard error is {:.0} % of it",
                    100.0 * part
                )
            }
            Self::Friction { value } => write!(
                f,
                "mu = {value:.2e} is {} than any two bodies have: check the units of forces and loads (N)",
                if *value < 1.0 { "less" } else { "more" }
            ),
            Self::Creepage { row, caution } => write!(f, "row {row}: {caution}"),
            Self::FarFromSliding { share } => write!(
                f,
                "no point comes near sliding (at most {share:.2} of mu N): mu rests on the bend of the \
                 curve alone, and on the theory's initial slope"
            ),
            Self::Scatter { factor } => write!(
                f,
                "the points scatter {factor:.1} times as much as their uncertainty; the errors of the \
                 result are enlarged by that"
            ),
            Self::Status { status, rows } => {
                let rows: Vec<_> = rows.iter().map(ToString::to_string).collect();
                write!(f, "the theory is `{}` in rows {}", status.name(), rows.join(", "))
            }
        }
    }
}

/// Friction found from measured forces.
///
/// The coefficient of friction, and if asked for a factor `k` of the initial slope, for which
/// `mu N f(k xi, k eta, k chi)` is nearest to the measured forces in the sense of least squares, `f` by
/// any theory. Each residual counts over the normal force, or over its uncertainty where that is given.
/// Points that lie more than four robust standard deviations off are left out and named.
///
/// ```
/// use creepage_study::{AnyCaseFile, Fit, FitOptions, MeasuredPoints};
/// # let text = "
/// # upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46, radius_lateral = 'flat' }
/// # lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 'flat', radius_lateral = 0.3 }
/// # contact = { normal_force = 80e3, friction = 0.3 }
/// # creepage = { longitudinal = 0 }
/// # [solve]
/// # theory = 'polach'
/// # ";
/// let file = AnyCaseFile::read(text)?;
/// let spec = file.case(".".as_ref())?.theory().clone();
/// let table = "longitudinal,longitudinal_coefficient\n\
///     0.5e-3,0.095\n1e-3,0.155\n2e-3,0.205\n4e-3,0.228\n8e-3,0.239\n";
/// let measured = MeasuredPoints::read(table)?;
/// let fit = Fit::new(&file, ".".as_ref(), &spec, &measured, FitOptions::default(), &mut || true)?;
/// assert!((fit.friction.value - 0.25).abs() < 0.02);
/// assert!(fit.friction.interval[0] < fit.friction.value);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// The theory's name.
    pub theory: &'static str,
    /// Coefficient of friction.
    pub friction: Fitted,
    /// Factor of the initial slope, where it was asked for.
    pub slope: Option<Fitted>,
    /// Correlation of the two.
    pub correlation: Option<f64>,
    /// The points, in the order of the table.
    pub points: Vec<FittedPoint>,
    /// Root mean square of the residuals of points that count, over the normal force.
    pub scatter: f64,
    /// Residuals less parameters.
    pub degrees_of_freedom: usize,
    /// Largest force over `mu N` among the points that count.
    pub reached: f64,
    /// Cautions about it.
    pub cautions: Vec<FitCaution>,
    /// The curve, where all points have one load and differ in one component.
    pub(super) curve: Option<FittedCurve>,
}

/// The theory along the component that varies.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FittedCurve {
    pub(super) component: usize,
    /// Creepage in SI units, then longitudinal and lateral force (N).
    pub(super) points: Vec<[f64; 3]>,
}
