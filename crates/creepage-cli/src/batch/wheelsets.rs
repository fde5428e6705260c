//! Batch rows that differ from a wheelset's file: positions, loads, motions and friction, on all cores.

use std::path::Path;

use creepage::{InvalidValue, Status, TheorySpec};
use creepage_study::{
    ANSWERS, ASKED, Caution, WheelsetCase, WheelsetFileError, WheelsetSolver, theory_spec,
    wheelset_caution_words,
};
use csv::ByteRecord;
use rayon::prelude::*;

use super::columns::{ColumnError, NoCase, names, parse, place_of, tell_misspelt, tell_of_file};
use super::rows::RowAnswer;
use super::table::Table;
use super::{free, write_answers};
use crate::batch_args::BatchArgs;
use crate::failure::Failure;
use crate::outcome::Outcome;
use crate::output::say;
use crate::wheelset::{read, say_found, say_left_out};

/// Beside what a wheelset is asked by: friction, and the place where surfaces vary along rolling.
const FRICTION: &str = "friction";
const PLACE: [&str; 2] = ["s", "pitch"];
/// Keys that rows cannot have.
const OF_FILE: [&str; 12] = [
    "curvature",
    "curve_radius",
    "superelevation",
    "gauge",
    "wheel_load",
    "wheel_load_left",
    "wheel_load_right",
    "torque",
    "longitudinal_force",
    "longitudinal",
    "lateral",
    "spin",
];
/// Where [`ASKED`] has the load on both wheels.
const AXLE_LOAD: usize = 4;

/// Why a row has no answer.
#[derive(Debug, thiserror::Error)]
enum RowError {
    #[error(transparent)]
    Field(#[from] NoCase),
    #[error(transparent)]
    Wheelset(#[from] WheelsetFileError),
}

/// Where rows say what.
struct Places {
    asked: [Option<usize>; ASKED.len()],
    friction: Option<usize>,
    place: [Option<usize>; 2],
    count: usize,
}

pub(super) fn run(args: &BatchArgs, path: &Path) -> Result<Outcome, Failure> {
    if args.table.is_some() {
        return Err(Failure::TableOfEllipses { path: path.into() });
    }
    let wrong = |source| Failure::Wheelset { path: path.into(), source: Box::new(source) };
    let mut case = read(path)?;
    if let Some(name) = &args.theory {
        let name = TheorySpec::named(name)?.facts().name;
        case.theory = theory_spec(name, &args.options).map_err(Failure::Option)?;
    }
    let solver = case.solver().map_err(wrong)?;
    let table = Table::open(args.input.as_deref())?;
    let places = Places::find(&table)?;
    let appended = [&ANSWERS[..], &["status", "message"]].concat();
    free(&table, &appended)?;
    if let Some(out) = &args.out {
        case.sources().ensure_not_overwritten(out)?;
    }
    case.notes.iter().for_each(say_found);
    say_left_out(&case, "rows");
    let differs = case.friction.as_ref().is_some_and(|[left, right]| left != right)
        || case.guard_friction.iter().any(Option::is_some);
    if places.friction.is_some() && differs {
        say(
            "note: the column friction holds on all rails, in place of the different ones of the file",
        );
    }
    let answers = |rows: &[ByteRecord]| {
        Ok(rows.par_iter().map(|row| places.answer(row, &case, &solver)).collect())
    };
    let tally = write_answers(args, table, &appended, None, answers, |out, row, answer| {
        out.write_answer(row, answer)
    })?;
    Ok(tally.outcome())
}

impl Places {
    fn find(table: &Table) -> Result<Self, Failure> {
        let input = |source| Failure::Columns { input: table.name.clone(), source };
        let mut asked = [None; ASKED.len()];
        for (place, name) in asked.iter_mut().zip(ASKED) {
            *place = place_of(&table.header, name).map_err(input)?;
        }
        let friction = place_of(&table.header, FRICTION).map_err(input)?;
        let mut place = [None; 2];
        for (place, name) in place.iter_mut().zip(PLACE) {
            *place = place_of(&table.header, name).map_err(input)?;
        }
        let others = place.iter().chain(&asked);
        if friction.is_none() && others.into_iter().all(Option::is_none) {
            let known = format!("{}, {FRICTION}, {}", ASKED.join(", "), PLACE.join(", "));
            return Err(input(ColumnError::NoneVaries { known, found: names(&table.header) }));
        }
        let known: Vec<_> = ASKED.into_iter().chain([FRICTION]).chain(PLACE).collect();
        tell_misspelt(&table.header, &known);
        tell_of_file(&table.header, &OF_FILE);
        Ok(Self { asked, friction, place, count: table.header.len() })
    }

    /// An empty field is the wheelset's own.
    fn answer(
        &self,
        row: &ByteRecord,
        case: &WheelsetCase,
        solver: &WheelsetSolver<'_>,
    ) -> Result<RowAnswer, RowError> {
        if row.len() != self.count {
            return Err(NoCase::FieldCount { found: row.len(), expected: self.count }.into());
        }
        let number = |name, place: Option<usize>| match place.map(|place| &row[place]) {
            Some(field) if !field.trim_ascii().is_empty() => {
                let value = parse(name, field)?;
                let invalid = InvalidValue { quantity: name, value, valid: "finite" };
                if value.is_finite() { Ok(value) } else { Err(NoCase::from(invalid)) }
            }
            _ => Ok(f64::NAN),
        };
        let mut asked = [f64::NAN; ASKED.len()];
        for ((asked, name), place) in asked.iter_mut().zip(ASKED).zip(self.asked) {
            *asked = number(name, place)?;
        }
        if asked[AXLE_LOAD] == 0.0 {
            return Ok(no_contact());
        }
        let friction = number(FRICTION, self.friction)?;
        let (stance, travel) = case.asked(&asked)?;
        let [s, pitch] = [0, 1].map(|k: usize| number(PLACE[k], self.place[k]));
        let (s, pitch) = (s?, pitch?);
        let elsewhere;
        let solver = if s.is_nan() && pitch.is_nan() {
            solver
        } else {
            elsewhere = case.place(s, pitch)?;
            &solver.on(&elsewhere)
        };
        let solved = if friction.is_nan() {
            solver.solve(&stance, &travel)
        } else if friction > 0.0 {
            solver.with_friction(friction).solve(&stance, &travel)
        } else {
            let invalid = InvalidValue { quantity: FRICTION, value: friction, valid: "positive" };
            return Err(NoCase::from(invalid).into());
        };
        let solved = solved.map_err(WheelsetFileError::from)?;
        let numbers = solved.answers().to_vec();
        let message = wheelset_caution_words(&solved).join("; ");
        Ok(RowAnswer { numbers, status: solved.status(), message })
    }
}

/// No load, no force; where the wheels hang nothing tells.
fn no_contact() -> RowAnswer {
    let mut numbers = vec![0.0; ANSWERS.len()];
    numbers[18..].fill(f64::NAN);
    let message = Caution::Status(Status::NoContact).to_string();
    RowAnswer { numbers, status: Status::NoContact, message }
}
