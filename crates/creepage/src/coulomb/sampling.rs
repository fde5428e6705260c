//! Force and frictional power of solved tractions.
//!
//! Near the pole of the spin the slip turns around within a few elements. Each sliding element is
//! therefore sampled at places within: there the slip is interpolated between elements, and the
//! traction has its direction. For large creepage this is the integral of the saturated theory.

use super::elements::{Elements, border, cut, fit};
use super::load::{self, Load};
use crate::{Creepage, Force};

/// Places in an element, along and across.
const PLACES: usize = 4;

/// Slip that counts as far from the border of adhesion; elastic slip is of order one. Near the
/// border the element's own direction rules, so that nothing jumps when an element starts to slide.
const FAR: f64 = 1.0;

/// The places in the elements: in each strip, and in each element along any strip.
#[derive(Debug, Clone)]
pub(super) struct Sampling {
    strips: Vec<Place>,
    elements: Vec<Place>,
}

/// A piece of a strip, or of the elements at one distance from the leading edge.
#[derive(Debug, Clone, Copy)]
struct Place {
    load: Load,
    /// The other strip or element to interpolate with, and its weight.
    other: usize,
    weight: f64,
}

/// Fields that are linear in the tractions and may be differentiated with them.
#[derive(Clone, Copy)]
pub(super) struct Fields<'a> {
    pub elements: &'a Elements,
    /// Where the slip of each element is.
    pub places: &'a [[f64; 2]],
    pub traction: &'a [Vec<f64>; 2],
    pub slip: &'a [Vec<f64>; 2],
    pub creepage: Creepage,
}

impl Fields<'_> {
    fn at(pair: &[Vec<f64>; 2], element: usize) -> [f64; 2] {
        [pair[0][element], pair[1][element]]
    }
}

/// What the tractions of a grid add up to.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sum {
    pub force: Force,
    /// Frictional power.
    pub dissipation: f64,
    /// Power of the tractions on the slip that the pressure causes.
    pub by_pressure: f64,
}

impl Sum {
    fn add(&mut self, share: f64, [x, y]: [f64; 2], [p, q]: [f64; 2]) {
        self.force.fx += share * p;
        self.force.fy += share * q;
        self.force.mz += share * (x * q - y * p);
    }
}

impl Sampling {
    pub(super) fn new(along: usize, strips: usize, a_over_b: f64) -> Self {
        let fit = fit(a_over_b);
        Self {
            strips: places(strips, |j| border(j, strips, fit), load::across),
            elements: places(along, |i| cut(i, along), |front, rear| load::along(rear, front)),
        }
    }

    /// Force and frictional power of one element.
    pub(super) fn add(&self, fields: Fields, element: usize, slides: bool, sum: &mut Sum) {
        let own = Fields::at(fields.traction, element);
        if !slides {
            let elements = fields.elements;
            return sum.add(elements.shares[element], elements.centroids[element], own);
        }
        let slip = Fields::at(fields.slip, element);
        let speed = (own[0] * slip[0] + own[1] * slip[1]).max(0.0);
        let turn = speed / (speed * speed + FAR * FAR);
        self.visit(fields.elements, element, |share, at, around| {
            let there = interpolate(fields, at, around);
            let bent = [0, 1].map(|k| own[k] + turn * (there[k] - slip[k]));
            let size = bent[0].hypot(bent[1]);
            sum.dissipation += share * speed * size;
            sum.add(share, at, direction(bent, size));
        });
    }

    /// The change of an element's force with its fields.
    pub(super) fn add_change(
        &self,
        [fields, change]: [Fields; 2],
        element: usize,
        slides: bool,
        sum: &mut Sum,
    ) {
        let [own, d_own] = [fields, change].map(|f| Fields::at(f.traction, element));
        if !slides {
            let elements = fields.elements;
            return sum.add(elements.shares[element], elements.centroids[element], d_own);
        }
        let [slip, d_slip] = [fields, change].map(|f| Fields::at(f.slip, element));
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        let speed = dot(own, slip).max(0.0);
        let d_speed = dot(own, d_slip) + dot(d_own, slip);
        let square = speed * speed + FAR * FAR;
        let (turn, d_turn) =
            (speed / square, d_speed * (FAR * FAR - speed * speed) / (square * square));
        self.visit(fields.elements, element, |share, at, around| {
            let [there, d_there] = [fields, change].map(|f| interpolate(f, at, around));
            let bent = [0, 1].map(|k| own[k] + turn * (there[k] - slip[k]));
            let d_bent = [0, 1].map(|k| {
                d_own[k] + d_turn * (there[k] - slip[k]) + turn * (d_there[k] - d_slip[k])
            });
            let size = bent[0].hypot(bent[1]);
            let unit = direction(bent, size);
            let along = dot(unit, d_bent);
            sum.add(share, at, direction([0, 1].map(|k| d_bent[k] - along * unit[k]), size));
        });
    }

    /// Calls for each place of an element: its share of the normal force, where this acts, and
    /// the four elements around with their weights.
    fn visit(
        &self,
        elements: &Elements,
        element: usize,
        mut call: impl FnMut(f64, [f64; 2], [(usize, f64); 4]),
    ) {
        let along = elements.along;
        let (strip, i) = (element / along, element % along);
        for across in &self.strips[PLACES * strip..PLACES * (strip + 1)] {
            for place in &self.elements[PLACES * i..PLACES * (i + 1)] {
                let at = elements.centroid(across.load, place.load);
                let (beside, ahead) = (across.other * along + i, strip * along + place.other);
                let [own, other] = [1.0 - across.weight, across.weight];
                let around = [
                    (element, own * (1.0 - place.weight)),
                    (ahead, own * place.weight),
                    (beside, other * (1.0 - place.weight)),
                    (across.other * along + place.other, other * place.weight),
                ];
                call(across.load.share * place.load.share, at, around);
            }
        }
    }
}

/// The places in `count` strips or elements, whose ends are at `position(0)` to `position(count)`.
fn places(
    count: usize,
    position: impl Fn(f64) -> f64,
    load: impl Fn(f64, f64) -> Load,
) -> Vec<Place> {
    let middle = |k: usize| 0.5 * (position(k as f64) + position((k + 1) as f64));
    let place = |piece: usize| {
        let own = piece / PLACES;
        let [start, end] = [piece, piece + 1].map(|p| position(p as f64 / PLACES as f64));
        let load = load(start, end);
        let off = load.centroid - middle(own);
        let later = own == 0 || off * (middle(own) - middle(own - 1)) > 0.0;
        let other = if later && own + 1 < count { own + 1 } else { own - 1 };
        Place { load, other, weight: off / (middle(other) - middle(own)) }
    };
    (0..PLACES * count).map(place).collect()
}

/// Slip at a place between elements: interpolated, and the rigid rotation that interpolation
/// leaves out.
fn interpolate(fields: Fields, at: [f64; 2], around: [(usize, f64); 4]) -> [f64; 2] {
    let ([mut u, mut v], [mut x, mut y]) = ([0.0; 2], at);
    for (element, weight) in around {
        u += weight * fields.slip[0][element];
        v += weight * fields.slip[1][element];
        x -= weight * fields.places[element][0];
        y -= weight * fields.places[element][1];
    }
    [u - fields.creepage.chi * y, v + fields.creepage.chi * x]
}

/// A vector over a size, which is its own or that of another; nothing over nothing.
fn direction(vector: [f64; 2], size: f64) -> [f64; 2] {
    if size > 0.0 { vector.map(|v| v / size) } else { [0.0; 2] }
}
