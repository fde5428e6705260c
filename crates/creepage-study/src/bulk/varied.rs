//! Quantities of a bulk case that may differ from row to row.

use crate::case::friction::FrictionValue;
use crate::case::radius::Radius;
use crate::case::sections::Sections;

/// A quantity of a case that may have a value of its own in every row, in SI units.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Varied {
    /// Longitudinal creepage.
    Longitudinal,
    /// Lateral creepage.
    Lateral,
    /// Spin (rad/m).
    Spin,
    /// Normal force (N).
    NormalForce,
    /// Coefficient of friction.
    Friction,
    /// Radius of the upper body along the rolling direction (m); infinite where flat.
    UpperRadiusRolling,
    /// Radius of the upper body across (m).
    UpperRadiusLateral,
    /// Radius of the lower body along (m).
    LowerRadiusRolling,
    /// Radius of the lower body across (m).
    LowerRadiusLateral,
    /// Semi-axis of the contact along (m).
    SemiAxisRolling,
    /// Semi-axis of the contact across (m).
    SemiAxisLateral,
    /// Rolling velocity (m/s).
    Speed,
}

impl Varied {
    /// All of them, as tables have their columns.
    pub const ALL: [Self; 12] = [
        Self::Longitudinal,
        Self::Lateral,
        Self::Spin,
        Self::NormalForce,
        Self::Friction,
        Self::UpperRadiusRolling,
        Self::UpperRadiusLateral,
        Self::LowerRadiusRolling,
        Self::LowerRadiusLateral,
        Self::SemiAxisRolling,
        Self::SemiAxisLateral,
        Self::Speed,
    ];

    /// The name of its column: that of the key of a case file, of a radius with its body.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Longitudinal => "longitudinal",
            Self::Lateral => "lateral",
            Self::Spin => "spin",
            Self::NormalForce => "normal_force",
            Self::Friction => "friction",
            Self::UpperRadiusRolling => "upper_radius_rolling",
            Self::UpperRadiusLateral => "upper_radius_lateral",
            Self::LowerRadiusRolling => "lower_radius_rolling",
            Self::LowerRadiusLateral => "lower_radius_lateral",
            Self::SemiAxisRolling => "semi_axis_rolling",
            Self::SemiAxisLateral => "semi_axis_lateral",
            Self::Speed => "speed",
        }
    }

    /// The quantity of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|varied| varied.name() == name)
    }

    /// Whether a flat body has it infinite.
    #[must_use]
    pub fn is_radius(self) -> bool {
        use Varied::{
            LowerRadiusLateral, LowerRadiusRolling, UpperRadiusLateral, UpperRadiusRolling,
        };
        matches!(
            self,
            LowerRadiusLateral | LowerRadiusRolling | UpperRadiusLateral | UpperRadiusRolling
        )
    }

    /// Whether another value of it is another shape of contact.
    pub(super) fn is_of_shape(self) -> bool {
        self.is_radius() || self.is_semi_axis()
    }

    fn is_semi_axis(self) -> bool {
        matches!(self, Self::SemiAxisRolling | Self::SemiAxisLateral)
    }

    /// Puts a value into its place.
    pub(super) fn set(self, value: f64, sections: &mut Sections) {
        let radius =
            || Some(if value.is_infinite() { Radius::Flat } else { Radius::Curved(value) });
        let Sections { upper, lower, contact, creepage, .. } = sections;
        match self {
            Self::Longitudinal => creepage.longitudinal = Some(value),
            Self::Lateral => creepage.lateral = Some(value),
            Self::Spin => creepage.spin = Some(value),
            Self::NormalForce => contact.normal_force = value,
            Self::Friction => contact.friction = Some(FrictionValue::Constant(value)),
            Self::UpperRadiusRolling => upper.radius_rolling = radius(),
            Self::UpperRadiusLateral => upper.radius_lateral = radius(),
            Self::LowerRadiusRolling => lower.radius_rolling = radius(),
            Self::LowerRadiusLateral => lower.radius_lateral = radius(),
            Self::SemiAxisRolling => contact.semi_axis_rolling = Some(value),
            Self::SemiAxisLateral => contact.semi_axis_lateral = Some(value),
            Self::Speed => creepage.speed = Some(value),
        }
    }

    /// Takes out of a case file what the rows have in another form: semi-axes in place of radii, or
    /// the other way round; creepage in SI units in place of the dimensionless one.
    pub(super) fn make_room(varied: &[Self], sections: &mut Sections) {
        let Sections { upper, lower, contact, creepage, .. } = sections;
        let (radii, semi_axes) = (
            varied.iter().any(|quantity| quantity.is_radius()),
            varied.iter().any(|quantity| quantity.is_semi_axis()),
        );
        if semi_axes && !radii {
            (contact.angle, upper.radius_rolling, upper.radius_lateral) = (None, None, None);
            (lower.radius_rolling, lower.radius_lateral) = (None, None);
        }
        if radii && !semi_axes {
            (contact.semi_axis_rolling, contact.semi_axis_lateral) = (None, None);
        }
        for quantity in varied {
            match quantity {
                Self::Longitudinal => creepage.xi = None,
                Self::Lateral => creepage.eta = None,
                Self::Spin => creepage.chi = None,
                _ => {}
            }
        }
    }
}
