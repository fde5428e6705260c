//! Elementary functions of several numbers at once, in plain arithmetic that compiles to SIMD: logarithms good to 1e-15,
//! others to 1e-11.

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

/// `a b + c`, rounded once if `FUSED`: fast where the processor does so, else very slow.
#[inline(always)]
pub(crate) fn multiply_add<const FUSED: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

/// Natural logarithm of a positive number that is neither tiny nor infinite.
#[inline(always)]
pub(crate) fn ln(x: f64) -> f64 {
    ln_of_ratio::<false>(x, 1.0)
}

/// Natural logarithm of `a/b`, of positive numbers that are neither tiny nor huge.
///
/// With `a/(2^k b)` between 2/3 and 3/2, its logarithm is `2 (z + z^3/3 + z^5/5 + ...)`,
/// `z = (a - 2^k b)/(a + 2^k b)`; what follows `z` is a polynomial, equal to that at Chebyshev's points.
#[inline(always)]
pub(crate) fn ln_of_ratio<const FUSED: bool>(a: f64, b: f64) -> f64 {
    const ONE: u64 = 0x3FF0_0000_0000_0000;
    const HALF: u64 = 1 << 51;
    // 2^52: a number with a small whole number in its last bits.
    const WHOLE: u64 = 0x4330_0000_0000_0000;
    const OFFSET: f64 = 4_503_599_627_370_496.0 + 1023.0;
    const SERIES: [f64; 7] = [
        0.333_333_333_333_334_8,
        0.199_999_999_996_469_4,
        0.142_857_144_249_310_04,
        0.111_110_905_642_842_65,
        0.090_923_489_931_172_36,
        0.076_407_864_241_297_25,
        0.075_688_654_126_584_67,
    ];
    // Bits of a positive number rise nearly as its logarithm.
    let exponent = a.to_bits().wrapping_sub(b.to_bits()).wrapping_add(ONE + HALF) >> 52;
    let power = f64::from_bits(exponent | WHOLE) - OFFSET;
    let a = f64::from_bits(a.to_bits().wrapping_sub(exponent << 52).wrapping_add(ONE));
    let z = (a - b) / (a + b);
    let q = z * z;
    let [c0, c1, c2, c3, c4, c5, c6] = SERIES;
    let end = multiply_add::<FUSED>(q, multiply_add::<FUSED>(q, c6, c5), c4);
    let middle = multiply_add::<FUSED>(q, multiply_add::<FUSED>(q, end, c3), c2);
    let series = q * multiply_add::<FUSED>(q, multiply_add::<FUSED>(q, middle, c1), c0);
    let twice = 2.0 * z;
    multiply_add::<FUSED>(
        power,
        std::f64::consts::LN_2,
        multiply_add::<FUSED>(twice, series, twice),
    )
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

/// The angle of the vector `(x, y)` to the first axis, between `-pi` and `pi`; zero without length.
///
/// With `b` the longer component and `a` the shorter, `atan(a/b) = pi/8 + atan((a - t b)/(b + t a))`,
/// `t = tan(pi/8)`; the last is a polynomial, equal to it at Chebyshev's points.
#[inline(always)]
pub(crate) fn arctangent(y: f64, x: f64) -> f64 {
    const TAN: f64 = std::f64::consts::SQRT_2 - 1.0;
    const SERIES: [f64; 11] = [
        -0.333_333_333_333_333_3,
        0.199_999_999_999_955_2,
        -0.142_857_142_846_665_42,
        0.111_111_110_152_563_61,
        -0.090_909_045_781_239_03,
        0.076_921_831_908_260_87,
        -0.066_645_114_473_819_48,
        0.058_581_489_128_022_1,
        -0.050_854_497_379_402_6,
        0.039_231_658_295_587_19,
        -0.019_176_887_119_062_257,
    ];
    let (rise, run) = (y.abs(), x.abs());
    let is_steep = rise > run;
    let (a, b) = (if is_steep { run } else { rise }, if is_steep { rise } else { run });
    let t = (a - TAN * b) / (b + TAN * a).max(f64::MIN_POSITIVE);
    let q = t * t;
    let mut series = SERIES[10];
    for k in (0..10).rev() {
        series = series * q + SERIES[k];
    }
    let first = std::f64::consts::FRAC_PI_8 + (t + t * q * series);
    // Without length the division gives nothing, and neither is there an angle.
    let first = if b > 0.0 { first } else { 0.0 };
    let first = if is_steep { std::f64::consts::FRAC_PI_2 - first } else { first };
    let first = if x < 0.0 { std::f64::consts::PI - first } else { first };
    first.copysign(y)
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
                let (found, expected) = (ln_of_ratio::<true>(x, 7.3 / x), (x * x / 7.3).ln());
                assert!((found - expected).abs() < 1e-15 * expected.abs().max(1.0), "{x}");
            }
            assert!((exp(x - 10.0) / (x - 10.0).exp() - 1.0).abs() < 1e-11, "{x}");
            let turned = 0.01 * x * f64::from(i);
            let (y, x) = turned.sin_cos();
            assert!((arctangent(y, x) - y.atan2(x)).abs() < 1e-15, "{x} {y}");
            let angle = (f64::from(i) * 2.5e-4 - 0.5) * std::f64::consts::PI;
            assert!((sin(angle) - angle.sin()).abs() < 1e-11, "{angle}");
        }
        // Rounding of pi/8, from which the rest is taken.
        assert!(arctangent(0.0, 0.0).abs() + arctangent(0.0, 1.0).abs() < 2e-16);
    }
}
