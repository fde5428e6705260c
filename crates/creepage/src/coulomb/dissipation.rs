//! Frictional power of slip zones narrower than an element.
//!
//! At the trailing edge the traction of adhesion grows as `K` over the root of the distance, and a
//! slip area much narrower than an element turns to heat what is proportional to `K^2`.

use super::grid::Grid;
use super::quadrature::Sum;
use super::solver::State;

/// What friction turns to heat, from the power of force and pressure and, of the finer grid, what its
/// elements give and `work`, the same power there: beyond it as the elements say, never short of it.
pub(super) fn dissipation(power: f64, fine: &Sum, work: f64) -> f64 {
    let beyond = fine.dissipation - work - fine.by_pressure;
    (power + beyond.max(0.0)).max(0.0)
}

/// Unresolved dissipation: by what each strip's last element is heated beyond what it resolves, and a factor for
/// all.
#[derive(Debug, Clone)]
pub(super) struct Unresolved {
    last: Vec<f64>,
    factor: f64,
}

impl Unresolved {
    /// Of a grid whose elements give `by_elements` of all that is turned to heat.
    pub(super) fn new(grid: &Grid, state: &State, dissipation: f64, by_elements: f64) -> Self {
        if dissipation <= by_elements {
            let factor = if by_elements > 0.0 { dissipation / by_elements } else { 1.0 };
            return Self { last: vec![0.0; grid.mesh.strips.len()], factor };
        }
        let strips = grid.mesh.strips.iter().enumerate();
        let weights = strips.map(|(j, strip)| {
            let last = grid.mesh.elements(j).end - 1;
            let traction = state.traction.at(last).map(|t| t * grid.pressure.bounds[last]);
            strip.area(strip.len() - 1) * (traction[0].powi(2) + traction[1].powi(2))
        });
        let weights: Vec<f64> = weights.collect();
        let each = (dissipation - by_elements) / weights.iter().sum::<f64>().max(f64::MIN_POSITIVE);
        Self { last: weights.iter().map(|weight| each * weight).collect(), factor: 1.0 }
    }

    /// The frictional power of element `i` of a strip.
    pub(super) fn power(&self, grid: &Grid, state: &State, strip: usize, i: usize) -> f64 {
        let elements = grid.mesh.elements(strip);
        let is_last = i + 1 == elements.len();
        let beyond = if is_last { self.last[strip] } else { 0.0 };
        self.factor * state.power(grid, elements.start + i) + beyond
    }
}
