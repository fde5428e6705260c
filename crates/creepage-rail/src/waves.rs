//! Waviness of a profile: how far its surface turns to and fro.

use crate::curve::{Curve, turn};

/// Spacing of the places at which a piece's direction is looked at, where its ends do not tell (m).
const DIRECTION_SPACING: f64 = 5e-5;

/// Waves on a stretch of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waves {
    /// How many whole ones there are.
    pub count: usize,
    /// Their mean length (m).
    pub length: f64,
    /// How far the surface turns from one side of a wave to the other, on the mean (rad).
    pub swing: f64,
}

impl Waves {
    /// Those between two arc lengths (m) of a curve that turn it by more than `least` (rad) to and
    /// fro; `None` without a whole one.
    pub(crate) fn of(curve: &Curve, [from, to]: [f64; 2], least: f64) -> Option<Self> {
        let [from, to] = [from, to].map(|s| s.clamp(0.0, curve.length()));
        let start = curve.at(from).tangent;
        let mut extremes: Vec<[f64; 2]> = vec![[from, 0.0]];
        for (first, piece) in curve.pieces() {
            let (low, high) = (from.max(first), to.min(first + piece.length()));
            let step = if piece.turns_one_way() { piece.length() } else { DIRECTION_SPACING };
            let inner = (0..).map(|i| low + f64::from(i) * step).take_while(|s| *s < high);
            for s in inner.chain((low <= high).then_some(high)) {
                let tangent = piece.at(s - first).tangent;
                push_extreme(&mut extremes, [s, turn(start, tangent)], least);
            }
        }
        let swings = extremes.len() - 1;
        let sum: f64 = extremes.windows(2).map(|pair| (pair[1][1] - pair[0][1]).abs()).sum();
        let (first, last) = (extremes.first()?, extremes.last()?);
        (swings > 1).then(|| Self {
            count: swings / 2,
            length: 2.0 * (last[0] - first[0]) / swings as f64,
            swing: sum / swings as f64,
        })
    }
}

/// Takes the next place and its direction: it goes on from the last extreme, or turns back by more
/// than `least`, or is nothing.
fn push_extreme(extremes: &mut Vec<[f64; 2]>, next: [f64; 2], least: f64) {
    match extremes.as_mut_slice() {
        [.., before, last] if (next[1] - last[1]) * (last[1] - before[1]) > 0.0 => *last = next,
        [.., last] if (next[1] - last[1]).abs() <= least => {}
        _ => extremes.push(next),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Profile, Role, Standard};

    /// A rail's arc of 300 mm with waves of 1 mm, a micrometre high on either side.
    fn wavy() -> Profile {
        let points = (0..=1600).map(|i| {
            let y = -0.02 + f64::from(i) * 2.5e-5;
            [y, y * y / 0.6 + 1e-6 * (y * std::f64::consts::TAU / 1e-3).sin()]
        });
        Profile::through(Role::Rail, &points.collect::<Vec<_>>(), &[]).unwrap()
    }

    #[test]
    fn a_sine_has_its_own_length_and_swing() {
        let profile = wavy();
        let waves = Waves::of(profile.curve(), [0.005, 0.0351], 5e-3).unwrap();
        // Slope from -k a to k a, with k a = 2 pi / 1000; the arc takes 0.5 mm / 0.3 m off one side
        // and gives it to the other. Places stand 5 % of a wave apart.
        assert!((waves.swing / (4e-3 * std::f64::consts::PI) - 1.0).abs() < 0.02, "{waves:?}");
        assert!((waves.length / 1e-3 - 1.0).abs() < 0.03, "{waves:?}");
        assert!(waves.count.abs_diff(30) <= 1, "{waves:?}");
        assert_eq!(Waves::of(profile.curve(), [0.005, 0.0351], 0.015), None);
    }

    /// Over a contact's width, 15 mm; 3.5 mrad is a tenth of a gigapascal in steel.
    #[test]
    fn standard_profiles_have_none() {
        for (name, standard) in Standard::NAMES {
            let profile = standard.profile();
            let curve = profile.curve();
            for start in curve.stations(2e-3) {
                let waves = Waves::of(curve, [start, start + 0.015], 3.5e-3);
                assert!(waves.is_none_or(|waves| waves.count < 2), "{name} at {start}: {waves:?}");
            }
        }
    }
}
