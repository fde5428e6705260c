//! A ruled range of numbers.

use crate::format::{fixed, floor_log10, round_below};

/// A range, and round numbers in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axis {
    pub(crate) from: f64,
    pub(crate) to: f64,
    step: f64,
}

impl Axis {
    /// The range from `from` to `to`, ruled with 4 to 10 steps.
    pub(crate) fn new(from: f64, to: f64) -> Self {
        let span = (to - from).abs();
        let step = if span > 0.0 && span.is_finite() { round_below(0.25 * span) } else { 1.0 };
        Self { from, to, step }
    }

    /// The same range in units of `unit`.
    pub(crate) fn scaled(self, unit: f64) -> Self {
        Self::new(self.from / unit, self.to / unit)
    }

    /// Where `value` lies: 0 at the start, 1 at the end.
    pub(crate) fn share(&self, value: f64) -> f64 {
        (value - self.from) / (self.to - self.from)
    }

    /// The round numbers, each with its text.
    pub(crate) fn ticks(&self) -> impl Iterator<Item = (f64, String)> {
        // Rounding must not lose a tick at an end.
        let first = (self.from / self.step - 1e-9).ceil();
        let count = (self.to / self.step + 1e-9).floor() - first;
        let decimals = usize::try_from(-floor_log10(self.step * (1.0 + 1e-9))).unwrap_or(0);
        let step = self.step;
        (0_u8..=20).map(f64::from).take_while(move |k| *k <= count).map(move |k| {
            let value = (first + k) * step;
            (value, fixed(value, decimals))
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn texts(from: f64, to: f64) -> Vec<String> {
        Axis::new(from, to).ticks().map(|(_, text)| text).collect()
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
            let axis = Axis::new(from, from + span);
            let places: Vec<_> = axis.ticks().map(|(value, _)| axis.share(value)).collect();
            prop_assert!((4..=11).contains(&places.len()), "{places:?}");
            // The tolerance for a tick at the end, some steps out of ten.
            prop_assert!(places.iter().all(|place| (-1e-6..=1.0 + 1e-6).contains(place)));
        }
    }
}
