//! Reader of `MiniProf` by segments: arcs and lines that make up a reference profile, as points.

use super::FileError;
use super::rows::{Point, numbers};

/// Points lie at most this far apart (mm), and on arcs at most this much of a turn (rad).
const SPACING: f64 = 0.25;
const TURN: f64 = 0.02;
/// Ends that belong together lie this near (mm).
const MAX_DISTANCE_OF_ENDS: f64 = 0.5;
/// Points of a segment at most.
const MAX_POINTS: f64 = 2000.0;

/// The points of one segment: `A y z radius from to` (degrees) or `L y z y z`.
pub(super) fn segment(line: usize, value: &str) -> Result<Vec<Point>, FileError> {
    let wrong = FileError::Key { line, key: "MPD" };
    let value = value.trim();
    let Some((kind, rest)) = value.split_at_checked(1) else { return Err(wrong) };
    let numbers = numbers(line, rest)?;
    if numbers.iter().any(|number| !number.is_finite()) {
        return Err(wrong);
    }
    let place: Box<dyn Fn(f64) -> [f64; 2]>;
    let count;
    match (kind, numbers.as_slice()) {
        ("A", &[y, z, radius, from, to]) => {
            let [from, to] = [from, to].map(f64::to_radians);
            let turn = to - from;
            count = (radius * turn / SPACING).abs().max((turn / TURN).abs());
            place = Box::new(move |part| {
                let (sin, cos) = (from + part * turn).sin_cos();
                [y + radius * cos, z + radius * sin]
            });
        }
        ("L", &[y, z, to_y, to_z]) => {
            count = (to_y - y).hypot(to_z - z) / SPACING;
            place = Box::new(move |part| [y + part * (to_y - y), z + part * (to_z - z)]);
        }
        _ => return Err(wrong),
    }
    let count = crate::curve::whole(count.ceil().clamp(1.0, MAX_POINTS));
    let at = |i: usize| place(i as f64 / count as f64);
    Ok((0..=count).map(|i| Point { line, at: at(i) }).collect())
}

/// The segments one after the other, each turned to where the one before ends.
pub(super) fn chain(segments: Vec<Vec<Point>>) -> Result<Vec<Point>, FileError> {
    let mut points: Vec<Point> = Vec::new();
    let mut segments = segments.into_iter().peekable();
    while let Some(mut segment) = segments.next() {
        let ends = |segment: &[Point]| segment.first().zip(segment.last()).map(|(a, b)| [*a, *b]);
        let Some([first, last]) = ends(&segment) else { continue };
        // The first one by the one that follows.
        let (turned, apart) = if let Some(end) = points.last() {
            (apart(end, &last) < apart(end, &first), apart(end, &first).min(apart(end, &last)))
        } else {
            let next = segments.peek().and_then(|next| ends(next));
            let near = |end: &Point| {
                next.map_or(0.0, |next| next.iter().map(|a| apart(end, a)).fold(f64::MAX, f64::min))
            };
            (near(&first) < near(&last), 0.0)
        };
        if apart > MAX_DISTANCE_OF_ENDS {
            return Err(FileError::Apart { line: first.line, apart });
        }
        if turned {
            segment.reverse();
        }
        points.extend(segment.into_iter().skip(usize::from(!points.is_empty())));
    }
    Ok(points)
}

fn apart(a: &Point, b: &Point) -> f64 {
    (a.at[0] - b.at[0]).hypot(a.at[1] - b.at[1])
}
