//! Height of a wheel over place and load, with what roll and yaw do to it.

use crate::blend::{Cubic, cubic_weights};
use crate::error::{MapError, Quantity};
use crate::scalar::Scalar;

/// Loads whose heights a node has, the first of them zero.
pub const HEIGHTS: usize = 14;
/// Rolls beyond its own at which a place has been pressed, in parts of [`Head::roll`](crate::Head::roll).
pub const ROLLS: [f64; 4] = [-1.0, -0.5, 0.5, 1.0];
/// Yaws at which a place has been pressed: squares, in parts of that of [`Head::yaw`](crate::Head::yaw).
pub const YAWS: [f64; 2] = [0.5, 1.0];
/// Rolls and yaws of a place beside its own.
pub const TURNS: usize = ROLLS.len() + YAWS.len();

/// What a further roll or a yaw does to a wheel at one place of a map, under the loads of [`Heights::loads`].
///
/// A turn moves the contact along the map, and the wheelset down or up.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Turned {
    /// How far aside (m) of its own place the contact is one without that turn, by where the load lies on the rail:
    /// where areas join, the more of them carry, the farther.
    pub aside: [f64; HEIGHTS],
    /// By how much lower (m, down) the wheelset stands at its own place.
    pub lowered: [f64; HEIGHTS],
}

/// A place of wheel on rail: heights over the load, and what roll and yaw do there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeightNode {
    /// The map's coordinate (m): `y - R roll - l yaw^2/2` on the right-hand image.
    pub place: f64,
    /// Roll (rad) at which it was pressed.
    pub roll: f64,
    /// Height of the wheelset (m, down) under the loads of [`Heights::loads`].
    pub heights: [f64; HEIGHTS],
    /// At the further [`ROLLS`], then at the [`YAWS`].
    pub turned: [Turned; TURNS],
}

/// Numbers of a [`HeightNode`].
pub const PLACE: usize = 2 + HEIGHTS + 2 * TURNS * HEIGHTS;

impl HeightNode {
    /// Its numbers in a row, as files have them.
    #[must_use]
    pub fn numbers(&self) -> [f64; PLACE] {
        let Self { place, roll, heights, turned } = *self;
        let turned = turned.into_iter().flat_map(|turn| turn.aside.into_iter().chain(turn.lowered));
        let mut all = [0.0; PLACE];
        let own = [place, roll].into_iter().chain(heights).chain(turned);
        all.iter_mut().zip(own).for_each(|(to, from)| *to = from);
        all
    }

    /// From its numbers.
    #[must_use]
    pub fn of_numbers(all: &[f64; PLACE]) -> Self {
        let row = |first: usize| std::array::from_fn(|k| all[first + k]);
        let turned = |turn: usize| {
            let first = 2 + HEIGHTS + 2 * turn * HEIGHTS;
            Turned { aside: row(first), lowered: row(first + HEIGHTS) }
        };
        Self { place: all[0], roll: all[1], heights: row(2), turned: std::array::from_fn(turned) }
    }
}

/// The heights of one wheel over place and load.
#[derive(Debug, Clone, PartialEq)]
pub struct Heights {
    pub(crate) places: Vec<f64>,
    pub(crate) nodes: Vec<HeightNode>,
    pub(crate) loads: [f64; HEIGHTS],
    /// `load^(2/3)`: in proportion to the depth where the area is Hertz's.
    powers: [f64; HEIGHTS],
}

/// Wheel in its pose, before its load is known.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placed<S> {
    /// The coordinate without what turns move the contact by (m).
    plain: S,
    weights: Cubic<S>,
    /// Roll (rad) beyond that of `plain`'s node.
    pub(crate) further: S,
    /// Height (m).
    z: S,
    /// Weights of [`HeightNode::turned`].
    turns: [S; TURNS],
}

impl<S: Scalar> Placed<S> {
    /// Without derivatives.
    fn values(&self) -> Placed<f64> {
        let Self { plain, weights, further, z, turns } = *self;
        let weights = Cubic { first: weights.first, weights: weights.weights.map(Scalar::value) };
        let [plain, further, z] = [plain, further, z].map(Scalar::value);
        Placed { plain, weights, further, z, turns: turns.map(Scalar::value) }
    }
}

/// Where a wheel has one of the loads of [`Heights::loads`].
#[derive(Debug, Clone, Copy)]
struct LoadedPlace<S> {
    /// Place in the map (m).
    place: S,
    /// Height (m).
    height: S,
}

impl Heights {
    /// From nodes of rising place, at least three.
    ///
    /// # Errors
    /// [`MapError::Senseless`] where there are fewer, or numbers are not finite or do not rise.
    pub fn new(nodes: Vec<HeightNode>, loads: [f64; HEIGHTS]) -> Result<Self, MapError> {
        let places: Vec<f64> = nodes.iter().map(|node| node.place).collect();
        let rises = |values: &[f64]| {
            values.iter().all(|v| v.is_finite()) && values.windows(2).all(|pair| pair[0] < pair[1])
        };
        let finite = |node: &HeightNode| {
            node.numbers().iter().all(|v| v.is_finite()) && rises(&node.heights)
        };
        let makes_sense = nodes.len() >= 3
            && rises(&places)
            && rises(&loads)
            && loads[0].abs() < f64::EPSILON
            && nodes.iter().all(finite);
        if !makes_sense {
            return Err(MapError::Senseless("heights"));
        }
        let powers = loads.map(|load| (load * load).cbrt());
        Ok(Self { places, nodes, loads, powers })
    }

    /// First and last place (m).
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        [self.places.first(), self.places.last()].map(|end| end.copied().unwrap_or(f64::NAN))
    }

    /// Roll (rad) at which the nodes beside a lateral position (m) were pressed; at the ends that of the last.
    pub(crate) fn free_roll(&self, y: f64, radius: f64) -> f64 {
        let y_of = |node: &HeightNode| node.place + radius * node.roll;
        let after =
            self.nodes.partition_point(|node| y_of(node) <= y).clamp(1, self.nodes.len() - 1);
        let (low, high) = (&self.nodes[after - 1], &self.nodes[after]);
        let part = ((y - y_of(low)) / (y_of(high) - y_of(low))).clamp(0.0, 1.0);
        low.roll + part * (high.roll - low.roll)
    }

    /// The nodes.
    #[must_use]
    pub fn nodes(&self) -> &[HeightNode] {
        &self.nodes
    }

    /// Loads (N) of the heights of all nodes.
    #[must_use]
    pub fn loads(&self) -> &[f64; HEIGHTS] {
        &self.loads
    }

    /// A wheel as it stands: by `plain`, the coordinate without what turns move the contact by, height and roll, the
    /// largest further roll, and the square of yaw over that of the map's largest.
    pub(crate) fn placed<S: Scalar>(
        &self,
        plain: S,
        [z, roll]: [S; 2],
        (most_roll, yaw_square): (f64, S),
    ) -> Result<Placed<S>, MapError> {
        self.inside(plain)?;
        let weights = Cubic::at(&self.places, plain);
        let further = roll - weights.of(|k| self.nodes[k].roll);
        let mut turns = [S::constant(0.0); TURNS];
        // Cubics through neighbouring rolls; the middle one, without further roll, changes nothing.
        let [low, half, over, high] = ROLLS;
        let part = if most_roll > 0.0 { most_roll.recip() } else { 0.0 };
        let by_roll = Cubic::at(&[low, half, 0.0, over, high], further * part);
        for (k, weight) in by_roll.weights.into_iter().enumerate() {
            match by_roll.first + k {
                2 => {}
                k if k < 2 => turns[k] = weight,
                k => turns[k - 1] = weight,
            }
        }
        // The parabola through none, half and the whole of the largest square of yaw.
        let t = yaw_square;
        turns[ROLLS.len()] = t * (-t + 1.0) * 4.0;
        turns[ROLLS.len() + 1] = t * (t * 2.0 - 1.0);
        Ok(Placed { plain, weights, further, z, turns })
    }

    fn inside<S: Scalar>(&self, place: S) -> Result<S, MapError> {
        let [low, high] = self.range();
        let (quantity, value) = (Quantity::Place, place.value());
        let inside = (low..=high).contains(&value);
        inside.then_some(place).ok_or(MapError::Outside { quantity, value, low, high })
    }

    /// Where the wheel has the load number `k` of [`Heights::loads`].
    fn level<S: Scalar>(&self, placed: &Placed<S>, k: usize) -> LoadedPlace<S> {
        let weights = placed.weights;
        let (mut place, mut height) = (placed.plain, weights.of(|n| self.nodes[n].heights[k]));
        for (turn, weight) in placed.turns.into_iter().enumerate() {
            place = place + weight * weights.of(|n| self.nodes[n].turned[turn].aside[k]);
            height = height + weight * weights.of(|n| self.nodes[n].turned[turn].lowered[k]);
        }
        LoadedPlace { place, height }
    }

    /// Height (m) of a wheel under a load (N) and its place in the map, nearly: between those of the loads beside
    /// it.
    pub(crate) fn under(&self, placed: &Placed<f64>, load: f64) -> Result<[f64; 2], MapError> {
        let power = (load * load).cbrt();
        let above = self.powers.partition_point(|p| *p <= power).clamp(1, HEIGHTS - 1);
        let [low, high] = [above - 1, above].map(|k| self.level(placed, k));
        let [from, to] = [self.powers[above - 1], self.powers[above]];
        let part = (power - from) / (to - from);
        let between = |low: f64, high: f64| low + (high - low) * part;
        let place = self.inside(between(low.place, high.place))?;
        Ok([between(low.height, high.height), place])
    }

    /// Load (N) at which a wheel stands there, and its place in the map (m); none where it hangs above its rail.
    pub(crate) fn load<S: Scalar>(&self, placed: &Placed<S>) -> Result<Option<[S; 2]>, MapError> {
        let value = placed.z.value();
        let values = placed.values();
        let height = |k: usize| self.level(&values, k).height;
        let (mut low, mut high) = (0, HEIGHTS - 1);
        if value <= height(0) {
            return Ok(None);
        }
        if value > height(high) {
            let (quantity, low, high) = (Quantity::Height, height(0), height(high));
            return Err(MapError::Outside { quantity, value, low, high });
        }
        while high - low > 1 {
            let middle = usize::midpoint(low, high);
            if height(middle) <= value { low = middle } else { high = middle }
        }
        let first = low.saturating_sub(1).min(HEIGHTS - 4);
        let levels = [0, 1, 2, 3].map(|k| self.level(placed, first + k));
        let knots = levels.map(|level| level.height);
        // Between turns heights that rise at each node may not.
        if knots.windows(2).any(|pair| pair[0].value() >= pair[1].value()) {
            return Err(MapError::NotFound { left: 1.0 });
        }
        let weights = cubic_weights(&knots, 4, low - first, placed.z);
        let (mut power, mut place) = (S::constant(0.0), S::constant(0.0));
        for (k, weight) in weights.into_iter().enumerate() {
            power = power + weight * self.powers[first + k];
            place = place + weight * levels[k].place;
        }
        if power.value() <= 0.0 {
            return Ok(None);
        }
        Ok(Some([power * power.sqrt(), self.inside(place)?]))
    }
}
