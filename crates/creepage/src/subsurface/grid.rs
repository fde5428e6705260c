//! Stresses in whole planes below a grid of equal rectangles: a convolution for each depth.

use realfft::FftError;
use realfft::num_complex::Complex;

use super::edges::Edges;
use super::element::{Element, ElementError};
use super::interior::Body;
use super::spectrum::Spectrum;
use super::stress::Stress;
use crate::check::{self, InvalidValue};

/// Error of a grid without stresses.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GridError {
    /// A number is outside its range.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// The rectangle cannot carry a traction.
    #[error(transparent)]
    Element(#[from] ElementError),
    /// The grid has no rectangles, or more than memory should be spent on.
    #[error("a grid of {along} x {across} elements is not between 1 x 1 and 2048 x 2048")]
    Size {
        /// Rectangles along.
        along: usize,
        /// Rectangles across.
        across: usize,
    },
    /// Not one traction for each rectangle.
    #[error("{given} tractions for {needed} elements")]
    Count {
        /// Tractions given.
        given: usize,
        /// Rectangles of the grid.
        needed: usize,
    },
    /// The Fourier transform refused its tables.
    #[error("the Fourier transform failed: {0}")]
    Transform(String),
}

impl From<FftError> for GridError {
    fn from(error: FftError) -> Self {
        Self::Transform(error.to_string())
    }
}

/// A grid of equal rectangles on the surface, counted along `x` first.
#[derive(Debug, Clone)]
pub struct Grid {
    /// Rectangles along and across.
    counts: [usize; 2],
    /// Lengths of a rectangle along and across.
    steps: [f64; 2],
    poisson: f64,
    signs: [f64; 3],
    spectrum: Spectrum,
}

/// Tractions on a grid, ready to be asked at any depth.
#[derive(Debug, Clone)]
pub struct PlaneLoad<'a> {
    grid: &'a Grid,
    tractions: [Vec<Complex<f64>>; 3],
}

/// Which components are odd in `x` and in `y` under a pressure: `xx, yy, zz, xy, yz, xz`.
const ODD: [[bool; 2]; 6] =
    [[false, false], [false, false], [false, false], [true, true], [false, true], [true, false]];

impl Grid {
    /// A grid of `counts` rectangles along and across with sides `steps`, on a body with Poisson's
    /// ratio `poisson`.
    ///
    /// # Errors
    /// [`GridError`] for sizes that are not positive, a ratio outside 0 to 0.5, or no or too many
    /// rectangles.
    pub fn new(
        counts: [usize; 2],
        steps: [f64; 2],
        poisson: f64,
        body: Body,
    ) -> Result<Self, GridError> {
        let [along, across] = counts;
        if !(1..=2048).contains(&along) || !(1..=2048).contains(&across) {
            return Err(GridError::Size { along, across });
        }
        check::positive("step_along", steps[0])?;
        check::positive("step_across", steps[1])?;
        check::poisson(poisson)?;
        // Twice as large, so that nothing comes around the corner.
        let spectrum = Spectrum::new(2 * across, 2 * along);
        Ok(Self { counts, steps, poisson, signs: body.signs(), spectrum })
    }

    /// Takes a traction `[X, Y, Z]`, of the upper body on the lower, for each rectangle, counted
    /// along `x` first.
    ///
    /// # Errors
    /// [`GridError`] when their number is not that of the rectangles or one is not finite.
    pub fn load(&self, tractions: &[[f64; 3]]) -> Result<PlaneLoad<'_>, GridError> {
        let needed = self.counts[0] * self.counts[1];
        if tractions.len() != needed {
            return Err(GridError::Count { given: tractions.len(), needed });
        }
        for value in tractions.iter().flatten() {
            check::finite("traction", *value)?;
        }
        let transform = |k: usize| {
            let mut table = vec![0.0; self.spectrum.len()];
            for (row, given) in table
                .chunks_exact_mut(2 * self.counts[0])
                .zip(tractions.chunks_exact(self.counts[0]))
            {
                row.iter_mut()
                    .zip(given)
                    .for_each(|(value, given)| *value = self.signs[k] * given[k]);
            }
            self.spectrum.forward(&mut table)
        };
        Ok(PlaneLoad { grid: self, tractions: [transform(0)?, transform(1)?, transform(2)?] })
    }

    /// Stresses at the depth below the rectangle at the origin's neighbours ahead and to the right,
    /// under unit tractions on it: a quarter of the plane, the rest follows by symmetry.
    fn quarter(&self, depth: f64) -> Result<Vec<[[f64; 6]; 3]>, GridError> {
        let unit = |k: usize| -> Result<Edges, GridError> {
            let mut traction = [0.0; 3];
            traction[k] = 1.0;
            let element = Element::rectangle([0.0; 2], self.steps, traction)?;
            Ok(Edges::new(element.sides([1.0; 3])))
        };
        let edges = [unit(0)?, unit(1)?, unit(2)?];
        let [along, across] = self.counts;
        Ok((0..along * across)
            .map(|k| {
                let offset = [(k % along) as f64, (k / along) as f64];
                let point = [offset[0] * self.steps[0], offset[1] * self.steps[1], depth];
                edges.each_ref().map(|edges| edges.stress(point, self.poisson))
            })
            .collect())
    }

    /// The transform of one component under one unit traction, over all offsets either way.
    fn kernel(
        &self,
        quarter: &[[[f64; 6]; 3]],
        traction: usize,
        component: usize,
    ) -> Result<Vec<Complex<f64>>, FftError> {
        let [along, across] = self.counts;
        let odd = [0, 1].map(|axis| ODD[component][axis] != (traction == axis));
        let mut table = vec![0.0; self.spectrum.len()];
        let mirror =
            |i: usize, count: usize| if i < count { (i, false) } else { (2 * count - i, true) };
        for (index, value) in table.iter_mut().enumerate() {
            let ((i, back), (j, left)) =
                (mirror(index % (2 * along), along), mirror(index / (2 * along), across));
            if i < along && j < across {
                let turned = (back && odd[0]) != (left && odd[1]);
                let own = quarter[j * along + i][traction][component];
                *value = if turned { -own } else { own };
            }
        }
        self.spectrum.forward(&mut table)
    }
}

impl PlaneLoad<'_> {
    /// Stresses below the middles of the rectangles at `depth`, in their order.
    ///
    /// # Errors
    /// [`GridError`] unless `depth` is finite and not negative.
    pub fn stress(&self, depth: f64) -> Result<Vec<Stress>, GridError> {
        let valid = "finite and not negative: into the body";
        check::require(depth.is_finite() && depth >= 0.0, "depth", depth, valid)?;
        let grid = self.grid;
        let (quarter, [along, across]) = (grid.quarter(depth)?, grid.counts);
        let mut plane = vec![[0.0; 6]; along * across];
        let mut table = vec![0.0; grid.spectrum.len()];
        for component in 0..6 {
            let mut sum = vec![Complex::default(); grid.spectrum.spectrum_len()];
            for (traction, spectrum) in self.tractions.iter().enumerate() {
                let kernel = grid.kernel(&quarter, traction, component)?;
                for ((sum, kernel), load) in sum.iter_mut().zip(kernel).zip(spectrum) {
                    *sum += kernel * load;
                }
            }
            grid.spectrum.backward(&mut sum, &mut table)?;
            for (k, stress) in plane.iter_mut().enumerate() {
                let value = table[(k / along) * 2 * along + k % along];
                stress[component] = value / (4.0 * std::f64::consts::PI);
            }
        }
        Ok(plane.into_iter().map(Stress::from_components).collect())
    }
}
