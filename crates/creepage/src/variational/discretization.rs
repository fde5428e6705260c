//! Traction and slip at the mesh points as linear functions of the unknowns (5.10).

use std::f64::consts::{PI, TAU};

use nalgebra::DMatrix;

use super::Settings;
use super::integrand::State;
use crate::check::InvalidValue;
use crate::contact::Contact;
use crate::coulomb::hertz_slip;
use crate::ellipse::Ellipse;
use crate::halfspace::{LoadDisplacement, harmonics, vanishing};
use crate::{Creepage, Force};

/// A set of points with what the traction polynomials do there.
///
/// The unknowns are the coefficients of `X'` and then of `Y'` in the polynomials of
/// [`harmonics::even_indices`]: orthonormal, so that any degree is well conditioned.
#[derive(Debug, Clone)]
pub(super) struct Discretization {
    /// Polynomials in each of `X'` and `Y'`.
    polynomials: usize,
    /// Points in units of `c`.
    positions: Vec<[f64; 2]>,
    /// `1 - (x/a)^2 - (y/b)^2` at the points.
    bound_squared: Vec<f64>,
    /// Rows a point, `polynomials` long each: see [`Rows`].
    rows: Vec<f64>,
    /// Slip at the points by the pressure of dissimilar bodies (6.4), in units of `mu f00`.
    pressure_slip: Vec<[f64; 2]>,
    /// By what the contact remembers, in rolling that is not steady.
    remembered_slip: Vec<[f64; 2]>,
    /// `A = (1 - sigma) E / (2 sqrt g)`: slip in units of `mu f00` over that in `mu c / rho`.
    slip_scale: f64,
}

/// What each polynomial contributes at one point.
pub(super) struct Rows<'a> {
    /// Its value: to `X'` from `X'`, to `Y'` from `Y'`.
    pub(super) value: &'a [f64],
    /// To `P = du/dx` from `X'`.
    pub(super) px: &'a [f64],
    /// To `P` from `Y'`, and to `Q = dv/dx` from `X'`.
    pub(super) py: &'a [f64],
    /// To `Q` from `Y'`.
    pub(super) qy: &'a [f64],
}

impl<'a> Rows<'a> {
    /// What the `X'` unknowns from the `first` on bring to `X'`, `P`, `Q`.
    pub(super) fn of_x(&self, first: usize) -> [&'a [f64]; 3] {
        [&self.value[first..], &self.px[first..], &self.py[first..]]
    }

    /// What the `Y'` unknowns from the `first` on bring to `Y'`, `P`, `Q`.
    pub(super) fn of_y(&self, first: usize) -> [&'a [f64]; 3] {
        [&self.value[first..], &self.py[first..], &self.qy[first..]]
    }
}

/// The part of a discretization that does not depend on the points.
#[derive(Debug, Clone)]
pub(super) struct SlipResponse {
    ellipse: Ellipse,
    degree: usize,
    slip_scale: f64,
    kappa_over_mu: f64,
    /// Harmonics of `du/dx` by `X'`, `du/dx` by `Y'`, `dv/dx` by `Y'`: a row a polynomial.
    harmonics: [Vec<Vec<f64>>; 3],
    /// `f_x` by `X'` and `f_y` by `Y'`.
    force: Vec<f64>,
    /// `m_z` by `X'`, `m_z` by `Y'`.
    moment: [Vec<f64>; 2],
}

impl SlipResponse {
    pub(super) fn new(contact: &Contact, degree: usize) -> Result<Self, InvalidValue> {
        let (ellipse, poisson) = (contact.hertz_ellipse()?, contact.poisson());
        let response = LoadDisplacement::new(ellipse, poisson, degree + 1)?;
        let polynomials = harmonics::polynomial_count(degree);
        let mut rows = [const { Vec::new() }; 3];
        let (mut force, mut moment) = (Vec::new(), [const { Vec::new() }; 2]);
        for j in 0..polynomials {
            let mut unit = vec![0.0; polynomials];
            unit[j] = 1.0;
            let gradient = vanishing::x_derivative(degree, &unit);
            let [px, qx] = response.tangential([&gradient, &[]]);
            let [_, qy] = response.tangential([&[], &gradient]);
            for (row, harmonics) in rows.iter_mut().zip([px, qx, qy]) {
                row.push(harmonics.iter().map(|h| h / ellipse.a()).collect::<Vec<_>>());
            }
            let [mean, x, y] = moments(degree, &unit);
            force.push(mean);
            moment[0].push(-ellipse.b() * y);
            moment[1].push(ellipse.a() * x);
        }
        let slip_scale = (1.0 - poisson) * ellipse.integrals().e / (2.0 * ellipse.g().sqrt());
        let kappa_over_mu = contact.kappa_over_mu();
        Ok(Self { ellipse, degree, slip_scale, kappa_over_mu, harmonics: rows, force, moment })
    }

    pub(super) fn ellipse(&self) -> Ellipse {
        self.ellipse
    }

    pub(super) fn degree(&self) -> usize {
        self.degree
    }

    /// Resultants of the traction polynomials.
    pub(super) fn force(&self, tau: &[f64]) -> Force {
        let (x, y) = tau.split_at(self.force.len());
        Force {
            fx: dot(&self.force, x),
            fy: dot(&self.force, y),
            mz: dot(&self.moment[0], x) + dot(&self.moment[1], y),
        }
    }

    /// Harmonics of `P` and `Q`, without the rigid slip.
    pub(super) fn slip(&self, tau: &[f64]) -> [Vec<f64>; 2] {
        let mut slip = [(); 2].map(|()| vec![0.0; harmonics::polynomial_count(self.degree + 1)]);
        let [px, py, qy] = &self.harmonics;
        let half = self.force.len();
        for (rows, tau) in [([px, py], &tau[..half]), ([py, qy], &tau[half..])] {
            for (slip, rows) in slip.iter_mut().zip(rows) {
                for (row, unknown) in rows.iter().zip(tau) {
                    slip.iter_mut().zip(row).for_each(|(sum, value)| *sum += unknown * value);
                }
            }
        }
        slip
    }

    /// The midpoints of the mesh that lie inside the ellipse, line by line from `-y`.
    pub(super) fn mesh(&self, settings: &Settings) -> Vec<[f64; 2]> {
        let [nx, ny] = settings.mesh;
        let middle = |i: usize, n: usize| (2 * i + 1) as f64 / n as f64 - 1.0;
        let points = (0..ny).flat_map(|j| (0..nx).map(move |i| [middle(i, nx), middle(j, ny)]));
        points
            .filter(|[x, y]| x * x + y * y < 1.0)
            .map(|[x, y]| [x * self.ellipse.a(), y * self.ellipse.b()])
            .collect()
    }

    /// The known function of (6.6), in units of `mu f00`.
    fn by_pressure(&self, at: [f64; 2]) -> [f64; 2] {
        if self.kappa_over_mu == 0.0 {
            return [0.0; 2];
        }
        hertz_slip(self.ellipse, at).map(|slip| self.kappa_over_mu * slip)
    }

    /// The discretization on `positions` in units of `c`, all inside the ellipse.
    pub(super) fn at(&self, positions: Vec<[f64; 2]>) -> Discretization {
        let polynomials = harmonics::polynomial_count(self.degree);
        let mut rows = Vec::with_capacity(4 * polynomials * positions.len());
        let mut bound_squared = Vec::with_capacity(positions.len());
        let mut table = vec![0.0; harmonics::count(self.degree + 1)];
        for position in &positions {
            let (x, y) = (position[0] / self.ellipse.a(), position[1] / self.ellipse.b());
            bound_squared.push((1.0 - x * x - y * y).max(0.0));
            harmonics::evaluate(self.degree + 1, x, y, &mut table);
            let values: Vec<f64> =
                harmonics::even_indices(self.degree + 1).map(|index| table[index]).collect();
            rows.extend_from_slice(&values[..polynomials]);
            for by_polynomial in &self.harmonics {
                rows.extend(by_polynomial.iter().map(|harmonics| {
                    harmonics.iter().zip(&values).map(|(h, value)| h * value).sum::<f64>()
                }));
            }
        }
        let pressure_slip = positions.iter().map(|at| self.by_pressure(*at)).collect();
        let remembered_slip = vec![[0.0; 2]; positions.len()];
        let slip_scale = self.slip_scale;
        Discretization {
            polynomials,
            positions,
            bound_squared,
            rows,
            pressure_slip,
            remembered_slip,
            slip_scale,
        }
    }

    /// Displacement differences at `positions` in units of `c`, as functions of the unknowns.
    pub(super) fn displacements(
        &self,
        poisson: f64,
        positions: &[[f64; 2]],
    ) -> Result<Displacements, InvalidValue> {
        let degree = self.degree + 2;
        let response = LoadDisplacement::new(self.ellipse, poisson, degree)?;
        let polynomials = self.force.len();
        let by_unknown = (0..polynomials).map(|j| {
            let mut unit = vec![0.0; polynomials];
            unit[j] = 1.0;
            let singular = vanishing::as_singular(self.degree, &unit);
            let [u_by_x, v_by_x] = response.tangential([&singular, &[]]);
            let [_, v_by_y] = response.tangential([&[], &singular]);
            [u_by_x, v_by_x, v_by_y]
        });
        let harmonics: Vec<[Vec<f64>; 3]> = by_unknown.collect();
        // Twice the elastic energy: traction times displacement, as a mean over the ellipse.
        let energy = |[i, j]: [usize; 2]| {
            let mut unit = vec![0.0; polynomials];
            unit[i] = 1.0;
            let singular = vanishing::as_singular(self.degree, &unit);
            harmonics[j].each_ref().map(|h| dot(&singular, h) / PI)
        };
        let energy = DMatrix::from_fn(2 * polynomials, 2 * polynomials, |row, column| {
            let [i, j] = [row % polynomials, column % polynomials];
            let [by_x, mixed, by_y] = energy([i, j]);
            match [row < polynomials, column < polynomials] {
                [true, true] => by_x,
                [false, false] => by_y,
                _ => mixed,
            }
        });
        let mut rows = Vec::with_capacity(3 * polynomials * positions.len());
        for [x, y] in positions {
            let point = [x / self.ellipse.a(), y / self.ellipse.b()];
            let values: Vec<[f64; 3]> = harmonics
                .iter()
                .map(|[a, b, c]| harmonics::sum(degree, point, [a, b, c]))
                .collect();
            for component in 0..3 {
                rows.extend(values.iter().map(|value| value[component]));
            }
        }
        Ok(Displacements { polynomials, rows, energy })
    }
}

/// Displacement differences `u`, `v` at points, in units of `mu f00 c`.
#[derive(Debug, Clone)]
pub(crate) struct Displacements {
    polynomials: usize,
    /// For each point `u` by `X'`, `u` by `Y'` and `v` by `X'`, `v` by `Y'`: a number a polynomial.
    rows: Vec<f64>,
    /// Mean over the ellipse of `Z (X'_i . u_j)`.
    energy: DMatrix<f64>,
}

impl Displacements {
    /// The quadratic form of the tractions' work on the displacements, as a mean over the ellipse.
    pub(super) fn energy(&self) -> &DMatrix<f64> {
        &self.energy
    }

    fn rows(&self, point: usize) -> [&[f64]; 3] {
        let n = self.polynomials;
        let (by_x, rest) = self.rows[3 * n * point..3 * n * (point + 1)].split_at(n);
        let (mixed, by_y) = rest.split_at(n);
        [by_x, mixed, by_y]
    }

    /// `(u, v)` at every point.
    fn at(&self, tau: &[f64]) -> Vec<[f64; 2]> {
        let (x, y) = tau.split_at(self.polynomials);
        let points = self.rows.len() / (3 * self.polynomials);
        (0..points)
            .map(|point| {
                let [by_x, mixed, by_y] = self.rows(point);
                [dot(by_x, x) + dot(mixed, y), dot(mixed, x) + dot(by_y, y)]
            })
            .collect()
    }
}

/// What of the slip (4.15b) acts in a step.
#[derive(Debug, Clone)]
pub(crate) struct Change<'a> {
    /// Of `du/dx`: 1 where the contact rolls, 0 where it is shifted.
    pub(crate) rolling: f64,
    /// Of the displacements at the end of the step, over `1/c`.
    pub(crate) present: f64,
    /// Of those before: the sum of their unknowns by their factors.
    pub(crate) past: &'a [f64],
}

impl Discretization {
    /// Number of unknowns, `(M+1)(M+2)`.
    pub(super) fn unknowns(&self) -> usize {
        2 * self.polynomials
    }

    pub(super) fn positions(&self) -> &[[f64; 2]] {
        &self.positions
    }

    pub(super) fn bound_squared(&self) -> &[f64] {
        &self.bound_squared
    }

    pub(super) fn slip_scale(&self) -> f64 {
        self.slip_scale
    }

    pub(super) fn rows(&self, point: usize) -> Rows<'_> {
        let n = self.polynomials;
        let (value, rest) = self.rows[4 * n * point..4 * n * (point + 1)].split_at(n);
        let (px, rest) = rest.split_at(n);
        let (py, qy) = rest.split_at(n);
        Rows { value, px, py, qy }
    }

    /// Slip before any traction acts, in units of `mu f00`: of the bodies as if rigid, and by the
    /// pressure (6.6).
    pub(super) fn rigid_slip(&self, creepage: Creepage, point: usize) -> [f64; 2] {
        let [x, y] = creepage.rigid_slip(self.positions[point]);
        let [by_x, by_y] = self.pressure_slip[point];
        [self.slip_scale * x + by_x, self.slip_scale * y + by_y]
    }

    /// The same points with the slip of (4.15b), which has the change of displacements in it.
    pub(super) fn changing(&self, displacements: &Displacements, change: &Change) -> Self {
        let mut changed = self.clone();
        let n = self.polynomials;
        for (point, past) in displacements.at(change.past).into_iter().enumerate() {
            // The pressure goes with the contact: its slip is that of rolling.
            let by_pressure = &mut changed.pressure_slip[point];
            *by_pressure = by_pressure.map(|part| change.rolling * part);
            changed.remembered_slip[point] = past;
            let slip = &mut changed.rows[4 * n * point + n..4 * n * (point + 1)];
            let displacement = displacements.rows(point).into_iter().flatten();
            for (row, displacement) in slip.iter_mut().zip(displacement) {
                *row = change.rolling * *row - change.present * displacement;
            }
        }
        changed
    }

    /// `X', Y', P, Q` at a point.
    pub(super) fn state(&self, creepage: Creepage, tau: &[f64], point: usize) -> State {
        let rows = self.rows(point);
        let (x, y) = tau.split_at(self.polynomials);
        let ([p, q], [by_p, by_q]) =
            (self.rigid_slip(creepage, point), self.remembered_slip[point]);
        [
            dot(rows.value, x),
            dot(rows.value, y),
            p + by_p + dot(rows.px, x) + dot(rows.py, y),
            q + by_q + dot(rows.py, x) + dot(rows.qy, y),
        ]
    }
}

/// `3/(2 pi)` times the integrals over the unit circle of `(1 - r^2)^(1/2) P {1, x, y}`: the
/// share of `mu N` that the polynomial `P` brings, and its moments.
fn moments(degree: usize, polynomial: &[f64]) -> [f64; 3] {
    let singular = vanishing::as_singular(degree, polynomial);
    // The polynomials 1, y, x are these harmonics over their norm.
    let norm = |n: f64| 1.5 / PI * ((TAU / (2.0 * n + 1.0)).sqrt());
    [norm(0.0) * singular[0], norm(1.0) * singular[2], norm(1.0) * singular[1]]
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
