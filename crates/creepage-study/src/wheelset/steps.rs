//! Transient rolling of a wheelset: a table of positions, and the forces at the end of each.

use std::io::{self, Read};
use std::mem::discriminant;

use creepage_rail::Side;
use creepage_wheelset::{
    ASKED, ContactChanges, Load, SolvedWheel, SolvedWheelset, SteppedWheelset, WheelSteps,
    WheelsetError, WheelsetPose, WheelsetVelocity, side_word,
};

use super::case::WheelsetCase;
use super::error::{WheelsetFileError, section};
use super::report::wheelset_cautions;
use super::steps_picture;
use crate::Caution;
use crate::case::keys::similar;
use crate::separator::Separator;

/// Columns of a table of positions: the distance rolled (m), the place along the track (m) and the wheels' turn (rad)
/// where surfaces vary along rolling, a wheel's own load (N), and what a wheelset is asked by.
const COLUMNS: [&str; 4] = ["distance", "s", "pitch", "wheel_load"];

/// Columns of what comes of it; of a side that is not solved they are empty.
pub const WHEEL_STEP_COLUMNS: [&str; 20] = [
    "distance_m",
    "left_longitudinal_n",
    "left_lateral_n",
    "left_vertical_n",
    "left_normal_n",
    "left_peak_pressure_pa",
    "left_contacts",
    "left_adhesion_share",
    "right_longitudinal_n",
    "right_lateral_n",
    "right_vertical_n",
    "right_normal_n",
    "right_peak_pressure_pa",
    "right_contacts",
    "right_adhesion_share",
    "appeared",
    "vanished",
    "split",
    "joined",
    "status",
];

/// How many of them are numbers: all but the status.
pub const WHEEL_STEP_NUMBERS: usize = WHEEL_STEP_COLUMNS.len() - 1;

/// Error of a table of positions.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WheelTableError {
    /// Not CSV.
    #[error("no table in CSV: {0}")]
    Csv(#[from] csv::Error),
    /// A column that is not known.
    #[error("column {name} is not known; known are {}", known().join(", "))]
    Column {
        /// Its name.
        name: String,
        /// The nearest known name.
        similar: Option<&'static str>,
    },
    /// A column twice.
    #[error("column {name} is there twice")]
    Twice {
        /// Its name.
        name: String,
    },
    /// No distance.
    #[error("column distance (m) is missing")]
    NoDistance,
    /// A field that is no number.
    #[error("row {row}: {column} = {text} is no finite number")]
    Number {
        /// Of the table, from 1.
        row: usize,
        /// Of which column.
        column: String,
        /// What stands there.
        text: String,
    },
    /// A load that presses nothing.
    #[error("row {row}: wheel_load = {load} N must be above zero")]
    Load {
        /// Of the table, from 1.
        row: usize,
        /// What stands there (N).
        load: f64,
    },
    /// Distances that do not rise.
    #[error("row {row}: distance = {distance} m is not above {before} m, where the row begins")]
    Order {
        /// Of the table, from 1.
        row: usize,
        /// What stands there (m).
        distance: f64,
        /// The one before (m).
        before: f64,
    },
    /// No rows.
    #[error("the table has no rows")]
    Empty,
}

/// One row.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Row {
    distance: f64,
    place: [f64; 2],
    wheel_load: f64,
    asked: [f64; ASKED.len()],
}

/// Table of positions and motions of wheels: the motion of a row acts from the distance of the row before, or
/// zero, to its own, in the position of the row.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelTable {
    rows: Vec<Row>,
}

fn known() -> Vec<&'static str> {
    COLUMNS.into_iter().chain(ASKED).collect()
}

/// Which of the known columns those of a table are.
fn columns<'a>(names: impl Iterator<Item = &'a str>) -> Result<Vec<usize>, WheelTableError> {
    let known = known();
    let mut columns: Vec<usize> = Vec::new();
    for name in names {
        let Some(column) = known.iter().position(|one| *one == name) else {
            let similar = similar(name, &known);
            return Err(WheelTableError::Column { name: name.into(), similar });
        };
        if columns.contains(&column) {
            return Err(WheelTableError::Twice { name: name.into() });
        }
        columns.push(column);
    }
    if columns.contains(&0) { Ok(columns) } else { Err(WheelTableError::NoDistance) }
}

impl WheelTable {
    /// Reads a table in CSV: `distance` (m), and what of `s`, `pitch`, `wheel_load` and of the names of [`ASKED`]
    /// differs from the case; an empty field is the case's own. Columns may be separated by semicolons or tabs, and
    /// between semicolons a comma may be the decimal sign.
    ///
    /// # Errors
    /// [`WheelTableError`] with the column and the row.
    pub fn read(input: impl Read) -> Result<Self, WheelTableError> {
        let text = io::read_to_string(input).map_err(csv::Error::from)?;
        let text = text.trim_start_matches('\u{feff}');
        let separator = Separator::of(text);
        let mut reader = separator.reader().from_reader(text.as_bytes());
        let columns = columns(reader.headers()?.iter())?;
        let mut table = Self { rows: Vec::new() };
        for (index, record) in reader.records().enumerate() {
            let mut values = vec![f64::NAN; columns.len()];
            for ((column, text), value) in columns.iter().zip(record?.iter()).zip(&mut values) {
                if text.is_empty() && *column != 0 {
                    continue;
                }
                let number = separator.number(text).filter(|number| number.is_finite());
                *value = number.ok_or_else(|| WheelTableError::Number {
                    row: index + 1,
                    column: known()[*column].into(),
                    text: text.into(),
                })?;
            }
            table.push(&columns, &values)?;
        }
        if table.is_empty() { Err(WheelTableError::Empty) } else { Ok(table) }
    }

    /// The same from columns by their names, of one length; a number that is not one (NaN) is the case's own.
    ///
    /// # Errors
    /// As [`WheelTable::read`].
    pub fn from_columns(given: &[(&str, &[f64])]) -> Result<Self, WheelTableError> {
        let columns = columns(given.iter().map(|(name, _)| *name))?;
        let mut table = Self { rows: Vec::new() };
        for index in 0..given.iter().map(|(_, values)| values.len()).min().unwrap_or(0) {
            let values: Vec<f64> = given.iter().map(|(_, values)| values[index]).collect();
            for (column, value) in columns.iter().zip(&values) {
                if value.is_infinite() || value.is_nan() && *column == 0 {
                    let (column, text) = (known()[*column].into(), format!("{value:?}"));
                    return Err(WheelTableError::Number { row: index + 1, column, text });
                }
            }
            table.push(&columns, &values)?;
        }
        if table.is_empty() { Err(WheelTableError::Empty) } else { Ok(table) }
    }

    /// Adds a row of such columns.
    fn push(&mut self, columns: &[usize], given: &[f64]) -> Result<(), WheelTableError> {
        let mut values = vec![f64::NAN; known().len()];
        for (column, value) in columns.iter().zip(given) {
            values[*column] = *value;
        }
        let (row, distance) = (self.rows.len() + 1, values[0]);
        let before = self.rows.last().map_or(0.0, |row| row.distance);
        if distance <= before {
            return Err(WheelTableError::Order { row, distance, before });
        }
        let (own, asked) = values.split_at(COLUMNS.len());
        if own[3] <= 0.0 {
            return Err(WheelTableError::Load { row, load: own[3] });
        }
        self.rows.push(Row {
            distance,
            place: [own[1], own[2]],
            wheel_load: own[3],
            asked: std::array::from_fn(|k| asked[k]),
        });
        Ok(())
    }

    /// The number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether it has no rows; never, as it was read.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

/// Run of wheels in steps by a table.
#[derive(Debug)]
pub struct WheelStepsRun<'a> {
    case: &'a WheelsetCase,
    table: &'a WheelTable,
    wheels: WheelSteps,
    done: usize,
    changes: ContactChanges,
    unequal: f64,
    /// Of each row the distance (m), and the forces on both rails (N).
    way: Vec<(f64, [Option<[f64; 3]>; 2])>,
    /// What wheels are in doubt for: the first row (from 1) of each kind and side, and the number of rows.
    doubts: Vec<Doubt>,
}

#[derive(Debug)]
struct Doubt {
    side: Side,
    caution: Caution,
    row: usize,
    count: usize,
}

impl<'a> WheelStepsRun<'a> {
    /// Before the first row.
    ///
    /// # Errors
    /// As [`WheelsetCase::solver`].
    pub fn new(case: &'a WheelsetCase, table: &'a WheelTable) -> Result<Self, WheelsetFileError> {
        case.solver()?;
        let wheels = WheelSteps::new(case.start);
        let (done, changes, unequal) = (0, ContactChanges::default(), 0.0);
        let (way, doubts) = (Vec::new(), Vec::new());
        Ok(Self { case, table, wheels, done, changes, unequal, way, doubts })
    }

    /// Rolls to the next row: its distance (m) and the wheels there; `None` after the last.
    ///
    /// # Errors
    /// [`WheelsetFileError`] for what cannot be solved.
    pub fn next_row(&mut self) -> Result<Option<(f64, SteppedWheelset)>, WheelsetFileError> {
        let Some(row) = self.table.rows.get(self.done) else { return Ok(None) };
        let before = self.done.checked_sub(1).map_or(0.0, |last| self.table.rows[last].distance);
        let [s, pitch] = row.place;
        let there;
        let case = if s.is_nan() && pitch.is_nan() {
            self.case
        } else {
            there = self.case.at(s, pitch)?;
            &there
        };
        case.travel.ok_or_else(|| section("motion", "speed"))?;
        let (pose, velocity): (WheelsetPose, WheelsetVelocity) = case.asked(&row.asked)?;
        let has_axle_load = ASKED
            .iter()
            .zip(&row.asked)
            .any(|(name, value)| *name == "axle_load" && !value.is_nan());
        if let Some(side) = pose.side.filter(|_| has_axle_load) {
            let (section, key, side) = ("wheelset", "axle_load", side_word(side));
            let instead = "give wheel_load";
            return Err(WheelsetFileError::OneWheel { section, key, side, instead });
        }
        let other = ASKED.iter().zip(&row.asked).find(|(name, value)| {
            ["z", "axle_load", "roll_moment"].contains(*name) && !value.is_nan()
        });
        if let Some((other, _)) = other.filter(|_| !row.wheel_load.is_nan()) {
            let one = "wheel_load";
            return Err(WheelsetError::Conflict { section: "wheelset", one, other }.into());
        }
        let load =
            if row.wheel_load.is_nan() { pose.load } else { Some(Load::Wheel(row.wheel_load)) };
        let pose = WheelsetPose { load, ..pose };
        let solver = case.solver()?;
        let stepped = self.wheels.step(&solver, &pose, &velocity, row.distance - before)?;
        self.done += 1;
        let ContactChanges { appeared, vanished, split, joined } = stepped.changes;
        self.changes.appeared += appeared;
        self.changes.vanished += vanished;
        self.changes.split += split;
        self.changes.joined += joined;
        for wheel in stepped.solved.wheels() {
            let wanted = match pose.load {
                Some(Load::Axle(load)) if pose.side.is_none() && pose.roll.is_none() => {
                    Some(0.5 * load)
                }
                Some(load) => load.of_wheel(wheel.side),
                None => None,
            };
            if let Some(wanted) = wanted.filter(|wanted| *wanted > 0.0) {
                self.unequal = self.unequal.max((wheel.on_rail().force[2] / wanted - 1.0).abs());
            }
        }
        let on_rail = |wheel: &Option<SolvedWheel>| Some(wheel.as_ref()?.on_rail().force);
        let SolvedWheelset { left, right, .. } = &stepped.solved;
        self.way.push((row.distance, [on_rail(left), on_rail(right)]));
        self.remember(&stepped);
        Ok(Some((row.distance, stepped)))
    }

    /// Keeps the cautions of a row but for its status, which the table has.
    fn remember(&mut self, stepped: &SteppedWheelset) {
        for (side, caution) in wheelset_cautions(&stepped.solved) {
            if matches!(caution, Caution::Status(_)) {
                continue;
            }
            let is_known = |doubt: &&mut Doubt| {
                doubt.side == side && discriminant(&doubt.caution) == discriminant(&caution)
            };
            match self.doubts.iter_mut().find(is_known) {
                Some(doubt) if doubt.row == self.done => {}
                Some(doubt) => doubt.count += 1,
                None => self.doubts.push(Doubt { side, caution, row: self.done, count: 1 }),
            }
        }
    }

    /// What to be careful about of all rows so far, in words.
    #[must_use]
    pub fn cautions(&self) -> Vec<String> {
        let ContactChanges { appeared, vanished, split, joined } = self.changes;
        let of_wheels = self.doubts.iter().map(|Doubt { side, caution, row, count }| {
            let others = match count - 1 {
                0 => String::new(),
                1 => " and one other".into(),
                others => format!(" and {others} others"),
            };
            format!("row {row}{others}: {} wheel: {caution}", side_word(*side))
        });
        let mut words: Vec<String> = of_wheels.collect();
        for (count, what) in [
            (appeared, "contacts appeared where nothing was before: they began without traction"),
            (vanished, "contacts ended, and their tractions with them"),
            (split, "contacts split: what each part had of the others is not felt from then on"),
            (joined, "contacts joined: tractions in planes of their own were taken as in one"),
        ] {
            if count > 0 {
                words.push(format!("{count} {what}"));
            }
        }
        let left_out = [("damage", self.case.damage.is_some()), ("heat", self.case.heat.is_some())];
        for (section, _) in left_out.into_iter().filter(|(_, is_wanted)| *is_wanted) {
            words.push(format!("[{section}] is left out: rows have no such numbers"));
        }
        if self.unequal > UNEQUAL {
            words.push(format!(
                "vertical forces differ by up to {:.2} % from the given loads: heights are those of steady rolling, \
                 friction in steps is another",
                100.0 * self.unequal
            ));
        }
        words
    }

    /// The forces on both rails so far over the distance, as SVG.
    #[must_use]
    pub fn picture(&self) -> String {
        steps_picture::forces(&self.way)
    }

    /// The numbers of a row, in the order of [`WHEEL_STEP_COLUMNS`] without its status; NaN of a side that is not
    /// solved.
    #[must_use]
    pub fn numbers(distance: f64, stepped: &SteppedWheelset) -> [f64; WHEEL_STEP_NUMBERS] {
        let SteppedWheelset { solved, changes } = stepped;
        let sides = [&solved.left, &solved.right]
            .map(|wheel| wheel.as_ref().map_or([f64::NAN; 7], numbers_of));
        let ContactChanges { appeared, vanished, split, joined } = *changes;
        let changes = [appeared, vanished, split, joined].map(|count| count as f64);
        let mut all = std::iter::once(distance).chain(sides.into_iter().flatten()).chain(changes);
        std::array::from_fn(|_| all.next().unwrap_or(f64::NAN))
    }

    /// The row of [`WHEEL_STEP_COLUMNS`].
    #[must_use]
    pub fn record(distance: f64, stepped: &SteppedWheelset) -> Vec<String> {
        let numbers = WHEEL_STEP_COLUMNS.into_iter().zip(Self::numbers(distance, stepped));
        let cell = |(name, value): (&str, f64)| match value {
            value if value.is_nan() => String::new(),
            value if COUNTS.contains(&name) => format!("{value:.0}"),
            value => format!("{value:e}"),
        };
        let status = stepped.solved.status().name().to_owned();
        numbers.map(cell).chain(std::iter::once(status)).collect()
    }
}

/// Columns of whole numbers.
const COUNTS: [&str; 6] =
    ["left_contacts", "right_contacts", "appeared", "vanished", "split", "joined"];

/// Of the load: less is friction's error.
const UNEQUAL: f64 = 5e-3;

fn numbers_of(wheel: &SolvedWheel) -> [f64; 7] {
    let [along, across, down] = wheel.on_rail().force;
    let contacts = wheel.contacts();
    let normal = contacts.iter().fold(0.0, |sum, one| sum + one.load());
    let peak = contacts.iter().map(|one| one.normal.peak_pressure().value).fold(0.0, f64::max);
    let area = |one: &creepage_wheelset::SolvedContact| one.normal.area().value;
    let all: f64 = contacts.iter().map(area).sum();
    let stuck: f64 = contacts.iter().map(|one| area(one) * one.adhesion_share()).sum();
    let share = if all > 0.0 { stuck / all } else { f64::NAN };
    [along, across, down, normal, peak, contacts.len() as f64, share]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<WheelTable, String> {
        WheelTable::read(text.as_bytes()).map_err(|error| error.to_string())
    }

    #[test]
    fn tables_are_read_and_checked() {
        let table =
            read("distance, y ,wheel_load\n# a comment\n0.001,0.002,5e4\n0.002,,5e4\n").unwrap();
        assert_eq!((table.len(), table.is_empty()), (2, false));
        assert!((table.rows[0].asked[0] - 0.002).abs() < 1e-15 && table.rows[1].asked[0].is_nan());
        assert!((table.rows[1].wheel_load - 5e4).abs() < 1e-9);
        for (text, words) in [
            ("y\n0\n", "distance"),
            ("distance,hight\n1,2\n", "hight is not known"),
            ("distance,y,y\n1,2,3\n", "twice"),
            ("distance\n", "no rows"),
            ("distance\n0.0\n", "not above"),
            ("distance,wheel_load\n0.1,0\n", "wheel_load = 0 N must be above zero"),
            ("distance\n0.2\n0.1\n", "row 2"),
            ("distance,y\n0.1,left\n", "no finite number"),
            ("distance,y\n0.1,inf\n", "no finite number"),
            ("distance,y\n,0.1\n", "no finite number"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.contains(words), "{text}: {error}");
        }
    }
}
