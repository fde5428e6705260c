//! Forces over the distance rolled, and the areas of adhesion and slip at some stations.

use creepage_plot::{Axis, Fill, Label, Panel, Pen, Point, Sheet};

use super::animation::Animation;
use super::progress::{Frame, Moment};
use super::run::HistoryRun;
use super::view::{View, is_there, range};
use crate::error::ReportError;

/// Contacts in the picture of areas.
const STATIONS: usize = 6;

/// The pictures of a history as SVG, with their names: `history` and, for an ellipse, `adhesion`.
#[must_use]
pub fn history_picture(run: &HistoryRun) -> Vec<(&'static str, String)> {
    let mut pictures = vec![("history", forces(&run.progress().moments))];
    // The first is the start.
    if let Some((_, frames)) = run.progress().frames.split_first()
        && !run.case().is_line()
    {
        pictures.push(("adhesion", areas(run, &stations(frames))));
    }
    pictures
}

/// The contact on its way as an animated PNG; `None` by FASTSIM, which has no such elements.
///
/// # Errors
/// [`ReportError::Picture`] where it does not turn into pixels.
pub fn history_animation(run: &HistoryRun) -> Result<Option<Vec<u8>>, ReportError> {
    Animation::new(run).map(|one| Ok(creepage_plot::animated_png(&one)?)).transpose()
}

/// Some of the contacts that were kept, evenly spread.
fn stations(frames: &[Frame]) -> Vec<&Frame> {
    let (all, stations) = (frames.len(), STATIONS.min(frames.len()));
    let station = |k: usize| k * stations / all;
    let last = (1..=all).filter(|k| station(*k) > station(k - 1));
    last.filter_map(|k| frames.get(k - 1)).collect()
}

/// A picture as PNG.
///
/// # Errors
/// [`ReportError::Picture`] where it does not turn into pixels.
pub fn to_png(svg: &str) -> Result<Vec<u8>, ReportError> {
    Ok(creepage_plot::png(svg)?)
}

fn forces(moments: &[Moment]) -> String {
    let x = [0.0, moments.last().map_or(1.0, |last| 1e3 * last.distance)];
    let of = |value: fn(&Moment) -> f64| -> Vec<Point> {
        moments.iter().map(|moment| [1e3 * moment.distance, value(moment)]).collect()
    };
    let label = |name: &str| Label::new(name);
    let forces = [
        (of(|moment| moment.force[0]), Label::default().indexed("f", "x")),
        (of(|moment| moment.force[1]), Label::default().indexed("f", "y")),
        (of(|moment| moment.force[2]), Label::default().indexed("m", "z")),
    ];
    let creepages = [
        (of(|moment| moment.creepage[0]), Label::default().symbol("ξ")),
        (of(|moment| moment.creepage[1]), Label::default().symbol("η")),
        (of(|moment| moment.creepage[2]), Label::default().symbol("χ")),
    ];
    let panel = |lines: &[(Vec<Point>, Label)], first: usize, name: &str, is_last: bool| {
        let values = lines.iter().flat_map(|(points, _)| points.iter().map(|point| point[1]));
        let along = Axis::new(x, label("distance rolled (mm)"));
        let along = if is_last { along } else { along.shared() };
        let panel = Panel::new(along, Axis::new(range(values), label(name))).height(300.0);
        let drawn = lines.iter().enumerate().filter(|(_, (points, _))| is_there(points));
        drawn.fold(panel, |panel, (k, (points, _))| panel.curve(points.clone(), Pen::of(first + k)))
    };
    let mut sheet = Sheet::new("Forces and creepages over the distance rolled")
        .panel(panel(&forces, 0, "force over μN", false))
        .panel(panel(&creepages, 3, "creepage", true));
    for (k, (points, label)) in forces.into_iter().chain(creepages).enumerate() {
        if is_there(&points) {
            sheet = sheet.key(Pen::of(k), label);
        }
    }
    sheet.svg()
}

fn areas(run: &HistoryRun, stations: &[&Frame]) -> String {
    let sheet = Sheet::new("Adhesion and slip while the contact rolls to the right").columns(3);
    let view = View::new(run);
    let sheet = stations.iter().fold(sheet, |sheet, frame| {
        let heading = Label::new(&format!("{:.4} m", frame.distance));
        sheet.panel(view.panel(frame).heading(heading))
    });
    sheet.key(Fill::ADHESION, Label::new("adhesion")).key(Fill::SLIP, Label::new("slip")).svg()
}
