//! Rigid slip of a contact; on a curved one, what it has beyond creepage and spin at the reference point.

use creepage::{Creepage, Scaling};
use creepage_rail::{Contact, Motion, RollingCreepage};

/// Rows across the contact at which the slip is looked up.
const ROWS: u32 = 64;
/// Half the distance along `x` between the two places of a row, over the overlap's length.
const APART: f64 = 0.2;

/// Rigid motion for which rolling is solved, in a theory's units.
#[derive(Debug, Clone)]
pub(crate) struct RigidMotion {
    pub(crate) creepage: Creepage,
    pub(crate) scaling: Scaling,
    pub(crate) curving: Option<Curving>,
}

impl RigidMotion {
    /// What a curved contact adds to the rigid slip at a place.
    pub(crate) fn more(&self, at: [f64; 2]) -> [f64; 2] {
        let Self { scaling, curving, .. } = self;
        let Some(curving) = curving else { return [0.0; 2] };
        curving.at(at.map(|at| at * scaling.length)).map(|slip| slip / scaling.slip)
    }
}

/// Slip over the rolling speed beyond that of a flat contact, by rows across, linear between
/// them and along each.
#[derive(Debug, Clone)]
pub(crate) struct Curving {
    rows: Vec<Row>,
}

#[derive(Debug, Clone, Copy)]
struct Row {
    s: f64,
    x: f64,
    slip: [f64; 2],
    /// Change of the slip along `x` (1/m).
    along: [f64; 2],
}

impl Curving {
    /// Looks the slip of a contact up, for a motion with the given creepage.
    pub(crate) fn new(contact: &Contact<'_>, motion: &Motion, creepage: RollingCreepage) -> Self {
        let [[back, front], [low, high]] = contact.extent;
        let apart = APART * (front - back);
        let more = |x: f64, s: f64| {
            let [along, across] = contact.rigid_slip(motion, x, s)?;
            let RollingCreepage { longitudinal, lateral, spin, .. } = creepage;
            Some([along - (longitudinal - spin * s), across - (lateral + spin * x)])
        };
        let row = |k: u32| {
            let s = low + (high - low) * f64::from(k) / f64::from(ROWS);
            let x = contact.at(s)?.x;
            // Off the locus the wheel falls away from the plane: that is the gap, and no slip.
            let slip = more(x, s)?;
            let (before, after) = (more(x - apart, s)?, more(x + apart, s)?);
            let along = [0, 1].map(|i: usize| 0.5 * (after[i] - before[i]) / apart);
            Some(Row { s, x, slip, along })
        };
        Self { rows: (0..=ROWS).filter_map(row).collect() }
    }

    /// The slip beyond creepage and spin at a place (m); beyond the rows that of the outermost.
    fn at(&self, [x, s]: [f64; 2]) -> [f64; 2] {
        let after = self.rows.partition_point(|row| row.s <= s);
        let low = after.checked_sub(1).and_then(|i| self.rows.get(i));
        match (low, self.rows.get(after)) {
            (Some(low), Some(high)) => {
                let part = (s - low.s) / (high.s - low.s);
                let (low, high) = (low.at(x), high.at(x));
                [0, 1].map(|i: usize| low[i] + part * (high[i] - low[i]))
            }
            (Some(row), None) | (None, Some(row)) => row.at(x),
            (None, None) => [0.0; 2],
        }
    }
}

impl Row {
    fn at(&self, x: f64) -> [f64; 2] {
        [0, 1].map(|i: usize| self.slip[i] + self.along[i] * (x - self.x))
    }
}
