//! Placement of curve names beside their last points.

use crate::clip::Frame;
use crate::label::Label;
use crate::mark::Pen;
use crate::scene::{Point, Scene, Type};

const SIZE: f64 = 14.5;
/// Height of a name.
const ROW: f64 = 17.5;
/// Length of the line before a name outside of the frame, and white before and after it.
const SAMPLE: f64 = 20.0;
const GAP: f64 = 6.0;
/// Curves that end beyond this share of the frame have their names outside of it.
const RIGHT: f64 = 0.85;

/// A curve's name.
#[derive(Debug, Clone)]
pub(crate) struct Name {
    pub(crate) label: Label,
    pub(crate) pen: Pen,
}

impl Name {
    fn width(&self) -> f64 {
        self.label.width(SIZE)
    }
}

/// Whether a name goes to the right of the frame.
pub(crate) fn is_outside(share: f64) -> bool {
    share > RIGHT
}

/// Room that names need on the right of the frame.
pub(crate) fn room<'a>(outside: impl Iterator<Item = &'a Name>) -> f64 {
    outside.map(|name| SAMPLE + 2.0 * GAP + name.width()).fold(0.0, f64::max)
}

/// Whether so many names fit beside a frame of a height.
pub(crate) fn fit(count: usize, height: f64) -> bool {
    count as f64 * ROW <= height
}

/// Draws names of curves that end at `ends` inside the frame, one beside the other.
pub(crate) fn inside(scene: &mut Scene, names: &[(&Name, Point)]) {
    let mut placed: Vec<[Point; 2]> = Vec::new();
    let mut names = names.to_vec();
    names.sort_by(|one, two| one.1[1].total_cmp(&two.1[1]));
    for (name, [x, y]) in names {
        let left = x + GAP;
        let right = left + name.width();
        let meets = |[[from, above], [to, _]]: &&[Point; 2], y: f64| {
            *from < right && left < *to && (y - above).abs() < ROW
        };
        let mut y = y + 5.0;
        while let Some([[_, above], _]) = placed.iter().find(|other| meets(other, y)) {
            y = above + ROW + 0.01;
        }
        placed.push([[left, y], [right, y]]);
        scene.haloed_text([left, y], Type::new(SIZE, name.pen.colour), &name.label);
    }
}

/// Draws names of curves in a column `beyond` the frame's right side, each as near to the height of
/// its curve's end as the others let it.
pub(crate) fn outside(scene: &mut Scene, frame: Frame, beyond: f64, names: &[(&Name, Point)]) {
    let mut names = names.to_vec();
    names.sort_by(|one, two| one.1[1].total_cmp(&two.1[1]));
    let heights = spread(names.iter().map(|(_, end)| end[1]).collect(), frame);
    for ((name, _), y) in names.iter().zip(heights) {
        let left = frame.to[0] + beyond + GAP;
        scene.line(&[[left, y], [left + SAMPLE, y]], name.pen.ink());
        let style = Type::new(SIZE, name.pen.colour);
        scene.text([left + SAMPLE + GAP, y + 5.0], style, &name.label);
    }
}

/// Heights from above to below, moved apart by as little as may be, within the frame.
fn spread(mut heights: Vec<f64>, frame: Frame) -> Vec<f64> {
    let [top, bottom] = [frame.from[1] + 0.5 * ROW, frame.to[1] - 0.5 * ROW];
    // Groups of names that touch, each about the mean of its ends.
    let mut groups: Vec<(f64, usize)> = Vec::new();
    for height in &heights {
        groups.push((*height, 1));
        while let [.., (above, m), (below, n)] = groups[..] {
            if below - above >= 0.5 * ROW * (m + n) as f64 {
                break;
            }
            let middle = (above * m as f64 + below * n as f64) / (m + n) as f64;
            groups.truncate(groups.len() - 2);
            groups.push((middle, m + n));
        }
    }
    let each = groups.iter().flat_map(|(middle, count)| {
        let first = middle - 0.5 * ROW * (*count as f64 - 1.0);
        (0..*count).map(move |k| first + ROW * k as f64)
    });
    for (height, spread) in heights.iter_mut().zip(each) {
        *height = spread;
    }
    let mut least = top;
    for height in &mut heights {
        *height = height.max(least);
        least = *height + ROW;
    }
    let mut most = bottom;
    for height in heights.iter_mut().rev() {
        *height = height.min(most);
        most = *height - ROW;
    }
    heights
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Frame = Frame { from: [0.0, 0.0], to: [100.0, 200.0] };

    #[test]
    fn names_that_do_not_touch_stay_where_they_are() {
        assert_eq!(spread(vec![20.0, 60.0, 150.0], FRAME), [20.0, 60.0, 150.0]);
    }

    #[test]
    fn names_that_touch_move_apart_about_their_middle() {
        let spread = spread(vec![100.0, 101.0, 102.0], FRAME);
        assert!((spread[1] - 101.0).abs() < 1e-9, "{spread:?}");
        assert!(spread.windows(2).all(|pair| (pair[1] - pair[0] - ROW).abs() < 1e-9));
    }

    #[test]
    fn all_stay_within_the_frame() {
        for heights in [vec![-50.0, -40.0, 0.0], vec![199.0, 199.5, 260.0], vec![100.0; 11]] {
            let spread = spread(heights, FRAME);
            assert!(spread.windows(2).all(|pair| pair[1] - pair[0] > ROW - 1e-9), "{spread:?}");
            assert!(spread.iter().all(|y| (8.0..=192.0).contains(y)), "{spread:?}");
        }
    }
}
