//! Pressure of the elements: how it spreads the traction bound and the normal load over them.

use std::f64::consts::PI;

use super::mesh::{Mesh, Strip};
use super::subdivision::SUBCELLS;
use crate::ellipse::Ellipse;

/// Pressure moments of a subcell.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Moments {
    /// Share of the normal force that it carries.
    pub share: f64,
    /// Centroid of its pressure.
    pub centroid: [f64; 2],
    /// The same along the strip, over the half-length, from 1 at the leading edge to -1.
    pub along: f64,
}

/// The pressure on every element of a mesh.
#[derive(Debug, Clone)]
pub(crate) struct Pressure {
    /// Mean over each element of the bound over its largest value, `mu Z / (mu Z)_max`.
    pub bounds: Vec<f64>,
    /// Share of the normal force that each element carries.
    pub shares: Vec<f64>,
    /// Centroid of the pressure in each element.
    pub centroids: Vec<[f64; 2]>,
    /// Of each element's subcells, `SUBCELLS` across by `SUBCELLS` along from the leading edge.
    pub subcells: Vec<[[Moments; SUBCELLS]; SUBCELLS]>,
}

impl Pressure {
    /// Hertz's pressure, in closed form.
    ///
    /// It separates in `y/b` and in `x` over the half-length at that `y`; so does every integral
    /// over a piece between two values of each.
    pub(crate) fn hertz(ellipse: Ellipse, mesh: &Mesh) -> Self {
        let n = mesh.len();
        let mut pressure = Self {
            bounds: Vec::with_capacity(n),
            shares: Vec::with_capacity(n),
            centroids: Vec::with_capacity(n),
            subcells: Vec::with_capacity(n),
        };
        let mut along = StripLoad::default();
        for strip in &mesh.strips {
            along.update(strip);
            let y = strip.across.map(|y| (y / ellipse.b()).clamp(-1.0, 1.0));
            let whole = across(y[0], y[SUBCELLS]);
            let parts: [Part; SUBCELLS] = std::array::from_fn(|k| across(y[k], y[k + 1]));
            for (element, cells) in along.elements.iter().zip(along.subcells.chunks(SUBCELLS)) {
                let Moments { share, centroid, .. } = product(ellipse, whole, *element);
                pressure.bounds.push(whole.bound * element.bound);
                pressure.shares.push(share);
                pressure.centroids.push(centroid);
                pressure.subcells.push(
                    parts.map(|part| std::array::from_fn(|k| product(ellipse, part, cells[k]))),
                );
            }
        }
        pressure
    }

    /// The unit of each element's traction, its bound, that makes displacements by [`Cuts`] slip;
    /// `slip_unit` is the unit of slip over the largest bound in units of `G`.
    ///
    /// [`Cuts`]: super::boussinesq_cerruti::Cuts
    pub(crate) fn units(&self, slip_unit: f64) -> Vec<f64> {
        let scale = 1.0 / (PI * slip_unit);
        self.bounds.iter().map(|bound| scale * bound).collect()
    }

    /// Multiplies all loads and all bounds.
    pub(crate) fn scale(&mut self, loads: f64, bounds: f64) {
        let cells = self.subcells.iter_mut().flat_map(|cells| cells.as_flattened_mut());
        let shares = cells.map(|cell| &mut cell.share).chain(&mut self.shares);
        shares.for_each(|share| *share *= loads);
        self.bounds.iter_mut().for_each(|bound| *bound *= bounds);
    }
}

/// The load on a piece of one coordinate, the other taken from end to end.
#[derive(Debug, Clone, Copy)]
struct Part {
    /// Share of the whole.
    share: f64,
    /// Its centroid: `y/b`, or `x` over the half-length.
    centroid: f64,
    /// Mean of the half-length over `a`, weighted with the load.
    length: f64,
    /// Factor of the mean bound over its largest value.
    bound: f64,
}

/// Both coordinates together.
fn product(ellipse: Ellipse, across: Part, along: Part) -> Moments {
    Moments {
        share: across.share * along.share,
        centroid: [ellipse.a() * across.length * along.centroid, ellipse.b() * across.centroid],
        along: along.centroid,
    }
}

/// The load along a strip; the next one is cut alike as a rule.
#[derive(Default)]
struct StripLoad {
    cuts: Vec<f64>,
    elements: Vec<Part>,
    subcells: Vec<Part>,
}

impl StripLoad {
    fn update(&mut self, strip: &Strip) {
        if self.cuts != strip.along.cuts {
            self.cuts.clone_from(&strip.along.cuts);
            let between = |ends: &[f64]| along(ends[1], ends[0]);
            self.subcells = strip.along.cuts.windows(2).map(between).collect();
            let element = |i: usize| along(strip.along.cut(i + 1), strip.along.cut(i));
            self.elements = (0..strip.len()).map(element).collect();
        }
    }
}

/// The load between two values of `y/b`.
fn across(low: f64, high: f64) -> Part {
    let load = difference(paraboloid, high, low);
    Part {
        share: 0.75 * load,
        centroid: difference(paraboloid_moment, high, low) / load,
        length: difference(disc_cubed, high, low) / load,
        bound: load / difference(disc, high, low),
    }
}

/// The load between two values of `x` over the half-length.
fn along(rear: f64, front: f64) -> Part {
    let load = difference(disc, front, rear);
    Part {
        share: 2.0 / PI * load,
        centroid: difference(disc_moment, front, rear) / load,
        length: 1.0,
        bound: load / (front - rear),
    }
}

fn difference(primitive: fn(f64) -> f64, high: f64, low: f64) -> f64 {
    primitive(high) - primitive(low)
}

/// Primitive of `sqrt(1 - t^2)`.
fn disc(t: f64) -> f64 {
    0.5 * (t * root(t) + t.asin())
}

/// Primitive of `sqrt(1 - t^2)^3`.
fn disc_cubed(t: f64) -> f64 {
    0.125 * (t * (5.0 - 2.0 * t * t) * root(t) + 3.0 * t.asin())
}

/// Primitive of `t sqrt(1 - t^2)`.
fn disc_moment(t: f64) -> f64 {
    -root(t).powi(3) / 3.0
}

/// Primitive of `1 - t^2`.
fn paraboloid(t: f64) -> f64 {
    t - t * t * t / 3.0
}

/// Primitive of `t (1 - t^2)`.
fn paraboloid_moment(t: f64) -> f64 {
    0.5 * t * t - 0.25 * t.powi(4)
}

/// `sqrt(1 - t^2)`, the half-length over `a` at `y/b = t`.
fn root(t: f64) -> f64 {
    (1.0 - t * t).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_elements_carry_the_whole_load() {
        let ellipse = Ellipse::from_ratio(3.0).unwrap();
        let pressure = Pressure::hertz(ellipse, &Mesh::ellipse(ellipse, 12, 8));
        // Primitives differ by rounding only.
        assert!((pressure.shares.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        let moment: f64 =
            pressure.shares.iter().zip(&pressure.centroids).map(|(w, c)| w * (c[0] + c[1])).sum();
        assert!(moment.abs() < 1e-14);
    }

    #[test]
    fn subcells_add_up_to_their_element() {
        let ellipse = Ellipse::from_ratio(0.4).unwrap();
        let pressure = Pressure::hertz(ellipse, &Mesh::ellipse(ellipse, 6, 5));
        for (element, cells) in pressure.subcells.iter().enumerate() {
            let cells = cells.as_flattened();
            let sum = |of: fn(&Moments) -> f64| cells.iter().map(|c| c.share * of(c)).sum::<f64>();
            let [share, x, y] = [sum(|_| 1.0), sum(|c| c.centroid[0]), sum(|c| c.centroid[1])];
            let centroid = pressure.centroids[element];
            assert!((share - pressure.shares[element]).abs() < 1e-15);
            // Rounding of shares of a hundredth.
            assert!((x / share - centroid[0]).abs() < 1e-12);
            assert!((y / share - centroid[1]).abs() < 1e-12);
        }
    }
}
