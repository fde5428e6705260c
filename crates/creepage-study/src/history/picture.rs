//! Forces over the distance rolled, and the areas of adhesion and slip at some stations.

use creepage_plot::{Axis, Fill, Label, Panel, Pen, Point, Sheet};

use super::progress::{Moment, Station};
use super::run::HistoryRun;
use crate::error::ReportError;

/// White above and below curves, in parts of their range.
const AIR: f64 = 0.06;

/// The pictures of a history as SVG, with their names: `history` and, for an ellipse, `adhesion`.
#[must_use]
pub fn history_picture(run: &HistoryRun) -> Vec<(&'static str, String)> {
    let mut pictures = vec![("history", forces(&run.progress().moments))];
    let stations = &run.progress().stations;
    if !run.case().is_line() && !stations.is_empty() {
        pictures.push(("adhesion", areas(stations)));
    }
    pictures
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

fn is_there(points: &[Point]) -> bool {
    points.iter().any(|point| point[1].abs() > 1e-6)
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = values.fold([0.0_f64; 2], |[low, high], y| [low.min(y), high.max(y)]);
    let air = (AIR * (high - low)).max(1e-3);
    [low - air, high + air]
}

fn areas(stations: &[Station]) -> String {
    let corners = || stations.iter().flat_map(|s| s.elements.iter().flat_map(|(c, _)| c.iter()));
    let most = |axis: usize| 1.08 * corners().map(|c| c[axis].abs()).fold(0.1, f64::max);
    let sheet = Sheet::new("Adhesion and slip while the contact rolls to the right").columns(3);
    let sheet = stations.iter().fold(sheet, |sheet, station| {
        let axis = |most: f64, name: &str| {
            Axis::new([-most, most], Label::default().symbol(name).plain("/").symbol("c"))
        };
        let of = |slides: bool| {
            let own = station.elements.iter().filter(move |(_, one)| *one == slides);
            own.map(|(corners, _)| corners.to_vec()).collect::<Vec<_>>()
        };
        let heading = format!("{:.4} m", station.distance);
        let panel = Panel::new(axis(most(0), "x"), axis(most(1), "y"))
            .to_scale()
            .heading(Label::new(&heading))
            .area(of(true), Fill::SLIP)
            .area(of(false), Fill::ADHESION);
        sheet.panel(panel)
    });
    sheet.key(Fill::ADHESION, Label::new("adhesion")).key(Fill::SLIP, Label::new("slip")).svg()
}
