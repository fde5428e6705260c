//! Wear and fatigue numbers of one contact.

use std::f64::consts::PI;

use creepage::damage::{
    FatigueStress, Row, Shakedown, TGamma, WearZone, local_surface_index, surface_index,
};
use creepage::{SiCreepage, SiForce};
use serde::Serialize;

use super::section::DamageWanted;

/// Input of the wear and fatigue numbers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DamageInput<'a> {
    /// Force on the lower body.
    pub force: SiForce,
    pub creepage: SiCreepage,
    /// Normal force (N), area (m2), peak pressure (Pa).
    pub normal: f64,
    pub area: f64,
    pub peak: f64,
    /// Rolling velocity (m/s).
    pub speed: Option<f64>,
    /// Rows of elements across the contact; `None` where the theory gives no slip.
    pub rows: Option<&'a [Row]>,
}

/// Wear and fatigue numbers. Key names carry their units.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Damage {
    /// `|F_x upsilon_x| + |F_y upsilon_y|` (N).
    pub t_gamma_n: f64,
    /// The same and `|M_z phi|` (N).
    pub t_gamma_with_spin_n: f64,
    /// T gamma, with spin, over the contact area (N/mm2): the index of USFD's law.
    pub t_gamma_over_area_n_per_mm2: f64,
    /// Wear rate by USFD's law of that (ug of metal per metre rolled and mm2 of contact).
    pub usfd_rate_ug_per_m_mm2: f64,
    /// Mass worn per metre rolled by USFD's law element by element (kg/m).
    pub usfd_mass_kg_per_m: Option<f64>,
    /// The deepest wear of a passage by it (m).
    pub usfd_depth_m: Option<f64>,
    /// Area of the wheel's section lost per metre rolled by British Rail Research's law (m2/m), where
    /// the wheel's diameter is given.
    pub bre_area_m2_per_m: Option<f64>,
    /// The deepest wear of a passage by Archard's map (m), where the rolling velocity is given.
    pub archard_depth_m: Option<f64>,
    /// Area of the section worn in a passage by Archard's map (m2).
    pub archard_area_m2: Option<f64>,
    /// The worst zone of the map.
    pub archard_zone: Option<&'static str>,
    /// Damage of the rail by the whole life rail model, per wheel, whatever the force's direction.
    pub wlrm_damage: f64,
    /// The same where only wheels that drive grow cracks.
    pub wlrm_directed_damage: f64,
    /// Tangential force over the load.
    pub traction_coefficient: f64,
    /// Peak pressure over the shear yield stress `k`.
    pub peak_over_shear_yield: f64,
    /// Surface fatigue index, force over load less `k/p0`: positive where the surface ratchets.
    pub surface_fatigue_index: f64,
    /// The largest of `(|p_t| - k)/p_n` over the elements.
    pub local_surface_fatigue_index: Option<f64>,
    /// Ekberg's subsurface index (Pa): positive where fatigue is predicted.
    pub subsurface_fatigue_index_pa: f64,
    /// The factor by which loads may grow and the lower body still shake down, by Melan's bound.
    pub shakedown_load_factor: Option<f64>,
    /// Where that is governed: `y` and depth (m).
    pub shakedown_place_m: Option<[f64; 2]>,
    /// Dang Van's largest equivalent stress over a passage (Pa), in the lower body to the depth of the contact's
    /// smaller half-width.
    pub dang_van_stress_pa: Option<f64>,
    /// The same over its limit: fatigue is predicted above 1.
    pub dang_van_over_limit: Option<f64>,
    /// Where that is: `y` and depth (m).
    pub dang_van_place_m: Option<[f64; 2]>,
    /// The laws whose constants are from memory and were not compared with the print.
    pub unverified: Vec<&'static str>,
    /// Wear across the contact, not in `report.json` but in `wear.csv`.
    #[serde(skip)]
    pub across: Vec<WearRow>,
}

/// Wear of one passage at one place across.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WearRow {
    /// Place across (m).
    pub y: f64,
    /// Depth by USFD's law (m).
    pub usfd_depth: f64,
    /// Depth by Archard's map (m), where the rolling velocity is known.
    pub archard_depth: Option<f64>,
    /// The worst zone of the map.
    pub zone: Option<WearZone>,
}

impl Damage {
    /// Names of the numbers that every row of many cases has, as in `report.json`.
    pub const OF_ROWS: [&str; 7] = [
        "t_gamma_n",
        "t_gamma_with_spin_n",
        "usfd_rate_ug_per_m_mm2",
        "wlrm_damage",
        "wlrm_directed_damage",
        "surface_fatigue_index",
        "subsurface_fatigue_index_pa",
    ];

    /// The numbers named by [`Damage::OF_ROWS`].
    #[must_use]
    pub fn of_rows(&self) -> [f64; 7] {
        [
            self.t_gamma_n,
            self.t_gamma_with_spin_n,
            self.usfd_rate_ug_per_m_mm2,
            self.wlrm_damage,
            self.wlrm_directed_damage,
            self.surface_fatigue_index,
            self.subsurface_fatigue_index_pa,
        ]
    }

    pub(crate) fn new(
        wanted: &DamageWanted,
        input: &DamageInput,
        below: Option<(Shakedown, FatigueStress)>,
    ) -> Self {
        let (shakedown, fatigue) = below.unzip();
        let constants = wanted.constants;
        let work = TGamma::new(input.force, input.creepage);
        let traction = input.force.longitudinal.hypot(input.force.lateral);
        let index = work.with_spin / input.area;
        let across = across(wanted, input);
        let rows = input.rows.unwrap_or_default();
        let by_width = |of: fn(&WearRow) -> Option<f64>| {
            let areas = across.iter().zip(rows).map(|(wear, row)| Some(of(wear)? * row.width));
            if across.is_empty() { None } else { areas.sum::<Option<f64>>() }
        };
        let deepest =
            |of: fn(&WearRow) -> Option<f64>| across.iter().filter_map(of).reduce(f64::max);
        let elements: Vec<_> = rows.iter().flat_map(|row| row.elements.iter().copied()).collect();
        let drives = input.force.longitudinal;
        let half = (input.area / PI).sqrt();
        Self {
            t_gamma_n: work.without_spin,
            t_gamma_with_spin_n: work.with_spin,
            t_gamma_over_area_n_per_mm2: 1e-6 * index,
            usfd_rate_ug_per_m_mm2: 1e3 * constants.usfd.rate(index),
            usfd_mass_kg_per_m: by_width(|row| Some(row.usfd_depth))
                .map(|area| area * constants.density),
            usfd_depth_m: deepest(|row| Some(row.usfd_depth)),
            bre_area_m2_per_m: wanted
                .wheel_diameter
                .map(|diameter| constants.bre.area_rate(work.with_spin, diameter)),
            archard_depth_m: deepest(|row| row.archard_depth),
            archard_area_m2: by_width(|row| row.archard_depth),
            archard_zone: across.iter().filter_map(|row| row.zone).max().map(WearZone::name),
            wlrm_damage: constants.wlrm.damage(work.with_spin),
            wlrm_directed_damage: constants.wlrm.directed_damage(work.with_spin, drives),
            traction_coefficient: traction / input.normal,
            peak_over_shear_yield: input.peak / constants.shear_yield,
            surface_fatigue_index: surface_index(
                traction,
                input.normal,
                input.peak,
                constants.shear_yield,
            ),
            local_surface_fatigue_index: local_surface_index(&elements, constants.shear_yield),
            subsurface_fatigue_index_pa: constants.ekberg.index(
                input.normal,
                traction / input.normal,
                [half; 2],
            ),
            shakedown_load_factor: shakedown.map(|limit| limit.load_factor(constants.shear_yield)),
            shakedown_place_m: shakedown.map(|limit| limit.place),
            dang_van_stress_pa: fatigue.map(|used| used.equivalent),
            dang_van_over_limit: fatigue.map(|used| used.equivalent / constants.dang_van.limit),
            dang_van_place_m: fatigue.map(|used| used.place),
            unverified: wanted.unverified(),
            across,
        }
    }
}

/// Wear row by row.
fn across(wanted: &DamageWanted, input: &DamageInput) -> Vec<WearRow> {
    let constants = &wanted.constants;
    let wear = |row: &Row| {
        let archard = input.speed.map(|speed| constants.archard.wear(&row.elements, speed));
        WearRow {
            y: row.y,
            usfd_depth: constants.usfd.depth(&row.elements, constants.density),
            archard_depth: archard.map(|wear| wear.depth),
            zone: archard.map(|wear| wear.zone),
        }
    };
    input.rows.unwrap_or_default().iter().map(wear).collect()
}
