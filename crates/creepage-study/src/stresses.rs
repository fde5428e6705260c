//! Stresses inside the bodies of a solved case.

use std::fmt::{self, Write as _};
use std::path::{Path, PathBuf};

use creepage::InvalidValue;
use creepage::Solid;
use creepage::subsurface::{
    Body, Inside, Interior, InteriorError, Largest, RollingError, Stress, largest,
};
use creepage_plot::format::{quantity, significant};
use rayon::prelude::*;
use serde_json::{Value, json};

use crate::SolvedCase;
use crate::error::ReportError;
use crate::file_set::write_all;
use crate::sources::Sources;
use crate::text::{Lines, aligned, status_words};

/// From this depth on, over the smaller semi-axis, the stresses below elements have settled: half of
/// an element of the coarsest resolution.
const SETTLED: f64 = 0.05;
/// Steps of the section along and down.
pub(crate) const SECTION_STEPS: [u32; 2] = [80, 40];
/// Where the largest stress is sought, over the semi-axes, and down over the smaller of them.
const SOUGHT: f64 = 1.5;
const HEADER: [&str; 17] = [
    "x",
    "y",
    "z",
    "sxx",
    "syy",
    "szz",
    "sxy",
    "syz",
    "sxz",
    "von_mises",
    "tresca",
    "s1",
    "s2",
    "s3",
    "u",
    "v",
    "w",
];

/// A place in a body and the stress there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StressPoint {
    /// `[x, y, z]` (m), `z` into the body.
    pub point: [f64; 3],
    /// Its stress (Pa), positive in tension.
    pub stress: Stress,
    /// Its displacement `[u, v, w]` (m), `w` into the body; it vanishes far away.
    pub displacement: [f64; 3],
}

/// Error of stresses that cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StressError {
    /// The tractions in closed form.
    #[error(transparent)]
    Interior(#[from] InteriorError),
    /// The tractions on elements.
    #[error(transparent)]
    Rolling(#[from] RollingError),
    /// A point.
    #[error(transparent)]
    Point(#[from] InvalidValue),
    /// The stress at a point is beyond the range of numbers.
    #[error("row {row}: the stress or displacement at ({:e}, {:e}, {:e}) m is no finite number", point[0], point[1], point[2])]
    NotFinite {
        /// Its number, from one.
        row: usize,
        /// The point (m).
        point: [f64; 3],
    },
}

/// Error of stresses that were not written.
#[derive(Debug, thiserror::Error)]
pub enum StressFileError {
    /// There are none.
    #[error(transparent)]
    Stress(#[from] StressError),
    /// The files.
    #[error(transparent)]
    Report(#[from] ReportError),
}

/// The stresses in one body of a solved case.
pub struct Stresses {
    /// The case.
    pub solved: SolvedCase,
    interior: Interior,
    settled: f64,
}

impl Stresses {
    /// In the body of this material. Full sliding without spin is in closed form (theory
    /// `saturated`), any other theory's tangential traction on elements ([`Interior::rolling`]).
    ///
    /// # Errors
    /// [`StressError`] for tractions that are not finite.
    pub fn new(solved: SolvedCase, solid: Solid, body: Body) -> Result<Self, StressError> {
        let (interior, settled) = Self::interior(&solved, solid, body)?;
        Ok(Self { solved, interior, settled })
    }

    /// The field inside a body of a solved case, and the depth from which on it has settled (m).
    ///
    /// # Errors
    /// As [`Stresses::new`].
    pub fn interior(
        solved: &SolvedCase,
        solid: Solid,
        body: Body,
    ) -> Result<(Interior, f64), StressError> {
        let [_, half] = solved.box_around();
        let (case, creepage) = (&solved.case, solved.creepage());
        let is_closed = solved.theory.name == "saturated" && creepage.chi() == 0.0;
        let settled = SETTLED * half[0].min(half[1]);
        let Some(hertz) = case.hertz() else {
            let interior =
                Interior::rolling_on_areas(&solved.contact, solved.solved(), solid, body)?;
            return Ok((interior, settled));
        };
        Ok(if is_closed {
            let size = creepage.xi().hypot(creepage.eta()).max(f64::MIN_POSITIVE);
            let friction =
                [creepage.xi(), creepage.eta()].map(|part| case.friction() * (part / size));
            (Interior::sliding(hertz, friction, solid, body)?, 0.0)
        } else {
            let (contact, rolled) = (&solved.contact, solved.solved());
            (Interior::rolling(hertz, contact, rolled, solid, body)?, settled)
        })
    }

    /// From this depth on (m) the stresses have settled: above, those below elements grow
    /// logarithmically towards the sides of elements. Zero in closed form.
    #[must_use]
    pub fn settled_depth(&self) -> f64 {
        self.settled
    }

    /// The stresses at points, in their order.
    ///
    /// # Errors
    /// [`StressError`] unless the points are finite and in the body, and so are the stresses.
    pub fn at(&self, points: &[[f64; 3]]) -> Result<Vec<StressPoint>, StressError> {
        let at = |(index, point): (usize, &[f64; 3])| {
            let Inside { stress, displacement } = self.interior.at(*point)?;
            if !(stress.von_mises().is_finite() && stress.trace().is_finite()) {
                return Err(StressError::NotFinite { row: index + 1, point: *point });
            }
            if !displacement.iter().all(|part| part.is_finite()) {
                return Err(StressError::NotFinite { row: index + 1, point: *point });
            }
            Ok(StressPoint { point: *point, stress, displacement })
        };
        points.par_iter().enumerate().map(at).collect()
    }

    /// The section through the contact's middle, `y = 0` of an ellipse, from `-2a` to `2a` and down to `2a`
    /// with `a` half its length, row by row downwards from the depth
    /// where the stresses have settled.
    ///
    /// # Errors
    /// As [`Stresses::at`]; none.
    pub fn section(&self) -> Result<Vec<StressPoint>, StressError> {
        let [[x, y], [a, _]] = self.solved.box_around();
        let at = |k: u32, steps: u32| f64::from(k) / f64::from(steps);
        let [along, down] = SECTION_STEPS;
        let row = |j: u32| {
            let z = (2.0 * a * at(j, down)).max(self.settled);
            (0..=along).map(move |i| [x + a * (4.0 * at(i, along) - 2.0), y, z])
        };
        self.at(&(0..=down).flat_map(row).collect::<Vec<_>>())
    }

    /// The largest equivalent stress by von Mises in the body, and where.
    ///
    /// # Errors
    /// As [`Stresses::at`]; none.
    pub fn largest(&self) -> Result<Largest, StressError> {
        let [[at_x, at_y], half] = self.solved.box_around();
        let [x, y] = half.map(|length| SOUGHT * length);
        let block = [[at_x - x, at_y - y, self.settled], [at_x + x, at_y + y, x.min(y)]];
        Ok(largest(&self.interior, block, Stress::von_mises)?)
    }

    /// The body as case files name it.
    pub(crate) fn body(&self) -> &'static str {
        match self.interior.body() {
            Body::Lower => "lower",
            Body::Upper => "upper",
        }
    }

    /// A short report on the largest equivalent stress.
    #[must_use]
    pub fn text(&self, largest: &Largest) -> String {
        let (theory, status) = (self.solved.theory.name, self.solved.solution().status);
        let mut lines = Lines::default();
        lines.line(&format!("Theory {theory}: {}", status_words(status)));
        self.cautions(&[]).iter().for_each(|words| lines.caution(words));
        let mut text = lines.into_text();
        let peak = self.solved.peak_pressure().value;
        let [x, y, z] = largest.point.map(|length| quantity(length, "m", 5));
        let [first, second, third] =
            largest.stress.principal().map(|value| quantity(value, "Pa", 5));
        let rows = [
            ("von Mises", quantity(largest.value, "Pa", 5)),
            ("over the peak pressure", significant(largest.value / peak, 5)),
            ("at x", x),
            ("at y", y),
            ("at depth z", z),
            ("Tresca", quantity(largest.stress.tresca(), "Pa", 5)),
            ("first principal stress", first),
            ("second", second),
            ("third", third),
        ];
        // Writing to a String cannot fail.
        let _ = writeln!(text, "\nLargest equivalent stress in the {} body", self.body());
        for (name, value) in rows {
            let line = format!("  {name:<26}{}", aligned(&value));
            let _ = writeln!(text, "{}", line.trim_end());
        }
        if self.settled > 0.0 {
            let depth = quantity(self.settled, "m", 3);
            let _ = writeln!(text, "\nSought from the depth {depth} on.");
        }
        text
    }

    /// Cautions in words: those of the case, and how many of `points` lie where stresses depend on the elements.
    #[must_use]
    pub fn cautions(&self, points: &[StressPoint]) -> Vec<String> {
        let settled = self.settled;
        let shallow = points.iter().filter(|at| at.point[2] < settled).count();
        let shallow = (shallow > 0).then(|| {
            format!(
                "points less than {settled:.2e} m deep: {shallow}; stresses there depend on the elements"
            )
        });
        self.solved.cautions.iter().map(ToString::to_string).chain(shallow).collect()
    }

    /// Points for programs.
    #[must_use]
    pub fn json(&self, key: &str, points: &[StressPoint]) -> Value {
        let cautions = self.cautions(points);
        json!({
            "creepage_version": env!("CARGO_PKG_VERSION"),
            "theory": self.solved.theory.name,
            "status": self.solved.solution().status.name(),
            "caution": (!cautions.is_empty()).then(|| cautions.join("; ")),
            "body": self.body(),
            "peak_pressure_pa": self.solved.peak_pressure().value,
            "settled_depth_m": self.settled,
            key: points.iter().map(object).collect::<Vec<_>>(),
        })
    }

    /// Down to `2a` below a point of the surface, from the depth where the stresses have settled.
    ///
    /// # Errors
    /// As [`Stresses::at`].
    pub fn beneath(&self, [x, y]: [f64; 2]) -> Result<Vec<StressPoint>, StressError> {
        /// Points from the least depth to the deepest, closer towards the surface.
        const DEPTHS: u32 = 80;
        let deepest = 2.0 * self.solved.box_around()[1][0];
        let depth = |k: u32| {
            self.settled + (deepest - self.settled) * (f64::from(k) / f64::from(DEPTHS)).powi(2)
        };
        self.at(&(0..=DEPTHS).map(|k| [x, y, depth(k)]).collect::<Vec<_>>())
    }

    /// Writes `stresses.csv` with `points` (without points the section), and a picture of the section and
    /// of the stresses beneath the largest as `stresses.svg` and `stresses.png`, into `directory`, which is
    /// made when missing; without points also a block of the body, `stresses.vtk`. None of `sources` is
    /// written over.
    ///
    /// # Errors
    /// [`StressFileError`]; what was made until then is removed.
    pub fn write(
        &self,
        directory: &Path,
        sources: &Sources,
        points: Option<&[StressPoint]>,
    ) -> Result<Vec<PathBuf>, StressFileError> {
        let section = self.section()?;
        let [x, y, _] = self.largest()?.point;
        let beneath = self.beneath([x, y])?;
        let csv = stress_csv(points.unwrap_or(&section))?;
        let svg = self.svg(&section, &beneath);
        let png = creepage_plot::png(&svg).map_err(ReportError::from)?;
        let mut files: Vec<(&str, &[u8])> =
            vec![("stresses.csv", &csv), ("stresses.svg", svg.as_bytes()), ("stresses.png", &png)];
        let vtk = if points.is_none() { self.vtk(&self.block()?) } else { String::new() };
        if points.is_none() {
            files.push(("stresses.vtk", vtk.as_bytes()));
        }
        Ok(write_all(directory, &files, sources)?)
    }
}

impl fmt::Debug for Stresses {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Stresses").field("settled", &self.settled).finish_non_exhaustive()
    }
}

/// The numbers of a row.
fn numbers(at: &StressPoint) -> [f64; 17] {
    let ([x, y, z], [xx, yy, zz, xy, yz, xz]) = (at.point, at.stress.components());
    let [first, second, third] = at.stress.principal();
    let (von_mises, tresca) = (at.stress.von_mises(), at.stress.tresca());
    let [u, v, w] = at.displacement;
    [x, y, z, xx, yy, zz, xy, yz, xz, von_mises, tresca, first, second, third, u, v, w]
}

fn object(at: &StressPoint) -> Value {
    HEADER.iter().zip(numbers(at)).map(|(name, value)| (*name, json!(value))).collect()
}

/// Points, stresses and displacements as CSV, in full precision.
///
/// # Errors
/// [`ReportError`] as of the writer of CSV.
pub fn stress_csv(points: &[StressPoint]) -> Result<Vec<u8>, ReportError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(HEADER)?;
    for point in points {
        writer.write_record(numbers(point).map(|value| format!("{value:e}")))?;
    }
    writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
}
