//! Wear laws by the frictional energy.

/// N/m2 in N/mm2.
const PER_MM2: f64 = 1e-6;
/// kg/(m m2) in ug/(m mm2).
const RATE: f64 = 1e-3;

/// Wear of wheel steel R8T on rail steel UIC60 900A by T gamma over the area, tested at Sheffield:
/// R. Lewis, R.S. Dwyer-Joyce, Proc. Inst. Mech. Eng. J 218 (2004) 467-478; F. Braghin and others, Wear 261
/// (2006) 1253-1264.
///
/// With `I` in N/mm2 and the rate in ug of metal per metre rolled and mm2 of contact: `5.3 I`, then
/// 55, then rising by 61.9 for each N/mm2 beyond 77.2. The last part is often copied as
/// `61.9 I - 4778.7`, which is -0.02 at `I = 77.2`: a misprint, for the measurements join. Here it is
/// `61.9 I - 4723.7`, and the first part ends where it meets the second, at 10.38 (10.4 in print).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Usfd {
    /// Rate over `I` of mild wear (ug/(m mm2) over N/mm2): 5.3.
    pub mild_slope: f64,
    /// Rate of severe wear (ug/(m mm2)): 55.
    pub severe_rate: f64,
    /// `I` at which catastrophic wear begins (N/mm2): 77.2.
    pub catastrophic_from: f64,
    /// Further rate over further `I` of catastrophic wear: 61.9.
    pub catastrophic_slope: f64,
}

impl Default for Usfd {
    fn default() -> Self {
        Self {
            mild_slope: 5.3,
            severe_rate: 55.0,
            catastrophic_from: 77.2,
            catastrophic_slope: 61.9,
        }
    }
}

impl Usfd {
    /// Mass of metal lost per metre rolled and area of the contact (kg/m3), for the frictional work per
    /// metre rolled and area `work` (N/m2): `TGamma` over the area, or that of one element.
    ///
    /// ```
    /// use creepage::damage::Usfd;
    /// let severe = Usfd::default().rate(30e6); // 30 N/mm2
    /// assert_eq!(severe, 55e-3); // 55 ug/(m mm2)
    /// ```
    #[must_use]
    pub fn rate(&self, work: f64) -> f64 {
        let index = work.max(0.0) * PER_MM2;
        let joined = (self.mild_slope * index).min(self.severe_rate);
        let beyond = self.catastrophic_slope * (index - self.catastrophic_from).max(0.0);
        RATE * (joined + beyond)
    }

    /// Depth lost in one passage (m) where the material runs through `elements`, one row of a contact
    /// along the rolling direction, for metal of `density` (kg/m3).
    #[must_use]
    pub fn depth(&self, row: &[super::ElementState], density: f64) -> f64 {
        let mass: f64 = row.iter().map(|element| self.rate(element.work()) * element.length).sum();
        mass / density
    }
}

/// British Rail Research's wear by T gamma alone: T.G. Pearce, N.D. Sherratt, Wear 144 (1991) 343-351.
/// *Unverified.*
///
/// Area lost of the section times the wheel's diameter in mm, per km rolled: `0.25 T`, then 25 from
/// 100 N, then `1.19 T - 154` from 200 N, where it **jumps** from 25 to 84 mm2 as published.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Bre {
    /// Area times diameter over T gamma of mild wear (mm3/km/N): 0.25.
    pub mild_slope: f64,
    /// T gamma at which wear stops growing, and at which it grows again (N): 100, 200.
    pub plateau: [f64; 2],
    /// Slope and offset of severe wear (mm3/km): 1.19, -154.
    pub severe: [f64; 2],
}

impl Default for Bre {
    fn default() -> Self {
        Self { mild_slope: 0.25, plateau: [100.0, 200.0], severe: [1.19, -154.0] }
    }
}

impl Bre {
    /// Area of the wheel's section lost per metre rolled (m2/m), for `t_gamma` (N) and the wheel's
    /// `diameter` (m).
    #[must_use]
    pub fn area_rate(&self, t_gamma: f64, diameter: f64) -> f64 {
        let [from, to] = self.plateau;
        let loss = if t_gamma < to {
            self.mild_slope * t_gamma.clamp(0.0, from)
        } else {
            self.severe[0] * t_gamma + self.severe[1]
        };
        // mm2 mm/km is 1e-12 m2 m/m.
        loss * 1e-12 / diameter
    }
}
