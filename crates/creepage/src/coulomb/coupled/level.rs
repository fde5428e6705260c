//! One grid of the coupled problem: alternating solution of the normal and the tangential problem.

use std::f64::consts::PI;

use super::Prescribed;
use super::normal::{Normal, PressedArea};
use super::normal_tangential_coupling::NormalInfluence;
use super::shape::Shape;
use crate::coulomb::grid::Grid;
use crate::coulomb::mesh::Mesh;
use crate::coulomb::pressure::Pressure;
use crate::coulomb::solver::{Equations, Outcome, State};
use crate::coulomb::stencil::SlipStencil;
use crate::numerics::anderson::AndersonAcceleration;
use crate::{Contact, Creepage};

/// Largest change from turn to turn in a solution, over `c` and the peak pressure: twenty times
/// the tolerance of the normal problem.
const TOLERANCE: f64 = 2e-7;
/// What is left of rounding in slender contacts: enough when the changes fall no more.
const ROUGH: f64 = 2e-6;
const TURNS: usize = 60;

/// How pressure and tangential traction act on each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Coupling {
    pub poisson: f64,
    /// Slip in units of `mu c / rho` over that in units of `kappa f00`.
    slip: f64,
    /// Slip in units of `mu c / rho` over `mu f00`.
    slip_unit: f64,
    /// `q = kappa mu / (1 - sigma)`.
    pub q: f64,
}

impl Coupling {
    pub(super) fn new(contact: &Contact, friction: f64) -> Self {
        let (ellipse, poisson) = (contact.ellipse(), contact.poisson());
        let slip_unit = (1.0 - poisson) * ellipse.integrals().e / (2.0 * ellipse.g().sqrt());
        let kappa_over_mu = contact.kappa_over_mu();
        let q = kappa_over_mu * friction * friction / (1.0 - poisson);
        Self { poisson, slip: kappa_over_mu / slip_unit, slip_unit, q }
    }
}

/// Coupled problem prepared on one grid.
#[derive(Debug, Clone)]
pub(super) struct CoupledGrid {
    pub normal: Normal,
    /// Slip of the elements on the ellipse by Hertz's pressure as constant on each, over `kappa f00`.
    slip_by_elements: Vec<[f64; 2]>,
}

/// Problem to be solved on a grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct CoupledProblem<'a> {
    pub hertz: &'a Grid,
    pub coupling: Coupling,
    pub prescribed: Prescribed,
    pub creepage: Creepage,
    /// The sign with which the bodies are unlike.
    pub side: f64,
}

/// Warm start of a grid.
pub(super) struct CoupledWarmStart<'a> {
    pub pressed: PressedArea,
    /// The tractions of the coarser grid, if there is one.
    pub coarser: Option<&'a State>,
}

/// Solution on one grid.
#[derive(Debug, Clone)]
pub(super) struct CoupledState {
    pub grid: Grid,
    pub state: State,
    pub equations: Equations,
    pub shape: Shape,
    pub pressed: PressedArea,
    /// The same by strips without friction.
    pub frictionless: PressedArea,
    pub converged: bool,
    pub turns: usize,
    pub sweeps: usize,
    pub factorizations: usize,
}

impl CoupledGrid {
    /// `None` when the strips do not find Hertz's contact.
    pub(super) fn new(contact: &Contact, hertz: &Grid) -> Option<Self> {
        const STRIPS: [usize; 2] = [8, 24];
        let stencils: Vec<_> = hertz.mesh.strips.iter().map(SlipStencil::steady).collect();
        let normal_influence = NormalInfluence::new(&hertz.mesh);
        let count = hertz.mesh.strips.len().clamp(STRIPS[0], STRIPS[1]);
        Some(Self {
            normal: Normal::new(contact.ellipse(), count)?,
            slip_by_elements: slip_by(&normal_influence, &hertz.pressure, &stencils),
        })
    }

    /// Solves at a creepage, `side` the sign with which the bodies are unlike, from a start; where that
    /// fails, from the frictionless contact, and then with the tractions' part in the normal problem
    /// growing by steps.
    pub(super) fn settle(&self, case: CoupledProblem, start: CoupledWarmStart) -> CoupledState {
        /// Steps in which the coupling grows, from attempt to attempt.
        const LOAD_STEPS: [u32; 3] = [1, 4, 16];
        let coarser = start.coarser;
        let mut settled = self.take_turns(case, 1.0, start);
        for steps in LOAD_STEPS {
            if settled.converged {
                break;
            }
            let (turns, sweeps) = (settled.turns, settled.sweeps);
            settled = self.by_steps(case, steps, coarser);
            settled.turns += turns;
            settled.sweeps += sweeps;
        }
        settled
    }

    /// Solves with ever larger parts of the coupling; ends where one of them fails.
    fn by_steps(&self, case: CoupledProblem, steps: u32, coarser: Option<&State>) -> CoupledState {
        let part = |step: u32| f64::from(step) / f64::from(steps);
        let pressed = self.normal.frictionless.clone();
        let mut settled = self.take_turns(case, part(1), CoupledWarmStart { pressed, coarser });
        for step in 2..=steps {
            if !settled.converged {
                return settled;
            }
            let (turns, pressed) = (settled.turns, settled.pressed);
            settled = self.take_turns(case, part(step), CoupledWarmStart { pressed, coarser });
            settled.turns += turns;
        }
        settled
    }

    /// Friction and normal contact in turn, with a part of what the tractions do to the pressure.
    fn take_turns(&self, case: CoupledProblem, part: f64, start: CoupledWarmStart) -> CoupledState {
        let factor = -case.side * part * case.coupling.q / PI;
        let (mut settled, mut normal_influence) = self.start(case, start);
        let mut mixing = AndersonAcceleration::default();
        loop {
            let outcome = settled.solve_tangential(case);
            let tractions = settled.tractions();
            let more = |at: [f64; 2]| factor * normal_influence.by_traction(at, &tractions);
            let Some(next) = self.normal.solve(&settled.pressed, more, case.prescribed) else {
                return settled;
            };
            let change = settled.pressed.apart(&next);
            if change <= TOLERANCE || (settled.turns > TURNS / 2 && change <= ROUGH) {
                settled.converged = outcome.converged;
                return settled;
            }
            if settled.turns >= TURNS || !change.is_finite() {
                return settled;
            }
            settled.pressed.accelerate(&mut mixing, &next);
            normal_influence = self.press(case, &mut settled);
        }
    }

    fn start(
        &self,
        case: CoupledProblem,
        start: CoupledWarmStart,
    ) -> (CoupledState, NormalInfluence) {
        let CoupledProblem { hertz, coupling, .. } = case;
        let CoupledWarmStart { pressed, coarser } = start;
        let shape = Shape::new(&self.normal, &pressed);
        let (grid, normal_influence) = self.grid(hertz, coupling, &shape, &pressed);
        let (mut state, equations) = (State::new(&grid), Equations::new(&grid));
        if let Some(coarser) = coarser {
            state.refine(hertz, coarser);
        }
        let settled = CoupledState {
            grid,
            state,
            equations,
            shape,
            pressed,
            frictionless: self.normal.frictionless.clone(),
            converged: false,
            turns: 0,
            sweeps: 0,
            factorizations: 0,
        };
        (settled, normal_influence)
    }

    /// Lays the elements into the area, and the pressure on them.
    fn press(&self, case: CoupledProblem, settled: &mut CoupledState) -> NormalInfluence {
        settled.shape = Shape::new(&self.normal, &settled.pressed);
        let (grid, normal_influence) =
            self.grid(case.hertz, case.coupling, &settled.shape, &settled.pressed);
        settled.grid = grid;
        normal_influence
    }

    /// The mesh and the pressure of a shape.
    pub(super) fn elements(
        &self,
        hertz: &Grid,
        shape: &Shape,
        pressed: &PressedArea,
    ) -> (Mesh, Pressure) {
        let load = pressed.load / self.normal.frictionless.load;
        (shape.mesh(&hertz.mesh), shape.pressed(&hertz.pressure, load))
    }

    fn grid(
        &self,
        hertz: &Grid,
        coupling: Coupling,
        shape: &Shape,
        pressed: &PressedArea,
    ) -> (Grid, NormalInfluence) {
        if pressed.is(&self.normal.frictionless) {
            return (hertz.clone(), NormalInfluence::new(&hertz.mesh));
        }
        let (mesh, pressure) = self.elements(hertz, shape, pressed);
        let stencils: Vec<_> = mesh.strips.iter().map(SlipStencil::steady).collect();
        let normal_influence = NormalInfluence::new(&mesh);
        // Hertz's own in closed form, and by elements only how much it changes.
        let changed = slip_by(&normal_influence, &pressure, &stencils);
        let before = hertz.pressure_slip.iter().zip(&self.slip_by_elements);
        let slip = before.zip(&changed).map(|((hertz, by_elements), changed)| {
            [0, 1].map(|k| hertz[k] + coupling.slip * (changed[k] - by_elements[k]))
        });
        let slip = slip.collect();
        let grid = Grid::new(mesh, pressure, coupling.poisson, coupling.slip_unit, &stencils);
        (Grid { pressure_slip: slip, rounding: hertz.rounding, ..grid }, normal_influence)
    }
}

/// Slip of the elements by pressure that is constant on each, over `kappa f00`.
fn slip_by(
    normal_influence: &NormalInfluence,
    pressure: &Pressure,
    stencils: &[SlipStencil],
) -> Vec<[f64; 2]> {
    let displacement =
        |at: [f64; 2]| normal_influence.by_pressure(at, &pressure.bounds).map(|sum| sum / PI);
    stencils.iter().flat_map(|stencil| stencil.slip(displacement)).collect()
}

impl CoupledState {
    /// Solves the tangential problem under the present pressure.
    fn solve_tangential(&mut self, case: CoupledProblem) -> Outcome {
        self.grid.set_forcing(case.creepage, case.side, &mut self.state.forcing);
        let outcome = self.state.solve(&self.grid, &mut self.equations);
        self.turns += 1;
        self.sweeps += outcome.sweeps;
        self.factorizations += outcome.factorizations;
        outcome
    }

    /// Tractions over `mu p_0`.
    fn tractions(&self) -> Vec<[f64; 2]> {
        let bounds = self.grid.pressure.bounds.iter().enumerate();
        bounds.map(|(element, bound)| self.state.traction.at(element).map(|t| bound * t)).collect()
    }
}
