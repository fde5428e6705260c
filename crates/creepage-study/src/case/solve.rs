//! `[solve]`: which theory, and its options.

use creepage::rolling::{fastrip, fastsim, variational};
use schemars::JsonSchema;
use serde::de::{Deserialize, Deserializer, Error};

use crate::case::resolution::Resolution;

/// The theory that solves the case, and its options; what is left out is the theory's default.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Solve {
    /// Name of the theory, as `creepage theories` lists them.
    pub theory: Option<String>,
    /// Theory "exact": how finely the contact is cut into elements; "standard" by default.
    pub resolution: Option<Resolution>,
    /// Theory "exact" with resolution = "auto": largest error bar of the forces, in parts of mu N;
    /// 0.001 by default.
    pub accuracy: Option<f64>,
    /// Theory "variational": degree M of the traction polynomials, 0 to 12; 3 by default.
    pub degree: Option<usize>,
    /// Theory "variational": mesh cells [along, across] of the box around the ellipse;
    /// by default 10 x 10, more for degrees above 3.
    #[serde(default, deserialize_with = "two_numbers")]
    pub mesh: Option<[usize; 2]>,
    /// Theory "variational": weight of the points of the mesh; "elliptic" by default.
    pub weight: Option<Weight>,
    /// Theories "fastsim" and "fastrip": cells [along, across], in strips that are cut each over
    /// its own length; 50 x 50 by default.
    #[serde(default, deserialize_with = "two_numbers")]
    pub grid: Option<[usize; 2]>,
    /// Theory "fastsim": how its three flexibilities are used; "blended" by default.
    pub flexibility: Option<Flexibility>,
    /// Theory "fastsim": bound of the traction, "elliptic" by default, or "parabolic". Theory
    /// "variational": what is done about tractions above their bound, "automatic" by default,
    /// "unchecked", or "kept".
    pub bound: Option<Bound>,
    /// Theory "fastrip": as published, or mended; "consistent" by default.
    pub variant: Option<Variant>,
    /// Theory "polach": factors [adhesion, slip] that reduce the slope at small creepage on a rail
    /// that is not clean and dry, 0 < slip <= adhesion <= 1; [1, 1] by default.
    #[serde(default, deserialize_with = "two_numbers")]
    pub reduction: Option<[f64; 2]>,
}

impl Solve {
    /// Names of the options that are given; `theory` is none.
    pub fn options(&self) -> impl Iterator<Item = &'static str> {
        // Taken apart, so that an option cannot be forgotten here.
        let Self {
            theory: _,
            resolution,
            accuracy,
            degree,
            mesh,
            weight,
            grid,
            flexibility,
            bound,
            variant,
            reduction,
        } = self;
        [
            ("resolution", resolution.is_some()),
            ("accuracy", accuracy.is_some()),
            ("degree", degree.is_some()),
            ("mesh", mesh.is_some()),
            ("weight", weight.is_some()),
            ("grid", grid.is_some()),
            ("flexibility", flexibility.is_some()),
            ("bound", bound.is_some()),
            ("variant", variant.is_some()),
            ("reduction", reduction.is_some()),
        ]
        .into_iter()
        .filter_map(|(name, given)| given.then_some(name))
    }
}

/// Weight W of the points in the integral (5.8).
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Weight {
    /// `1 - (x/a)^2 - (y/b)^2`: the middle of the contact counts more than its edge.
    Elliptic,
    /// 1: every point counts alike.
    Uniform,
    /// The square root of the elliptic weight.
    #[serde(rename = "root-elliptic")]
    RootElliptic,
}

impl From<Weight> for variational::Weight {
    fn from(weight: Weight) -> Self {
        match weight {
            Weight::Elliptic => Self::Elliptic,
            Weight::Uniform => Self::Uniform,
            Weight::RootElliptic => Self::RootElliptic,
        }
    }
}

/// How FASTSIM uses its three flexibilities.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Flexibility {
    /// Their mean, weighted with creepages and spin (1982).
    One,
    /// Each for its own creepage or spin (1982).
    Three,
    /// From three at small creepage to one at large creepage (2023).
    Blended,
}

impl From<Flexibility> for fastsim::Flexibility {
    fn from(flexibility: Flexibility) -> Self {
        match flexibility {
            Flexibility::One => Self::One,
            Flexibility::Three => Self::Three,
            Flexibility::Blended => Self::Blended,
        }
    }
}

/// The bound of the traction; each theory takes its own words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Bound {
    /// FASTSIM: friction times the Hertz pressure.
    Elliptic,
    /// FASTSIM: a paraboloid of the same total (1982).
    Parabolic,
    /// Chapter 5: kept where a/b is 3 or more.
    Automatic,
    /// Chapter 5: verified afterwards only (1967).
    Unchecked,
    /// Chapter 5: kept, by the least loss of power in place of the integral (5.9).
    Kept,
}

impl Bound {
    /// As case files have it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Elliptic => "elliptic",
            Self::Parabolic => "parabolic",
            Self::Automatic => "automatic",
            Self::Unchecked => "unchecked",
            Self::Kept => "kept",
        }
    }

    /// That of FASTSIM, if it is one.
    #[must_use]
    pub fn of_fastsim(self) -> Option<fastsim::TractionBound> {
        match self {
            Self::Elliptic => Some(fastsim::TractionBound::Elliptic),
            Self::Parabolic => Some(fastsim::TractionBound::Parabolic),
            Self::Automatic | Self::Unchecked | Self::Kept => None,
        }
    }

    /// That of chapter 5, if it is one.
    #[must_use]
    pub fn of_variational(self) -> Option<variational::TractionBound> {
        match self {
            Self::Elliptic | Self::Parabolic => None,
            Self::Automatic => Some(variational::TractionBound::Automatic),
            Self::Unchecked => Some(variational::TractionBound::Unchecked),
            Self::Kept => Some(variational::TractionBound::Kept),
        }
    }
}

/// Which `FaStrip`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Variant {
    /// As published in 2016.
    Original,
    /// Blended flexibilities and elliptic bound; strips beyond the bound in spin slide.
    Modified,
    /// As "modified", with no slip left in the adhesion area.
    Consistent,
}

impl From<Variant> for fastrip::Variant {
    fn from(variant: Variant) -> Self {
        match variant {
            Variant::Original => Self::Original,
            Variant::Modified => Self::Modified,
            Variant::Consistent => Self::Consistent,
        }
    }
}

/// An array of just two: the TOML reader by itself would drop a third number silently.
pub(crate) fn two_numbers<'de, D, T>(deserializer: D) -> Result<Option<[T; 2]>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    let numbers = Vec::<T>::deserialize(deserializer)?;
    let count = numbers.len();
    let pair = numbers.try_into().map_err(|_| D::Error::invalid_length(count, &"two numbers"))?;
    Ok(Some(pair))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json_schema;

    #[test]
    fn every_option_of_the_format_is_counted() {
        let all: Solve = toml::from_str(
            "theory = 'fastsim'\nresolution = 'fine'\naccuracy = 1\ndegree = 3\nmesh = [1, 2]\nweight = 'uniform'\ngrid = [3, 4]\n\
             flexibility = 'three'\nbound = 'parabolic'\nvariant = 'original'\nreduction = [1, 0.5]",
        )
        .unwrap();
        let mut counted: Vec<_> = all.options().collect();
        counted.push("theory");
        counted.sort_unstable();
        let schema = json_schema();
        let known = schema["properties"]["solve"]["properties"].as_object().unwrap();
        let mut known: Vec<_> = known.keys().collect();
        known.sort_unstable();
        assert_eq!(counted, known);
        assert_eq!(Solve::default().options().count(), 0);
    }

    #[test]
    fn the_words_of_bounds_read_as_what_they_name() {
        for bound in
            [Bound::Elliptic, Bound::Parabolic, Bound::Automatic, Bound::Unchecked, Bound::Kept]
        {
            let solve = Solve::read(&[format!("bound={}", bound.word())]).unwrap();
            assert_eq!(solve.bound, Some(bound));
            // Of one theory each.
            assert!(bound.of_fastsim().is_some() != bound.of_variational().is_some());
        }
    }
}
