//! Varying load in transient rolling: in a straight line over a step, in parts within which the contact grows or shrinks
//! by little.

use super::motion::{Motion, Prescribed};

/// Largest change of the contact's size in a part.
const GROWTH: f64 = 0.04;
/// Bodies touch first, and part at last, at this fraction of the load to come or gone: what tractions
/// there are until then is as small.
const TOUCH: f64 = 1e-3;

/// The load over one step, and the motion with it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Course {
    /// Loads at its beginning and its end, over the nominal one.
    loads: [f64; 2],
    distance: f64,
    motion: Motion,
    /// The forces at the beginning, where those asked for are beyond friction there.
    forces: Option<[f64; 3]>,
}

impl Course {
    /// From a load to another, with the forces that there are.
    pub(super) fn new(loads: [f64; 2], force: [f64; 3], distance: f64, motion: &Motion) -> Self {
        let is_beyond = loads[1] > loads[0] && motion.nearly_slides(loads[0]);
        let forces = is_beyond.then_some(force);
        Self { loads, distance, motion: *motion, forces }
    }

    /// The load after some part of the distance.
    pub(super) fn load(&self, rolled: f64) -> f64 {
        let [from, to] = self.loads;
        let part = (rolled / self.distance).min(1.0);
        if part < 1.0 { from + part * (to - from) } else { to }
    }

    /// The motion there: as asked for, but that forces which friction cannot give at the beginning grow
    /// with the load, from those that there are.
    pub(super) fn motion(&self, rolled: f64) -> Motion {
        let Some(forces) = self.forces else { return self.motion };
        let part = (rolled / self.distance).min(1.0);
        let at = |prescribed: Prescribed, before: f64| match prescribed {
            Prescribed::Force(to) => Prescribed::Force(before + part * (to - before)),
            Prescribed::Creepage(_) => prescribed,
        };
        let Motion { longitudinal, lateral, spin } = self.motion;
        Motion {
            longitudinal: at(longitudinal, forces[0]),
            lateral: at(lateral, forces[1]),
            spin: at(spin, forces[2]),
        }
    }

    /// How far the contact may roll from there on in one part.
    pub(super) fn longest(&self, rolled: f64) -> f64 {
        let ([from, to], load) = (self.loads, self.load(rolled));
        let touch = TOUCH * from.max(to);
        let whole = (to - from).abs();
        let volume = (1.0 + GROWTH).powi(3);
        let change = if to > from {
            (load * (volume - 1.0)).max(touch - load)
        } else if load > touch {
            load * (1.0 - volume.recip())
        } else {
            load
        };
        if whole > 0.0 { self.distance * (change / whole) } else { self.distance }
    }
}
