//! One panel of the creep-force curves.

use creepage::rolling::{Force, Status};

use crate::axis::Axis;
use crate::clip::clip;
use crate::curve_legend::{CASE, pen};
use crate::curves::{Curve, Curves};
use crate::format::Scale;
use crate::label::Label;
use crate::scene::{Anchor, Ink, Point, Scene, Type};
use crate::sheet::{Area, DARK, GREY, MARGIN, PALE, WIDTH};

pub(crate) const NUMBERS: Type =
    Type { size: 14.0, colour: DARK, bold: false, anchor: Anchor::Middle };
pub(crate) const WORDS: Type =
    Type { size: 15.0, colour: DARK, bold: false, anchor: Anchor::Start };
/// Length of a tick.
pub(crate) const TICK: f64 = 5.0;
/// White above and below the curves, in parts of their range.
const AIR: f64 = 0.06;

/// One component of the force over the range.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Panel {
    pub(crate) words: &'static str,
    /// Dimensionless, and with its dimension.
    pub(crate) symbols: [&'static str; 2],
    pub(crate) index: &'static str,
    /// Symbol of the unit, its SI value, and the SI unit of that.
    pub(crate) unit: (&'static str, f64, &'static str),
    /// Friction allows no more: theories that do not know are cut off.
    pub(crate) limit: f64,
    pub(crate) of: fn(Force) -> f64,
}

impl Panel {
    fn values(self, curve: &Curve) -> impl Iterator<Item = f64> {
        curve.solutions.iter().map(move |solution| (self.of)(solution.force))
    }

    /// Largest size of this component on any curve.
    pub(crate) fn largest(self, curves: &Curves) -> f64 {
        curves.lines.iter().flat_map(|curve| self.values(curve)).fold(0.0, |m, v| m.max(v.abs()))
    }

    /// The range of the curves, zero included.
    fn axis(self, curves: &Curves) -> Axis {
        let values = curves.lines.iter().flat_map(|curve| self.values(curve));
        let (mut low, mut high) = values.fold((0.0, 0.0), |(low, high): (f64, f64), value| {
            (low.min(value.max(-self.limit)), high.max(value.min(self.limit)))
        });
        let air = AIR * (high - low).max(f64::MIN_POSITIVE);
        // What only rounding has put on the other side of zero needs none.
        if low < -1e-3 * air {
            low -= air;
        } else {
            low = 0.0;
        }
        if high > 1e-3 * air || low >= 0.0 {
            high += air;
        } else {
            high = 0.0;
        }
        Axis::new(low, high)
    }

    /// Draws the panel into `frame`, with its heading on a line at `heading`.
    pub(crate) fn draw(
        self,
        scene: &mut Scene,
        frame: Area,
        heading: f64,
        x: Axis,
        curves: &Curves,
    ) {
        let y = self.axis(curves);
        let plot = Plot { frame, x, y };
        plot.grid(scene);
        let case = curves.vary.of(curves.case);
        if curves.reach(case) {
            let x = plot.at([case, 0.0])[0];
            scene.line(&[[x, frame.from[1]], [x, frame.to[1]]], CASE);
        }
        for (k, curve) in curves.lines.iter().enumerate() {
            plot.curve(scene, k, curves, curve, self.of);
        }
        let [width, height] = [0, 1].map(|i| frame.to[i] - frame.from[i]);
        scene.rectangle(frame.from, [width, height], 0.0, Ink::line(GREY, 1.2));
        self.heading(scene, heading, y);
        self.numbers(scene, plot);
    }

    fn scale(self, y: Axis) -> Scale {
        let (_, unit, name) = self.unit;
        Scale::of(y.from.abs().max(y.to.abs()) * unit, name, 4)
    }

    /// What is on the left and what on the right axis.
    fn heading(self, scene: &mut Scene, baseline: f64, y: Axis) {
        let [small, large] = self.symbols;
        let label = Label::new(self.words).indexed(small, self.index).plain(" = ");
        let label = label.indexed(large, self.index).plain("/").symbol(self.unit.0);
        scene.text([MARGIN, baseline], WORDS, &label);
        let unit = format!(" [{}]", self.scale(y).unit);
        let label = Label::default().indexed(large, self.index).plain(&unit);
        scene.text([WIDTH - MARGIN, baseline], WORDS.anchored(Anchor::End), &label);
    }

    fn numbers(self, scene: &mut Scene, plot: Plot) {
        let (left, right) = (plot.frame.from[0], plot.frame.to[0]);
        for (value, text) in plot.y.ticks() {
            let height = plot.height(plot.y.share(value));
            let at = [left - TICK - 5.0, height + 5.0];
            scene.line(&[[left - TICK, height], [left, height]], Ink::line(GREY, 1.2));
            let label = Label::default().number(&text);
            scene.text(at, NUMBERS.anchored(Anchor::End), &label);
        }
        let si = plot.y.scaled(self.scale(plot.y).factor / self.unit.1);
        for (value, text) in si.ticks() {
            let height = plot.height(si.share(value));
            let at = [right + TICK + 5.0, height + 5.0];
            scene.line(&[[right, height], [right + TICK, height]], Ink::line(GREY, 1.2));
            let label = Label::default().number(&text);
            scene.text(at, NUMBERS.anchored(Anchor::Start), &label);
        }
    }
}

/// A frame with its two axes.
#[derive(Clone, Copy)]
struct Plot {
    frame: Area,
    x: Axis,
    y: Axis,
}

impl Plot {
    fn height(&self, share: f64) -> f64 {
        self.frame.to[1] - share * (self.frame.to[1] - self.frame.from[1])
    }

    fn at(&self, [x, y]: Point) -> Point {
        [across(self.frame, self.x.share(x)), self.height(self.y.share(y))]
    }

    fn grid(&self, scene: &mut Scene) {
        let Area { from: [left, top], to: [right, bottom] } = self.frame;
        let ink = |value: f64| match value {
            0.0 => Ink::line(GREY, 1.0),
            _ => Ink::line(PALE, 0.8),
        };
        for (value, _) in self.x.ticks() {
            let x = across(self.frame, self.x.share(value));
            scene.line(&[[x, top], [x, bottom]], ink(value));
        }
        for (value, _) in self.y.ticks() {
            let y = self.height(self.y.share(value));
            scene.line(&[[left, y], [right, y]], ink(value));
        }
    }

    /// In the pen of number `k`; thin where the theory does not stand for it.
    fn curve(
        &self,
        scene: &mut Scene,
        k: usize,
        curves: &Curves,
        curve: &Curve,
        of: fn(Force) -> f64,
    ) {
        let points: Vec<_> = (curves.values.iter().zip(&curve.solutions))
            .map(|(x, solution)| {
                (self.at([*x, of(solution.force)]), solution.status == Status::Solved)
            })
            .collect();
        for (solved, part) in parts(&points) {
            for line in clip(&part, self.frame) {
                scene.line(&line, pen(k, solved));
            }
        }
    }
}

/// Where a share of the range of x lies on the sheet.
pub(crate) fn across(frame: Area, share: f64) -> f64 {
    frame.from[0] + share * (frame.to[0] - frame.from[0])
}

/// A line in parts that are each solved or not throughout.
fn parts(points: &[(Point, bool)]) -> Vec<(bool, Vec<Point>)> {
    let mut parts: Vec<(bool, Vec<Point>)> = Vec::new();
    for pair in points.windows(2) {
        let solved = pair[0].1 && pair[1].1;
        match parts.last_mut() {
            Some((kind, part)) if *kind == solved => part.push(pair[1].0),
            _ => parts.push((solved, vec![pair[0].0, pair[1].0])),
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn doubtful_points_make_parts_of_their_own() {
        let line = [true, true, false, true, true];
        let line: Vec<_> =
            line.iter().enumerate().map(|(x, solved)| ([x as f64, 1.0], *solved)).collect();
        let parts = parts(&line);
        let kinds: Vec<_> = parts.iter().map(|(solved, part)| (*solved, part.len())).collect();
        assert_eq!(kinds, [(true, 2), (false, 3), (true, 2)]);
    }
}
