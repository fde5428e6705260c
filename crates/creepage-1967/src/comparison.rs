//! Comparison of one printed value or claim of the thesis with the computed one, and its verdict.

/// Verdict of a comparison of print and computed value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// Rounded as the print is, ours is the print; or what is claimed holds.
    Agrees,
    /// Not to the digit, but within a tolerance that the note gives a reason for.
    Close,
    /// The print is wrong; the note says how that is known.
    Misprint,
    /// It is not found; the note says why.
    NotReproduced,
    /// There is nothing to compare with: the thesis has the experiment's points in a picture only.
    NoData,
}

impl Verdict {
    /// In words, as in the table of agreement.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::Close => "close",
            Self::Misprint => "misprint",
            Self::NotReproduced => "not reproduced",
            Self::NoData => "no data",
        }
    }
}

/// A line of the table of agreement.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// What is compared.
    pub quantity: String,
    /// What was printed, in 1967's digits or words.
    pub printed: String,
    /// What is found today, to one digit more.
    pub ours: String,
    /// Ours less the print, where both are numbers.
    pub difference: Option<f64>,
    /// How they compare.
    pub verdict: Verdict,
    /// Why, where there is anything to say.
    pub note: String,
}

impl Comparison {
    /// A number with the digits as printed: it agrees when ours rounds to it.
    #[must_use]
    pub fn number(quantity: impl Into<String>, printed: &str, ours: f64) -> Self {
        let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let difference = printed.parse::<f64>().ok().map(|number| ours - number);
        // Half a unit of the last digit, and the rounding of decimal fractions.
        let half = 0.5 * 0.1_f64.powi(i32::try_from(decimals).unwrap_or(0)) * (1.0 + 1e-9);
        let agrees = difference.is_some_and(|difference| difference.abs() <= half);
        Self {
            quantity: quantity.into(),
            printed: printed.into(),
            ours: format!("{ours:.*}", decimals + 1),
            difference,
            verdict: if agrees { Verdict::Agrees } else { Verdict::NotReproduced },
            note: String::new(),
        }
    }

    /// Something said in words, or a bound: it agrees when it `holds`.
    #[must_use]
    pub fn claim(
        quantity: impl Into<String>,
        printed: impl Into<String>,
        ours: impl Into<String>,
        holds: bool,
    ) -> Self {
        Self {
            quantity: quantity.into(),
            printed: printed.into(),
            ours: ours.into(),
            difference: None,
            verdict: if holds { Verdict::Agrees } else { Verdict::NotReproduced },
            note: String::new(),
        }
    }

    /// Something said of an experiment whose numbers are not in the text.
    #[must_use]
    pub fn without_data(
        quantity: impl Into<String>,
        printed: impl Into<String>,
        ours: impl Into<String>,
        reason: &str,
    ) -> Self {
        let claim = Self::claim(quantity, printed, ours, false);
        Self { verdict: Verdict::NoData, note: reason.into(), ..claim }
    }

    /// Calls a number that does not agree close, when it is within `tolerance` of the print; the
    /// reason says why the print need not be met to the digit.
    #[must_use]
    pub fn within(mut self, tolerance: f64, reason: &str) -> Self {
        if self.verdict == Verdict::NotReproduced
            && self.difference.is_some_and(|difference| difference.abs() <= tolerance)
        {
            self.verdict = Verdict::Close;
            self.note = reason.into();
        }
        self
    }

    /// Calls what does not agree a misprint, for a reason found elsewhere.
    #[must_use]
    pub fn misprint(mut self, reason: &str) -> Self {
        if self.verdict == Verdict::NotReproduced {
            self.verdict = Verdict::Misprint;
            self.note = reason.into();
        }
        self
    }

    /// Why something is not reproduced; of no effect when it is.
    #[must_use]
    pub fn because(mut self, reason: &str) -> Self {
        if self.verdict == Verdict::NotReproduced {
            self.note = reason.into();
        }
        self
    }

    /// Adds a remark, whatever the verdict.
    #[must_use]
    pub fn remark(mut self, remark: &str) -> Self {
        let gap = if self.note.is_empty() { "" } else { "; " };
        self.note = format!("{}{gap}{remark}", self.note);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_agrees_when_it_rounds_to_the_print() {
        let verdict = |printed, ours| Comparison::number("", printed, ours).verdict;
        assert_eq!(verdict("4.22", 4.2193), Verdict::Agrees);
        assert_eq!(verdict("4.22", 4.2251), Verdict::NotReproduced);
        assert_eq!(verdict("7", 7.3), Verdict::Agrees);
        assert_eq!(verdict("-0.5", -0.5499), Verdict::Agrees);
        assert_eq!(verdict("not a number", 7.3), Verdict::NotReproduced);
        assert_eq!(verdict("0.1", f64::NAN), Verdict::NotReproduced);
    }

    #[test]
    fn notes_are_of_the_verdict() {
        let line = Comparison::number("", "1.0", 1.2);
        assert_eq!(line.clone().within(0.3, "why").verdict, Verdict::Close);
        assert_eq!(line.clone().within(0.1, "why").note, "");
        assert_eq!(line.misprint("known").because("?").note, "known");
        let right = Comparison::number("", "1.0", 1.0).within(0.3, "why").because("why");
        assert_eq!((right.verdict, &right.note[..]), (Verdict::Agrees, ""));
    }
}
