//! Rail heads: symmetric ones from their arcs, and the standard profiles.

use super::zones::Zone::Up;
use super::zones::profile;
use crate::curve::{Arc, Line};
use crate::{Curve, Piece, Profile, ProfileError, Role};

/// A symmetric rail head: arcs that join smoothly from the crown outwards, then straight sides.
///
/// ```
/// # use creepage_rail::RailHead;
/// let head = RailHead {
///     arcs: vec![(0.300, 0.010228), (0.080, 0.0260265)],
///     corner: 0.013,
///     side_slope: 1.0 / 20.0,
///     depth: 0.030,
/// };
/// let side = head.profile()?.at_z(0.0143).unwrap();
/// assert!((side.y.abs() - 0.036).abs() < 1e-6);
/// # Ok::<(), creepage_rail::ProfileError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RailHead {
    /// Radius and half width at which the arc ends (m), from the crown outwards.
    pub arcs: Vec<(f64, f64)>,
    /// Radius of the corner that leads into the side (m).
    pub corner: f64,
    /// How far the side leans outwards for each metre down (1/20 for most rails).
    pub side_slope: f64,
    /// Depth below the crown down to which the sides go (m).
    pub depth: f64,
}

impl RailHead {
    /// The profile of the head.
    ///
    /// # Errors
    /// [`ProfileError::Head`] where an arc cannot reach its half width.
    pub fn profile(&self) -> Result<Profile, ProfileError> {
        let mut reached = 0.0;
        let mut lean = 0.0;
        for (index, &(radius, half_width)) in self.arcs.iter().enumerate() {
            let wrong = ProfileError::Head { index, radius, half_width };
            let centre = self.centre(index);
            let sin = (half_width - centre[0]) / radius;
            let positive = radius > 0.0 && radius.is_finite();
            if !(positive && half_width > reached && sin > lean && sin < 1.0) {
                return Err(wrong);
            }
            (reached, lean) = (half_width, sin);
        }
        let index = self.arcs.len();
        let [y, z] = self.centre(index);
        let [_, outward] = self.side();
        let (side_y, side_z) = (y + self.corner * outward[0], z + self.corner * outward[1]);
        let convex = self.corner > 0.0 && self.corner.is_finite() && outward[0] > lean;
        if convex && side_y > reached && side_z < self.depth && self.depth.is_finite() {
            Ok(self.built())
        } else {
            Err(ProfileError::Head { index, radius: self.corner, half_width: side_y })
        }
    }

    /// Direction of the right side downwards, and its outward normal.
    fn side(&self) -> [[f64; 2]; 2] {
        let length = self.side_slope.hypot(1.0);
        let (sin, cos) = (self.side_slope / length, 1.0 / length);
        [[sin, cos], [cos, -sin]]
    }

    /// Centre of arc `index` on the right half; each touches the one before where that ends.
    fn centre(&self, index: usize) -> [f64; 2] {
        let radius = |i: usize| self.arcs.get(i).map_or(self.corner, |arc| arc.0);
        (0..index).fold([0.0, radius(0)], |[y, z], i| {
            let half_width = self.arcs.get(i).map_or(0.0, |arc| arc.1);
            let sin = (half_width - y) / radius(i);
            let change = radius(i) - radius(i + 1);
            [y + change * sin, z - change * (1.0 - sin * sin).sqrt()]
        })
    }

    /// The profile without checks.
    pub(super) fn built(&self) -> Profile {
        let [down, outward] = self.side();
        let mut right = Vec::new();
        let mut from = [0.0, 0.0];
        for index in 0..=self.arcs.len() {
            let [y, z] = self.centre(index);
            let (radius, end) = match self.arcs.get(index) {
                Some(&(radius, half_width)) => {
                    let sin = (half_width - y) / radius;
                    (radius, [half_width, z - radius * (1.0 - sin * sin).sqrt()])
                }
                None => (self.corner, [y + self.corner * outward[0], z + self.corner * outward[1]]),
            };
            right.push(Half::Arc([y, z], radius, from, end));
            from = end;
        }
        let rest = (self.depth - from[1]) / down[1];
        right.push(Half::Line(from, [from[0] + rest * down[0], self.depth]));
        let left = right.iter().rev().map(Half::mirrored);
        Profile::known(
            Role::Rail,
            Curve::chain(left.chain(right.iter().map(Half::piece)).collect()),
        )
    }
}

/// A piece of the right half.
enum Half {
    Arc([f64; 2], f64, [f64; 2], [f64; 2]),
    Line([f64; 2], [f64; 2]),
}

impl Half {
    fn piece(&self) -> Piece {
        match *self {
            Self::Arc(centre, radius, from, to) => Arc::between(centre, radius, from, to),
            Self::Line(from, to) => Line::between(from, to),
        }
    }

    /// Its mirror image on the left, run the other way.
    fn mirrored(&self) -> Piece {
        let image = |[y, z]: [f64; 2]| [-y, z];
        match *self {
            Self::Arc(centre, radius, from, to) => {
                Arc::between(image(centre), radius, image(to), image(from))
            }
            Self::Line(from, to) => Line::between(image(to), image(from)),
        }
    }
}

/// A head of arcs 300, 80 and 13 mm with sides 1:20, by the half chords of the first two (m).
pub(super) fn arcs_300_80_13(crown: f64, shoulder: f64) -> Profile {
    RailHead {
        arcs: vec![(0.300, crown), (0.080, shoulder)],
        corner: 0.013,
        side_slope: 0.05,
        depth: 0.030,
    }
    .built()
}

/// In mm, as the standard prints it.
pub(super) fn en15302_a() -> Profile {
    let breaks = [-32.634, -23.2401, -7.8749, 13.0989, 28.6709, 39.2705];
    let arcs = [
        Up(-19.639_49, 15.899_044, 13.0),
        Up(-1.0825, 80.277_908, 80.0),
        Up(17.5966, 299.483_49, 300.0),
        Up(14.298_29, 79.508_225, 80.0),
        Up(26.335_35, 13.598_369, 13.0),
    ];
    profile(Role::Rail, &breaks, &arcs)
}
