//! Archard's wear law, with a coefficient by pressure and speed of slip.

use super::ElementState;

/// The map of T. Jendel (Wear 253 (2002) 86-99; KTH, Stockholm), by which dry wheels on rails wear.
/// *Unverified*: ranges from memory, 1 to 10, 30 to 40 and 300 to 400 times 1e-4; the defaults are their
/// middles. The coefficient steps from zone to zone, so every result says in which it is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Archard {
    /// Hardness of the softer metal (Pa): 3e9.
    pub hardness: f64,
    /// Speed of slip from which wear is severe, and from which it is mild again (m/s): 0.2, 0.7.
    pub severe_between: [f64; 2],
    /// Part of the hardness from which the pressure makes the surfaces seize: 0.8.
    pub seizure_from: f64,
    /// Coefficient of mild wear, slow and fast: 5e-4.
    pub mild: f64,
    /// Coefficient of severe wear: 35e-4.
    pub severe: f64,
    /// Coefficient of seizure: 350e-4.
    pub seizure: f64,
}

impl Default for Archard {
    fn default() -> Self {
        Self {
            hardness: 3e9,
            severe_between: [0.2, 0.7],
            seizure_from: 0.8,
            mild: 5e-4,
            severe: 35e-4,
            seizure: 350e-4,
        }
    }
}

/// Zone of the wear map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum WearZone {
    /// Slow slip: an oxide layer protects.
    Mild,
    /// Fast slip: heat makes oxide again.
    MildFast,
    /// Between them: metal on metal.
    Severe,
    /// Pressure near the hardness.
    Seizure,
}

impl WearZone {
    /// `"mild"`, `"mild, fast"`, `"severe"` or `"seizure"`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Mild => "mild",
            Self::MildFast => "mild, fast",
            Self::Severe => "severe",
            Self::Seizure => "seizure",
        }
    }
}

/// Wear of one row of elements.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArchardWear {
    /// Depth lost in one passage (m).
    pub depth: f64,
    /// The worst zone in which material slid.
    pub zone: WearZone,
}

impl Archard {
    /// The zone of the map at `pressure` (Pa) and `speed` of slip (m/s).
    #[must_use]
    pub fn zone(&self, pressure: f64, speed: f64) -> WearZone {
        let [from, to] = self.severe_between;
        if pressure > self.seizure_from * self.hardness {
            WearZone::Seizure
        } else if speed < from {
            WearZone::Mild
        } else if speed <= to {
            WearZone::Severe
        } else {
            WearZone::MildFast
        }
    }

    /// The wear coefficient of a zone.
    #[must_use]
    pub fn coefficient(&self, zone: WearZone) -> f64 {
        match zone {
            WearZone::Mild | WearZone::MildFast => self.mild,
            WearZone::Severe => self.severe,
            WearZone::Seizure => self.seizure,
        }
    }

    /// Wear in one passage through the elements of `row`, one along the rolling direction, at the
    /// rolling velocity `speed` (m/s): the sum of `k p ds/H`, `ds` the distance slid.
    #[must_use]
    pub fn wear(&self, row: &[ElementState], speed: f64) -> ArchardWear {
        let mut wear = ArchardWear { depth: 0.0, zone: WearZone::Mild };
        for element in row.iter().filter(|element| element.slip_distance() > 0.0) {
            let slip_speed = element.slip[0].hypot(element.slip[1]) * speed;
            let zone = self.zone(element.pressure, slip_speed);
            wear.zone = wear.zone.max(zone);
            wear.depth +=
                self.coefficient(zone) * element.pressure * element.slip_distance() / self.hardness;
        }
        wear
    }
}
