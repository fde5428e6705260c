//! The discrete Fourier transform of a real table.

use std::sync::Arc;

use realfft::num_complex::Complex;
use realfft::{ComplexToReal, FftError, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftPlanner};

/// Transforms of tables with `rows` rows of `columns` numbers each.
#[derive(Clone)]
pub(super) struct Spectrum {
    rows: usize,
    columns: usize,
    along: Arc<dyn RealToComplex<f64>>,
    back_along: Arc<dyn ComplexToReal<f64>>,
    across: Arc<dyn Fft<f64>>,
    back_across: Arc<dyn Fft<f64>>,
}

impl std::fmt::Debug for Spectrum {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Spectrum")
            .field("rows", &self.rows)
            .field("columns", &self.columns)
            .finish_non_exhaustive()
    }
}

impl Spectrum {
    pub(super) fn new(rows: usize, columns: usize) -> Self {
        let (mut real, mut complex) = (RealFftPlanner::new(), FftPlanner::new());
        Self {
            rows,
            columns,
            along: real.plan_fft_forward(columns),
            back_along: real.plan_fft_inverse(columns),
            across: complex.plan_fft_forward(rows),
            back_across: complex.plan_fft_inverse(rows),
        }
    }

    /// How many numbers a table has.
    pub(super) fn len(&self) -> usize {
        self.rows * self.columns
    }

    /// How many numbers its transform has, column by column.
    pub(super) fn spectrum_len(&self) -> usize {
        self.rows * self.width()
    }

    fn width(&self) -> usize {
        self.columns / 2 + 1
    }

    /// The transform, stored column by column; `table` is used up.
    pub(super) fn forward(&self, table: &mut [f64]) -> Result<Vec<Complex<f64>>, FftError> {
        let mut columns = vec![Complex::default(); self.spectrum_len()];
        let mut row_spectrum = self.along.make_output_vec();
        for (j, row) in table.chunks_exact_mut(self.columns).enumerate() {
            self.along.process(row, &mut row_spectrum)?;
            for (i, value) in row_spectrum.iter().enumerate() {
                columns[i * self.rows + j] = *value;
            }
        }
        self.across.process(&mut columns);
        Ok(columns)
    }

    /// The table of a transform, which is used up, into `table`.
    pub(super) fn backward(
        &self,
        columns: &mut [Complex<f64>],
        table: &mut [f64],
    ) -> Result<(), FftError> {
        self.back_across.process(columns);
        let mut row_spectrum = self.back_along.make_input_vec();
        let width = self.width();
        for (j, row) in table.chunks_exact_mut(self.columns).enumerate() {
            for (i, value) in row_spectrum.iter_mut().enumerate() {
                *value = columns[i * self.rows + j];
            }
            // The transform of a real table is real here; rounding is not.
            row_spectrum[0].im = 0.0;
            if self.columns.is_multiple_of(2) {
                row_spectrum[width - 1].im = 0.0;
            }
            self.back_along.process(&mut row_spectrum, row)?;
        }
        let scale = 1.0 / self.len() as f64;
        for value in table {
            *value *= scale;
        }
        Ok(())
    }
}
