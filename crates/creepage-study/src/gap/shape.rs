//! `[gap]`: the undeformed distance of the two bodies.

use std::path::Path;

use creepage::gap::{Gap, GapError, Rolling, Term};
use schemars::JsonSchema;
use serde::Deserialize;

use super::columns::Columns;
use super::error::{GapCaseError, GapFileError};

/// The undeformed distance h(x, y) of the bodies in the plane of contact, in metres: exactly one
/// of `polynomial`, `section` and `grid`. Pressed together by an approach, undeformed bodies would
/// penetrate by the approach less h.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct GapSection {
    /// Terms [i, j, coefficient] of h = sum coefficient x^i y^j, in metres throughout.
    pub(super) polynomial: Option<Vec<(u32, u32, f64)>>,
    /// CSV file beside the case file with the columns y, gap (m); also `radius_rolling` (m) for a
    /// radius that varies, and x (m) for the place along x of the least distance.
    pub(super) section: Option<String>,
    /// CSV file beside the case file with the columns x, y, gap (m): the points of a rectangular
    /// grid, in any order.
    pub(super) grid: Option<String>,
    /// With `section`: radius R (m) along the rolling direction, h = h(y) + x^2/(2 R).
    pub(super) radius_rolling: Option<f64>,
}

impl GapSection {
    /// The gap, with the files that stand in `directory`.
    pub(super) fn gap(&self, directory: &Path) -> Result<Gap, GapCaseError> {
        let gap = match (&self.polynomial, &self.section, &self.grid) {
            (Some(terms), None, None) => {
                self.no_radius("polynomial")?;
                polynomial(terms)
            }
            (None, Some(file), None) => self.section(directory, file)?,
            (None, None, Some(file)) => {
                self.no_radius("grid")?;
                grid(directory, file)?
            }
            _ => return Err(GapCaseError::NotOneShape { given: self.given() }),
        };
        gap.map_err(|source| GapCaseError::Gap { shape: self.shape(), source })
    }

    /// The key that gives the shape, with its file.
    pub(super) fn shape(&self) -> String {
        match (&self.section, &self.grid) {
            (Some(file), _) => format!("section = {file:?}"),
            (_, Some(file)) => format!("grid = {file:?}"),
            _ => "polynomial".into(),
        }
    }

    fn given(&self) -> Vec<&'static str> {
        let given = [
            ("polynomial", self.polynomial.is_some()),
            ("section", self.section.is_some()),
            ("grid", self.grid.is_some()),
        ];
        given.into_iter().filter_map(|(name, is_given)| is_given.then_some(name)).collect()
    }

    fn no_radius(&self, shape: &'static str) -> Result<(), GapCaseError> {
        self.radius_rolling.map_or(Ok(()), |_| Err(GapCaseError::RadiusBeside { shape }))
    }

    fn section(&self, directory: &Path, file: &str) -> Result<Result<Gap, GapError>, GapCaseError> {
        let columns = Columns::read(&directory.join(file), &["y", "gap"], &["radius_rolling", "x"])
            .map_err(in_file("section", file))?;
        let (y, gap) = (columns.column("y"), columns.column("gap"));
        let locus = columns.column("x");
        let same: Vec<f64>;
        let radius = match (self.radius_rolling, columns.find("radius_rolling")) {
            (None, None) => return Err(GapCaseError::NoRadius { file: file.into() }),
            (Some(_), Some(_)) => return Err(GapCaseError::TwoRadii { file: file.into() }),
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
}

fn polynomial(terms: &[(u32, u32, f64)]) -> Result<Gap, GapError> {
    let term = |&(x, y, coefficient): &(u32, u32, f64)| Term { x, y, coefficient };
    Gap::polynomial(&terms.iter().map(term).collect::<Vec<_>>())
}

fn grid(directory: &Path, file: &str) -> Result<Result<Gap, GapError>, GapCaseError> {
    let columns = Columns::read(&directory.join(file), &["x", "y", "gap"], &[])
        .map_err(in_file("grid", file))?;
    let [x, y, gap] = ["x", "y", "gap"].map(|name| columns.column(name));
    let points: Vec<_> = x.iter().zip(y).zip(gap).map(|((&x, &y), &gap)| [x, y, gap]).collect();
    Ok(Gap::grid(&points))
}

fn in_file(key: &'static str, file: &str) -> impl Fn(GapFileError) -> GapCaseError {
    move |source| GapCaseError::File { key, file: file.into(), source }
}
