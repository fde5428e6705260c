//! Table of a history: distances, loads and motions of the bodies, row by row.

use std::io::{self, Read};

use creepage::unsteady::{Motion, Prescribed};
use creepage::{InvalidValue, SiCreepage};

use super::case::{RollCase, over};
use super::error::{HistoryError, MotionError};
use super::roller::HistoryMotion;
use crate::case::keys::similar;
use crate::caution::Caution;
use crate::separator::Separator;

/// Row of a history: a distance, and the motion of the bodies up to it from that of the row before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HistoryRow {
    /// Distance rolled at its end (m).
    pub distance: f64,
    /// Motion and load.
    pub motion: HistoryMotion,
}

/// History of motions and loads, every number of it checked.
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    /// In order of the distance.
    pub rows: Vec<HistoryRow>,
}

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Distance,
    NormalForce,
    /// The creepage of a component, in SI units.
    Si(usize),
    Dimensionless(usize),
    Force(usize),
}

const COLUMNS: [(&str, Kind); 11] = [
    ("distance", Kind::Distance),
    ("normal_force", Kind::NormalForce),
    ("longitudinal", Kind::Si(0)),
    ("lateral", Kind::Si(1)),
    ("spin", Kind::Si(2)),
    ("xi", Kind::Dimensionless(0)),
    ("eta", Kind::Dimensionless(1)),
    ("chi", Kind::Dimensionless(2)),
    ("longitudinal_force", Kind::Force(0)),
    ("lateral_force", Kind::Force(1)),
    ("moment", Kind::Force(2)),
];

type Column = (&'static str, Kind);

impl Kind {
    /// The component that it moves.
    fn component(self) -> Option<usize> {
        match self {
            Self::Si(k) | Self::Dimensionless(k) | Self::Force(k) => Some(k),
            Self::Distance | Self::NormalForce => None,
        }
    }

    fn is_creepage(self) -> bool {
        matches!(self, Self::Si(_) | Self::Dimensionless(_))
    }
}

impl History {
    /// Reads a table in CSV: `distance` (m); of each component of the motion the creepage in SI units
    /// (`longitudinal`, `lateral`, `spin`), the dimensionless one (`xi`, `eta`, `chi`) or the force
    /// (`longitudinal_force`, `lateral_force`, `moment`), zero creepage if none; `normal_force`. With a creepage and the
    /// force of one component each row has one of the two, and the other field is empty. Columns may be separated by
    /// semicolons or tabs, and between semicolons a comma may be the decimal sign.
    ///
    /// # Errors
    /// [`HistoryError`] that names the column, and the row.
    pub fn read(input: impl Read, case: &RollCase) -> Result<Self, HistoryError> {
        let text = io::read_to_string(input).map_err(csv::Error::from)?;
        let text = text.trim_start_matches('\u{feff}');
        let separator = Separator::of(text);
        let mut reader = separator.reader().flexible(true).from_reader(text.as_bytes());
        let columns = columns(reader.headers()?.iter(), case)?;
        let mut rows = Rows::new(&columns, case);
        for (index, record) in reader.records().enumerate() {
            rows.push(&numbers(index + 1, &record?, separator, &columns)?)?;
        }
        rows.whole()
    }

    /// The same from columns by their names, of one length; a field that is empty is no number (NaN).
    ///
    /// # Errors
    /// As [`History::read`].
    pub fn from_columns(given: &[(&str, &[f64])], case: &RollCase) -> Result<Self, HistoryError> {
        let columns = columns(given.iter().map(|(name, _)| *name), case)?;
        let mut rows = Rows::new(&columns, case);
        for index in 0..given.iter().map(|(_, values)| values.len()).min().unwrap_or(0) {
            let values: Vec<f64> = given.iter().map(|(_, values)| values[index]).collect();
            rows.push(&values)?;
        }
        rows.whole()
    }
}

impl History {
    /// The first row, from one, with a creepage that no wheel has, which may be in per cent or in degrees, or a load under
    /// which a metal flows.
    #[must_use]
    pub fn caution(&self, case: &RollCase) -> Option<(usize, Caution)> {
        let si = |component: Prescribed| match component {
            Prescribed::Creepage(creepage) => creepage * case.scaling.slip,
            Prescribed::Force(_) => 0.0,
        };
        self.rows.iter().enumerate().find_map(|(index, row)| {
            let Motion { longitudinal, lateral, spin } = row.motion.motion;
            let [longitudinal, lateral, slip] = [longitudinal, lateral, spin].map(si);
            let si = SiCreepage { longitudinal, lateral, spin: slip / case.scaling.length };
            let heavy = || case.caution_of_load(row.motion.load);
            Some((index + 1, case.caution_of_motion(si).or_else(heavy)?))
        })
    }
}

impl HistoryRow {
    /// A single step: `distance` is its own length, all by the names of a history's columns.
    ///
    /// # Errors
    /// [`HistoryError`] that names the column.
    pub(super) fn of_step(given: &[(&str, f64)], case: &RollCase) -> Result<Self, HistoryError> {
        let columns = columns(given.iter().map(|(name, _)| *name), case)?;
        let values: Vec<f64> = given.iter().map(|(_, value)| *value).collect();
        row(&values, &columns, case, 0.0).map_err(HistoryError::Step)
    }
}

/// Rows as they are read.
struct Rows<'a> {
    columns: &'a [Column],
    case: &'a RollCase,
    read: Vec<HistoryRow>,
}

impl<'a> Rows<'a> {
    fn new(columns: &'a [Column], case: &'a RollCase) -> Self {
        Self { columns, case, read: Vec::new() }
    }

    fn push(&mut self, values: &[f64]) -> Result<(), HistoryError> {
        let before = self.read.last().map_or(0.0, |row| row.distance);
        let row = row(values, self.columns, self.case, before);
        self.read.push(row.map_err(HistoryError::in_row(self.read.len() + 1))?);
        Ok(())
    }

    fn whole(self) -> Result<History, HistoryError> {
        let rows = self.read;
        if rows.is_empty() { Err(HistoryError::Empty) } else { Ok(History { rows }) }
    }
}

fn columns<'a>(
    names: impl Iterator<Item = &'a str>,
    case: &RollCase,
) -> Result<Vec<Column>, HistoryError> {
    let found = names.map(named).collect::<Result<Vec<_>, _>>()?;
    for (index, (first, kind)) in found.iter().enumerate() {
        // Of a component a creepage and a force may stand beside each other: one of them in each row.
        let is_same = |other: &Kind| {
            let is_component = kind.component().is_some_and(|k| other.component() == Some(k));
            other == kind || is_component && kind.is_creepage() == other.is_creepage()
        };
        if let Some((second, _)) = found[index + 1..].iter().find(|(_, other)| is_same(other)) {
            if first == second {
                return Err(HistoryError::Twice { column: first });
            }
            return Err(HistoryError::TwoColumns { first, second });
        }
        if *kind == Kind::NormalForce && case.has_areas() {
            return Err(HistoryError::NotOfAnArea { column: first });
        }
        if *kind == Kind::NormalForce && case.has_layer() {
            return Err(HistoryError::NotWithLayer { column: first });
        }
        if *kind == Kind::NormalForce && case.is_variational() {
            return Err(HistoryError::NotOfVariational { what: "column normal_force" });
        }
        let foreign = *kind == Kind::NormalForce || kind.component() == Some(2);
        if foreign && case.is_line() {
            return Err(HistoryError::NotOfALine { column: first });
        }
        if kind.is_creepage() && case.lacks_length() {
            return Err(HistoryError::NoLength { column: first });
        }
    }
    let has_distance = found.iter().any(|(_, kind)| *kind == Kind::Distance);
    let is_held = found.iter().any(|(_, kind)| *kind == Kind::Force(0));
    if !has_distance {
        return Err(HistoryError::NoDistance);
    }
    if case.lacks_length() && !is_held {
        return Err(HistoryError::NoLength { column: "longitudinal" });
    }
    Ok(found)
}

fn named(name: &str) -> Result<Column, HistoryError> {
    COLUMNS.into_iter().find(|(known, _)| *known == name).ok_or_else(|| {
        let names = COLUMNS.map(|(known, _)| known);
        let hint = match similar(name, &names) {
            Some(likely) => format!("did you mean `{likely}`?"),
            None => format!("known are {}", names.join(", ")),
        };
        HistoryError::UnknownColumn { name: name.into(), hint }
    })
}

/// The fields of a row as numbers.
fn numbers(
    row: usize,
    record: &csv::StringRecord,
    separator: Separator,
    columns: &[Column],
) -> Result<Vec<f64>, HistoryError> {
    let (found, expected) = (record.len(), columns.len());
    if found != expected {
        return Err(HistoryError::Fields { row, found, expected });
    }
    let number = |(text, (column, kind)): (&str, &Column)| {
        if text.is_empty() && counterpart(*kind, columns).is_some() {
            return Ok(EMPTY);
        }
        let wrong = || HistoryError::NotANumber { row, column, text: text.into() };
        separator.number(text).ok_or_else(wrong)
    };
    record.iter().zip(columns).map(number).collect()
}

/// In place of a number that is not given.
const EMPTY: f64 = f64::NAN;

/// The column of the same component's force or creepage, where a table has both.
fn counterpart(kind: Kind, columns: &[Column]) -> Option<&'static str> {
    let component = kind.component()?;
    let is_other = |other: &Kind| *other != kind && other.component() == Some(component);
    columns.iter().find(|(_, other)| is_other(other)).map(|(name, _)| *name)
}

fn row(
    values: &[f64],
    columns: &[Column],
    case: &RollCase,
    before: f64,
) -> Result<HistoryRow, MotionError> {
    let units = &case.scaling;
    let mut distance = f64::NAN;
    let mut load = 1.0;
    let mut parts = [Prescribed::Creepage(0.0); 3];
    let mut given = [0; 3];
    for (value, (column, kind)) in values.iter().zip(columns) {
        if let Some(k) = kind.component().filter(|_| counterpart(*kind, columns).is_some()) {
            if value.is_nan() {
                continue;
            }
            given[k] += 1;
        }
        let value = in_range(column, *value)?;
        match *kind {
            Kind::Distance => distance = value,
            Kind::NormalForce => load = normal(value, case.load)?,
            Kind::Si(k) => {
                let unit = [units.slip, units.slip, units.slip / units.length][k];
                parts[k] = over(Prescribed::Creepage(value), unit);
            }
            Kind::Dimensionless(k) => parts[k] = Prescribed::Creepage(value),
            Kind::Force(k) => {
                let unit = [units.force, units.force, units.force * units.length][k];
                parts[k] = over(Prescribed::Force(value), unit);
            }
        }
    }
    for (first, kind) in columns {
        if let Some((second, k)) = counterpart(*kind, columns).zip(kind.component())
            && given[k] != 1
        {
            return Err(MotionError::OneOfTwo { first, second, given: given[k] });
        }
    }
    if distance.is_nan() || distance <= before {
        return Err(MotionError::Distance { value: distance, before });
    }
    let [longitudinal, lateral, spin] = parts;
    let motion = HistoryMotion { motion: Motion { longitudinal, lateral, spin }, load };
    within(&motion, case)?;
    Ok(HistoryRow { distance, motion })
}

/// As large as any creepage may be, and safe to square.
fn in_range(quantity: &'static str, value: f64) -> Result<f64, InvalidValue> {
    let valid = "between -1e100 and 1e100";
    if value.abs() <= 1e100 { Ok(value) } else { Err(InvalidValue { quantity, value, valid }) }
}

/// A normal force over the nominal one.
fn normal(value: f64, nominal: f64) -> Result<f64, InvalidValue> {
    let valid = "between zero and a million times that of the case";
    let load = value / nominal;
    let invalid = InvalidValue { quantity: "normal_force", value, valid };
    if (0.0..=1e6).contains(&load) { Ok(load) } else { Err(invalid) }
}

/// Friction must be able to give the forces of a row, and the moment on an ellipse.
fn within(motion: &HistoryMotion, case: &RollCase) -> Result<(), MotionError> {
    let unit = case.scaling.force;
    if let (Some(most), Prescribed::Force(moment)) = (case.largest_moment(), motion.motion.spin) {
        let most = motion.load * motion.load.cbrt() * most;
        if moment.abs() > most {
            let unit = unit * case.scaling.length;
            let (moment, most) = (moment.abs() * unit, most * unit);
            return Err(MotionError::MomentBeyondFriction { moment, most });
        }
    }
    let parts = [motion.motion.longitudinal, motion.motion.lateral];
    let [fx, fy] = parts.map(|part| match part {
        Prescribed::Force(value) => value,
        Prescribed::Creepage(_) => 0.0,
    });
    let force = fx.hypot(fy);
    if force <= motion.load {
        return Ok(());
    }
    Err(MotionError::BeyondFriction { force: force * unit, most: motion.load * unit })
}
