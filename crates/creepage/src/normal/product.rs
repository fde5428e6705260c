//! Matrix-vector product of the element method: displacements from pressures on cells of a lattice, by a dense matrix
//! for few cells, a convolution by fast Fourier transforms for many.

use std::sync::Arc;

use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftPlanner};

use super::lattice::Lattice;
use super::love::Love;

/// The product of the influence numbers with pressures, for one set of cells.
pub(super) enum Product {
    Dense(Dense),
    Convolution(Box<Convolution>),
}

impl Product {
    /// For cells of a lattice, by their index; lengths are in units of `length`.
    pub(super) fn new(lattice: &Lattice, cells: &[usize], length: f64) -> Self {
        const DENSE_BELOW: usize = 400;
        const DENSE_AT_MOST: usize = 4000;
        let step = lattice.step.map(|step| step / length);
        // A matrix entry costs about as much as a twentieth of a transform's point.
        let transformed = 4 * lattice.cells() * 20;
        let few = cells.len() < DENSE_BELOW
            || (cells.len() < DENSE_AT_MOST && cells.len().pow(2) < transformed);
        if few {
            Self::Dense(Dense::new(lattice, step, cells))
        } else {
            Self::Convolution(Box::new(Convolution::new(lattice, step, cells)))
        }
    }

    pub(super) fn apply(&mut self, pressures: &[f64], displacements: &mut [f64]) {
        match self {
            Self::Dense(dense) => dense.apply(pressures, displacements),
            Self::Convolution(convolution) => convolution.apply(pressures, displacements),
        }
    }
}

pub(super) struct Dense {
    rows: Vec<f64>,
}

impl Dense {
    fn new(lattice: &Lattice, step: [f64; 2], cells: &[usize]) -> Self {
        let love = Love::new(step, lattice.count);
        let columns = lattice.count[0];
        let places: Vec<[usize; 2]> =
            cells.iter().map(|cell| [cell % columns, cell / columns]).collect();
        let mut rows = Vec::with_capacity(cells.len().pow(2));
        for [i, j] in &places {
            rows.extend(places.iter().map(|[k, l]| love.at(i.abs_diff(*k), j.abs_diff(*l))));
        }
        Self { rows }
    }

    fn apply(&self, pressures: &[f64], displacements: &mut [f64]) {
        for (out, row) in displacements.iter_mut().zip(self.rows.chunks_exact(pressures.len())) {
            *out = dot(row, pressures);
        }
    }
}

/// A sum of products in eight lanes.
pub(super) fn dot(one: &[f64], other: &[f64]) -> f64 {
    const LANES: usize = 8;
    let (ones, others) = (one.chunks_exact(LANES), other.chunks_exact(LANES));
    let rest: f64 = ones.remainder().iter().zip(others.remainder()).map(|(a, b)| a * b).sum();
    let mut sums = [0.0; LANES];
    for (a, b) in ones.zip(others) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    sums.iter().sum::<f64>() + rest
}

/// A convolution on a lattice padded to twice its size, rows by real transforms, then columns.
pub(super) struct Convolution {
    columns: usize,
    rows: usize,
    padded: [usize; 2],
    cells: Vec<usize>,
    kernel: Vec<f64>,
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
    down: Arc<dyn Fft<f64>>,
    up: Arc<dyn Fft<f64>>,
    line: Vec<f64>,
    spectrum: Vec<Complex<f64>>,
    columns_first: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl Convolution {
    fn new(lattice: &Lattice, step: [f64; 2], cells: &[usize]) -> Self {
        let [columns, rows] = lattice.count;
        let padded = [fast_length(2 * columns), fast_length(2 * rows)];
        let (mut real, mut complex) = (RealFftPlanner::new(), FftPlanner::new());
        let (forward, backward) =
            (real.plan_fft_forward(padded[0]), real.plan_fft_inverse(padded[0]));
        let (down, up) = (complex.plan_fft_forward(padded[1]), complex.plan_fft_inverse(padded[1]));
        let longest = [
            forward.get_scratch_len(),
            backward.get_scratch_len(),
            down.get_inplace_scratch_len(),
            up.get_inplace_scratch_len(),
        ];
        let zero = Complex::new(0.0, 0.0);
        let width = padded[0] / 2 + 1;
        let mut convolution = Self {
            columns,
            rows,
            padded,
            cells: cells.to_vec(),
            kernel: Vec::new(),
            line: vec![0.0; padded[0]],
            spectrum: vec![zero; width],
            columns_first: vec![zero; width * padded[1]],
            scratch: vec![zero; longest.into_iter().max().unwrap_or(0)],
            forward,
            backward,
            down,
            up,
        };
        convolution.transform_kernel(&Love::new(step, lattice.count));
        convolution
    }

    /// The kernel is even in both directions, so its transform is real.
    fn transform_kernel(&mut self, love: &Love) {
        let [across, down] = self.padded;
        for row in 0..down {
            let j = row.min(down - row);
            self.line.fill(0.0);
            if j < self.rows {
                for i in 0..self.columns {
                    self.line[i] = love.at(i, j);
                    self.line[(across - i) % across] = love.at(i, j);
                }
            }
            self.row_forward(row);
        }
        self.down.process_with_scratch(&mut self.columns_first, &mut self.scratch);
        let scale = 1.0 / (across * down) as f64;
        self.kernel = self.columns_first.iter().map(|value| value.re * scale).collect();
    }

    /// Transforms the line and stores it as a row of the array kept by columns.
    fn row_forward(&mut self, row: usize) {
        // The lengths are the plan's own, the only thing that can fail.
        let _ = self.forward.process_with_scratch(
            &mut self.line,
            &mut self.spectrum,
            &mut self.scratch,
        );
        let targets = self.columns_first.iter_mut().skip(row).step_by(self.padded[1]);
        for (target, value) in targets.zip(&self.spectrum) {
            *target = *value;
        }
    }

    fn row_backward(&mut self, row: usize) {
        let sources = self.columns_first.iter().skip(row).step_by(self.padded[1]);
        for (value, source) in self.spectrum.iter_mut().zip(sources) {
            *value = *source;
        }
        // What rounding leaves there the transform back refuses.
        for end in [0, self.spectrum.len() - 1] {
            self.spectrum[end].im = 0.0;
        }
        let _ = self.backward.process_with_scratch(
            &mut self.spectrum,
            &mut self.line,
            &mut self.scratch,
        );
    }

    fn apply(&mut self, pressures: &[f64], displacements: &mut [f64]) {
        self.columns_first.fill(Complex::new(0.0, 0.0));
        let mut next = 0;
        for row in 0..self.rows {
            self.line.fill(0.0);
            let first = next;
            while next < self.cells.len() && self.cells[next] / self.columns == row {
                self.line[self.cells[next] % self.columns] = pressures[next];
                next += 1;
            }
            if next > first {
                self.row_forward(row);
            }
        }
        self.down.process_with_scratch(&mut self.columns_first, &mut self.scratch);
        for (value, kernel) in self.columns_first.iter_mut().zip(&self.kernel) {
            *value *= *kernel;
        }
        self.up.process_with_scratch(&mut self.columns_first, &mut self.scratch);
        let mut next = 0;
        for row in 0..self.rows {
            if next < self.cells.len() && self.cells[next] / self.columns == row {
                self.row_backward(row);
            }
            while next < self.cells.len() && self.cells[next] / self.columns == row {
                displacements[next] = self.line[self.cells[next] % self.columns];
                next += 1;
            }
        }
    }
}

/// The least even number of small prime factors that is not below `least`.
fn fast_length(least: usize) -> usize {
    let smooth = |mut n: usize| {
        for factor in [2, 3, 5] {
            while n.is_multiple_of(factor) {
                n /= factor;
            }
        }
        n == 1
    };
    let least = least.max(2);
    // A power of two lies below twice the least.
    (least..=2 * least).find(|&n| n.is_multiple_of(2) && smooth(n)).unwrap_or(2 * least)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways_agree() {
        let lattice = Lattice { corner: [0.0; 2], step: [1.0, 0.3], count: [17, 23] };
        let cells: Vec<usize> = (0..lattice.cells()).filter(|cell| cell % 7 != 3).collect();
        let pressures: Vec<f64> = cells.iter().map(|&cell| (cell as f64).sin()).collect();
        let step = lattice.step;
        let mut results = [
            Product::Dense(Dense::new(&lattice, step, &cells)),
            Product::Convolution(Box::new(Convolution::new(&lattice, step, &cells))),
        ]
        .map(|mut product| {
            let mut out = vec![0.0; cells.len()];
            product.apply(&pressures, &mut out);
            out
        });
        let [dense, convolution] = &mut results;
        for (one, other) in dense.iter().zip(convolution.iter()) {
            assert!((one - other).abs() < 1e-12, "{one} {other}");
        }
    }
}
