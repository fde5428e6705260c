//! How the normal load is spread: its integrals over pieces of the contact.
//!
//! The pressure separates in `y/b` and `x` over the half-length at that `y`; so does every
//! integral over a piece between two values of each.

use std::f64::consts::PI;

/// The load on a piece of one coordinate, the other taken from end to end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Load {
    /// Share of the whole.
    pub share: f64,
    /// Its centroid: `y/b`, or `x` over the half-length.
    pub centroid: f64,
    /// Mean of the half-length over `a`, weighted with the load.
    pub length: f64,
    /// Factor of the mean bound over its largest value.
    pub bound: f64,
}

/// The load between two values of `y/b`.
pub(super) fn across(low: f64, high: f64) -> Load {
    let load = difference(paraboloid, high, low);
    Load {
        share: 0.75 * load,
        centroid: difference(paraboloid_moment, high, low) / load,
        length: difference(disc_cubed, high, low) / load,
        bound: load / difference(disc, high, low),
    }
}

/// The load between two values of `x` over the half-length.
pub(super) fn along(rear: f64, front: f64) -> Load {
    let load = difference(disc, front, rear);
    Load {
        share: 2.0 / PI * load,
        centroid: difference(disc_moment, front, rear) / load,
        length: 1.0,
        bound: load / (front - rear),
    }
}

/// Mean of the half-length over `a` between two values of `y/b`.
pub(super) fn mean_length(low: f64, high: f64) -> f64 {
    difference(disc, high, low) / (high - low)
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
pub(super) fn root(t: f64) -> f64 {
    (1.0 - t * t).max(0.0).sqrt()
}
