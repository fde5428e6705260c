//! The three forms of number on the page (5.28): floating, fixed, integer.

/// Number format of the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Numbers {
    /// `3.10202512545e-3`
    Modern,
    /// `+.310202512545- 2`, and signs apart from the number.
    Of1967,
}

impl Numbers {
    /// Twelve digits and an exponent.
    pub(super) fn floating(self, value: f64) -> String {
        match self {
            Self::Modern => format!("{value:>19.11e}"),
            Self::Of1967 => floating_1967(value),
        }
    }

    /// A fixed number of decimals.
    pub(super) fn fixed(self, value: f64, decimals: usize) -> String {
        match self {
            Self::Modern => format!("{value:>10.decimals$}"),
            Self::Of1967 => {
                let sign = if value < 0.0 { '-' } else { ' ' };
                format!("{sign}{:>8.decimals$}", value.abs())
            }
        }
    }
}

/// Sign, twelve digits behind the point, and the power of ten: `+.310202512545- 2`.
fn floating_1967(value: f64) -> String {
    let sign = if value < 0.0 { '-' } else { '+' };
    let scientific = format!("{:.11e}", value.abs());
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    let exponent = if value == 0.0 { 0 } else { exponent.parse::<i32>().unwrap_or(0) + 1 };
    let exponent_sign = if exponent < 0 { '-' } else { '+' };
    format!("{sign}.{digits}{exponent_sign}{:>2}", exponent.abs())
}

/// An angle from the rolling direction (degrees), from -90 up to 270 as on the page.
pub(super) fn angle([x, y]: [f64; 2]) -> f64 {
    let angle = y.atan2(x).to_degrees();
    if angle < -90.0 { angle + 360.0 } else { angle }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floating_numbers_as_printed_in_1967() {
        for (value, print) in [
            (0.003_102_025_125_45, "+.310202512545- 2"),
            (-12.386_520_890_8, "-.123865208908+ 2"),
            (0.825_463_503_290, "+.825463503290+ 0"),
            (0.0, "+.000000000000+ 0"),
        ] {
            assert_eq!(Numbers::Of1967.floating(value), print);
        }
    }

    #[test]
    fn angles_lie_between_minus_90_and_270() {
        assert!((angle([-1.0, -1.0]) - 225.0).abs() < 1e-12);
        assert!((angle([1.0, -1.0]) + 45.0).abs() < 1e-12);
    }
}
