//! File of a wheelset, and the case that it describes.

use std::path::Path;

use creepage::{SolidPair, TheorySpec};
use creepage_rail::{
    Corrugation, Place, Rail, RailVariation, Role, Roller, Side, Track, Waviness, Wheel,
    WheelVariation, Wheelset, WheelsetOnTrack,
};
use creepage_wheelset::RailFriction;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;
use toml::Table;

use super::case::{ProfileNote, WheelsetCase};
use super::error::{WheelsetFileError, checked, needed, section};
use super::friction::RailFrictionValue;
use super::profile::{noted, surface_of};
use super::rails::WIDEST;
use super::sections::{
    FrictionSection, MaterialSection, MotionSection, RailSection, SideName, StepsStartSection,
    TrackSection, WheelSection, WheelsetSection,
};
use super::worn::{WearError, WearPlan, WearSection};
use crate::case::schema::schema_of;
use crate::case::{CaseError, keys, solve};
use crate::damage::DamageSection;
use crate::heat::HeatSection;

/// A wheelset in its track, in SI units: wheels and rails by their profiles, where the wheelset
/// stands, how it moves.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "creepage wheelset file")]
pub struct WheelsetFile {
    /// Both wheels, or what they have in common.
    #[serde(default)]
    wheel: WheelSection,
    /// Where the left wheel differs.
    #[serde(default)]
    wheel_left: WheelSection,
    /// Where the right wheel differs.
    #[serde(default)]
    wheel_right: WheelSection,
    /// Both rails, or what they have in common.
    #[serde(default)]
    rail: RailSection,
    /// Where the left rail differs.
    #[serde(default)]
    rail_left: RailSection,
    /// Where the right rail differs.
    #[serde(default)]
    rail_right: RailSection,
    /// Where the rails stand.
    track: TrackSection,
    /// The wheelset and where it stands.
    wheelset: WheelsetSection,
    /// How it moves.
    #[serde(default)]
    #[schemars(with = "MotionSection")]
    motion: Option<MotionSection>,
    /// The friction.
    #[serde(default)]
    #[schemars(with = "FrictionSection")]
    contact: Option<FrictionSection>,
    /// The material of wheel and rail.
    #[serde(default)]
    #[schemars(with = "MaterialSection")]
    materials: Option<MaterialSection>,
    /// The wheel's material, where it differs from the rail's.
    #[serde(default)]
    #[schemars(with = "MaterialSection")]
    upper: Option<MaterialSection>,
    /// The rail's material.
    #[serde(default)]
    #[schemars(with = "MaterialSection")]
    lower: Option<MaterialSection>,
    /// That wear and fatigue numbers are wanted, and their constants.
    #[serde(default)]
    #[schemars(with = "DamageSection")]
    damage: Option<DamageSection>,
    /// Wear over a distance, for `creepage wear`.
    #[serde(default)]
    #[schemars(with = "WearSection")]
    wear: Option<WearSection>,
    /// How wheels begin, for `creepage roll`.
    #[serde(default)]
    #[schemars(with = "StepsStartSection")]
    start: Option<StepsStartSection>,
    /// That temperatures of wheels (upper) and rails (lower) are wanted.
    #[serde(default)]
    #[schemars(with = "HeatSection")]
    heat: Option<HeatSection>,
    /// The theory, "exact" by default, and its options.
    #[serde(default)]
    #[schemars(with = "TheorySpec")]
    solve: Table,
}

/// The JSON schema (draft 2020-12) of a wheelset file, for editors and validators.
///
/// ```
/// let schema = creepage_study::wheelset_json_schema();
/// assert!(schema["properties"]["wheelset"]["properties"]["back_to_back"].is_object());
/// ```
#[must_use]
pub fn wheelset_json_schema() -> Value {
    let mut schema = schema_of::<WheelsetFile>();
    let theories = schema["properties"]["solve"]["oneOf"].as_array_mut();
    for theory in theories.into_iter().flatten() {
        if theory["properties"]["theory"]["const"] == TheorySpec::default().facts().name {
            theory["required"] = Value::Array(Vec::new());
        }
    }
    schema
}

impl WheelsetFile {
    /// Whether a text is meant as a wheelset file: it has `[wheelset]`.
    #[must_use]
    pub fn is_one(text: &str) -> bool {
        text.parse::<Table>().is_ok_and(|table| table.contains_key("wheelset"))
    }

    /// Reads the text of a wheelset file and checks its form: TOML, sections, keys and kinds of
    /// values.
    ///
    /// # Errors
    /// [`CaseError`] that says where the text is not a wheelset file.
    pub fn read(text: &str) -> Result<Self, CaseError> {
        keys::check(&text.parse()?, &wheelset_json_schema())?;
        Ok(toml::from_str(text)?)
    }

    /// The case, its profile files in `directory`. Only wheels, rails, `[track]` and
    /// `back_to_back` are needed; what else is there is checked.
    ///
    /// # Errors
    /// [`WheelsetFileError`] for profiles that cannot be read, numbers out of range, contradictions.
    pub fn case(&self, directory: &Path) -> Result<WheelsetCase, WheelsetFileError> {
        self.check_idle()?;
        let mut notes = Vec::new();
        let running = self.running(directory, &mut notes)?;
        let contact = self.contact.as_ref();
        let curvature = self.track.curvature()?;
        let rails = SIDES.map(|side| self.rail_section(side).motion());
        let travel = self.motion.as_ref().map(|motion| motion.travel(curvature, rails));
        let travel = travel.transpose()?;
        let mut stance = self.wheelset.stance()?;
        let runs = (travel.map_or(0.0, |travel| travel.speed), curvature);
        let tapes = running.wheelset().tape_distance();
        let vehicle = self.wheelset.vehicle(&self.track, tapes)?;
        if let Some(vehicle) = &vehicle {
            stance.load = Some(vehicle.load(runs.0, runs.1)?);
        }
        let speed = travel.map(|travel| travel.speed);
        let heat = self.heat.as_ref().map(|section| section.wanted_of_wheels(speed)).transpose()?;
        Ok(WheelsetCase {
            running,
            stance,
            vehicle,
            travel,
            solids: self.solids()?,
            friction: self.friction()?,
            guard_friction: self.guard_friction()?,
            springs: [
                self.rail_section(Side::Left).springs(self.springs_section(Side::Left))?,
                self.rail_section(Side::Right).springs(self.springs_section(Side::Right))?,
            ],
            slip: contact.and_then(|section| section.slip).unwrap_or_default(),
            patches: contact.and_then(|section| section.patches).unwrap_or_default(),
            damage: self.damage.as_ref().map(DamageSection::wanted_without_limit).transpose()?,
            heat,
            start: self.start.unwrap_or_default().start(),
            theory: solve::from_table(&self.solve).map_err(CaseError::from)?,
            notes,
        })
    }

    /// The wear over a distance that `[wear]` asks for, of this file's `case`; its table in `directory`.
    ///
    /// # Errors
    /// [`WearError`] for a missing section or table, numbers out of range, contradictions.
    pub fn wear(&self, case: &WheelsetCase, directory: &Path) -> Result<WearPlan, WearError> {
        let what = "wear over a distance";
        case.is_alike_along(what)?;
        if case.is_guarded() {
            return Err(WheelsetFileError::Guarded { what }.into());
        }
        let wear = self.wear.as_ref();
        let needs = "distance (of wheels) or passages (over rails), and situations";
        wear.ok_or_else(|| section("wear", needs))?.plan(case, directory)
    }

    fn running(
        &self,
        directory: &Path,
        notes: &mut Vec<ProfileNote>,
    ) -> Result<WheelsetOnTrack, WheelsetFileError> {
        let mut wheel = |side| self.wheel(side, directory, notes);
        let (left, right) = (wheel(Side::Left)?, wheel(Side::Right)?);
        let back_to_back = self.wheelset.back_to_back;
        let is_valid = (0.0..=WIDEST).contains(&back_to_back);
        checked(
            "wheelset",
            "back_to_back",
            back_to_back,
            is_valid,
            "zero, or positive, at most 10 m",
        )?;
        let wheelset = Wheelset::new(left, right, back_to_back)
            .map_err(WheelsetFileError::geometry("wheelset"))?;
        let place = self.track.place()?;
        let mut rail = |side| self.rail(side, place, directory, notes);
        let track = Track { left: rail(Side::Left)?, right: rail(Side::Right)? };
        for rail in [&track.left, &track.right] {
            let radius = rail.roller().map_or(0.0, Roller::radius);
            let is_valid = radius >= 0.0 || radius < -wheelset.radius();
            let valid =
                "for a ring around the wheel (below zero) larger in size than the wheel's radius";
            checked("rail", "roller_radius", radius, is_valid, valid)?;
        }
        let [s, pitch] = [self.wheelset.s, self.wheelset.pitch].map(|value| value.unwrap_or(0.0));
        wheelset.on(track).at(s, pitch).map_err(WheelsetFileError::geometry("wheelset"))
    }

    /// What the file says of the rail of a side.
    fn rail_section(&self, side: Side) -> RailSection {
        match side {
            Side::Left => self.rail_left.or(&self.rail),
            Side::Right => self.rail_right.or(&self.rail),
        }
    }

    /// The section that says on which springs the rail of a side lies: its own where that has any of their keys.
    fn springs_section(&self, side: Side) -> &'static str {
        let (own, section) = match side {
            Side::Left => (&self.rail_left, "rail_left"),
            Side::Right => (&self.rail_right, "rail_right"),
        };
        let of_springs = [own.stiffness_y, own.stiffness_z, own.force_y, own.force_z];
        if of_springs.iter().any(Option::is_some) { section } else { "rail" }
    }

    /// Refuses the motion of a wheel that is not solved.
    fn check_idle(&self) -> Result<(), WheelsetFileError> {
        let motion = self.motion.as_ref();
        for (side, word, key, rate) in [
            (
                Side::Left,
                "right",
                "pitch_rate_left",
                motion.and_then(|motion| motion.pitch_rate_left),
            ),
            (
                Side::Right,
                "left",
                "pitch_rate_right",
                motion.and_then(|motion| motion.pitch_rate_right),
            ),
        ] {
            if rate.is_some() && self.is_idle(side) {
                let instead = "that wheel is not solved; leave it out, or leave side out";
                return Err(WheelsetFileError::OneWheel {
                    section: "motion",
                    key,
                    side: word,
                    instead,
                });
            }
        }
        let rails = [
            (Side::Left, "right", "rail_left", &self.rail_left),
            (Side::Right, "left", "rail_right", &self.rail_right),
        ];
        for (side, word, section, rail) in rails {
            if rail.friction.is_some() && self.is_idle(side) {
                let instead = "that rail carries no wheel; leave it out, or leave side out";
                return Err(WheelsetFileError::OneWheel {
                    section,
                    key: "friction",
                    side: word,
                    instead,
                });
            }
        }
        Ok(())
    }

    /// Friction on both rails; `None` where neither has any.
    fn friction(&self) -> Result<Option<[RailFriction; 2]>, WheelsetFileError> {
        let common = self.contact.as_ref().and_then(|section| section.friction.as_ref());
        let of = |side| {
            let own = self.rail_section(side).friction;
            own.as_ref().or(common).map(RailFrictionValue::friction).transpose()
        };
        let (left, right) = (of(Side::Left)?, of(Side::Right)?);
        Ok(match (left, right) {
            (Some(left), Some(right)) => Some([left, right]),
            // Of one wheel alone the other rail is idle.
            (Some(own), None) if self.is_idle(Side::Right) => Some([own.clone(), own]),
            (None, Some(own)) if self.is_idle(Side::Left) => Some([own.clone(), own]),
            _ => None,
        })
    }

    fn wheel(
        &self,
        side: Side,
        directory: &Path,
        notes: &mut Vec<ProfileNote>,
    ) -> Result<Wheel, WheelsetFileError> {
        let (own, section, other) = match side {
            Side::Left => (&self.wheel_left, "wheel_left", &self.wheel_right),
            Side::Right => (&self.wheel_right, "wheel_right", &self.wheel_left),
        };
        let section = if *own == WheelSection::default() { "wheel" } else { section };
        let wheel = own.or(&self.wheel);
        // Of one wheel alone the other may be left out.
        let wheel = if self.is_idle(side) { wheel.or(other) } else { wheel };
        let radius = needed(section, "radius", wheel.radius)?;
        let given = (wheel.profile.as_deref(), wheel.points.as_deref(), wheel.slices.as_deref());
        let asked = (section, Role::Wheel, side, wheel.reading);
        let (profile, slices) = surface_of(given, asked, directory, notes)?;
        let geometry = WheelsetFileError::geometry(section);
        let made = Wheel::new(&profile, radius).map_err(&geometry)?;
        let flats = wheel.flat.as_ref().map(|flat| flat.flats(section, radius)).transpose()?;
        let waviness = wheel.waviness.iter().flatten().map(Waviness::from).collect();
        let variation = WheelVariation { slices, flats: flats.unwrap_or_default(), waviness };
        let made = wheel.flange_back.map_or(Ok(made.clone()), |back| made.with_flange_back(back));
        made.and_then(|made| made.with_variation(variation)).map_err(geometry)
    }

    fn rail(
        &self,
        side: Side,
        place: Place,
        directory: &Path,
        notes: &mut Vec<ProfileNote>,
    ) -> Result<Rail, WheelsetFileError> {
        let (own, section, other) = match side {
            Side::Left => (&self.rail_left, "rail_left", &self.rail_right),
            Side::Right => (&self.rail_right, "rail_right", &self.rail_left),
        };
        let section = if *own == RailSection::default() { "rail" } else { section };
        let rail = own.or(&self.rail);
        let rail = if self.is_idle(side) { rail.or(other) } else { rail };
        let given = (rail.profile.as_deref(), rail.points.as_deref(), rail.slices.as_deref());
        let asked = (section, Role::Rail, side, rail.reading);
        let (profile, slices) = surface_of(given, asked, directory, notes)?;
        let corrugation = rail.corrugation.iter().flatten().map(Corrugation::from).collect();
        let variation = RailVariation { slices, corrugation };
        let guard = rail.guard.as_ref();
        let of_guard = match (&own.guard, side) {
            (None, _) => "rail.guard",
            (Some(_), Side::Left) => "rail_left.guard",
            (Some(_), Side::Right) => "rail_right.guard",
        };
        guard.map(|guard| guard.check(of_guard)).transpose()?;
        let cant = rail.cant.unwrap_or(0.0);
        let geometry = WheelsetFileError::geometry(section);
        let laid = match guard {
            Some(guard) if guard.is_grooved() => Rail::grooved(&profile, cant, place),
            _ => Rail::new(&profile, cant, place),
        };
        let mut laid = laid.map_err(&geometry)?;
        if let Some(guard) = guard.filter(|guard| !guard.is_grooved()) {
            laid = noted(guard.beside(laid, (of_guard, side, place), directory)?, notes);
        }
        if let Some(radius) = rail.roller_radius {
            let roller = Roller::new(radius).map_err(&geometry)?;
            laid = laid.on_roller(roller).map_err(&geometry)?;
        }
        if let Some(deviation) = rail.deviation() {
            laid = laid.displaced(side, deviation).map_err(&geometry)?;
        }
        laid.with_variation(variation).map_err(geometry)
    }

    /// Friction on both guard rails, where they have their own.
    fn guard_friction(&self) -> Result<[Option<RailFriction>; 2], WheelsetFileError> {
        let of = |side| {
            let guard = self.rail_section(side).guard;
            let friction = guard.as_ref().and_then(|guard| guard.friction.as_ref());
            friction.map(RailFrictionValue::friction).transpose()
        };
        Ok([of(Side::Left)?, of(Side::Right)?])
    }

    /// Whether the other wheel is solved alone.
    fn is_idle(&self, side: Side) -> bool {
        match self.wheelset.side {
            Some(SideName::Left) => side == Side::Right,
            Some(SideName::Right) => side == Side::Left,
            None => false,
        }
    }

    /// `[materials]` for both bodies, or one section for each.
    fn solids(&self) -> Result<Option<SolidPair>, CaseError> {
        match (&self.materials, &self.upper, &self.lower) {
            (None, None, None) => Ok(None),
            (Some(both), None, None) => {
                let solid = both.solid("materials")?;
                Ok(Some(SolidPair::new(solid, solid)))
            }
            (None, Some(upper), Some(lower)) => {
                Ok(Some(SolidPair::new(upper.solid("upper")?, lower.solid("lower")?)))
            }
            (Some(_), upper, _) => {
                let other = if upper.is_some() { "upper" } else { "lower" };
                let [first, second] = ["materials", other].map(|section| (section, "poisson"));
                Err(CaseError::Conflict { first, second })
            }
            (None, upper, _) => {
                let missing = if upper.is_some() { "lower" } else { "upper" };
                let needs = "shear_modulus or young_modulus, poisson".into();
                Err(CaseError::MissingSection { section: missing.into(), needs })
            }
        }
    }
}

const SIDES: [Side; 2] = [Side::Left, Side::Right];
