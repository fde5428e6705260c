//! Right-hand image of a side of the track.

use creepage_rail::{Position, Side, WheelsetOnTrack};

use creepage_wheelset::WheelsetError;

/// A side of the track seen as a right-hand one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Image<'a> {
    running: &'a WheelsetOnTrack,
    side: Side,
}

impl<'a> Image<'a> {
    pub(super) fn new(running: &'a WheelsetOnTrack, side: Side) -> Self {
        Self { running, side }
    }

    pub(super) fn side(self) -> Side {
        self.side
    }

    pub(super) fn sense(self) -> f64 {
        self.side.sense()
    }

    pub(super) fn radius(self) -> f64 {
        self.running.wheelset().radius()
    }

    /// A position of the image in the track, and the other way round.
    pub(super) fn track(self, position: Position) -> Position {
        let sense = self.sense();
        let Position { y, z, roll, yaw } = position;
        Position { y: sense * y, z, roll: sense * roll, yaw: sense * yaw }
    }

    /// Height at which the wheel touches (m), at `y`, roll and yaw.
    pub(super) fn touch(self, [y, roll, yaw]: [f64; 3]) -> Result<f64, WheelsetError> {
        let Position { y, roll, yaw, .. } = self.track(Position { y, z: 0.0, roll, yaw });
        let touch = self.running.touch(self.side, y, roll, yaw);
        Ok(touch.map_err(|source| WheelsetError::Position { side: self.side, source })?.z)
    }

    /// Roll (rad) at which both wheels touch, of the image.
    pub(super) fn free_roll(self, y: f64) -> Result<f64, WheelsetError> {
        let resting = self.running.resting(self.sense() * y, 0.0, None);
        Ok(self.sense() * resting.map_err(WheelsetError::Resting)?.roll)
    }
}
