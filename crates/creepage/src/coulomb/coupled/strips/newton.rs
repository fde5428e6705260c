//! Newton's method for the pressures, centres and half lengths of all strips at once.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use super::Strip;
use super::kernel::View;

/// The depth of undeformed penetration, at x and y in the solver's units.
pub(in crate::coulomb::coupled) type Depth<'a> = &'a dyn Fn(f64, f64) -> f64;

/// Strips that touch all along, and how load follows the approach, in the solver's units.
#[derive(Debug, Clone)]
pub(in crate::coulomb::coupled) struct Touching {
    pub(in crate::coulomb::coupled) strips: Vec<Strip>,
    pub(in crate::coulomb::coupled) stiffness: f64,
}

/// Solves from a start close by; else the strips where it stopped.
pub(in crate::coulomb::coupled) fn solve(
    strips: Vec<Strip>,
    terms: usize,
    depth: Depth<'_>,
) -> Result<Touching, Vec<Strip>> {
    const STEPS: usize = 10;
    const ENOUGH: f64 = 1e-8;
    let mut system = System { strips, terms, points: points(terms) };
    let mut equations = system.equations(depth);
    for _ in 0..STEPS {
        let size = equations.residual.amax();
        let factors = equations.jacobian.clone().lu();
        if size < ENOUGH {
            let ones = DVector::from_element(equations.residual.len(), 1.0);
            let Some(by_approach) = factors.solve(&ones) else { break };
            let stiffness = system.load_change(&by_approach);
            return Ok(Touching { strips: system.strips, stiffness });
        }
        let next =
            factors.solve(&equations.residual).and_then(|s| system.improved(&s, size, depth));
        let Some(next) = next else { break };
        (system, equations) = next;
    }
    Err(system.strips)
}

struct System {
    strips: Vec<Strip>,
    terms: usize,
    points: Vec<f64>,
}

struct Equations {
    residual: DVector<f64>,
    jacobian: DMatrix<f64>,
}

/// Zeros of Chebyshev's polynomial: as many as a strip has unknowns.
fn points(terms: usize) -> Vec<f64> {
    let count = terms + 2;
    (0..count).map(|i| -((2 * i + 1) as f64 * PI / (2 * count) as f64).cos()).collect()
}

impl System {
    /// Unknowns of a strip: its pressures, its centre in half lengths, the logarithm of its half
    /// length.
    fn size(&self) -> usize {
        self.terms + 2
    }

    fn equations(&self, depth: Depth<'_>) -> Equations {
        let size = self.size();
        let total = self.strips.len() * size;
        let mut residual = DVector::zeros(total);
        // By columns of the transpose: a row of the matrix is one contiguous slice.
        let mut rows = DMatrix::zeros(total, total);
        for (i, strip) in self.strips.iter().enumerate() {
            for (l, &s) in self.points.iter().enumerate() {
                let at = i * size + l;
                let mut column = rows.column_mut(at);
                residual[at] = self.row(i, strip, s, depth, column.as_mut_slice());
            }
        }
        Equations { residual, jacobian: rows.transpose() }
    }

    /// Displacement less depth at a point of a strip; derivatives are added to `row`.
    fn row(&self, i: usize, strip: &Strip, s: f64, depth: Depth<'_>, row: &mut [f64]) -> f64 {
        const STEP: f64 = 1e-3;
        let (size, terms) = (self.size(), self.terms);
        let x = strip.centre + strip.half * s;
        let (mut displacement, mut slope) = (0.0, 0.0);
        for (j, source) in self.strips.iter().enumerate() {
            let integrals = view(strip, source, x, s, i == j).integrals(terms);
            let scale = source.half / PI;
            let (mut value, mut by_x, mut by_e) = (0.0, 0.0, 0.0);
            for k in 0..terms {
                row[j * size + k] += scale * integrals.value[k];
                value += source.pressure[k] * integrals.value[k];
                by_x += source.pressure[k] * integrals.by_x[k];
                by_e += source.pressure[k] * integrals.by_e[k];
            }
            displacement += scale * value;
            let distance = (x - source.centre) / source.half;
            if i == j {
                // Its points move with the strip.
                by_x = 0.0;
            }
            slope += by_x / PI;
            row[j * size + terms] -= scale * by_x;
            row[j * size + terms + 1] += scale * (value - distance * by_x - by_e);
        }
        let h = STEP * strip.half;
        slope -= (depth(x + h, strip.y) - depth(x - h, strip.y)) / (2.0 * h);
        row[i * size + terms] += slope * strip.half;
        row[i * size + terms + 1] += slope * strip.half * s;
        displacement - depth(x, strip.y)
    }

    /// How far a step may go: no half length changes by more than a third, no centre moves
    /// further. `None` when the step is not a number.
    fn longest(&self, step: &DVector<f64>) -> Option<f64> {
        const MOST: f64 = 0.35;
        let size = self.size();
        let largest = (0..self.strips.len())
            .flat_map(|j| [step[j * size + self.terms], step[j * size + self.terms + 1]])
            .fold(0.0, |largest: f64, change| largest.max(change.abs()));
        step.iter().all(|change| change.is_finite()).then(|| (MOST / largest).min(1.0))
    }

    /// The system after a step, halved until the residual falls.
    fn improved(
        &self,
        step: &DVector<f64>,
        size: f64,
        depth: Depth<'_>,
    ) -> Option<(Self, Equations)> {
        const SHORTEST: f64 = 0.03;
        let mut length = self.longest(step)?;
        while length > SHORTEST {
            let trial = self.moved(step, length);
            let equations = trial.equations(depth);
            if equations.residual.amax() < size * (1.0 - 0.1 * length) {
                return Some((trial, equations));
            }
            length *= 0.5;
        }
        None
    }

    fn moved(&self, step: &DVector<f64>, length: f64) -> Self {
        let size = self.size();
        let strips = self.strips.iter().enumerate().map(|(j, strip)| {
            let mut strip = *strip;
            for k in 0..self.terms {
                strip.pressure[k] -= length * step[j * size + k];
            }
            strip.centre -= length * step[j * size + self.terms] * strip.half;
            strip.half *= (-length * step[j * size + self.terms + 1]).exp();
            strip
        });
        Self { strips: strips.collect(), terms: self.terms, points: self.points.clone() }
    }

    /// Change of load along a change of all unknowns.
    fn load_change(&self, change: &DVector<f64>) -> f64 {
        let size = self.size();
        let strips = self.strips.iter().enumerate();
        strips
            .map(|(j, strip)| {
                let by_half = strip.pressure[0] * change[j * size + self.terms + 1];
                PI * strip.width * strip.half * (change[j * size] + by_half)
            })
            .sum()
    }
}

fn view(strip: &Strip, source: &Strip, x: f64, s: f64, own: bool) -> View {
    let across = strip.y - source.y;
    View {
        x: if own { s } else { (x - source.centre) / source.half },
        low: (across - source.width) / source.half,
        high: (across + source.width) / source.half,
        own,
    }
}
