//! Rigid slip that is added element by element (E), as a case file has it.

use super::{Cause, Geometry, LoadOrApproach};
use crate::bodies::Bodies;
use crate::read::Materials;
use crate::text::list;

/// The slip at the middles of the elements, where it is not zero everywhere and the bodies roll.
pub(super) fn added_slip(
    case: &Bodies,
    materials: &Materials,
    (geometry, pressed): (&Geometry, LoadOrApproach),
    turned: bool,
) -> Result<Option<String>, Cause> {
    let Some(slips) = &case.added_slip else { return Ok(None) };
    match case.control.tangential() {
        0 => return Ok(None),
        1 => return Err("a shift that differs from element to element (E)".into()),
        _ if matches!(geometry, Geometry::Line(_)) => {
            return Err("slip added element by element (E) on a line".into());
        }
        _ => {}
    }
    let grid = case.grid.ok_or("no case has given a grid (D = 2)")?;
    let (mut first, mut size) = (grid.first, grid.size);
    if grid.kind < 0 {
        let axes = geometry
            .semi_axes(materials, pressed)
            .ok_or("slip added element by element (E) around an ellipse that is sought")?;
        // The box around the ellipse, larger by SCALE.
        let halves = axes.map(|semi_axis| semi_axis * 1e3 * grid.size[0]);
        first = halves.map(|half| -half);
        size = [0, 1].map(|axis| 2.0 * halves[axis] / grid.elements[axis] as f64);
    }
    let sign = if turned { -1.0 } else { 1.0 };
    let [columns, _] = grid.elements;
    let place = |axis: usize, index: usize| {
        let middle = first[axis] + (index as f64 + 0.5) * size[axis];
        sign * (middle - case.middle[axis]) * 1e-3
    };
    let x = list((0..slips.len()).map(|k| place(0, k % columns)));
    let y = list((0..slips.len()).map(|k| place(1, k / columns)));
    let [along, across] = [0, 1].map(|axis| list(slips.iter().map(|slip| sign * slip[axis])));
    Ok(Some(format!("{{ x = {x}, y = {y}, longitudinal = {along}, lateral = {across} }}")))
}
