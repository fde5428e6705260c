//! Bounding rectangle of the places where a gap is below some height.

use super::polynomial::Polynomial;
use super::section::Section;
use super::wells::Well;
use super::{Gap, Rectangle, Shape};

impl Gap {
    /// A rectangle outside of which the gap exceeds `height`; its domain where that is bounded.
    /// `None` when no rectangle was found: the gap stays low however far one goes.
    pub(crate) fn reach(&self, height: f64) -> Option<Rectangle> {
        match &self.shape {
            Shape::Polynomial(polynomial) => {
                // Where the gap is nowhere below the height, its deepest well is what is looked at.
                let [first, others @ ..] = polynomial.wells() else { return None };
                let below = others.iter().filter(|well| well.height < height);
                let mut all = reach_of_well(polynomial, first, height)?;
                // One that lies inside is reached from there already: the bottom of a ring has no end of wells.
                for well in below {
                    if !all.holds(well.place) {
                        all = all.around(&reach_of_well(polynomial, well, height)?);
                    }
                }
                Some(all)
            }
            Shape::Section(section) => reach_of_section(section, height, &self.domain()),
            Shape::Grid(_) | Shape::Function(_) => Some(self.domain()),
            Shape::Turned(turned) => turned.gap().reach(height).map(|own| turned.around(own)),
        }
    }

    /// The least height, where it is known: of a polynomial.
    pub(crate) fn least(&self) -> Option<f64> {
        match &self.shape {
            Shape::Polynomial(polynomial) => Some(polynomial.least()),
            Shape::Turned(turned) => turned.gap().least(),
            _ => None,
        }
    }

    /// Wells below a height, where they are known.
    pub(crate) fn wells_below(&self, height: f64) -> usize {
        match &self.shape {
            Shape::Polynomial(polynomial) => {
                polynomial.wells().iter().filter(|well| well.height < height).count()
            }
            Shape::Turned(turned) => turned.gap().wells_below(height),
            _ => 0,
        }
    }

    /// A height at which bodies that need `compliance_force` `N/E*` (m^2) may be expected to
    /// touch, to a factor of some tens: where to begin a search.
    pub(crate) fn likely_height(&self, compliance_force: f64) -> f64 {
        let domain = self.domain();
        match &self.shape {
            Shape::Turned(turned) => turned.gap().likely_height(compliance_force),
            Shape::Polynomial(polynomial) => {
                polynomial.least() + likely_depth(polynomial, compliance_force)
            }
            Shape::Section(section) => {
                let heights = section.y().iter().map(|&y| section.row(y)[0]);
                above_the_least(heights, compliance_force / domain.size()[1])
            }
            Shape::Grid(_) | Shape::Function(_) => {
                let place = |[low, high]: [f64; 2], i: u32| {
                    low + (high - low) * (f64::from(i) + 0.5) / 16.0
                };
                let row = |j| (0..16).map(move |i| self.at(place(domain.x, i), place(domain.y, j)));
                let [length, width] = domain.size();
                above_the_least((0..16).flat_map(row), compliance_force / length.min(width))
            }
        }
    }
}

/// A quarter of the way up from the least height; where all are nearly one, as of a roller that ends where
/// it is cut, by this depth.
fn above_the_least(heights: impl Iterator<Item = f64> + Clone, depth: f64) -> f64 {
    /// Of the depth that a load may take: less of a rise is flat.
    const FLAT: f64 = 1e-3;
    let low = heights.clone().fold(f64::INFINITY, f64::min);
    let high = heights.fold(f64::NEG_INFINITY, f64::max);
    let rise = 0.25 * (high - low);
    low + if rise > FLAT * depth { rise } else { depth }
}

/// Depth at which the shortest length of the terms, times the depth, is the load over `E*`.
fn likely_depth(polynomial: &Polynomial, compliance_force: f64) -> f64 {
    let (mut low, mut high) = (1e-18_f64, 1e9_f64);
    let deepest = polynomial.wells().first();
    for _ in 0..40 {
        let middle = (low * high).sqrt();
        let lengths = deepest.into_iter().flat_map(|well| well.lengths(middle));
        let length = lengths.fold(f64::INFINITY, f64::min);
        *(if length * middle > compliance_force { &mut high } else { &mut low }) = middle;
    }
    (low * high).sqrt()
}

/// The smallest square about a well beyond which, as far as the lengths of its terms
/// reach, no square's sides come below the height.
fn reach_of_well(polynomial: &Polynomial, well: &Well, height: f64) -> Option<Rectangle> {
    const BEYOND: f64 = 8.0;
    const MAX_STEPS: usize = 80;
    let depth = (height - well.height).abs().max(f64::MIN_POSITIVE);
    let (mut shortest, mut longest) = (f64::INFINITY, 0.0_f64);
    for length in well.lengths(depth) {
        shortest = shortest.min(length);
        longest = longest.max(length);
    }
    if !(longest > 0.0 && longest.is_finite()) {
        return None;
    }
    let largest = longest * BEYOND;
    let sizes = std::iter::successors(Some(largest), |half| Some(0.5 * half));
    let closed: Vec<bool> = sizes
        .take_while(|&half| half > shortest / BEYOND)
        .take(MAX_STEPS)
        .map(|half| perimeter_is_above(polynomial, (well.place, half), height))
        .collect();
    // A well may lie between two squares whose sides are above: no square inside that ring will do.
    let rings = (0..closed.len().saturating_sub(1)).take_while(|&k| closed[k]);
    let another = |k: &usize| {
        let half = largest * (-(*k as f64)).exp2();
        closed[k + 1] && well.turns_down() && ring_is_below(polynomial, (well.place, half), height)
    };
    if let Some(at) = rings.into_iter().find(another) {
        let half = largest * (-(at as f64)).exp2();
        return Some(about(well.place, half));
    }
    // From the outermost inwards: the first open square ends the search. Where the outermost is
    // open (a fit that turns down far away), the innermost two closed in a row do.
    let outermost = closed.iter().position(|closed| !closed).unwrap_or(closed.len());
    let at = match outermost {
        0 => closed.windows(2).rposition(|run| run.iter().all(|&closed| closed))? + 1,
        open => open - 1,
    };
    let half = largest * (-(at as f64)).exp2();
    Some(about(well.place, half))
}

fn about(place: [f64; 2], half: f64) -> Rectangle {
    let [x, y] = place.map(|middle| [middle - half, middle + half]);
    Rectangle { x, y }
}

/// Whether the gap is below a height somewhere between a square and one of half its size.
fn ring_is_below(polynomial: &Polynomial, ([x, y], half): ([f64; 2], f64), height: f64) -> bool {
    const RING_STEPS: i32 = 32;
    let place = |i: i32| half * f64::from(i) / f64::from(RING_STEPS);
    let in_ring = |i: i32, j: i32| 2 * i.abs().max(j.abs()) >= RING_STEPS;
    (-RING_STEPS..=RING_STEPS).any(|i| {
        (-RING_STEPS..=RING_STEPS)
            .any(|j| in_ring(i, j) && polynomial.at(x + place(i), y + place(j)) < height)
    })
}

fn perimeter_is_above(
    polynomial: &Polynomial,
    ([x0, y0], half): ([f64; 2], f64),
    height: f64,
) -> bool {
    const SIDE_STEPS: i32 = 48;
    (-SIDE_STEPS..=SIDE_STEPS).all(|i| {
        let t = half * f64::from(i) / f64::from(SIDE_STEPS);
        [(half, t), (-half, t), (t, half), (t, -half)]
            .into_iter()
            .all(|(x, y)| polynomial.at(x0 + x, y0 + y) > height)
    })
}

fn reach_of_section(section: &Section, height: f64, domain: &Rectangle) -> Option<Rectangle> {
    const PARTS: u32 = 4;
    const MARGIN: f64 = 0.05;
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for pair in section.y().windows(2) {
        for part in 0..=PARTS {
            let y = pair[0] + (pair[1] - pair[0]) * f64::from(part) / f64::from(PARTS);
            let [lowest, half_curvature, locus] = section.row(y);
            let half = ((height - lowest).max(0.0) / half_curvature).sqrt();
            low = low.min(locus - half);
            high = high.max(locus + half);
        }
    }
    // Where the gap is nowhere below the height, any stretch along rolling will do.
    let margin = if high > low { MARGIN * (high - low) } else { domain.size()[1] };
    let x = [low - margin, high + margin];
    margin.is_finite().then_some(Rectangle { x, ..*domain })
}
