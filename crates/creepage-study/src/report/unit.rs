//! Units of quantities, and how their numbers are written.

use creepage_plot::format::{fixed, quantity, significant};

/// The SI unit of a quantity, or a number without one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// A number without unit.
    One,
    /// A part of a whole, from 0 to 1; in percent in texts.
    Share,
    /// A part of a whole in percent.
    Percent,
    /// N.
    Newton,
    /// m.
    Metre,
    /// m².
    SquareMetre,
    /// Pa.
    Pascal,
    /// N m.
    NewtonMetre,
    /// N/m, a stiffness.
    NewtonPerMetre,
    /// N/m, a force per length of a line contact.
    LineLoad,
    /// m/N^(2/3).
    MetrePerNewtonTwoThirds,
    /// A force (N) by what is in this unit; its key is that of the force.
    ForceBy(PerUnit),
    /// A moment (N m) by what is in this unit; its key is that of the moment.
    MomentBy(PerUnit),
    /// N m/rad.
    NewtonMetrePerRadian,
    /// Pa/m.
    PascalPerMetre,
    /// 1/m.
    PerMetre,
    /// rad.
    Radian,
    /// deg.
    Degree,
    /// rad/m.
    RadianPerMetre,
    /// rad/s.
    RadianPerSecond,
    /// J.
    Joule,
    /// J/m.
    JoulePerMetre,
    /// J/m².
    JoulePerSquareMetre,
    /// m/s.
    MetrePerSecond,
    /// W.
    Watt,
}

/// Unit of the variable by which a force is derived.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PerUnit {
    /// m.
    Metre,
    /// rad.
    Radian,
    /// m/s.
    MetrePerSecond,
    /// rad/s.
    RadianPerSecond,
}

impl PerUnit {
    /// Units of forces and of moments by it.
    const fn symbols(self) -> [&'static str; 2] {
        match self {
            Self::Metre => ["N/m", "N"],
            Self::Radian => ["N/rad", "N m/rad"],
            Self::MetrePerSecond => ["N s/m", "N s"],
            Self::RadianPerSecond => ["N s/rad", "N m s/rad"],
        }
    }
}

impl Unit {
    /// How a key ends that has this unit, and the unit as it is written.
    const fn words(self) -> [&'static str; 2] {
        match self {
            Self::One | Self::Share => ["", ""],
            Self::Percent => ["_percent", "%"],
            Self::Newton => ["_n", "N"],
            Self::Metre => ["_m", "m"],
            Self::SquareMetre => ["_m2", "m²"],
            Self::Pascal => ["_pa", "Pa"],
            Self::NewtonMetre => ["_n_m", "N m"],
            Self::NewtonPerMetre | Self::LineLoad => ["_n_per_m", "N/m"],
            Self::MetrePerNewtonTwoThirds => ["_m_per_n_2_3", "m/N^(2/3)"],
            Self::ForceBy(by) => ["_n", by.symbols()[0]],
            Self::MomentBy(by) => ["_n_m", by.symbols()[1]],
            Self::NewtonMetrePerRadian => ["_n_m_per_rad", "N m/rad"],
            Self::PascalPerMetre => ["_pa_per_m", "Pa/m"],
            Self::PerMetre => ["_per_m", "1/m"],
            Self::Radian => ["_rad", "rad"],
            Self::Degree => ["_deg", "deg"],
            Self::RadianPerMetre => ["_rad_per_m", "rad/m"],
            Self::RadianPerSecond => ["_rad_per_s", "rad/s"],
            Self::Joule => ["_j", "J"],
            Self::JoulePerMetre => ["_j_per_m", "J/m"],
            Self::JoulePerSquareMetre => ["_j_per_m2", "J/m²"],
            Self::MetrePerSecond => ["_m_per_s", "m/s"],
            Self::Watt => ["_w", "W"],
        }
    }

    /// The unit as it is written; nothing for numbers without one.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        self.words()[1]
    }

    /// How a key ends that has this unit.
    pub(super) const fn suffix(self) -> &'static str {
        self.words()[0]
    }

    /// A number with its unit, for people.
    fn text(self, value: f64, digits: usize) -> String {
        match self {
            Self::Share => format!("{} %", fixed(100.0 * value, 2)),
            Self::Percent | Self::Degree => format!("{} {}", fixed(value, 2), self.symbol()),
            Self::SquareMetre => format!("{} mm²", significant(1e6 * value, digits)),
            Self::NewtonPerMetre => format!("{} N/µm", significant(1e-6 * value, digits)),
            Self::Radian => format!("{} deg", fixed(value.to_degrees(), 3)),
            Self::One => significant(value, digits),
            Self::PerMetre
            | Self::MetrePerNewtonTwoThirds
            | Self::RadianPerMetre
            | Self::RadianPerSecond => {
                format!("{} {}", significant(value, digits), self.symbol())
            }
            _ => quantity(value, self.symbol(), digits),
        }
    }
}

/// Number format of a text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Written {
    /// In the unit that people use for it, with a prefix where it takes one, to so many significant digits.
    Digits(usize),
    /// In its SI unit with a prefix, to so many significant digits.
    Prefixed(usize),
    /// The number times a factor, in another unit, to so many significant digits.
    Significant(f64, &'static str, usize),
    /// The same to so many decimals.
    Fixed(f64, &'static str, usize),
    /// The same without its sign.
    FixedSize(f64, &'static str, usize),
}

impl Written {
    /// To five significant digits.
    pub(crate) const USUAL: Self = Self::Digits(5);

    pub(super) fn text(self, unit: Unit, value: f64) -> String {
        match self {
            Self::Digits(digits) => unit.text(value, digits),
            Self::Prefixed(digits) => match unit {
                Unit::One | Unit::Share | Unit::Percent | Unit::Degree => unit.text(value, digits),
                _ => quantity(value, unit.symbol(), digits),
            },
            Self::Significant(factor, name, digits) => {
                format!("{} {name}", significant(factor * value, digits))
            }
            Self::Fixed(factor, name, decimals) => {
                format!("{} {name}", fixed(factor * value, decimals))
            }
            Self::FixedSize(factor, name, decimals) => {
                format!("{} {name}", fixed(factor * value.abs(), decimals))
            }
        }
    }

    /// An error bar, to two digits.
    pub(super) fn error(self, unit: Unit, error: f64) -> String {
        match self {
            Self::Digits(_) => unit.text(error, 2),
            Self::Prefixed(_) => Self::Prefixed(2).text(unit, error),
            Self::Significant(factor, name, _)
            | Self::Fixed(factor, name, _)
            | Self::FixedSize(factor, name, _) => {
                format!("{} {name}", significant(factor * error, 2))
            }
        }
    }
}
