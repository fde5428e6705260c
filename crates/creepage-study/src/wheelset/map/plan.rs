//! Plan of a contact map: its ranges, resolutions and motions.

use creepage::coulomb::Resolution;
use creepage::normal;
use creepage_map::HEIGHTS;
use creepage_wheelset::Load;

use super::error::MapBuildError;
use super::head;
use crate::wheelset::case::WheelsetCase;

/// Plan of a map: its ranges, resolutions and motions.
#[derive(Debug, Clone, PartialEq)]
pub struct MapPlan {
    /// Lateral positions of the wheelset from the track centre (m) that the map is to cover, to both sides; it
    /// ends before where profiles end or the flange has climbed.
    pub y: f64,
    /// Largest yaw (rad).
    pub yaw: f64,
    /// Vertical loads of a wheel (N) between which it is interpolated, rising, at least two.
    pub loads: Vec<f64>,
    /// Least and largest coefficient of friction.
    pub friction: [f64; 2],
    /// Part of `mu N` by which forces in the middle of a cell may differ before it is halved.
    pub tolerance: f64,
    /// Widest and narrowest cells (m).
    pub widths: [f64; 2],
    /// Spacing of places with heights (m).
    pub spacing: f64,
    /// States drawn afresh in each cell.
    pub states: usize,
    /// Elements of rolling and of pressing.
    pub resolution: MapResolution,
}

/// Resolution of the contacts of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapResolution {
    /// For a first look.
    Fast,
    /// The full theory's usual one.
    Standard,
    /// The finer one, for contacts of several lobes.
    Fine,
}

impl MapResolution {
    pub(super) fn rolling(self) -> Resolution {
        match self {
            Self::Fast => Resolution::FAST,
            Self::Standard => Resolution::STANDARD,
            Self::Fine => Resolution::FINE,
        }
    }

    pub(super) fn solids(self) -> normal::Resolution {
        match self {
            Self::Fast => normal::Resolution::FAST,
            Self::Standard => normal::Resolution::STANDARD,
            Self::Fine => normal::Resolution::FINE,
        }
    }
}

impl MapPlan {
    /// Largest roll (rad) beyond that of a wheelset that rolls freely.
    pub(super) const ROLL: f64 = 1e-3;
    /// Lightest and heaviest load of the nodes, over the usual load of a wheel.
    const LOADS: [f64; 2] = [0.12, 2.4];
    /// Number of loads, in even steps of their logarithm, along which forces are blended.
    const LOAD_COUNT: i32 = 6;

    /// The usual plan for wheels that carry `load` (N) each.
    #[must_use]
    pub fn usual(load: f64) -> Self {
        let [light, heavy] = Self::LOADS;
        let step = (heavy / light).powf(1.0 / f64::from(Self::LOAD_COUNT - 1));
        Self {
            // On the flange shifts by roll and yaw no longer tell the load: its error says how far.
            y: 6.2e-3,
            yaw: 0.01,
            loads: (0..Self::LOAD_COUNT).map(|k| load * light * step.powi(k)).collect(),
            friction: [0.05, 0.6],
            tolerance: 0.01,
            widths: [0.4e-3, 0.05e-3],
            spacing: 0.05e-3,
            states: 2,
            resolution: MapResolution::Standard,
        }
    }

    /// The usual plan for a wheelset's own load.
    ///
    /// # Errors
    /// [`MapBuildError`] where its file has no load that both wheels share.
    pub fn of(case: &WheelsetCase) -> Result<Self, MapBuildError> {
        match case.stance.load {
            Some(Load::Axle(load)) => Ok(Self::usual(0.5 * load)),
            Some(Load::Wheel(load)) => Ok(Self::usual(load)),
            Some(Load::Wheels(_) | Load::Loaded { .. }) => Err(MapBuildError::UNEVEN),
            Some(Load::Height(_)) | None => Err(MapBuildError::NoLoad),
        }
    }

    /// Loads of the heights: zero, then in even steps of the depth.
    pub(super) fn height_loads(&self) -> [f64; HEIGHTS] {
        let most = 1.02 * self.loads.last().copied().unwrap_or(0.0);
        std::array::from_fn(|k| most * (k as f64 / (HEIGHTS - 1) as f64).powf(1.5))
    }

    /// Checks its numbers.
    ///
    /// # Errors
    /// [`MapBuildError::Plan`] with the first of them that no map can have.
    pub fn check(&self) -> Result<(), MapBuildError> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let [wide, narrow] = self.widths;
        let rises = |values: &[f64]| values.windows(2).all(|pair| pair[0] < pair[1]);
        let checks = [
            ("y", self.y, positive(self.y) && self.y <= 0.05, "above 0 m, at most 0.05 m"),
            ("yaw", self.yaw, self.yaw >= 0.0 && self.yaw <= 0.05, "0 to 0.05 rad"),
            ("tolerance", self.tolerance, positive(self.tolerance), "positive and finite"),
            ("widest", wide, positive(wide) && wide <= 2e-3, "above 0 m, at most 0.002 m"),
            (
                "narrowest",
                narrow,
                narrow >= 5e-6 && narrow <= wide,
                "5e-6 m to the width of the widest cells",
            ),
            (
                "spacing",
                self.spacing,
                self.spacing >= 5e-6 && self.spacing <= 1e-3,
                "5e-6 to 1e-3 m",
            ),
            ("friction", self.friction[0], self.friction[0] >= 0.01, "0.01 and above"),
            (
                "friction",
                self.friction[1],
                self.friction[1] <= 2.0 && rises(&self.friction),
                "at most 2",
            ),
        ];
        if let Some((quantity, value, _, valid)) = checks.into_iter().find(|check| !check.2) {
            return Err(MapBuildError::Plan { quantity, value, valid });
        }
        let wrong = |value, valid| MapBuildError::Plan { quantity: "loads", value, valid };
        if self.loads.len() < 2 {
            return Err(wrong(self.loads.len() as f64, "two or more in number"));
        }
        if let Some(load) = self.loads.iter().find(|load| !positive(**load)) {
            return Err(wrong(*load, "positive and finite"));
        }
        if let Some(pair) = self.loads.windows(2).find(|pair| pair[0] >= pair[1]) {
            return Err(wrong(pair[1], "rising, each above the one before"));
        }
        Ok(())
    }

    /// Checks that a wheelset has a map by this plan, which needs no table yet.
    ///
    /// # Errors
    /// [`MapBuildError`] with what is in the wheelset's file and in no map.
    pub fn check_case(&self, case: &WheelsetCase) -> Result<(), MapBuildError> {
        head::of(case, self).map(|_| ())
    }
}
