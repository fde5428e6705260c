//! The compensation of the singularity along the leading edge (4.35): which functions `f(y)`,
//! `g(y)` in the displacements (4.31) make it vanish.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, Matrix2};

use super::edge::{self, Node, Strength};
use super::waves::Waves;
use crate::ellipse::Ellipse;

/// What is made as small as possible on the leading edge, where polynomials of finite degree
/// leave a rest of the strength `k = (X', Y')`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Criterion {
    /// The integral of `k k` over the eccentric angle (4.36).
    Thesis,
    /// The integral of `(x/a)^2 k W k`. `k W k` is the energy that the edge would release, and
    /// with this weight the strengths of `P_n(y/b)` of one kind are orthogonal: the rest
    /// falls faster than with any other criterion that was tried.
    Energy,
}

impl Criterion {
    /// The upper triangle by which a strength is multiplied, so that its square is integrated.
    fn root(self, node: &Node) -> Matrix2<f64> {
        let factor = node.weight.sqrt();
        match self {
            Self::Thesis => Matrix2::from_diagonal_element(factor),
            Self::Energy => {
                let w = node.compliance;
                let (first, coupling) = (w.m11.sqrt(), w.m12 / w.m11.sqrt());
                Matrix2::new(first, coupling, 0.0, (w.m22 - coupling * coupling).sqrt())
                    * (factor * node.angle.sin())
            }
        }
    }
}

/// The two problems into which mirror symmetry about the `x` axis splits linear theory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Symmetry {
    /// Longitudinal creepage: `u` even, `v` odd in `y`.
    Longitudinal,
    /// Lateral creepage and spin: `u` odd, `v` even in `y`.
    Lateral,
}

impl Symmetry {
    /// Whether the part of degree `n` has `u` even and `v` odd in `x`, or the reverse.
    pub(super) fn u_even_in_x(self, n: usize) -> bool {
        n.is_multiple_of(2) == (self == Self::Longitudinal)
    }

    /// Rigid displacements (4.31) of unit creepage (and of unit spin), by degree.
    fn rigid(self, ellipse: Ellipse, moments: &[Matrix2<f64>]) -> Vec<Vec<Strength>> {
        let (a, b) = (ellipse.a(), ellipse.b());
        let strength = |right: &[[f64; 2]]| edge::strength(moments, right);
        match self {
            // u = -x
            Self::Longitudinal => vec![vec![vec![], strength(&[[a, 0.0], [-a, 0.0]])]],
            // v = -x; u = xy and v = -x^2/2, with x^2/a^2 = (1 + 2 P_2(x/a))/3
            Self::Lateral => {
                let (xy, xx) = (2.0 / 3.0 * a * b, -a * a / 6.0);
                let spin = [[-xy, -2.0 * xx], [0.0, 2.0 * xx], [xy, -2.0 * xx]];
                vec![
                    vec![vec![], strength(&[[0.0, -a], [0.0, a]])],
                    vec![strength(&[[0.0, xx]]), vec![], strength(&spin)],
                ]
            }
        }
    }
}

/// The solution of linear theory for one symmetry.
#[derive(Debug)]
pub(super) struct Compensated {
    ellipse: Ellipse,
    /// Of unit creepage, and of unit spin, the strengths of the traction over `G` by degree.
    pub(super) problems: Vec<Vec<Strength>>,
}

impl Compensated {
    /// `F_x` of longitudinal creepage, over `G`.
    pub(super) fn longitudinal_force(&self) -> f64 {
        self.area_factor() * self.problems[0][0][0][0]
    }

    /// `F_y` of a lateral problem, over `G`.
    pub(super) fn lateral_force(&self, problem: usize) -> f64 {
        self.area_factor() * self.problems[problem][0][0][1]
    }

    /// `M_z` of a lateral problem, over `G`: of degree one, `Y'` by `x/a` and `X'` by `y/b`.
    pub(super) fn moment(&self, problem: usize) -> f64 {
        let [below, above] = [0, 1].map(|l| self.problems[problem][1][l]);
        let (y_by_x, x_by_y) = (below[1] - above[1], below[0] + above[0]);
        self.area_factor() / 3.0 * (self.ellipse.a() * y_by_x - self.ellipse.b() * x_by_y)
    }

    /// `2 pi ab`, the integral of `(1 - r^2)^(-1/2)`.
    fn area_factor(&self) -> f64 {
        TAU * self.ellipse.a() * self.ellipse.b()
    }
}

/// The edge of one ellipse, ready to compensate either symmetry.
pub(super) struct Edge {
    ellipse: Ellipse,
    nodes: Vec<Node>,
    waves: Waves,
    moments: Vec<Matrix2<f64>>,
    of_y: Vec<Vec<Matrix2<f64>>>,
}

impl Edge {
    /// For `f` and `g` of `degree`, at least 2.
    pub(super) fn new(ellipse: Ellipse, poisson: f64, degree: usize) -> Self {
        let nodes = edge::nodes(ellipse, poisson, degree);
        let waves = Waves::new(&nodes, 2 * degree);
        let moments = waves.moments(&nodes, degree);
        let of_y = edge::strengths_of_y(&moments);
        Self { ellipse, nodes, waves, moments, of_y }
    }

    pub(super) fn compensate(&self, symmetry: Symmetry, criterion: Criterion) -> Compensated {
        let free = self.free(symmetry);
        let columns = self.sample(symmetry, criterion, &free);
        let gram = (columns.transpose() * &columns).cholesky();
        let mut problems = symmetry.rigid(self.ellipse, &self.moments);
        for problem in &mut problems {
            let rest = self.sample(symmetry, criterion, problem).column_sum();
            let mut shares = columns.tr_mul(&-rest);
            // The strengths are linearly independent, their Gram matrix positive definite.
            if let Some(gram) = &gram {
                gram.solve_mut(&mut shares);
            }
            problem.resize(free.len(), vec![]);
            for ((total, free), share) in problem.iter_mut().zip(&free).zip(&shares) {
                total.resize(free.len(), [0.0; 2]);
                for (total, free) in total.iter_mut().zip(free) {
                    *total = [total[0] + share * free[0], total[1] + share * free[1]];
                }
            }
        }
        Compensated { ellipse: self.ellipse, problems }
    }

    /// The strengths of `P_n(y/b)` in `u` or in `v`, whichever the symmetry admits.
    fn free(&self, symmetry: Symmetry) -> Vec<Strength> {
        let pick = |(n, kernel): (usize, &Vec<Matrix2<f64>>)| {
            let column = usize::from(!symmetry.u_even_in_x(n));
            kernel.iter().map(|k| [k[(0, column)], k[(1, column)]]).collect()
        };
        self.of_y.iter().enumerate().map(pick).collect()
    }

    /// Strengths along the leading edge, one column a degree: above the first component at all
    /// nodes, below the second, weighted so that the sum of squares is the criterion's integral.
    fn sample(
        &self,
        symmetry: Symmetry,
        criterion: Criterion,
        strengths: &[Strength],
    ) -> DMatrix<f64> {
        let count = self.nodes.len();
        let roots: Vec<_> = self.nodes.iter().map(|node| criterion.root(node)).collect();
        let mut samples = DMatrix::zeros(2 * count, strengths.len());
        for (n, (strength, mut column)) in
            strengths.iter().zip(samples.column_iter_mut()).enumerate()
        {
            let (first, second) = column.as_mut_slice().split_at_mut(count);
            self.waves.add(strength, symmetry.u_even_in_x(n), [first, second]);
            for ((x, y), root) in first.iter_mut().zip(second).zip(&roots) {
                (*x, *y) = (root.m11 * *x + root.m12 * *y, root.m22 * *y);
            }
        }
        samples
    }
}
