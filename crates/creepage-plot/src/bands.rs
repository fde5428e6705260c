//! A quantity over an ellipse or a rectangle in shades between round levels: the darker, the more.

use std::f64::consts::TAU;

use crate::contour::{Contour, ellipse};
use crate::format::{Scale, floor_log10};
use crate::label::Label;
use crate::mark::{Fill, Pen};
use crate::panel::Panel;
use crate::scene::Point;
use crate::sheet::Sheet;
use crate::top_view::TopView;

/// Most levels; there is one band more.
const MAX_LEVELS: usize = 7;
/// Shades in equal steps of grey, light enough to carry dark arrows.
const SHADES: [&str; MAX_LEVELS + 1] =
    ["#f4f8fc", "#dfeaf5", "#c9dcee", "#b2cde6", "#9bbddd", "#83abd0", "#6b98c2", "#5385b3"];
/// The lines between shades.
const CONTOUR: Pen = Pen { colour: "#3f6288", dashes: "", width: 0.8 };
/// Rings of equal area, and points on each, that give the range of the quantity.
const RINGS: u32 = 25;
const POINTS_PER_RING: u32 = 48;
/// Share of the area below the highest level of a quantity that has no largest value.
const SHOWN: f64 = 0.9;

/// The areas above each of a few round levels.
#[derive(Debug, Clone)]
pub struct Bands {
    levels: Vec<f64>,
    above: Vec<Vec<Vec<Point>>>,
    edge: Vec<Point>,
}

impl Bands {
    /// The bands of a quantity at `(x/a, y/b)`, which vanishes at the edge or, if `is_singular`,
    /// grows there without bound.
    #[must_use]
    pub fn new(quantity: impl Fn(Point) -> f64, is_singular: bool) -> Self {
        let levels = levels(rings().map(&quantity), is_singular);
        let above = |level: &f64| {
            Contour::trace(|points| points.iter().map(|p| quantity(*p) > *level).collect()).polygons
        };
        let edge = ellipse([1.0, 1.0]);
        Self { above: levels.iter().map(above).collect(), levels, edge }
    }

    /// The bands of a quantity at points of the rectangle between two corners.
    #[must_use]
    pub fn over([from, to]: [Point; 2], quantity: impl Fn(Point) -> f64) -> Self {
        let at =
            |square: Point| [0, 1].map(|i| from[i] + 0.5 * (1.0 + square[i]) * (to[i] - from[i]));
        let side = |k: u32| 2.0 * f64::from(k) / f64::from(POINTS_PER_RING) - 1.0;
        let places = (0..=POINTS_PER_RING)
            .flat_map(|j| (0..=POINTS_PER_RING).map(move |i| [side(i), side(j)]));
        let mut values: Vec<_> = places.map(|place| quantity(at(place))).collect();
        values.sort_unstable_by(f64::total_cmp);
        let levels = match (values.first(), values.last()) {
            (Some(&low), Some(&high)) => round_levels(low, high),
            _ => vec![],
        };
        let above = |level: &f64| -> Vec<Vec<Point>> {
            let is_above =
                |points: &[Point]| points.iter().map(|p| quantity(at(*p)) > *level).collect();
            let polygons = Contour::trace_square(is_above).polygons.into_iter();
            polygons.map(|polygon| polygon.into_iter().map(at).collect()).collect()
        };
        let edge = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(at).to_vec();
        Self { above: levels.iter().map(above).collect(), levels, edge }
    }

    /// From round levels between zero and the largest value, and the areas above a level; the edge is the
    /// caller's, for [`Bands::fill`].
    #[must_use]
    pub fn up_to(largest: f64, above: impl Fn(f64) -> Vec<Vec<Point>>) -> Self {
        let levels = round_levels(0.0, largest);
        Self { above: levels.iter().map(|level| above(*level)).collect(), levels, edge: vec![] }
    }

    /// Fills the ellipse of a panel in units of its semi-axes, or the rectangle of a panel.
    #[must_use]
    pub fn draw(&self, panel: Panel) -> Panel {
        let edge = vec![self.edge.clone()];
        self.fill(panel, &edge).outlines(&edge, Pen::OUTLINE.wide(2.0))
    }

    /// Fills areas of a panel, without their outlines.
    #[must_use]
    pub fn fill(&self, panel: Panel, areas: &[Vec<Point>]) -> Panel {
        let panel = panel.area(areas.to_vec(), Fill::plain(self.shade(0)));
        self.above.iter().enumerate().fold(panel, |panel, (k, polygons)| {
            let fill = Fill::plain(self.shade(k + 1));
            panel.area(polygons.clone(), fill).outlines(polygons, CONTOUR)
        })
    }

    /// Adds each shade with the levels that it lies between, in a unit, to a legend; the highest
    /// first.
    #[must_use]
    pub fn key(&self, view: TopView, unit: &str) -> TopView {
        self.entries(unit).into_iter().fold(view, |view, (fill, name)| view.key(fill, name))
    }

    /// The same for a sheet.
    #[must_use]
    pub fn key_below(&self, sheet: Sheet, unit: &str) -> Sheet {
        self.entries(unit).into_iter().fold(sheet, |sheet, (fill, name)| sheet.key(fill, name))
    }

    /// Each shade with the levels that it lies between, in a unit; the highest first.
    #[must_use]
    pub fn entries(&self, unit: &str) -> Vec<(Fill, Label)> {
        let scale = Scale::of(self.levels.last().copied().unwrap_or(0.0), unit, 3);
        let number = |words: &str, level: &f64| Label::new(words).number(&scale.write(*level));
        let name = |band: usize| match (self.levels.get(band.wrapping_sub(1)), self.levels.first())
        {
            (Some(level), _) => number("above ", level),
            (None, Some(level)) => number("below ", level),
            (None, None) => Label::new("the same everywhere"),
        };
        let bands = (0..=self.levels.len()).rev();
        bands.map(|band| (Fill::plain(self.shade(band)), name(band))).collect()
    }

    /// The shade of a band, spread over all shades.
    fn shade(&self, band: usize) -> &'static str {
        SHADES[(band * MAX_LEVELS).checked_div(self.levels.len()).unwrap_or(0).min(MAX_LEVELS)]
    }
}

/// Round levels in ascending order, at most [`MAX_LEVELS`].
fn levels(values: impl Iterator<Item = f64>, is_singular: bool) -> Vec<f64> {
    let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    values.sort_unstable_by(f64::total_cmp);
    // What has a largest value vanishes at the edge.
    let (least, share) = if is_singular { (1.0, SHOWN) } else { (0.0, 1.0) };
    match (values.first(), values.get(last(values.len(), share))) {
        (Some(&low), Some(&high)) => round_levels(least * low, high),
        _ => vec![],
    }
}

/// Position of the value below which a share of all lies.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // some thousand values
fn last(count: usize, share: f64) -> usize {
    ((count as f64 * share) as usize).min(count.saturating_sub(1))
}

fn rings() -> impl Iterator<Item = Point> {
    (0..RINGS).flat_map(|ring| {
        let radius = ((f64::from(ring) + 0.5) / f64::from(RINGS)).sqrt();
        (0..POINTS_PER_RING).map(move |k| {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(POINTS_PER_RING)).sin_cos();
            [radius * cos, radius * sin]
        })
    })
}

/// Multiples of a round step strictly between `low` and `high`.
fn round_levels(low: f64, high: f64) -> Vec<f64> {
    let width = (high - low) / MAX_LEVELS as f64;
    if !(width > 0.0 && width > 1e-9 * high) {
        return vec![];
    }
    let power = 10f64.powi(floor_log10(width));
    let steps = [1.0, 2.0, 2.5, 5.0].map(|factor| factor * power);
    let step = steps.into_iter().find(|step| *step >= width).unwrap_or(10.0 * power);
    let first = (low / step).floor() + 1.0;
    (0..MAX_LEVELS).map(|k| (first + k as f64) * step).take_while(|level| *level < high).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn levels_are_few_ascending_and_inside(low in 0.0..1e9_f64, width in 1.0..1e9_f64) {
            let levels = round_levels(low, low + width);
            // Steps are at most 2.5 sevenths of the range, so that two fit at least.
            prop_assert!((2..=MAX_LEVELS).contains(&levels.len()), "{levels:?}");
            prop_assert!(levels.windows(2).all(|pair| pair[0] < pair[1]));
            prop_assert!(levels.iter().all(|level| (low..low + width).contains(level)));
        }
    }

    #[test]
    fn nothing_to_tell_apart_has_no_levels() {
        assert!(round_levels(5.0, 5.0).is_empty());
        assert!(round_levels(0.0, 0.0).is_empty());
    }
}
