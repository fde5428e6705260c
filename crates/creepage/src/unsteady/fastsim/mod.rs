//! Transient FASTSIM: the traction of a particle grows on its way as its slip asks for, whatever others do, and is cut
//! off at its bound.
//!
//! With the flexibilities `L` of steady FASTSIM, `s = w + L (dX/dx - dX/dq)`: from the centre of one
//! cell to that of the next the traction grows by the rigid slip over `L` in between, averaged over the
//! way. Tractions at all cells are remembered, as displacements are by [`Rolling`](super::Rolling).

mod arriving;
mod march;

use march::Sum;

use super::history::{Creep, Past, TimeLevel};
use super::load::Course;
use super::motion::Motion;
use super::prescribed_forces::{Accuracy, solve_prescribed};
use super::rolling::{Rolled, no_layer};
use crate::approximate::fastsim::friction_bound::FrictionBound;
use crate::approximate::fastsim::{Flexibilities, Flexibility, Settings};
use crate::approximate::linear::CreepageCoefficients;
use crate::approximate::strip::strip_slope;
use crate::check::{self, InvalidValue};
use crate::theory::{Solution, Statistics, Status};
use crate::{Contact, Creepage, Force};

/// Longest step over the semi-axis under the load.
const LONGEST: f64 = 0.05;
/// Size of the contact from which on that counts.
const SMALLEST: f64 = 0.1;
/// Contact lengths after which nothing is left of what was before: a particle stays for one, and a
/// creepage found from a force, an average of those over the last one, settles by a factor of more than
/// five in each.
const FORGOTTEN: f64 = 12.0;

/// FASTSIM with a memory, for one contact.
///
/// ```
/// use creepage::approximate::fastsim::{Fastsim, Settings};
/// use creepage::unsteady::{Motion, RollingFastsim};
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let contact = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
/// let creepage = Creepage::new(0.5, 0.2, 0.3)?;
/// let mut rolling = RollingFastsim::new(&contact, Settings::default())?;
/// let end = rolling.step(3.0, &Motion::from(creepage))?.solution.force;
/// let steady = Fastsim::new(&contact, Settings::default())?.solve(creepage).force;
/// assert!((end.fx - steady.fx).abs() < 1e-3); // after a contact length it forgets
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct RollingFastsim {
    flexibilities: Flexibilities,
    flexibility: Flexibility,
    strips: Vec<Strip>,
    cells: usize,
    /// Under the nominal load, in units of `c`.
    semi_axes: [f64; 2],
    /// Where friction depends on the slip or the place.
    resistance: Option<FrictionBound>,
    pub(super) past: Past,
    pub(super) travel: RollingState,
}

/// State of rolling: where the contact is, how it is loaded and how it last moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RollingState {
    pub distance: f64,
    /// Normal force over the nominal one, now and at the end of the next step.
    pub loads: [f64; 2],
    pub creep: Creep,
    pub force: [f64; 3],
}

#[derive(Debug, Clone)]
struct Strip {
    y: f64,
    half_length: f64,
    /// Largest traction bound.
    peak: f64,
    /// Bound of each cell, over that.
    along: Vec<f64>,
    /// Area of a cell.
    area: f64,
}

impl RollingFastsim {
    /// The contact just pressed together, without traction.
    ///
    /// # Errors
    /// [`InvalidValue`] as [`Fastsim::new`](crate::approximate::fastsim::Fastsim::new), and for a contact
    /// with a layer.
    pub fn new(contact: &Contact, settings: Settings) -> Result<Self, InvalidValue> {
        no_layer(contact)?;
        contact.require_no_added_slip()?;
        let coefficients = CreepageCoefficients::interpolated(contact)?;
        let (ellipse, [cells, across]) = (contact.ellipse(), settings.grid);
        for (name, number) in [("grid along", cells), ("grid across", across)] {
            let valid = "at least 1 and no more than 10000";
            let range = 1..=Settings::MAX_CELLS;
            check::require(range.contains(&number), name, number as f64, valid)?;
        }
        let valid = "[1, 1, ..] where springs remember their load";
        check::require(settings.is_clean(), "reduction", settings.reduction[0], valid)?;
        let profile = settings.bound.profile(1.0);
        let strip = |j: usize| {
            let t = (2.0 * j as f64 + 1.0) / across as f64 - 1.0;
            let s = (1.0 - t * t).sqrt();
            let half_length = ellipse.a() * s;
            let width = 2.0 * ellipse.b() / across as f64;
            let at = |i: usize| profile.along(1.0 - (2.0 * i as f64 + 1.0) / cells as f64);
            Strip {
                y: ellipse.b() * t,
                half_length,
                peak: profile.peak(s),
                along: (0..cells).map(at).collect(),
                area: 2.0 * half_length / cells as f64 * width,
            }
        };
        let slope = strip_slope(&ellipse, contact.poisson());
        let resistance = FrictionBound::new(contact);
        let begin = level(0.0, 1.0, cells * across, resistance.is_some());
        Ok(Self {
            flexibilities: Flexibilities::new(&ellipse, slope, &coefficients)?,
            flexibility: settings.flexibility,
            strips: (0..across).map(strip).collect(),
            cells,
            semi_axes: [ellipse.a(), ellipse.b()],
            resistance,
            past: Past(std::iter::once(begin).collect()),
            travel: RollingState {
                distance: 0.0,
                loads: [1.0; 2],
                creep: [0.0; 3],
                force: [0.0; 3],
            },
        })
    }

    /// Presses with another normal force, over the nominal one: in the next step the force goes there in
    /// a straight line, as in [`Rolling::press`](super::Rolling::press).
    ///
    /// # Errors
    /// [`InvalidValue`] unless `load` lies between 0 and a million.
    pub fn press(&mut self, load: f64) -> Result<(), InvalidValue> {
        let valid = "between 0 and 1e6";
        self.travel.loads[1] = check::require((0.0..=1e6).contains(&load), "load", load, valid)?;
        Ok(())
    }

    /// Starts anew under another normal force, over the nominal one, without traction.
    ///
    /// # Errors
    /// [`InvalidValue`] as [`RollingFastsim::press`].
    pub fn start_with_load(&mut self, load: f64) -> Result<(), InvalidValue> {
        self.press(load)?;
        self.begin(load);
        self.travel.distance = 0.0;
        Ok(())
    }

    /// Rolls on; of a distance longer than twelve contact lengths only the last twelve are marched, for
    /// nothing is left then of what was before (less than `1e-6 mu N`, a creepage found from a force
    /// included).
    ///
    /// # Errors
    /// [`InvalidValue`] unless the distance is positive, all numbers are finite, and the forces are
    /// within friction's reach.
    pub fn step(&mut self, distance: f64, motion: &Motion) -> Result<Rolled, InvalidValue> {
        check::positive("distance", distance)?;
        motion.check()?;
        let (size, most) = (motion.force(), self.travel.loads[1]);
        check::require(size <= most, "force", size, "at most the force of friction, mu N")?;
        if most == 0.0 {
            // The bodies part at its end.
            return Ok(self.advance(distance, 0.0, motion));
        }
        let course = Course::new(self.travel.loads, self.travel.force, distance, motion);
        let mut remaining = self.skip(distance);
        loop {
            // Counted from the end: next to a long distance a short step would be lost in rounding.
            let rolled_on = distance - remaining;
            let size = course.load(rolled_on).cbrt().max(SMALLEST);
            let longest = course.longest(rolled_on).min(LONGEST * size * self.semi_axes[0]);
            let steps = (remaining / longest - 1e-9).ceil().max(1.0);
            let is_last = steps <= 1.0;
            let length = if is_last { remaining } else { remaining / steps };
            remaining = if is_last { 0.0 } else { remaining - length };
            let end = if is_last { distance } else { distance - remaining };
            let (load, motion) = (course.load(end), course.motion(end));
            let rolled = self.advance(length, load, &motion);
            if is_last {
                return Ok(rolled);
            }
        }
    }

    /// Leaves out the beginning of a long distance, of which the contact remembers nothing at its end;
    /// gives the rest.
    fn skip(&mut self, distance: f64) -> f64 {
        let [from, to] = self.travel.loads;
        let size = from.max(to).cbrt().max(SMALLEST);
        let rest = distance.min(FORGOTTEN * 2.0 * self.semi_axes[0] * size);
        self.travel.distance += distance - rest;
        rest
    }

    /// One step to a load.
    fn advance(&mut self, length: f64, load: f64, motion: &Motion) -> Rolled {
        self.travel.distance += length;
        if load == 0.0 {
            self.begin(0.0);
            self.travel.creep = motion.components().map(|one| one.creepage().unwrap_or(0.0));
            return self.rolled(&Sum::default(), true);
        }
        if self.travel.loads[0] == 0.0 {
            self.begin(load);
        }
        let (level, sum, solved) = self.solve_prescribed(length, load.cbrt(), motion);
        self.travel.creep = level.creep;
        self.travel.force = sum.force;
        self.travel.loads[0] = load;
        let largest = self.past.0.iter().map(|level| level.scale).fold(level.scale, f64::max);
        self.past.forget_beyond(largest * 2.0 * self.semi_axes[0] / self.cells as f64);
        self.past.0.push_front(level);
        self.rolled(&sum, solved)
    }

    /// The step at the creepage that meets the prescribed forces, from the last creepage.
    fn solve_prescribed(&self, length: f64, scale: f64, motion: &Motion) -> (TimeLevel, Sum, bool) {
        let accuracy = Accuracy { tolerance: 1e-9 * scale.powi(3), difference: 1e-6 };
        let march = |creep| {
            let (level, sum) = self.march([length, scale], creep);
            ((level, sum), sum.force)
        };
        let (_, (level, sum), solved) =
            solve_prescribed(motion.components(), self.travel.creep, accuracy, march);
        (level, sum, solved)
    }

    /// The bodies touch under a load, without traction.
    fn begin(&mut self, load: f64) {
        let scale = if load > 0.0 { load.cbrt() } else { 1.0 };
        self.past.0.clear();
        self.past.0.push_front(level(0.0, scale, self.size(), self.resistance.is_some()));
        self.travel.loads[0] = load;
        (self.travel.creep, self.travel.force) = ([0.0; 3], [0.0; 3]);
    }

    /// Starts from steady rolling with a motion: a particle is in the contact for one contact length.
    ///
    /// # Errors
    /// As [`RollingFastsim::step`].
    pub fn start_steady(&mut self, motion: &Motion) -> Result<Rolled, InvalidValue> {
        let size = self.travel.loads[0].cbrt().max(f64::MIN_POSITIVE);
        let rolled = self.step(2.5 * self.semi_axes[0] * size, motion)?;
        self.travel.distance = 0.0;
        Ok(Rolled { distance: 0.0, ..rolled })
    }

    /// Distance rolled since the beginning, in units of `c`; zero before the first step.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.travel.distance
    }

    /// Number of cells.
    pub(super) fn size(&self) -> usize {
        self.cells * self.strips.len()
    }

    fn rolled(&self, sum: &Sum, solved: bool) -> Rolled {
        let [xi, eta, chi] = self.travel.creep;
        let [fx, fy, mz] = sum.force;
        // The sum of the bound over cells is beyond friction by the error of its quadrature.
        let beyond = (fx.hypot(fy) / self.travel.loads[0].max(f64::MIN_POSITIVE)).max(1.0);
        let [fx, fy] = [fx, fy].map(|part| part / beyond);
        let status = if solved { Status::Solved } else { Status::NotConverged };
        let force = Force { fx, fy, mz };
        let statistics = Statistics::default();
        Rolled {
            distance: self.travel.distance,
            creepage: Creepage { xi, eta, chi },
            solution: Solution { force, error: None, status, statistics },
            adhesion_share: if sum.area > 0.0 { sum.adhesion / sum.area } else { 0.0 },
            dissipation: sum.dissipation,
        }
    }
}

/// No traction, friction at rest; that of each cell where it depends on something.
fn level(length: f64, scale: f64, cells: usize, varies: bool) -> TimeLevel {
    let remembered = if varies { cells } else { 0 };
    TimeLevel {
        length,
        scale,
        creep: [0.0; 3],
        smooth: false,
        displacement: [vec![0.0; cells], vec![0.0; cells]],
        friction: [vec![1.0; remembered], vec![0.0; remembered], vec![]],
    }
}
