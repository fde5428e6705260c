//! Pictures of worn profiles: the shape to scale, the depth over the profile, and an animation with one picture a stop.

use super::run::Wear;
use super::state::{WearStop, WornBody, WornProfile};
use creepage_plot::{Axis, Frames, Label, Panel, Pen, Point, Sheet};
use creepage_rail::Role;

/// White around a profile (mm), and above the depth in parts of it.
const AIR: f64 = 4.0;
const ABOVE: f64 = 0.08;
/// As many stops have a line of their own.
const LINES: usize = 6;

impl Wear {
    /// Wheels or rails as SVG, a column for each that wears; `None` where none does.
    #[must_use]
    pub fn svg(&self, role: Role) -> Option<String> {
        let last = self.stops.last()?;
        let every = self.stops.len().saturating_sub(1).div_ceil(LINES).max(1);
        let lines: Vec<&WearStop> =
            self.stops.iter().rev().step_by(every).filter(|stop| stop.steps > 0).collect();
        let lines: Vec<&WearStop> = lines.into_iter().rev().collect();
        let sheet = self.sheet(role, last, &lines)?;
        let pens = (0..).map(Pen::of);
        Some(
            lines
                .iter()
                .zip(pens)
                .fold(sheet, |sheet, (stop, pen)| sheet.key(pen, stop.way(role)))
                .key(Pen::THIN, Label::new("new"))
                .svg(),
        )
    }

    /// Profiles at a stop above the depth at the stops of `lines`, on axes that hold the whole run.
    pub(super) fn sheet(&self, role: Role, stop: &WearStop, lines: &[&WearStop]) -> Option<Sheet> {
        let (first, last) = (self.stops.first()?, self.stops.last()?);
        let all = WornBody::ALL.into_iter().filter(|body| body.role() == role);
        let shown: Vec<WornBody> = all.filter(|body| first.of(*body).is_some()).collect();
        if shown.is_empty() {
            return None;
        }
        let mut sheet = Sheet::new(&format!("Worn {role}s")).columns(shown.len());
        if shown.len() > 1 {
            sheet = sheet.width(1320.0);
        }
        for body in &shown {
            let (new, worn) = (first.of(*body)?, stop.of(*body)?);
            let [y, z] = [0, 1].map(|axis| range(&new.points, axis));
            let heading = Label::new(&body.name().replace('_', ", "));
            let panel = Panel::new(axis(y), Axis::new([z[1], z[0]], label("z", " down (mm)")))
                .to_scale()
                .heading(heading)
                .curve(millimetres(&new.points), Pen::THIN)
                .curve(millimetres(&worn.points), Pen::OUTLINE);
            sheet = sheet.panel(panel);
        }
        for body in &shown {
            let most = 1e3 * last.of(*body)?.greatest();
            let most = if most > 0.0 { most * (1.0 + ABOVE) } else { 1.0 };
            let upright = Axis::new([0.0, most], Label::new("depth along the normal (mm)"));
            let across = axis(range(&first.of(*body)?.points, 0));
            let mut panel = Panel::new(across, upright).height(260.0);
            for (k, stop) in lines.iter().enumerate() {
                panel = panel.curve(depths(stop.of(*body)?), Pen::of(k));
            }
            sheet = sheet.panel(panel);
        }
        Some(sheet)
    }
}

impl WearStop {
    /// How far it is: the distance of wheels, the passages over rails.
    pub(super) fn way(&self, role: Role) -> Label {
        Label::new(&match role {
            Role::Wheel => format!("{:.0} km", 1e-3 * self.distance),
            Role::Rail => format!("{:.0} passages", self.passages),
        })
    }
}

fn label(symbol: &str, words: &str) -> Label {
    Label::default().symbol(symbol).plain(words)
}

fn axis(range: [f64; 2]) -> Axis {
    Axis::new(range, label("y", " to the field side (mm)"))
}

fn millimetres(points: &[[f64; 2]]) -> Vec<Point> {
    points.iter().map(|[y, z]| [1e3 * y, 1e3 * z]).collect()
}

fn depths(worn: &WornProfile) -> Vec<Point> {
    worn.points.iter().zip(&worn.depth).map(|([y, _], depth)| [1e3 * y, 1e3 * depth]).collect()
}

fn range(points: &[[f64; 2]], axis: usize) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    let [low, high] = points
        .iter()
        .fold(start, |[low, high], point| [low.min(point[axis]), high.max(point[axis])]);
    [1e3 * low - AIR, 1e3 * high + AIR]
}

/// How long it plays, and the shortest and longest time of one picture (milliseconds).
const DURATION: f64 = 6000.0;
const EACH: [f64; 2] = [60.0, 800.0];
/// How long the last picture stays (milliseconds).
const LAST: u16 = 2000;

/// The stops of a run one after the other, from the first with wear.
pub(super) struct Animation(Vec<Sheet>);

impl Animation {
    /// `None` where no body of this kind wears, or with one stop alone.
    pub(super) fn new(wear: &Wear, role: Role) -> Option<Self> {
        let worn = wear.stops.get(1..).filter(|stops| stops.len() > 1)?;
        let sheets = worn.iter().map(|stop| {
            let sheet = wear.sheet(role, stop, &[stop])?;
            Some(sheet.key(Pen::of(0), stop.way(role)).key(Pen::THIN, Label::new("new")))
        });
        sheets.collect::<Option<_>>().map(Self)
    }
}

impl Frames for Animation {
    fn count(&self) -> usize {
        self.0.len()
    }

    fn svg(&self, number: usize) -> String {
        self.0[number].svg()
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
    fn milliseconds(&self, number: usize) -> u16 {
        if number + 1 == self.count() {
            return LAST;
        }
        (DURATION / self.count() as f64).clamp(EACH[0], EACH[1]) as u16
    }
}
