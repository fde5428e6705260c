//! Where a wheel stands under its load.

use crate::blend::{Cubic, cubic_weights};
use crate::error::{MapError, Quantity};
use crate::scalar::Scalar;

/// Loads whose heights a node has, the first of them zero.
pub const HEIGHTS: usize = 14;
/// Yaws beside none that a place has been pressed at: squares of half and the whole of the map's largest.
pub const YAWS: usize = 2;

/// What yaw does to a wheel at one place of a map.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Yawed {
    /// By how much lower the wheelset stands under the loads of [`Heights::loads`] (m, down).
    pub lowered: [f64; HEIGHTS],
    /// How far aside (m) of its own place the contact is one without yaw: by where the load lies on the rail.
    pub aside: f64,
}

/// A place of wheel on rail: heights over the load, and how roll moves it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeightNode {
    /// The map's coordinate (m): `y - R roll - l yaw^2/2` on the right-hand image.
    pub place: f64,
    /// Roll (rad) at which it was pressed.
    pub roll: f64,
    /// By how much more than `R` a further roll moves the wheel aside under the loads of [`Heights::loads`]
    /// (m/rad): where areas join, the more of them carry, the farther.
    pub shift: [f64; HEIGHTS],
    /// By how much a further roll brings the wheel down under these loads (m/rad).
    pub fall: [f64; HEIGHTS],
    /// Height of the wheelset (m, down) under the loads of [`Heights::loads`].
    pub heights: [f64; HEIGHTS],
    /// At the map's yaws.
    pub yawed: [Yawed; YAWS],
}

/// Numbers of a [`HeightNode`].
pub const PLACE: usize = 2 + 3 * HEIGHTS + YAWS * (1 + HEIGHTS);

impl HeightNode {
    /// Its numbers in a row, as files have them.
    #[must_use]
    pub fn numbers(&self) -> [f64; PLACE] {
        let Self { place, roll, shift, fall, heights, yawed } = *self;
        let yawed =
            yawed.into_iter().flat_map(|yawed| std::iter::once(yawed.aside).chain(yawed.lowered));
        let mut all = [0.0; PLACE];
        let own = [place, roll].into_iter().chain(shift).chain(fall).chain(heights);
        all.iter_mut().zip(own.chain(yawed)).for_each(|(to, from)| *to = from);
        all
    }

    /// From its numbers.
    #[must_use]
    pub fn of_numbers(all: &[f64; PLACE]) -> Self {
        let row = |first: usize| std::array::from_fn(|k| all[first + k]);
        let yawed = |k: usize| {
            let first = 2 + 3 * HEIGHTS + k * (1 + HEIGHTS);
            Yawed { aside: all[first], lowered: row(first + 1) }
        };
        Self {
            place: all[0],
            roll: all[1],
            shift: row(2),
            fall: row(2 + HEIGHTS),
            heights: row(2 + 2 * HEIGHTS),
            yawed: std::array::from_fn(yawed),
        }
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

/// A wheel as it stands, before its load is known.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placed<S> {
    /// The coordinate without the local part of the shift by roll (m).
    plain: S,
    weights: Cubic<S>,
    /// Roll (rad) beyond that of `plain`'s node.
    pub(crate) further: S,
    /// Height (m).
    z: S,
    /// Weights of [`HeightNode::yawed`].
    yaws: [S; YAWS],
}

impl<S: Scalar> Placed<S> {
    /// Without derivatives.
    fn values(&self) -> Placed<f64> {
        let Self { plain, weights, further, z, yaws } = *self;
        let weights = Cubic { first: weights.first, weights: weights.weights.map(Scalar::value) };
        let [plain, further, z] = [plain, further, z].map(Scalar::value);
        Placed { plain, weights, further, z, yaws: yaws.map(Scalar::value) }
    }
}

/// Where a wheel has one of the loads of [`Heights::loads`].
#[derive(Debug, Clone, Copy)]
struct Level<S> {
    /// Place in the map without yaw's part (m).
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
            let lowered = |yawed: &Yawed| -> [f64; HEIGHTS] {
                std::array::from_fn(|k| node.heights[k] + yawed.lowered[k])
            };
            [node.roll].iter().chain(&node.shift).chain(&node.fall).all(|v| v.is_finite())
                && rises(&node.heights)
                && node.yawed.iter().all(|yawed| yawed.aside.is_finite())
                && node.yawed.iter().all(|yawed| rises(&lowered(yawed)))
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

    /// A wheel as it stands: by `plain`, the coordinate without the local part of the shift by roll, height and
    /// roll, and the square of yaw over that of the map's largest.
    pub(crate) fn placed<S: Scalar>(
        &self,
        plain: S,
        [z, roll]: [S; 2],
        yaw_square: S,
    ) -> Result<Placed<S>, MapError> {
        self.inside(plain)?;
        let weights = Cubic::at(&self.places, plain);
        let further = roll - weights.of(|k| self.nodes[k].roll);
        // The parabola through none, half and the whole of the largest square of yaw.
        let t = yaw_square;
        let yaws = [t * (-t + 1.0) * 4.0, t * (t * 2.0 - 1.0)];
        Ok(Placed { plain, weights, further, z, yaws })
    }

    fn inside<S: Scalar>(&self, place: S) -> Result<S, MapError> {
        let [low, high] = self.range();
        let (quantity, value) = (Quantity::Place, place.value());
        let inside = (low..=high).contains(&value);
        inside.then_some(place).ok_or(MapError::Outside { quantity, value, low, high })
    }

    /// Where the wheel has the load number `k` of [`Heights::loads`].
    fn level<S: Scalar>(&self, placed: &Placed<S>, k: usize) -> Level<S> {
        let shift = placed.weights.of(|n| self.nodes[n].shift[k]);
        let place = placed.plain - shift * placed.further;
        let weights = Cubic::at(&self.places, place);
        let own = weights.of(|n| self.nodes[n].heights[k]);
        let by_yaw = |y: usize| weights.of(|n| self.nodes[n].yawed[y].lowered[k]) * placed.yaws[y];
        let fall = weights.of(|n| self.nodes[n].fall[k]);
        Level { place, height: own + by_yaw(0) + by_yaw(1) - fall * placed.further }
    }

    /// With what yaw adds to a place.
    fn turned<S: Scalar>(&self, placed: &Placed<S>, place: S) -> Result<S, MapError> {
        let weights = Cubic::at(&self.places, self.inside(place)?);
        let aside = |k: usize| weights.of(|n| self.nodes[n].yawed[k].aside) * placed.yaws[k];
        Ok(place + aside(0) + aside(1))
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
        let place = self.turned(placed, between(low.place, high.place))?;
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
        // Between yaws, and with much roll, heights that rise at each node may not.
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
        Ok(Some([power * power.sqrt(), self.turned(placed, place)?]))
    }
}
