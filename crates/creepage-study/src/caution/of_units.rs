//! Numbers that look like ones in another unit: contacts that are large beside the bodies, pressures above the modulus,
//! creepages that no wheel has.

use creepage::gap::Gap;
use creepage::normal::{NormalContact, Patch};
use creepage::{Hertz, SiCreepage};

use super::Caution;

impl Caution {
    /// A semi-axis above this part of the smallest radius, and creepage above it, are cautions: the
    /// bodies are no half-spaces then, and steel does not get there without yielding.
    pub const LARGE: f64 = 0.3;

    /// What looks like a number in another unit, such as megapascals for pascals or degrees for radians.
    ///
    /// ```
    /// use creepage::{Hertz, Radii, SiCreepage, Solid, SolidPair};
    /// use creepage_study::Caution;
    /// let [ball, flat] = [6e-3, f64::INFINITY].map(|r| Radii { rolling: r, lateral: r });
    /// for (shear_modulus, count) in [(82e9, 0), (82e3, 2)] {
    ///     let steel = Solid::new(shear_modulus, 0.28)?; // in MPa: too soft
    ///     let contact = Hertz::new(SolidPair::new(steel, steel), ball, flat, 0.0, 500.0)?;
    ///     let cautions = Caution::units(&contact, Some(6e-3), SiCreepage::default());
    ///     assert_eq!(cautions.len(), count);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn units(hertz: &Hertz, smallest_radius: Option<f64>, creepage: SiCreepage) -> Vec<Self> {
        let [along, across] = hertz.relative_curvatures();
        let radius = smallest_radius.unwrap_or(0.5 / along.max(across));
        let contact = Self::large_contact(hertz.ellipse().major(), radius);
        let pressure = Self::moduli(hertz.peak_pressure(), hertz.pair().shear_modulus());
        let large = smallest_radius.filter(|radius| radius.is_finite() && *radius > Self::RADIUS);
        contact
            .into_iter()
            .chain(pressure)
            .chain(large.map(|radius| Self::LargeRadius { radius }))
            .chain(Self::large_creepage(creepage))
            .chain(Self::large_spin(creepage.spin, hertz.ellipse().major()))
            .collect()
    }

    /// The same of a line contact: its half-width and the smallest radius (m), its peak pressure and the
    /// shear modulus (Pa).
    #[must_use]
    pub fn line_units(
        [half_width, radius]: [f64; 2],
        [peak_pressure, shear_modulus]: [f64; 2],
    ) -> Vec<Self> {
        let contact = Self::large_contact(half_width, radius);
        contact.into_iter().chain(Self::moduli(peak_pressure, shear_modulus)).collect()
    }

    /// What an ellipse is in doubt for, whatever it does: units, a metal that yields.
    #[must_use]
    pub fn of_hertz(hertz: &Hertz, smallest_radius: Option<f64>) -> Vec<Self> {
        let mut cautions = Self::units(hertz, smallest_radius, SiCreepage::default());
        if cautions.is_empty() {
            let (peak, pair) = (hertz.peak_pressure(), hertz.pair());
            cautions.extend(Self::yields(peak, pair.shear_modulus(), None));
        }
        cautions
    }

    /// A contact (m) that is large beside the bodies' radius (m).
    pub(crate) fn large_contact(semi_axis: f64, radius: f64) -> Option<Self> {
        (semi_axis > Self::LARGE * radius).then_some(Self::LargeContact { semi_axis, radius })
    }

    /// Contact areas that are large beside the radius of the gap in them.
    pub(crate) fn large_areas(gap: &Gap, areas: &NormalContact) -> Option<Self> {
        let mut widths = areas.patches().iter().flat_map(|patch| half_widths(gap, patch));
        widths.find_map(|(width, radius)| Self::large_contact(width, radius))
    }

    /// Combined shear modulus (Pa) above which both bodies are harder than diamond (535e9).
    const DIAMOND: f64 = 600e9;
    /// Smallest radius (m) of both bodies above which it is a caution.
    const RADIUS: f64 = 100.0;
    /// Coefficient of friction above which it is a caution: clean metals in air and rubber stay below.
    pub(crate) const FRICTION: f64 = 2.0;

    /// A pressure (Pa) above the shear modulus (Pa), or a modulus above that of any solid.
    pub(crate) fn moduli(peak_pressure: f64, shear_modulus: f64) -> impl Iterator<Item = Self> {
        let soft = (peak_pressure > shear_modulus)
            .then_some(Self::HighPressure { peak_pressure, shear_modulus });
        let hard = (shear_modulus > Self::DIAMOND).then_some(Self::HighModulus { shear_modulus });
        soft.into_iter().chain(hard)
    }

    /// A coefficient of friction that no pair of bodies has.
    pub(crate) fn large_friction(friction: f64) -> Option<Self> {
        (friction > Self::FRICTION).then_some(Self::LargeFriction { friction })
    }

    /// A load without slip that takes more than is given, or such a one.
    pub(crate) fn needs_friction(friction: f64, given: Option<f64>) -> Option<Self> {
        (friction > given.unwrap_or(Self::FRICTION)).then_some(Self::NeedsFriction { friction })
    }

    /// Bodies that a load moves far beside the half-width of their contact (m).
    pub(crate) fn large_shift([shift, half_width]: [f64; 2]) -> Option<Self> {
        (shift > Self::LARGE * half_width).then_some(Self::LargeShift { shift, half_width })
    }

    /// The components of a creepage that no wheel has.
    pub(crate) fn large_creepage(creepage: SiCreepage) -> impl Iterator<Item = Self> {
        let SiCreepage { longitudinal, lateral, .. } = creepage;
        let components = [("longitudinal", longitudinal), ("lateral", lateral)];
        let large = components.into_iter().filter(|(_, value)| value.abs() > Self::LARGE);
        large.map(|(component, value)| Self::LargeCreepage { component, value })
    }

    /// The same on areas: as far from the origin as they reach.
    pub(crate) fn large_spin_of_areas(spin: f64, areas: &NormalContact) -> Option<Self> {
        let extents = areas.patches().iter().map(Patch::extent);
        let ends = extents.flat_map(|extent| [extent.x, extent.y]).flatten();
        Self::large_spin(spin, ends.map(f64::abs).fold(0.0, f64::max))
    }

    /// A spin (rad/m) that slips at the farthest side of a contact, `length` (m) from its middle, as fast as no body
    /// rolls: those of bodies that roll are the sine of an angle over their radius.
    pub(crate) fn large_spin(spin: f64, length: f64) -> Option<Self> {
        let slip = spin.abs() * length;
        (slip > Self::LARGE).then_some(Self::LargeSpin { spin, slip })
    }

    /// Whether it is one of [`Caution::units`].
    #[must_use]
    pub fn is_of_units(&self) -> bool {
        matches!(
            self,
            Self::LargeContact { .. }
                | Self::LargeShift { .. }
                | Self::HighPressure { .. }
                | Self::HighModulus { .. }
                | Self::LargeFriction { .. }
                | Self::LargeCreepage { .. }
                | Self::LargeSpin { .. }
                | Self::LargeRadius { .. }
                | Self::Shallow { .. }
        )
    }
}

/// Along and across, half the width of an area and the radius of the gap in it: that of the parabola
/// through the middle and both ends.
fn half_widths(gap: &Gap, patch: &Patch) -> [(f64, f64); 2] {
    let extent = patch.extent();
    let [x, y] = [extent.x, extent.y].map(|[low, high]| f64::midpoint(low, high));
    let middle = gap.at(x, y);
    let [along, across] =
        [extent.x.map(|end| gap.at(end, y) - middle), extent.y.map(|end| gap.at(x, end) - middle)];
    [(extent.size()[0], along), (extent.size()[1], across)].map(|(size, [one, other])| {
        let half = 0.5 * size;
        // A gap that is hollow there has none.
        (half, half * half / (one + other).max(0.0))
    })
}

#[cfg(test)]
mod tests {
    use creepage::Ellipse;

    use super::*;

    #[test]
    fn numbers_in_other_units_are_cautions_from_their_bounds_on() {
        let steel = creepage::Solid::new(1e9, 0.25).unwrap();
        let ellipse = Ellipse::new(3e-3, 2e-3).unwrap();
        let hertz = |load| {
            Hertz::from_ellipse(creepage::SolidPair::new(steel, steel), ellipse, load).unwrap()
        };
        let units = |load, radius, longitudinal, lateral| {
            let creepage = SiCreepage { longitudinal, lateral, spin: 9.0 };
            Caution::units(&hertz(load), radius, creepage)
        };
        assert_eq!(units(1e3, Some(10.1e-3), 0.3, -0.3), []);
        assert_eq!(units(1e3, Some(9.9e-3), 0.0, 0.0).len(), 1);
        assert_eq!(units(1e3, None, 0.31, -0.31).len(), 2);
        // Peak pressure 3N / (2 pi a b), with the modulus of 1 GPa: from 12.57 kN on. The ellipse
        // then belongs to bodies of its own size.
        assert_eq!(units(12.5e3, Some(1.0), 0.0, 0.0), []);
        assert_eq!(units(12.6e3, Some(1.0), 0.0, 0.0).len(), 1);
        let words = Caution::words(&units(12.6e3, None, 2.0, 0.0));
        for part in ["0.003 m is more", "1.003 GPa exceeds", "longitudinal creepage of 2 "] {
            assert!(words.contains(part), "{part} is not in {words}");
        }
        assert!(units(12.6e3, None, 2.0, 0.0).iter().all(Caution::is_of_units));
    }
}
