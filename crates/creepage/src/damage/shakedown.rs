//! Shakedown limit of the contact at hand: Melan's lower bound.
//!
//! The body shakes down if some residual stress in equilibrium, constant in time, keeps every elastic
//! state of the passage within the yield limit. Where the contact rolls along `x`, residual stresses
//! `xx` that do not depend on `x`, and `yy` and `xy` that depend on the depth alone, are in
//! equilibrium and leave the surface free. With the best of them at each depth the largest of von Mises's
//! stress over the passage is the radius of a smallest ball; the limit by that radius is safe, and
//! other residual stresses could only raise it.
//!
//! No residual stress of this kind changes `xz` and `yz`: the limit is at most the shear yield stress over
//! the largest of these.

use rayon::prelude::*;

use super::ball::{self, Deviator};
use super::passage::{DangVan, Passage};
use crate::check::{self, InvalidValue};
use crate::subsurface::Interior;

/// Block of the body in which the limit is sought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShakedownBlock {
    /// Half the length and half the width of the contact.
    pub half: [f64; 2],
    /// The least depth (same unit): the surface, unless stresses settle below it.
    pub top: f64,
    /// How deep (same unit).
    pub depth: f64,
    /// Lines across, on each side of the middle one.
    pub lines: usize,
    /// Depths, the surface among them.
    pub depths: usize,
    /// States of each passage.
    pub states: usize,
}

impl ShakedownBlock {
    /// A contact with these half-lengths, to a depth of its shorter one: 3 lines a side, 16 depths, 61
    /// states; a result to about one per cent.
    #[must_use]
    pub fn of(half: [f64; 2]) -> Self {
        Self { half, top: 0.0, depth: half[0].min(half[1]), lines: 3, depths: 16, states: 61 }
    }
}

/// Shakedown limit, by the place that governs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shakedown {
    /// Von Mises's stress over the passage with the best residual stress (Pa).
    pub amplitude: f64,
    /// `[y, z]` of the governing place.
    pub place: [f64; 2],
    /// Residual stress `[xx, yy, xy]` there (Pa), for the load as it is.
    pub residual: [f64; 3],
}

impl Shakedown {
    /// The factor by which the tractions may grow and the body still shake down, for a shear yield
    /// stress `k` (Pa): `sqrt(3) k` over the amplitude. Below one the material ratchets or yields in
    /// turns, by this bound.
    #[must_use]
    pub fn load_factor(&self, shear_yield: f64) -> f64 {
        3.0_f64.sqrt() * shear_yield / self.amplitude
    }
}

/// The place where Dang Van's criterion is used most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FatigueStress {
    /// The largest equivalent stress of its passage (Pa).
    pub equivalent: f64,
    /// `[y, z]` of the place.
    pub place: [f64; 2],
}

/// Melan's lower bound for the body `interior` under the contact that `block` describes.
///
/// ```
/// use creepage::subsurface::{Body, Interior};
/// use creepage::damage::{ShakedownBlock, shakedown};
/// use creepage::{Ellipse, Hertz, Solid, SolidPair};
/// let steel = Solid::new(80e9, 0.3)?;
/// let contact =
///     Hertz::from_ellipse(SolidPair::new(steel, steel), Ellipse::new(5e-3, 5e-3)?, 80e3)?;
/// let rail = Interior::sliding(&contact, [0.0, 0.0], steel, Body::Lower)?;
/// let limit = shakedown(&rail, &ShakedownBlock { lines: 2, ..ShakedownBlock::of([5e-3; 2]) })?;
/// let p0_over_k = limit.load_factor(300e6) * contact.peak_pressure() / 300e6;
/// assert!((p0_over_k - 4.63).abs() < 0.02); // a circle without friction
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`InvalidValue`] unless lengths are positive, `depths` between 1 and 1000, `lines` up to 1000 and
/// `states` between 3 and 10000.
pub fn shakedown(interior: &Interior, block: &ShakedownBlock) -> Result<Shakedown, InvalidValue> {
    shakedown_and_fatigue(interior, block, &DangVan::default()).map(|(limit, _)| limit)
}

/// The same, and where in the block a fatigue criterion is used most, by the same stresses.
///
/// # Errors
/// As [`shakedown`].
pub fn shakedown_and_fatigue(
    interior: &Interior,
    block: &ShakedownBlock,
    criterion: &DangVan,
) -> Result<(Shakedown, FatigueStress), InvalidValue> {
    let [length, width] = block.half;
    check::positive("half_length", length)?;
    check::positive("half_width", width)?;
    check::positive("depth", block.depth)?;
    check::require(block.top >= 0.0, "top", block.top, "not negative: into the body")?;
    let within = |name, count: usize, low: usize| {
        let valid = "at most 1000, and one depth at least";
        check::require((low..=1000).contains(&count), name, count as f64, valid)
    };
    within("depths", block.depths, 1)?;
    within("lines", block.lines, 0)?;
    let depth = |k: usize| block.top + block.depth * k as f64 / (block.depths - 1).max(1) as f64;
    let depths = (0..block.depths).into_par_iter();
    let depths = depths.map(|k| at_depth(interior, block, criterion, depth(k)));
    let found = depths.collect::<Result<Vec<_>, _>>()?;
    let limit = Shakedown { amplitude: 0.0, place: [0.0; 2], residual: [0.0; 3] };
    let fatigue = FatigueStress { equivalent: f64::NEG_INFINITY, place: [0.0; 2] };
    // The shallower of equals, on any number of cores.
    Ok(found.into_iter().fold((limit, fatigue), |(limit, fatigue), (next, used)| {
        let is_worse = used.equivalent > fatigue.equivalent;
        (
            if next.amplitude > limit.amplitude { next } else { limit },
            if is_worse { used } else { fatigue },
        )
    }))
}

/// The governing line at one depth. Of all lines, the one that would be worst by itself chooses `yy` and
/// `xy`, which all lines then share; each has its own `xx`.
fn at_depth(
    interior: &Interior,
    block: &ShakedownBlock,
    criterion: &DangVan,
    z: f64,
) -> Result<(Shakedown, FatigueStress), InvalidValue> {
    let mut fatigue = FatigueStress { equivalent: f64::NEG_INFINITY, place: [0.0, z] };
    let mut lines = Vec::with_capacity(2 * block.lines + 1);
    for k in 0..=2 * block.lines {
        let y = block.half[1] * (k as f64 / block.lines.max(1) as f64 - 1.0);
        let y = if block.lines == 0 { 0.0 } else { y };
        let passage = Passage::below(interior, block.half[0], [y, z], block.states)?;
        let equivalent = criterion.equivalent(&passage);
        if equivalent > fatigue.equivalent {
            fatigue = FatigueStress { equivalent, place: [y, z] };
        }
        let states: Vec<Deviator> = passage.states().iter().map(ball::coordinates).collect();
        let alone = ball::smallest(&states, 3);
        lines.push((y, states, alone));
    }
    let by_radius = |one: &&(f64, Vec<Deviator>, ball::Ball),
                     two: &&(f64, Vec<Deviator>, ball::Ball)| {
        one.2.radius.total_cmp(&two.2.radius)
    };
    let shared = lines.iter().max_by(by_radius).map_or([0.0; 5], |line| line.2.centre);
    let mut worst = Shakedown { amplitude: -1.0, place: [0.0, z], residual: [0.0; 3] };
    for (y, states, _) in &lines {
        let moved: Vec<_> = states.iter().map(|state| without(*state, shared)).collect();
        let ball = ball::smallest(&moved, 1);
        if ball.radius > worst.amplitude {
            let residual = residual(ball.centre[0], shared);
            worst = Shakedown { amplitude: ball.radius, place: [*y, z], residual };
        }
    }
    Ok((worst, fatigue))
}

/// A state without the shared `yy` and `xy`; what these do to the first coordinate, `xx` does too.
fn without([first, second, xy, xz, yz]: Deviator, shared: Deviator) -> Deviator {
    [first, second - shared[1], xy - shared[2], xz, yz]
}

/// `[xx, yy, xy]` that move the states by minus these coordinates.
fn residual(first: f64, shared: Deviator) -> [f64; 3] {
    let root = 3.0_f64.sqrt();
    let yy = -2.0 / root * shared[1];
    [-first + 0.5 * yy, yy, -shared[2] / root]
}
