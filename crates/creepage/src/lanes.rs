//! Several numbers at once, in plain arithmetic that compiles to SIMD: logarithms good to 1e-15, others
//! to 1e-11.

// So that all is compiled for each kind of processor.
#![allow(clippy::inline_always)]

/// Numbers that are computed together.
pub(crate) const LANES: usize = 8;

/// As many numbers.
pub(crate) type Lanes = [f64; LANES];

/// One function of all.
#[inline(always)]
pub(crate) fn each(f: impl Fn(usize) -> f64) -> Lanes {
    let mut out = [0.0; LANES];
    for (l, out) in out.iter_mut().enumerate() {
        *out = f(l);
    }
    out
}

/// Natural logarithm of a positive number that is neither tiny nor infinite.
///
/// With `m` between `1/sqrt 2` and `sqrt 2`, `ln m = 2 (z + z^3/3 + z^5/5 + ...)`,
/// `z = (m - 1)/(m + 1)`.
#[inline(always)]
pub(crate) fn ln(x: f64) -> f64 {
    const ONE: u64 = 0x3FF0_0000_0000_0000;
    const ROOT_OF_HALF: u64 = 0x3FE6_A09E_667F_3BCD;
    // 2^52: a number with a small whole number in its last bits.
    const WHOLE: u64 = 0x4330_0000_0000_0000;
    const OFFSET: f64 = 4_503_599_627_370_496.0 + 1023.0;
    let exponent = x.to_bits().wrapping_add(ONE - ROOT_OF_HALF) >> 52;
    let mantissa = f64::from_bits(x.to_bits().wrapping_sub(exponent << 52).wrapping_add(ONE));
    let power = f64::from_bits(exponent | WHOLE) - OFFSET;
    let z = (mantissa - 1.0) / (mantissa + 1.0);
    let q = z * z;
    let end = 1.0 / 15.0 + q * (1.0 / 17.0 + q * (1.0 / 19.0));
    let tail = 1.0 / 9.0 + q * (1.0 / 11.0 + q * (1.0 / 13.0 + q * end));
    let series = 1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q * tail)));
    power * std::f64::consts::LN_2 + 2.0 * z * series
}

/// Exponential function of a number below some hundreds.
#[inline(always)]
pub(crate) fn exp(x: f64) -> f64 {
    // 1.5 times 2^52: adding it rounds to a whole number, which its last bits then hold.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    const ONE: u64 = 0x3FF0_0000_0000_0000;
    let rounded = x * std::f64::consts::LOG2_E + ROUND;
    let r = x - (rounded - ROUND) * std::f64::consts::LN_2;
    let power = f64::from_bits((rounded.to_bits() << 52).wrapping_add(ONE));
    let tail = 1.0 / 120.0
        + r * (1.0 / 720.0 + r * (1.0 / 5040.0 + r * (1.0 / 40320.0 + r * (1.0 / 362_880.0))));
    power * (1.0 + r * (1.0 + r * (0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * tail)))))
}

/// Sine of an angle of at most a right one.
#[inline(always)]
pub(crate) fn sin(x: f64) -> f64 {
    let q = -x * x;
    let tail = 1.0 / 39_916_800.0 + q * (1.0 / 6_227_020_800.0 + q * (1.0 / 1_307_674_368_000.0));
    let middle = 1.0 / 120.0 + q * (1.0 / 5040.0 + q * (1.0 / 362_880.0 + q * tail));
    x * (1.0 + q * (1.0 / 6.0 + q * middle))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_the_library_functions() {
        for i in 1..4000 {
            let x = f64::from(i) * 5e-3;
            for x in [x, 1e-9 * x, 1e9 * x] {
                assert!((ln(x) - x.ln()).abs() < 1e-15 * x.ln().abs().max(1.0), "{x}");
            }
            assert!((exp(x - 10.0) / (x - 10.0).exp() - 1.0).abs() < 1e-11, "{x}");
            let angle = (x / 20.0 - 0.5) * std::f64::consts::PI;
            assert!((sin(angle) - angle.sin()).abs() < 1e-11, "{angle}");
        }
    }
}
