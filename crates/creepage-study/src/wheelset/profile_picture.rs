//! The picture of a profile.

use creepage_plot::{Axis, Label, Panel, Pen, Sheet};
use creepage_rail::Profile;

use crate::error::ReportError;

/// Spacing of the points drawn (m).
const POINT_SPACING: f64 = 2e-4;
/// White around the profile (mm).
const AIR: f64 = 4.0;

/// A profile to scale as SVG and as PNG: `y` to the field side, `z` down, in millimetres.
///
/// # Errors
/// [`ReportError::Picture`] where the picture does not turn into pixels.
pub fn profile_pictures(title: &str, profile: &Profile) -> Result<[Vec<u8>; 2], ReportError> {
    let svg = svg(title, profile);
    let png = creepage_plot::png(&svg)?;
    Ok([svg.into_bytes(), png])
}

fn svg(title: &str, profile: &Profile) -> String {
    let curve = profile.curve();
    let points = curve.stations(POINT_SPACING).into_iter().map(|s| curve.at(s));
    let points: Vec<[f64; 2]> = points.map(|point| [1e3 * point.y, 1e3 * point.z]).collect();
    let [y, z] = [0, 1].map(|axis| range(&points, axis));
    let label = |symbol: &str, words: &str| Label::default().symbol(symbol).plain(words);
    let panel = Panel::new(
        Axis::new(y, label("y", " to the field side (mm)")),
        Axis::new([z[1], z[0]], label("z", " down (mm)")),
    );
    Sheet::new(title).panel(panel.to_scale().curve(points, Pen::OUTLINE)).svg()
}

fn range(points: &[[f64; 2]], axis: usize) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    let [low, high] = points
        .iter()
        .fold(start, |[low, high], point| [low.min(point[axis]), high.max(point[axis])]);
    [low - AIR, high + AIR]
}
