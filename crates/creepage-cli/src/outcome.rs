//! Outcome of a command that did its work.

/// Quality of the output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// All of it can be used.
    Done,
    /// Some of it says of itself that it cannot be used.
    Doubtful,
}

impl Outcome {
    /// That of two works together.
    pub(crate) fn or(self, other: Self) -> Self {
        if self == Self::Done { other } else { self }
    }
}
