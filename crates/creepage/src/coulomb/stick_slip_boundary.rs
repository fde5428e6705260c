//! The boundary between stick and slip, located inside elements.
//!
//! Where slip begins, the traction of adhesion nears its bound as the root of the distance that is
//! left; where slip ends, its speed falls as the distance to the power 3/2. Along each strip the border
//! is found by these laws between the middles of elements, and across strips by interpolation. What is
//! much narrower than an element is not seen.

use super::grid::Grid;
use super::mesh::{Mesh, Strip};
use super::solver::State;

/// Power of the part of an element at which traction and slip, taken as linear, meet the border where
/// slip begins, and how far ahead of that it is, in elements: 2 and nothing by the root alone, which
/// elements average, and whose corner the solver rounds. Chosen on 96 random cases against 96 x 80
/// elements: of borders alone in their strip half then err by less than 0.05 elements.
const BEGINS: [f64; 2] = [1.75, 0.12];
/// Largest distance by which the end of slip is extrapolated beyond an element's middle, in elements.
const REACH: f64 = 1.5;
/// Least distance from adhesion in a strip that slides all along, in elements.
const MIN_DISTANCE: f64 = 0.1;

/// The areas of adhesion of every strip.
#[derive(Debug, Clone)]
pub(crate) struct Borders {
    strips: Vec<Intervals>,
    /// Of a strip that slides all along, the strips beside it that do not, each with the one beyond.
    beside: Vec<Vec<[usize; 2]>>,
}

/// The `x` from where to where a strip adheres, on its middle line, from the leading edge on. What reaches
/// an edge has no border there, and goes on beyond it.
#[derive(Debug, Clone)]
struct Intervals {
    intervals: Vec<[f64; 2]>,
    /// Mean length of an element.
    element: f64,
}

impl Borders {
    pub(crate) fn new(grid: &Grid, state: &State) -> Self {
        let mesh = &grid.mesh;
        let along = |(j, strip): (usize, &Strip)| {
            let elements = || mesh.elements(j);
            let excess: Vec<f64> = elements().map(|e| state.excess(grid, e)).collect();
            let speed: Vec<f64> = elements().map(|e| state.speed(e)).collect();
            Intervals::new(&excess, &speed, strip)
        };
        let strips: Vec<_> = mesh.strips.iter().enumerate().map(along).collect();
        let beside = (0..strips.len()).map(|j| beside(mesh, &strips, j)).collect();
        Self { strips, beside }
    }

    /// How far a position is from the border, positive in slip: the strips around it, with their weights,
    /// and its `x`. Beyond the middle line of an outermost strip that slides, all slides.
    pub(crate) fn beyond(&self, strips: [(usize, f64); 2], x: f64) -> f64 {
        let [(own, _), (_, weight)] = strips;
        if weight < 0.0 && self.strips[own].intervals.is_empty() {
            return self.on(own, x);
        }
        strips.iter().map(|(strip, weight)| weight * self.on(*strip, x)).sum()
    }

    /// The same on the middle line of a strip. In one that slides all along it is extrapolated, so that
    /// areas of adhesion end where their borders meet.
    fn on(&self, strip: usize, x: f64) -> f64 {
        let own = &self.strips[strip];
        let extrapolated = self.beside[strip]
            .iter()
            .map(|[near, far]| 2.0 * self.strips[*near].beyond(x) - self.strips[*far].beyond(x));
        match extrapolated.reduce(f64::min) {
            Some(beyond) => beyond.max(MIN_DISTANCE * own.element),
            None => own.beyond(x),
        }
    }
}

/// What is kept of a strip in [`Borders::beside`].
fn beside(mesh: &Mesh, strips: &[Intervals], j: usize) -> Vec<[usize; 2]> {
    let patch = &mesh.strips[j].patch;
    let pairs = [-1, 1].map(|side| [1, 2].map(|away| j.checked_add_signed(side * away)));
    let within = |k: Option<usize>| k.filter(|k| patch.contains(k));
    let pair = |[near, far]: [Option<usize>; 2]| Some([within(near)?, within(far).or(near)?]);
    let adheres = |[near, _]: &[usize; 2]| !strips[*near].intervals.is_empty();
    let all = pairs.into_iter().filter_map(pair).filter(adheres);
    if strips[j].intervals.is_empty() { all.collect() } else { Vec::new() }
}

impl Intervals {
    /// By how much the trial traction of each element exceeds its bound, and the speed of its slip.
    fn new(excess: &[f64], speed: &[f64], strip: &Strip) -> Self {
        let (x, angles) = (|angle: f64| strip.middle_x(angle.sin()), &strip.along.angles);
        let adheres = |i: usize| excess[i] <= 0.0;
        let mut intervals: Vec<[f64; 2]> = Vec::new();
        let mut front = adheres(0).then_some(f64::INFINITY);
        for i in 0..excess.len() - 1 {
            let [middle, next] = [angles[i], angles[i + 1]];
            let crossing = excess[i] / (excess[i] - excess[i + 1]);
            match (adheres(i), adheres(i + 1)) {
                (true, false) => {
                    let part = crossing.powf(BEGINS[0]) - BEGINS[1];
                    let rear = x(middle + part * (next - middle));
                    intervals.extend(front.take().filter(|front| rear < *front).map(|f| [rear, f]));
                }
                (false, true) => {
                    let part = slip_left(&speed[..=i]).unwrap_or(crossing).clamp(0.0, REACH);
                    front = Some(x(middle + part * (next - middle)));
                }
                _ => {}
            }
        }
        let element = (strip.middle_x(1.0) - strip.middle_x(-1.0)) / excess.len() as f64;
        intervals.extend(front.map(|front| [strip.middle_x(-1.0) - element, front]));
        Self { intervals, element }
    }

    /// Distance from the nearest border, positive in slip; where all slides, one element.
    fn beyond(&self, x: f64) -> f64 {
        let from_border = |[rear, front]: &[f64; 2]| {
            let nearest = (x - rear).abs().min((x - front).abs());
            if (*rear..=*front).contains(&x) { -nearest } else { nearest }
        };
        self.intervals.iter().map(from_border).reduce(f64::min).unwrap_or(self.element)
    }
}

/// After how many elements beyond the last the slip of some elements ends, by that of the last two.
fn slip_left(speed: &[f64]) -> Option<f64> {
    let [.., before, last] = speed else { return None };
    let [before, last] = [before, last].map(|speed| speed.powf(2.0 / 3.0));
    (before > last).then(|| last / (before - last))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ellipse::Ellipse;

    const COUNT: usize = 40;

    fn mesh() -> Mesh {
        Mesh::ellipse(Ellipse::from_ratio(1.0).unwrap(), COUNT, 5)
    }

    /// A strip that adheres between two angles, by the laws of the module.
    fn strip([front, rear]: [f64; 2]) -> Intervals {
        let mesh = mesh();
        let angle = |i: usize| -mesh.strips[2].along.angles[i];
        let speed = |i: usize| match angle(i) {
            x if x < front => (front - x).powf(1.5),
            x if x > rear => (x - rear).sqrt(),
            _ => 0.0,
        };
        let excess = |i: usize| match angle(i) {
            x if (front..rear).contains(&x) => -(rear - x).sqrt().min(0.5),
            _ => 0.3 * speed(i),
        };
        let (excess, speed): (Vec<f64>, Vec<f64>) =
            (0..COUNT).map(|i| (excess(i), speed(i))).unzip();
        Intervals::new(&excess, &speed, &mesh.strips[2])
    }

    /// The end of slip is found by its law to rounding, its beginning within a quarter of an element:
    /// the law alone leaves out what elements average.
    #[test]
    fn both_borders_are_found_inside_elements() {
        for k in 0..20 {
            let borders = [-0.5, 0.6].map(|at| at + 0.01 * f64::from(k));
            let found = strip(borders);
            let wanted = borders.map(|angle| mesh().strips[2].middle_x(-angle.sin()));
            let [rear, front] = found.intervals[0];
            assert!(found.intervals.len() == 1 && (front - wanted[0]).abs() < 1e-12);
            let largest = 0.25 * 1.6 * found.element;
            assert!((rear - wanted[1]).abs() < largest, "{rear} {wanted:?}");
        }
    }

    #[test]
    fn the_distance_changes_its_sign_at_the_borders_alone() {
        let intervals = vec![[0.3, f64::INFINITY], [-0.5, -0.1]];
        let found = Intervals { intervals, element: 0.1 };
        for (x, beyond) in [(1.5, -1.2), (0.3, 0.0), (0.2, 0.1), (-0.2, -0.1), (-0.9, 0.4)] {
            assert!((found.beyond(x) - beyond).abs() < 1e-15, "{x}");
        }
    }

    /// Half of the strips adhere up to a straight border that meets the leading edge.
    #[test]
    fn a_border_goes_on_straight_into_a_strip_that_slides() {
        let mesh = mesh();
        let y: Vec<f64> = mesh.strips.iter().map(Strip::y).collect();
        let interval = |j: usize| vec![[0.6 + y[j], f64::INFINITY]];
        let all = [interval(0), interval(1), interval(2), vec![], vec![]];
        let strips: Vec<_> =
            all.map(|intervals| Intervals { intervals, element: 0.05 }).into_iter().collect();
        let beside = (0..5).map(|j| beside(&mesh, &strips, j)).collect();
        let borders = Borders { strips, beside };
        let at = |x: f64, y: f64| {
            let strip = mesh.strips.partition_point(|strip| strip.borders()[1] <= y);
            borders.beyond(mesh.strips_across(strip, y), x)
        };
        for (x, y) in [(-0.3, -0.9), (0.1, -0.5), (0.6, 0.0), (0.6 + 0.9 * y[3] - 0.1, y[3] - 0.1)]
        {
            assert!((at(x, y) - (0.6 + y - x)).abs() < 1e-14 || y > 0.0, "{x} {y}");
            assert!((at(x, y) > 0.0) == (x < 0.6 + y), "{x} {y}");
        }
        assert!(at(0.9, y[4]) > 0.0);
    }

    #[test]
    fn all_adhesion_has_no_border() {
        let all = |excess: f64| Intervals::new(&[excess; COUNT], &[0.0; COUNT], &mesh().strips[2]);
        assert!(all(-1.0).beyond(1.0) < 0.0 && all(-1.0).beyond(-1.0) < 0.0);
        assert!(all(0.2).beyond(0.5) > 0.0 && all(0.2).intervals.is_empty());
    }
}
