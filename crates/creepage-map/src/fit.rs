//! The two ellipses whose creep forces are those of a contact: nine numbers by least squares
//! (Levenberg and Marquardt), then six of the moment, which are linear.

use creepage::table::Table;
use creepage::{Creepage, InvalidValue};
use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use crate::error::MapError;
use crate::patch::Ellipse;

/// Force of the full theory at one creepage, to which ellipses are fitted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Creepage along and across, and spin (rad/m), over the coefficient of friction.
    pub creepage: [f64; 3],
    /// Force along and across over `mu N`, moment about the reference point over `mu N` (m).
    pub force: [f64; 3],
    /// How much its tangential force counts against that of others.
    pub weight: f64,
    /// Creepage at which the force is taken off: then it is the difference that is to be met, a slope of
    /// the force.
    pub from: Option<[f64; 3]>,
}

impl Sample {
    /// A force, which counts once.
    #[must_use]
    pub fn new(creepage: [f64; 3], force: [f64; 3]) -> Self {
        Self { creepage, force, weight: 1.0, from: None }
    }
}

/// Start of a fit: a contact's outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contour {
    /// Dimensionless creepage over creepage, and spin over spin (m), times the coefficient of friction: as of
    /// the contact's own scaling.
    pub scale: [f64; 2],
    /// Length along (m).
    pub length: f64,
    /// From where to where it reaches across, from the reference point (m).
    pub across: [f64; 2],
}

/// Fitted ellipses and their residual.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// The ellipses.
    pub ellipses: [Ellipse; 2],
    /// Root mean square of what is left of the tangential force over the samples, in parts of `mu N`.
    pub residual: f64,
    /// The same of the moment, in parts of `mu N` and of the length that goes with the contact (m).
    pub moment_residual: f64,
}

/// `ln r`, `ln k_x`, `ln k_p`, `s` over a length, of both ellipses; `logit w`.
type Numbers = SVector<f64, 9>;
/// Bounds of the ratio of axes, as parts of the table's.
const MARGIN: f64 = 1.02;
/// Largest `logit w`.
const LOGIT: f64 = 4.0;

struct Problem<'a> {
    table: &'a Table,
    poisson: f64,
    samples: &'a [Sample],
    /// Unit of `s` (m).
    length: f64,
    /// Logarithms.
    ratios: [f64; 2],
    /// Logarithms of `k_x` and `k_p` from which the fit starts.
    scales: [f64; 2],
    /// Bounds of `s` in its unit: as far beyond the area as this is wide.
    offsets: [f64; 2],
}

/// How far `ln k_x` and `ln k_p` may go from their start: beyond, an ellipse slides at any creepage or at none.
const SCALE: f64 = 3.0;

/// Fits two ellipses to samples, from several starts; the best one.
///
/// # Errors
/// [`MapError::Invalid`] where Poisson's ratio is not in the table, [`MapError::Senseless`] for fewer than 9
/// samples or numbers that are not finite.
pub fn fit(
    table: &Table,
    poisson: f64,
    samples: &[Sample],
    contour: &Contour,
) -> Result<Fit, MapError> {
    let axis = table.a_over_b();
    let [low, high] = contour.across;
    let finite = samples.iter().flat_map(|s| s.creepage.iter().chain(&s.force).chain([&s.weight]));
    let is_good = samples.len() >= 9
        && finite.copied().all(f64::is_finite)
        && high > low
        && contour.length > 0.0
        && contour.scale.iter().all(|scale| *scale > 0.0 && scale.is_finite());
    if !is_good {
        return Err(MapError::Senseless("samples"));
    }
    if axis.high <= MARGIN.powi(2) * axis.low {
        let valid = "a range in the table of ellipses, not one value";
        return Err(InvalidValue { quantity: "a_over_b", value: axis.high, valid }.into());
    }
    let length = (contour.length * (high - low)).sqrt();
    let ratios = [(axis.low * MARGIN).ln(), (axis.high / MARGIN).ln()];
    let scales = contour.scale.map(f64::ln);
    let offsets = [(2.0 * low - high) / length, (2.0 * high - low) / length];
    let problem = Problem { table, poisson, samples, length, ratios, scales, offsets };
    let [kx, kp] = scales;
    let shape = (contour.length / (high - low)).ln();
    let two = |s: [f64; 2], shape: f64| {
        Numbers::from([shape, kx, kp, s[0] / length, shape, kx, kp, s[1] / length, 0.0])
    };
    // One ellipse, from three shapes; then two, from it and from lobes on either side.
    let single = |shape: f64| problem.solve(two([0.0; 2], shape), 4);
    let mut best: Option<(Numbers, f64)> = None;
    let mut keep = |found: (Numbers, f64)| {
        if best.as_ref().is_none_or(|best| found.1 < best.1) {
            best = Some(found);
        }
        best
    };
    let mut one = None;
    for more in [-0.7, 0.2, 0.9] {
        one = keep(single(shape + more)?);
    }
    if let Some((one, _)) = one {
        let mut start = one;
        start[3] -= 3e-4 / length;
        for k in 0..4 {
            start[4 + k] = one[k];
        }
        start[7] += 3e-4 / length;
        keep(problem.solve(start, 9)?);
    }
    for s in [[0.5 * low, 0.5 * high], [low / 3.0, 0.7 * high], [0.7 * low, high / 3.0]] {
        keep(problem.solve(two(s, 1.6_f64.ln()), 9)?);
    }
    let (numbers, _) = best.ok_or(MapError::Senseless("samples"))?;
    problem.finish(&numbers)
}

impl Problem<'_> {
    fn bounded(&self, mut numbers: Numbers) -> Numbers {
        for k in [0, 4] {
            numbers[k] = numbers[k].clamp(self.ratios[0], self.ratios[1]);
            for (scale, start) in self.scales.into_iter().enumerate() {
                let scale = &mut numbers[k + 1 + scale];
                *scale = scale.clamp(start - SCALE, start + SCALE);
            }
            numbers[k + 3] = numbers[k + 3].clamp(self.offsets[0], self.offsets[1]);
        }
        numbers[8] = numbers[8].clamp(-LOGIT, LOGIT);
        numbers
    }

    fn ellipses(&self, numbers: &Numbers) -> [Ellipse; 2] {
        let weight = (1.0 + (-numbers[8]).exp()).recip();
        [(0, weight), (4, 1.0 - weight)].map(|(k, weight)| Ellipse {
            ratio: numbers[k].exp(),
            by_creepage: numbers[k + 1].exp(),
            by_spin: numbers[k + 2].exp(),
            offset: numbers[k + 3] * self.length,
            weight,
            ..Ellipse::default()
        })
    }

    /// Force and moment of an ellipse at a sample, and their derivatives by `ln k_x`, `ln k_p`, `s`.
    fn of(
        &self,
        ellipse: &Ellipse,
        sample: &Sample,
    ) -> Result<([f64; 3], [[f64; 3]; 3]), MapError> {
        let (mut force, mut slopes) = self.at(ellipse, sample.creepage)?;
        if let Some(from) = sample.from {
            let (less, slopes_less) = self.at(ellipse, from)?;
            for i in 0..3 {
                force[i] -= less[i];
                for k in 0..3 {
                    slopes[i][k] -= slopes_less[i][k];
                }
            }
        }
        Ok((force, slopes))
    }

    fn at(
        &self,
        ellipse: &Ellipse,
        [ux, uy, spin]: [f64; 3],
    ) -> Result<([f64; 3], [[f64; 3]; 3]), MapError> {
        let Ellipse { ratio, by_creepage, by_spin, offset, .. } = *ellipse;
        let xi = by_creepage * (ux - spin * offset);
        let (eta, chi) = (by_creepage * uy, by_spin * spin);
        let slice = self.table.at(ratio, self.poisson)?;
        let (force, by) = slice.force_and_derivative(Creepage::new(xi, eta, chi)?);
        let slopes = [0, 1, 2].map(|i: usize| {
            let shift = -by[i][0] * by_creepage * spin * self.length;
            [by[i][0] * xi + by[i][1] * eta, by[i][2] * chi, shift]
        });
        Ok((force.components(), slopes))
    }

    /// What is left of the tangential force at each sample, and its derivatives.
    fn linearized(&self, numbers: &Numbers) -> Result<(DVector<f64>, DMatrix<f64>), MapError> {
        const DIFFERENCE_STEP: f64 = 1e-4;
        let ellipses = self.ellipses(numbers);
        let rows = 2 * self.samples.len();
        let (mut left, mut by) = (DVector::zeros(rows), DMatrix::zeros(rows, 9));
        for (n, sample) in self.samples.iter().enumerate() {
            let mut forces = [[0.0; 3]; 2];
            for (e, ellipse) in ellipses.iter().enumerate() {
                let (force, slopes) = self.of(ellipse, sample)?;
                // Along the ratio by a difference, towards the middle of its range.
                let ratio = numbers[4 * e];
                let step = if ratio > self.ratios[0].midpoint(self.ratios[1]) {
                    -DIFFERENCE_STEP
                } else {
                    DIFFERENCE_STEP
                };
                let share = sample.weight * ellipse.weight;
                let beside = Ellipse { ratio: (ratio + step).exp(), ..*ellipse };
                let (moved, _) = self.of(&beside, sample)?;
                for i in 0..2 {
                    let row = 2 * n + i;
                    by[(row, 4 * e)] = share * (moved[i] - force[i]) / step;
                    for k in 0..3 {
                        by[(row, 4 * e + 1 + k)] = share * slopes[i][k];
                    }
                }
                forces[e] = force;
            }
            let [one, other] = ellipses.map(|ellipse| ellipse.weight);
            let parts = forces[0].into_iter().zip(forces[1]).zip(sample.force);
            for (i, ((first, second), wanted)) in parts.take(2).enumerate() {
                let row = 2 * n + i;
                left[row] = sample.weight * (one * first + other * second - wanted);
                by[(row, 8)] = sample.weight * one * other * (first - second);
            }
        }
        Ok((left, by))
    }

    fn squares(&self, numbers: &Numbers) -> Result<f64, MapError> {
        let ellipses = self.ellipses(numbers);
        let mut sum = 0.0;
        for sample in self.samples {
            let [one, other] = [self.of(&ellipses[0], sample)?.0, self.of(&ellipses[1], sample)?.0];
            for i in 0..2 {
                let force = ellipses[0].weight * one[i] + ellipses[1].weight * other[i];
                sum += (sample.weight * (force - sample.force[i])).powi(2);
            }
        }
        Ok(sum)
    }

    /// Levenberg and Marquardt in the first `free` numbers; with four, both ellipses are one.
    fn solve(&self, start: Numbers, free: usize) -> Result<(Numbers, f64), MapError> {
        const MAX_FIT_STEPS: usize = 60;
        const SMALL: f64 = 1e-4;
        let same = |mut numbers: Numbers| {
            if free == 4 {
                for k in 0..4 {
                    numbers[4 + k] = numbers[k];
                }
            }
            self.bounded(numbers)
        };
        let mut at = same(start);
        let mut squares = self.squares(&at)?;
        let mut damping = 1e-3;
        for _ in 0..MAX_FIT_STEPS {
            let (left, mut by) = self.linearized(&at)?;
            if free == 4 {
                for k in 0..4 {
                    let both = by.column(k) + by.column(4 + k);
                    by.set_column(k, &both);
                    by.column_mut(4 + k).fill(0.0);
                }
                by.column_mut(8).fill(0.0);
            }
            let normal = by.tr_mul(&by);
            let gradient = by.tr_mul(&left);
            let mut gained = None;
            while damping < 1e8 {
                let mut damped = SMatrix::<f64, 9, 9>::from_fn(|i, j| normal[(i, j)]);
                for k in 0..9 {
                    damped[(k, k)] += damping * damped[(k, k)].max(1e-6);
                }
                let right = SVector::<f64, 9>::from_fn(|k, _| -gradient[k]);
                let Some(factor) = damped.cholesky() else { break };
                let next = same(at + factor.solve(&right));
                // A step out of what the table takes is too long.
                let found = self.squares(&next).unwrap_or(f64::INFINITY);
                if found < squares {
                    gained = Some((squares - found) / squares);
                    (at, squares) = (next, found);
                    damping = (damping * 0.2).max(1e-12);
                    break;
                }
                damping *= 5.0;
            }
            match gained {
                Some(gained) if gained > SMALL => {}
                _ => break,
            }
        }
        Ok((at, squares))
    }

    /// With the moment's numbers.
    fn finish(&self, numbers: &Numbers) -> Result<Fit, MapError> {
        let mut ellipses = self.ellipses(numbers);
        let count = self.samples.len();
        let mut by = DMatrix::zeros(count + 6, 6);
        let mut right = DVector::zeros(count + 6);
        for (n, sample) in self.samples.iter().enumerate() {
            for (e, ellipse) in ellipses.iter().enumerate() {
                let ([fx, fy, mz], _) = self.of(ellipse, sample)?;
                for (k, part) in [mz, fx, fy].into_iter().enumerate() {
                    by[(n, 3 * e + k)] = part;
                }
            }
            right[n] = sample.force[2] / self.length;
        }
        // A little towards zero: where both ellipses are one, their numbers are not told apart.
        for k in 0..6 {
            by[(count + k, k)] = 1e-4;
        }
        let solved = by.clone().svd(true, true).solve(&right, 1e-12);
        let solved = solved.map_err(|_| MapError::Senseless("samples"))?;
        let left = &by * &solved - &right;
        for (e, ellipse) in ellipses.iter_mut().enumerate() {
            ellipse.moment = [0, 1, 2].map(|k| solved[3 * e + k] * self.length);
        }
        let mean = |squares: f64| (squares / count as f64).sqrt();
        let moment_residual = mean(left.rows(0, count).norm_squared()) * self.length;
        let mut squares = 0.0;
        for sample in self.samples {
            let [one, other] = [self.of(&ellipses[0], sample)?.0, self.of(&ellipses[1], sample)?.0];
            let [first, second] = ellipses.map(|ellipse| ellipse.weight);
            let left = |i: usize| first * one[i] + second * other[i] - sample.force[i];
            squares += left(0).powi(2) + left(1).powi(2);
        }
        Ok(Fit { ellipses, residual: mean(squares), moment_residual })
    }
}
