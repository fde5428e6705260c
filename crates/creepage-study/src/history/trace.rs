//! Traces over the distance rolled, as a history has them: what a row holds is constant over it, what follows from it is
//! known at its end.

use creepage::unsteady::Prescribed;
use creepage_plot::{Label, Mark, Panel, Pen, Point, Shape};

use super::progress::Moment;
use super::roller::HistoryMotion;
use super::run::HistoryRun;

/// With more rows than this their ends are not marked.
const MARKED: usize = 40;
/// Half the width of a mark.
const SIZE: f64 = 2.6;

/// One quantity of a history.
pub(super) struct Trace {
    /// Distance (mm) and value, two points for a row that holds it.
    pub points: Vec<Point>,
    /// Ends of rows at which it was found; none where there are many.
    marks: Vec<Point>,
}

impl Trace {
    /// A component of the force, from the one at the start.
    pub(super) fn force(run: &HistoryRun, component: usize) -> Self {
        let start = [0.0, run.start_force()[component]];
        let mut load = run.history().rows.first().map_or(1.0, |row| row.motion.load);
        // A load that changes takes a force with it.
        let is_held = |motion: &HistoryMotion| {
            let before = std::mem::replace(&mut load, motion.load);
            matches!(prescribed(motion, component), Prescribed::Force(_))
                && (before - motion.load).abs() < 1e-12
        };
        Self::new(run, Some(start), |moment| moment.force[component], is_held)
    }

    /// A component of the creepage.
    pub(super) fn creepage(run: &HistoryRun, component: usize) -> Self {
        let is_held = |motion: &HistoryMotion| {
            matches!(prescribed(motion, component), Prescribed::Creepage(_))
        };
        Self::new(run, None, |moment| moment.creepage[component], is_held)
    }

    fn new(
        run: &HistoryRun,
        start: Option<Point>,
        value: impl Fn(&Moment) -> f64,
        mut is_held: impl FnMut(&HistoryMotion) -> bool,
    ) -> Self {
        let moments = &run.progress().moments;
        let (mut points, mut marks): (Vec<_>, _) = (start.into_iter().collect(), Vec::new());
        let mut before = 0.0;
        for (moment, row) in moments.iter().zip(&run.history().rows) {
            let end = [1e3 * moment.distance, value(moment)];
            if is_held(&row.motion) {
                points.push([before, end[1]]);
            } else {
                marks.push(end);
            }
            points.push(end);
            before = end[0];
        }
        if moments.len() > MARKED {
            marks.clear();
        }
        Self { points, marks }
    }

    /// Whether it is more than zero anywhere.
    pub(super) fn is_there(&self) -> bool {
        self.points.iter().any(|point| point[1].abs() > 1e-6)
    }

    /// Draws it.
    pub(super) fn on(&self, panel: Panel, pen: Pen) -> Panel {
        let mark = Mark { size: SIZE, ..Mark::full(Shape::Circle, pen.colour) };
        panel.curve(self.points.clone(), pen).marks(self.marks.clone(), mark)
    }
}

fn prescribed(HistoryMotion { motion, .. }: &HistoryMotion, component: usize) -> Prescribed {
    [motion.longitudinal, motion.lateral, motion.spin][component]
}

/// The names of force and moment.
pub(super) fn force_labels() -> [Label; 3] {
    let label = Label::default;
    [label().indexed("f", "x"), label().indexed("f", "y"), label().indexed("m", "z")]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{History, RollFile};

    const CASE: &str = r#"
        upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.5, radius_lateral = "flat" }
        lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = "flat", radius_lateral = 0.4 }
        contact = { normal_force = 60e3, friction = 0.25 }
        solve = { theory = "fastsim" }
    "#;

    fn traces(table: &str) -> [Trace; 4] {
        let case = RollFile::read(CASE).unwrap().case(".".as_ref()).unwrap();
        let history = History::read(table.as_bytes(), &case).unwrap();
        let mut run = HistoryRun::new(&case, &history).unwrap();
        while run.next_row().unwrap().is_some() {}
        let [fx, fy] = [0, 1].map(|k| Trace::force(&run, k));
        [fx, fy, Trace::creepage(&run, 0), Trace::creepage(&run, 1)]
    }

    /// The jump of a prescribed quantity is upright in the picture; what follows from it starts at the
    /// contact without traction.
    #[test]
    fn a_prescribed_quantity_is_drawn_in_steps_and_its_answer_in_lines() {
        let [fx, fy, xi, eta] =
            traces("distance,xi,lateral_force\n0.003,0.4,2e3\n0.007,-0.2,-1e3\n0.1,-0.2,-1e3\n");
        let steps = [[0.0, 0.4], [3.0, 0.4], [3.0, -0.2], [7.0, -0.2], [7.0, -0.2], [100.0, -0.2]];
        assert_eq!(xi.points.len(), 6);
        for (point, right) in xi.points.iter().zip(steps) {
            assert!((point[0] - right[0]).abs() < 1e-9 && (point[1] - right[1]).abs() < 1e-12);
        }
        assert!(xi.marks.is_empty() && fy.marks.is_empty());
        assert_eq!((fy.points.len(), fy.points[0]), (7, [0.0, 0.0]));
        // Met to 1e-9 of the friction force.
        assert!(
            (fy.points[3][1] + 1e3 / 15e3).abs() < 1e-8
                && (fy.points[3][0] - fy.points[2][0]).abs() < 1e-12
        );
        assert_eq!((fx.points.len(), fx.points[0], fx.marks.len()), (4, [0.0, 0.0], 3));
        assert_eq!((eta.points.len(), eta.marks.len()), (3, 3));
    }
}
