//! Forces over the distance rolled, and the areas of adhesion and slip at some stations.

use creepage_plot::{Axis, Fill, Label, Panel, Pen, Sheet};

use super::animation::Animation;
use super::progress::Frame;
use super::run::HistoryRun;
use super::trace::{Trace, force_labels};
use super::view::{View, range};
use crate::error::ReportError;

/// Contacts in the picture of areas.
const STATIONS: usize = 6;

/// The pictures of a history as SVG, with their names: `history` and, for an ellipse, `adhesion`.
#[must_use]
pub fn history_picture(run: &HistoryRun) -> Vec<(&'static str, String)> {
    let mut pictures = vec![("history", forces(run))];
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

fn forces(run: &HistoryRun) -> String {
    let x = [0.0, run.progress().moments.last().map_or(1.0, |last| 1e3 * last.distance)];
    let label = |name: &str| Label::new(name);
    let forces = [0, 1, 2].map(|k| Trace::force(run, k));
    let creepages = [0, 1, 2].map(|k| Trace::creepage(run, k));
    let panel = |traces: &[Trace], first: usize, name: &str, is_last: bool| {
        let values = traces.iter().flat_map(|trace| trace.points.iter().map(|point| point[1]));
        let along = Axis::new(x, label("distance rolled (mm)"));
        let along = if is_last { along } else { along.shared() };
        let panel = Panel::new(along, Axis::new(range(values), label(name))).height(300.0);
        let drawn = traces.iter().enumerate().filter(|(_, trace)| trace.is_there());
        drawn.fold(panel, |panel, (k, trace)| trace.on(panel, Pen::of(first + k)))
    };
    let mut sheet = Sheet::new("Forces and creepages over the distance rolled")
        .panel(panel(&forces, 0, "force over μN", false))
        .panel(panel(&creepages, 3, "creepage", true));
    let labels =
        force_labels().into_iter().chain(["ξ", "η", "χ"].map(|name| Label::default().symbol(name)));
    for (k, (trace, label)) in forces.iter().chain(&creepages).zip(labels).enumerate() {
        if trace.is_there() {
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
