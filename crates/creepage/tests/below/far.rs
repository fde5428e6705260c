//! Far from the contact the bodies feel point forces.

use creepage::halfspace::Edge;
use creepage::subsurface::{Body, Element, Interior};

use super::support::{apart, cubic, sliding};
use creepage::Solid;

const DIRECTIONS: [[f64; 3]; 5] =
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.05], [-0.6, 0.5, 0.4], [0.1, -0.7, 2.0], [0.0, 0.0, 1.0]];

/// Both sides of the distance from which on tractions are point forces: the stress times the square of
/// the distance is one function of the direction, but for its next moment, a thousandth per thousand.
fn is_smooth(interior: &Interior, size: f64) {
    let [near, far] = [0.999e3, 1.001e3];
    for direction in DIRECTIONS {
        let length = direction.iter().map(|part| part * part).sum::<f64>().sqrt();
        let at = |radius: f64| direction.map(|part| part / length * radius);
        let [one, other] = [near, far].map(|radius| interior.stress(at(radius)).unwrap());
        let other = creepage::subsurface::Stress::default().plus((far / near).powi(2), &other);
        // The dipole changes by .002 of a thousandth between the two, of stresses of 1e-6.
        let off = apart(&one, &other);
        assert!(off < 1e-11 * size, "{direction:?}: {off:e} {one:?} {other:?}");
        let [one, other] = [near, far].map(|radius| interior.displacement(at(radius)).unwrap());
        for (one, other) in one.into_iter().zip(other) {
            let off = (one - other * (far / near)).abs();
            assert!(off < 2e-8 * size, "{direction:?}: {one:e} {other:e}");
        }
    }
}

#[test]
fn the_field_goes_on_smoothly_where_tractions_become_point_forces() {
    let solid = Solid::new(1.0, 0.3).unwrap();
    for body in [Body::Lower, Body::Upper] {
        is_smooth(&sliding(2.0, 0.3, [0.3, -0.2], body), 1.0);
        for edge in [Edge::Vanishing, Edge::Singular] {
            let traction = cubic(1.5, edge);
            is_smooth(&Interior::new(solid, body).with_traction(&traction, 1.0).unwrap(), 10.0);
        }
        let corners = [[1.0, 0.0], [0.2, 0.9], [-0.8, 0.1], [-0.2, -0.5]];
        let element = Element::new(&corners, [0.4, -0.7, 1.0]).unwrap();
        let back = Element::new(&[[0.1, 0.0], [0.0, 0.4], [0.3, 0.4]], [1.0, 1.0, 1.0]).unwrap();
        is_smooth(&Interior::new(solid, body).with_elements(&[element, back]), 3.0);
    }
}

/// The stress falls as the square of the distance, to zero where no number is as small.
#[test]
fn stresses_decay_to_nothing_however_far() {
    let interior = sliding(1.5, 0.28, [0.1, 0.3], Body::Lower)
        .with_elements(&[Element::rectangle([0.1, 0.2], [0.5, 0.4], [1.0, 0.3, 0.0]).unwrap()]);
    for direction in DIRECTIONS {
        let at = |radius: f64| direction.map(|part| part * radius);
        let first = interior.stress(at(1e6)).unwrap();
        for exponent in [10, 40, 77, 80, 150, 200, 307] {
            let radius = 10.0_f64.powi(exponent);
            let stress = interior.stress(at(radius)).unwrap();
            let moved = interior.displacement(at(radius)).unwrap();
            assert!(moved.iter().all(|part| part.is_finite() && part.abs() < 10.0 / radius));
            assert!(stress.von_mises().is_finite() && stress.tresca().is_finite());
            let factor = (1e6 / radius).powi(2);
            for (value, first) in stress.components().into_iter().zip(first.components()) {
                // The first is off by its dipole, a millionth.
                let off = (value - first * factor).abs();
                assert!(
                    off <= 1e-5 * 1e-12 * factor + 1e-300,
                    "{direction:?} {radius:e}: {value:e}"
                );
            }
        }
    }
}

/// A force on the surface is carried by every half-sphere around it.
#[test]
fn a_far_half_sphere_carries_the_force() {
    let interior = sliding(1.5, 0.28, [0.1, 0.3], Body::Lower);
    let load = 2.0 / 3.0 * std::f64::consts::PI / 1.5;
    let (mut sum, steps, radius) = ([0.0; 3], 400, 1e9_f64);
    for i in 0..steps {
        // Equal steps of the depth are equal areas of the sphere.
        let z = (f64::from(i) + 0.5) / f64::from(steps);
        for k in 0..24 {
            let turn = std::f64::consts::TAU * f64::from(k) / 24.0;
            let flat = (1.0 - z * z).sqrt();
            let [x, y] = [flat * turn.cos(), flat * turn.sin()];
            let s = interior.stress([x, y, z].map(|part| radius * part)).unwrap();
            let area = std::f64::consts::TAU * radius * radius / f64::from(24 * steps);
            sum[0] += area * (s.xx * x + s.xy * y + s.xz * z);
            sum[1] += area * (s.xy * x + s.yy * y + s.yz * z);
            sum[2] += area * (s.xz * x + s.yz * y + s.zz * z);
        }
    }
    // The midpoint rule of 400 steps.
    for (sum, force) in sum.into_iter().zip([0.1 * load, 0.3 * load, load]) {
        assert!((sum + force).abs() < 1e-4 * load, "{sum} {force}");
    }
}
