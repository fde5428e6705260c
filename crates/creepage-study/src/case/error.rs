//! Errors of case files.

use creepage::halfspace::PolynomialError;
use creepage::variational::VariationalError;
use creepage::{HertzError, InvalidValue};

use super::solve::SpecError;

/// Error of a case file; every message names the section and the key.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CaseError {
    /// Not TOML, or a value of the wrong kind, such as text for a number.
    #[error(transparent)]
    Toml(#[from] toml::de::Error),
    /// A word without quotes.
    #[error("{key} = {word} is not valid: words are written in quotes, as {key} = \"{word}\"")]
    BareWord {
        /// The key.
        key: String,
        /// The word.
        word: String,
    },
    /// A key or section that the format does not have.
    #[error("unknown key `{key}` in {place}: {hint}")]
    UnknownKey {
        /// The key as the file has it.
        key: String,
        /// Where it stands: `[section]`, or the top level.
        place: String,
        /// A likely meaning, or the keys that the place has.
        hint: String,
    },
    /// A whole section is missing.
    #[error("section [{section}] is missing: it needs {needs}")]
    MissingSection {
        /// The section's name.
        section: String,
        /// What belongs in it.
        needs: String,
    },
    /// A key without which the section means nothing.
    #[error("[{section}] {key} is missing")]
    Missing {
        /// The section's name.
        section: String,
        /// The key.
        key: String,
    },
    /// Two keys of which one is needed, and neither is there.
    #[error("[{section}] needs {} or {}", keys[0], keys[1])]
    MissingEither {
        /// The section's name.
        section: &'static str,
        /// The two ways to say it.
        keys: [&'static str; 2],
    },
    /// Two keys that say the same, or contradict each other.
    #[error(
        "[{}] {} and [{}] {} exclude each other: give one of them",
        first.0, first.1, second.0, second.1
    )]
    Conflict {
        /// Section and key.
        first: (&'static str, &'static str),
        /// Section and key.
        second: (&'static str, &'static str),
    },
    /// The shakedown limit of a contact that is not Hertz's.
    #[error("[damage] shakedown is computed for contact ellipses only: leave it out")]
    ShakedownOfAnyShape,
    /// A weight of the area of adhesion where there is none.
    #[error("[solve] adhesion_weight goes with method = \"areas\" alone")]
    WeightOfAreas,
    /// Friction by temperature without the bodies' heat.
    #[error("[contact] friction by temperature needs [heat]: how both bodies conduct heat")]
    HeatOfFriction,
    /// Friction by temperature on a rail.
    #[error(
        "[contact] friction: cold and hot are for one contact; on a rail give a number or a law"
    )]
    TemperatureOnRail,
    /// A friction law on a line contact in steady rolling.
    #[error(
        "[contact] friction: steady rolling on a line takes one coefficient; `roll` takes laws with a memory"
    )]
    LawOnLine,
    /// A crowned body in a line contact.
    #[error(
        "[{section}] radius_lateral = {radius} is a crown, which does not touch along a line: leave it out, or give \
         [contact] normal_force in place of line_load"
    )]
    CrownOnLine {
        /// The body's section.
        section: &'static str,
        /// The radius (m).
        radius: f64,
    },
    /// Viscoelastic bodies that are not alike.
    #[error("[relaxation] is that of two bodies of one material: [upper] and [lower] differ")]
    UnlikeRelaxation,
    /// Viscoelastic cylinders out of range.
    #[error("[relaxation]: {source}")]
    Viscoelastic {
        /// Why.
        source: creepage::viscoelastic::ViscoelasticError,
    },
    /// Points that are no rigid slip.
    #[error("[contact] {points}: {why}")]
    Slip {
        /// The key, and the file if there is one.
        points: String,
        /// What is wrong with them.
        why: String,
    },
    /// A slip from place to place in many rows at once.
    #[error(
        "[contact] slip is for one case at a time: leave it out for rows of many, or solve each file"
    )]
    SlipOfRows,
    /// A number of elements for a theory of bearings that has none.
    #[error("[solve] resolution is an option of theory = \"exact\": leave it out")]
    ResolutionOfExact,
    /// A friction of its own in each row beside one that varies in the file.
    #[error(
        "[contact] friction is a law, or varies, and the rows have a friction of their own: leave out the column, or give \
         a number in the file"
    )]
    FrictionOfRows,
    /// A rigid slip from place to place where numbers follow from creepage and spin alone.
    #[error(
        "[contact] slip with [{section}]: {section} is computed by creepage and spin alone; leave out one of the two"
    )]
    SlipWith {
        /// The section.
        section: &'static str,
    },
    /// Temperatures of many rows at once.
    #[error(
        "[heat] is for one case at a time: leave it out for rows of many; rows of a case with [gap] have temperatures"
    )]
    HeatOfRows,
    /// The creepage is wanted where it must be given.
    #[error(
        "section [wanted] asks for a creepage, which `solve` finds: what needs a creepage to \
         start from takes it from [creepage] alone"
    )]
    Wanted,
    /// Creepages and wanted forces that are too few, or too many, to determine the others.
    #[error(
        "[creepage] and [wanted] give {} of six quantities ({}): exactly three are needed, those \
         that are zero included", given.len(), given.join(", ")
    )]
    NotThree {
        /// Those that are given.
        given: Vec<&'static str>,
    },
    /// A wanted force that no creepage can give.
    #[error("[wanted] {key} = {value:?} is not reachable: friction gives at most {most}")]
    BeyondFriction {
        /// The force or moment.
        key: &'static str,
        /// The value that was given.
        value: f64,
        /// The largest size that it can have, in the same unit.
        most: f64,
    },
    /// A number out of its range.
    #[error("[{section}] {invalid}")]
    Invalid {
        /// The section's name.
        section: &'static str,
        /// The key, its value, and what it must be.
        invalid: InvalidValue,
    },
    /// Friction across a contact whose place on the rail is not known beforehand.
    #[error(
        "[contact] friction: across is for one contact; on a rail give position (its profile's y) or angle, and value"
    )]
    AcrossOnRail,
    /// A law of friction by the speed of slip, without the speed of rolling.
    #[error("[creepage] speed is missing: [contact] friction depends on the speed of slip")]
    SpeedOfLaw,
    /// Falling terms given for a constant law.
    #[error("[contact] friction: law = \"constant\" has no terms")]
    TermsOfConstant,
    /// `[solve]` names no theory, or options that the theory does not have.
    #[error("[solve] {0}")]
    Spec(#[from] SpecError),
    /// The numerical theory of chapter 5 cannot be prepared.
    #[error("[{section}] {source}")]
    Variational {
        /// The section's name.
        section: &'static str,
        /// What is wrong with its numbers.
        source: VariationalError,
    },
    /// A list of numbers that makes no traction polynomials.
    #[error("[chain] starting_values: {source}")]
    StartingValues {
        /// What is wrong with the list.
        source: PolynomialError,
    },
    /// A loop without end, or with more cases than any machine would finish.
    #[error("[creepage] {key}: {cases} cases are too many: a sweep has at most {max}")]
    TooManyCases {
        /// `chi`, `alpha` or `upsilon`.
        key: &'static str,
        /// How many there would be.
        cases: f64,
        /// The most.
        max: usize,
    },
    /// Invalid radius.
    #[error("[{section}] {key} = {value} is not valid: it must be {valid}")]
    Radius {
        /// The section's name.
        section: &'static str,
        /// `radius_rolling` or `radius_lateral`.
        key: &'static str,
        /// The value that was given.
        value: f64,
        /// What it must be, in words.
        valid: &'static str,
    },
    /// The bodies' radii and the angle between them give no contact ellipse.
    #[error("[upper] {upper} and [lower] {lower}: {source}")]
    Shape {
        /// The upper body's radii, as in the file.
        upper: String,
        /// The lower body's radii, as in the file.
        lower: String,
        /// Why there is no ellipse.
        source: HertzError,
    },
    /// The ellipse stands askew to the rolling direction, which no theory of rolling here takes.
    #[error(
        "[contact] angle = {angle} degrees turns the contact ellipse by {ellipse_angle} degrees \
         from the rolling direction: theories of rolling need its axis along that direction \
         (the contact alone can be computed: `hertz`)"
    )]
    Tilted {
        /// Angle between the bodies' axes (degrees).
        angle: f64,
        /// Angle from the rolling direction to the ellipse's axis (degrees).
        ellipse_angle: f64,
    },
}

impl CaseError {
    /// Places an [`InvalidValue`] of the library in its section of the file.
    pub(crate) fn invalid(section: &'static str) -> impl Fn(InvalidValue) -> Self {
        move |invalid| Self::Invalid { section, invalid }
    }
}
