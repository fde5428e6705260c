//! Animation of worn profiles over the distance: one picture a stop.

use creepage_plot::{Frames, Label, Pen, Sheet};
use creepage_rail::Role;

use super::run::Wear;

/// How long it plays, and the shortest and longest time of one picture (milliseconds).
const DURATION: f64 = 6000.0;
const EACH: [f64; 2] = [60.0, 800.0];
/// How long the last picture stays (milliseconds).
const LAST: u16 = 2000;

/// The stops of a run one after the other, from the first with wear.
pub(super) struct Animation(Vec<Sheet>);

impl Animation {
    /// `None` where no body of this kind wears, or with one stop alone.
    pub(super) fn new(wear: &Wear, role: Role) -> Option<Self> {
        let worn = wear.stops.get(1..).filter(|stops| stops.len() > 1)?;
        let sheets = worn.iter().map(|stop| {
            let sheet = wear.sheet(role, stop, &[stop])?;
            Some(sheet.key(Pen::of(0), stop.way(role)).key(Pen::THIN, Label::new("new")))
        });
        sheets.collect::<Option<_>>().map(Self)
    }
}

impl Frames for Animation {
    fn count(&self) -> usize {
        self.0.len()
    }

    fn svg(&self, number: usize) -> String {
        self.0[number].svg()
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
    fn milliseconds(&self, number: usize) -> u16 {
        if number + 1 == self.count() {
            return LAST;
        }
        (DURATION / self.count() as f64).clamp(EACH[0], EACH[1]) as u16
    }
}
