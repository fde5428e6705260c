//! Number formatting for readers.

/// SI prefixes and their powers of ten.
const PREFIXES: [(i32, &str); 9] =
    [(-12, "p"), (-9, "n"), (-6, "µ"), (-3, "m"), (0, ""), (3, "k"), (6, "M"), (9, "G"), (12, "T")];

/// `value` to `digits` significant digits without trailing zeros: `0.25`, `1164`, `3.1e-7`.
#[must_use]
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return "-".into();
    }
    let exponential = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = exponential.split_once('e').unwrap_or((&exponential, "0"));
    match exponent.parse::<i32>() {
        Ok(power @ -4..=5) => {
            let places = power.unsigned_abs() as usize;
            let decimals = digits - 1;
            let decimals =
                if power < 0 { decimals + places } else { decimals.saturating_sub(places) };
            trim_zeros(&format!("{value:.decimals$}")).into()
        }
        _ => format!("{}e{exponent}", trim_zeros(mantissa)),
    }
}

fn trim_zeros(decimal: &str) -> &str {
    if decimal.contains('.') {
        decimal.trim_end_matches('0').trim_end_matches('.')
    } else {
        decimal
    }
}

/// `value` with an SI prefix before `unit`: `quantity(2.4e4, "N", 4)` is `24 kN`.
#[must_use]
pub fn quantity(value: f64, unit: &str, digits: usize) -> String {
    let scale = Scale::of(value, unit, digits);
    format!("{} {}", significant(value / scale.factor, digits), scale.unit)
}

/// The power of a thousand in which a column of like quantities is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Scale {
    /// What its numbers are divided by.
    pub factor: f64,
    /// The unit with its prefix.
    pub unit: String,
    decimals: usize,
}

impl Scale {
    /// The prefix that brings `largest` between 1 and 1000, and as many decimals as show it to
    /// `digits` significant digits.
    #[must_use]
    pub fn of(largest: f64, unit: &str, digits: usize) -> Self {
        let scaled = largest != 0.0 && largest.is_finite();
        // A rounded 999.96 belongs to the next prefix.
        let power = if scaled { floor_log10(largest.abs() * (1.0 + 5e-5)) } else { 0 };
        let group = (power.div_euclid(3) * 3).clamp(PREFIXES[0].0, PREFIXES[8].0);
        let prefix = PREFIXES.iter().find(|p| p.0 == group).map_or("", |p| p.1);
        Self {
            factor: 10f64.powi(group),
            unit: format!("{prefix}{unit}"),
            decimals: (digits - 1).saturating_sub(usize::try_from(power - group).unwrap_or(0)),
        }
    }

    /// `value` in this scale. What is nothing beside the scale is written as zero, unsigned.
    #[must_use]
    pub fn write(&self, value: f64) -> String {
        format!("{} {}", fixed(value / self.factor, self.decimals), self.unit)
    }
}

/// `value` to so many decimals, without a sign before zero.
#[must_use]
pub fn fixed(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return "-".into();
    }
    let text = format!("{value:.decimals$}");
    let zero = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
    if zero { text.trim_start_matches('-').into() } else { text }
}

/// The power of ten at or below `value > 0`.
#[must_use]
#[allow(clippy::cast_possible_truncation)] // a double's powers of ten lie within -324 and 308
pub fn floor_log10(value: f64) -> i32 {
    value.log10().floor() as i32
}

/// The largest of 1, 2 and 5 times a power of ten that does not exceed `limit > 0`.
#[must_use]
pub fn round_below(limit: f64) -> f64 {
    let power = 10f64.powi(floor_log10(limit));
    let step = [5.0, 2.0, 1.0].into_iter().find(|step| step * power <= limit * (1.0 + 1e-12));
    step.unwrap_or(1.0) * power
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn significant_digits_read_back(value in proptest::num::f64::NORMAL, digits in 1..9_usize) {
            // Beyond, what is rounded up is no number any more.
            prop_assume!(value.abs() < 1.5e308);
            let back: f64 = significant(value, digits).parse().unwrap();
            // Half a unit of the last digit, and the roundings of two conversions.
            let bound = 0.5 * 0.1_f64.powi(i32::try_from(digits).unwrap() - 1) + 1e-14;
            prop_assert!((back / value - 1.0).abs() <= bound, "{value} {back}");
        }

        #[test]
        fn any_number_can_be_written(value in any::<f64>(), digits in 1..9_usize) {
            let scale = Scale::of(value, "N", digits);
            for text in [significant(value, digits), quantity(value, "N", digits), scale.write(value)] {
                prop_assert!(!text.is_empty() && !text.contains("NaN") && !text.contains("inf"));
            }
        }

        #[test]
        fn round_numbers_lie_within_a_factor_below(limit in 1e-300..1e300_f64) {
            let round = round_below(limit);
            // The steps 1, 2, 5, 10 are at most a factor 2.5 apart.
            prop_assert!(round <= limit * (1.0 + 1e-11) && limit < 2.5 * round * (1.0 + 1e-11));
        }
    }

    #[test]
    fn significant_digits() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (0.001, "0.001"),
            (1164.27, "1164"),
            (0.624_93, "0.6249"),
            (-12.0, "-12"),
            (9.999_96, "10"),
            (1.234_4e-7, "1.234e-7"),
            (1e6, "1e6"),
            (123_456.0, "123456"),
            (f64::NAN, "-"),
        ] {
            assert_eq!(significant(value, 4), text, "{value}");
        }
    }

    #[test]
    fn quantities_take_the_prefix_that_fits() {
        for (value, text) in [
            (2.4e4, "24 kN"),
            (-1.5, "-1.5 N"),
            (999.96, "1 kN"),
            (3.21e-4, "321 µN"),
            (0.0, "0 N"),
            (7e-20, "7e-8 pN"),
        ] {
            assert_eq!(quantity(value, "N", 4), text);
        }
    }

    #[test]
    fn a_column_shares_its_scale() {
        let scale = Scale::of(24e3, "N", 4);
        assert_eq!(scale.write(-2_928.4), "-2.93 kN");
        assert_eq!(scale.write(-1e-9), "0.00 kN");
        assert_eq!(Scale::of(0.0, "N", 4).write(0.0), "0.000 N");
    }

    #[test]
    fn round_numbers_below() {
        for (limit, round) in [(7.3, 5.0), (0.049, 0.02), (1.0, 1.0), (2e3, 2e3)] {
            // One rounding of the power of ten.
            assert!((round_below(limit) / round - 1.0_f64).abs() < 1e-15);
        }
    }
}
