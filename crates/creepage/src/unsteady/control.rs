//! Step size control: steps are as long as the forces go on nearly as they did.

/// Result of a step, as far as its length matters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Watched {
    /// In parts of the present `mu N`.
    pub force: [f64; 3],
    /// Creepages that prescribed forces ask for; zero where the creepage is prescribed.
    pub found: [f64; 3],
}

/// Trend of the results over the last step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Trend {
    pub watched: Watched,
    /// Change of the force over distance in the last step, after the first.
    pub rate: Option<[f64; 3]>,
}

/// Step size controller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Control {
    pub next: f64,
    pub trend: Option<Trend>,
    pub semi_axis: f64,
}

/// Largest difference of a force from the straight continuation, in parts of `mu N`.
const TOLERANCE: f64 = 3e-3;
/// A step is taken again where the difference is so many times larger.
const TOO_LARGE: f64 = 4.0;
/// Largest change of a creepage that is found: its mean over a step lags by half of it.
const CHANGE: f64 = 0.01;
const GROWTH: f64 = 1.5;
const SHRINKING: f64 = 0.3;
/// First and shortest step over the semi-axis.
const FIRST: f64 = 0.02;
const SHORTEST: f64 = 0.005;
/// Shortest step for the sake of a creepage: below, it shows how the border of adhesion crosses one
/// element after the other.
const SHORTEST_FOUND: f64 = 0.03;

impl Control {
    pub(crate) fn new(semi_axis: f64) -> Self {
        Self { next: FIRST * semi_axis, trend: None, semi_axis }
    }

    /// After a jump nothing goes on as it did.
    pub(crate) fn restart(&mut self) {
        self.next = self.next.min(FIRST * self.semi_axis);
        self.trend = None;
    }

    /// Length of the next of the equal steps that cover a distance, none longer than `longest`, and
    /// whether it is the last.
    pub(crate) fn length(&self, remaining: f64, longest: f64) -> (f64, bool) {
        let steps = (remaining / self.next.min(longest) - 1e-9).ceil().max(1.0);
        (remaining / steps, steps <= 1.0)
    }

    /// Judges a step by its result; false when it is to be taken again with a shorter one.
    pub(crate) fn accepts(&mut self, length: f64, watched: Watched) -> bool {
        let Some(Trend { watched: before, rate }) = self.trend else {
            self.trend = Some(Trend { watched, rate: None });
            return true;
        };
        let change = |k: usize| watched.force[k] - before.force[k];
        if let Some(rate) = rate {
            let off = largest(|k| change(k) - rate[k] * length);
            let shortest = SHORTEST * self.semi_axis;
            if off > TOO_LARGE * TOLERANCE && length > 1.001 * shortest {
                self.next = (0.4 * length).max(shortest);
                return false;
            }
            let by_force = (0.9 * (TOLERANCE / off).sqrt()).clamp(SHRINKING, GROWTH) * length;
            // A step that was cut to fit must not shorten those to come.
            let by_force = if by_force < length {
                by_force
            } else {
                (GROWTH * self.next).min(by_force.max(self.next))
            };
            let lag = largest(|k| watched.found[k] - before.found[k]) / CHANGE;
            let by_found = (length / lag.max(1e-6)).max(SHORTEST_FOUND * self.semi_axis);
            self.next = by_force.max(shortest).min(by_found);
        }
        let rate = std::array::from_fn(|k| change(k) / length);
        self.trend = Some(Trend { watched, rate: Some(rate) });
        true
    }
}

fn largest(of: impl Fn(usize) -> f64) -> f64 {
    (0..3).map(|k| of(k).abs()).fold(0.0, f64::max)
}
