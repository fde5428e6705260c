//! A statics file: two bodies in contact without rolling, or a die on one.

mod contact;
mod error;
mod load;

use creepage::statics::{
    Bonded, Compression, Die, PartialSlip, PartialSlipError, ShearError, ShearedRectangle,
    ShiftAxis, ShiftEnd, ShiftPath,
};
use creepage::{Ellipse, Hertz, Layer, SiForce, Solid, SolidPair, Status};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

use crate::Caution;
use crate::case::body::Body;
use crate::case::error::CaseError;
use crate::case::keys;
use crate::case::layer::LayerSection;
use crate::case::schema::schema_of;
use crate::case::sections::smallest_radius;

use contact::StaticsContact;
pub use error::StaticsError;
use load::{Problem, Statics};

/// Rings of a compression: its areas are known to one of them.
const RINGS: usize = 100;

/// A contact without rolling, in SI units: the bodies, what presses them together, and the load.
///
/// `x` and `y` are along the axes of the contact ellipse, which are those of the bodies' radii;
/// `z` points into the lower body.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "creepage statics file")]
pub struct StaticsFile {
    /// The upper body. Problem "die": left out, since the die is rigid.
    upper: Option<Body>,
    /// The lower body. Problem "die": the half-space under the die.
    lower: Body,
    /// The contact of the two.
    #[serde(default)]
    contact: StaticsContact,
    /// Problem "sheared-rectangle": a layer between the bodies.
    layer: Option<LayerSection>,
    /// The problem and its load.
    statics: Statics,
}

/// A statics file, solved.
#[derive(Debug, Clone)]
pub struct StaticsCase {
    /// The problem with its solution.
    pub problem: StaticsProblem,
    /// Cautions about it.
    pub cautions: Vec<Caution>,
}

/// One problem of statics, solved; every number of it is checked.
#[derive(Debug, Clone)]
pub enum StaticsProblem {
    /// A rigid die under an offset load (3.211).
    Die {
        /// The half-space.
        solid: Solid,
        /// The base of the die (m).
        base: Ellipse,
        /// Force that presses the die down (N).
        normal_force: f64,
        /// Where it acts, `[x, y]` from the centre (m).
        offset: [f64; 2],
        /// The solution.
        die: Box<Die>,
    },
    /// A shift without slip (3.212).
    Shift {
        /// The equivalent solid of the two bodies.
        pair: SolidPair,
        /// The contact (m).
        ellipse: Ellipse,
        /// Tangential force `[F_x, F_y]` of the upper body on the lower (N).
        force: [f64; 2],
        /// The solution.
        bonded: Box<Bonded>,
    },
    /// A twist without slip (3.212).
    Twist {
        /// The equivalent solid of the two bodies.
        pair: SolidPair,
        /// The contact (m).
        ellipse: Ellipse,
        /// Moment `M_z` of the upper body on the lower (N m).
        moment: f64,
        /// The solution.
        bonded: Box<Bonded>,
    },
    /// A shift with slip at the edge (3.222).
    PartialSlip {
        /// The contact, by Hertz.
        contact: Box<Hertz>,
        /// Coefficient of friction.
        friction: f64,
        /// Tangential force `[F_x, F_y]` of the upper body on the lower (N).
        force: [f64; 2],
        /// The solution.
        partial: Box<PartialSlip>,
    },
    /// A shift to and fro, under a load that stays or changes (3.222).
    ShiftPath {
        /// The contact, by Hertz.
        contact: Box<Hertz>,
        /// Coefficient of friction.
        friction: f64,
        /// The axis along which the bodies are shifted.
        axis: ShiftAxis,
        /// The path after every step.
        steps: Vec<ShiftPath>,
    },
    /// Unlike bodies of revolution pressed together with friction (Spence).
    Compression {
        /// The contact without friction, by Hertz.
        contact: Box<Hertz>,
        /// The solution.
        compression: Box<Compression>,
    },
    /// A rectangle of uniform pressure with a layer, sheared to and fro.
    ShearedRectangle {
        /// The equivalent solid of the two bodies.
        pair: SolidPair,
        /// Normal force (N).
        normal_force: f64,
        /// Coefficient of friction.
        friction: f64,
        /// The layer.
        layer: Option<Layer>,
        /// The rectangle after every step.
        steps: Vec<ShearedRectangle>,
    },
}

/// The JSON schema (draft 2020-12) of a statics file, for editors and validators.
///
/// ```
/// let schema = creepage_study::statics_json_schema();
/// assert!(schema["properties"]["statics"]["properties"]["problem"].is_object());
/// ```
#[must_use]
pub fn statics_json_schema() -> Value {
    schema_of::<StaticsFile>()
}

impl StaticsFile {
    /// Whether a text is one: it has a section `[statics]`.
    #[must_use]
    pub fn is_one(text: &str) -> bool {
        text.parse::<toml::Table>().is_ok_and(|table| table.contains_key("statics"))
    }

    /// Reads the text of a statics file and checks its form: TOML, sections, keys and kinds of
    /// values.
    ///
    /// # Errors
    /// [`CaseError`] that says where the text is not a statics file.
    pub fn read(text: &str) -> Result<Self, CaseError> {
        keys::check(&keys::parse(text)?, &statics_json_schema())?;
        Ok(toml::from_str(text)?)
    }

    /// Solves the problem.
    ///
    /// # Errors
    /// [`StaticsError`] for numbers out of range, contradictions, a die that lifts off, and a
    /// tangential force beyond friction.
    ///
    /// ```
    /// let file = creepage_study::StaticsFile::read(
    ///     r#"
    ///     [lower]
    ///     shear_modulus = 82e9
    ///     poisson = 0.28
    ///     [contact]
    ///     normal_force = 20e3
    ///     semi_axis_rolling = 5e-3
    ///     semi_axis_lateral = 10e-3
    ///     [statics]
    ///     problem = "die"
    ///     offset_x = 2e-3
    ///     "#,
    /// )?;
    /// let error = file.solve().unwrap_err(); // beyond a third of the semi-axis
    /// assert!(error.to_string().starts_with("[statics] offset_x = 0.002, offset_y = 0"));
    /// # Ok::<(), creepage_study::CaseError>(())
    /// ```
    pub fn solve(&self) -> Result<StaticsCase, StaticsError> {
        self.statics.reject_foreign_keys()?;
        self.reject_what_is_of_rectangles()?;
        let problem = match self.statics.problem {
            Problem::Die => self.die()?,
            Problem::Shift => self.shift()?,
            Problem::Twist => self.twist()?,
            Problem::PartialSlip => self.partial_slip()?,
            Problem::ShiftPath => self.shift_path()?,
            Problem::Compression => self.compression()?,
            Problem::ShearedRectangle => self.sheared_rectangle()?,
        };
        let mut cautions = self.cautions(&problem);
        cautions.extend(self.contact.friction().ok().and_then(Caution::large_friction));
        cautions.extend(Caution::large_shift(moved(&problem)));
        Ok(StaticsCase { problem, cautions })
    }

    /// What looks like a number in another unit, and a metal that flows.
    fn cautions(&self, problem: &StaticsProblem) -> Vec<Caution> {
        let mut unlike = None;
        let (upper, hertz) = match (problem, &self.upper) {
            (StaticsProblem::Die { solid, die, .. }, _) => {
                let pressure = die.pressure([0.0; 2]);
                return Caution::moduli(pressure, solid.shear_modulus()).collect();
            }
            (StaticsProblem::ShearedRectangle { pair, steps, layer, .. }, _) => {
                let Some(last) = steps.last() else { return Vec::new() };
                let [one, other] = last.half_lengths();
                let thick = layer.and_then(|layer| Caution::thick_beside(layer, one.min(other)));
                let units = Caution::moduli(last.pressure(), pair.shear_modulus());
                return units.chain(thick).collect();
            }
            (StaticsProblem::PartialSlip { contact, friction, .. }, Some(upper)) => {
                unlike = Caution::like_bodies(contact.pair().kappa() / friction);
                (upper, **contact)
            }
            (StaticsProblem::ShiftPath { contact, friction, steps, .. }, Some(upper)) => {
                unlike = Caution::like_bodies(contact.pair().kappa() / friction);
                (upper, heaviest(contact, steps))
            }
            (StaticsProblem::Compression { contact, .. }, Some(upper)) => (upper, **contact),
            // Without a load there is no pressure, and the ellipse is given by itself.
            (_, Some(upper)) => match self.contact.hertz(upper, &self.lower) {
                Ok(hertz) => (upper, hertz),
                Err(_) => return Vec::new(),
            },
            (_, None) => return Vec::new(),
        };
        let radius = smallest_radius([upper, &self.lower]);
        let mut all = Caution::of_hertz(&hertz, radius);
        all.extend(unlike);
        let given = self.contact.friction().ok();
        all.extend(Caution::needs_friction(needed_friction(problem, &hertz), given));
        all
    }

    fn die(&self) -> Result<StaticsProblem, StaticsError> {
        if self.upper.is_some() {
            return Err(StaticsError::DieWithUpper);
        }
        let solid = self.lower.solid("lower")?;
        let base = self.contact.base(&self.lower)?;
        let normal_force = self.contact.normal_force()?;
        if self.contact.friction().is_ok_and(|friction| friction > 0.0) {
            return Err(StaticsError::DieWithFriction);
        }
        let offset = self.statics.offset();
        let die = Die::new(solid, base, normal_force, offset)
            .map_err(|source| StaticsError::die(offset, source))?;
        Ok(StaticsProblem::Die { solid, base, normal_force, offset, die: Box::new(die) })
    }

    fn shift(&self) -> Result<StaticsProblem, StaticsError> {
        let force @ [longitudinal, lateral] = self.statics.tangential_force()?;
        let (pair, ellipse) = self.touching_bodies()?;
        let load = SiForce { longitudinal, lateral, moment: 0.0 };
        let bonded = Box::new(Bonded::new(pair, ellipse, load)?);
        Ok(StaticsProblem::Shift { pair, ellipse, force, bonded })
    }

    fn twist(&self) -> Result<StaticsProblem, StaticsError> {
        let moment = self.statics.moment()?;
        let (pair, ellipse) = self.touching_bodies()?;
        let load = SiForce { moment, ..SiForce::default() };
        let bonded = Box::new(Bonded::new(pair, ellipse, load)?);
        Ok(StaticsProblem::Twist { pair, ellipse, moment, bonded })
    }

    fn touching_bodies(&self) -> Result<(SolidPair, Ellipse), CaseError> {
        let upper = self.upper()?;
        if self.contact.friction().is_ok() {
            // What it carries follows from the load.
            self.contact.normal_force()?;
        }
        let pair = SolidPair::new(upper.solid("upper")?, self.lower.solid("lower")?);
        Ok((pair, self.contact.ellipse(upper, &self.lower)?))
    }

    fn partial_slip(&self) -> Result<StaticsProblem, StaticsError> {
        let contact = self.contact.hertz(self.upper()?, &self.lower)?;
        let friction = self.contact.friction()?;
        let force = self.statics.tangential_force()?;
        let partial =
            PartialSlip::new(&contact, friction, force).map_err(StaticsError::partial_slip)?;
        let (contact, partial) = (Box::new(contact), Box::new(partial));
        Ok(StaticsProblem::PartialSlip { contact, friction, force, partial })
    }

    fn shift_path(&self) -> Result<StaticsProblem, StaticsError> {
        let contact = Box::new(self.contact.hertz(self.upper()?, &self.lower)?);
        let friction = self.contact.friction()?;
        let (axis, wanted) = self.statics.path()?;
        let mut path =
            ShiftPath::new(&contact, friction, axis).map_err(CaseError::invalid("contact"))?;
        let mut steps = Vec::with_capacity(wanted.len());
        for ((load, end), number) in wanted.into_iter().zip(1..) {
            let normal_force = load.unwrap_or(path.normal_force());
            let went = match load {
                Some(load) => path.to(load, end),
                None => path.to_end(end),
            };
            let (key, value, limit) = match end {
                ShiftEnd::Force(force) => ("force", force, friction * normal_force),
                ShiftEnd::Shift(shift) => ("shift", shift, path.sliding_shift_under(normal_force)),
            };
            went.map_err(|error| match error {
                PartialSlipError::Invalid(source) => StaticsError::Step { number, source },
                _ => StaticsError::PathSlides { number, key, value, limit },
            })?;
            steps.push(path.clone());
        }
        Ok(StaticsProblem::ShiftPath { contact, friction, axis, steps })
    }

    fn compression(&self) -> Result<StaticsProblem, StaticsError> {
        let contact = Box::new(self.contact.hertz(self.upper()?, &self.lower)?);
        let ellipse = contact.ellipse();
        let ratio = ellipse.a() / ellipse.b();
        // Radii that are alike give a circle but for rounding.
        if (ratio - 1.0).abs() > 1e-9 {
            return Err(StaticsError::NotRound { ratio });
        }
        let [curvature, _] = contact.relative_curvatures();
        let (load, friction) = (contact.normal_force(), self.contact.friction()?);
        // Undeformed, they are `curvature r^2` apart.
        let radius = 0.5 / curvature;
        let compression = Compression::under_load(contact.pair(), radius, friction, load, RINGS)
            .map_err(CaseError::invalid("contact"))?;
        if compression.status() != Status::Solved {
            return Err(StaticsError::NotSettled);
        }
        Ok(StaticsProblem::Compression { contact, compression: Box::new(compression) })
    }

    fn sheared_rectangle(&self) -> Result<StaticsProblem, StaticsError> {
        let upper = self.upper()?;
        let pair = SolidPair::new(upper.solid("upper")?, self.lower.solid("lower")?);
        let half_lengths = self.contact.rectangle(upper, &self.lower)?;
        let (normal_force, friction) = (self.contact.normal_force()?, self.contact.friction()?);
        let layer = self.layer.as_ref().map(LayerSection::layer).transpose()?;
        let (axis, wanted) = self.statics.path()?;
        let mut path =
            ShearedRectangle::new(pair, half_lengths, normal_force, friction, layer, axis)
                .map_err(|invalid| {
                    let of_layer = invalid.quantity == "slope";
                    CaseError::invalid(if of_layer { "layer" } else { "contact" })(invalid)
                })?;
        let mut steps = Vec::with_capacity(wanted.len());
        for ((load, end), number) in wanted.into_iter().zip(1..) {
            if load.is_some() {
                return Err(StaticsError::LoadOfStep { number });
            }
            let went = match end {
                ShiftEnd::Force(force) => path.to_force(force),
                ShiftEnd::Shift(shift) => path.to_shift(shift),
            };
            went.map_err(|error| match error {
                ShearError::Beyond { force, most } => {
                    StaticsError::PathBeyond { number, force, most }
                }
                other => StaticsError::Shear(other),
            })?;
            steps.push(path.clone());
        }
        Ok(StaticsProblem::ShearedRectangle { pair, normal_force, friction, layer, steps })
    }

    /// A layer, or the lengths of a rectangle, must not be dropped in silence.
    fn reject_what_is_of_rectangles(&self) -> Result<(), StaticsError> {
        let problem = self.statics.problem;
        if problem == Problem::ShearedRectangle {
            return Ok(());
        }
        let layer = self.layer.as_ref().map(|_| "section [layer]");
        match layer.or(self.contact.of_rectangle()) {
            Some(what) => Err(StaticsError::OfRectangle { what, problem: problem.name() }),
            None => Ok(()),
        }
    }

    fn upper(&self) -> Result<&Body, CaseError> {
        let needs = || "shear_modulus or young_modulus, and poisson".into();
        self.upper
            .as_ref()
            .ok_or_else(|| CaseError::MissingSection { section: "upper".into(), needs: needs() })
    }
}

/// How far a load moves the bodies, and the smaller half-width of their contact (m).
fn moved(problem: &StaticsProblem) -> [f64; 2] {
    match problem {
        StaticsProblem::Die { base, die, .. } => [die.indentation(), base.minor()],
        StaticsProblem::Shift { ellipse, bonded, .. } => {
            let [x, y] = bonded.shift();
            [x.hypot(y), ellipse.minor()]
        }
        // The ends of the longer semi-axis move farthest.
        StaticsProblem::Twist { ellipse, bonded, .. } => {
            [bonded.twist().abs() * ellipse.major(), ellipse.major()]
        }
        StaticsProblem::PartialSlip { contact, partial, .. } => {
            let [x, y] = partial.shift();
            [x.hypot(y), contact.ellipse().minor()]
        }
        StaticsProblem::ShiftPath { contact, steps, .. } => {
            let shifts = steps.iter().map(|step| step.shift().abs());
            [shifts.fold(0.0, f64::max), contact.ellipse().minor()]
        }
        StaticsProblem::Compression { contact, compression } => {
            [compression.approach(), contact.ellipse().minor()]
        }
        // A layer that yields, and a rectangle that slides, move on.
        StaticsProblem::ShearedRectangle { .. } => [0.0, f64::INFINITY],
    }
}

/// The coefficient of friction without which a load that is taken without slip makes all slide: the tangential force
/// over the normal one; a moment over the largest that friction 1 gives.
fn needed_friction(problem: &StaticsProblem, hertz: &Hertz) -> f64 {
    let normal = hertz.normal_force();
    match problem {
        StaticsProblem::Shift { force: [x, y], .. } => x.hypot(*y) / normal,
        StaticsProblem::Twist { ellipse, moment, .. } => {
            moment.abs() / (normal * ellipse.friction_arm())
        }
        _ => 0.0,
    }
}

/// The contact under the largest load of a path: Hertz's semi-axes grow with its cube root.
fn heaviest(contact: &Hertz, steps: &[ShiftPath]) -> Hertz {
    let load = steps.iter().map(ShiftPath::normal_force).fold(contact.normal_force(), f64::max);
    let size = (load / contact.normal_force()).cbrt();
    let ellipse = Ellipse::new(size * contact.ellipse().a(), size * contact.ellipse().b());
    let larger = ellipse.ok().and_then(|e| Hertz::from_ellipse(contact.pair(), e, load).ok());
    larger.unwrap_or(*contact)
}
