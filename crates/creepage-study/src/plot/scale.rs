//! One axis of a panel: range, numbers and name.

use crate::axis::Axis;
use crate::label::Label;

/// A linear axis.
#[derive(Debug, Clone)]
pub struct Scale {
    range: [f64; 2],
    label: Label,
    ticks: Option<Vec<(f64, String)>>,
}

impl Scale {
    /// From the left or the bottom to the right or the top; the first number may be the larger.
    /// Round numbers are put on it.
    #[must_use]
    pub const fn new(range: [f64; 2], label: Label) -> Self {
        Self { range, label, ticks: None }
    }

    /// The same with these numbers, each with its text.
    #[must_use]
    pub fn ticks(self, ticks: Vec<(f64, String)>) -> Self {
        Self { ticks: Some(ticks), ..self }
    }

    pub(super) const fn label(&self) -> &Label {
        &self.label
    }

    /// Where `value` lies: 0 at the start, 1 at the end.
    pub(super) fn share(&self, value: f64) -> f64 {
        let [from, to] = self.range;
        (value - from) / (to - from)
    }

    /// Units of the axis over its length.
    pub(super) fn span(&self) -> f64 {
        (self.range[1] - self.range[0]).abs()
    }

    pub(super) fn numbers(&self) -> Vec<(f64, String)> {
        let [low, high] = [self.range[0].min(self.range[1]), self.range[0].max(self.range[1])];
        self.ticks.clone().unwrap_or_else(|| Axis::new(low, high).ticks().collect())
    }
}
