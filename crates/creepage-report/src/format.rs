//! Numbers as people read them.

/// SI prefixes and their powers of ten.
const PREFIXES: [(i32, &str); 9] =
    [(-12, "p"), (-9, "n"), (-6, "µ"), (-3, "m"), (0, ""), (3, "k"), (6, "M"), (9, "G"), (12, "T")];

/// `value` to `digits` significant digits without trailing zeros: `0.25`, `1164`, `3.1e-7`.
pub(crate) fn significant(value: f64, digits: usize) -> String {
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
            let decimals = usize::try_from(digits as i32 - 1 - power).unwrap_or(0);
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
pub(crate) fn quantity(value: f64, unit: &str, digits: usize) -> String {
    let scale = Scale::of(value, unit, digits);
    format!("{} {}", significant(value / scale.factor, digits), scale.unit)
}

/// The power of a thousand in which a column of like quantities is written.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scale {
    factor: f64,
    unit: String,
    decimals: usize,
}

impl Scale {
    /// The prefix that brings `largest` between 1 and 1000, and as many decimals as show it to
    /// `digits` significant digits.
    pub(crate) fn of(largest: f64, unit: &str, digits: usize) -> Self {
        let power =
            if largest == 0.0 || !largest.is_finite() { 0.0 } else { largest.abs().log10() };
        // A rounded 999.96 belongs to the next prefix.
        let power = (power + 2e-5).floor() as i32;
        let group = (power.div_euclid(3) * 3).clamp(PREFIXES[0].0, PREFIXES[8].0);
        let prefix = PREFIXES.iter().find(|p| p.0 == group).map_or("", |p| p.1);
        Self {
            factor: 10f64.powi(group),
            unit: format!("{prefix}{unit}"),
            decimals: (digits - 1).saturating_sub(usize::try_from(power - group).unwrap_or(0)),
        }
    }

    /// `value` in this scale. What is nothing beside the scale is written as zero, unsigned.
    pub(crate) fn write(&self, value: f64) -> String {
        format!("{} {}", fixed(value / self.factor, self.decimals), self.unit)
    }
}

/// `value` to so many decimals, without a sign before zero.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return "-".into();
    }
    let text = format!("{value:.decimals$}");
    let zero = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
    if zero { text.trim_start_matches('-').into() } else { text }
}

/// The largest of 1, 2 and 5 times a power of ten that does not exceed `limit > 0`.
pub(crate) fn round_below(limit: f64) -> f64 {
    let power = 10f64.powi(limit.log10().floor() as i32);
    let step = [5.0, 2.0, 1.0].into_iter().find(|step| step * power <= limit * (1.0 + 1e-12));
    step.unwrap_or(1.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert_eq!([7.3, 0.049, 1.0, 2e3].map(round_below), [5.0, 0.02, 1.0, 2e3]);
    }
}
