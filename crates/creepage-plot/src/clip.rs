//! Clipping of lines to a frame.

use crate::scene::Point;

/// A rectangle on the sheet: where it starts and ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Left and top.
    pub from: Point,
    /// Right and bottom.
    pub to: Point,
}

impl Frame {
    pub(crate) fn centre(&self) -> Point {
        [0, 1].map(|i| f64::midpoint(self.from[i], self.to[i]))
    }
}

/// The parts of a line through `points` that lie in the frame.
pub(crate) fn clip(points: &[Point], frame: Frame) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    for pair in points.windows(2) {
        let Some([from, to]) = segment([pair[0], pair[1]], frame) else { continue };
        match parts.last_mut() {
            Some(part) if part.last() == Some(&from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
    }
    parts
}

/// Liang's and Barsky's way: the line enters and leaves each pair of parallel sides.
fn segment([from, to]: [Point; 2], frame: Frame) -> Option<[Point; 2]> {
    if !from.iter().chain(&to).all(|coordinate| coordinate.is_finite()) {
        return None;
    }
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for i in 0..2 {
        let (step, low, high) = (to[i] - from[i], frame.from[i], frame.to[i]);
        if step == 0.0 {
            if !(low..=high).contains(&from[i]) {
                return None;
            }
            continue;
        }
        let [one, two] = [(low - from[i]) / step, (high - from[i]) / step];
        enter = enter.max(one.min(two));
        leave = leave.min(one.max(two));
    }
    let at = |share: f64| match share {
        0.0 => from,
        1.0 => to,
        _ => [0, 1].map(|i| from[i] + share * (to[i] - from[i])),
    };
    (enter < leave).then(|| [at(enter), at(leave)])
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Frame = Frame { from: [0.0, 0.0], to: [10.0, 4.0] };

    #[test]
    fn a_line_is_cut_where_it_leaves_the_frame() {
        let parts = clip(&[[-1.0, 1.0], [2.0, 1.0], [5.0, 7.0], [8.0, 1.0]], FRAME);
        let expected = [vec![[0.0, 1.0], [2.0, 1.0], [3.5, 4.0]], vec![[6.5, 4.0], [8.0, 1.0]]];
        assert_eq!(parts, expected);
    }

    #[test]
    fn points_that_are_not_finite_are_not_drawn() {
        assert!(clip(&[[1.0, f64::NAN], [2.0, 1.0], [2.0, f64::INFINITY]], FRAME).is_empty());
    }
}
