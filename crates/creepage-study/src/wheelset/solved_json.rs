//! The report of a wheelset for programs. Key names carry their units; a number that is not
//! finite is `null`.

use creepage::normal::Method;
use creepage_wheelset::{Resultant, RigidSlip, SolvedContact, SolvedWheel};
use serde::Serialize;

use super::derivatives_json::{DerivativesJson, derivatives_json};
use super::report::WheelsetReport;
use crate::{Damage, Heat};

/// `report.json` of a wheelset, in track axes: `x` forward, `y` right, `z` down.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WheelsetReportJson {
    /// Version of this program.
    pub creepage_version: &'static str,
    /// The theory's name.
    pub theory: &'static str,
    /// One word: [`Status::name`](creepage::Status::name), the worst of all contacts.
    pub status: &'static str,
    /// Cautions about the solution, in words; else `null`.
    pub caution: Option<String>,
    /// Lateral position of the wheelset, to the right (m).
    pub y_m: f64,
    /// Its height, down (m); at 0 the nominal circle touches the track plane.
    pub z_m: f64,
    /// Turn about `x` (rad).
    pub roll_rad: f64,
    /// Turn about `z` (rad).
    pub yaw_rad: f64,
    /// Place along the track (m); left out unless surfaces vary along rolling.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub s_m: Option<f64>,
    /// How far the wheels have rolled on (rad), positive forward; left out unless surfaces vary along rolling.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pitch_rad: Option<f64>,
    /// Speed along the track (m/s).
    pub speed_m_per_s: f64,
    /// Angular velocity about the axle (rad/s), positive when it rolls forward.
    pub pitch_rate_rad_per_s: f64,
    /// Velocity to the right (m/s).
    pub lateral_velocity_m_per_s: f64,
    /// Velocity downwards (m/s).
    pub vertical_velocity_m_per_s: f64,
    /// Angular velocity about `x` (rad/s).
    pub roll_rate_rad_per_s: f64,
    /// Angular velocity about `z` (rad/s).
    pub yaw_rate_rad_per_s: f64,
    /// Coefficient of friction, the largest where it differs by place.
    pub friction: f64,
    /// The least one; left out where it does not differ by place.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub least_friction: Option<f64>,
    /// `flat` or `curved`: how the rigid slip follows from the motion.
    pub slip: &'static str,
    /// The left wheel on its rail; `null` where the right one was solved alone.
    pub left: Option<WheelJson>,
    /// The right wheel on its rail; `null` where the left one was solved alone.
    pub right: Option<WheelJson>,
}

/// One wheel on its rail.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WheelJson {
    /// Force of the wheel on the rail, with that on the guard rail beside it where there is one.
    pub force: RailForceJson,
    /// Its places of contact, by falling load.
    pub patches: Vec<WheelPatchJson>,
    /// The wheelset's height for this wheel (m).
    pub z_m: f64,
    /// Its angular velocity about the axle (rad/s), of independent wheels its own.
    pub pitch_rate_rad_per_s: f64,
    /// How far it would have to go down to touch (m), where it touches nothing; else `null`.
    pub clearance_m: Option<f64>,
    /// The guard rail beside its rail; absent without one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub guard: Option<GuardJson>,
    /// How far its rail gave way on its springs, `[y, z]` (m), where it lies on any; else `null`.
    pub rail_deflection_m: Option<[f64; 2]>,
    /// Origin of the rail's profile `[x, y, z]` (m).
    pub rail_origin_m: [f64; 3],
    /// How the force changes with the wheelset's position and motion; `null` where nobody asked.
    pub derivatives: Option<DerivativesJson>,
}

/// What a wheel does to the guard rail.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GuardJson {
    /// Force on it, a part of the wheel's `force`; its moment is about the origin of the running rail's profile.
    pub force: RailForceJson,
    /// The least distance between the flange's back and it (m), 0 where they touch.
    pub clearance_m: Option<f64>,
}

/// A force on a rail in track axes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RailForceJson {
    /// Along `x` (N).
    pub longitudinal_n: f64,
    /// Its error bar (N); null by a theory without, here and below.
    pub longitudinal_error_n: Option<f64>,
    /// Along `y` (N).
    pub lateral_n: f64,
    /// Its error bar (N).
    pub lateral_error_n: Option<f64>,
    /// Along `z` (N).
    pub vertical_n: f64,
    /// Its error bar (N).
    pub vertical_error_n: Option<f64>,
    /// About `x` through the origin of the rail's profile (N m).
    pub moment_x_n_m: f64,
    /// About `y` (N m).
    pub moment_y_n_m: f64,
    /// About `z` (N m).
    pub moment_z_n_m: f64,
}

/// One place of contact. Its axes: `x` forward, `s = (cos angle, sin angle)` in the track's
/// `(y, z)`, the normal into the rail.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WheelPatchJson {
    /// `guard` where it lies on the guard rail; left out on the running rail.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rail: Option<&'static str>,
    /// The reference point in track axes: along (m).
    pub x_m: f64,
    /// Across (m).
    pub y_m: f64,
    /// Down (m).
    pub z_m: f64,
    /// The reference point's `y` in the rail's profile, to the field side (m).
    pub y_rail_m: f64,
    /// The same in the wheel's profile (m).
    pub y_wheel_m: f64,
    /// Rotation about `x` from the track's `z` to the normal (rad).
    pub contact_angle_rad: f64,
    /// Turn about `s` after that (rad), which lowers the plane ahead; left out unless surfaces vary along rolling.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact_slope_rad: Option<f64>,
    /// Approach of the undeformed bodies along the normal (m).
    pub approach_m: f64,
    /// Its error bar (m).
    pub approach_error_m: f64,
    /// Normal force (N).
    pub normal_force_n: f64,
    /// Its error bar (N).
    pub normal_force_error_n: f64,
    /// Force along `x` (N).
    pub longitudinal_n: f64,
    /// Its error bar (N); null by a theory without, here and below.
    pub longitudinal_error_n: Option<f64>,
    /// Force along `s` (N).
    pub lateral_n: f64,
    /// Its error bar (N).
    pub lateral_error_n: Option<f64>,
    /// Moment about the normal through the reference point (N m).
    pub moment_n_m: f64,
    /// Its error bar (N m).
    pub moment_error_n_m: Option<f64>,
    /// Largest pressure (Pa).
    pub peak_pressure_pa: f64,
    /// Its error bar (Pa).
    pub peak_pressure_error_pa: f64,
    /// Area (m^2).
    pub area_m2: f64,
    /// Its error bar (m^2).
    pub area_error_m2: f64,
    /// Connected areas.
    pub areas: usize,
    /// Extent along `x` from the reference point (m).
    pub extent_x_m: [f64; 2],
    /// Extent along `s` from the reference point (m).
    pub extent_s_m: [f64; 2],
    /// Centre of pressure `[x, s]` from the reference point (m).
    pub centre_of_pressure_m: [f64; 2],
    /// Longitudinal creepage of the wheel relative to the rail.
    pub longitudinal_creepage: f64,
    /// Lateral creepage.
    pub lateral_creepage: f64,
    /// Spin (rad/m).
    pub spin_rad_per_m: f64,
    /// Adhesion area over contact area.
    pub adhesion_share: f64,
    /// Energy turned to heat per metre rolled (J/m).
    pub frictional_power_per_metre_j_per_m: Option<f64>,
    /// How the pressure was found: `strips` or `elements`.
    pub method: &'static str,
    /// One word.
    pub status: &'static str,
    /// Wear and fatigue numbers, where `[damage]` asks for them; else `null`.
    pub damage: Option<Damage>,
    /// Temperatures, where `[heat]` asks for them; else `null`.
    pub heat: Option<Heat>,
}

impl WheelsetReport {
    /// The report, ready for `serde_json`.
    #[must_use]
    pub fn json(&self) -> WheelsetReportJson {
        let (position, motion) = (self.position(), self.motion);
        let words = self.caution_words().join("; ");
        WheelsetReportJson {
            creepage_version: env!("CARGO_PKG_VERSION"),
            theory: self.theory.name(),
            status: self.status().name(),
            caution: (!words.is_empty()).then_some(words),
            y_m: position.y,
            z_m: position.z,
            roll_rad: position.roll,
            yaw_rad: position.yaw,
            s_m: self.place.map(|[s, _]| s),
            pitch_rad: self.place.map(|[_, pitch]| pitch),
            speed_m_per_s: motion.speed,
            pitch_rate_rad_per_s: motion.pitch_rate,
            lateral_velocity_m_per_s: motion.lateral_velocity,
            vertical_velocity_m_per_s: motion.vertical_velocity,
            roll_rate_rad_per_s: motion.roll_rate,
            yaw_rate_rad_per_s: motion.yaw_rate,
            friction: self.friction,
            least_friction: (self.least_friction < self.friction).then_some(self.least_friction),
            slip: match self.slip {
                RigidSlip::Flat => "flat",
                RigidSlip::Curved => "curved",
            },
            left: self.left.as_ref().map(|wheel| self.wheel_json(wheel)),
            right: self.right.as_ref().map(|wheel| self.wheel_json(wheel)),
        }
    }

    fn wheel_json(&self, wheel: &SolvedWheel) -> WheelJson {
        let derivatives = self.derivatives.as_ref().map(|all| derivatives_json(all, wheel.side));
        WheelJson::new(self, wheel, derivatives)
    }
}

impl WheelJson {
    fn new(
        report: &WheelsetReport,
        wheel: &SolvedWheel,
        derivatives: Option<DerivativesJson>,
    ) -> Self {
        let damage = report.damage(wheel.side);
        let patch = |(k, contact): (usize, &SolvedContact)| {
            WheelPatchJson::new(contact, damage.get(k), report.heat(wheel.side, k))
        };
        Self {
            force: RailForceJson::new(&wheel.on_rail()),
            patches: wheel.contacts().iter().enumerate().map(patch).collect(),
            z_m: wheel.position.z,
            pitch_rate_rad_per_s: wheel.pitch_rate,
            clearance_m: wheel.clearance,
            guard: wheel.on_guard().map(|force| GuardJson {
                force: RailForceJson::new(&force),
                clearance_m: wheel.guard_clearance,
            }),
            rail_deflection_m: wheel.deflection,
            rail_origin_m: wheel.rail_origin,
            derivatives,
        }
    }
}

impl RailForceJson {
    fn new(on_rail: &Resultant) -> Self {
        let Resultant { force, force_error, moment } = *on_rail;
        Self {
            longitudinal_n: force[0],
            longitudinal_error_n: force_error.map(|error| error[0]),
            lateral_n: force[1],
            lateral_error_n: force_error.map(|error| error[1]),
            vertical_n: force[2],
            vertical_error_n: force_error.map(|error| error[2]),
            moment_x_n_m: moment[0],
            moment_y_n_m: moment[1],
            moment_z_n_m: moment[2],
        }
    }
}

impl WheelPatchJson {
    fn new(contact: &SolvedContact, damage: Option<&Damage>, heat: Option<&Heat>) -> Self {
        let normal = &contact.normal;
        let [load, approach, area, peak] =
            [normal.load(), normal.approach(), normal.area(), normal.peak_pressure()];
        let [x_m, y_m, z_m] = contact.reference;
        let [x, s] = contact.extent();
        Self {
            rail: contact.is_on_guard.then_some("guard"),
            x_m,
            y_m,
            z_m,
            y_rail_m: contact.y_rail,
            y_wheel_m: contact.y_wheel,
            contact_angle_rad: contact.angle,
            contact_slope_rad: contact.varying.map(|_| contact.slope),
            approach_m: approach.value,
            approach_error_m: approach.error,
            normal_force_n: load.value,
            normal_force_error_n: contact.load_error,
            longitudinal_n: contact.force.longitudinal,
            longitudinal_error_n: contact.force_error.map(|error| error.longitudinal),
            lateral_n: contact.force.lateral,
            lateral_error_n: contact.force_error.map(|error| error.lateral),
            moment_n_m: contact.force.moment,
            moment_error_n_m: contact.force_error.map(|error| error.moment),
            peak_pressure_pa: peak.value,
            peak_pressure_error_pa: peak.error,
            area_m2: area.value,
            area_error_m2: area.error,
            areas: normal.patches().len(),
            extent_x_m: x,
            extent_s_m: s,
            centre_of_pressure_m: contact.centre_of_pressure(),
            longitudinal_creepage: contact.creepage.longitudinal,
            lateral_creepage: contact.creepage.lateral,
            spin_rad_per_m: contact.creepage.spin,
            adhesion_share: contact.adhesion_share(),
            frictional_power_per_metre_j_per_m: contact.dissipation,
            method: match normal.method() {
                Method::Strips => "strips",
                Method::Elements => "elements",
            },
            status: contact.status.name(),
            damage: damage.cloned(),
            heat: heat.cloned(),
        }
    }
}
