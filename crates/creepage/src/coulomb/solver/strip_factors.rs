//! LU factors of Newton's matrix of each strip.
//!
//! An element that slides beyond the rounded corner keeps the size of its traction. Its equation
//! along the traction gives the change in that direction at once, and only how far the traction turns is
//! left: a strip that slides all along has half the unknowns, and its factors cost an eighth.

use pulp::{Arch, Simd, WithSimd};

use crate::coulomb::friction::Sliding;
use crate::coulomb::grid::Grid;
use crate::coulomb::mesh::Mesh;
use crate::coulomb::product::Row;
use crate::numerics::buffer_pool::BufferPool;
use crate::numerics::lu::Lu;

/// The unknowns of an element are the changes of its traction in two directions: along the traction at
/// its bound and across it, to the left, else along `x` and `y`. In the matrix come those along at the
/// bound, then the others along, then all across.
#[derive(Debug, Clone, Default)]
pub(super) struct StripFactors {
    lu: Lu,
    /// `x` and `y` of each element's direction along.
    directions: [Vec<f64>; 2],
    /// Place of each element's unknown along.
    places: Vec<usize>,
    /// Room for a row by the unknowns along, in the order of elements.
    along: Vec<f64>,
}

/// Factors of all strips of a grid, in memory that is used again.
#[derive(Debug, Clone, Default)]
pub(super) struct Factors(pub Vec<StripFactors>);

/// Numbers in matrices that are kept for other grids.
const MOST_KEPT: usize = 400_000;

static SPARE: BufferPool<StripFactors> = BufferPool::new();

impl Factors {
    pub(super) fn new(mesh: &Mesh) -> Self {
        let mut factors = SPARE.take(mesh.strips.len());
        factors.resize_with(mesh.strips.len(), StripFactors::default);
        for (factors, strip) in factors.iter_mut().zip(&mesh.strips) {
            factors.resize(strip.len());
        }
        Self(factors)
    }
}

impl Drop for Factors {
    fn drop(&mut self) {
        if self.0.iter().map(|factors| factors.lu.room()).sum::<usize>() <= MOST_KEPT {
            SPARE.keep(std::mem::take(&mut self.0));
        }
    }
}

impl StripFactors {
    /// Room for a strip of so many elements.
    fn resize(&mut self, elements: usize) {
        self.lu.resize(2 * elements);
        self.places.resize(elements, 0);
        for numbers in self.directions.iter_mut().chain([&mut self.along]) {
            numbers.resize(elements, 0.0);
        }
    }

    /// Factors the equations of a strip: `slip' = 0` in adhesion, `traction - projection = 0` in
    /// slip. `sliding` is that of all elements. False when the matrix is singular.
    pub(super) fn factor(
        &mut self,
        grid: &Grid,
        strip: usize,
        sliding: &[Option<Sliding>],
    ) -> bool {
        let elements = grid.mesh.elements(strip);
        let known = self.order(&sliding[elements.clone()]);
        for (i, element) in elements.enumerate() {
            let (own, sign) = grid.influence.strip_block(strip, element);
            let [x, y] = self.direction(i);
            let places = [self.places[i], self.places.len() + i];
            for (direction, place) in [[x, y], [-y, x]].into_iter().zip(places) {
                if place < known {
                    self.lu.row(place).fill(0.0);
                    self.lu.row(place)[place] = 1.0;
                } else if let Some(Sliding { derivative, .. }) = sliding[element] {
                    let by_trial = derivative.map(|row| dot(row, direction));
                    self.fill(place, by_trial.map(|d| -grid.weights[element] * d), own, sign);
                    let by_traction = [0, 1].map(|k| direction[k] - by_trial[k]);
                    self.lu.row(place)[places[0]] += dot(by_traction, [x, y]);
                    self.lu.row(place)[places[1]] += dot(by_traction, [-y, x]);
                } else {
                    self.fill(place, direction, own, sign);
                }
            }
        }
        self.lu.factor(known)
    }

    /// Chooses directions and places; how many unknowns are given at once.
    fn order(&mut self, sliding: &[Option<Sliding>]) -> usize {
        let known = sliding.iter().flatten().filter(|sliding| sliding.at_bound).count();
        let [mut at_bound, mut other] = [0, known];
        for (i, sliding) in sliding.iter().enumerate() {
            let (place, [x, y]) = match sliding {
                Some(Sliding { traction, at_bound: true, .. }) => (&mut at_bound, *traction),
                _ => (&mut other, [1.0, 0.0]),
            };
            let size = x.hypot(y);
            [self.directions[0][i], self.directions[1][i]] = [x / size, y / size];
            self.places[i] = *place;
            *place += 1;
        }
        known
    }

    fn direction(&self, i: usize) -> [f64; 2] {
        [self.directions[0][i], self.directions[1][i]]
    }

    /// Fills a row with `by[0] * (slip in x) + by[1] * (slip in y)` by the unknowns.
    fn fill(&mut self, place: usize, by: [f64; 2], own: Row, sign: f64) {
        let Self { lu, directions, places, along } = self;
        let row = lu.row(place);
        let (ordered, across) = row.split_at_mut(places.len());
        Arch::new().dispatch(Fill { by, own, sign, directions, along, across });
        for (place, along) in places.iter().zip(along) {
            ordered[*place] = *along;
        }
    }

    /// Solves for the change of a strip's tractions, all `x` before all `y`, by the residual of each of
    /// its elements; `ordered` is room.
    pub(super) fn solve(
        &self,
        residual: impl Fn(usize) -> [f64; 2],
        ordered: &mut [f64],
        change: &mut [f64],
    ) {
        let n = self.places.len();
        let [x, y] = self.directions.each_ref().map(|of| of.iter());
        for (i, ((x, y), place)) in x.zip(y).zip(&self.places).enumerate() {
            let residual = residual(i);
            ordered[*place] = dot([*x, *y], residual);
            ordered[n + i] = dot([-y, *x], residual);
        }
        self.lu.solve(ordered);
        let (along, across) = ordered.split_at(n);
        let (change_x, change_y) = change.split_at_mut(n);
        let changes = change_x.iter_mut().zip(change_y).zip(&self.places).zip(across);
        let [x, y] = self.directions.each_ref().map(|of| of.iter());
        for ((((change_x, change_y), place), across), (x, y)) in changes.zip(x.zip(y)) {
            *change_x = along[*place] * x - across * y;
            *change_y = along[*place] * y + across * x;
        }
    }
}

/// The slip of an element, combined, by the change of a strip's tractions along and across.
struct Fill<'a> {
    by: [f64; 2],
    own: Row<'a>,
    sign: f64,
    directions: &'a [Vec<f64>; 2],
    along: &'a mut [f64],
    across: &'a mut [f64],
}

impl WithSimd for Fill<'_> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { by: [by_x, by_y], own: Row { xx, xy, yy }, sign, directions, along, across } =
            self;
        let n = along.len();
        let ([xx, xy, yy], across) = ([&xx[..n], &xy[..n], &yy[..n]], &mut across[..n]);
        let [x, y] = [&directions[0][..n], &directions[1][..n]];
        for i in 0..n {
            let by_tractions =
                [by_x * xx[i] + sign * by_y * xy[i], sign * by_x * xy[i] + by_y * yy[i]];
            along[i] = by_tractions[0] * x[i] + by_tractions[1] * y[i];
            across[i] = by_tractions[1] * x[i] - by_tractions[0] * y[i];
        }
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
