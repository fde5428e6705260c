//! What a contact map has of a wheelset's file: its head, or the reason why there is no map of this wheelset.

use creepage::TheorySpec;
use creepage::table::Table;
use creepage_map::{Head, HeightOrLoad, State};
use creepage_rail::RailMotion;
use creepage_wheelset::{Drive, Load, PitchRate, RailFriction, RigidSlip, WheelsetError};

use super::error::MapBuildError;
use super::plan::MapPlan;
use crate::wheelset::case::WheelsetCase;
use crate::wheelset::error::section;

/// The head of a wheelset's map.
pub(super) fn of(case: &WheelsetCase, plan: &MapPlan) -> Result<Head, MapBuildError> {
    if case.slip == RigidSlip::Curved {
        return Err(MapBuildError::Curved);
    }
    if case.stance.side.is_some() {
        return Err(MapBuildError::OneWheel);
    }
    let travel = case.travel.unwrap_or_default();
    let is_plain = matches!(travel.pitch, PitchRate::Rigid(_)) && travel.drive == Drive::default();
    for (is_in, what) in [
        (
            !case.running.varies(),
            "[wheel] slices, flat, waviness, [rail] slices, corrugation, roller_radius",
        ),
        (!case.is_guarded(), "[rail] guard"),
        (matches!(case.theory, TheorySpec::Exact(_)), "[solve] theory other than \"exact\""),
        (travel.curvature == 0.0, "[track] curve_radius"),
        (travel.rails == [RailMotion::default(); 2], "[rail] dy_rate, dz_rate, droll_rate"),
        (is_plain, "[motion] torque, longitudinal_force, independent wheels"),
        (travel.speed >= 0.0, "[motion] speed below zero"),
    ] {
        if !is_in {
            return Err(MapBuildError::NotInMap { what });
        }
    }
    let friction = friction(case)?;
    let pair = case.solids.ok_or_else(|| section("materials", "shear_modulus, poisson"));
    let pair = pair.map_err(MapBuildError::from_case)?;
    let track = case.running.track();
    Ok(Head {
        radius: case.running.wheelset().radius(),
        half_distance: 0.5 * case.running.wheelset().tape_distance(),
        rail_origins: [track.left.origin(), track.right.origin()],
        poisson: pair.poisson(),
        friction: plan.friction,
        yaw: plan.yaw,
        roll: MapPlan::ROLL,
        own: own(case, friction)?,
    })
}

/// Whether a map can be fitted by this table: it is of `exact` where it names its theory, and has the ratios of axes that
/// contacts of wheels come near, for this Poisson's ratio.
pub(super) fn check_ellipses(table: &Table, poisson: f64) -> Result<(), MapBuildError> {
    const RATIOS: [f64; 2] = [0.2, 20.0];
    let theory = &table.provenance().theory;
    if !matches!(theory.as_str(), "" | "exact") {
        return Err(MapBuildError::EllipsesOf { theory: theory.clone() });
    }
    for (quantity, axis, needed) in
        [("a_over_b", table.a_over_b(), RATIOS), ("poisson", table.poisson(), [poisson; 2])]
    {
        let given = [axis.low, axis.high];
        // As wide as is needed, but for rounding.
        let is_wide = given[0] <= needed[0] + 1e-9 && given[1] >= needed[1] - 1e-9;
        if !is_wide {
            return Err(MapBuildError::EllipsesRange { quantity, given, needed });
        }
    }
    Ok(())
}

/// The coefficient of friction of both rails; 0.3 where the file has no friction, for the map covers a range of it.
fn friction(case: &WheelsetCase) -> Result<f64, MapBuildError> {
    match &case.friction {
        None => Ok(0.3),
        Some([RailFriction::Constant(left), RailFriction::Constant(right)])
            if left.to_bits() == right.to_bits() =>
        {
            Ok(*left)
        }
        Some(_) => {
            let what = "[contact] friction by place or speed of slip, and different rails'";
            Err(MapBuildError::NotInMap { what })
        }
    }
}

/// The state that the wheelset's file has.
fn own(case: &WheelsetCase, friction: f64) -> Result<State, MapBuildError> {
    let (stance, travel) = (case.stance, case.travel.unwrap_or_default());
    let pressed = match stance.load {
        Some(Load::Axle(load)) => HeightOrLoad::AxleLoad(load),
        Some(Load::Wheel(load)) => HeightOrLoad::AxleLoad(2.0 * load),
        Some(Load::Height(z)) => HeightOrLoad::Height(z),
        Some(Load::Wheels(_) | Load::Loaded { .. }) => return Err(MapBuildError::UNEVEN),
        None => return Err(WheelsetError::NoLoad.into()),
    };
    let pitch_rate = match travel.pitch {
        PitchRate::Rigid(rate) => rate,
        PitchRate::Independent(_) => None,
    };
    Ok(case.state(pressed, pitch_rate, friction))
}

impl WheelsetCase {
    /// Its position and motion as a state of which a contact map is asked, pressed so, at this pitch rate (rad/s) and
    /// with this friction.
    #[must_use]
    pub fn state(&self, pressed: HeightOrLoad, pitch_rate: Option<f64>, friction: f64) -> State {
        let (stance, travel) = (self.stance, self.travel.unwrap_or_default());
        State {
            y: stance.y,
            yaw: stance.yaw,
            roll: stance.roll,
            pressed,
            speed: travel.speed,
            pitch_rate,
            lateral_velocity: travel.lateral_velocity,
            vertical_velocity: travel.vertical_velocity,
            roll_rate: travel.roll_rate,
            yaw_rate: travel.yaw_rate,
            friction,
        }
    }
}
