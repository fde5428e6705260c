//! Transient solver on one grid of elements, step by step.

use std::collections::VecDeque;
use std::sync::Arc;

use super::elements::Elements;
use super::history::{Creep, Past, TimeLevel};
use super::motion::Motion;
use super::predictor::Predictor;
use super::system::System;
use crate::added_slip::AddedSlip;
use crate::coulomb::friction_bound::Moment;
use crate::coulomb::grid::Grid;
use crate::coulomb::solver::{Equations, Outcome, State};
use crate::{Force, Scaling};

/// One grid and what it remembers.
#[derive(Debug, Clone)]
pub(crate) struct TransientLevel {
    pub elements: Arc<Elements>,
    pub grid: Grid,
    pub system: System,
    pub state: State,
    pub equations: Equations,
    pub past: Past,
    /// Tractions over their bounds at the levels of the past, from the latest on, as far as they were solved here.
    pub tractions: VecDeque<[Vec<f64>; 2]>,
    /// Of the last solution.
    pub outcome: Outcome,
    /// Creepage of the last solution.
    pub creep: Creep,
    pub predictor: Predictor,
    /// Rigid slip beside creepage and spin, with the units of the nominal load.
    pub added: Option<(Arc<AddedSlip>, Scaling)>,
}

/// Stage of a step: the equations that hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Stage {
    /// The contact is shifted and does not roll; `begins` without traction.
    Shift { begins: bool },
    /// It has rolled for ever.
    Steady { scale: f64 },
    /// It rolls on for `length` to the size `scale`.
    Step { length: f64, scale: f64, smooth: bool },
}

/// Force and power of one grid's solution, in the units of the nominal load.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Result {
    pub creep: Creep,
    pub force: Force,
    pub dissipation: f64,
    pub adhesion_share: f64,
}

/// Distance over which a past that did not change is remembered, beyond what any particle looks back.
const FOR_EVER: f64 = 1e4;

impl TransientLevel {
    pub(crate) fn new(elements: Arc<Elements>) -> Self {
        let grid = elements.steady.clone();
        let (state, equations) = (State::new(&grid), Equations::new(&grid));
        let mut track = Self {
            elements,
            grid,
            system: System::default(),
            state,
            equations,
            past: Past::default(),
            tractions: VecDeque::new(),
            outcome: Outcome::default(),
            creep: [0.0; 3],
            predictor: Predictor::default(),
            added: None,
        };
        track.begin(1.0);
        track
    }

    /// Forgets all: the bodies have just been pressed together, without traction.
    pub(crate) fn begin(&mut self, scale: f64) {
        self.state.reset();
        self.predictor.restart();
        self.creep = [0.0; 3];
        self.past.0.clear();
        self.tractions.clear();
        let mut level = self.level(0.0, scale, false);
        // No layer has yielded yet.
        level.friction[2].clear();
        self.past.0.push_front(level);
    }

    /// Makes the equations of a stage those to be solved.
    pub(crate) fn prepare(&mut self, stage: Stage) {
        let elements = &self.elements;
        let begins = stage == Stage::Shift { begins: true };
        self.grid.rounding = if begins { elements.rounding } else { 0.0 };
        let mut system = match stage {
            Stage::Shift { .. } => System::of_shift(elements, &self.past.0[0]),
            Stage::Step { length, scale, smooth } => {
                System::of_step(elements, &self.past, length, scale, smooth)
            }
            Stage::Steady { scale } => {
                let zeros = || vec![0.0; elements.points()];
                let displacement = [zeros(), zeros()];
                let creep = [0.0; 3];
                let friction = [vec![], vec![], vec![]];
                let level =
                    TimeLevel { length: 0.0, scale, creep, smooth: false, displacement, friction };
                let past = Past(std::iter::once(level).collect());
                System::of_step(elements, &past, f64::INFINITY, scale, false)
            }
        };
        if let (Some((slip, scaling)), false) = (&self.added, matches!(stage, Stage::Shift { .. }))
        {
            system.add_slip(elements, |place| {
                let [x, y] = place.map(|at| scaling.length * at);
                slip.at(x, y).map(|slip| slip / scaling.slip)
            });
        }
        if let Some(resistance) = &mut self.grid.resistance {
            let remembers = resistance.remembers();
            let arriving = match stage {
                Stage::Step { length, .. } if remembers => {
                    elements.arriving(&self.past, length, system.scale)
                }
                Stage::Shift { .. } if resistance.yields() => elements.staying(&self.past.0[0]),
                _ => Vec::new(),
            };
            let rolls = !matches!(stage, Stage::Shift { .. });
            resistance.at_moment(Moment { size: system.scale, rolls }, arriving);
        }
        if system.weights != self.system.weights {
            self.grid.combine(&elements.displacements, &system.weights);
        }
        self.system = system;
    }

    /// Solves a stage for a motion, after the coarser grid if there is one: whether friction is obeyed
    /// and prescribed forces are met.
    pub(crate) fn solve(&mut self, stage: Stage, motion: &Motion, coarse: Option<&Self>) -> bool {
        self.state.keep_tractions_only();
        self.predictor.slope = None;
        let Stage::Step { length, smooth, .. } = stage else {
            return self.solve_prescribed(motion);
        };
        let last = self.creep;
        self.predict((length, smooth), coarse);
        if self.solve_prescribed(motion) {
            return true;
        }
        // The prediction misled: from where the last step ended.
        self.predictor.take_back(&mut self.state.traction);
        self.state.keep_tractions_only();
        self.creep = last;
        self.solve_prescribed(motion)
    }

    /// Goes to where the end of a step is likely to be.
    fn predict(&mut self, step: (f64, bool), coarse: Option<&Self>) {
        let State { limits, traction, .. } = &mut self.state;
        let found = coarse.map(|coarse| (&coarse.predictor, &coarse.state.traction));
        self.predictor.predict(step, found, limits, traction);
        let found = coarse.map(|coarse| (&coarse.predictor, coarse.creep));
        self.creep = self.predictor.predict_creep(step, &self.past, found, self.creep);
    }

    /// Solves at a creepage, from the present tractions.
    pub(super) fn solve_at(&mut self, creep: Creep) -> bool {
        self.creep = creep;
        self.force_slip();
        self.outcome = self.state.solve(&self.grid, &mut self.equations);
        if !self.outcome.converged {
            self.state.reset();
            self.outcome = self.state.solve(&self.grid, &mut self.equations);
        }
        self.outcome.converged
    }

    fn force_slip(&mut self) {
        let Self { elements, system, creep, state, .. } = self;
        let forcing = &mut state.forcing;
        forcing.spin = creep[2];
        forcing.slip.clear();
        let drive = |element| system.drive(elements, element, *creep);
        forcing.slip.extend((0..elements.all.len()).map(drive));
    }

    /// The force in the units of the contact's present size.
    pub(super) fn own_force(&self) -> Force {
        self.state.sum(&self.grid, 1.0).force
    }

    /// What the last solution adds up to.
    pub(crate) fn result(&self) -> Result {
        let (sum, scale) = (self.state.sum(&self.grid, 1.0), self.system.scale);
        let (cube, Force { fx, fy, mz }) = (scale.powi(3), sum.force);
        let adhering =
            |element: &usize| self.state.traction_and_slip(&self.grid, *element).1.is_none();
        let area = |element: usize| self.elements.all[element].area;
        let elements = 0..self.elements.all.len();
        let all: f64 = elements.clone().map(area).sum();
        let adhesion = elements.filter(adhering).map(area).fold(0.0, |sum, area| sum + area);
        Result {
            creep: self.creep,
            force: Force { fx: cube * fx, fy: cube * fy, mz: cube * scale * mz },
            dissipation: cube * scale * sum.dissipation,
            adhesion_share: adhesion / all,
        }
    }

    /// Makes the solution of a stage part of the past.
    pub(crate) fn remember(&mut self, stage: Stage) {
        if !matches!(stage, Stage::Step { .. }) {
            self.tractions.clear();
        }
        self.tractions.push_front(self.state.traction.own.clone());
        match stage {
            Stage::Step { length, scale, smooth } => {
                self.past.forget_beyond(self.reach(scale));
                self.past.0.push_front(self.level(length, scale, smooth));
                self.predictor.record_step(length, &self.state.traction);
            }
            Stage::Shift { .. } => {
                self.predictor.restart();
                let level = self.level(0.0, self.system.scale, false);
                self.past.0.clear();
                self.past.0.push_front(level);
            }
            Stage::Steady { scale } => {
                self.predictor.restart();
                let mut level = self.level(FOR_EVER, scale, false);
                level.creep = self.creep;
                self.past.0.clear();
                self.past.0.push_front(level.clone());
                self.past.0.push_front(level);
                self.tractions.push_front(self.state.traction.own.clone());
            }
        }
        self.tractions.truncate(self.past.0.len());
    }

    /// How far back particles are followed.
    fn reach(&self, scale: f64) -> f64 {
        let largest = |k: usize| self.elements.all.iter().map(|e| e.steps[k]).fold(0.0, f64::max);
        let before = self.past.0.iter().map(|level| level.scale).fold(scale, f64::max);
        1.6 * before * (largest(0) + largest(1))
    }

    /// Friction over that at rest, the size of the slip and the plastic displacement of a layer, in the units
    /// of the nominal load, where they are remembered.
    fn friction(&self) -> [Vec<f64>; 3] {
        let resistance = self.grid.resistance.as_ref();
        let Some(resistance) = resistance.filter(|resistance| resistance.remembers()) else {
            return [vec![], vec![], vec![]];
        };
        // Before anything is solved nothing slips.
        let is_solved = self.system.scale > 0.0;
        let slip = |element: usize| {
            let [x, y] = self.state.traction_and_slip(&self.grid, element).1.unwrap_or_default();
            x.hypot(y)
        };
        let Grid { mesh, pressure, .. } = &self.grid;
        let plastic = if resistance.yields() && is_solved {
            resistance.plastic_displacements(mesh, &pressure.bounds, slip)
        } else {
            vec![]
        };
        let slips = (0..mesh.len()).map(|element| self.system.scale * slip(element)).collect();
        [self.state.limits.clone(), slips, plastic]
    }

    /// The present displacements.
    fn level(&self, length: f64, scale: f64, smooth: bool) -> TimeLevel {
        let unit = scale * scale;
        let mut displacement = self.elements.displacements.by(&self.state.traction);
        for (k, by_traction) in displacement.iter_mut().enumerate() {
            for (all, by_pressure) in by_traction.iter_mut().zip(&self.elements.by_pressure) {
                *all = unit * (*all + by_pressure[k]);
            }
        }
        let (creep, friction) = (self.creep, self.friction());
        TimeLevel { length, scale, creep, smooth, displacement, friction }
    }
}
