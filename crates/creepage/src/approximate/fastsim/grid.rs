//! Grid of FASTSIM, strips of equal width, eight at a time, each cut into cells over its own length; and the traction bound along a strip.

use super::settings::Settings;
use crate::Ellipse;
use crate::check::{self, InvalidValue};
use std::f64::consts::PI;

/// Strips that are marched together.
pub(crate) const LANES: usize = 8;

/// One number for each strip of a block.
pub(crate) type Lanes = [f64; LANES];

/// A cell, of any strip: lengths in units of the strip's half-length.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cell {
    /// Centre.
    pub(crate) x: f64,
    /// Middle of the step that ends at the centre.
    pub(crate) middle: f64,
    /// Length of that step.
    pub(crate) step: f64,
    /// Traction bound at the centre, in units of the strip's largest.
    pub(crate) bound: f64,
}

/// Eight strips; those beyond the last one of the contact have no weight.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Block {
    /// Place across, `y`.
    pub(crate) y: Lanes,
    /// Half-length.
    pub(crate) half_length: Lanes,
    /// Half-length over the largest bound: turns slopes into tractions.
    pub(crate) gain: Lanes,
    /// Largest bound times the area of a cell.
    pub(crate) weight: Lanes,
}

/// All strips and cells.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub(crate) blocks: Vec<Block>,
    pub(crate) cells: Vec<Cell>,
}

impl Grid {
    pub(crate) fn new(
        ellipse: &Ellipse,
        [nx, ny]: [usize; 2],
        profile: Profile,
    ) -> Result<Self, InvalidValue> {
        for (name, number) in [("grid along", nx), ("grid across", ny)] {
            let valid = "at least 1 and no more than 10000";
            let range = 1..=Settings::MAX_CELLS;
            check::require(range.contains(&number), name, number as f64, valid)?;
        }
        let block = |first| Block::new(ellipse, first, [nx, ny], profile);
        Ok(Self {
            blocks: (0..ny).step_by(LANES).map(block).collect(),
            cells: (0..nx).map(|i| Cell::new(i, nx, profile)).collect(),
        })
    }

    /// The steps `(from, to)` of the march that ends at `x`, in units of the half-length.
    pub(crate) fn walk(&self, x: f64) -> impl Iterator<Item = (f64, f64)> {
        let starts = std::iter::once(1.0).chain(self.cells.iter().map(|cell| cell.x));
        let ends = self.cells.iter().map(|cell| cell.x).chain(std::iter::once(-1.0));
        starts
            .zip(ends)
            .take_while(move |&(from, _)| from > x)
            .map(move |(from, to)| (from, to.max(x)))
    }
}

impl Cell {
    fn new(i: usize, nx: usize, profile: Profile) -> Self {
        let width = 2.0 / nx as f64;
        let x = 1.0 - (i as f64 + 0.5) * width;
        // Traction vanishes at the leading edge, half a cell before the first centre.
        let step = if i == 0 { 0.5 * width } else { width };
        Self { x, middle: x + 0.5 * step, step, bound: profile.along(x) }
    }
}

impl Block {
    fn new(ellipse: &Ellipse, first: usize, [nx, ny]: [usize; 2], profile: Profile) -> Self {
        let (a, b) = (ellipse.a(), ellipse.b());
        let mut block = Self {
            y: [0.0; LANES],
            half_length: [a; LANES],
            gain: [a / profile.peak(1.0); LANES],
            weight: [0.0; LANES],
        };
        for (l, j) in (first..ny.min(first + LANES)).enumerate() {
            let t = (2 * j + 1) as f64 / ny as f64 - 1.0;
            let s = ((1.0 - t) * (1.0 + t)).sqrt();
            let (half_length, peak) = (a * s, profile.peak(s));
            block.y[l] = b * t;
            block.half_length[l] = half_length;
            block.gain[l] = half_length / peak;
            block.weight[l] = peak * (2.0 * half_length / nx as f64) * (2.0 * b / ny as f64);
        }
        block
    }
}

/// The traction bound: in every strip the same profile, of a height that depends on the strip.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Profile {
    /// `factor * 2 / (pi a b) * (1 - (x/a)^2 - (y/b)^2)`, in units of `mu N`.
    Parabolic { factor: f64 },
    /// `3 / (2 pi a b) * sqrt(1 - (x/a)^2 - (y/b)^2)`.
    Elliptic,
}

impl Profile {
    /// Largest value of the Hertz bound, in units of `mu N / c^2`.
    pub(crate) const HERTZ_PEAK: f64 = 1.5 / PI;

    /// Largest bound in the strip of half-length `a s`.
    pub(crate) fn peak(self, s: f64) -> f64 {
        match self {
            Self::Parabolic { factor } => factor * 2.0 / PI * s * s,
            Self::Elliptic => Self::HERTZ_PEAK * s,
        }
    }

    /// The bound at `x`, in units of the half-length, over the strip's largest.
    pub(crate) fn along(self, x: f64) -> f64 {
        let profile = ((1.0 - x) * (1.0 + x)).max(0.0);
        match self {
            Self::Parabolic { .. } => profile,
            Self::Elliptic => profile.sqrt(),
        }
    }
}
