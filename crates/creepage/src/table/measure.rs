//! Accuracy of a table against its theory, measured at random and at hard places when it is built.

use super::bends;
use super::build::BuildError;
use super::coordinates::Coordinates;
use super::in_memory::Table;
use super::spec::Spec;
use crate::{Contact, Ellipse, Theory};
use rayon::prelude::*;

/// How many random places share a theory, where each must be prepared for its shape and Poisson's
/// ratio.
const SHARED: usize = 24;

/// Errors of force and moment.
type Errors = Vec<[f64; 2]>;

/// Measurement of a table's error, with its progress callback.
pub(crate) struct Measure<'a, P> {
    pub(crate) table: &'a Table,
    pub(crate) prepare: P,
    pub(crate) done: &'a (dyn Fn() + Sync),
}

impl<E, P> Measure<'_, P>
where
    E: std::error::Error,
    P: Fn(&Contact) -> Result<Box<dyn Theory>, E>,
{
    /// At as many random and hard places as `spec` says.
    pub(crate) fn accuracy(&self, spec: &Spec) -> Result<Accuracy, BuildError<E>> {
        let (random, hard) = (self.random(spec.places)?, self.hard(spec)?);
        let spread = |which: usize| {
            let errors = |of: &Errors| of.iter().map(|error| error[which]).collect::<Vec<_>>();
            Spread::new(errors(&random), &errors(&hard))
        };
        let [force, moment] = [spread(0), spread(1)];
        Ok(Accuracy { places: random.len(), hard_places: hard.len(), force, moment })
    }

    fn random(&self, places: usize) -> Result<Errors, BuildError<E>> {
        use std::f64::consts::{FRAC_PI_2, PI};
        let mut random = Random(1967);
        let group = if self.table.blocks.len() == 1 { places } else { SHARED };
        let mut errors = Vec::with_capacity(places);
        while errors.len() < places {
            let shape = [random.next(), random.next()];
            let count = group.min(places - errors.len());
            let at = (0..count).map(|_| [0; 3].map(|_| random.next()));
            let at = at.map(|[theta, phi, t]| [theta * FRAC_PI_2, (phi - 0.5) * PI, t]).collect();
            errors.extend(self.errors(shape, at)?);
        }
        Ok(errors)
    }

    fn hard(&self, spec: &Spec) -> Result<Errors, BuildError<E>> {
        let mut errors = Vec::with_capacity(spec.hard_places());
        for shape in spec.middles() {
            let values = self.table.mixed(self.table.windows(shape));
            let cells = bends::cells(&values, spec.intervals, spec.hard_places_each());
            let at = cells.into_iter().map(|cell| spec.intervals.middle(cell)).collect();
            errors.extend(self.errors(shape, at)?);
        }
        Ok(errors)
    }

    /// Of places `theta`, `phi`, `t` for a shape and a Poisson's ratio given by their shares.
    fn errors(&self, shape: [f64; 2], at: Vec<[f64; 3]>) -> Result<Errors, BuildError<E>> {
        let (shapes, materials) = (self.table.a_over_b, self.table.poisson);
        let (a_over_b, poisson) = (shapes.geometric(shape[0]), materials.even(shape[1]));
        let contact = Contact::new(Ellipse::from_ratio(a_over_b)?, poisson)?;
        let theory = (self.prepare)(&contact).map_err(BuildError::Theory)?;
        let slice = self.table.at(a_over_b, poisson)?;
        let coordinates = Coordinates::new(a_over_b);
        let error = |at| {
            let creepage = coordinates.creepage(at);
            let (found, right) = (slice.force(creepage), theory.solve(creepage).force);
            (self.done)();
            [(found.fx - right.fx).hypot(found.fy - right.fy), (found.mz - right.mz).abs()]
        };
        Ok(at.into_par_iter().map(error).collect())
    }
}

/// `SplitMix64` (Steele, Lea, Flood 2014): the same places in every build.
struct Random(u64);

impl Random {
    /// Between 0 and 1, never quite 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((bits ^ (bits >> 31)) >> 11) as f64) / (1_u64 << 53) as f64
    }
}

/// Distribution of an error.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Spread {
    /// Half of the random places err by less.
    pub median: f64,
    /// 95 of 100 random places err by less.
    pub p95: f64,
    /// 99 of 100 random places err by less.
    pub p99: f64,
    /// Largest of all, random and hard.
    pub worst: f64,
}

/// The error of a table against its theory, none of it at a node: at places spread at random and
/// evenly over the table's coordinates, and at hard ones, the middles of the cells where the
/// force bends most, half-way between shapes and Poisson's ratios.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Accuracy {
    /// Number of random places.
    pub places: usize,
    /// Number of hard places.
    pub hard_places: usize,
    /// Length of the difference of `(f_x, f_y)`, in parts of `mu N`.
    pub force: Spread,
    /// Size of the difference of `m_z`, in parts of `mu N c`.
    pub moment: Spread,
}

impl Spread {
    pub(crate) fn new(mut random: Vec<f64>, hard: &[f64]) -> Self {
        random.sort_unstable_by(f64::total_cmp);
        let at = |hundredths: usize| {
            random.get(random.len() * hundredths / 100).copied().unwrap_or_default()
        };
        let worst = random.iter().chain(hard).copied().fold(0.0, f64::max);
        Self { median: at(50), p95: at(95), p99: at(99), worst }
    }
}
