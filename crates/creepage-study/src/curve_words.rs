//! Labels of the curves' axis: names, symbols and units of creepage components.

use creepage_plot::Label;

use crate::curves::Component;

impl Component {
    pub(crate) fn words(self) -> &'static str {
        match self {
            Self::Longitudinal => "longitudinal creepage ",
            Self::Lateral => "lateral creepage ",
            Self::Spin => "spin ",
        }
    }

    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Self::Longitudinal => "ξ",
            Self::Lateral => "η",
            Self::Spin => "χ",
        }
    }

    /// Adds the symbol of the quantity with its dimension.
    pub(crate) fn si_symbol(self, label: Label) -> Label {
        match self {
            Self::Longitudinal => label.indexed("υ", "x"),
            Self::Lateral => label.indexed("υ", "y"),
            Self::Spin => label.symbol("φ"),
        }
    }

    pub(crate) fn unit(self) -> &'static str {
        match self {
            Self::Longitudinal | Self::Lateral => "",
            Self::Spin => " rad/m",
        }
    }
}

/// A power as raised digits.
pub(crate) fn raised(power: i32) -> String {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raise = |character: char| {
        let digit = character.to_digit(10).and_then(|digit| usize::try_from(digit).ok());
        digit.and_then(|digit| digits.get(digit)).copied().unwrap_or('⁻')
    };
    power.to_string().chars().map(raise).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_raised() {
        assert_eq!([raised(-3), raised(12)], ["⁻³", "¹²"]);
    }
}
