//! Storage of the influence matrix of contacts with mirror symmetry fore and aft, across, or both.
//!
//! Tractions are the sum of parts that are even or odd in each direction of symmetry. A part moves the surface
//! in one way only: `x` components in `x` as they are themselves, and in `y` evenly where they are odd. So the
//! product of a part needs the coefficients of one element of each set of mirror images, at one place of each
//! set: with both symmetries there are a quarter as many coefficients, and as many multiplications.

use std::ops::Range;

use crate::coulomb::product::BLOCK;

/// The mirror images that have the same coefficients.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Symmetry {
    /// The two parts are the front half of each strip and the rear half, from its end.
    #[default]
    None,
    /// Fore and aft: the parts are even and odd.
    Along,
    /// Strips in opposite order: the parts are even and odd.
    Across,
    /// Even both ways, odd both ways, even along and odd across, odd along and even across.
    Both,
}

impl Symmetry {
    pub(super) fn new(along: bool, across: bool) -> Self {
        match (along, across) {
            (false, false) => Self::None,
            (true, false) => Self::Along,
            (false, true) => Self::Across,
            (true, true) => Self::Both,
        }
    }

    /// An even number: the second of a pair is odd where the first is even, both ways.
    pub(super) fn parts(self) -> usize {
        if self == Self::Both { 4 } else { 2 }
    }

    /// Whether half the strips have their coefficients from the others.
    pub(super) fn is_across(self) -> bool {
        matches!(self, Self::Across | Self::Both)
    }

    /// Whether half of a strip's coefficients are those of the other half.
    pub(super) fn is_along(self) -> bool {
        matches!(self, Self::Along | Self::Both)
    }
}

/// Where the elements are among the columns of the parts.
#[derive(Debug, Clone, Default)]
pub(super) struct Layout {
    pub(super) symmetry: Symmetry,
    /// First element of every strip, and the number of all.
    pub(super) elements: Vec<usize>,
    /// First column of every strip whose coefficients are kept, and the number of all.
    pub(super) columns: Vec<usize>,
    /// Columns of a part, in whole blocks.
    pub(super) width: usize,
    /// What makes of the sums over mirror images a part of each column, so that parts add up to the whole.
    pub(super) factors: Vec<f64>,
}

impl Layout {
    pub(super) fn new(symmetry: Symmetry, elements: &[usize]) -> Self {
        let strips = elements.len() - 1;
        let kept = if symmetry.is_across() { strips.div_ceil(2) } else { strips };
        let is_halved = symmetry != Symmetry::Across;
        let images = if symmetry == Symmetry::None { 1.0 } else { symmetry.parts() as f64 };
        let (mut columns, mut factors) = (vec![0], Vec::new());
        for strip in 0..kept {
            let count = elements[strip + 1] - elements[strip];
            let own = if is_halved { count.div_ceil(2) } else { count };
            // An element that is its own mirror image is counted twice.
            let once = if symmetry.is_across() && 2 * strip + 1 == strips { 0.5 } else { 1.0 };
            factors.resize(factors.len() + own, once / images);
            if let (true, 1, Some(middle)) = (is_halved, count % 2, factors.last_mut()) {
                *middle *= 0.5;
            }
            columns.push(factors.len());
        }
        let width = factors.len().next_multiple_of(BLOCK);
        factors.resize(width, 0.0);
        Self { symmetry, elements: elements.to_vec(), columns, width, factors }
    }

    /// Number of elements.
    pub(super) fn len(&self) -> usize {
        self.elements.last().copied().unwrap_or_default()
    }

    /// Strips whose coefficients are kept.
    pub(super) fn kept(&self) -> usize {
        self.columns.len() - 1
    }

    /// The strip whose coefficients a strip has.
    pub(super) fn original(&self, strip: usize) -> usize {
        if strip < self.kept() { strip } else { self.opposite(strip) }
    }

    /// The mirror image of a strip across; a strip itself where there is none.
    pub(super) fn image(&self, strip: usize) -> usize {
        if self.symmetry.is_across() { self.opposite(strip) } else { strip }
    }

    fn opposite(&self, strip: usize) -> usize {
        self.elements.len() - 2 - strip
    }

    pub(super) fn elements(&self, strip: usize) -> Range<usize> {
        self.elements[strip]..self.elements[strip + 1]
    }

    /// Numbers of all parts.
    pub(super) fn entries(&self) -> usize {
        self.symmetry.parts() * self.width
    }

    /// The blocks in which a kept strip has columns.
    pub(super) fn blocks(&self, strip: usize) -> Range<usize> {
        self.columns[strip] / BLOCK..self.columns[strip + 1].div_ceil(BLOCK)
    }

    /// Puts into the parts the sums and differences of a kept strip and its mirror images, part by part.
    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    pub(super) fn fold(&self, strip: usize, of: &[f64], parts: &mut [f64]) {
        let [own, image] = [strip, self.image(strip)].map(|strip| &of[self.elements(strip)]);
        let columns = self.columns[strip]..self.columns[strip + 1];
        let mut parts = parts.chunks_exact_mut(self.width).map(|part| &mut part[columns.clone()]);
        let [a, b, c, d] = std::array::from_fn(|_| parts.next().unwrap_or_default());
        let two = a.iter_mut().zip(b);
        let reversed = own.iter().zip(own.iter().rev());
        match self.symmetry {
            Symmetry::None => {
                for ((a, b), (front, rear)) in two.zip(reversed) {
                    (*a, *b) = (*front, *rear);
                }
            }
            Symmetry::Along => {
                for ((a, b), (own, along)) in two.zip(reversed) {
                    (*a, *b) = (own + along, own - along);
                }
            }
            Symmetry::Across => {
                for ((a, b), (own, across)) in two.zip(own.iter().zip(image)) {
                    (*a, *b) = (own + across, own - across);
                }
            }
            Symmetry::Both => {
                let images = reversed.zip(image.iter().zip(image.iter().rev()));
                for (((a, b), (c, d)), ((own, along), (across, both))) in
                    two.zip(c.iter_mut().zip(d)).zip(images)
                {
                    let [plus, cross] = [own + both, along + across];
                    let [minus, apart] = [own - both, along - across];
                    (*a, *b, *c, *d) = (plus + cross, plus - cross, minus + apart, minus - apart);
                }
            }
        }
    }
}

/// The values at an element and its mirror images along, across and both ways, from parts.
#[allow(clippy::inline_always)] // in products
#[inline(always)]
pub(super) fn unfold([a, b, c, d]: [f64; 4]) -> [f64; 4] {
    [(a + b) + (c + d), (a - b) + (c - d), (a - b) - (c - d), (a + b) - (c + d)]
}
