//! Full theory of transient rolling on two grids: a state that rolls on.

use std::sync::Arc;

use super::control::{Control, Watched};
use super::elements::{Elements, Surface};
use super::level::{self, Stage, TransientLevel};
use super::load::Course;
use super::motion::Motion;
use super::predictor::Predictor;
use crate::added_slip::AddedSlip;
use crate::check::{self, InvalidValue};
use crate::coulomb::extrapolation::{error_bar, extrapolate, extrapolate_force};
use crate::coulomb::{ElementField, Exact, Resolution};
use crate::friction_law::RollingFriction;
use crate::theory::{Solution, Statistics, Status};
use crate::{Contact, Creepage, FieldPoint, Region, Scaling};

/// Result of a step, dimensionless in the units of the contact's nominal load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolled {
    /// Distance rolled since the beginning, in units of `c`.
    pub distance: f64,
    /// Creepage at the end of the step, prescribed or found.
    pub creepage: Creepage,
    /// Force at the end of the step, its error bars, outcome and cost.
    pub solution: Solution,
    /// Share of the contact area that adheres.
    pub adhesion_share: f64,
    /// Frictional energy per distance at the end of the step, over `mu N mu c / rho`.
    pub dissipation: f64,
}

/// A contact that rolls on: its past decides with the motion what comes.
///
/// ```
/// use creepage::coulomb::Resolution;
/// use creepage::unsteady::{Motion, Rolling};
/// use creepage::{Contact, Creepage, Ellipse};
/// let contact = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
/// let mut rolling = Rolling::new(&contact, Resolution::FAST)?;
/// let motion = Motion::from(Creepage::new(0.5, 0.0, 0.0)?);
/// let quarter = rolling.step(0.25, &motion)?.solution.force;
/// assert!((quarter.fx - 0.075).abs() < 0.002); // nearly a sticking disc, .0785
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Rolling {
    pub(super) tracks: [TransientLevel; 2],
    pub(super) control: Control,
    pub(super) travel: RollingState,
}

/// State of rolling: where the contact is, how it is loaded and how it last moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RollingState {
    pub distance: f64,
    /// Normal force over the nominal one, now and from the next step on.
    pub load: f64,
    pub next_load: f64,
    /// The last motion, after the first.
    pub motion: Option<Motion>,
    /// The last force and moment of the finer grid.
    pub force: [f64; 3],
}

impl RollingState {
    /// Nothing rolled, no traction.
    fn begin(load: f64) -> Self {
        Self { distance: 0.0, load, next_load: load, motion: None, force: [0.0; 3] }
    }
}

impl Rolling {
    /// The contact just pressed together, without traction; with half as many elements more along the
    /// rolling direction than [`Exact`] has, for borders travel that way.
    ///
    /// Friction may depend on the slip and the place as [`Contact::with_rolling_friction`] has it; one
    /// that falls with the speed needs a memory, for without it the tractions jump from step to step.
    /// Bodies that are shifted have friction at rest. A layer takes part as in [`Contact::with_layer`]: its
    /// plastic displacement moves with the particles, and the load stays as it is.
    ///
    /// # Errors
    /// [`InvalidValue`] as [`Exact::new`], and for falling friction without a memory.
    pub fn new(contact: &Contact, resolution: Resolution) -> Result<Self, InvalidValue> {
        if let Some(friction) = contact.rolling_friction() {
            remembered(friction)?;
        }
        let ellipse = contact.hertz_ellipse()?;
        check::ratio(ellipse.ratio(), Exact::RATIO_RANGE, "between 1/64 and 64")?;
        let [along, across] = resolution.coarse(ellipse.ratio());
        let along = along + along / 2;
        let (poisson, kappa_over_mu) = (contact.poisson(), contact.kappa_over_mu());
        let surface = Surface { friction: contact.rolling_friction(), layer: contact.layer() };
        let rolling = Self::of([1, 2].map(|k| {
            Elements::hertz(ellipse, poisson, kappa_over_mu, [k * along, k * across])
                .with_surface(&surface, contact.scaling())
        }));
        Ok(match contact.added_slip() {
            Some(slip) => rolling.with_added_slip(slip, contact.scaling()),
            None => rolling,
        })
    }

    /// The same with a rigid slip beside creepage and spin, as [`Contact::with_added_slip`] has it; `scaling` is that
    /// of the contact. It stands still in the contact while particles pass, under every load, and does nothing in a
    /// shift.
    #[must_use]
    pub fn with_added_slip(mut self, slip: &Arc<AddedSlip>, scaling: Scaling) -> Self {
        for track in &mut self.tracks {
            track.added = Some((Arc::clone(slip), scaling));
        }
        self
    }

    pub(super) fn of(elements: [Elements; 2]) -> Self {
        let control = Control::new(elements[0].semi_axes[0]);
        let mut tracks = elements.map(|elements| TransientLevel::new(Arc::new(elements)));
        let [coarse, fine] = tracks.each_ref().map(|track| &track.grid.mesh);
        tracks[1].predictor = Predictor::of_finer(coarse, fine);
        Self { tracks, control, travel: RollingState::begin(1.0) }
    }

    /// Starts anew under another normal force, over the nominal one, without traction.
    ///
    /// # Errors
    /// [`InvalidValue`] as [`Rolling::press`].
    pub fn start_with_load(&mut self, load: f64) -> Result<(), InvalidValue> {
        self.press(load)?;
        let scale = if load > 0.0 { load.cbrt() } else { 1.0 };
        self.tracks.iter_mut().for_each(|track| track.begin(scale));
        self.travel = RollingState::begin(load);
        self.control.restart();
        Ok(())
    }

    /// Presses with another normal force, over the nominal one: in the next step the force goes there in
    /// a straight line, and the area grows or shrinks with its third root. At zero the bodies part, and
    /// what they remember is lost.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `load` lies between 0 and a million, and for line contacts, areas of
    /// any shape and contacts with a layer, whose load stays as it is.
    pub fn press(&mut self, load: f64) -> Result<(), InvalidValue> {
        let Elements { semi_axes, has_layer, .. } = &*self.tracks[0].elements;
        let stays = semi_axes[1].is_infinite() || *has_layer;
        let valid =
            "1 for a line contact, an area of any shape, or with a layer between the bodies";
        check::require(!stays || (load - 1.0).abs() < 1e-12, "load", load, valid)?;
        let valid = "between 0 and 1e6";
        self.travel.next_load = check::require((0.0..=1e6).contains(&load), "load", load, valid)?;
        Ok(())
    }

    /// Distance rolled since the beginning, in units of `c`; zero before the first step.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.travel.distance
    }

    /// Shifts the bodies against each other by a force, before they roll: Cattaneo's and Mindlin's
    /// problem, on any ellipse in any direction.
    ///
    /// `creepage` of what is given back is the shift of the upper body, in units of `mu c^2 / rho`.
    ///
    /// # Errors
    /// [`InvalidValue`] unless the force is below that of friction.
    pub fn shift(&mut self, fx: f64, fy: f64) -> Result<Rolled, InvalidValue> {
        let valid = "below the force of friction, mu N";
        let size = check::require(fx.hypot(fy) < self.travel.load, "force", fx.hypot(fy), valid)?;
        check::finite("force", size)?;
        let rolled =
            self.start(Stage::Shift { begins: self.is_at_rest() }, &Motion::forces(fx, fy));
        let [coarse, fine] = self.tracks.each_ref().map(|track| track.creep);
        let [xi, eta, chi] = [0, 1, 2].map(|k| extrapolate(coarse[k], fine[k]));
        Ok(Rolled { creepage: Creepage { xi, eta, chi }, ..rolled })
    }

    /// Starts from steady rolling with a motion.
    ///
    /// # Errors
    /// [`InvalidValue`] when a number of the motion is not finite.
    pub fn start_steady(&mut self, motion: &Motion) -> Result<Rolled, InvalidValue> {
        motion.check()?;
        let rolled = self.start(Stage::Steady { scale: self.travel.load.cbrt() }, motion);
        self.travel.motion = Some(*motion);
        Ok(rolled)
    }

    fn start(&mut self, stage: Stage, motion: &Motion) -> Rolled {
        let solved = self.solve(stage, motion);
        for track in &mut self.tracks {
            track.remember(stage);
        }
        self.control.restart();
        self.travel.force = self.tracks[1].result().force.components();
        self.rolled(solved)
    }

    /// Rolls on, in steps as short as the forces ask for.
    ///
    /// Where a prescribed force differs from the present one by more than a twentieth of `mu N`, the
    /// bodies are shifted first, at rest; smaller differences are part of the first step.
    ///
    /// # Errors
    /// [`InvalidValue`] unless the distance is positive and all numbers are finite.
    pub fn step(&mut self, distance: f64, motion: &Motion) -> Result<Rolled, InvalidValue> {
        self.check(distance, motion)?;
        let mut smooth = self.continues(motion);
        if !smooth {
            self.control.restart();
        }
        let course = Course::new(
            [self.travel.load, self.travel.next_load],
            self.travel.force,
            distance,
            motion,
        );
        let (mut rolled_on, mut cost) = (0.0, Statistics::default());
        loop {
            let longest = course.longest(rolled_on);
            let (length, is_last) = self.control.length(distance - rolled_on, longest);
            let end = if is_last { distance } else { rolled_on + length };
            let (load, motion) = (course.load(end), course.motion(end));
            let Some(rolled) = self.try_step(length, load, &motion, smooth, true) else { continue };
            cost.iterations += rolled.solution.statistics.iterations;
            cost.factorizations += rolled.solution.statistics.factorizations;
            smooth = true;
            rolled_on = end;
            if is_last {
                let solution = Solution { statistics: cost, ..rolled.solution };
                return Ok(Rolled { solution, ..rolled });
            }
        }
    }

    /// Rolls on in a single step of the scheme, whatever its length and however much the load changes.
    ///
    /// # Errors
    /// As [`Rolling::step`].
    pub fn advance(&mut self, distance: f64, motion: &Motion) -> Result<Rolled, InvalidValue> {
        self.check(distance, motion)?;
        let smooth = self.continues(motion) && self.load_is_smooth();
        let rolled = self.try_step(distance, self.travel.next_load, motion, smooth, false);
        Ok(rolled.unwrap_or_else(|| self.rolled(false)))
    }

    /// The elements of the finer grid as the last step left them, strip by strip from negative `y`, each
    /// from the leading edge: positions in units of `c`, tractions in that of the nominal load.
    #[must_use]
    pub fn elements(&self) -> Vec<ElementField> {
        let track = &self.tracks[1];
        let (grid, scale) = (&track.grid, self.travel.load.cbrt());
        let place = |at: [f64; 2]| at.map(|x| scale * x);
        let element = |(index, (strip, i)): (usize, (usize, usize))| {
            let bound = scale * grid.pressure.bounds[index];
            let (traction, slip) = track.state.traction_and_slip(grid, index);
            let point = FieldPoint {
                position: place(grid.pressure.centroids[index]),
                traction: traction.map(|t| bound * t),
                slip: slip.unwrap_or_default().map(|s| scale * s),
                region: if slip.is_some() { Region::Slip } else { Region::Adhesion },
            };
            ElementField {
                point,
                bound,
                share: scale.powi(3) * grid.pressure.shares[index],
                power: scale.powi(4) * track.state.power(grid, index),
                corners: grid.mesh.strips[strip].corners(i).map(place),
                beyond: ElementField::whole(point.region),
            }
        };
        grid.mesh.all().enumerate().map(element).collect()
    }

    fn check(&self, distance: f64, motion: &Motion) -> Result<(), InvalidValue> {
        check::positive("distance", distance)?;
        motion.check()?;
        let (limit, size) = (self.travel.next_load, motion.force());
        check::require(size <= limit, "force", size, "at most the force of friction, mu N")?;
        Ok(())
    }

    /// One step; `None` when it is to be tried with a shorter one.
    fn try_step(
        &mut self,
        length: f64,
        load: f64,
        motion: &Motion,
        smooth: bool,
        controlled: bool,
    ) -> Option<Rolled> {
        if load == 0.0 {
            return Some(self.part(length, motion));
        }
        if self.travel.load == 0.0 {
            self.press_together(load);
            self.shift_on(motion);
        }
        let stage = Stage::Step { length, scale: load.cbrt(), smooth };
        let before = self.keep();
        let solved = self.solve(stage, motion);
        if controlled && !self.control.accepts(length, self.watched(motion, load)) {
            self.go_back(before);
            return None;
        }
        for track in &mut self.tracks {
            track.remember(stage);
        }
        self.travel.load = load;
        self.travel.distance += length;
        self.travel.motion = Some(*motion);
        self.travel.force = self.tracks[1].result().force.components();
        Some(self.rolled(solved))
    }

    /// The bodies are apart.
    fn part(&mut self, length: f64, motion: &Motion) -> Rolled {
        self.tracks.iter_mut().for_each(|track| track.begin(1.0));
        self.control.restart();
        let distance = self.travel.distance + length;
        let next_load = self.travel.next_load;
        let begin = RollingState::begin(0.0);
        self.travel = RollingState { distance, next_load, motion: Some(*motion), ..begin };
        let [xi, eta, chi] = motion.components().map(|one| one.creepage().unwrap_or(0.0));
        Rolled {
            distance: self.travel.distance,
            creepage: Creepage { xi, eta, chi },
            solution: Solution::closed_form(crate::Force::default(), Status::Solved),
            adhesion_share: 0.0,
            dissipation: 0.0,
        }
    }

    pub(super) fn solve(&mut self, stage: Stage, motion: &Motion) -> bool {
        let [coarse, fine] = &mut self.tracks;
        coarse.prepare(stage);
        fine.prepare(stage);
        let solved = coarse.solve(stage, motion, None);
        fine.solve(stage, motion, Some(coarse)) && solved
    }

    /// What step control looks at: forces, and creepages that are found.
    fn watched(&self, motion: &Motion, load: f64) -> Watched {
        let level::Result { creep, force, .. } = self.tracks[1].result();
        let found = |k: usize| motion.components()[k].force().map_or(0.0, |_| creep[k]);
        let force = force.components().map(|part| part / load);
        Watched { force, found: [0, 1, 2].map(found) }
    }

    /// Both grids together.
    fn rolled(&self, solved: bool) -> Rolled {
        let [coarse, fine] = self.tracks.each_ref().map(TransientLevel::result);
        let count = |of: fn(&TransientLevel) -> usize| self.tracks.iter().map(of).sum();
        // Creepages that are found go up and down as the border of adhesion crosses elements, those of
        // the coarser grid most: extrapolation would add to it.
        let [xi, eta, chi] = fine.creep;
        Rolled {
            distance: self.travel.distance,
            creepage: Creepage { xi, eta, chi },
            solution: Solution {
                force: extrapolate_force([coarse.force, fine.force]),
                error: Some(error_bar(
                    [coarse.force, fine.force],
                    self.tracks[1].elements.all.len(),
                )),
                status: if solved { Status::Solved } else { Status::NotConverged },
                statistics: Statistics {
                    iterations: count(|track| track.outcome.sweeps),
                    factorizations: count(|track| track.outcome.factorizations),
                },
            },
            adhesion_share: fine.adhesion_share,
            dissipation: positive(coarse.dissipation, fine.dissipation),
        }
    }
}

/// By the approximate theories rolling that is not steady knows no third body.
pub(super) fn no_layer(contact: &Contact) -> Result<(), InvalidValue> {
    let thickness = contact.layer().map_or(0.0, |layer| layer.thickness());
    let valid = "none: rolling that is not steady has a third body by the full theory alone";
    check::require(contact.layer().is_none(), "layer thickness", thickness, valid).map(drop)
}

/// Falling friction that follows the slip at once makes the tractions jump from step to step.
pub(super) fn remembered(friction: RollingFriction) -> Result<(), InvalidValue> {
    let valid = "given where friction falls with the speed of slip and rolling is not steady";
    let is_remembered = !friction.falls() || friction.memory().is_some();
    check::require(is_remembered, "memory_distance", 0.0, valid).map(drop)
}

/// Extrapolation of what cannot be negative: where the finer grid has less, by the third root of the
/// ratio, which is the same to first order in the difference.
fn positive(coarse: f64, fine: f64) -> f64 {
    if fine < coarse { fine * (fine / coarse).cbrt() } else { extrapolate(coarse, fine) }
}
