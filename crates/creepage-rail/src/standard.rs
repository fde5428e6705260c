//! Profiles of the standards, by name, from their defining arcs and polynomials.

mod head;
mod wheel;
mod zones;

pub use head::RailHead;

use crate::{Profile, Role};

/// A profile known by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Standard {
    /// S1002 of UIC 510-2 and EN 13715, flange 28 mm high and 32.5 mm thick.
    S1002,
    /// Cone 1:20 with the flange of S1002 and a fillet of 13 mm.
    Cone20,
    /// Cone 1:40 with the flange of S1002 and a fillet of 13 mm.
    Cone40,
    /// Reference wheel A of EN 15302.
    En15302A,
    /// Reference wheel B of EN 15302.
    En15302B,
    /// Reference wheel C of EN 15302.
    En15302C,
    /// Reference wheel H of EN 15302.
    En15302H,
    /// Reference wheel I of EN 15302.
    En15302I,
    /// UIC 60 as everyone computes with it: the crown's half chord is 10.5 mm. Uncanted.
    Uic60,
    /// 60E1 of EN 13674-1: the crown's half chord is 10.228 mm. Uncanted.
    Rail60E1,
    /// 54E1 of EN 13674-1. Uncanted.
    Rail54E1,
    /// Reference rail A of EN 15302, inclined by .05 rad as the standard has it; its origin is
    /// the point of the surface 750 mm from the track's centre.
    En15302RailA,
}

impl Standard {
    /// All profiles with their names.
    pub const NAMES: [(&'static str, Self); 12] = [
        ("S1002", Self::S1002),
        ("cone-1:20", Self::Cone20),
        ("cone-1:40", Self::Cone40),
        ("EN15302-A", Self::En15302A),
        ("EN15302-B", Self::En15302B),
        ("EN15302-C", Self::En15302C),
        ("EN15302-H", Self::En15302H),
        ("EN15302-I", Self::En15302I),
        ("UIC60", Self::Uic60),
        ("60E1", Self::Rail60E1),
        ("54E1", Self::Rail54E1),
        ("EN15302-rail-A", Self::En15302RailA),
    ];

    /// The profile of that name, as in [`Standard::NAMES`].
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(known, _)| *known == name).map(|&(_, standard)| standard)
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, known)| *known == self).map_or("", |&(name, _)| name)
    }

    /// Where its numbers are from, and what it is.
    #[must_use]
    pub fn source(self) -> &'static str {
        match self {
            Self::S1002 => "UIC 510-2, EN 13715; flange 28 mm high, 32.5 mm thick",
            Self::Cone20 => "cone 1:20 with the flange of S1002 and a fillet of 13 mm",
            Self::Cone40 => "cone 1:40 with the flange of S1002 and a fillet of 13 mm",
            Self::En15302A => "EN 15302, reference wheel A",
            Self::En15302B => "EN 15302, reference wheel B",
            Self::En15302C => "EN 15302, reference wheel C",
            Self::En15302H => "EN 15302, reference wheel H",
            Self::En15302I => "EN 15302, reference wheel I",
            Self::Uic60 => {
                "UIC 60 as everyone computes with it: half chord of the crown 10.5 mm; uncanted"
            }
            Self::Rail60E1 => "EN 13674-1; half chord of the crown 10.228 mm; uncanted",
            Self::Rail54E1 => "EN 13674-1; uncanted",
            Self::En15302RailA => {
                "EN 15302, reference rail A, inclined by .05 rad as the standard has it"
            }
        }
    }

    /// Wheel or rail.
    #[must_use]
    pub fn role(self) -> Role {
        match self {
            Self::Uic60 | Self::Rail60E1 | Self::Rail54E1 | Self::En15302RailA => Role::Rail,
            _ => Role::Wheel,
        }
    }

    /// The profile.
    #[must_use]
    pub fn profile(self) -> Profile {
        match self {
            Self::S1002 => wheel::s1002(),
            Self::Cone20 => wheel::cone(0.05),
            Self::Cone40 => wheel::cone(0.025),
            Self::En15302A => wheel::en15302_a(),
            Self::En15302B => wheel::en15302_b(),
            Self::En15302C => wheel::en15302_c(),
            Self::En15302H => wheel::en15302_h(),
            Self::En15302I => wheel::en15302_i(),
            Self::Uic60 => head::arcs_300_80_13(10.5e-3, 25.988e-3),
            Self::Rail60E1 => head::arcs_300_80_13(10.228e-3, 26.0265e-3),
            Self::Rail54E1 => head::arcs_300_80_13(10.012e-3, 24.8635e-3),
            Self::En15302RailA => head::en15302_a(),
        }
    }
}
