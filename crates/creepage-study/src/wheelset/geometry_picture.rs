//! The geometry of a wheelset on its track as a picture: radius difference and places of contact
//! over the lateral position.

use super::case::WheelsetCase;
use crate::error::ReportError;
use creepage_plot::{Axis, Label, Panel, Pen, Point, Sheet};
use creepage_rail::{Profile, RadiusDifference, Side};

const MM: f64 = 1e3;
/// Neighbouring positions between which contact moves further (mm) are not joined: it jumps.
const JUMP: f64 = 1.5;

impl WheelsetCase {
    /// Radius difference and places of contact on the rails over the lateral position, as SVG and
    /// as PNG. `rolls` as for [`WheelsetCase::radius_difference`].
    ///
    /// # Errors
    /// [`ReportError::Picture`] where the picture does not turn into pixels.
    pub fn geometry_pictures(
        &self,
        difference: &RadiusDifference,
        rolls: bool,
    ) -> Result<[Vec<u8>; 2], ReportError> {
        let svg = self.geometry_svg(difference, rolls);
        let png = creepage_plot::png(&svg)?;
        Ok([svg.into_bytes(), png])
    }

    fn geometry_svg(&self, difference: &RadiusDifference, rolls: bool) -> String {
        let rows: Vec<Point> = difference.rows().map(|(y, r)| [MM * y, MM * r]).collect();
        let places = [Side::Left, Side::Right].map(|side| self.places(difference, side, rolls));
        let across = || {
            let [from, to] = difference.range().map(|y| MM * y);
            Axis::new([from, to], Label::default().symbol("y").plain(" of the wheelset (mm)"))
        };
        let radii = Axis::new(range(&rows), Label::default().symbol("Δr").plain(" (mm)"));
        let heading = Label::new("difference of rolling radii, right less left");
        let first = Panel::new(across(), radii).heading(heading).curves(&broken(rows), Pen::of(0));
        let all: Vec<Point> = places.concat();
        let lateral = Label::default().symbol("y").plain(" of the rail (mm)");
        let second = Panel::new(across(), Axis::new(range(&all), lateral));
        let heading = Label::new("where wheels touch, to the field side");
        let [left, right] = places.map(broken);
        let second = second.heading(heading).curves(&left, Pen::of(1)).curves(&right, Pen::of(2));
        let roll = if rolls { "rolled until both wheels touch" } else { "without roll" };
        Sheet::new("Wheelset on its track, over its lateral position")
            .note(Label::new(roll))
            .panel(first)
            .panel(second)
            .key(Pen::of(1), Label::new("left"))
            .key(Pen::of(2), Label::new("right"))
            .svg()
    }

    /// Where a wheel touches its rail (mm) over the lateral position (mm).
    fn places(&self, difference: &RadiusDifference, side: Side, rolls: bool) -> Vec<Point> {
        let place = |y: f64| {
            let roll = if rolls { self.running.resting(y, 0.0, None).ok()?.roll } else { 0.0 };
            let touch = self.running.touch(side, y, roll, 0.0).ok()?;
            Some([MM * y, MM * touch.y_rail])
        };
        difference.rows().filter_map(|(y, _)| place(y)).collect()
    }
}

/// Lines that end where contact jumps.
fn broken(points: Vec<Point>) -> Vec<Vec<Point>> {
    let mut lines: Vec<Vec<Point>> = Vec::new();
    for point in points {
        match lines.last_mut() {
            Some(line) if line.last().is_some_and(|last| (point[1] - last[1]).abs() < JUMP) => {
                line.push(point);
            }
            _ => lines.push(vec![point]),
        }
    }
    lines
}

fn range(points: &[Point]) -> [f64; 2] {
    let nothing = [f64::INFINITY, f64::NEG_INFINITY];
    let [low, high] =
        points.iter().fold(nothing, |[low, high], point| [low.min(point[1]), high.max(point[1])]);
    let margin = 0.05 * (high - low).max(1e-3);
    [low - margin, high + margin]
}

/// Spacing of the points drawn (m).
const POINT_SPACING: f64 = 2e-4;
/// White around the profile (mm).
const AIR: f64 = 4.0;

/// A profile to scale as SVG and as PNG: `y` to the field side, `z` down, in millimetres.
///
/// # Errors
/// [`ReportError::Picture`] where the picture does not turn into pixels.
pub fn profile_pictures(title: &str, profile: &Profile) -> Result<[Vec<u8>; 2], ReportError> {
    let svg = profile_svg(title, profile);
    let png = creepage_plot::png(&svg)?;
    Ok([svg.into_bytes(), png])
}

fn profile_svg(title: &str, profile: &Profile) -> String {
    let curve = profile.curve();
    let points = curve.stations(POINT_SPACING).into_iter().map(|s| curve.at(s));
    let points: Vec<[f64; 2]> = points.map(|point| [1e3 * point.y, 1e3 * point.z]).collect();
    let [y, z] = [0, 1].map(|axis| profile_range(&points, axis));
    let label = |symbol: &str, words: &str| Label::default().symbol(symbol).plain(words);
    let panel = Panel::new(
        Axis::new(y, label("y", " to the field side (mm)")),
        Axis::new([z[1], z[0]], label("z", " down (mm)")),
    );
    Sheet::new(title).panel(panel.to_scale().curve(points, Pen::OUTLINE)).svg()
}

fn profile_range(points: &[[f64; 2]], axis: usize) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    let [low, high] = points
        .iter()
        .fold(start, |[low, high], point| [low.min(point[axis]), high.max(point[axis])]);
    [low - AIR, high + AIR]
}
