//! `[gap]`: the undeformed distance of the two bodies.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use creepage::SolidPair;
use creepage::curved::CurvedGap;
use creepage::gap::{Gap, GapError, Rolling, Term};
use schemars::JsonSchema;
use serde::Deserialize;

use super::along::Roller;
use super::columns::Columns;
use super::curved::GrooveTable;
use super::error::{GapCaseError, GapFileError};
use super::roller::RollerSection;
use super::vary::GapVaried;
use crate::Sources;

/// The undeformed distance h(x, y) of the bodies in the plane of contact, in metres: exactly one
/// of `polynomial`, `section`, `grid`, `groove` and `roller`. Pressed together by an approach, undeformed bodies would
/// penetrate by the approach less h.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct GapSection {
    /// Terms [i, j, coefficient] of h = sum coefficient x^i y^j, in metres throughout.
    pub(super) polynomial: Option<Vec<(u32, u32, f64)>>,
    /// CSV file beside the case file with the columns y, gap (m); also `radius_rolling` (m) for a
    /// radius that varies, and x (m) for the place along x of the least distance.
    pub(super) section: Option<Points>,
    /// CSV file beside the case file with the columns x, y, gap (m): the points of a rectangular
    /// grid, in any order.
    pub(super) grid: Option<Points>,
    /// A round upper body in a groove of the lower one, which a contact may follow: `[contact] surface = "curved"`.
    pub(super) groove: Option<GrooveTable>,
    /// With `section`: radius R (m) along the rolling direction, h = h(y) + x^2/(2 R).
    pub(super) radius_rolling: Option<f64>,
    /// A roller by its design, its axis along y.
    #[serde(default)]
    #[schemars(with = "RollerSection")]
    pub(super) roller: Option<RollerSection>,
}

/// Points of a shape: the name of a CSV file, or its columns, each a list of numbers by its name.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(
    untagged,
    expecting = "expected the name of a file, or lists of numbers by the names of its columns"
)]
pub(crate) enum Points {
    File(String),
    Columns(BTreeMap<String, Vec<f64>>),
}

impl Points {
    /// The columns, as many values each; a file stands in `directory`.
    pub(crate) fn read(
        &self,
        directory: &Path,
        needed: &[&'static str],
        allowed: &[&'static str],
    ) -> Result<Columns, GapFileError> {
        match self {
            Self::File(file) => Columns::read(&directory.join(file), needed, allowed),
            Self::Columns(columns) => Columns::of(columns, needed, allowed),
        }
    }

    /// The key that gave them, with the file.
    pub(crate) fn shape(&self, key: &str) -> String {
        match self {
            Self::File(file) => format!("{key} = {file:?}"),
            Self::Columns(_) => key.into(),
        }
    }

    /// The file, where it is one.
    pub(crate) fn file(&self, directory: &Path) -> Option<PathBuf> {
        match self {
            Self::File(file) => Some(directory.join(file)),
            Self::Columns(_) => None,
        }
    }
}

impl GapSection {
    /// The gap, with the files that stand in `directory`; of a roller for the material of the case.
    pub(super) fn gap(&self, directory: &Path, pair: SolidPair) -> Result<Gap, GapCaseError> {
        if let Some(groove) = self.groove {
            self.no_radius("groove")?;
            if self.given().len() > 1 {
                return Err(GapCaseError::NotOneShape { given: self.given() });
            }
            let plane = groove.curved()?.plane();
            return plane.map_err(|source| GapCaseError::Gap { shape: self.shape(), source });
        }
        let gap = match (&self.polynomial, &self.section, &self.grid, &self.roller) {
            (Some(terms), None, None, None) => {
                self.no_radius("polynomial")?;
                polynomial(terms)
            }
            (None, Some(points), None, None) => self.section(directory, points)?,
            (None, None, Some(points), None) => {
                self.no_radius("grid")?;
                self.grid(directory, points)?
            }
            (None, None, None, Some(roller)) => {
                self.no_radius("roller")?;
                roller.gap(pair)?
            }
            _ => return Err(GapCaseError::NotOneShape { given: self.given() }),
        };
        gap.map_err(|source| GapCaseError::Gap { shape: self.shape(), source })
    }

    /// The curve across that a contact follows.
    pub(super) fn curved(&self) -> Result<CurvedGap, GapCaseError> {
        Ok(self.groove.ok_or(GapCaseError::NoCurve)?.curved()?)
    }

    /// The file that gives the shape, where one does.
    pub(super) fn sources(&self, directory: &Path) -> Sources {
        let points = [&self.section, &self.grid].into_iter().flatten();
        Sources::new(points.filter_map(|points| points.file(directory)))
    }

    /// The key that gives the shape, with its file.
    pub(super) fn shape(&self) -> String {
        match (&self.section, &self.grid) {
            (Some(points), _) => points.shape("section"),
            (_, Some(points)) => points.shape("grid"),
            _ if self.groove.is_some() => "groove".into(),
            _ if self.roller.is_some() => "roller".into(),
            _ => "polynomial".into(),
        }
    }

    /// Takes the shape from another file, which needs the radius along rolling if it is a section.
    pub(super) fn replace(&mut self, varied: GapVaried, file: &str) {
        let points = Some(Points::File(file.into()));
        *self = if varied == GapVaried::Grid {
            Self { grid: points, ..Self::default() }
        } else {
            Self { section: points, radius_rolling: self.radius_rolling, ..Self::default() }
        };
    }

    /// The length of a roller, where one gives the shape.
    pub(super) fn roller(&self) -> Option<Roller> {
        let roller = self.roller.as_ref()?;
        Some(Roller { length: roller.length, half_straight: roller.half_straight() })
    }

    fn given(&self) -> Vec<&'static str> {
        let given = [
            ("polynomial", self.polynomial.is_some()),
            ("section", self.section.is_some()),
            ("grid", self.grid.is_some()),
            ("groove", self.groove.is_some()),
            ("roller", self.roller.is_some()),
        ];
        given.into_iter().filter_map(|(name, is_given)| is_given.then_some(name)).collect()
    }

    fn no_radius(&self, shape: &'static str) -> Result<(), GapCaseError> {
        self.radius_rolling.map_or(Ok(()), |_| Err(GapCaseError::RadiusBeside { shape }))
    }

    fn section(
        &self,
        directory: &Path,
        points: &Points,
    ) -> Result<Result<Gap, GapError>, GapCaseError> {
        let columns = points
            .read(directory, &["y", "gap"], &["radius_rolling", "x"])
            .map_err(|source| self.unread(source))?;
        let (y, gap) = (columns.column("y"), columns.column("gap"));
        let locus = columns.column("x");
        let same: Vec<f64>;
        let radius = match (self.radius_rolling, columns.find("radius_rolling")) {
            (None, None) => return Err(GapCaseError::NoRadius { shape: self.shape() }),
            (Some(_), Some(_)) => return Err(GapCaseError::TwoRadii { shape: self.shape() }),
            (Some(radius), None) if locus.is_empty() => {
                return Ok(Gap::section(y, gap, Rolling::Radius(radius)));
            }
            (Some(radius), None) => {
                same = vec![radius; y.len()];
                &same
            }
            (None, Some(radii)) => radii,
        };
        Ok(Gap::section(y, gap, Rolling::Varying { radius, locus }))
    }

    fn grid(
        &self,
        directory: &Path,
        points: &Points,
    ) -> Result<Result<Gap, GapError>, GapCaseError> {
        let columns = points
            .read(directory, &["x", "y", "gap"], &[])
            .map_err(|source| self.unread(source))?;
        let [x, y, gap] = ["x", "y", "gap"].map(|name| columns.column(name));
        let points: Vec<_> = x.iter().zip(y).zip(gap).map(|((&x, &y), &gap)| [x, y, gap]).collect();
        Ok(Gap::grid(&points))
    }

    fn unread(&self, source: GapFileError) -> GapCaseError {
        GapCaseError::Points { shape: self.shape(), source }
    }
}

fn polynomial(terms: &[(u32, u32, f64)]) -> Result<Gap, GapError> {
    let term = |&(x, y, coefficient): &(u32, u32, f64)| Term { x, y, coefficient };
    Gap::polynomial(&terms.iter().map(term).collect::<Vec<_>>())
}
