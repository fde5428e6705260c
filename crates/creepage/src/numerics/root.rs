//! The root of a rising function of one number: Newton's method or chords, kept in a bracket; and bisection.

/// Newton's method kept in a bracket, one step at a time: the caller evaluates the function at [`Root::at`], and hands
/// its value to [`Root::next`].
///
/// ```
/// use creepage::numerics::Root;
/// let mut root = Root::new(2.0, [0.0, 10.0]);
/// while (root.at.exp() - 3.0).abs() > 1e-12 {
///     root.next(root.at.exp() - 3.0, Some(root.at.exp()));
/// }
/// assert!((root.at - 3f64.ln()).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Root {
    /// Where the function is wanted next.
    pub at: f64,
    bracket: [f64; 2],
    last: Option<[f64; 2]>,
    slope: Option<f64>,
    steps: usize,
}

impl Root {
    /// Steps after which nothing but halving is trusted.
    const TRUSTED: usize = 12;

    /// The function is negative at the first end of the bracket and positive at the second.
    #[must_use]
    pub fn new(start: f64, bracket: [f64; 2]) -> Self {
        let [low, high] = bracket;
        let at = if start > low && start < high { start } else { low.midpoint(high) };
        Self { at, bracket, last: None, slope: None, steps: 0 }
    }

    /// Moves on from the function's value, infinite where only its sign is known, and its slope,
    /// where that is known; by chords else. A slope that is no positive number halves the bracket.
    pub fn next(&mut self, value: f64, slope: Option<f64>) {
        self.bracket[usize::from(value > 0.0)] = self.at;
        let chord = self.last.map(|[at, before]| (value - before) / (self.at - at));
        let slope = slope.or(chord).filter(|slope| *slope > 0.0 && slope.is_finite());
        (self.last, self.slope) = (Some([self.at, value]), slope);
        self.steps += 1;
        let [low, high] = self.bracket;
        let newton = slope.map_or(f64::NAN, |slope| self.at - value / slope);
        let is_inside = newton > low && newton < high && self.steps < Self::TRUSTED;
        self.at = if is_inside { newton } else { low.midpoint(high) };
    }

    /// The same where a first slope is only guessed: chords take over.
    pub fn next_by_chord(&mut self, value: f64, guess: f64) {
        let slope = self.last.is_none().then_some(guess);
        self.next(value, slope);
    }

    /// The slope of the last step, unless that halved the bracket.
    #[must_use]
    pub fn slope(&self) -> Option<f64> {
        self.slope
    }

    /// Whether the bracket has no room left, of the size `least`: the function jumps there.
    #[must_use]
    pub fn is_spent(&self, least: f64) -> bool {
        self.bracket[1] - self.bracket[0] < least
    }
}

/// Where a condition that holds at `from` and not at `to` ends, to `2^-rounds` of the stretch: the middle of what is left.
pub fn bisect(
    mut from: f64,
    mut to: f64,
    rounds: usize,
    mut holds: impl FnMut(f64) -> bool,
) -> f64 {
    for _ in 0..rounds {
        let middle = 0.5 * (from + to);
        *(if holds(middle) { &mut from } else { &mut to }) = middle;
    }
    0.5 * (from + to)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solve(start: f64, f: impl Fn(f64) -> f64, slope: impl Fn(f64) -> Option<f64>) -> (f64, u32) {
        let mut root = Root::new(start, [-10.0, 10.0]);
        for count in 0..200 {
            let (at, value) = (root.at, f(root.at));
            if value.abs() < 1e-12 || root.is_spent(1e-14) {
                return (at, count);
            }
            root.next(value, slope(at));
        }
        panic!("not found");
    }

    #[test]
    fn newton_and_chords_are_quick_on_smooth_functions() {
        let f = |x: f64| x.exp() - 3.0;
        let (at, count) = solve(2.0, f, |x| Some(x.exp()));
        assert!((at - 3f64.ln()).abs() < 1e-12 && count < 8, "{at} {count}");
        let (at, count) = solve(2.0, f, |_| None);
        assert!((at - 3f64.ln()).abs() < 1e-12 && count < 14, "{at} {count}");
    }

    #[test]
    fn flat_ends_jumps_and_bare_signs_end_in_halving() {
        let (at, _) = solve(9.0, |x| (3.0 * (x - 1.0)).tanh(), |_| None);
        assert!((at - 1.0).abs() < 1e-11);
        let (at, count) =
            solve(5.0, |x| if x < 2.0 { f64::NEG_INFINITY } else { 1.0 }, |_| Some(1.0));
        assert!((at - 2.0).abs() < 1e-12 && count < 80, "{at} {count}");
    }

    /// From above as from below; each round halves what is left.
    #[test]
    fn bisection_ends_where_a_condition_does() {
        for rounds in [5, 20, 60] {
            let below = bisect(0.0, 8.0, rounds, |x| x * x < 2.0);
            let above = bisect(8.0, 0.0, rounds, |x| x * x > 2.0);
            let left = 8.0 * 0.5_f64.powi(i32::try_from(rounds).unwrap()) + 1e-15;
            assert!((below - 2f64.sqrt()).abs() <= left, "{rounds} {below}");
            assert!((above - 2f64.sqrt()).abs() <= left, "{rounds} {above}");
        }
    }
}
