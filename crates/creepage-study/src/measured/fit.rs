//! Fit of the coefficient of friction, and of the initial slope, to measured forces.

use std::path::Path;

use creepage::{SiCreepage, Status, TheorySpec};

use super::fitted::{Fit, FitCaution, FitError, FitOptions, Fitted, FittedCurve, FittedPoint};
use super::least_squares::{Minimum, minimize, robust_deviation, student_95};
use super::model::{Model, Predicted};
use super::points::MeasuredPoints;
use crate::{AnyCaseFile, Caution};

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
/// Coefficients of friction that dry bodies have: superlubricity lies below, no pair of bodies above.
const FRICTION: [f64; 2] = [1e-3, Caution::FRICTION];
/// A relative standard error above which a number is hardly one.
const MAX_RELATIVE_ERROR: f64 = 0.25;

/// The points as residuals.
struct Problem<'a> {
    model: &'a Model,
    /// Measured forces (N) and the unit of their residuals (N).
    measured: Vec<([Option<f64>; 2], f64)>,
    used: Vec<bool>,
    proceeds: &'a mut dyn FnMut() -> bool,
}

impl Problem<'_> {
    fn predicted(&mut self, at: &[f64]) -> Result<Vec<Predicted>, FitError> {
        if !(self.proceeds)() {
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
    /// case's. `proceeds` is asked before each evaluation of all points, and stops the work by `false`.
    ///
    /// # Errors
    /// [`FitError`] for what is no case, too few points, and points that say nothing of what is wanted.
    pub fn new(
        file: &AnyCaseFile,
        directory: &Path,
        theory: &TheorySpec,
        measured: &MeasuredPoints,
        options: FitOptions,
        proceeds: &mut dyn FnMut() -> bool,
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
        let slips =
            |si: &SiCreepage| [si.longitudinal, si.lateral, si.spin].iter().any(|c| *c != 0.0);
        if !model.creepages.iter().any(slips) {
            return Err(FitError::NoCreepage);
        }
        let least = if has_uncertainty { 1.0 } else { LEAST_DEVIATION * top };
        let used = vec![true; forces.len()];
        let mut problem = Problem { model: &model, measured: forces, used, proceeds };
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
            if part > MAX_RELATIVE_ERROR {
                cautions.push(FitCaution::Hardly { what, part });
            }
        }
        let [least, most] = FRICTION;
        let value = self.friction.value;
        if !(least..=most).contains(&value) {
            cautions.push(FitCaution::Friction { value });
        }
        let large = self.points.iter().find_map(|point| {
            let caution = Caution::large_creepage(point.creepage).next()?;
            Some(FitCaution::Creepage { row: point.row, caution })
        });
        cautions.extend(large);
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
        const CURVE_POINTS: u32 = 120;
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
        let xs: Vec<_> = (0..=CURVE_POINTS)
            .map(|i| low + (high - low) * f64::from(i) / f64::from(CURVE_POINTS))
            .collect();
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
        let mut used: Vec<_> = found.iter().map(belongs).collect();
        let left: usize =
            found.iter().zip(&used).map(|(r, used)| if *used { r.len() } else { 0 }).sum();
        if left < at.len() + 2 {
            // Too few would be left to tell a bad point by.
            used.fill(true);
        }
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
        let along: f64 = predicted
            .iter()
            .zip(&problem.measured)
            .flat_map(|(found, (measured, _))| found.force.into_iter().zip(*measured))
            .filter_map(|(found, measured)| Some(found * measured?))
            .sum();
        if along < 0.0 {
            let why = "forces have the sign opposite to that of the theory: they are to be those on the lower body";
            return Err(FitError::Undetermined { what: "mu", why });
        }
        if top > Caution::FRICTION {
            return Err(FitError::BeyondFriction { share: top });
        }
        let why = "they lie so far below sliding that any larger value fits as well";
        return Err(FitError::Undetermined { what: "mu", why });
    }
    if found.at.len() == 2 && !matters(1) {
        let why = "all of them slide fully";
        return Err(FitError::Undetermined { what: "the slope", why });
    }
    Ok(found)
}
