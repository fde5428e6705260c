//! Residual and Jacobian of the strip system: displacement less depth at their points, and its derivatives
//! by the unknowns.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};
use pulp::{Arch, Simd, WithSimd};

use super::rules::{CENTRED, MAX_TERMS};
use super::sources::Sources;
use super::strip::Strip;
use crate::numerics::simd_math::LANES;

/// The depth of undeformed penetration, at x and y in the solver's units.
pub(crate) type Depth<'a> = &'a dyn Fn(f64, f64) -> f64;

/// A step: what is subtracted from the unknowns, and what is added to the depth.
pub(super) struct Step {
    pub(super) unknowns: DVector<f64>,
    pub(super) deeper: f64,
}

/// Strips in contact, their unknowns and equations.
pub(super) struct System {
    pub(super) strips: Vec<Strip>,
    pub(super) terms: usize,
    /// Of each strip, over its half length.
    pub(super) points: Vec<f64>,
    /// What is added to the depth.
    pub(super) deeper: f64,
}

/// Zeros of Chebyshev's polynomial: as many as a strip has unknowns. Of a symmetric strip those to one
/// side are enough.
pub(super) fn points(terms: usize) -> Vec<f64> {
    let count = if terms == CENTRED { 4 } else { terms + 2 };
    zeros(count).filter(|zero| terms != CENTRED || *zero > 0.0).collect()
}

/// Zeros of Chebyshev's polynomial of a degree.
pub(super) fn zeros(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| -((2 * i + 1) as f64 * PI / (2 * count) as f64).cos())
}

/// Displacement less depth at the points of all strips, and with `SLOPES` its derivatives by the
/// unknowns, a row a point.
struct Evaluate<'a, const T: usize, const SLOPES: bool> {
    system: &'a System,
    depth: Depth<'a>,
    residual: &'a mut [f64],
    rows: &'a mut [f64],
}

impl<const T: usize, const SLOPES: bool> WithSimd for Evaluate<'_, T, SLOPES> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { system, depth, residual, rows } = self;
        let (all, total) = (Sources::all(&system.strips), residual.len());
        for (i, strip) in system.strips.iter().enumerate() {
            for (l, &s) in system.points.iter().enumerate() {
                let at = i * system.size() + l;
                let start = if SLOPES { at * total } else { 0 };
                let row = if SLOPES { &mut rows[start..start + total] } else { &mut [][..] };
                residual[at] = system.row::<T, SLOPES>(&all, [i, l], depth, row)
                    - depth(strip.centre + strip.half * s, strip.y)
                    - system.deeper;
            }
        }
    }
}

/// Displacement less depth at all points of the strips from `first` on, and its derivatives by
/// their pressures.
struct ByPressures<'a, const T: usize> {
    system: &'a System,
    depth: Depth<'a>,
    first: usize,
}

impl<const T: usize> WithSimd for ByPressures<'_, T> {
    type Output = (DMatrix<f64>, DVector<f64>);

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        let Self { system, depth, first } = self;
        let (all, size) = (Sources::all(&system.strips), system.size());
        let own = &system.strips[first..];
        let mut matrix = DMatrix::zeros(T * own.len(), T * own.len());
        let mut residual = DVector::zeros(T * own.len());
        let mut row = vec![0.0; system.strips.len() * size];
        for (i, strip) in own.iter().enumerate() {
            for (l, &s) in system.points.iter().enumerate() {
                row.fill(0.0);
                let at = T * i + l;
                residual[at] = system.row::<T, false>(&all, [first + i, l], depth, &mut row)
                    - depth(strip.centre + strip.half * s, strip.y)
                    - system.deeper;
                for (j, by_source) in row[first * size..].chunks_exact(size).enumerate() {
                    for (k, by_pressure) in by_source[..T].iter().enumerate() {
                        matrix[(at, T * j + k)] = *by_pressure;
                    }
                }
            }
        }
        (matrix, residual)
    }
}

impl System {
    /// The strips from `first` on with pressures by which they sink as deep as they should at as
    /// many points, all ends and the pressures of the other strips held.
    pub(super) fn with_pressures(&self, first: usize, depth: Depth<'_>) -> Option<Vec<Strip>> {
        let (system, arch) = (self, Arch::new());
        let (matrix, residual) = match self.terms {
            CENTRED => arch.dispatch(ByPressures::<1> { system, depth, first }),
            2 => arch.dispatch(ByPressures::<2> { system, depth, first }),
            4 => arch.dispatch(ByPressures::<4> { system, depth, first }),
            _ => arch.dispatch(ByPressures::<MAX_TERMS> { system, depth, first }),
        };
        let less = matrix.lu().solve(&residual)?;
        let own = self.strips[first..].iter().zip(less.as_slice().chunks_exact(self.terms));
        let strips = own.map(|(strip, less)| {
            let mut strip = *strip;
            for (pressure, less) in strip.pressure.iter_mut().zip(less) {
                *pressure -= less;
            }
            strip
        });
        Some(strips.collect())
    }

    /// Unknowns of a strip: its pressures, its centre in half lengths unless that is known, the
    /// logarithm of its half length.
    pub(super) fn size(&self) -> usize {
        self.terms + self.lengths()
    }

    /// Those of the unknowns that are lengths.
    fn lengths(&self) -> usize {
        if self.terms == CENTRED { 1 } else { 2 }
    }

    pub(super) fn residual(&self, depth: Depth<'_>) -> DVector<f64> {
        let mut residual = DVector::zeros(self.strips.len() * self.size());
        let (system, out) = (self, residual.as_mut_slice());
        let arch = Arch::new();
        let rows = &mut [][..];
        match self.terms {
            CENTRED => arch.dispatch(Evaluate::<1, false> { system, depth, residual: out, rows }),
            2 => arch.dispatch(Evaluate::<2, false> { system, depth, residual: out, rows }),
            4 => arch.dispatch(Evaluate::<4, false> { system, depth, residual: out, rows }),
            _ => arch.dispatch(Evaluate::<MAX_TERMS, false> { system, depth, residual: out, rows }),
        }
        residual
    }

    /// The residual and its derivatives, a row a point.
    pub(super) fn linearized(&self, depth: Depth<'_>) -> (DVector<f64>, Vec<f64>) {
        let total = self.strips.len() * self.size();
        let mut residual = DVector::zeros(total);
        let mut matrix = vec![0.0; total * total];
        let (system, out, rows) = (self, residual.as_mut_slice(), &mut matrix[..]);
        let arch = Arch::new();
        match self.terms {
            CENTRED => arch.dispatch(Evaluate::<1, true> { system, depth, residual: out, rows }),
            2 => arch.dispatch(Evaluate::<2, true> { system, depth, residual: out, rows }),
            4 => arch.dispatch(Evaluate::<4, true> { system, depth, residual: out, rows }),
            _ => arch.dispatch(Evaluate::<MAX_TERMS, true> { system, depth, residual: out, rows }),
        }
        (residual, matrix)
    }

    /// Displacement at point `l` of strip `i`. Its derivatives by the pressures are added to `row`
    /// unless that is empty, and with `SLOPES` those of the residual by the lengths too.
    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn row<const T: usize, const SLOPES: bool>(
        &self,
        all: &[Sources<T>],
        [i, l]: [usize; 2],
        depth: Depth<'_>,
        row: &mut [f64],
    ) -> f64 {
        let (strip, s, size) =
            (&self.strips[i], self.points[l], T + if T == CENTRED { 1 } else { 2 });
        let x = strip.centre + strip.half * s;
        let (mut displacement, mut slope) = (0.0, 0.0);
        for (block, sources) in all.iter().enumerate() {
            let first = block * LANES;
            let own = i.checked_sub(first).filter(|own| *own < sources.count());
            let found = sources.displacements::<SLOPES>([x, strip.y], own);
            displacement += sources.sum(&found);
            if !row.is_empty() {
                slope += sources.add_to::<SLOPES>(&mut row[first * size..], x, &found);
            }
        }
        if SLOPES {
            const DIFFERENCE_STEP: f64 = 1e-3;
            let h = DIFFERENCE_STEP * strip.half;
            slope -= (depth(x + h, strip.y) - depth(x - h, strip.y)) / (2.0 * h);
            if T != CENTRED {
                row[i * size + T] += slope * strip.half;
            }
            row[(i + 1) * size - 1] += slope * strip.half * s;
        }
        displacement
    }

    /// How far a step may go: no half length changes by more than a third, no centre moves
    /// further. `None` when the step is not a number.
    pub(super) fn longest(&self, step: &DVector<f64>) -> Option<f64> {
        const MAX_CHANGE: f64 = 0.35;
        let size = self.size();
        let lengths = step.as_slice().chunks_exact(size).flat_map(|own| &own[self.terms..]);
        let largest = lengths.fold(0.0, |largest: f64, change| largest.max(change.abs()));
        step.iter().all(|change| change.is_finite()).then(|| (MAX_CHANGE / largest).min(1.0))
    }

    /// The system after a whole step; `None` where that is too long.
    pub(super) fn after(&self, step: &Step) -> Option<Self> {
        let length = self.longest(&step.unknowns)?;
        (length >= 1.0).then(|| self.moved(step, length))
    }

    /// The system after a step that minimizes the square of the residual and, weighted, of the
    /// change of ends (Levenberg and Marquardt), the weight raised until the square falls: for strips
    /// whose ends hardly matter yet, such as those at a tip.
    pub(super) fn damped(
        &self,
        residual: &DVector<f64>,
        depth: Depth<'_>,
    ) -> Option<(Self, DVector<f64>)> {
        const WEIGHTS: [f64; 4] = [1e-4, 1e-3, 1e-2, 1e-1];
        const MAX_RESIDUAL_PART: f64 = 0.98;
        let total = residual.len();
        let jacobian = DMatrix::from_row_slice(total, total, &self.linearized(depth).1);
        let (square, right) = (jacobian.tr_mul(&jacobian), jacobian.tr_mul(residual));
        WEIGHTS.into_iter().find_map(|weight| {
            let mut matrix = square.clone();
            for (i, strip) in self.strips.iter().enumerate() {
                let end = (i + 1) * self.size();
                for at in end - self.lengths()..end {
                    matrix[(at, at)] += weight * strip.pressure[0].powi(2);
                }
            }
            let unknowns = matrix.cholesky()?.solve(&right);
            let length = self.longest(&unknowns)?;
            let trial = self.moved(&Step { unknowns, deeper: 0.0 }, length);
            let after = trial.residual(depth);
            (after.norm() < MAX_RESIDUAL_PART * residual.norm()).then_some((trial, after))
        })
    }

    /// The system after a part of a step.
    pub(super) fn moved(&self, Step { unknowns: step, deeper }: &Step, length: f64) -> Self {
        let size = self.size();
        let strips = self.strips.iter().enumerate().map(|(j, strip)| {
            let mut strip = *strip;
            let step = &step.as_slice()[j * size..(j + 1) * size];
            for (pressure, change) in strip.pressure.iter_mut().zip(&step[..self.terms]) {
                *pressure -= length * change;
            }
            if let [centre, _] = step[self.terms..] {
                strip.centre -= length * centre * strip.half;
            }
            strip.half *= (-length * step[size - 1]).exp();
            strip
        });
        let deeper = self.deeper + length * deeper;
        Self { strips: strips.collect(), terms: self.terms, points: self.points.clone(), deeper }
    }

    pub(super) fn load(&self) -> f64 {
        self.strips.iter().map(Strip::load).sum()
    }

    /// Change of load along a change of all unknowns.
    pub(super) fn load_change(&self, change: &DVector<f64>) -> f64 {
        let size = self.size();
        let strips = self.strips.iter().enumerate();
        strips
            .map(|(j, strip)| {
                let by_half = strip.pressure[0] * change[(j + 1) * size - 1];
                PI * strip.width * strip.half * (change[j * size] + by_half)
            })
            .sum()
    }
}
