//! Transient rolling by the numerical theory of chapter 5, the last proposal of the thesis (6.2).
//!
//! The slip of (4.15b) has one term more than that of steady rolling, `-du/dq`. At the end of a step of
//! length `h` it is a difference backwards between displacements at one place of the contact,
//!
//! ```math
//! \frac{\partial u}{\partial q} \approx \frac{1}{h} \left[ \frac{1 + 2r}{1 + r} u_n - (1 + r) u_{n-1}
//!   + \frac{r^2}{1 + r} u_{n-2} \right], \qquad r = \frac{h}{h_{n-1}},
//! ```
//!
//! of second order, and `(u_n - u_{n-1})/h` after a jump. So slip and traction stay linear functions of
//! the unknowns, and each step is one minimum.
//!
//! (5.9) alone does not do. `T S` vanishes as well where nothing slips under a traction beyond its bound;
//! steady rolling keeps polynomials from that, but bodies that begin to roll from rest can stick all over
//! however large their tractions become: the forces then grow beyond `mu N`, with the degree the more. So
//! the bound (5.7) has to be kept, by the convex functional of
//! [`TractionBound::Kept`](crate::variational::TractionBound::Kept), the least loss of power, with the
//! power that goes into elastic energy. Where nothing changes any more it rolls steadily, near that theory of
//! steady rolling but not to the last digit: what elastic energy takes is left out there, for it is zero.
//!
//! Against [`Rolling`](super::Rolling) from no traction into steady rolling, a circle at creepages and spins
//! of order one: the force within 0.07 of `mu N` with degree 3 and 0.05 with degree 6. With `a/b = 0.5`,
//! `xi = 0.6`, `eta = -0.4`, `chi = 0.8` it ends 0.09 and 0.02 off.

use super::history::Creep;
use super::motion::Motion;
use super::prescribed_forces::{Accuracy, solve_prescribed};
use super::rolling::{Rolled, no_layer};
use crate::check::{self, InvalidValue};
use crate::theory::{Solution, Statistics, Status};
use crate::variational::{
    Change, Changing, Rubbing, Settings, Start, Variational, VariationalError, VariationalSolution,
};
use crate::{Contact, Creepage};

/// Longest step over the semi-axis: forces are then off by less than what polynomials of degree 12 are.
const LONGEST: f64 = 0.05;
/// A step so much longer than the one before takes the difference of first order.
const LONGER: f64 = 2.0;
/// A prescribed force that differs by more than this part of `mu N` shifts the bodies at rest first.
const JUMP: f64 = 0.05;
/// Contact lengths after which nothing is left of what was before.
const FORGOTTEN: f64 = 12.0;

/// Chapter 5 with a memory, for one contact under a constant load.
///
/// ```
/// use creepage::coulomb::{Exact, Resolution};
/// use creepage::unsteady::{Motion, RollingVariational};
/// use creepage::variational::Settings;
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let contact = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
/// let motion = Motion::from(Creepage::new(0.9, 0.0, 0.0)?);
/// let mut rolling = RollingVariational::new(&contact, Settings::default())?;
/// let begin = rolling.step(0.2, &motion)?.solution.force;
/// assert!(begin.fx < 0.2); // it has yet to build up
/// let end = rolling.step(5.0, &motion)?.solution.force;
/// let full = Exact::new(&contact, Resolution::FAST)?.solve(Creepage::new(0.9, 0.0, 0.0)?).force;
/// assert!((end.fx - full.fx).abs() < 0.05); // degree 3
/// # Ok::<(), creepage::variational::VariationalError>(())
/// ```
#[derive(Debug, Clone)]
pub struct RollingVariational {
    changing: Changing,
    /// In units of `c`.
    semi_axis: f64,
    state: State,
}

/// State that the contact remembers.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct State {
    pub distance: f64,
    /// Distance since the slip was last resolved, or since the beginning.
    pub unresolved: f64,
    pub creep: Creep,
    pub force: [f64; 3],
    /// The last motion, after the first.
    pub motion: Option<Motion>,
    /// The unknowns now, and at the beginning of the last step, which was so long; only the first
    /// after a jump.
    pub now: Vec<f64>,
    pub before: Option<(f64, Vec<f64>)>,
}

impl State {
    /// No traction.
    fn begin(unknowns: usize) -> Self {
        Self {
            distance: 0.0,
            unresolved: 0.0,
            creep: [0.0; 3],
            force: [0.0; 3],
            motion: None,
            now: vec![0.0; unknowns],
            before: None,
        }
    }
}

/// One way of the displacements to where they are.
enum Stage {
    Shift,
    Steady,
    Step { length: f64, smooth: bool },
}

impl RollingVariational {
    /// The contact just pressed together, without traction. Tractions are kept within their bound unless
    /// [`Settings::bound`] is [`Unchecked`](crate::variational::TractionBound::Unchecked), which is (5.9)
    /// to the letter.
    ///
    /// # Errors
    /// [`VariationalError`] as [`Variational::new`], for a contact with a layer, and for friction that
    /// depends on the slip or the place.
    pub fn new(contact: &Contact, settings: Settings) -> Result<Self, VariationalError> {
        no_layer(contact)?;
        contact.require_no_added_slip()?;
        let valid = "one coefficient: this theory has Coulomb's law alone";
        check::require(contact.rolling_friction().is_none(), "friction law", 1.0, valid)?;
        let changing = Changing::new(contact, settings)?;
        let semi_axis = changing.steady().ellipse().a();
        let state = State::begin(changing.unknowns());
        Ok(Self { changing, semi_axis, state })
    }

    /// Starts anew without traction.
    pub fn start(&mut self) {
        self.state = State::begin(self.changing.unknowns());
    }

    /// Starts from steady rolling with a motion.
    ///
    /// # Errors
    /// [`InvalidValue`] when a number of the motion is not finite.
    pub fn start_steady(&mut self, motion: &Motion) -> Result<Rolled, InvalidValue> {
        motion.check()?;
        let rolled = self.solve(&Stage::Steady, motion);
        self.state.distance = 0.0;
        Ok(Rolled { distance: 0.0, ..rolled })
    }

    /// Shifts the bodies against each other by a force, before they roll, as
    /// [`Rolling::shift`](super::Rolling::shift).
    ///
    /// # Errors
    /// [`InvalidValue`] unless the force is below that of friction.
    pub fn shift(&mut self, fx: f64, fy: f64) -> Result<Rolled, InvalidValue> {
        let valid = "below the force of friction, mu N";
        let size = check::require(fx.hypot(fy) < 1.0, "force", fx.hypot(fy), valid)?;
        check::finite("force", size)?;
        Ok(self.shift_to(&Motion::forces(fx, fy)))
    }

    /// Rolls on, in steps of at most a twentieth of the semi-axis; of a distance longer than twelve
    /// contact lengths only the last twelve are rolled, for nothing is left then of what was before.
    ///
    /// Where a prescribed force differs from the present one by more than a twentieth of `mu N`, the
    /// bodies are shifted first, at rest.
    ///
    /// # Errors
    /// [`InvalidValue`] unless the distance is positive, all numbers are finite, and the forces are
    /// within friction's reach.
    pub fn step(&mut self, distance: f64, motion: &Motion) -> Result<Rolled, InvalidValue> {
        Self::check(distance, motion)?;
        let rest = distance.min(FORGOTTEN * 2.0 * self.semi_axis);
        self.state.distance += distance - rest;
        let steps = (rest / (LONGEST * self.semi_axis) - 1e-9).ceil().max(1.0);
        let mut smooth = self.goes_on(motion);
        let mut cost = 0;
        let mut left = steps;
        loop {
            let rolled = self.solve(&Stage::Step { length: rest / steps, smooth }, motion);
            cost += rolled.solution.statistics.iterations;
            left -= 1.0;
            if left <= 0.0 {
                let statistics = Statistics { iterations: cost, factorizations: 0 };
                return Ok(Rolled {
                    solution: Solution { statistics, ..rolled.solution },
                    ..rolled
                });
            }
            smooth = true;
        }
    }

    /// Rolls on in a single step, whatever its length.
    ///
    /// # Errors
    /// As [`RollingVariational::step`].
    pub fn advance(&mut self, distance: f64, motion: &Motion) -> Result<Rolled, InvalidValue> {
        Self::check(distance, motion)?;
        let smooth = self.goes_on(motion);
        Ok(self.solve(&Stage::Step { length: distance, smooth }, motion))
    }

    /// Distance rolled since the beginning, in units of `c`; zero before the first step.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.state.distance
    }

    fn check(distance: f64, motion: &Motion) -> Result<(), InvalidValue> {
        check::positive("distance", distance)?;
        motion.check()?;
        let size = motion.force();
        check::require(size <= 1.0, "force", size, "at most the force of friction, mu N").map(drop)
    }

    /// Whether a motion follows the last without a jump; a prescribed force that jumps has shifted the
    /// bodies then.
    fn goes_on(&mut self, motion: &Motion) -> bool {
        let differs = |(one, present): (&super::Prescribed, f64)| {
            one.force().is_some_and(|force| (force - present).abs() > JUMP)
        };
        let jumps = motion.components().iter().zip(self.state.force).any(differs);
        if jumps && !motion.nearly_slides(1.0) {
            let (before, creep) = (self.state.clone(), self.state.creep);
            let shifted = self.shift_to(&motion.without_creepage());
            if shifted.solution.status == Status::NotConverged {
                self.state = before;
            }
            self.state.creep = creep;
            return false;
        }
        self.state.motion.is_some_and(|last| motion.continues(&last))
    }

    fn shift_to(&mut self, motion: &Motion) -> Rolled {
        let at_rest = self.state.creep;
        self.state.creep = [0.0; 3];
        let rolled = self.solve(&Stage::Shift, motion);
        (self.state.creep, self.state.motion) = (at_rest, None);
        rolled
    }

    /// Solves a stage for a motion, and remembers it.
    fn solve(&mut self, stage: &Stage, motion: &Motion) -> Rolled {
        let theory = self.theory(stage);
        let start = self.state.now.clone();
        let is_steady = matches!(stage, Stage::Steady);
        let mut iterations = 0;
        let solve = |[xi, eta, chi]: Creep| {
            let from = if is_steady { Start::FullSliding } else { Start::From(&start) };
            let found = theory.solve_from(Creepage { xi, eta, chi }, &from);
            iterations += found.iterations();
            let force = found.solution.force.components();
            (found, force)
        };
        let accuracy = Accuracy { tolerance: 1e-7, difference: 1e-5 };
        let (creep, found, met) =
            solve_prescribed(motion.components(), self.state.creep, accuracy, solve);
        self.remember(stage, motion, creep, &found);
        let [xi, eta, chi] = creep;
        let (rubbing, solution) = (Rubbing::of(&found), found.solution);
        let status = if met { self.status(stage, solution.status) } else { Status::NotConverged };
        let statistics = Statistics { iterations, factorizations: 0 };
        Rolled {
            distance: self.state.distance,
            creepage: Creepage { xi, eta, chi },
            solution: Solution { status, statistics, ..solution },
            adhesion_share: rubbing.adhesion_share,
            dissipation: rubbing.dissipation,
        }
    }

    /// The theory of a stage, with what it knows of the past.
    fn theory(&self, stage: &Stage) -> Variational {
        let State { now, before, .. } = &self.state;
        let (length, smooth) = match stage {
            Stage::Steady => return self.changing.steady().clone(),
            Stage::Shift => {
                return self.changing.in_step(&Change { rolling: 0.0, present: 1.0, past: now });
            }
            Stage::Step { length, smooth } => (*length, *smooth),
        };
        let (present, past): (f64, Vec<f64>) = match before {
            Some((last, before)) if smooth && length <= LONGER * last => {
                let r = length / last;
                let [own, next, third] = [(1.0 + 2.0 * r) / (1.0 + r), 1.0 + r, r * r / (1.0 + r)];
                let past = now.iter().zip(before).map(|(now, before)| next * now - third * before);
                (own / length, past.map(|part| part / length).collect())
            }
            _ => (length.recip(), now.iter().map(|part| part / length).collect()),
        };
        self.changing.in_step(&Change { rolling: 1.0, present, past: &past })
    }

    fn remember(
        &mut self,
        stage: &Stage,
        motion: &Motion,
        creep: Creep,
        found: &VariationalSolution,
    ) {
        let state = &mut self.state;
        let last = std::mem::replace(&mut state.now, found.tau.clone());
        state.before = match stage {
            Stage::Shift => None,
            // It was as it is for ever.
            Stage::Steady => Some((FORGOTTEN * self.semi_axis, state.now.clone())),
            Stage::Step { length, .. } => Some((*length, last)),
        };
        if let Stage::Step { length, .. } = stage {
            state.distance += length;
            state.unresolved += length;
        }
        if found.solution.status == Status::Solved {
            state.unresolved = 0.0;
        }
        state.creep = creep;
        state.force = found.solution.force.components();
        state.motion = Some(*motion);
    }

    /// An area of slip that polynomials do not resolve makes the force too small, once the contact has
    /// had the way to get one.
    fn status(&self, stage: &Stage, found: Status) -> Status {
        let is_young = self.state.unresolved < 2.0 * self.semi_axis;
        match found {
            Status::CreepageTooSmall if is_young && !matches!(stage, Stage::Steady) => {
                Status::Solved
            }
            other => other,
        }
    }

    pub(super) fn state(&self) -> &State {
        &self.state
    }

    /// Takes a state of a contact with as many unknowns.
    pub(super) fn take(&mut self, state: State) -> bool {
        let unknowns = self.changing.unknowns();
        let fits = state.now.len() == unknowns
            && state.before.as_ref().is_none_or(|(_, before)| before.len() == unknowns);
        if fits {
            self.state = state;
        }
        fits
    }
}
