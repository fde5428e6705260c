//! Friction, and the initial slope, fitted to measured forces.

use std::fmt;
use std::path::Path;

use creepage::theory::TheoryError;
use creepage::{InvalidValue, SiCreepage, Status, TheorySpec};

use super::least_squares::{Minimum, minimize, robust_deviation, student_95};
use super::model::{Model, Predicted};
use super::points::MeasuredPoints;
use crate::{AnyCaseFile, GapCaseError, RowError};

/// Largest measured force over the normal force, times these, is where friction is looked for: below
/// one for the sake of bad points, far above it for points without slip.
const SEARCHED: [f64; 2] = [0.2, 20.0];
/// Values of friction from which the search starts, and of the factor of the slope.
const STARTS: u32 = 15;
const SLOPES: [f64; 5] = [0.2, 0.4, 0.7, 1.0, 1.5];
/// A point so many robust standard deviations off does not belong to the others: one in 16,000 of a
/// normal distribution.
const BAD: f64 = 4.0;
/// Rounds of leaving out bad points.
const MAX_ROUNDS: usize = 8;
/// The least standard deviation by which a point is judged, of the largest force: the theories' own
/// error.
const LEAST_DEVIATION: f64 = 2e-3;
/// A parameter that changes the residuals by less than this part of the forces is not determined:
/// the differences are rounding.
const NO_INFLUENCE: f64 = 1e-5;
/// A relative standard error above which a number is hardly one.
const HARDLY: f64 = 0.25;

/// Why nothing was fitted.
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

/// What is fitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FitOptions {
    /// A factor of the initial slope too: the creepages count that many times, as where a layer or
    /// rough surfaces yield besides the bodies.
    pub slope: bool,
}

/// A number found, and how uncertain it is.
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

/// Cautions about a fit.
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

/// The points as residuals.
struct Problem<'a> {
    model: &'a Model,
    /// Measured forces (N) and the unit of their residuals (N).
    measured: Vec<([Option<f64>; 2], f64)>,
    used: Vec<bool>,
    go_on: &'a mut dyn FnMut() -> bool,
}

impl Problem<'_> {
    fn predicted(&mut self, at: &[f64]) -> Result<Vec<Predicted>, FitError> {
        if !(self.go_on)() {
            return Err(FitError::Interrupted);
        }
        self.model.forces(at[0].exp(), at.get(1).map_or(1.0, |slope| slope.exp()))
    }

    /// Residuals of the points that count.
    fn residuals(&mut self, at: &[f64]) -> Result<Vec<f64>, FitError> {
        let predicted = self.predicted(at)?;
        let points = predicted.iter().zip(&self.measured).zip(&self.used);
        let points = points.filter(|(_, used)| **used).map(|(point, _)| point);
        Ok(points
            .flat_map(|(found, (measured, unit))| residuals_of(found, *measured, *unit))
            .collect())
    }
}

fn residuals_of(
    found: &Predicted,
    measured: [Option<f64>; 2],
    unit: f64,
) -> impl Iterator<Item = f64> {
    let both = measured.into_iter().zip(found.force);
    both.filter_map(move |(measured, found)| Some((found - measured?) / unit))
}

impl Fit {
    /// Fits the case of a file to points, by a theory; what the table has is the table's, all else the
    /// case's. `go_on` is asked before each evaluation of all points, and stops the work by `false`.
    ///
    /// # Errors
    /// [`FitError`] for what is no case, too few points, and points that say nothing of what is wanted.
    pub fn new(
        file: &AnyCaseFile,
        directory: &Path,
        theory: &TheorySpec,
        measured: &MeasuredPoints,
        options: FitOptions,
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Self, FitError> {
        let model = Model::new(file, directory, theory, measured)?;
        let unit_of = |point: &super::MeasuredPoint, load: f64| {
            let in_newtons = if measured.over_normal { load } else { 1.0 };
            point.uncertainty.map_or(load, |uncertainty| uncertainty * in_newtons)
        };
        let rows = || measured.points.iter().zip(&model.loads);
        let forces: Vec<_> = rows()
            .map(|(point, load)| (measured.newtons(point, *load), unit_of(point, *load)))
            .collect();
        let has_uncertainty = measured.points.iter().any(|point| point.uncertainty.is_some());
        let count = forces.iter().flat_map(|(force, _)| force).flatten().count();
        let (wanted, parameters) =
            if options.slope { ("friction and slope", 2) } else { ("friction", 1) };
        if count < parameters + 2 {
            return Err(FitError::TooFew { given: count, wanted, least: parameters + 2 });
        }
        let over_load = rows().zip(&forces).map(|((_, load), (force, _))| {
            force.iter().flatten().fold(0.0, |sum: f64, part| sum.hypot(*part)) / load
        });
        let top = over_load.fold(0.0, f64::max);
        if top == 0.0 {
            return Err(FitError::NoForce);
        }
        let least = if has_uncertainty { 1.0 } else { LEAST_DEVIATION * top };
        let used = vec![true; forces.len()];
        let mut problem = Problem { model: &model, measured: forces, used, go_on };
        let start = start(&mut problem, top, options.slope)?;
        let found = settle(&mut problem, start, least, top)?;
        Self::of(theory.facts().name, &mut problem, &found, (least, has_uncertainty), measured)
    }

    fn of(
        theory: &'static str,
        problem: &mut Problem,
        found: &Minimum,
        (least, has_uncertainty): (f64, bool),
        table: &MeasuredPoints,
    ) -> Result<Self, FitError> {
        let parameters = found.at.len();
        let degrees_of_freedom = found.residuals.len().saturating_sub(parameters);
        if degrees_of_freedom == 0 {
            let (given, least) = (found.residuals.len(), parameters + 1);
            return Err(FitError::TooFew { given, wanted: "what is wanted", least });
        }
        let variance =
            found.residuals.iter().map(|r| r * r).sum::<f64>() / degrees_of_freedom as f64;
        // Points that scatter less than their uncertainty say no more than that.
        let of_points = if has_uncertainty { variance.max(1.0) } else { variance };
        let undetermined = FitError::Undetermined {
            what: "friction and slope apart",
            why: "any larger friction with another slope fits as well; points near sliding are needed",
        };
        let cofactors = found.cofactors().ok_or(undetermined)?;
        let student = student_95(degrees_of_freedom);
        let fitted = |k: usize| {
            let (value, error) = (found.at[k].exp(), (of_points * cofactors[k][k]).sqrt());
            let interval = [-1.0, 1.0].map(|sign| value * (sign * student * error).exp());
            Fitted { value, standard_error: value * error, interval }
        };
        let slope = (parameters == 2).then(|| fitted(1));
        let correlation =
            slope.map(|_| cofactors[0][1] / (cofactors[0][0] * cofactors[1][1]).sqrt());
        let deviation = robust_deviation(&found.residuals, least);
        let predicted = problem.predicted(&found.at)?;
        let model = problem.model;
        let points: Vec<_> = predicted
            .iter()
            .enumerate()
            .map(|(k, predicted)| {
                let (measured, unit) = problem.measured[k];
                let farthest =
                    residuals_of(predicted, measured, unit).fold(0.0, |m: f64, r| m.max(r.abs()));
                FittedPoint {
                    row: table.points[k].row,
                    creepage: model.creepages[k],
                    normal_force: model.loads[k],
                    measured,
                    fitted: predicted.force,
                    deviations: farthest / deviation,
                    bad: !problem.used[k],
                    status: predicted.status,
                }
            })
            .collect();
        let counting = || predicted.iter().zip(&points).filter(|(_, point)| !point.bad);
        let reached = counting().map(|(predicted, _)| predicted.share).fold(0.0, f64::max);
        let squares = counting().flat_map(|(predicted, point)| {
            residuals_of(predicted, point.measured, point.normal_force).map(|r| r * r)
        });
        let scatter = (squares.sum::<f64>() / found.residuals.len() as f64).sqrt();
        let friction = fitted(0);
        let mut fit = Self {
            theory,
            friction,
            slope,
            correlation,
            points,
            scatter,
            degrees_of_freedom,
            reached,
            cautions: Vec::new(),
            curve: None,
        };
        fit.cautions = fit.held_against(if has_uncertainty { variance.sqrt() } else { 0.0 });
        fit.curve = fit.along(model)?;
        Ok(fit)
    }

    fn held_against(&self, scatter: f64) -> Vec<FitCaution> {
        /// A force below this part of `mu N` leaves the height of the curve open.
        const NEAR_SLIDING: f64 = 0.8;
        /// Scatter so many times the uncertainty is none of chance.
        const MUCH: f64 = 1.5;
        let bad = self.points.iter().filter(|point| point.bad);
        let mut cautions: Vec<_> = bad
            .map(|point| FitCaution::Bad { row: point.row, deviations: point.deviations })
            .collect();
        let numbers = [("mu", Some(self.friction)), ("the factor of the slope", self.slope)];
        for (what, fitted) in numbers {
            let part = fitted.map_or(0.0, |fitted| fitted.standard_error / fitted.value);
            if part > HARDLY {
                cautions.push(FitCaution::Hardly { what, part });
            }
        }
        if self.reached < NEAR_SLIDING {
            cautions.push(FitCaution::FarFromSliding { share: self.reached });
        }
        if scatter > MUCH {
            cautions.push(FitCaution::Scatter { factor: scatter });
        }
        let mut statuses: Vec<Status> = Vec::new();
        for point in self.points.iter().filter(|point| point.status != Status::Solved) {
            if !statuses.contains(&point.status) {
                statuses.push(point.status);
            }
        }
        cautions.extend(statuses.into_iter().map(|status| {
            let rows = self.points.iter().filter(|point| point.status == status);
            FitCaution::Status { status, rows: rows.map(|point| point.row).collect() }
        }));
        cautions
    }

    /// The theory between the points, where they lie on one curve.
    fn along(&self, model: &Model) -> Result<Option<FittedCurve>, FitError> {
        const POINTS: u32 = 120;
        let component = |si: SiCreepage, k: usize| [si.longitudinal, si.lateral, si.spin][k];
        let Some(first) = self.points.first() else { return Ok(None) };
        let differs = |k: &usize| {
            self.points.iter().any(|one| {
                component(one.creepage, *k).to_bits() != component(first.creepage, *k).to_bits()
            })
        };
        let varying: Vec<_> = (0..3).filter(differs).collect();
        let one_load = self
            .points
            .iter()
            .all(|one| one.normal_force.to_bits() == first.normal_force.to_bits());
        let ([k], true) = (&varying[..], one_load) else { return Ok(None) };
        let values = || self.points.iter().map(|one| component(one.creepage, *k));
        let (low, high) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
        let at = |value: f64| {
            let mut si = first.creepage;
            *[&mut si.longitudinal, &mut si.lateral, &mut si.spin][*k] = value;
            (si, first.normal_force)
        };
        let xs: Vec<_> =
            (0..=POINTS).map(|i| low + (high - low) * f64::from(i) / f64::from(POINTS)).collect();
        let asked: Vec<_> = xs.iter().map(|x| at(*x)).collect();
        let slope = self.slope.map_or(1.0, |slope| slope.value);
        let found = model.at(self.friction.value, slope, &asked)?;
        let points = xs.iter().zip(&found).map(|(x, found)| [*x, found.force[0], found.force[1]]);
        Ok(Some(FittedCurve { component: *k, points: points.collect() }))
    }
}

/// The best of a few values, by the sum of sizes, which bad points move little.
fn start(problem: &mut Problem, top: f64, slope: bool) -> Result<Vec<f64>, FitError> {
    let [low, high] = SEARCHED.map(|factor| (factor * top).ln());
    let slopes = if slope { &SLOPES[..] } else { &[1.0][..] };
    let mut best: Option<(f64, Vec<f64>)> = None;
    for k in 0..STARTS {
        let mu = low + (high - low) * f64::from(k) / f64::from(STARTS - 1);
        for factor in slopes {
            let at = if slope { vec![mu, factor.ln()] } else { vec![mu] };
            let cost: f64 = problem.residuals(&at)?.iter().map(|residual| residual.abs()).sum();
            if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                best = Some((cost, at));
            }
        }
    }
    Ok(best.map_or_else(|| vec![top.ln()], |(_, at)| at))
}

/// Least squares over the points that belong together.
fn settle(
    problem: &mut Problem,
    start: Vec<f64>,
    least: f64,
    top: f64,
) -> Result<Minimum, FitError> {
    let robust = minimize(&mut |at: &[f64]| problem.residuals(at), start, Some(least))?;
    let mut at = check(problem, robust, top)?.at;
    for _ in 0..MAX_ROUNDS {
        let all = problem.predicted(&at)?;
        let found: Vec<Vec<f64>> = all
            .iter()
            .zip(&problem.measured)
            .map(|(found, (measured, unit))| residuals_of(found, *measured, *unit).collect())
            .collect();
        let counting: Vec<f64> = found
            .iter()
            .zip(&problem.used)
            .filter(|(_, used)| **used)
            .flat_map(|(residuals, _)| residuals.clone())
            .collect();
        let limit = BAD * robust_deviation(&counting, least);
        let belongs = |residuals: &Vec<f64>| residuals.iter().all(|r| r.abs() <= limit);
        let used: Vec<_> = found.iter().map(belongs).collect();
        let is_settled = used == problem.used;
        problem.used = used;
        let minimum = minimize(&mut |at: &[f64]| problem.residuals(at), at, None)?;
        let minimum = check(problem, minimum, top)?;
        if is_settled {
            return Ok(minimum);
        }
        at = minimum.at;
    }
    let minimum = minimize(&mut |at: &[f64]| problem.residuals(at), at, None)?;
    check(problem, minimum, top)
}

/// Each parameter must matter, and friction lie where it was looked for.
fn check(problem: &mut Problem, found: Minimum, top: f64) -> Result<Minimum, FitError> {
    let size = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>().sqrt();
    let predicted = problem.predicted(&found.at)?;
    let scale: Vec<f64> = predicted
        .iter()
        .zip(&problem.measured)
        .flat_map(|(found, (_, unit))| found.force.map(|force| force / unit))
        .collect();
    let matters = |k: usize| size(&found.jacobian[k]) > NO_INFLUENCE * size(&scale);
    let in_range = found.at[0].exp() < SEARCHED[1] * top;
    if !matters(0) || !in_range {
        let why = "they lie so far below sliding that any larger value fits as well";
        return Err(FitError::Undetermined { what: "mu", why });
    }
    if found.at.len() == 2 && !matters(1) {
        let why = "all of them slide fully";
        return Err(FitError::Undetermined { what: "the slope", why });
    }
    Ok(found)
}
