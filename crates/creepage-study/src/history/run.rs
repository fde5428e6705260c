//! Run of a history: a row of results for each of its rows.

use creepage::unsteady::Rolled;

use super::case::RollCase;
use super::columns::History;
use super::error::HistoryError;
use super::progress::{Frame, Moment, Progress};
use super::roller::TransientSolver;

/// The columns of the results.
pub const HISTORY_COLUMNS: [&str; 12] = [
    "distance_m",
    "xi",
    "eta",
    "chi",
    "fx",
    "fy",
    "mz",
    "longitudinal_n",
    "lateral_n",
    "moment_n_m",
    "adhesion_share",
    "status",
];

/// Contacts that are kept for the pictures, beside the one at the start.
const FRAMES: usize = 100;

/// A history that is being rolled.
#[derive(Debug)]
pub struct HistoryRun<'a> {
    case: &'a RollCase,
    history: &'a History,
    rolling: TransientSolver,
    /// Corners of the elements under the nominal load, over the unit of length; none for FASTSIM.
    corners: Vec<[[f64; 2]; 4]>,
    done: usize,
    /// Dimensionless, in the starting state.
    start_force: [f64; 3],
    progress: Progress,
}

impl<'a> HistoryRun<'a> {
    /// Prepares the contact in its starting state.
    ///
    /// # Errors
    /// [`HistoryError::Contact`] when the contact cannot be prepared.
    pub fn new(case: &'a RollCase, history: &'a History) -> Result<Self, HistoryError> {
        let first = history.rows.first().ok_or(HistoryError::Empty)?;
        let mut rolling = case.prepared()?;
        let elements = rolling.elements().unwrap_or_default();
        let corners = elements.into_iter().map(|element| element.corners).collect();
        let start = case.start(&mut rolling, &first.motion).map_err(HistoryError::Contact)?;
        let start_force = start.components();
        let mut run = Self {
            case,
            history,
            rolling,
            corners,
            done: 0,
            start_force,
            progress: Progress::default(),
        };
        run.keep(0.0, first.motion.load);
        Ok(run)
    }

    /// Goes on after `done` rows from the bytes of [`HistoryRun::state`]; false when they are of no use.
    #[must_use]
    pub fn resume(&mut self, done: usize, bytes: &[u8]) -> bool {
        parts(bytes).is_some_and(|(saved, progress)| {
            let is_resumed = done == progress.moments.len()
                && done <= self.history.rows.len()
                && self.rolling.restore(saved).is_ok();
            if is_resumed {
                (self.done, self.progress) = (done, progress);
            }
            is_resumed
        })
    }

    /// Number of rows that are done.
    #[must_use]
    pub fn done(&self) -> usize {
        self.done
    }

    /// The state after the last row, for [`HistoryRun::resume`].
    #[must_use]
    pub fn state(&self) -> Vec<u8> {
        let saved = self.rolling.save();
        [&(saved.len() as u64).to_le_bytes(), &saved[..], &self.progress.to_bytes()].concat()
    }

    /// Rolls to the end of the next row: its distance (m) and what it leads to; `None` at the end.
    ///
    /// # Errors
    /// [`HistoryError::Row`]; none for a history that was read for the case.
    pub fn next_row(&mut self) -> Result<Option<(f64, Rolled)>, HistoryError> {
        let Some(row) = self.history.rows.get(self.done) else { return Ok(None) };
        let before = self.done.checked_sub(1).and_then(|last| self.history.rows.get(last));
        let length = row.distance - before.map_or(0.0, |row| row.distance);
        let rolled = self
            .case
            .roll(&mut self.rolling, length, &row.motion)
            .map_err(|error| HistoryError::in_row(self.done + 1)(error.into()))?;
        self.done += 1;
        self.progress.moments.push(Moment::new(row.distance, &rolled));
        if self.is_frame() {
            self.keep(row.distance, row.motion.load);
        }
        Ok(Some((row.distance, rolled)))
    }

    /// Whether the row just done is one of those evenly spread over the history.
    fn is_frame(&self) -> bool {
        let rows = self.history.rows.len();
        let frame = |done: usize| done * FRAMES.min(rows) / rows;
        frame(self.done) > frame(self.done - 1)
    }

    /// Keeps the contact as it is, for the pictures.
    fn keep(&mut self, distance: f64, load: f64) {
        let frame = self.rolling.elements().map(|all| Frame::new(distance, load.cbrt(), &all));
        self.progress.frames.extend(frame);
    }

    /// The numbers of one row in the order of [`HISTORY_COLUMNS`], all but the status.
    #[must_use]
    pub fn numbers(&self, distance: f64, rolled: &Rolled) -> [f64; 11] {
        let force = self.case.scaling.si_force(rolled.solution.force);
        let [xi, eta, chi] = rolled.creepage.components();
        let [fx, fy, mz] = rolled.solution.force.components();
        let (longitudinal, lateral, moment) = (force.longitudinal, force.lateral, force.moment);
        let share = rolled.adhesion_share;
        [distance, xi, eta, chi, fx, fy, mz, longitudinal, lateral, moment, share]
    }

    /// The results of one row as they stand in the table.
    #[must_use]
    pub fn record(&self, distance: f64, rolled: &Rolled) -> Vec<String> {
        let numbers = self.numbers(distance, rolled);
        let mut record: Vec<String> = numbers.iter().map(|number| format!("{number:?}")).collect();
        record.push(rolled.solution.status.name().into());
        record
    }

    pub(super) fn progress(&self) -> &Progress {
        &self.progress
    }

    /// Corners of the elements under the nominal load.
    pub(super) fn corners(&self) -> &[[[f64; 2]; 4]] {
        &self.corners
    }

    /// The force in the starting state, dimensionless.
    pub(super) fn start_force(&self) -> [f64; 3] {
        self.start_force
    }

    pub(super) fn history(&self) -> &History {
        self.history
    }

    pub(super) fn case(&self) -> &RollCase {
        self.case
    }
}

/// The two parts of a state: the contact's, and what has come of it so far.
fn parts(bytes: &[u8]) -> Option<(&[u8], Progress)> {
    let (length, rest) = bytes.split_first_chunk()?;
    let length = usize::try_from(u64::from_le_bytes(*length)).ok()?;
    let (saved, progress) = rest.split_at_checked(length)?;
    Some((saved, Progress::from_bytes(progress)?))
}
