//! Warm start from a solved position: the pitch rate, the load sharing, and the predictor's error.

use creepage_rail::{Contact, Side};

use crate::tilt::{Placed, distance};

/// A pitch rate nearby, closer to balance than the one rolled with, and how the moment about the axle rises
/// with it (N m s/rad).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct PitchState {
    pub(crate) rate: Option<f64>,
    pub(crate) slope: Option<f64>,
}

/// Correction of the predictor: by how much a wheelset came to stand and turn otherwise than was expected from
/// the position before, as pressing and rolling change while the contacts go along the profiles. A next step in
/// the same direction drifts by as much in proportion.
#[derive(Debug, Clone)]
pub(crate) struct PredictorCorrection {
    /// The step in shift and yaw, over what is near.
    pub(crate) step: [f64; 2],
    /// Lower (m) and rolled (rad) by so much, each wheel.
    pub(crate) by: Vec<[f64; 2]>,
    /// By how much faster the left and the right wheel turn (rad/s).
    pub(crate) faster: [f64; 2],
    /// By how much more friction pushes each contact aside.
    pub(crate) shares: LateralForceRatios,
    /// By how much the areas of each contact, in the wheelset's order, reach further out on both sides (m).
    pub(crate) sides: Vec<Vec<[f64; 2]>>,
}

/// Warm start of the vertical loads, from a position that was solved before.
#[derive(Debug, Clone, Default)]
pub(crate) struct LateralForceRatios {
    /// Lateral and longitudinal force over load of contacts by their spot: what friction adds.
    ratios: Vec<(Side, [f64; 2], [f64; 2])>,
}

impl LateralForceRatios {
    /// Remembers a contact by its spot.
    pub(crate) fn push(&mut self, side: Side, spot: [f64; 2], shares: [f64; 2]) {
        self.ratios.push((side, spot, shares));
    }

    /// Adds to each contact's share so many times that of another.
    pub(crate) fn add_times(&mut self, times: f64, other: &Self) {
        for (side, spot, shares) in &mut self.ratios {
            let near = other.near(*side, *spot);
            *shares = [0, 1].map(|k: usize| shares[k] + times * near[k]);
        }
    }

    /// Lateral and longitudinal force over load of a contact.
    pub(crate) fn of(&self, contact: &Contact<'_>) -> [f64; 2] {
        self.near(contact.side, contact.spot())
    }

    /// That of the nearest contact; nothing where none is known.
    fn near(&self, side: Side, spot: [f64; 2]) -> [f64; 2] {
        let own = self.ratios.iter().filter(|known| known.0 == side);
        let nearest = own.min_by(|a, b| distance(a.1, spot).total_cmp(&distance(b.1, spot)));
        nearest.map_or([0.0; 2], |&(.., shares)| shares)
    }
}
