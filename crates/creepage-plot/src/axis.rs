//! One axis of a panel: range, numbers and name.

use crate::format::{fixed, floor_log10, round_below};
use crate::label::Label;

/// A linear axis.
#[derive(Debug, Clone)]
pub struct Axis {
    pub(crate) range: [f64; 2],
    label: Label,
    ticks: Option<Vec<(f64, String)>>,
    pub(crate) is_shared: bool,
}

impl Axis {
    /// From the left or the bottom to the right or the top; the first number may be the larger.
    /// Round numbers are put on it.
    #[must_use]
    pub const fn new(range: [f64; 2], label: Label) -> Self {
        Self { range, label, ticks: None, is_shared: false }
    }

    /// The same with these numbers, each with its text.
    #[must_use]
    pub fn ticks(self, ticks: Vec<(f64, String)>) -> Self {
        Self { ticks: Some(ticks), ..self }
    }

    /// The same without numbers and name: those of the panel below it are its own.
    #[must_use]
    pub fn shared(self) -> Self {
        Self { is_shared: true, ..self }
    }

    pub(crate) const fn label(&self) -> &Label {
        &self.label
    }

    /// Where `value` lies: 0 at the start, 1 at the end.
    pub(crate) fn share(&self, value: f64) -> f64 {
        let [from, to] = self.range;
        (value - from) / (to - from)
    }

    /// Units of the axis over its length.
    pub(crate) fn span(&self) -> f64 {
        (self.range[1] - self.range[0]).abs()
    }

    pub(crate) fn numbers(&self) -> Vec<(f64, String)> {
        let [low, high] = [self.range[0].min(self.range[1]), self.range[0].max(self.range[1])];
        self.ticks.clone().unwrap_or_else(|| round_numbers(low, high))
    }
}

/// The round numbers of a range in 4 to 10 steps, each with its text.
fn round_numbers(low: f64, high: f64) -> Vec<(f64, String)> {
    let span = high - low;
    let step = if span > 0.0 && span.is_finite() { round_below(0.25 * span) } else { 1.0 };
    // Rounding must not lose a tick at an end.
    let first = (low / step - 1e-9).ceil();
    let count = (high / step + 1e-9).floor() - first;
    let decimals = usize::try_from(-floor_log10(step * (1.0 + 1e-9))).unwrap_or(0);
    let at = |k: f64| (first + k) * step;
    let steps = (0_u8..=20).map(f64::from).take_while(|k| *k <= count);
    steps.map(|k| (at(k), fixed(at(k), decimals))).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn texts(low: f64, high: f64) -> Vec<String> {
        round_numbers(low, high).into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(texts(0.0, 1.0), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(
            texts(-3.5, 0.0),
            ["-3.5", "-3.0", "-2.5", "-2.0", "-1.5", "-1.0", "-0.5", "0.0"]
        );
        assert_eq!(texts(-21.0, 24.0), ["-20", "-10", "0", "10", "20"]);
    }

    proptest! {
        #[test]
        fn a_few_ticks_within_any_range(from in -1e3..1e3_f64, span in 1e-3..1e3_f64) {
            let axis = Axis::new([from, from + span], Label::default());
            let places: Vec<_> = axis.numbers().iter().map(|(value, _)| axis.share(*value)).collect();
            prop_assert!((4..=11).contains(&places.len()), "{places:?}");
            // The tolerance for a tick at the end, some steps out of ten.
            prop_assert!(places.iter().all(|place| (-1e-6..=1.0 + 1e-6).contains(place)));
        }
    }
}
