//! Conversion of a case's geometry: radii, semi-axes, a line, or the undeformed distance.

use super::{Cause, Geometry, LoadOrApproach};
use crate::bodies::{Bodies, Grid, Shape};
use crate::read::Materials;
use crate::text::{list, number};

pub(super) fn geometry(
    case: &Bodies,
    materials: &Materials,
    turned: bool,
    notes: &mut Vec<String>,
) -> Result<(Geometry, LoadOrApproach), Cause> {
    let grid = case.grid.ok_or("no case has given a grid (D = 2)")?;
    let [load, ..] = case.kinematics;
    let has_load = case.control.has_load();
    if grid.elements == [1, 1] {
        return rectangle(grid, load, has_load);
    }
    let [first, second] = grid.first;
    let curvatures = match grid.kind {
        -1 => [first, second],
        -2 => [first, first * ratio_of_curvatures(second)?],
        -3 if has_load => {
            return Ok((
                Geometry::SemiAxes([first * 1e-3, second * 1e-3]),
                LoadOrApproach::Load(load),
            ));
        }
        -3 => return Err("an approach with the semi-axes given (IPOTCN = -3, N = 0)".into()),
        kind if kind < 0 => return Err(format!("IPOTCN = {kind}: two half ellipses, or a box")),
        _ => {
            return shaped(case, materials, turned, notes);
        }
    };
    smooth(case, materials, curvatures, 0.0, notes)
}

impl Geometry {
    /// Hertz's semi-axes along and across (m), of an ellipse under a load.
    pub(super) fn semi_axes(
        &self,
        materials: &Materials,
        pressed: LoadOrApproach,
    ) -> Option<[f64; 2]> {
        match (self, pressed) {
            (Self::SemiAxes(own), _) => Some(*own),
            (Self::Radii(radii), LoadOrApproach::Load(load)) => {
                let compliance: f64 = (0..2)
                    .map(|k| (1.0 - materials.poisson[k]) / (2e6 * materials.shear_modulus[k]))
                    .sum();
                let [longer, ratio] =
                    longer_axis(radii.map(|radius| 0.5 / radius), load * compliance)?;
                // The softer curvature has the longer axis.
                let axes = [longer, longer * ratio];
                Some(if radii[0] >= radii[1] { axes } else { [axes[1], axes[0]] })
            }
            _ => None,
        }
    }
}

/// The longer semi-axis (m) of Hertz's ellipse and the shorter one over it, of these curvatures (1/m) under a load times
/// the compliance (m2).
fn longer_axis(curvatures: [f64; 2], load: f64) -> Option<[f64; 2]> {
    let [first, second] = curvatures;
    let (small, large) = (first.min(second), first.max(second));
    if !(small > 0.0 && large.is_finite() && load > 0.0) {
        return None;
    }
    // The ratio of axes is below that of curvatures to the power 2/3, and above it to the first.
    let (mut low, mut high) = (small / large, 1.0_f64);
    for _ in 0..60 {
        let middle = (low * high).sqrt();
        // `ratio_of_curvatures` of a longer axis over a shorter one is that across over that along, above one.
        if ratio_of_curvatures(1.0 / middle).ok()? > large / small {
            low = middle;
        } else {
            high = middle;
        }
    }
    let ratio = (low * high).sqrt();
    // Hertz: A = 3 N (1/E*) (K - E)/(2 pi a^3 e^2), whose last factor is pi/4 for a circle.
    let eccentricity = 1.0 - ratio * ratio;
    let factor = if eccentricity < 1e-9 {
        std::f64::consts::FRAC_PI_4
    } else {
        let [k, e] = elliptic_integrals(ratio);
        (k - e) / eccentricity
    };
    let cube = 1.5 * load * factor / (std::f64::consts::PI * small);
    Some([cube.cbrt(), ratio])
}

/// A single element: its pressure is uniform.
fn rectangle(grid: Grid, load: f64, has_load: bool) -> Result<(Geometry, LoadOrApproach), Cause> {
    if !has_load {
        return Err("a single element at a given approach (N = 0)".into());
    }
    let half_lengths = match grid.kind {
        // The box around the ellipse, larger by SCALE.
        -3 => grid.first.map(|semi_axis| semi_axis * grid.size[0]),
        kind if kind > 0 => grid.size.map(|size| 0.5 * size),
        kind => {
            return Err(format!(
                "a single element around an ellipse that is sought (IPOTCN = {kind})"
            ));
        }
    };
    Ok((Geometry::Rectangle(half_lengths.map(|half| half * 1e-3)), LoadOrApproach::Load(load)))
}

/// Bodies of constant curvatures (1/mm), `offset` apart (mm).
fn smooth(
    case: &Bodies,
    materials: &Materials,
    curvatures: [f64; 2],
    offset: f64,
    notes: &mut Vec<String>,
) -> Result<(Geometry, LoadOrApproach), Cause> {
    let [first, second] = curvatures;
    if !(first > 0.0 && second > 0.0) {
        return Err("curvatures that are not above zero".into());
    }
    let radii = curvatures.map(|curvature| 0.5e-3 / curvature);
    let [load, ..] = case.kinematics;
    if case.control.has_load() {
        return Ok((Geometry::Radii(radii), LoadOrApproach::Load(load)));
    }
    let approach = (load - offset) * 1e-3;
    let is_unlike = materials.poisson[0] != materials.poisson[1]
        || materials.shear_modulus[0] != materials.shear_modulus[1];
    let needs_load = case.control.tangential() < 3 || is_unlike;
    if needs_load && (first - second).abs() < 1e-6 * first && approach > 0.0 {
        // Hertz's sphere: what shifts and rolls in steps needs a load, and areas at a given approach take unlike
        // bodies for like ones.
        let compliance: f64 =
            (0..2).map(|k| (1.0 - materials.poisson[k]) / (2e6 * materials.shear_modulus[k])).sum();
        let load = 4.0 / 3.0 / compliance * radii[0].sqrt() * approach.powf(1.5);
        let own = if is_unlike { ": friction between unlike bodies changes it" } else { "" };
        notes.push(format!("the load is Hertz's at the given approach{own}"));
        return Ok((Geometry::Radii(radii), LoadOrApproach::Load(load)));
    }
    let terms = format!(
        "polynomial = [[2, 0, {}], [0, 2, {}]]\n",
        number(first * 1e3),
        number(second * 1e3)
    );
    Ok((Geometry::Gap(terms), LoadOrApproach::Approach(approach)))
}

/// A shape on a grid of elements (IPOTCN > 0).
fn shaped(
    case: &Bodies,
    materials: &Materials,
    turned: bool,
    notes: &mut Vec<String>,
) -> Result<(Geometry, LoadOrApproach), Cause> {
    let grid = case.grid.ok_or("no case has given a grid (D = 2)")?;
    let shape = case.shape.as_ref().ok_or("no case has given a shape (Z = 1, 2)")?;
    let [load, ..] = case.kinematics;
    if grid.elements[1] == 1 {
        return line(case, shape, notes);
    }
    if let Shape::Quadratic([first, mixed, second, x, y, offset]) = *shape
        && [mixed, x, y].iter().all(|term| *term == 0.0)
    {
        return smooth(case, materials, [first, second], offset, notes);
    }
    let pressed = if case.control.has_load() {
        LoadOrApproach::Load(load)
    } else {
        LoadOrApproach::Approach(load * 1e-3)
    };
    let sign: f64 = if turned { -1.0 } else { 1.0 };
    let text = match shape {
        Shape::Quadratic(b) => {
            let powers = [[2, 0], [1, 1], [0, 2], [1, 0], [0, 1], [0, 0]];
            let terms: Vec<_> = powers
                .iter()
                .zip(b)
                .filter(|(_, value)| **value != 0.0)
                .map(|([i, j], value)| {
                    // Metres: mm times (1/mm) to the power.
                    let si = value * 1e-3 * 1e3_f64.powi(i + j) * sign.powi(i + j);
                    format!("[{i}, {j}, {}]", number(si))
                })
                .collect();
            format!("polynomial = [{}]\n", terms.join(", "))
        }
        Shape::Circular { radius, middle, first, step, points } => {
            if *radius <= 0.0 || *step <= 0.0 {
                return Err("a radius or a step across that is not above zero (IBASE = 2)".into());
            }
            let mut places: Vec<(f64, f64)> = (0..points.len())
                .map(|k| (sign * (first + k as f64 * step) * 1e-3, points[k] * 1e-3))
                .collect();
            if turned {
                places.reverse();
            }
            let y = list(places.iter().map(|place| place.0));
            let gap = list(places.iter().map(|place| place.1));
            let columns = if *middle == 0.0 {
                format!("{{ y = {y}, gap = {gap} }}")
            } else {
                let x = list(places.iter().map(|_| sign * middle * 1e-3));
                format!("{{ y = {y}, gap = {gap}, x = {x} }}")
            };
            format!("section = {columns}\nradius_rolling = {}\n", number(radius * 1e-3))
        }
        Shape::WithSines => return Err("a shape with sine waves (IBASE = 3)".into()),
        Shape::Points(points) => {
            let [count, _] = grid.elements;
            let place = |axis, index| sign * grid.middle(axis, index) * 1e-3;
            let x = list((0..points.len()).map(|k| place(0, k % count)));
            let y = list((0..points.len()).map(|k| place(1, k / count)));
            let gap = list(points.iter().map(|value| value * 1e-3));
            format!("grid = {{ x = {x}, y = {y}, gap = {gap} }}\n")
        }
    };
    Ok((Geometry::Gap(text), pressed))
}

/// One row of elements: a line contact.
fn line(
    case: &Bodies,
    shape: &Shape,
    notes: &mut Vec<String>,
) -> Result<(Geometry, LoadOrApproach), Cause> {
    let grid = case.grid.ok_or("no case has given a grid (D = 2)")?;
    let radius = match *shape {
        Shape::Quadratic([curvature, _, _, _, _, _]) if curvature > 0.0 => 0.5 / curvature,
        Shape::Circular { radius, .. } if radius > 0.0 => radius,
        _ => return Err("a line contact that is not of cylinders".into()),
    };
    if let Shape::Quadratic([_, _, _, x, _, _]) = *shape
        && x != 0.0
    {
        notes.push("the line contact's place along x (B4) is put at x = 0".into());
    }
    if !case.control.has_load() {
        return Err("a line contact at a given approach, which depends on the length".into());
    }
    // Forces of a line contact are per length.
    let [load, ..] = case.kinematics;
    let length = grid.size[1] * 1e-3;
    notes.push(format!(
        "one row of elements {} m wide is a line contact: forces are per metre",
        number(length)
    ));
    Ok((Geometry::Line([radius * 1e-3, length]), LoadOrApproach::Load(load / length)))
}

/// The case with the middle of its paraboloid at the origin, and where that was (mm): in a shift or in rolling by
/// steps without a turn about the normal, the place changes nothing else.
pub(super) fn centred(case: &Bodies) -> (Bodies, [f64; 2]) {
    let mut centred = case.clone();
    let [pressed, _, _, turn] = case.kinematics;
    let is_free = matches!(case.control.tangential(), 1 | 2) && turn == 0.0;
    let Some(Shape::Quadratic([first, mixed, second, x, y, offset])) = case.shape else {
        return (centred, [0.0; 2]);
    };
    let is_row = case.grid.is_some_and(|grid| grid.elements[1] == 1);
    if !(is_free && mixed == 0.0 && first > 0.0 && second > 0.0) || is_row {
        return (centred, [0.0; 2]);
    }
    let place = [-0.5 * x / first, -0.5 * y / second];
    let mut lowest = offset + 0.5 * (x * place[0] + y * place[1]);
    // The digits of a file end before a millionth of the approach.
    if case.control.has_load() || lowest.abs() <= 1e-6 * pressed.abs() {
        lowest = 0.0;
    }
    centred.shape = Some(Shape::Quadratic([first, mixed, second, 0.0, 0.0, lowest]));
    centred.middle = place;
    (centred, place)
}

/// Curvature across over that along, for semi-axes a, b in the ratio a/b.
fn ratio_of_curvatures(ratio: f64) -> Result<f64, Cause> {
    if !(ratio > 0.0 && ratio.is_finite()) {
        return Err("a ratio of semi-axes that is not above zero".into());
    }
    if (ratio - 1.0).abs() < 1e-9 {
        return Ok(1.0);
    }
    // Hertz: curvatures along the longer and the shorter axis are as K - E to E/(1 - e2) - K.
    let shorter = ratio.min(1.0 / ratio);
    let squared = 1.0 - shorter * shorter;
    let [first, second] = elliptic_integrals(shorter);
    let longer_over_shorter = (first - second) / (second / (1.0 - squared) - first);
    Ok(if ratio > 1.0 { 1.0 / longer_over_shorter } else { longer_over_shorter })
}

/// Complete elliptic integrals K and E at the complementary modulus, by arithmetic-geometric means.
fn elliptic_integrals(complementary: f64) -> [f64; 2] {
    let (mut a, mut b) = (1.0_f64, complementary);
    let mut sum = 0.5 * (1.0 - b * b);
    let mut power = 1.0;
    // Each mean doubles the digits.
    for _ in 0..12 {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        sum += power * c * c;
        power *= 2.0;
    }
    let first = std::f64::consts::FRAC_PI_2 / a;
    [first, first * (1.0 - sum)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hertzs_ratio_is_that_of_tables() {
        // a/b = 2 along the longer axis: K and E at e2 = 3/4 are 2.15651565 and 1.21105603
        // (Abramowitz and Stegun, table 17.1, by interpolation to 1e-6).
        let expected = (1.211_056 / 0.25 - 2.156_516) / (2.156_516 - 1.211_056);
        let found = ratio_of_curvatures(2.0).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-5, "{found} {expected}");
        assert!((ratio_of_curvatures(0.5).unwrap() * found - 1.0).abs() < 1e-12);
        assert!((ratio_of_curvatures(1.001).unwrap() - 1.0).abs() < 0.01);
    }
}
