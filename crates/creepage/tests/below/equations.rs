//! The equations of elasticity, by differences, and the symmetries (2.8), (2.14).

use creepage::Solid;
use creepage::halfspace::{DisplacementField, Edge};
use creepage::subsurface::{Body, Element, Interior, Stress};

use proptest::prelude::{Just, prop_assert};

use crate::support::{apart, cubic};

const POINTS: [[f64; 3]; 5] =
    [[0.2, 0.3, 0.3], [-0.6, 0.1, 0.5], [0.9, -0.8, 0.25], [1.6, 0.4, 0.4], [0.1, -0.2, 2.0]];

fn interiors() -> Vec<Interior> {
    let mut all = vec![];
    for poisson in [0.0, 0.3, 0.5] {
        let solid = Solid::new(2.0, poisson).unwrap();
        for edge in [Edge::Singular, Edge::Vanishing] {
            let traction = cubic(0.7, edge);
            all.push(Interior::new(solid, Body::Lower).with_traction(&traction, 1.0).unwrap());
        }
        let corners = [[0.5, -0.1], [0.4, 0.6], [-0.3, 0.5], [-0.5, -0.4]];
        let element = Element::new(&corners, [0.4, -0.3, 1.0]).unwrap();
        let triangle =
            Element::new(&[[0.5, -0.1], [1.0, 0.2], [0.4, 0.6]], [1.0, 2.0, 0.5]).unwrap();
        all.push(Interior::new(solid, Body::Lower).with_elements(&[element, triangle]));
    }
    all
}

/// Central difference of fourth order.
fn derivative<const N: usize>(
    field: impl Fn([f64; 3]) -> [f64; N],
    point: [f64; 3],
    axis: usize,
) -> [f64; N] {
    const STEP: f64 = 2e-3;
    let at = |steps: f64| {
        let mut moved = point;
        moved[axis] += steps * STEP;
        field(moved)
    };
    let [far, near, ahead, beyond] = [at(-2.0), at(-1.0), at(1.0), at(2.0)];
    std::array::from_fn(|i| (8.0 * (ahead[i] - near[i]) - (beyond[i] - far[i])) / (12.0 * STEP))
}

/// The divergence of the stress vanishes.
#[test]
fn equilibrium() {
    for (k, interior) in interiors().iter().enumerate() {
        for point in POINTS {
            let [x, y, z] = [0, 1, 2]
                .map(|axis| derivative(|p| interior.stress(p).unwrap().components(), point, axis));
            let force = [x[0] + y[3] + z[5], x[3] + y[1] + z[4], x[5] + y[4] + z[2]];
            // The step to the fourth power, over the depth to the fourth, and rounding over the step.
            for part in force {
                assert!(part.abs() < 1e-6, "interior {k} at {point:?}: {force:?}");
            }
        }
    }
}

/// The strains, which come from the stresses, are the derivatives of the displacements.
#[test]
fn compatibility() {
    for (k, interior) in interiors().iter().enumerate() {
        for point in POINTS {
            let [x, y, z] = [0, 1, 2]
                .map(|axis| derivative(|p| interior.displacement(p).unwrap(), point, axis));
            let half = |one: f64, two: f64| 0.5 * (one + two);
            let expected = Stress {
                xx: x[0],
                yy: y[1],
                zz: z[2],
                xy: half(x[1], y[0]),
                yz: half(y[2], z[1]),
                xz: half(x[2], z[0]),
            };
            let found = interior.strain(point).unwrap();
            assert!(apart(&found, &expected) < 1e-7, "{k} {point:?}: {found:?} {expected:?}");
        }
    }
}

/// The force through a plane below is the force on the surface: Gauss's rule in polar coordinates.
#[test]
fn the_load_goes_down() {
    let solid = Solid::new(2.0, 0.3).unwrap();
    let corners = [[0.5, -0.1], [0.4, 0.6], [-0.3, 0.5], [-0.5, -0.4]];
    let element = Element::new(&corners, [0.4, -0.3, 1.0]).unwrap();
    let interior = Interior::new(solid, Body::Lower).with_elements(&[element]);
    let rule = gauss_quad::GaussLegendre::new(60.try_into().unwrap());
    let mut force = [0.0; 3];
    for &(node, weight) in &rule {
        // Radius t/(1 - t): all of the plane.
        let t = 0.5 * (1.0 + node);
        let (radius, measure) = (t / (1.0 - t), 0.5 * weight / (1.0 - t).powi(2));
        for k in 0..60 {
            let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 60.0).sin_cos();
            let stress = interior.stress([radius * cos, radius * sin, 1.0]).unwrap();
            let share = measure * radius * std::f64::consts::TAU / 60.0;
            for (sum, part) in force.iter_mut().zip([stress.xz, stress.yz, stress.zz]) {
                *sum -= share * part;
            }
        }
    }
    let area = 0.5
        * (0.5 * 0.6
            + 0.1 * 0.4
            + 0.4 * 0.5
            + 0.3 * 0.6
            + 0.3 * 0.4
            + 0.5 * 0.5
            + 0.5 * 0.1
            + 0.4 * 0.5);
    // The rule is good to eight digits at this depth.
    for (sum, traction) in force.into_iter().zip([0.4, -0.3, 1.0]) {
        assert!((sum - traction * area).abs() < 1e-7, "{force:?} {area}");
    }
}

/// (2.8), (2.14): in its own frame the upper body is the lower one with the shear turned about.
#[test]
fn elastic_symmetry() {
    let solid = Solid::new(2.0, 0.3).unwrap();
    let traction = cubic(0.7, Edge::Vanishing);
    let element = Element::rectangle([0.2, 0.1], [0.3, 0.2], [0.5, 0.7, 2.0]).unwrap();
    let [lower, upper] = [Body::Lower, Body::Upper].map(|body| {
        let interior = Interior::new(solid, body).with_traction(&traction, 1.0).unwrap();
        interior.with_elements(std::slice::from_ref(&element))
    });
    let [pressure, shear] = [[1.0, 0.0], [0.0, 1.0]].map(|[by_pressure, by_shear]| {
        let [x, y, z] = traction.harmonics().map(<[f64]>::to_vec);
        let scaled = |table: Vec<f64>, by: f64| table.into_iter().map(|v| v * by).collect();
        let part = creepage::halfspace::Traction::from_harmonics(
            traction.ellipse(),
            Edge::Vanishing,
            [scaled(x, by_shear), scaled(y, by_shear), scaled(z, by_pressure)],
        )
        .unwrap();
        let [x, y, z] = element.traction();
        let own = [by_shear * x, by_shear * y, by_pressure * z];
        let element = Element::new(element.corners(), own).unwrap();
        Interior::new(solid, Body::Lower)
            .with_traction(&part, 1.0)
            .unwrap()
            .with_elements(&[element])
    });
    for point in POINTS {
        let [lower, upper, pressure, shear] = [&lower, &upper, &pressure, &shear]
            .map(|interior| interior.displacement(point).unwrap());
        for i in 0..3 {
            // Sums of the same numbers in another order.
            assert!((lower[i] - pressure[i] - shear[i]).abs() < 1e-13);
            assert!((upper[i] - pressure[i] + shear[i]).abs() < 1e-13);
        }
    }
}

/// At the surface the two bodies' displacements differ by what the half-space's own equations say.
#[test]
fn the_surface_moves_as_the_displacement_field() {
    let (one, two) = (Solid::new(1.0, 0.2).unwrap(), Solid::new(3.0, 0.4).unwrap());
    let pair = creepage::SolidPair::new(one, two);
    for edge in [Edge::Singular, Edge::Vanishing] {
        let traction = cubic(0.7, edge);
        let field = DisplacementField::new(&traction, pair.poisson(), pair.kappa()).unwrap();
        let [upper, lower] = [(one, Body::Upper), (two, Body::Lower)].map(|(solid, body)| {
            Interior::new(solid, body).with_traction(&traction, pair.shear_modulus()).unwrap()
        });
        for at in [[0.1, 0.2], [-0.5, 0.9], [0.0, 0.0], [1.3, 0.5], [-2.0, -3.0]] {
            let [above, below] =
                [&upper, &lower].map(|i| i.displacement([at[0], at[1], 0.0]).unwrap());
            let found = [below[0] - above[0], below[1] - above[1], below[2] + above[2]];
            for (found, expected) in found.into_iter().zip(field.at(at)) {
                assert!((found - expected).abs() < 1e-10, "{edge:?} {at:?} {found} {expected}");
            }
        }
    }
}

#[test]
fn nonsense_is_an_error() {
    let interior = Interior::new(Solid::new(1.0, 0.3).unwrap(), Body::Lower);
    assert_eq!(interior.stress([0.0, 0.0, -1e-3]).unwrap_err().quantity, "z");
    assert_eq!(interior.displacement([f64::NAN, 0.0, 1.0]).unwrap_err().quantity, "x");
    assert!(Element::new(&[[0.0; 2]; 2], [0.0; 3]).is_err());
    assert!(Element::new(&[[0.0; 2]; 3], [0.0, f64::INFINITY, 0.0]).is_err());
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(60))]

    /// Every point has a finite value, below circles and slender ellipses, on the edge, at the surface
    /// and far away; it falls off with the square of the distance.
    #[test]
    fn every_point_has_a_value(
        log_ratio in -3.0..3.0_f64,
        angle in 0.0..6.3_f64,
        radius in proptest::prop_oneof![Just(0.0), Just(1.0), 0.0..1.5_f64, Just(1e3)],
        depth in proptest::prop_oneof![Just(0.0), Just(1e-12), 0.0..2.0_f64, Just(1e4)],
    ) {
        let interior = crate::support::sliding(10.0_f64.powf(log_ratio), 0.3, [0.3, 0.1], Body::Lower);
        let b = 10.0_f64.powf(-log_ratio);
        let (sin, cos) = angle.sin_cos();
        let point = [radius * cos, radius * b * sin, depth * b.min(1.0)];
        let stress = interior.stress(point).unwrap().components();
        let distance = (point[0].powi(2) + point[1].powi(2) + point[2].powi(2)).sqrt();
        let most = (4.0 * b / distance.powi(2).max(1e-300)).min(2.0 + 2.0 * b.max(1.0).ln());
        for value in stress.into_iter().chain(interior.displacement(point).unwrap()) {
            prop_assert!(value.is_finite(), "{point:?}");
        }
        if radius > 100.0 || depth > 1e3 {
            prop_assert!(stress.iter().all(|value| value.abs() < most), "{point:?} {stress:?}");
        }
    }
}
