//! A guard or check rail beside a rail: the back of the flange runs on its field side.

use super::{Place, Rail, turned};
use crate::{GeometryError, Profile};

impl Rail {
    /// Sets a grooved rail in place, whose profile has the running head on the field side of a groove and a lip, or
    /// guard rail, on the track side: the head lies as by [`Rail::new`], and the lip is its guard rail.
    ///
    /// # Errors
    /// As by [`Rail::new`], and [`GeometryError::NoGroove`].
    pub fn grooved(profile: &Profile, cant: f64, place: Place) -> Result<Self, GeometryError> {
        let floor = profile.groove().ok_or(GeometryError::NoGroove)?;
        let head = Self::of_part(profile, [floor, profile.curve().length()], cant, place)?;
        let mut lip = Self { part: [0.0, floor], ..head.clone() };
        lip.look()?;
        Ok(head.with_guard(lip))
    }

    /// The same with a second rail beside it, on whose field side the back of the flange runs: a guard or check
    /// rail in its own place.
    #[must_use]
    pub fn with_guard(self, guard: Self) -> Self {
        Self { guard: Some(Box::new(Self { guard: None, ..guard })), ..self }
    }

    /// The same with a guard rail beside it: its `profile`, inclined by `cant` (rad) as a rail's, whose highest point
    /// lies `height` (m) above the track plane and whose running face, down to `depth` (m) below that plane, stands
    /// `flangeway` (m) from this rail's gauge face, which is its nearest place down to the same depth.
    ///
    /// # Errors
    /// As by [`Rail::new`], and [`GeometryError::Value`] for a flangeway that is not above zero, or a guard rail
    /// that lies below that depth.
    pub fn guarded(
        self,
        profile: &Profile,
        cant: f64,
        [flangeway, height, depth]: [f64; 3],
    ) -> Result<Self, GeometryError> {
        let lengths = [("flangeway", flangeway, "above 0 m"), ("depth", depth, "above 0 m")];
        for (name, value, range) in lengths {
            if !(value > 0.0 && value.is_finite()) {
                return Err(GeometryError::Value { name, value, range });
            }
        }
        if !(height > -depth && height.is_finite()) {
            let range =
                "such that the guard rail reaches above the depth of the gauge's measurement";
            return Err(GeometryError::Value { name: "height", value: height, range });
        }
        let face = self.nearest(&self.stations(), depth);
        let mut guard = Self::new(profile, cant, Place::Origin(0.0))?;
        guard.shift[1] -= height;
        guard.look()?;
        let high = guard.visible.iter().filter(|station| station.z <= depth);
        let reach = high.map(|station| station.y).fold(f64::NEG_INFINITY, f64::max);
        guard.shift[0] = face - flangeway - reach;
        guard.look()?;
        Ok(self.with_guard(guard))
    }

    /// The guard rail beside it.
    #[must_use]
    pub fn guard(&self) -> Option<&Self> {
        self.guard.as_deref()
    }

    /// As a guard rail: moves with its rail, whose origin goes from one place to another (m) while it turns by an angle
    /// of that cosine and sine. Both stand on the same sleepers.
    pub(super) fn go_with(
        &mut self,
        (from, to): ([f64; 2], [f64; 2]),
        (cos, sin): (f64, f64),
    ) -> Result<(), GeometryError> {
        let [y, z] = [self.shift[0] - from[0], self.shift[1] - from[1]];
        self.rotation = turned(self.rotation, (cos, sin));
        self.shift = [to[0] + cos * y - sin * z, to[1] + sin * y + cos * z];
        self.look()
    }
}
