//! FASTSIM that is not steady: the traction of a particle grows on its way as its slip asks for,
//! whatever others do, and is cut off at its bound.
//!
//! With the flexibilities `L` of steady FASTSIM, `s = w + L (dX/dx - dX/dq)`: from the centre of one
//! cell to that of the next the traction grows by the rigid slip over `L` in between, averaged over the
//! way. Tractions at all cells are remembered, as displacements are by [`Rolling`](super::Rolling).

use super::motion::{Motion, Prescribed};
use super::past::{Ages, Creep, Level, Past};
use super::rolling::{Rolled, no_layer};
use crate::approximate::fastsim::resistance::{Resistance, Step, Walk};
use crate::approximate::fastsim::{Flexibilities, Flexibility, Settings};
use crate::approximate::linear::CreepageCoefficients;
use crate::approximate::strip::strip_slope;
use crate::check::{self, InvalidValue};
use crate::theory::{Solution, Statistics, Status};
use crate::{Contact, Creepage, Force};

/// Longest step over the semi-axis.
const LONGEST: f64 = 0.05;
const NEWTON: usize = 40;
const TOLERANCE: f64 = 1e-9;

/// FASTSIM with a memory, for one contact under a constant load.
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
    semi_axis: f64,
    /// Where friction depends on the slip or the place.
    resistance: Option<Resistance>,
    pub(super) past: Past,
    pub(super) distance: f64,
    pub(super) creep: Creep,
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
        let coefficients = CreepageCoefficients::new(contact)?;
        let (ellipse, [cells, across]) = (contact.ellipse(), settings.grid);
        for (name, number) in [("grid along", cells), ("grid across", across)] {
            let valid = "at least 1 and no more than 10000";
            let range = 1..=Settings::MAX_CELLS;
            check::require(range.contains(&number), name, number as f64, valid)?;
        }
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
        let resistance = Resistance::new(contact);
        let begin = level(0.0, [0.0; 3], cells * across, resistance.is_some());
        Ok(Self {
            flexibilities: Flexibilities::new(&ellipse, slope, &coefficients)?,
            flexibility: settings.flexibility,
            strips: (0..across).map(strip).collect(),
            cells,
            semi_axis: ellipse.a(),
            resistance,
            past: Past(std::iter::once(begin).collect()),
            distance: 0.0,
            creep: [0.0; 3],
        })
    }

    /// Rolls on.
    ///
    /// # Errors
    /// [`InvalidValue`] unless the distance is positive, all numbers are finite, and the forces are
    /// within friction's reach.
    pub fn step(&mut self, distance: f64, motion: &Motion) -> Result<Rolled, InvalidValue> {
        check::positive("distance", distance)?;
        motion.check()?;
        let [fx, fy, _] = motion.components().map(|one| one.force().unwrap_or(0.0));
        let size = fx.hypot(fy);
        check::require(size <= 1.0, "force", size, "at most the force of friction, mu N")?;
        let steps = (distance / (LONGEST * self.semi_axis)).ceil().max(1.0);
        let length = distance / steps;
        let mut left = steps;
        loop {
            let (level, sum, solved) = self.meet(length, motion);
            self.creep = level.creep;
            self.past.forget_beyond(2.0 * self.semi_axis / self.cells as f64);
            self.past.0.push_front(level);
            self.distance += length;
            left -= 1.0;
            if left < 0.5 {
                return Ok(self.rolled(&sum, solved));
            }
        }
    }

    /// Starts from steady rolling with a motion: a particle is in the contact for one contact length.
    ///
    /// # Errors
    /// As [`RollingFastsim::step`].
    pub fn start_steady(&mut self, motion: &Motion) -> Result<Rolled, InvalidValue> {
        let rolled = self.step(2.5 * self.semi_axis, motion)?;
        self.distance = 0.0;
        Ok(Rolled { distance: 0.0, ..rolled })
    }

    /// Distance rolled since the beginning, in units of `c`; zero before the first step.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// Number of cells.
    pub(super) fn size(&self) -> usize {
        self.cells * self.strips.len()
    }

    fn rolled(&self, sum: &Sum, solved: bool) -> Rolled {
        let [xi, eta, chi] = self.creep;
        let [fx, fy, mz] = sum.force;
        let status = if solved { Status::Solved } else { Status::NotConverged };
        let force = Force { fx, fy, mz };
        let statistics = Statistics::default();
        Rolled {
            distance: self.distance,
            creepage: Creepage { xi, eta, chi },
            solution: Solution { force, error: None, status, statistics },
            adhesion_share: sum.adhesion / sum.area,
            dissipation: sum.dissipation,
        }
    }

    /// The step at the creepage that meets the prescribed forces, by Newton's method with differences.
    fn meet(&self, length: f64, motion: &Motion) -> (Level, Sum, bool) {
        const DIFFERENCE: f64 = 1e-6;
        let prescribed = motion.components();
        let mut creep = self.creep;
        for (creep, prescribed) in creep.iter_mut().zip(prescribed) {
            *creep = prescribed.creepage().unwrap_or(*creep);
        }
        let unknown: Vec<usize> = (0..3).filter(|k| prescribed[*k].force().is_some()).collect();
        let off = |sum: &Sum, k: usize| match prescribed[k] {
            Prescribed::Force(value) => value - sum.force[k],
            Prescribed::Creepage(_) => 0.0,
        };
        let (mut level, mut sum) = self.march(length, creep);
        for _ in 0..NEWTON {
            if unknown.iter().all(|k| off(&sum, *k).abs() < TOLERANCE) {
                return (level, sum, true);
            }
            let n = unknown.len();
            let columns = unknown.iter().map(|k| {
                let mut moved = creep;
                moved[*k] += DIFFERENCE;
                self.march(length, moved).1
            });
            let columns: Vec<Sum> = columns.collect();
            let entry = |i: usize, k: usize| {
                (columns[k].force[unknown[i]] - sum.force[unknown[i]]) / DIFFERENCE
            };
            let residual =
                nalgebra::DVector::from_iterator(n, unknown.iter().map(|k| off(&sum, *k)));
            let matrix = nalgebra::DMatrix::from_fn(n, n, entry);
            let step = matrix.lu().solve(&residual);
            let Some(step) = step.filter(|s| s.iter().all(|s| s.is_finite())) else { break };
            let mut shorter = 1.0;
            for _ in 0..NEWTON {
                let mut moved = creep;
                unknown.iter().zip(step.iter()).for_each(|(k, s)| moved[*k] += shorter * s);
                (level, sum) = self.march(length, moved);
                let next = unknown.iter().map(|k| off(&sum, *k).powi(2)).sum::<f64>().sqrt();
                if next < residual.norm() {
                    creep = moved;
                    break;
                }
                shorter *= 0.5;
            }
        }
        let solved = unknown.iter().all(|k| off(&sum, *k).abs() < TOLERANCE);
        (level, sum, solved)
    }

    /// A step at a creepage.
    fn march(&self, length: f64, creep: Creep) -> (Level, Sum) {
        let ages = self.past.seen_after(length, 1.0, true);
        let mut level = self::level(length, creep, self.size(), self.resistance.is_some());
        level.smooth = true;
        let mut sum = Sum::default();
        for (j, strip) in self.strips.iter().enumerate() {
            self.march_strip(j * self.cells, strip, &ages, &mut level, &mut sum);
        }
        (level, sum)
    }

    fn march_strip(
        &self,
        first: usize,
        strip: &Strip,
        ages: &Ages,
        level: &mut Level,
        sum: &mut Sum,
    ) {
        let step = 2.0 * strip.half_length / self.cells as f64;
        for i in 0..self.cells {
            let way = if i == 0 { 0.5 * step } else { step };
            let back = way.min(ages.origin());
            let x = strip.half_length - (i as f64 + 0.5) * step;
            let mut walk = self.friction_before(first, i, ages, level, back);
            walk.traction = self.before(first, i, back / way, ages, level, back);
            let creep = self.mean(ages, level, back);
            let slides = self.advance(&mut walk, strip, [x, back], strip.along[i], creep);
            let Walk { traction, lost, friction, slip, .. } = walk;
            (0..2).for_each(|k| level.displacement[k][first + i] = traction[k]);
            for (values, value) in level.friction.iter_mut().zip([friction, slip]) {
                values.get_mut(first + i).into_iter().for_each(|known| *known = value);
            }
            sum.add(strip, x, traction, slides);
            if slides {
                let [l1, l2, _] = self.flexibilities.effective(self.flexibility, creep);
                let factor = (self.flexibilities.kappa() * back).recip();
                let slip = [l1 * lost[0], l2 * lost[1]].map(|s| factor * s);
                sum.dissipation += strip.area * (traction[0] * slip[0] + traction[1] * slip[1]);
            }
        }
    }

    /// Takes a particle over the last `back` of its way to `x`; whether it slides then.
    fn advance(
        &self,
        walk: &mut Walk,
        strip: &Strip,
        [x, back]: [f64; 2],
        along: f64,
        creep: Creep,
    ) -> bool {
        let slopes = self.flexibilities.slopes(self.flexibility, creep);
        let growth = slopes.at([x + 0.5 * back, strip.y]).map(|slope| back * slope);
        let bound = strip.peak * along;
        let Some(resistance) = &self.resistance else {
            let trial = [0, 1].map(|k| walk.traction[k] + growth[k]);
            let size = trial[0].hypot(trial[1]);
            let part = if size > bound { bound / size } else { 1.0 };
            walk.traction = trial.map(|t| t * part);
            walk.lost = [0, 1].map(|k| trial[k] - walk.traction[k]);
            return size > bound;
        };
        let [xi, eta, chi] = creep;
        let rigid_slip = [xi - chi * strip.y, eta + chi * x];
        let bound = resistance.share(strip.y) * bound;
        let step = Step { length: back, growth, bound, rigid_slip, flexibility: 0.0 };
        resistance.advance(walk, &step);
        walk.slip > 0.0
    }

    /// A particle some distance back, at the cell upstream: its friction and slip.
    fn friction_before(
        &self,
        first: usize,
        i: usize,
        ages: &Ages,
        present: &Level,
        back: f64,
    ) -> Walk {
        let mut walk = Walk::start();
        if self.resistance.is_none() || i == 0 {
            return walk;
        }
        let upstream = |level: &Level| [0, 1].map(|k| level.friction[k][first + i - 1]);
        let weights = ages.weights(back);
        let [mut friction, mut slip] = upstream(present).map(|value| weights.present * value);
        for (level, weight) in weights.levels {
            let known = upstream(&self.past.0[level]);
            (friction, slip) = (friction + weight * known[0], slip + weight * known[1]);
        }
        (walk.friction, walk.slip) = (friction.clamp(0.0, 1.0), slip.max(0.0));
        walk
    }

    /// Traction of a particle some distance back, at the cell upstream or a part of the way to it.
    fn before(
        &self,
        first: usize,
        i: usize,
        part: f64,
        ages: &Ages,
        present: &Level,
        back: f64,
    ) -> [f64; 2] {
        let weights = ages.weights(back);
        let at = |level: &Level| {
            let own = level.at(first + i);
            let upstream = if i == 0 { [0.0; 2] } else { level.at(first + i - 1) };
            [0, 1].map(|k| part * upstream[k] + (1.0 - part) * own[k])
        };
        let mut traction = [0.0; 2];
        let mut add = |value: [f64; 2], weight: f64| {
            (0..2).for_each(|k| traction[k] += weight * value[k]);
        };
        if weights.present != 0.0 && i > 0 {
            add(present.at(first + i - 1), weights.present);
        }
        for (level, weight) in weights.levels {
            if weight != 0.0 {
                add(at(&self.past.0[level]), weight);
            }
        }
        traction
    }

    /// Creepage averaged over a way back.
    fn mean(&self, ages: &Ages, present: &Level, back: f64) -> Creep {
        let mut sums = present.creep.map(|part| part * back.min(present.length));
        for (level, start) in self.past.0.iter().zip(&ages.back[1..]) {
            let part = (start + level.length).min(back) - start;
            if part > 0.0 {
                sums.iter_mut().zip(level.creep).for_each(|(sum, creep)| *sum += part * creep);
            }
        }
        sums.map(|sum| sum / back)
    }
}

/// No traction, friction at rest; that of each cell where it depends on something.
fn level(length: f64, creep: Creep, cells: usize, varies: bool) -> Level {
    let remembered = if varies { cells } else { 0 };
    Level {
        length,
        scale: 1.0,
        creep,
        smooth: false,
        displacement: [vec![0.0; cells], vec![0.0; cells]],
        friction: [vec![1.0; remembered], vec![0.0; remembered]],
    }
}

/// What tractions add up to.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    force: [f64; 3],
    adhesion: f64,
    area: f64,
    dissipation: f64,
}

impl Sum {
    fn add(&mut self, strip: &Strip, x: f64, [p, q]: [f64; 2], slides: bool) {
        let parts = [p, q, x * q - strip.y * p];
        self.force.iter_mut().zip(parts).for_each(|(sum, part)| *sum += strip.area * part);
        self.area += strip.area;
        self.adhesion += if slides { 0.0 } else { strip.area };
    }
}
