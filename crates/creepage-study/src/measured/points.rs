//! The table of measured forces.

use std::fmt;

use csv::StringRecord;

use crate::Component;
use crate::case::keys::similar;
use crate::separator::Separator;

/// Columns of the table.
pub(crate) const CREEPAGE: [&str; 3] = ["longitudinal", "lateral", "spin"];
const FORCE: [&str; 2] = ["longitudinal_force", "lateral_force"];
const COEFFICIENT: [&str; 2] = ["longitudinal_coefficient", "lateral_coefficient"];
const NORMAL: &str = "normal_force";
const UNCERTAINTY: &str = "uncertainty";
const KNOWN: [&str; 9] = [
    CREEPAGE[0],
    CREEPAGE[1],
    CREEPAGE[2],
    FORCE[0],
    FORCE[1],
    COEFFICIENT[0],
    COEFFICIENT[1],
    NORMAL,
    UNCERTAINTY,
];

/// Error of a table without measured points.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MeasuredError {
    /// No column of a creepage.
    #[error("a creepage is needed: a column longitudinal, lateral or spin{}", suggestion(.near.as_ref()))]
    NoCreepage {
        /// A column whose name is like one of them, and that one.
        near: Option<(String, &'static str)>,
    },
    /// No column of a force.
    #[error(
        "a force is needed: a column longitudinal_force or lateral_force (N), or \
         longitudinal_coefficient or lateral_coefficient (force over normal force){}", suggestion(.near.as_ref())
    )]
    NoForce {
        /// A column whose name is like one of them, and that one.
        near: Option<(String, &'static str)>,
    },
    /// Forces in two units.
    #[error("columns {first} and {second} are in two units: give all forces in one")]
    TwoUnits {
        /// A force in newtons.
        first: &'static str,
        /// One over the normal force.
        second: &'static str,
    },
    /// Two columns of one name.
    #[error("column {column} is there twice")]
    Twice {
        /// The column.
        column: &'static str,
    },
    /// Columns of different lengths.
    #[error("column {column} has {given} values, not {expected} as the first one")]
    Length {
        /// The column.
        column: &'static str,
        /// Its values.
        given: usize,
        /// Those of the first one.
        expected: usize,
    },
    /// The creepage along which curves are drawn is no column.
    #[error(
        "column {column} is missing: the curves vary it, and the points need a value of their own"
    )]
    NotVaried {
        /// The column.
        column: &'static str,
    },
    /// No row that can be read.
    #[error("no row has the numbers of a measured point{}", .first.as_ref().map_or_else(String::new, |row| format!(": {row}")))]
    Empty {
        /// The first row that cannot be read, where there is one.
        first: Option<UnreadRow>,
    },
    /// No CSV.
    #[error(transparent)]
    Csv(#[from] csv::Error),
}

fn suggestion(found: Option<&(String, &'static str)>) -> String {
    found.map_or_else(String::new, |(given, meant)| {
        format!("; `{given}` is none: did you mean `{meant}`?")
    })
}

/// Measured point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredPoint {
    /// Its row, from one, without the header.
    pub row: usize,
    /// Longitudinal and lateral creepage, spin (rad/m); `None` where there is no such column.
    pub creepage: [Option<f64>; 3],
    /// Longitudinal and lateral force of the upper body on the lower, in the unit of the table; `None`
    /// where there is no such column.
    pub force: [Option<f64>; 2],
    /// Normal force (N), where it is a column.
    pub normal_force: Option<f64>,
    /// One standard deviation of the forces, in their unit, where it is a column.
    pub uncertainty: Option<f64>,
}

/// Unread row, with the reason.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnreadRow {
    /// From one, without the header.
    pub row: usize,
    /// The column.
    pub column: &'static str,
    /// What stands there.
    pub text: String,
    /// What should.
    pub valid: &'static str,
}

impl fmt::Display for UnreadRow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { row, column, text, valid } = self;
        write!(f, "row {row}, column {column}: `{text}` is not {valid}")
    }
}

/// Table of measured forces.
///
/// Columns, in any order: `longitudinal`, `lateral` (creepages), `spin` (rad/m), of which one at least;
/// `longitudinal_force`, `lateral_force` (N, of the upper body on the lower), of which one at least, or
/// in their place `longitudinal_coefficient`, `lateral_coefficient` (force over normal force);
/// `normal_force` (N) where it differs from the case's; `uncertainty`, one standard deviation of the
/// forces in their unit. Lines that begin with `#` are passed over; columns may be separated by
/// semicolons or tabs, and between semicolons a comma may be the decimal sign.
///
/// ```
/// use creepage_study::MeasuredPoints;
/// let table = "lateral,lateral_force\n1e-3,11e3\n2e-3,18e3\n3e-3,\n";
/// let measured = MeasuredPoints::read(table)?;
/// assert_eq!(measured.points.len(), 2);
/// assert_eq!(measured.unread[0].row, 3);
/// # Ok::<(), creepage_study::MeasuredError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredPoints {
    /// The points, in the order of the table.
    pub points: Vec<MeasuredPoint>,
    /// Rows that are none.
    pub unread: Vec<UnreadRow>,
    /// Columns that mean nothing here.
    pub unused: Vec<String>,
    /// Whether forces are over the normal force.
    pub over_normal: bool,
}

/// Where the table has what.
struct Places {
    found: [Option<usize>; 9],
}

impl Places {
    fn new(names: &[&str]) -> Result<Self, MeasuredError> {
        let mut found = [None; 9];
        for (place, name) in names.iter().enumerate() {
            let Some(k) = KNOWN.iter().position(|known| known == name) else { continue };
            if found[k].replace(place).is_some() {
                return Err(MeasuredError::Twice { column: KNOWN[k] });
            }
        }
        let places = Self { found };
        let nearest = |meant: &[&'static str]| {
            let others = names.iter().filter(|name| !KNOWN.contains(name));
            let mut near = others.filter_map(|name| Some(((*name).into(), similar(name, meant)?)));
            near.next()
        };
        if !places.has(0..3) {
            return Err(MeasuredError::NoCreepage { near: nearest(&CREEPAGE) });
        }
        if !places.has(3..7) {
            return Err(MeasuredError::NoForce { near: nearest(&KNOWN[3..7]) });
        }
        let first = |range: std::ops::Range<usize>| range.into_iter().find(|k| found[*k].is_some());
        if let (Some(one), Some(two)) = (first(3..5), first(5..7)) {
            return Err(MeasuredError::TwoUnits { first: KNOWN[one], second: KNOWN[two] });
        }
        Ok(places)
    }

    fn has(&self, mut range: std::ops::Range<usize>) -> bool {
        range.any(|k| self.found[k].is_some())
    }

    /// The point of a row, by what its columns hold.
    fn point(
        &self,
        row: usize,
        at: impl Fn(usize) -> (Option<f64>, String),
    ) -> Result<MeasuredPoint, UnreadRow> {
        let mut numbers = [None; 9];
        for (k, number) in numbers.iter_mut().enumerate() {
            let Some(place) = self.found[k] else { continue };
            let (value, text) = at(place);
            let column = KNOWN[k];
            let value = value.filter(|value| value.is_finite());
            let wrong = |valid| UnreadRow { row, column, text: text.clone(), valid };
            let value = value.ok_or_else(|| wrong("a finite number"))?;
            if k >= 7 && value <= 0.0 {
                return Err(wrong("a number greater than zero"));
            }
            *number = Some(value);
        }
        let [longitudinal, lateral, spin, fx, fy, tx, ty, normal_force, uncertainty] = numbers;
        let creepage = [longitudinal, lateral, spin];
        Ok(MeasuredPoint {
            row,
            creepage,
            force: [fx.or(tx), fy.or(ty)],
            normal_force,
            uncertainty,
        })
    }
}

impl MeasuredPoints {
    /// Reads a table in CSV.
    ///
    /// # Errors
    /// [`MeasuredError`] for a table without creepages, forces or points. A row that is no point is
    /// no error: it is named in [`MeasuredPoints::unread`].
    pub fn read(text: &str) -> Result<Self, MeasuredError> {
        let text = text.trim_start_matches('\u{feff}');
        let separator = Separator::of(text);
        let mut reader = separator.reader().flexible(true).from_reader(text.as_bytes());
        let header = reader.headers()?.clone();
        let names: Vec<_> = header.iter().collect();
        let places = Places::new(&names)?;
        let records = reader.into_records().collect::<Result<Vec<StringRecord>, _>>()?;
        let rows = records.iter().map(|record| {
            move |place: usize| {
                let text = record.get(place).unwrap_or_default();
                (separator.number(text), text.to_owned())
            }
        });
        Self::of(&places, &names, rows)
    }

    /// The same from columns by their names.
    ///
    /// # Errors
    /// As [`MeasuredPoints::read`], and for columns of different lengths.
    pub fn from_columns(given: &[(&str, &[f64])]) -> Result<Self, MeasuredError> {
        let names: Vec<_> = given.iter().map(|(name, _)| *name).collect();
        let places = Places::new(&names)?;
        let expected = given.first().map_or(0, |(_, values)| values.len());
        for (name, values) in given {
            let column = KNOWN.into_iter().find(|known| known == name);
            if let (Some(column), true) = (column, values.len() != expected) {
                return Err(MeasuredError::Length { column, given: values.len(), expected });
            }
        }
        let rows = (0..expected).map(|row| {
            move |place: usize| {
                let value = given.get(place).and_then(|(_, values)| values.get(row)).copied();
                (value, value.map_or_else(String::new, |value| value.to_string()))
            }
        });
        Self::of(&places, &names, rows)
    }

    fn of(
        places: &Places,
        names: &[&str],
        rows: impl Iterator<Item = impl Fn(usize) -> (Option<f64>, String)>,
    ) -> Result<Self, MeasuredError> {
        let (mut points, mut unread) = (Vec::new(), Vec::new());
        for (row, at) in (1..).zip(rows) {
            match places.point(row, at) {
                Ok(point) => points.push(point),
                Err(row) => unread.push(row),
            }
        }
        if points.is_empty() {
            return Err(MeasuredError::Empty { first: unread.into_iter().next() });
        }
        let unused = names.iter().filter(|name| !KNOWN.contains(name));
        let unused = unused.map(|name| (*name).to_owned()).collect();
        Ok(Self { points, unread, unused, over_normal: places.has(5..7) })
    }

    /// The component of the creepage that varies most, in parts of its largest size.
    #[must_use]
    pub fn varies(&self) -> Component {
        let spread = |k: usize| {
            let values = || self.points.iter().filter_map(|point| point.creepage[k]);
            let largest = values().map(f64::abs).fold(f64::MIN_POSITIVE, f64::max);
            let width = values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min);
            width / largest
        };
        let widest = (0..3).reduce(|one, two| if spread(two) > spread(one) { two } else { one });
        Component::ALL[widest.unwrap_or(0)]
    }

    /// What of the table cannot be used, a line each; empty where all of it can.
    #[must_use]
    pub fn left_out(&self) -> Vec<String> {
        let rows = self.unread.iter().map(|row| format!("{row}; left out"));
        let unused = (!self.unused.is_empty())
            .then(|| format!("columns without a meaning here: {}", self.unused.join(", ")));
        rows.chain(unused).collect()
    }

    /// The force of a point (N), where the case's normal force is `normal` and the point has none.
    pub(crate) fn newtons(&self, point: &MeasuredPoint, normal: f64) -> [Option<f64>; 2] {
        let unit = if self.over_normal { point.normal_force.unwrap_or(normal) } else { 1.0 };
        point.force.map(|force| force.map(|force| force * unit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_separators_comments_and_decimal_commas() {
        let text = "\u{feff}# a rig\nspin;lateral_coefficient;time\n0,5;0,1;7\n# pause\n1;0,2;8\n";
        let read = MeasuredPoints::read(text).unwrap();
        assert_eq!(read.points[0].creepage, [None, None, Some(0.5)]);
        assert_eq!(read.points[1].force, [None, Some(0.2)]);
        assert!(read.over_normal && read.unused == ["time"] && read.unread.is_empty());
    }

    #[test]
    fn what_is_no_table_is_refused_by_its_cause() {
        let error = |text| MeasuredPoints::read(text).unwrap_err().to_string();
        assert!(
            error("longitudnal,lateral_force\n1,2\n").ends_with("did you mean `longitudinal`?")
        );
        assert!(error("lateral\n1\n").starts_with("a force is needed"));
        assert!(error("spin,lateral_force,lateral_coefficient\n1,2,3\n").contains("two units"));
        assert!(error("spin,spin,lateral_force\n1,2,3\n").contains("twice"));
        assert!(error("spin,lateral_force\n1,x\n").ends_with("`x` is not a finite number"));
        assert!(error("").starts_with("a creepage is needed"));
    }

    #[test]
    fn rows_that_are_no_points_are_named() {
        let text = "lateral,lateral_force,normal_force\n1,2,3\n,2,3\n1,nan,3\n1,2,-3\n1,2\n";
        let read = MeasuredPoints::read(text).unwrap();
        assert_eq!(read.points.len(), 1);
        let places: Vec<_> = read.unread.iter().map(|row| (row.row, row.column)).collect();
        assert_eq!(
            places,
            [(2, "lateral"), (3, "lateral_force"), (4, "normal_force"), (5, "normal_force")]
        );
    }
}
