//! Animation of a rolling contact: areas, tractions, and where on the curve of the forces it is.

use creepage_plot::theme::ARROW;
use creepage_plot::{Axis, Fill, Frames, Label, Panel, Pen, Point, Sample, Sheet};

use super::progress::{Frame, LEAST_TRACTION};
use super::run::HistoryRun;
use super::trace::{Trace, force_labels};
use super::view::{View, range};

/// How long it plays (milliseconds): a hundred pictures are then eleven a second.
const DURATION: f64 = 9000.0;
/// The shortest and the longest time that an eye follows one picture (milliseconds).
const EACH: [f64; 2] = [40.0, 1000.0];
/// How long the last one stays (milliseconds).
const LAST: u16 = 1500;
const WIDTH: f64 = 600.0;
/// The traction along a line contact.
const TRACTION: Pen = Pen { colour: ARROW, dashes: "", width: 2.2 };

/// The animation of a history, at a constant rolling velocity.
pub(super) struct Animation<'a> {
    frames: &'a [Frame],
    /// The forces along and across that are not zero, with their pens.
    forces: Vec<(Trace, Pen, Label)>,
    /// The whole one (mm).
    distance: f64,
    view: View<'a>,
    is_line: bool,
    /// Elements with an arrow, and its length over the traction.
    arrows: (Vec<usize>, f64),
}

impl<'a> Animation<'a> {
    /// `None` where nothing was kept.
    pub(super) fn new(run: &'a HistoryRun) -> Option<Self> {
        let frames = &run.progress().frames[..];
        // The first picture is all that some programs show: it is one with tractions.
        let first = frames.iter().position(Frame::has_traction).unwrap_or_default();
        let (view, is_line) = (View::new(run), run.case().is_line());
        let arrows = if is_line { Default::default() } else { view.arrows() };
        let labels = force_labels().into_iter().take(2).enumerate();
        let forces = labels.map(|(k, label)| (Trace::force(run, k), Pen::of(k), label));
        let forces = forces.filter(|(trace, ..)| trace.is_there()).collect();
        let distance = run.progress().moments.last().map_or(1.0, |last| 1e3 * last.distance);
        let frames = &frames[first..];
        (!frames.is_empty()).then_some(Self { frames, forces, distance, view, is_line, arrows })
    }

    /// The contact seen from above.
    fn ellipse(&self, frame: &Frame) -> Panel {
        let (places, length) = &self.arrows;
        places.iter().fold(self.view.panel(frame), |panel, place| {
            let (middle, [x, y]) = (self.view.middle(frame, *place), frame.tractions[*place]);
            let end = |sign: f64| {
                let half = 0.5 * sign * length;
                [middle[0] + half * x, middle[1] + half * y]
            };
            // What is no arrow on the sheet is no point either.
            let is_drawn = x.hypot(y) > LEAST_TRACTION;
            if is_drawn { panel.arrow(end(-1.0), end(1.0), 1.6, ARROW) } else { panel }
        })
    }

    /// The forces over the distance, and where on it the contact is.
    fn curve(&self, frame: &Frame) -> Panel {
        let at = 1e3 * frame.distance;
        let range = range(self.forces.iter().flat_map(|one| &one.0.points).map(|point| point[1]));
        let x = Axis::new([0.0, self.distance], Label::new("distance rolled (mm)"));
        let y = Axis::new(range, Label::new("force over ").symbol("μN"));
        let here = range.map(|y| [at, y]).to_vec();
        let panel = Panel::new(x, y).height(110.0).curve(here, Pen::OUTLINE.wide(3.0));
        self.forces.iter().fold(panel, |panel, (trace, pen, _)| trace.on(panel, *pen))
    }
}

impl Frames for Animation<'_> {
    fn count(&self) -> usize {
        self.frames.len()
    }

    fn svg(&self, number: usize) -> String {
        let frame = &self.frames[number];
        let contact = if self.is_line { self.view.strip(frame) } else { self.ellipse(frame) };
        let words = format!("{:.3} mm rolled", 1e3 * frame.distance);
        let mut sheet = Sheet::new("Rolling to the right")
            .width(WIDTH)
            .panel(contact.heading(Label::new(&words)))
            .panel(self.curve(frame))
            .key(Fill::ADHESION, Label::new("adhesion"))
            .key(Fill::SLIP, Label::new("slip"));
        sheet = if self.is_line {
            sheet.key(TRACTION, Label::new("traction over ").indexed("μp", "0"))
        } else {
            sheet.key(Sample::arrow(ARROW), Label::new("traction"))
        };
        let keys = self.forces.iter().map(|(_, pen, label)| (*pen, label.clone()));
        keys.fold(sheet, |sheet, (pen, label)| sheet.key(pen, label)).svg()
    }

    /// In proportion to the distance to the next picture.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
    fn milliseconds(&self, number: usize) -> u16 {
        let (Some(next), Some(last)) = (self.frames.get(number + 1), self.frames.last()) else {
            return LAST;
        };
        let share = (next.distance - self.frames[number].distance) / last.distance;
        (DURATION * share).clamp(EACH[0], EACH[1]) as u16
    }
}

impl View<'_> {
    /// A line contact: the traction along it within its bound.
    fn strip(&self, frame: &Frame) -> Panel {
        let areas = |slides: bool| {
            let own = self.corners.iter().zip(&frame.slides).filter(|(_, one)| **one == slides);
            let tall = |corners: &[Point; 4]| {
                let x = corners.map(|corner| corner[0]);
                let (low, high) = (x.iter().copied().fold(x[0], f64::min), x[0].max(x[2]));
                vec![[low, -1.0], [high, -1.0], [high, 1.0], [low, 1.0]]
            };
            own.map(|(corners, _)| tall(corners)).collect::<Vec<_>>()
        };
        let along: Vec<_> = (0..=120).map(|k| f64::from(k) / 60.0 - 1.0).collect();
        let bound = |sign: f64| along.iter().map(|x| [*x, sign * (1.0 - x * x).sqrt()]).collect();
        let traction = |(k, traction): (usize, &[f64; 2])| [self.middle(frame, k)[0], traction[0]];
        let traction = frame.tractions.iter().enumerate().map(traction).collect();
        let x = Axis::new([-1.08, 1.08], Label::default().symbol("x").plain("/").symbol("a"));
        let y = Axis::new([-1.0, 1.0], Label::new("traction over ").indexed("μp", "0"));
        Panel::new(x, y)
            .height(240.0)
            .area(areas(true), Fill::SLIP)
            .area(areas(false), Fill::ADHESION)
            .curve(bound(1.0), Pen::GUIDE)
            .curve(bound(-1.0), Pen::GUIDE)
            .curve(traction, TRACTION)
    }
}
