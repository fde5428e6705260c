//! View of the contact from above at some distance, and the axes of curves.

use creepage_plot::{Axis, Fill, Label, Panel, Point};

use super::progress::Frame;
use super::run::HistoryRun;

/// White above and below curves, in parts of their range.
const AIR: f64 = 0.06;
/// Places of arrows on the semi-axis of a circle.
const ARROWS: f64 = 5.0;

/// The range of an axis that holds zero and some values.
pub(super) fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = values.fold([0.0_f64; 2], |[low, high], y| [low.min(y), high.max(y)]);
    let air = (AIR * (high - low)).max(1e-3);
    [low - air, high + air]
}

/// View of the contact from above.
pub(super) struct View<'a> {
    /// Corners of the elements under the nominal load.
    pub(super) corners: &'a [[Point; 4]],
    /// Half of what the axes reach over.
    reach: [f64; 2],
}

impl<'a> View<'a> {
    /// Large enough for all that is kept of a history.
    pub(super) fn new(run: &'a HistoryRun) -> Self {
        let corners = run.corners();
        let scale = run.progress().frames.iter().map(|frame| frame.scale).fold(0.0, f64::max);
        let most = |axis: usize| {
            let all = corners.as_flattened().iter().map(|corner| scale * corner[axis].abs());
            1.08 * all.fold(0.1, f64::max)
        };
        Self { corners, reach: [0, 1].map(most) }
    }

    /// Areas of slip and of adhesion.
    pub(super) fn panel(&self, frame: &Frame) -> Panel {
        let axis = |k: usize, name: &str| {
            let label = Label::default().symbol(name).plain("/").symbol("c");
            // Seen from above, y is to the right of the rolling direction.
            let sign = if k == 0 { 1.0 } else { -1.0 };
            Axis::new([-sign * self.reach[k], sign * self.reach[k]], label)
        };
        let of = |slides: bool| {
            let own = self.corners.iter().zip(&frame.slides).filter(|(_, one)| **one == slides);
            let place = |corner: &Point| corner.map(|x| frame.scale * x);
            own.map(|(corners, _)| corners.iter().map(place).collect()).collect::<Vec<_>>()
        };
        Panel::new(axis(0, "x"), axis(1, "y"))
            .to_scale()
            .area(of(true), Fill::SLIP)
            .area(of(false), Fill::ADHESION)
    }

    /// The middle of an element.
    pub(super) fn middle(&self, frame: &Frame, element: usize) -> Point {
        centre(&self.corners[element]).map(|x| frame.scale * x)
    }

    /// Elements evenly spread over the contact, and the length of an arrow over the traction: along
    /// the rolling direction the largest ones just do not touch.
    pub(super) fn arrows(&self) -> (Vec<usize>, f64) {
        let half = [0, 1].map(|k| {
            self.corners.as_flattened().iter().map(|corner| corner[k].abs()).fold(0.0, f64::max)
        });
        let pitch = (half[0] * half[1]).sqrt() / ARROWS;
        let mut elements: Vec<usize> = Vec::new();
        for element in lattice(half, pitch).filter_map(|place| self.nearest(place)) {
            let here = centre(&self.corners[element]);
            let is_near = |other: &usize| far(centre(&self.corners[*other]), here) < 0.75 * pitch;
            if !elements.iter().any(is_near) {
                elements.push(element);
            }
        }
        (elements, 0.75 * pitch)
    }

    fn nearest(&self, place: Point) -> Option<usize> {
        let all = self.corners.iter().map(|corners| far(centre(corners), place)).enumerate();
        all.min_by(|one, two| one.1.total_cmp(&two.1)).map(|(element, _)| element)
    }
}

fn centre(corners: &[Point; 4]) -> Point {
    [0, 1].map(|k| 0.25 * corners.iter().map(|corner| corner[k]).sum::<f64>())
}

fn far([x, y]: Point, [u, v]: Point) -> f64 {
    (x - u).hypot(y - v)
}

/// Places a pitch apart inside an ellipse.
fn lattice(half: [f64; 2], pitch: f64) -> impl Iterator<Item = Point> {
    let steps = move |k: usize| {
        let most = (half[k] / pitch).floor();
        let all = (0_u32..).map(move |step| pitch * (f64::from(step) - most));
        all.take_while(move |at| *at <= half[k])
    };
    let places = steps(1).flat_map(move |y| steps(0).map(move |x| [x, y]));
    places.filter(move |[x, y]| (x / half[0]).hypot(y / half[1]) < 0.97)
}
