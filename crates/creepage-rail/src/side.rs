//! Side of the track, left or right.

/// A side of the track, seen in the direction of travel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// `y < 0`.
    Left,
    /// `y > 0`.
    Right,
}

impl Side {
    /// The sign of the track's `y` towards the field side.
    #[must_use]
    pub fn sense(self) -> f64 {
        match self {
            Self::Left => -1.0,
            Self::Right => 1.0,
        }
    }
}
