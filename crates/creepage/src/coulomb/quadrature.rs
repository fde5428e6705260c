//! Force, moment and frictional power of solved tractions, by subcell quadrature.
//!
//! Near the pole of the spin the slip turns around within a few elements. Each sliding element is
//! therefore cut into subcells: at the centroid of the pressure in each the slip is interpolated
//! between elements, and the traction has its direction. For large creepage this is the integral
//! of the saturated theory.

use std::sync::Arc;

use pulp::{Arch, Simd, WithSimd};

use super::mesh::{Mesh, Strip, next};
use super::pressure::{Moments, Pressure};
use super::subdivision::{Pieces, SUBCELLS};
use crate::Force;
use crate::numerics::buffer_pool::BufferPool;
use crate::numerics::simd_math::LANES;

/// Slip that counts as far from the border of adhesion; elastic slip is of order one. Near the
/// border the element's own direction rules, so that nothing jumps when an element starts to slide.
const FAR: f64 = 1.0;
/// By how much its square grows, at most, where spin turns the slip about within an element.
const TURNED: f64 = 2.0;

/// Subcells of an element.
const OWN: usize = SUBCELLS * SUBCELLS;

/// The quadrature points of an element: where the pressure of its subcells acts.
#[derive(Debug, Clone, Copy)]
struct Subcells {
    share: [f64; OWN],
    at: [[f64; OWN]; 2],
    /// The four elements to interpolate between, and their weights.
    around: [[usize; 4]; OWN],
    weights: [[f64; 4]; OWN],
    /// Its position from the mean of the places where those have their slip.
    off: [[f64; OWN]; 2],
}

/// Pressure moments of all elements and of their subcells.
#[derive(Debug, Clone)]
pub(crate) struct Quadrature {
    subcells: Vec<Subcells>,
    shares: Vec<f64>,
    centroids: Vec<[f64; 2]>,
    /// Mean area of an element.
    area: f64,
    /// What slip is to be compared with: 1, or more on a layer.
    elastic_slip: f64,
}

static SPARE: BufferPool<Subcells> = BufferPool::new();

impl Drop for Quadrature {
    fn drop(&mut self) {
        SPARE.keep(std::mem::take(&mut self.subcells));
    }
}

/// Fields that are linear in the tractions and may be differentiated with them.
#[derive(Clone, Copy)]
pub(crate) struct Fields<'a> {
    pub traction: &'a [Vec<f64>; 2],
    pub slip: &'a [Vec<f64>; 2],
    /// Size of the traction of each element that slides.
    pub limits: &'a [f64],
    pub spin: f64,
}

impl Fields<'_> {
    fn at(pair: &[Vec<f64>; 2], element: usize) -> [f64; 2] {
        [pair[0][element], pair[1][element]]
    }

    /// Slip of the subcells: interpolated, and the rigid rotation that interpolation leaves out.
    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn slip_in(&self, subcells: &Subcells) -> [[f64; OWN]; 2] {
        let mut slip = [[0.0; OWN]; 2];
        for (k, (elements, weights)) in subcells.around.iter().zip(&subcells.weights).enumerate() {
            let [mut u, mut v] = [0.0; 2];
            for (element, weight) in elements.iter().zip(weights) {
                u += weight * self.slip[0][*element];
                v += weight * self.slip[1][*element];
            }
            let [x, y] = [subcells.off[0][k], subcells.off[1][k]];
            (slip[0][k], slip[1][k]) = (u - self.spin * y, v + self.spin * x);
        }
        slip
    }
}

/// Force, moment and power of a grid's tractions.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sum {
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

impl Quadrature {
    /// `places` are those where each element has its slip.
    pub(crate) fn new(mesh: &Mesh, pressure: &Pressure, places: &[[f64; 2]]) -> Self {
        let mut subcells = SPARE.take(mesh.len());
        subcells.clear();
        let all = mesh.all().zip(&pressure.subcells);
        subcells.extend(all.map(|(at, moments)| Subcells::new(mesh, places, at, moments)));
        let area: f64 = mesh.all().map(|(strip, i)| mesh.strips[strip].area(i)).sum();
        Self {
            area: area / mesh.len() as f64,
            elastic_slip: 1.0,
            subcells,
            shares: pressure.shares.clone(),
            centroids: pressure.centroids.clone(),
        }
    }

    /// On a layer elastic slip is so many times larger.
    pub(crate) fn set_elastic_slip(&mut self, times: f64) {
        self.elastic_slip = times;
    }

    /// The square of the slip that counts as far, and its derivative by the spin. It grows with the
    /// square of the difference that spin makes from one element to the next: near the pole the
    /// elastic slip changes as fast, and what is interpolated between elements is less sure.
    fn far(&self, spin: f64) -> (f64, f64) {
        let unit = self.elastic_slip * self.elastic_slip;
        let difference = self.area * spin * spin / unit;
        let square = unit * (FAR * FAR + TURNED * difference / (1.0 + difference));
        (square, 2.0 * TURNED * self.area * spin / (1.0 + difference).powi(2))
    }

    /// Adds force and frictional power of one element.
    pub(crate) fn add(&self, fields: Fields, element: usize, slides: bool, sum: &mut Sum) {
        let own = Fields::at(fields.traction, element);
        if !slides {
            return sum.add(self.shares[element], self.centroids[element], own);
        }
        let own = own.map(|t| t / fields.limits[element]);
        let slip = Fields::at(fields.slip, element);
        let speed = dot(own, slip);
        let turn = speed / (speed * speed + self.far(fields.spin).0);
        let (subcells, limit) = (&self.subcells[element], fields.limits[element]);
        Arch::new().dispatch(AddSliding { fields, subcells, own, slip, turn, limit, sum });
    }

    /// Adds the change of an element's force with its fields.
    pub(crate) fn add_change(
        &self,
        [fields, change]: [Fields; 2],
        element: usize,
        slides: bool,
        sum: &mut Sum,
    ) {
        let [own, d_own] = [fields, change].map(|f| Fields::at(f.traction, element));
        if !slides {
            return sum.add(self.shares[element], self.centroids[element], d_own);
        }
        let [slip, d_slip] = [fields, change].map(|f| Fields::at(f.slip, element));
        let (traction, speed) = (norm(own), dot(own, slip));
        let d_traction = dot(direction(own, traction), d_own);
        let d_speed = dot(own, d_slip) + dot(d_own, slip);
        let (far, d_far) = self.far(fields.spin);
        let square = speed * speed + far;
        let d_square = 2.0 * speed * d_speed + d_far * change.spin;
        let (turn, d_turn) =
            (speed / square, (d_speed * square - speed * d_square) / (square * square));
        let subcells = &self.subcells[element];
        let [there, d_there] = [fields, change].map(|f| f.slip_in(subcells));
        for k in 0..OWN {
            let at = |of: &[[f64; OWN]; 2]| [of[0][k], of[1][k]];
            let (there, d_there) = (at(&there), at(&d_there));
            let bent = [0, 1].map(|k| own[k] + turn * (there[k] - slip[k]));
            let d_bent = [0, 1].map(|k| {
                d_own[k] + d_turn * (there[k] - slip[k]) + turn * (d_there[k] - d_slip[k])
            });
            let size = norm(bent);
            let unit = direction(bent, size);
            let along = dot(unit, d_bent);
            let d_unit = direction([0, 1].map(|k| d_bent[k] - along * unit[k]), size);
            let d_there = [0, 1].map(|k| traction * d_unit[k] + d_traction * unit[k]);
            sum.add(subcells.share[k], at(&subcells.at), d_there);
        }
    }
}

/// Adds force and frictional power of an element that slides: traction over its limit and slip, and how much
/// of the difference in slip turns the traction of a subcell.
struct AddSliding<'a> {
    fields: Fields<'a>,
    subcells: &'a Subcells,
    own: [f64; 2],
    slip: [f64; 2],
    turn: f64,
    limit: f64,
    sum: &'a mut Sum,
}

impl WithSimd for AddSliding<'_> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { fields, subcells, own, slip, turn, limit, sum } = self;
        let (traction, speed) = (norm(own), dot(own, slip).max(0.0));
        let [u, v] = fields.slip_in(subcells);
        let Subcells { share, at: [at_x, at_y], .. } = subcells;
        let [mut fx, mut fy, mut mz, mut power] = [[0.0; LANES]; 4];
        for first in (0..OWN).step_by(LANES) {
            for l in 0..LANES {
                let k = first + l;
                let x = own[0] + turn * (u[k] - slip[0]);
                let y = own[1] + turn * (v[k] - slip[1]);
                let size = (x * x + y * y).sqrt();
                let by = share[k] * traction / size;
                let by = if size > 0.0 { by } else { 0.0 };
                fx[l] += by * x;
                fy[l] += by * y;
                mz[l] += by * (at_x[k] * y - at_y[k] * x);
                power[l] += share[k] * size;
            }
        }
        let total = |lanes: [f64; LANES]| limit * lanes.iter().sum::<f64>();
        sum.force.fx += total(fx);
        sum.force.fy += total(fy);
        sum.force.mz += total(mz);
        sum.dissipation += speed * total(power);
    }
}

impl Subcells {
    /// Between its own element, the next along, and the same two in the strip beside.
    fn new(
        mesh: &Mesh,
        places: &[[f64; 2]],
        (strip, i): (usize, usize),
        moments: &[[Moments; SUBCELLS]; SUBCELLS],
    ) -> Self {
        let Strip { along: pieces, patch, .. } = &mesh.strips[strip];
        let y = |j: usize| mesh.strips[patch.start + j].y();
        let mut all = Self {
            share: [0.0; OWN],
            at: [[0.0; OWN]; 2],
            around: [[0; 4]; OWN],
            weights: [[0.0; 4]; OWN],
            off: [[0.0; OWN]; 2],
        };
        for (k, Moments { share, centroid, along }) in moments.as_flattened().iter().enumerate() {
            let (beside, across) = next(strip - patch.start, patch.len(), centroid[1], y);
            let beside = patch.start + beside;
            let ([a, b], weight) = pair(pieces, i, *along);
            let others = &mesh.strips[beside].along;
            let is_alike = Arc::ptr_eq(pieces, others);
            let ([c, d], other) = if is_alike { ([a, b], weight) } else { pair(others, i, *along) };
            let [first, start] = [strip, beside].map(|strip| mesh.elements(strip).start);
            let around = [first + a, first + b, start + c, start + d];
            let own = 1.0 - across;
            let weights =
                [own * (1.0 - weight), own * weight, across * (1.0 - other), across * other];
            for axis in 0..2 {
                let parts = around.iter().zip(weights).map(|(e, weight)| weight * places[*e][axis]);
                all.at[axis][k] = centroid[axis];
                all.off[axis][k] = centroid[axis] - parts.sum::<f64>();
            }
            (all.share[k], all.around[k], all.weights[k]) = (*share, around, weights);
        }
        all
    }
}

/// The element of a strip that holds a place, likely number `i`, the next one, and its weight.
fn pair(pieces: &Pieces, i: usize, place: f64) -> ([usize; 2], f64) {
    let holds = i < pieces.len() && pieces.cut(i) >= place && place >= pieces.cut(i + 1);
    let i = if holds { i } else { pieces.element_at(place) };
    let (other, weight) = next(i, pieces.len(), place, |i| pieces.middles[i]);
    ([i, other], weight)
}

fn norm(a: [f64; 2]) -> f64 {
    dot(a, a).sqrt()
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// A vector over a size, which is its own or that of another; zero over zero.
fn direction(vector: [f64; 2], size: f64) -> [f64; 2] {
    if size > 0.0 { vector.map(|v| v / size) } else { [0.0; 2] }
}
