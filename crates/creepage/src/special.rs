//! The complete elliptic integrals of the theory, as functions of the axis ratio.

use std::f64::consts::{FRAC_PI_2, PI};

use ellip::cel;

/// The complete elliptic integrals (3.17) for modulus `e`, `g^2 = 1 - e^2`, with
/// `Delta = sqrt(1 - e^2 sin^2 psi)`, each integrated over `psi` from 0 to `pi/2`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CompleteIntegrals {
    /// `K`: 1 / Delta.
    pub k: f64,
    /// `E`: Delta.
    pub e: f64,
    /// `B`: cos^2 / Delta.
    pub b: f64,
    /// `C`: sin^2 cos^2 / Delta^3.
    pub c: f64,
    /// `D`: sin^2 / Delta.
    pub d: f64,
}

impl CompleteIntegrals {
    /// The integrals for the axis ratio `g` (minor over major), `0 < g <= 1`.
    ///
    /// Taking `g` and not `e` keeps full accuracy for slender ellipses.
    #[must_use]
    pub fn new(g: f64) -> Self {
        // Bulirsch's `cel` fails only for g = 0, which an ellipse excludes.
        let integral = |p, a, b| cel(g, p, a, b).unwrap_or(f64::NAN);
        let (b, d) = (integral(1.0, 1.0, 0.0), integral(1.0, 0.0, 1.0));
        Self { k: b + d, e: b + g * g * d, b, c: integral_c(g, b, d), d }
    }
}

/// `C = (D - B)/e^2` loses digits near the circle; there the midpoint rule, which converges
/// geometrically for a periodic integrand, takes over.
fn integral_c(g: f64, b: f64, d: f64) -> f64 {
    const MIDPOINTS: u32 = 48;
    if g < 0.5 {
        return (d - b) / ((1.0 - g) * (1.0 + g));
    }
    let mean = (0..MIDPOINTS)
        .map(|i| {
            let (sin, cos) = ((f64::from(i) + 0.5) * PI / f64::from(MIDPOINTS)).sin_cos();
            (sin * cos).powi(2) / (cos * cos + g * g * sin * sin).powf(1.5)
        })
        .sum::<f64>()
        / f64::from(MIDPOINTS);
    FRAC_PI_2 * mean
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(actual: f64, expected: f64) {
        assert!((actual / expected - 1.0).abs() < 1e-14, "{actual} differs from {expected}");
    }

    /// 40-digit arithmetic, rounded.
    #[test]
    fn reference_values() {
        for (g, [k, e, b, c, d]) in [
            (
                0.1,
                [
                    3.695_637_362_989_874_7,
                    1.015_993_545_025_224,
                    0.988_926_435_752_853_8,
                    1.735_135_849_984_007_3,
                    2.706_710_927_237_021,
                ],
            ),
            (
                0.5,
                [
                    2.156_515_647_499_643_4,
                    1.211_056_027_568_459_4,
                    0.895_902_820_924_731_6,
                    0.486_280_007_533_573_3,
                    1.260_612_826_574_911_7,
                ],
            ),
            (
                0.9,
                [
                    1.654_616_667_522_527,
                    1.493_290_108_131_207,
                    0.805_529_512_831_370_4,
                    0.229_250_746_630_453_72,
                    0.849_087_154_691_156_6,
                ],
            ),
        ] {
            let integrals = CompleteIntegrals::new(g);
            close(integrals.k, k);
            close(integrals.e, e);
            close(integrals.b, b);
            close(integrals.c, c);
            close(integrals.d, d);
        }
    }

    #[test]
    fn circle() {
        let circle = CompleteIntegrals::new(1.0);
        close(circle.k, FRAC_PI_2);
        close(circle.e, FRAC_PI_2);
        close(circle.b, PI / 4.0);
        close(circle.c, PI / 16.0);
        close(circle.d, PI / 4.0);
    }

    /// (3.17c): the limits of K, C and D for slender ellipses.
    #[test]
    fn slender_limits() {
        let g = 1e-8_f64;
        let slender = CompleteIntegrals::new(g);
        let log = (4.0 / g).ln();
        close(slender.k, log);
        close(slender.e, 1.0);
        close(slender.d, log - 1.0);
        close(slender.c, log - 2.0);
    }
}
