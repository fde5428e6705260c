//! Constant tractions on polygons: against the point forces (2.5), (2.12), and each other.

use creepage::Solid;
use creepage::subsurface::{Body, Element, Interior, Stress};
use proptest::prelude::*;

use crate::support::{apart, sliding};

/// Displacements of a point force `[X, Y, Z]` on a body of shear modulus one, (2.5), (2.12).
fn point_force([x, y, z]: [f64; 3], poisson: f64, [fx, fy, fz]: [f64; 3]) -> [f64; 3] {
    let r = (x * x + y * y + z * z).sqrt();
    let m = 1.0 - 2.0 * poisson;
    let shear = |x: f64, y: f64| {
        [
            1.0 / r + m / (z + r) + x * x / r.powi(3) - m * x * x / (r * (z + r).powi(2)),
            x * y / r.powi(3) - m * x * y / (r * (z + r).powi(2)),
            x * z / r.powi(3) + m * x / (r * (z + r)),
        ]
    };
    let ([uu, uv, uw], [vv, vu, vw]) = (shear(x, y), shear(y, x));
    let pressure = |x: f64| x * z / r.powi(3) - m * x / (r * (z + r));
    let down = z * z / r.powi(3) + 2.0 * (1.0 - poisson) / r;
    [
        fx * uu + fy * vu + fz * pressure(x),
        fx * uv + fy * vv + fz * pressure(y),
        fx * uw + fy * vw + fz * down,
    ]
    .map(|value| value / (4.0 * std::f64::consts::PI))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Displacements of a parallelogram by Gauss's rule over point forces.
    #[test]
    fn a_parallelogram_is_many_points(
        sides in prop::array::uniform4(-1.0..1.0_f64),
        point in prop::array::uniform2(-2.0..2.0_f64),
        depth in 0.5..2.0_f64,
        poisson in 0.0..0.5_f64,
        traction in prop::array::uniform3(-1.0..1.0_f64),
    ) {
        let [ux, uy, vx, vy] = sides;
        let corner = |i: f64, j: f64| [i * ux + j * vx, i * uy + j * vy];
        let corners = [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
        let solid = Solid::new(1.0, poisson).unwrap();
        let element = Element::new(&corners, traction).unwrap();
        let interior = Interior::new(solid, Body::Lower).with_elements(&[element]);
        let found = interior.displacement([point[0], point[1], depth]).unwrap();
        let rule = gauss_quad::GaussLegendre::new(40.try_into().unwrap());
        let (area, mut expected) = ((ux * vy - uy * vx).abs(), [0.0; 3]);
        for &(s, first) in &rule {
            for &(t, second) in &rule {
                let [x, y] = corner(0.5 * (1.0 + s), 0.5 * (1.0 + t));
                let part = point_force([point[0] - x, point[1] - y, depth], poisson, traction);
                let share = 0.25 * first * second * area;
                expected.iter_mut().zip(part).for_each(|(sum, part)| *sum += share * part);
            }
        }
        for (found, expected) in found.into_iter().zip(expected) {
            // The rule's error at this depth, and rounding.
            prop_assert!((found - expected).abs() < 1e-11, "{found} {expected}");
        }
    }

    /// A polygon cut in two, and the same with a side all around the other way.
    #[test]
    fn parts_make_the_whole(
        point in prop::array::uniform2(-1.5..1.5_f64),
        depth in 0.0..1.0_f64,
        traction in prop::array::uniform3(-1.0..1.0_f64),
    ) {
        let solid = Solid::new(1.0, 0.3).unwrap();
        let whole = [[-1.0, -0.5], [0.8, -0.6], [0.9, 0.7], [-0.7, 0.4]];
        let below = [whole[0], whole[1], whole[2]];
        let above = [whole[0], whole[3], whole[2]];
        let element = |corners: &[[f64; 2]]| Element::new(corners, traction).unwrap();
        let point = [point[0], point[1], depth];
        let one = Interior::new(solid, Body::Lower).with_elements(&[element(&whole)]);
        let two = Interior::new(solid, Body::Lower).with_elements(&[element(&below), element(&above)]);
        let [one, two] = [one, two].map(|interior| interior.stress(point).unwrap());
        // The common side cancels to the last bit; the order of the sum does not.
        prop_assert!(apart(&one, &two) < 1e-12, "{one:?} {two:?}");
    }

    /// No point, not even a corner or the line of a side, gives what is not a number.
    #[test]
    fn every_point_has_a_value(
        i in 0..5_i32, j in 0..5_i32,
        depth in prop::sample::select(vec![0.0, 1e-300, 1e-12, 0.3]),
    ) {
        let solid = Solid::new(1.0, 0.3).unwrap();
        let element = Element::rectangle([0.0; 2], [1.0, 1.0], [1.0, 0.5, 2.0]).unwrap();
        let interior = Interior::new(solid, Body::Lower).with_elements(&[element]);
        let point = [0.5 * f64::from(i) - 1.0, 0.5 * f64::from(j) - 1.0, depth];
        for value in interior.stress(point).unwrap().components() {
            prop_assert!(value.is_finite(), "{point:?}");
        }
        for value in interior.displacement(point).unwrap() {
            prop_assert!(value.is_finite(), "{point:?}");
        }
    }
}

/// Under the middle of a square at the surface: `-p` on top, and sideways half of `p (1 + 2 sigma)`.
#[test]
fn at_the_surface_the_limit_from_inside_counts() {
    for poisson in [0.0, 0.28, 0.5] {
        let solid = Solid::new(1.0, poisson).unwrap();
        let element = Element::rectangle([0.0; 2], [2.0, 2.0], [0.0, 0.0, 1.0]).unwrap();
        let interior = Interior::new(solid, Body::Lower).with_elements(&[element]);
        let found = interior.stress([0.0; 3]).unwrap();
        let side = -0.5 * (1.0 + 2.0 * poisson);
        let expected = Stress { xx: side, yy: side, zz: -1.0, ..Stress::default() };
        assert!(apart(&found, &expected) < 1e-15, "{found:?}");
    }
}

/// Squares inscribed in the circle of Hertz, ever finer, approach the closed form with second order.
#[test]
fn elements_converge_to_the_polynomial() {
    let exact = sliding(1.0, 0.28, [0.3, 0.1], Body::Lower);
    let solid = exact.solid();
    let points = [[0.0, 0.0, 0.3], [0.5, 0.2, 0.4], [-0.8, 0.4, 0.3], [1.2, 0.0, 0.5]];
    let errors = [20, 40, 80].map(|count| {
        let side = 2.0 / f64::from(count);
        let middle = |i: i32| side * (f64::from(i) + 0.5) - 1.0;
        let mut elements = vec![];
        for k in 0..count * count {
            let [x, y] = [middle(k % count), middle(k / count)];
            let pressure = (1.0 - x * x - y * y).max(0.0).sqrt();
            let traction = [0.3 * pressure, 0.1 * pressure, pressure];
            elements.push(Element::rectangle([x, y], [side, side], traction).unwrap());
        }
        let interior = Interior::new(solid, Body::Lower).with_elements(&elements);
        points.iter().fold(0.0_f64, |worst, point| {
            worst.max(apart(&interior.stress(*point).unwrap(), &exact.stress(*point).unwrap()))
        })
    });
    // The staircase at the edge, where the pressure is least: order 3/2 at least.
    assert!(errors[0] < 5e-3 && errors[2] < errors[0] / 6.0, "{errors:?}");
}
