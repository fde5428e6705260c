//! Specification of a theory with its options: one for case files, command, Python and C.

use std::fmt;

use super::Theory;
use super::facts::{self, TheoryFacts};
use crate::approximate::fastrip::{self, Fastrip};
use crate::approximate::fastsim::{self, Fastsim};
use crate::approximate::linear::Linear;
use crate::approximate::non_hertzian::{NonHertzianSimplified, Simplified};
use crate::approximate::polach::Polach;
use crate::approximate::saturated::Saturated;
use crate::approximate::shen_hedrick_elkins::ShenHedrickElkins;
use crate::approximate::strip::StripTheory;
use crate::approximate::vermeulen_johnson::VermeulenJohnson;
use crate::check::InvalidValue;
use crate::contact::Contact;
use crate::coulomb::{
    Automatic, Coupled, Exact, NonHertzian, NonHertzianAutomatic, Prescribed, Resolution,
};
use crate::variational::{self, Settings, Variational, VariationalError};

/// A theory and its options. With the feature `serde` it is read and written as a table whose key
/// `theory` names the theory and whose other keys are that theory's options.
///
/// ```
/// use creepage::{Contact, Creepage, Ellipse, TheorySpec};
/// let contact = Contact::new(Ellipse::from_ratio(1.5)?, 0.28)?;
/// let fastsim = TheorySpec::named("fastsim")?.prepare(&contact)?;
/// let solution = fastsim.solve(Creepage::new(0.5, 0.0, 0.3)?);
/// assert!(solution.force.fx > 0.4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(tag = "theory", rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum TheorySpec {
    /// The full theory: Coulomb's law on elements.
    Exact(ExactOptions),
    /// Chapter 5 of the thesis: polynomial tractions.
    Variational(VariationalOptions),
    /// `FaStrip`: strip theory in adhesion, FASTSIM in slip.
    Fastrip(FastripOptions),
    /// FASTSIM: a bed of springs.
    Fastsim(fastsim::Settings),
    /// Strip theory: plane strips.
    Strip(NoOptions),
    /// Polach's law.
    Polach(PolachOptions),
    /// The law of Shen, Hedrick and Elkins.
    ShenHedrickElkins(NoOptions),
    /// The theory of Vermeulen and Johnson.
    VermeulenJohnson(NoOptions),
    /// Linear theory: no slip.
    Linear(NoOptions),
    /// Slip everywhere.
    Saturated(NoOptions),
}

/// A theory without options.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct NoOptions {}

/// Options of `exact`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ExactOptions {
    /// How finely the contact is cut into elements; "standard" by default.
    pub resolution: ResolutionSpec,
    /// With resolution = "auto": largest error bar of the forces, in parts of mu N; 0.001 by
    /// default.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub accuracy: Option<f64>,
    /// Between unlike bodies, whether tractions act back on pressure and contact area; false by
    /// default.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "std::ops::Not::not"))]
    pub coupled: bool,
    /// With coupled = true: what stays as it is without friction, "load" (the default) or "approach".
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Prescribed::is_load"))]
    pub prescribed: Prescribed,
}

/// Elements of `exact`: a word, or the numbers of elements along and across.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        untagged,
        expecting = "expected \"fast\", \"standard\", \"fine\", \"auto\", or two numbers of elements"
    )
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum ResolutionSpec {
    /// One of four words.
    Named(NamedResolution),
    /// So many elements along and across a circle, 4 to 200 (10000 in all); on an ellipse they
    /// become more nearly square.
    Elements([usize; 2]),
}

/// Elements of `exact` by a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum NamedResolution {
    /// 14 x 12 elements: forces to 0.3 % of mu N.
    Fast,
    /// 22 x 18 elements: forces to 0.1 %.
    Standard,
    /// 40 x 32 elements: forces to a few hundredths of a per cent.
    Fine,
    /// The first of these three whose error bars are within the accuracy.
    Auto,
}

impl Default for ResolutionSpec {
    fn default() -> Self {
        Self::Named(NamedResolution::Standard)
    }
}

/// Options of `variational`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct VariationalOptions {
    /// Degree M of the traction polynomials, 0 to 12; 3 by default.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub degree: Option<usize>,
    /// Mesh cells [along, across] of the box around the ellipse; by default 10 x 10, more for degrees
    /// above 3.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub mesh: Option<[usize; 2]>,
    /// Weight of the points of the mesh; "elliptic" by default.
    pub weight: variational::Weight,
    /// What is done about tractions above their bound; "automatic" by default.
    pub bound: variational::TractionBound,
}

impl VariationalOptions {
    /// The settings of the theory; what is not given follows from the degree.
    #[must_use]
    pub fn settings(&self) -> Settings {
        let usual = self.degree.map_or(Settings::default(), Settings::of_degree);
        let mesh = self.mesh.unwrap_or(usual.mesh);
        Settings { mesh, weight: self.weight, bound: self.bound, ..usual }
    }
}

/// Options of `fastrip`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FastripOptions {
    /// Cells [along, across], in strips that are cut each over its own length; 50 x 50 by default.
    pub grid: [usize; 2],
    /// As published, or mended; "consistent" by default.
    pub variant: fastrip::Variant,
}

impl Default for FastripOptions {
    fn default() -> Self {
        Self { grid: fastsim::Settings::default().grid, variant: fastrip::Variant::default() }
    }
}

/// Options of `polach`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PolachOptions {
    /// Factors [adhesion, slip] that reduce the slope at small creepage on a rail that is not clean
    /// and dry, 0 < slip <= adhesion <= 1; [1, 1] by default.
    pub reduction: [f64; 2],
}

impl Default for PolachOptions {
    fn default() -> Self {
        Self { reduction: [1.0; 2] }
    }
}

impl Default for TheorySpec {
    /// `exact` at its standard resolution.
    fn default() -> Self {
        Self::Exact(ExactOptions::default())
    }
}

impl TheorySpec {
    /// Every theory with its default options, in the order of a reader's interest: the general ones
    /// first.
    #[must_use]
    pub fn all() -> [Self; 10] {
        [
            Self::Exact(ExactOptions::default()),
            Self::Variational(VariationalOptions::default()),
            Self::Fastrip(FastripOptions::default()),
            Self::Fastsim(fastsim::Settings::default()),
            Self::Strip(NoOptions {}),
            Self::Polach(PolachOptions::default()),
            Self::ShenHedrickElkins(NoOptions {}),
            Self::VermeulenJohnson(NoOptions {}),
            Self::Linear(NoOptions {}),
            Self::Saturated(NoOptions {}),
        ]
    }

    /// The theory of that name with its default options.
    ///
    /// # Errors
    /// [`UnknownTheory`], with the nearest name if one is near.
    pub fn named(name: &str) -> Result<Self, UnknownTheory> {
        let mut all = Self::all().into_iter();
        all.find(|theory| theory.facts().name == name).ok_or_else(|| UnknownTheory::new(name))
    }

    /// What a user should know of the theory.
    #[must_use]
    pub fn facts(&self) -> &'static TheoryFacts {
        match self {
            Self::Exact(_) => &facts::EXACT,
            Self::Variational(_) => &facts::VARIATIONAL,
            Self::Fastrip(_) => &facts::FASTRIP,
            Self::Fastsim(_) => &facts::FASTSIM,
            Self::Strip(_) => &facts::STRIP,
            Self::Polach(_) => &facts::POLACH,
            Self::ShenHedrickElkins(_) => &facts::SHEN_HEDRICK_ELKINS,
            Self::VermeulenJohnson(_) => &facts::VERMEULEN_JOHNSON,
            Self::Linear(_) => &facts::LINEAR,
            Self::Saturated(_) => &facts::SATURATED,
        }
    }

    /// The largest error bar of the force that is asked for, in parts of `mu N`, where the resolution
    /// depends on it.
    #[must_use]
    pub fn prescribed_accuracy(&self) -> Option<f64> {
        let Self::Exact(ExactOptions { resolution, accuracy, .. }) = self else { return None };
        let automatic = *resolution == ResolutionSpec::Named(NamedResolution::Auto);
        automatic.then(|| accuracy.unwrap_or(Automatic::DEFAULT_ACCURACY))
    }

    /// The theory, prepared for a contact.
    ///
    /// # Errors
    /// [`TheoryError`] for contacts and options out of the theory's range.
    pub fn prepare(&self, contact: &Contact) -> Result<Box<dyn Theory>, TheoryError> {
        if contact.areas().is_some() {
            return self.prepare_on_areas(contact);
        }
        self.prepare_on_ellipse(contact)
    }

    /// The theory, prepared for Hertz's ellipse: as [`TheorySpec::prepare`] without what areas of any shape
    /// need, for a program that has none and must be small.
    ///
    /// # Errors
    /// [`TheoryError`] as of [`TheorySpec::prepare`], and for areas of any shape.
    pub fn prepare_on_ellipse(&self, contact: &Contact) -> Result<Box<dyn Theory>, TheoryError> {
        contact.hertz_ellipse()?;
        self.check_slip(contact)?;
        Ok(match self {
            Self::Exact(options) => return options.prepare(contact),
            Self::Variational(options) => Box::new(Variational::new(contact, options.settings())?),
            Self::Fastrip(FastripOptions { grid, variant }) => {
                Box::new(Fastrip::new(contact, *variant, *grid)?)
            }
            Self::Fastsim(settings) => Box::new(Fastsim::new(contact, *settings)?),
            Self::Strip(_) => Box::new(StripTheory::new(contact)),
            Self::Polach(PolachOptions { reduction: [adhesion, slip] }) => {
                let valid = "two factors [adhesion, slip] with 0 < slip <= adhesion <= 1";
                let named = |invalid| InvalidValue { quantity: "reduction", valid, ..invalid };
                Box::new(Polach::new(contact)?.with_reduction(*adhesion, *slip).map_err(named)?)
            }
            Self::ShenHedrickElkins(_) => Box::new(ShenHedrickElkins::new(contact)?),
            Self::VermeulenJohnson(_) => Box::new(VermeulenJohnson::new(contact)?),
            Self::Linear(_) => Box::new(Linear::new(contact)?),
            Self::Saturated(_) => Box::new(Saturated::new(contact)?),
        })
    }

    /// Names of the theories that take areas of any shape.
    pub const OF_AREAS: [&'static str; 5] = ["exact", "fastsim", "fastrip", "linear", "saturated"];

    /// Whether the theory takes areas of any shape, and its options have a meaning there.
    ///
    /// # Errors
    /// [`TheoryError::NeedsEllipse`] and [`TheoryError::OptionOfEllipse`].
    pub fn check_on_areas(&self) -> Result<(), TheoryError> {
        let name = self.facts().name;
        let usual = fastsim::Settings::default();
        let (key, why) = match self {
            Self::Exact(ExactOptions { coupled: true, .. }) => {
                ("coupled", "their bodies are taken for like ones")
            }
            Self::Exact(ExactOptions { prescribed: Prescribed::Approach, .. }) => {
                return Err(TheoryError::PrescribedOneWay);
            }
            Self::Fastsim(settings) if settings.flexibility != usual.flexibility => {
                ("flexibility", "areas of any shape have blended ones")
            }
            Self::Fastsim(settings) if settings.bound != usual.bound => {
                ("bound", "the bound is mu times the true pressure")
            }
            Self::Fastsim(settings) if !settings.is_clean() => {
                ("reduction", "areas of any shape have the springs of clean and dry surfaces")
            }
            Self::Fastrip(options) if options.variant != fastrip::Variant::default() => {
                ("variant", "areas of any shape have the consistent one")
            }
            Self::Exact(_)
            | Self::Fastsim(_)
            | Self::Fastrip(_)
            | Self::Linear(_)
            | Self::Saturated(_) => return Ok(()),
            _ => return Err(TheoryError::NeedsEllipse { name, why: self.why_an_ellipse() }),
        };
        Err(TheoryError::OptionOfEllipse { name, key, why })
    }

    fn why_an_ellipse(&self) -> &'static str {
        match self {
            Self::Variational(_) => "its polynomials are those of an ellipse",
            Self::Strip(_) => "it solves all strips of an ellipse in closed form; fastrip has them",
            _ => "it is a formula for the forces on an ellipse",
        }
    }

    /// Whether the theory follows a slip from place to place, where the contact has one.
    fn check_slip(&self, contact: &Contact) -> Result<(), TheoryError> {
        match self {
            Self::Exact(options) if !options.is_coupled(contact)? => Ok(()),
            _ => Ok(contact.require_no_added_slip()?),
        }
    }

    fn prepare_on_areas(&self, contact: &Contact) -> Result<Box<dyn Theory>, TheoryError> {
        self.check_on_areas()?;
        self.check_slip(contact)?;
        let usual = fastsim::Settings::default().grid;
        let simplified = |kind, grid| -> Result<Box<dyn Theory>, TheoryError> {
            Ok(Box::new(NonHertzianSimplified::on(contact, kind, grid)?))
        };
        match self {
            Self::Exact(options) => options.prepare_on_areas(contact),
            Self::Fastsim(settings) => simplified(Simplified::Fastsim, settings.grid),
            Self::Fastrip(options) => simplified(Simplified::Fastrip, options.grid),
            Self::Linear(_) => simplified(Simplified::Linear, usual),
            Self::Saturated(_) => simplified(Simplified::Saturated, usual),
            _ => {
                let (name, why) = (self.facts().name, self.why_an_ellipse());
                Err(TheoryError::NeedsEllipse { name, why })
            }
        }
    }
}

impl ExactOptions {
    /// The resolution; `None` where the accuracy decides.
    ///
    /// # Errors
    /// [`TheoryError`] for numbers of elements out of range, and for an accuracy besides them.
    pub fn fixed_resolution(&self) -> Result<Option<Resolution>, TheoryError> {
        Ok(Some(match self.resolution {
            ResolutionSpec::Named(NamedResolution::Auto) => return Ok(None),
            _ if self.accuracy.is_some() => return Err(TheoryError::AccuracyOfFixed),
            ResolutionSpec::Named(NamedResolution::Fast) => Resolution::FAST,
            ResolutionSpec::Named(NamedResolution::Standard) => Resolution::STANDARD,
            ResolutionSpec::Named(NamedResolution::Fine) => Resolution::FINE,
            ResolutionSpec::Elements([along, across]) => Resolution::new(along, across)
                .map_err(|invalid| InvalidValue { quantity: "resolution", ..invalid })?,
        }))
    }

    /// Whether a contact is solved coupled: one of unlike bodies, where that is asked for.
    ///
    /// # Errors
    /// [`TheoryError::CoupledWithoutFriction`] where only `kappa/mu` is known of it.
    pub fn is_coupled(&self, contact: &Contact) -> Result<bool, TheoryError> {
        let coupled = self.coupled && contact.kappa_over_mu() != 0.0;
        if coupled && contact.friction().is_none() {
            return Err(TheoryError::CoupledWithoutFriction);
        }
        Ok(coupled)
    }

    fn prepare(self, contact: &Contact) -> Result<Box<dyn Theory>, TheoryError> {
        if self.is_coupled(contact)? {
            return self.prepare_coupled(contact);
        }
        if !self.coupled && self.prescribed != Prescribed::Load {
            return Err(TheoryError::PrescribedOneWay);
        }
        if let Some(resolution) = self.fixed_resolution()? {
            return Ok(Box::new(Exact::new(contact, resolution)?));
        }
        let accuracy = self.accuracy.unwrap_or(Automatic::DEFAULT_ACCURACY);
        Ok(Box::new(Automatic::new(contact, accuracy)?))
    }

    fn prepare_on_areas(self, contact: &Contact) -> Result<Box<dyn Theory>, TheoryError> {
        if let Some(resolution) = self.fixed_resolution()? {
            return Ok(Box::new(NonHertzian::on(contact, resolution)?));
        }
        let accuracy = self.accuracy.unwrap_or(Automatic::DEFAULT_ACCURACY);
        Ok(Box::new(NonHertzianAutomatic::on(contact, accuracy)?))
    }

    fn prepare_coupled(self, contact: &Contact) -> Result<Box<dyn Theory>, TheoryError> {
        if let Some(resolution) = self.fixed_resolution()? {
            return Ok(Box::new(Coupled::new(contact, resolution, self.prescribed)?));
        }
        let accuracy = self.accuracy.unwrap_or(Automatic::DEFAULT_ACCURACY);
        Ok(Box::new(Coupled::automatic(contact, accuracy, self.prescribed)?))
    }
}

/// Error of a theory that cannot be prepared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TheoryError {
    /// Degree or mesh of the numerical theory of chapter 5.
    #[error(transparent)]
    Variational(#[from] VariationalError),
    /// A number out of range: of the contact, or an option.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// An accuracy is prescribed, but the resolution is fixed.
    #[error("`accuracy` needs resolution = \"auto\"")]
    AccuracyOfFixed,
    /// The approach is prescribed, but one-way the pressure is that of Hertz.
    #[error("`prescribed` needs coupled = true")]
    PrescribedOneWay,
    /// Both ways is asked for, but what acts back depends on the coefficient of friction itself.
    #[error("`coupled` needs a case with bodies and friction: kappa/mu alone does not give both")]
    CoupledWithoutFriction,
    /// A theory that is tied to Hertz's ellipse, for areas of any shape.
    #[error(
        "theory = {name:?} needs an ellipse, for {why}: {} take areas of any shape",
        TheorySpec::OF_AREAS.join(", ")
    )]
    NeedsEllipse {
        /// Its name.
        name: &'static str,
        /// Why.
        why: &'static str,
    },
    /// An option that has no meaning on areas of any shape.
    #[error("{key} of {name} has no meaning on areas of any shape: {why}")]
    OptionOfEllipse {
        /// The theory's name.
        name: &'static str,
        /// The option.
        key: &'static str,
        /// Why.
        why: &'static str,
    },
}

/// Error of a name that no theory has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownTheory {
    /// The name.
    pub name: String,
    /// The theory that may be meant.
    pub nearest: Option<&'static str>,
}

impl UnknownTheory {
    fn new(name: &str) -> Self {
        // Slips of the keys lie above this, other words below.
        const ALIKE: f64 = 0.8;
        let names = TheorySpec::all().map(|theory| theory.facts().name);
        let likeness = |other: &&str| strsim::jaro_winkler(name, other);
        let nearest = names.into_iter().max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
        Self { name: name.into(), nearest: nearest.filter(|other| likeness(other) > ALIKE) }
    }
}

impl std::error::Error for UnknownTheory {}

impl fmt::Display for UnknownTheory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown theory `{}`: ", self.name)?;
        if let Some(nearest) = self.nearest {
            return write!(f, "did you mean `{nearest}`?");
        }
        let names = TheorySpec::all().map(|theory| theory.facts().name);
        write!(f, "known are {}", names.join(", "))
    }
}
