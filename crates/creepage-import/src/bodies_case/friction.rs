//! Conversion of a case's friction to the keys of a case file.

use super::Cause;
use crate::bodies::Bodies;
use crate::read::{Friction, Law};
use crate::text::{list, number, quoted};

/// The coefficient at rest, the text of it, and whether the speed counts.
pub(super) fn friction(
    case: &Bodies,
    turned: bool,
    notes: &mut Vec<String>,
) -> Result<(f64, String, bool), Cause> {
    let read = case.friction.as_ref().ok_or("no case has given friction (L)")?;
    match &read.friction {
        Friction::One(law) => law_text(law, read.memory, notes),
        Friction::ByRow(laws) => by_row(case, laws, turned),
        Friction::ByAngle(_) | Friction::Along(_) => {
            Err("friction by angle or along the track on given bodies".into())
        }
    }
}

/// A law as a case file has it: the coefficient at rest, the text, whether the speed counts.
pub(crate) fn law_text(
    law: &Law,
    memory: Option<[f64; 2]>,
    notes: &mut Vec<String>,
) -> Result<(f64, String, bool), Cause> {
    match law {
        Law::Coulomb { at_rest, kinetic } => {
            if at_rest != kinetic {
                notes.push(format!(
                    "FSTAT = {} beside FKIN = {}: FKIN is taken for both",
                    number(*at_rest),
                    number(*kinetic)
                ));
            }
            Ok((*kinetic, number(*kinetic), false))
        }
        Law::Falling { name, kinetic, terms } => {
            // In rational laws a term's place is its power.
            let used = if terms[1][0] == 0.0 { usize::from(terms[0][0] != 0.0) } else { 2 };
            let texts: Vec<_> = terms[..used]
                .iter()
                .map(|[drop, speed]| {
                    let (drop, speed) = (number(*drop), number(speed * 1e-3));
                    format!("{{ drop = {drop}, half_speed = {speed} }}")
                })
                .collect();
            let rest = kinetic + terms[..used].iter().map(|term| term[0]).sum::<f64>();
            let memory = memory.map_or(String::new(), |[distance, speed]| {
                let (distance, speed) = (number(distance * 1e-3), number(speed * 1e-3));
                format!(", memory_distance = {distance}, memory_speed = {speed}")
            });
            if used == 0 {
                return Ok((rest, number(rest), false));
            }
            let text = format!(
                "{{ law = {}, kinetic = {}, terms = [{}]{memory} }}",
                quoted(name),
                number(*kinetic),
                texts.join(", ")
            );
            Ok((rest, text, true))
        }
        Law::OfTemperature([reference, from, change, range]) => {
            if !(*range > 0.0 && *reference > 0.0 && reference + change > 0.0) {
                return Err(
                    "friction by temperature that ends at zero, or over no range (L = 6)".into()
                );
            }
            if memory.is_some() {
                notes.push("the memory of friction by temperature has no counterpart".into());
            }
            let (cold, hot) = (number(*reference), number(reference + change));
            let temperatures = list([*from, from + range]);
            let text = format!("{{ cold = {cold}, hot = {hot}, temperatures = {temperatures} }}");
            Ok((reference.max(reference + change), text, true))
        }
    }
}

/// Friction row by row, where few straight lines say it.
fn by_row(case: &Bodies, laws: &[Law], turned: bool) -> Result<(f64, String, bool), Cause> {
    let grid = case.grid.filter(|grid| grid.kind > 0);
    let grid = grid.ok_or("friction row by row on an ellipse that is given by its axes")?;
    let sign = if turned { -1.0 } else { 1.0 };
    let mut points = Vec::new();
    for (row, law) in laws.iter().enumerate() {
        match law {
            Law::Coulomb { at_rest, kinetic } if at_rest == kinetic => {
                points.push([sign * grid.middle(1, row) * 1e-3, *kinetic]);
            }
            _ => return Err("friction row by row by a law, or with two coefficients".into()),
        }
    }
    if turned {
        points.reverse();
    }
    let corners = corners(&points);
    if corners.len() > 7 {
        return Err("friction row by row that takes more than seven straight points".into());
    }
    let largest = points.iter().map(|point| point[1]).fold(0.0, f64::max);
    let pairs: Vec<_> = corners.iter().map(|point| list(*point)).collect();
    Ok((largest, format!("{{ across = [{}] }}", pairs.join(", ")), false))
}

/// The points at which a line through all of them bends.
fn corners(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let inner = points.windows(3).filter(|three| {
        let slope = |k: usize| (three[k + 1][1] - three[k][1]) / (three[k + 1][0] - three[k][0]);
        let bend = (slope(1) - slope(0)) * (three[2][0] - three[0][0]);
        // A millionth of a coefficient is what the digits of a file can tell.
        bend.abs() > 1e-6
    });
    let ends = points.first().into_iter().copied();
    let last = points.last().filter(|_| points.len() > 1).copied();
    ends.chain(inner.map(|three| three[1])).chain(last).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_are_where_lines_bend() {
        let points = [[0.0, 0.1], [1.0, 0.2], [2.0, 0.3], [3.0, 0.3], [4.0, 0.3]];
        assert_eq!(corners(&points), [[0.0, 0.1], [2.0, 0.3], [4.0, 0.3]]);
    }
}
