//! Cases at random, the same on every machine.

/// A small generator of random numbers, the same on every machine.
pub(crate) struct Random(u64);

impl Random {
    /// Not from zero.
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// Of any size between the two, and of either sign.
    pub(crate) fn of_any_size(&mut self, low: f64, high: f64) -> f64 {
        let sign = if self.uniform() < 0.5 { -1.0 } else { 1.0 };
        sign * self.between(low.ln(), high.ln()).exp()
    }
}
