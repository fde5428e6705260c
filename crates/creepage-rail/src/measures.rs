//! Wheel profile measures of EN 15313: flange height, thickness and slope, a hollow tread.

use crate::search::threshold;
use crate::{Profile, Role, Waves};

/// Spacing of the stations at which a profile is looked at (m).
const STATION_SPACING: f64 = 2.5e-4;
/// Below the tape circle, where flange thickness is measured (m).
const FACE: f64 = 0.010;
/// Above the flange's tip, where its slope begins (m).
const TIP: f64 = 0.002;
/// A tread reaches from the flange's root to the field side: beyond this `y` (m) it belongs to no flange.
const ROOT: f64 = -0.020;

/// Measures of a wheel's profile after EN 15313, `y = 0` at the tape circle.
///
/// ```
/// use creepage_rail::{Standard, WheelMeasures};
/// let measures = WheelMeasures::of(&Standard::S1002.profile(), -0.070).unwrap();
/// assert!((measures.flange_height - 0.028).abs() < 1e-4); // of S1002 (m)
/// assert!((measures.flange_thickness - 0.0325).abs() < 1e-4);
/// assert!(measures.hollow < 1e-6);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WheelMeasures {
    /// Of the flange's tip below the tape circle (m): `Sh`.
    pub flange_height: f64,
    /// From the flange's back to its face, 10 mm below the tape circle (m): `Sd`.
    pub flange_thickness: f64,
    /// Across, from the face 10 mm below the tape circle to the face 2 mm above the tip (m): `qR`.
    pub flange_slope: f64,
    /// How far the tread rises above its own field side (m): the height of a false flange; zero where it falls
    /// or is level outwards.
    pub hollow: f64,
}

impl WheelMeasures {
    /// Measures a wheel's profile whose flange back lies at `flange_back` (m).
    ///
    /// `None` for a rail's profile, one without a flange, and one that does not reach the tape circle.
    #[must_use]
    pub fn of(profile: &Profile, flange_back: f64) -> Option<Self> {
        if profile.role() != Role::Wheel {
            return None;
        }
        let curve = profile.curve();
        let stations = curve.stations(STATION_SPACING);
        // The curve runs from the field side to the flange.
        let at_tape = stations.windows(2).find_map(|pair| {
            let outside = |s: f64| curve.at(s).y > 0.0;
            let crosses = outside(pair[0]) && !outside(pair[1]);
            crosses.then(|| threshold([pair[0], pair[1]], outside)[1])
        })?;
        let tape = curve.at(at_tape).z;
        let tip = stations.iter().copied().filter(|s| *s > at_tape);
        let tip = tip.max_by(|a, b| curve.at(*a).z.total_cmp(&curve.at(*b).z))?;
        let height = curve.at(tip).z - tape;
        if height < FACE + TIP {
            return None;
        }
        let on_face = |depth: f64| {
            let above = |s: f64| curve.at(s).z < tape + depth;
            let found = stations.windows(2).find(|pair| {
                pair[1] <= tip + STATION_SPACING
                    && pair[0] >= at_tape
                    && above(pair[0])
                    && !above(pair[1])
            })?;
            Some(curve.at(threshold([found[0], found[1]], above)[1]).y)
        };
        let (face, near_tip) = (on_face(FACE)?, on_face(height - TIP)?);
        let mut lowest = f64::NEG_INFINITY;
        let mut hollow = 0.0f64;
        // From the field side inwards: what stood lower there, less what is here.
        for point in stations.iter().map(|s| curve.at(*s)).take_while(|point| point.y > ROOT) {
            lowest = lowest.max(point.z);
            hollow = hollow.max(lowest - point.z);
        }
        Some(Self {
            flange_height: height,
            flange_thickness: face - flange_back,
            flange_slope: face - near_tip,
            hollow,
        })
    }
}

impl Profile {
    /// Waves of the whole profile that turn it by more than `least` (rad) to and fro; `None` without two
    /// whole ones.
    #[must_use]
    pub fn all_waves(&self, least: f64) -> Option<Waves> {
        let curve = self.curve();
        Waves::of(curve, [0.0, curve.length()], least).filter(|waves| waves.count > 1)
    }

    /// Area (m^2) of the cross-section that a wheel has lost from when it was `new`, both laid on each other at
    /// the flange's tip; `None` for rails and profiles without a tip.
    #[must_use]
    pub fn worn_from(&self, new: &Self) -> Option<f64> {
        let [worn, new] = [self, new].map(Outline::of);
        let (worn, new) = (worn?, new?);
        let (from, to) = (worn.tip[0].max(new.tip[0]), worn.last().min(new.last()));
        let places = (0..).map(|k: u32| from + (f64::from(k) + 0.5) * STATION_SPACING);
        let lost: Vec<f64> = places
            .take_while(|place| *place < to)
            .filter_map(|place| {
                let (new_z, worn_z) = (new.height(place)?, worn.height(place)?);
                Some((new_z - new.tip[1]) - (worn_z - worn.tip[1]))
            })
            .collect();
        (!lost.is_empty()).then(|| STATION_SPACING * lost.iter().sum::<f64>())
    }
}

/// A wheel's outline from the flange's tip to the field side, `y` rising.
struct Outline {
    tip: [f64; 2],
    points: Vec<[f64; 2]>,
}

impl Outline {
    fn of(profile: &Profile) -> Option<Self> {
        if profile.role() != Role::Wheel {
            return None;
        }
        let curve = profile.curve();
        let points = curve.stations(STATION_SPACING).into_iter().map(|s| curve.at(s));
        let mut points: Vec<[f64; 2]> = points.map(|point| [point.y, point.z]).collect();
        points.reverse();
        let tip = (0..points.len()).max_by(|&a, &b| points[a][1].total_cmp(&points[b][1]))?;
        let points = points.split_off(tip);
        Some(Self { tip: *points.first()?, points })
    }

    fn last(&self) -> f64 {
        self.points.last().map_or(f64::NEG_INFINITY, |point| point[0])
    }

    /// Linear between stations.
    fn height(&self, y: f64) -> Option<f64> {
        let pair = self.points.windows(2).find(|pair| pair[0][0] <= y && y < pair[1][0])?;
        let [[from, low], [to, high]] = [pair[0], pair[1]];
        Some(low + (high - low) * (y - from) / (to - from))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Standard;

    /// S1002 turned by its own cylinder: worn by a depth that is the same everywhere.
    #[test]
    fn a_worn_tread_is_measured() {
        let new = Standard::S1002.profile();
        let curve = new.curve();
        let depth = 2e-3;
        // The tread between root and field side 2 mm deeper, the flange as it was; tape circle at zero again.
        let points = curve.stations(2e-4).into_iter().map(|s| curve.at(s)).map(|p| {
            let share = ((p.y + 0.035) / 0.010).clamp(0.0, 1.0);
            [p.y, p.z - depth * share * share * (3.0 - 2.0 * share) + depth]
        });
        let worn = Profile::through(Role::Wheel, &points.collect::<Vec<_>>(), &[]).unwrap();
        let [before, after] =
            [&new, &worn].map(|profile| WheelMeasures::of(profile, -0.070).unwrap());
        assert!((after.flange_height - before.flange_height - depth).abs() < 2e-5);
        let lost = worn.worn_from(&new).unwrap();
        // From y = -30 mm, the middle of the transition, to the field side at 60 mm.
        let width = curve.at(0.0).y + 0.030;
        assert!((lost / (depth * width) - 1.0).abs() < 0.02, "{lost}");
        assert!(new.worn_from(&new).unwrap().abs() < 1e-12);
        assert!(WheelMeasures::of(&Standard::Uic60.profile(), -0.070).is_none());
    }

    #[test]
    fn a_hollow_tread_has_a_false_flange() {
        let new = Standard::S1002.profile();
        let curve = new.curve();
        let points = curve.stations(2e-4).into_iter().map(|s| curve.at(s)).map(|p| {
            let off = p.y / 0.020;
            [p.y, p.z - 3e-3 * (-off * off).exp() + 3e-3]
        });
        let hollow = Profile::through(Role::Wheel, &points.collect::<Vec<_>>(), &[]).unwrap();
        let measures = WheelMeasures::of(&hollow, -0.070).unwrap();
        // 3 mm deep at the tape circle; the field side of S1002 itself falls by 1 to 2 mm.
        assert!(measures.hollow > 0.8e-3 && measures.hollow < 3e-3, "{measures:?}");
    }
}
