//! The report for programs. Key names carry their units; a number that is not finite is `null`.

use std::collections::BTreeMap;

use creepage::coulomb::Constraints;
use creepage::friction_law::RollingFriction;
use creepage::{Creepage, Force, Hertz, SiCreepage, SiForce};
use serde::Serialize;

use crate::contact_json::{HertzJson, hertz_json};
use crate::gap::OnAreas;
use crate::{Caution, Damage, GapReportJson, Heat, SolvedCase};

/// `report.json` of any contact.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum AnyReportJson {
    /// Of Hertz's ellipse.
    Ellipse(Box<ReportJson>),
    /// Of areas of any shape.
    Areas(Box<GapReportJson>),
    /// Of nothing that touches.
    None,
}

/// `report.json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReportJson {
    /// Version of this program.
    pub creepage_version: &'static str,
    /// The theory's name.
    pub theory: String,
    /// One word: [`Status::name`](creepage::Status::name).
    pub status: &'static str,
    /// Cautions about the solution, in words; else `null`.
    pub caution: Option<String>,
    /// The contact.
    pub contact: HertzJson,
    /// Coefficient of friction `mu`.
    pub friction: f64,
    /// Creepage of the upper body relative to the lower.
    pub creepage: CreepageJson,
    /// Force of the upper body on the lower.
    pub lower_body: ForceJson,
    /// Force of the lower body on the upper: the reaction.
    pub upper_body: ForceJson,
    /// The force on the lower body in units of `mu N` and `mu N c`.
    pub dimensionless: DimensionlessJson,
    /// Areas of adhesion and slip.
    pub areas: AreasJson,
    /// Names of the three quantities that were given, where the creepage was found to wanted
    /// forces; else `null`.
    pub known: Option<Vec<&'static str>>,
    /// Energy turned to heat per metre rolled (J/m), from force and creepage.
    pub frictional_power_per_metre_j_per_m: f64,
    /// The same (J/m) from traction and slip over the contact, where the theory gives it.
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
    /// What only this theory says, by key.
    pub details: BTreeMap<&'static str, DetailJson>,
}

/// How friction varies: by the speed of slip, or across the contact.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FrictionLawJson {
    /// Coefficient at rest, the `mu` of all quantities.
    pub at_rest: f64,
    /// Coefficient at very high speed.
    pub kinetic: f64,
    /// `[drop, half speed (m/s)]` of each term.
    pub terms: Vec<[f64; 2]>,
    /// Distance of slip over which friction follows the speed (m), where it does.
    pub memory_distance_m: Option<f64>,
    /// The least speed that slip counts as in that (m/s).
    pub memory_speed_m_per_s: Option<f64>,
    /// `[temperature (degrees Celsius), coefficient]` of cold and of hot surfaces, where it depends on the
    /// temperature; else `null`.
    pub by_temperature: Option<[[f64; 2]; 2]>,
    /// `[y (m), coefficient]` where friction differs across the contact; else `null`.
    pub across: Option<Vec<[f64; 2]>>,
}

impl From<RollingFriction> for FrictionLawJson {
    fn from(friction: RollingFriction) -> Self {
        let (law, memory) = (friction.law(), friction.memory());
        Self {
            at_rest: law.at_rest(),
            kinetic: law.kinetic(),
            terms: law.terms().iter().map(|term| [term.drop, term.half_speed]).collect(),
            memory_distance_m: memory.map(|memory| memory.distance()),
            memory_speed_m_per_s: memory.map(|memory| memory.speed()),
            by_temperature: friction.of_temperature().map(|law| {
                let (range, ends) = (law.range(), law.ends());
                [0, 1].map(|k| [range[k], ends[k]])
            }),
            across: friction.by_place().map(|across| across.points().to_vec()),
        }
    }
}

/// Creepage and spin in both kinds of units.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CreepageJson {
    /// Relative velocity over rolling velocity, along.
    pub longitudinal: f64,
    /// Relative velocity over rolling velocity, across.
    pub lateral: f64,
    /// Relative angular velocity over rolling velocity (rad/m).
    pub spin_rad_per_m: f64,
    /// Dimensionless `xi`.
    pub xi: f64,
    /// Dimensionless `eta`.
    pub eta: f64,
    /// Dimensionless `chi`.
    pub chi: f64,
}

/// Tangential force and moment on one body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ForceJson {
    /// Along the rolling direction (N).
    pub longitudinal_n: f64,
    /// Across (N).
    pub lateral_n: f64,
    /// About the normal (N m).
    pub moment_n_m: f64,
}

/// The force in parts of what friction can bear.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DimensionlessJson {
    /// `F_x / (mu N)`.
    pub fx: f64,
    /// `F_y / (mu N)`.
    pub fy: f64,
    /// `M_z / (mu N c)`.
    pub mz: f64,
    /// `sqrt(f_x^2 + f_y^2)`, the used share of `mu N`.
    pub friction_used: f64,
}

/// Areas of adhesion and slip.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AreasJson {
    /// Adhesion area over contact area.
    pub adhesion_share: f64,
    /// Adhesion area (m^2).
    pub adhesion_m2: f64,
    /// Slip area (m^2).
    pub slip_m2: f64,
    /// Points in `points.csv`.
    pub points: usize,
}

/// A number that only one theory gives.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DetailJson {
    /// What it is, in words.
    pub label: &'static str,
    /// The number.
    pub value: f64,
}

impl SolvedCase {
    /// Everything but the points, ready for `serde_json`.
    #[must_use]
    pub fn json(&self) -> AnyReportJson {
        match (OnAreas::of(self), self.case.hertz()) {
            (Some(on_areas), _) => AnyReportJson::Areas(Box::new(on_areas.json())),
            (None, Some(hertz)) => AnyReportJson::Ellipse(Box::new(self.json_on(hertz))),
            (None, None) => AnyReportJson::None,
        }
    }

    fn json_on(&self, hertz: &Hertz) -> ReportJson {
        let (solution, scaling) = (self.solution(), self.scaling());
        let force = scaling.si_force(solution.force);
        let caution = (!self.cautions.is_empty()).then(|| Caution::words(&self.cautions));
        ReportJson {
            creepage_version: env!("CARGO_PKG_VERSION"),
            theory: self.theory.name.into(),
            status: solution.status.name(),
            caution,
            contact: hertz_json(hertz),
            friction: self.case.friction(),
            creepage: CreepageJson::new(self.creepage(), scaling.si_creepage(self.creepage())),
            lower_body: force.into(),
            upper_body: (-force).into(),
            dimensionless: solution.force.into(),
            areas: self.areas_json(),
            known: self.known(),
            frictional_power_per_metre_j_per_m: self.power_per_metre(),
            frictional_power_per_metre_by_slip_j_per_m: self.dissipation_per_metre(),
            rolling_velocity_m_per_s: self.case.speed(),
            frictional_power_w: self.power(),
            friction_law: self.contact.rolling_friction().map(Into::into),
            // Tractions of a solved case are finite.
            damage: self.damage().ok().flatten().cloned(),
            heat: self.heat().cloned(),
            details: self
                .diagnostics()
                .iter()
                .map(|d| (d.key, DetailJson { label: d.label, value: d.value }))
                .collect(),
        }
    }

    /// Names of the three quantities that were given, where the creepage was to be found.
    #[must_use]
    pub fn known(&self) -> Option<Vec<&'static str>> {
        let Constraints { xi, eta, chi, fx, fy, mz } = self.constraints()?;
        let values = [("xi", xi), ("eta", eta), ("chi", chi), ("fx", fx), ("fy", fy), ("mz", mz)];
        Some(values.into_iter().filter_map(|(name, value)| value.map(|_| name)).collect())
    }

    fn areas_json(&self) -> AreasJson {
        let (share, area) = (self.adhesion_share(), self.contact_area());
        AreasJson {
            adhesion_share: share,
            adhesion_m2: share * area,
            slip_m2: (1.0 - share) * area,
            points: self.point_count(),
        }
    }
}

impl CreepageJson {
    fn new(dimensionless: Creepage, si: SiCreepage) -> Self {
        Self {
            longitudinal: si.longitudinal,
            lateral: si.lateral,
            spin_rad_per_m: si.spin,
            xi: dimensionless.xi(),
            eta: dimensionless.eta(),
            chi: dimensionless.chi(),
        }
    }
}

impl From<SiForce> for ForceJson {
    fn from(force: SiForce) -> Self {
        Self {
            longitudinal_n: force.longitudinal,
            lateral_n: force.lateral,
            moment_n_m: force.moment,
        }
    }
}

impl From<Force> for DimensionlessJson {
    fn from(force: Force) -> Self {
        Self { fx: force.fx, fy: force.fy, mz: force.mz, friction_used: force.magnitude() }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::testing::{CURVE, SLIDING, case, report, solved};
    use crate::{Case, Given};

    fn close(value: &serde_json::Value, expected: f64) {
        // A handful of roundings.
        assert!((value.as_f64().unwrap() / expected - 1.0).abs() < 1e-12, "{value} {expected}");
    }

    #[test]
    fn the_numbers_are_those_of_hand_formulas() {
        let json = serde_json::to_value(report(2.25, SLIDING, CURVE).json()).unwrap();
        // c = 6 mm, so a = 9 mm and b = 4 mm; mu N = 24 kN.
        close(&json["contact"]["semi_axis_rolling_m"], 9e-3);
        close(&json["contact"]["semi_axis_lateral_m"], 4e-3);
        close(&json["contact"]["peak_pressure_pa"], 1.5 * 80e3 / (PI * 36e-6));
        close(&json["lower_body"]["longitudinal_n"], 0.6 * 24e3);
        close(&json["lower_body"]["lateral_n"], 0.5 * 24e3);
        close(&json["lower_body"]["moment_n_m"], -0.1 * 24e3 * 6e-3);
        close(&json["upper_body"]["longitudinal_n"], -0.6 * 24e3);
        close(&json["upper_body"]["moment_n_m"], 0.1 * 24e3 * 6e-3);
        let rho = json["contact"]["rho_m"].as_f64().unwrap();
        close(&json["creepage"]["longitudinal"], CURVE[0] * 0.3 * 6e-3 / rho);
        close(&json["creepage"]["lateral"], CURVE[1] * 0.3 * 6e-3 / rho);
        close(&json["creepage"]["spin_rad_per_m"], CURVE[2] * 0.3 / rho);
        close(&json["dimensionless"]["friction_used"], 0.61_f64.sqrt());
        close(&json["areas"]["slip_m2"], PI * 36e-6);
    }

    #[test]
    fn what_is_known_besides() {
        let plain = serde_json::to_value(report(1.0, SLIDING, CURVE).json()).unwrap();
        for key in ["caution", "known", "rolling_velocity_m_per_s", "frictional_power_w"] {
            assert!(plain[key].is_null(), "{key}");
        }
        let given =
            Constraints { chi: Some(1.5), fx: Some(0.6), fy: Some(0.5), ..Constraints::default() };
        let like = case(1.0, CURVE);
        let contact = like.contact.with_kappa_over_mu(0.5).unwrap();
        let case = Case { contact, speed: Some(20.0), given: Given::Constraints(given), ..like };
        let json = serde_json::to_value(solved(&case, SLIDING).json()).unwrap();
        assert!(json["caution"].as_str().unwrap().contains("kappa/mu = 0.5"), "{json}");
        assert_eq!(json["known"], serde_json::json!(["chi", "fx", "fy"]));
        let per_metre = json["frictional_power_per_metre_j_per_m"].as_f64().unwrap();
        close(&json["frictional_power_w"], 20.0 * per_metre);
        let slip = json["contact"]["rho_m"].as_f64().map(|rho| 0.3 * 6e-3 / rho).unwrap();
        close(&json["frictional_power_per_metre_by_slip_j_per_m"], 0.5 * 24e3 * slip);
    }

    #[test]
    fn words_and_details() {
        let json = serde_json::to_value(report(1.0, SLIDING, CURVE).json()).unwrap();
        assert_eq!(json["status"], "spin_too_large");
        assert_eq!(json["theory"], "test & trial");
        assert_eq!(json["creepage_version"], env!("CARGO_PKG_VERSION"));
        assert_eq!(json["details"]["mean_integrand"]["value"], 1.25e-3);
        assert!(json["details"]["unknown"]["value"].is_null());
        assert_eq!(json["areas"]["points"], 3);
    }
}
