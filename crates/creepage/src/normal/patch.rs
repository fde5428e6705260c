//! Patch: one connected contact area with its pressure.

use crate::gap::Rectangle;

use super::patch_strip::{Band, Moments};

/// One connected contact area.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    bands: Vec<Band>,
}

impl Patch {
    pub(super) fn new(bands: Vec<Band>) -> Self {
        Self { bands }
    }

    /// The parts that every line along x crosses once; mostly there is one.
    #[must_use]
    pub fn bands(&self) -> &[Band] {
        &self.bands
    }

    pub(super) fn bands_mut(&mut self) -> &mut [Band] {
        &mut self.bands
    }

    /// One area of this and another at greater y; `None` unless each is one band, and they touch.
    pub(super) fn merged(&self, other: &Self) -> Option<Self> {
        let ([own], [other]) = (self.bands(), other.bands()) else { return None };
        own.touches(other).then(|| Self::new(vec![own.merged(other)]))
    }

    /// With all lengths and pressures grown by a factor, about the centre of pressure.
    pub(super) fn grown(&self, factor: f64) -> Self {
        let centre = self.centroid();
        Self::new(self.bands.iter().map(|band| band.grown(factor, centre)).collect())
    }

    /// The rectangle around it (m).
    #[must_use]
    pub fn extent(&self) -> Rectangle {
        let union = |one: [f64; 2], other: [f64; 2]| [one[0].min(other[0]), one[1].max(other[1])];
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        self.bands.iter().fold(Rectangle { x: nothing, y: nothing }, |sum, band| Rectangle {
            x: union(sum.x, band.x()),
            y: union(sum.y, band.y()),
        })
    }

    /// Area (m^2).
    #[must_use]
    pub fn area(&self) -> f64 {
        self.bands.iter().map(Band::area).sum()
    }

    /// Force, and its moments about the axes.
    #[must_use]
    pub fn moments(&self) -> Moments {
        self.bands.iter().map(Band::total).fold(Moments::default(), |mut sum, part| {
            sum += part;
            sum
        })
    }

    /// Load (N).
    #[must_use]
    pub fn load(&self) -> f64 {
        self.moments().force
    }

    /// Centre of pressure (m).
    #[must_use]
    pub fn centroid(&self) -> [f64; 2] {
        let Moments { force, by_x, by_y } = self.moments();
        [by_x / force, by_y / force]
    }

    /// Pressure at a place (Pa), zero outside.
    #[must_use]
    pub fn pressure(&self, x: f64, y: f64) -> f64 {
        self.bands.iter().map(|band| band.pressure(x, y)).fold(0.0, f64::max)
    }
}
