//! Tables, and the formulas of Hertz on the axis.

use creepage::subsurface::{Body, Stress};

use crate::support::{apart, rows, sliding};

/// 36 points, to the ten digits that the table keeps.
#[test]
fn full_sliding() {
    let mut worst = 0.0_f64;
    let rows = rows(include_str!("full_sliding.csv"));
    assert_eq!(rows.len(), 36);
    for row in rows {
        let [a_over_b, mu, x, y, z] = [0, 1, 2, 3, 4].map(|i| row[i]);
        let interior = sliding(a_over_b, 0.28, [mu, 0.0], Body::Lower);
        let (b, minor) = (1.0 / a_over_b, (1.0 / a_over_b).min(1.0));
        let found = interior.stress([x, y * b, z * minor]).unwrap();
        let expected = Stress::from_components([5, 6, 7, 8, 9, 10].map(|i| row[i]));
        worst = worst.max(apart(&found, &expected));
    }
    assert!(worst < 1e-10, "{worst:e}");
}

/// On the axis of a circle: `szz = -1/(1 + z^2)`,
/// `sxx = -(1 + sigma)(1 - z atan(1/z)) + 1/(2 (1 + z^2))`.
#[test]
fn hertz_on_the_axis() {
    for poisson in [0.0, 0.28, 0.5] {
        let interior = sliding(1.0, poisson, [0.0, 0.0], Body::Lower);
        for z in [0.0, 1e-9, 1e-3, 0.1, 0.48, 1.0, 3.0, 10.0, 300.0] {
            let found = interior.stress([0.0, 0.0, z]).unwrap();
            let below = 1.0 / (1.0 + z * z);
            let angle = if z == 0.0 { 0.0 } else { z * (1.0 / z).atan() };
            let radial = -(1.0 + poisson) * (1.0 - angle) + 0.5 * below;
            let expected = Stress { xx: radial, yy: radial, zz: -below, ..Stress::default() };
            // Rounding of a sum over directions.
            assert!(apart(&found, &expected) < 1e-14, "z = {z}: {found:?} {expected:?}");
        }
    }
}

/// At the surface the tractions are met from below, and beside the contact there are none: of circles
/// and of slender contacts.
#[test]
fn the_surface_carries_the_tractions() {
    let places =
        [(0.0, 0.0), (0.5, 0.3), (-0.9, 0.1), (0.7, -0.7), (0.0, 0.999), (1.2, 0.2), (0.9, 0.8)];
    let mu = [0.3, -0.2];
    for a_over_b in [0.6, 1.0, 7.0, 1e-3, 1e3] {
        let interior = sliding(a_over_b, 0.3, mu, Body::Lower);
        for (x, y) in places {
            let found = interior.stress([x, y / a_over_b, 0.0]).unwrap();
            let pressure = (1.0_f64 - x * x - y * y).max(0.0).sqrt();
            // The double exponential rule: twelve digits.
            for (stress, traction) in
                [(found.zz, pressure), (found.xz, mu[0] * pressure), (found.yz, mu[1] * pressure)]
            {
                let apart = (stress + traction).abs();
                assert!(apart < 1e-12, "{a_over_b} {x} {y}: {stress} {traction}");
            }
        }
    }
}

/// On the axis of a contact a thousand times as wide as long the stresses are those of the line
/// contact; of `xx` and `yy` the sum only, for Poisson's ratio brings in the first power of the ratio.
#[test]
fn a_slender_contact_is_a_line() {
    let interior = sliding(1e-3, 0.3, [0.0, 0.0], Body::Lower);
    for z in [0.05_f64, 0.5, 0.786, 2.0] {
        let found = interior.stress([0.0, 0.0, z]).unwrap();
        let root = (1.0 + z * z).sqrt();
        let (xx, zz) = (2.0 * z - (1.0 + 2.0 * z * z) / root, -1.0 / root);
        // The square of the ratio, times a logarithm.
        assert!((found.zz - zz).abs() < 2e-5, "{z} {found:?}");
        assert!((found.trace() - 1.3 * (xx + zz)).abs() < 2e-5, "{z} {found:?}");
    }
}
