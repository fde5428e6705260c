//! Quadrature over the directions of the surface: sums over equal steps, a double exponential rule where the integrand is sharp.
//!
//! The integrand is periodic and, away from the edge of the contact, smooth: sums over equal
//! steps converge geometrically, and are halved until two agree. Close to the edge, beside it at
//! the surface, and for slender ellipses, the interval is cut where the integrand is sharp, and a
//! double exponential rule clusters its nodes there.

use std::f64::consts::{FRAC_PI_2, PI};

use super::wave::{Source, Wave};

/// Steps over half a turn, at most.
const MAX_DIRECTIONS: usize = 256;
/// Steps of the coarsest sum.
const COARSEST: usize = 16;
/// Two sums that agree to this part of the traction are right to much better: the error of the
/// finer is the square of the coarser's.
const AGREEMENT: f64 = 1e-10;

/// The directions of one source in equal steps, prepared.
#[derive(Debug, Clone)]
pub(super) struct Directions {
    waves: Vec<Wave>,
    slender: bool,
}

/// A point on the disc: coordinates and distance from the centre, over the semi-axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct DiscPoint {
    pub position: [f64; 2],
    pub radius: f64,
    /// Depth over the minor semi-axis.
    pub depth: f64,
}

impl Directions {
    pub(super) fn new(source: &Source) -> Self {
        let angle = |k: usize| PI * k as f64 / MAX_DIRECTIONS as f64;
        let slender = source.ellipse.g() < 0.1;
        // Equal steps are of no use to a slender ellipse.
        let steps = if slender { 0 } else { MAX_DIRECTIONS };
        Self { waves: (0..steps).map(|k| source.wave(angle(k))).collect(), slender }
    }

    /// The integral over half a turn of `integrand(wave, h - 1)`.
    pub(super) fn integrate<const N: usize>(
        &self,
        source: &Source,
        at: DiscPoint,
        mut integrand: impl FnMut(&Wave, f64) -> [f64; N],
    ) -> [f64; N] {
        let sharp = at.radius > 0.9 && at.depth < 0.1;
        if !(self.slender || sharp)
            && let Some(sum) = self.equal_steps(at, source.size(), &mut integrand)
        {
            return sum;
        }
        panels(source, at, &mut integrand)
    }

    /// `None` when the sums do not settle.
    fn equal_steps<const N: usize>(
        &self,
        at: DiscPoint,
        size: f64,
        integrand: &mut impl FnMut(&Wave, f64) -> [f64; N],
    ) -> Option<[f64; N]> {
        let mut total = [0.0; N];
        let mut add = |start: usize, stride: usize| -> [f64; N] {
            for wave in self.waves.iter().skip(start).step_by(stride) {
                let values = integrand(wave, wave.toward_end(at.position));
                total.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
            }
            total
        };
        let mut stride = MAX_DIRECTIONS / COARSEST;
        let mean = |sum: [f64; N], stride: usize| {
            sum.map(|s| s * PI * stride as f64 / MAX_DIRECTIONS as f64)
        };
        let mut coarse = mean(add(0, stride), stride);
        while stride > 1 {
            let fine = mean(add(stride / 2, stride), stride / 2);
            stride /= 2;
            let apart = coarse.iter().zip(&fine).fold(0.0_f64, |d, (c, f)| d.max((c - f).abs()));
            if apart <= AGREEMENT * size {
                return Some(fine);
            }
            coarse = fine;
        }
        None
    }
}

/// Panels between the directions in which the integrand is sharp: where the line through the
/// point touches the edge or comes nearest to it, and along the major axis.
fn panels<const N: usize>(
    source: &Source,
    at: DiscPoint,
    integrand: &mut impl FnMut(&Wave, f64) -> [f64; N],
) -> [f64; N] {
    let toward = at.position[1].atan2(at.position[0]);
    let touch = if at.radius > 1.0 { at.radius.recip().acos() } else { 0.0 };
    let major = if source.ellipse.a() < source.ellipse.b() { FRAC_PI_2 } else { 0.0 };
    let offset = (major - toward + FRAC_PI_2).rem_euclid(PI) - FRAC_PI_2;
    let mut cuts = [-FRAC_PI_2, -touch, offset, touch, FRAC_PI_2];
    cuts.sort_by(f64::total_cmp);
    // The pole beside a singular edge takes a finer rule.
    let steps = if source.is_singular() { 96 } else { 24 };
    let mut total = [0.0; N];
    for panel in cuts.windows(2).filter(|panel| panel[1] > panel[0]) {
        for Node { cut, beyond, weight } in double_exponential([panel[0], panel[1]], steps) {
            let wave = source.wave(toward + (cut + beyond));
            let values = integrand(&wave, toward_end(at.radius, cut, beyond));
            total.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
        }
    }
    total
}

/// `radius cos(cut + beyond) - 1`, without loss where it vanishes.
fn toward_end(radius: f64, cut: f64, beyond: f64) -> f64 {
    let at_cut = if radius > 1.0 && (radius * cut.cos() - 1.0).abs() < 1e-12 {
        0.0
    } else {
        (radius - 1.0) - 2.0 * radius * (0.5 * cut).sin().powi(2)
    };
    let turn = (0.5 * beyond).sin();
    at_cut - 2.0 * radius * turn * (cut + 0.5 * beyond).sin()
}

/// A node of the rule: how far beyond the nearer end of the interval.
struct Node {
    cut: f64,
    beyond: f64,
    weight: f64,
}

/// Nodes and weights that cluster at both ends of an interval; it converges geometrically though
/// the integrand be singular there.
fn double_exponential([start, end]: [f64; 2], steps: i32) -> impl Iterator<Item = Node> {
    // Beyond 3.6 the nodes are nearer to the end than any pole that is looked at.
    let (step, half) = (f64::from(steps).recip(), 18 * steps / 5);
    (-half..=half).map(move |i| {
        let t = step * f64::from(i);
        let growth = (PI * t.sinh()).exp();
        let (left, right) = (growth / (1.0 + growth), 1.0 / (1.0 + growth));
        let weight = step * PI * t.cosh() * left * right * (end - start);
        let (cut, beyond) =
            if i < 0 { (start, left * (end - start)) } else { (end, -right * (end - start)) };
        Node { cut, beyond, weight }
    })
}
