//! The report for programs. Key names carry their units; a number that is not finite is `null`.

use creepage::SiForce;
use creepage::gap::Rectangle;
use creepage::normal::{Method, NormalContact, Patch, Status};
use serde::Serialize;

use super::curved::CurvedJson;
use super::view::OnAreas;
use crate::contact_json::SolidJson;
use crate::json::{AreasJson, ForceJson, FrictionLawJson};
use crate::{Caution, Damage, Heat};

/// `report.json` of a contact of any shape.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GapReportJson {
    /// Version of this program.
    pub creepage_version: &'static str,
    /// The theory's name.
    pub theory: &'static str,
    /// One word: [`Status::name`](creepage::Status::name).
    pub status: &'static str,
    /// Cautions about the solution, in words; else `null`.
    pub caution: Option<String>,
    /// The contact areas.
    pub contact: GapContactJson,
    /// Coefficient of friction `mu`.
    pub friction: f64,
    /// Creepage of the upper body relative to the lower, at the origin of coordinates.
    pub creepage: GapCreepageJson,
    /// Force of the upper body on the lower.
    pub lower_body: GapForceJson,
    /// Force of the lower body on the upper: the reaction.
    pub upper_body: ForceJson,
    /// `sqrt(F_x^2 + F_y^2)` over `mu N`.
    pub friction_used: f64,
    /// Areas of adhesion and slip.
    pub areas: AreasJson,
    /// Names of the three quantities that were given, where the creepage was found to wanted
    /// forces; else `null`.
    pub known: Option<Vec<&'static str>>,
    /// Energy turned to heat per metre rolled (J/m), from force and creepage.
    pub frictional_power_per_metre_j_per_m: f64,
    /// The same (J/m) from traction and slip over the contact.
    pub frictional_power_per_metre_by_slip_j_per_m: Option<f64>,
    /// Rolling velocity (m/s), where it is known.
    pub rolling_velocity_m_per_s: Option<f64>,
    /// Frictional power (W), where the rolling velocity is known.
    pub frictional_power_w: Option<f64>,
    /// How friction varies, where it is not constant; else `null`.
    pub friction_law: Option<FrictionLawJson>,
    /// Wear and fatigue numbers, where `[damage]` asks for them; else `null`.
    pub damage: Option<Damage>,
    /// Temperatures, where `[heat]` asks for them; else `null`.
    pub heat: Option<Heat>,
    /// What a contact along a curve has besides; else `null`. Places across are arc lengths then.
    pub curved: Option<CurvedJson>,
}

/// Contact areas and pressure; an error bar of zero stands by what was prescribed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GapContactJson {
    /// Normal force `N` (N).
    pub normal_force_n: f64,
    /// Its error bar (N).
    pub normal_force_error_n: f64,
    /// Approach (m), counted like the gap.
    pub approach_m: f64,
    /// Its error bar (m).
    pub approach_error_m: f64,
    /// Area of all patches (m^2).
    pub area_m2: f64,
    /// Its error bar (m^2).
    pub area_error_m2: f64,
    /// Largest pressure (Pa).
    pub peak_pressure_pa: f64,
    /// Its error bar (Pa).
    pub peak_pressure_error_pa: f64,
    /// `dN/d(approach)` (N/m).
    pub stiffness_n_per_m: f64,
    /// How the pressure was found: `strips`, or `elements` where strips did not settle.
    pub method: &'static str,
    /// `converged`, or `not_converged`.
    pub status: &'static str,
    /// Centre of pressure `[x, y]` (m).
    pub centroid_m: [f64; 2],
    /// The connected areas, from low to high y.
    pub patches: Vec<PatchJson>,
    /// The equivalent solid of both bodies.
    pub solid: SolidJson,
}

/// One connected contact area.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PatchJson {
    /// The rectangle around it (m).
    pub extent_m: ExtentJson,
    /// Area (m^2).
    pub area_m2: f64,
    /// Load (N).
    pub load_n: f64,
    /// Centre of pressure `[x, y]` (m).
    pub centroid_m: [f64; 2],
}

/// A rectangle (m).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ExtentJson {
    /// Least and greatest x.
    pub x: [f64; 2],
    /// Least and greatest y.
    pub y: [f64; 2],
}

/// Creepage and spin in SI units.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GapCreepageJson {
    /// Relative velocity over rolling velocity, along.
    pub longitudinal: f64,
    /// Relative velocity over rolling velocity, across.
    pub lateral: f64,
    /// Relative angular velocity over rolling velocity (rad/m).
    pub spin_rad_per_m: f64,
}

/// Tangential force and moment with error bars.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GapForceJson {
    /// Along the rolling direction (N).
    pub longitudinal_n: f64,
    /// Its error bar (N), where the theory has one.
    pub longitudinal_error_n: Option<f64>,
    /// Across (N).
    pub lateral_n: f64,
    /// Its error bar (N), where the theory has one.
    pub lateral_error_n: Option<f64>,
    /// About the normal through the origin of coordinates (N m).
    pub moment_n_m: f64,
    /// Its error bar (N m), where the theory has one.
    pub moment_error_n_m: Option<f64>,
}

impl OnAreas<'_> {
    /// Everything but the points, ready for `serde_json`.
    pub(crate) fn json(&self) -> GapReportJson {
        let creepage = self.scaling.si_creepage(self.creepage);
        let words =
            self.solved.cautions.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ");
        GapReportJson {
            creepage_version: env!("CARGO_PKG_VERSION"),
            theory: self.solved.theory.name,
            status: self.solution.status.name(),
            caution: (!words.is_empty()).then_some(words),
            contact: self.contact_json(),
            friction: self.solved.case.friction(),
            creepage: GapCreepageJson {
                longitudinal: creepage.longitudinal,
                lateral: creepage.lateral,
                spin_rad_per_m: creepage.spin,
            },
            lower_body: GapForceJson::new(self.solved.force(), self.solved.force_error()),
            upper_body: (-self.solved.force()).into(),
            friction_used: self.solution.force.magnitude(),
            areas: self.areas_json(),
            known: self.given.known(),
            frictional_power_per_metre_j_per_m: self.solved.power_per_metre(),
            frictional_power_per_metre_by_slip_j_per_m: self.solved.dissipation_per_metre(),
            rolling_velocity_m_per_s: self.solved.case.speed(),
            frictional_power_w: self
                .solved
                .case
                .speed()
                .map(|speed| speed * self.solved.power_per_metre()),
            friction_law: self.solved.contact.rolling_friction().map(Into::into),
            damage: self.solved.damage().ok().flatten().cloned(),
            heat: self.solved.heat().cloned(),
            curved: self.solved.curved,
        }
    }

    fn contact_json(&self) -> GapContactJson {
        GapContactJson::new(self.contact)
    }

    fn areas_json(&self) -> AreasJson {
        let (share, area) = (self.solved.adhesion_share(), self.contact.area().value);
        AreasJson {
            adhesion_share: share,
            adhesion_m2: share * area,
            slip_m2: (1.0 - share) * area,
            points: self.elements.len(),
        }
    }
}

/// Bodies of any shape pressed together as a report, without rolling.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PressedReportJson {
    /// The contact areas.
    #[serde(flatten)]
    pub contact: GapContactJson,
    /// Warnings in words; else `null`.
    pub caution: Option<String>,
}

impl PressedReportJson {
    /// The areas and warnings about them.
    #[must_use]
    pub fn new(contact: &NormalContact, cautions: &[Caution]) -> Self {
        let caution = (!cautions.is_empty()).then(|| Caution::words(cautions));
        Self { contact: GapContactJson::new(contact), caution }
    }
}

/// How the pressure was found.
pub(super) fn method(contact: &NormalContact) -> &'static str {
    match contact.method() {
        Method::Strips => "strips",
        Method::Elements => "elements",
    }
}

impl GapContactJson {
    fn new(contact: &NormalContact) -> Self {
        let [load, approach, area, peak] =
            [contact.load(), contact.approach(), contact.area(), contact.peak_pressure()];
        GapContactJson {
            normal_force_n: load.value,
            normal_force_error_n: load.error,
            approach_m: approach.value,
            approach_error_m: approach.error,
            area_m2: area.value,
            area_error_m2: area.error,
            peak_pressure_pa: peak.value,
            peak_pressure_error_pa: peak.error,
            stiffness_n_per_m: contact.stiffness(),
            method: method(contact),
            status: match contact.status() {
                Status::Converged => "converged",
                Status::NotConverged { .. } => "not_converged",
            },
            centroid_m: contact.centroid(),
            patches: contact.patches().iter().map(PatchJson::new).collect(),
            solid: contact.pair().into(),
        }
    }
}

impl PatchJson {
    fn new(patch: &Patch) -> Self {
        let Rectangle { x, y } = patch.extent();
        Self {
            extent_m: ExtentJson { x, y },
            area_m2: patch.area(),
            load_n: patch.load(),
            centroid_m: patch.centroid(),
        }
    }
}

impl GapForceJson {
    fn new(force: SiForce, error: Option<SiForce>) -> Self {
        Self {
            longitudinal_n: force.longitudinal,
            longitudinal_error_n: error.map(|error| error.longitudinal),
            lateral_n: force.lateral,
            lateral_error_n: error.map(|error| error.lateral),
            moment_n_m: force.moment,
            moment_error_n_m: error.map(|error| error.moment),
        }
    }
}
