//! Fields of sides of elements and of point forces, several at a time: stress and displacement together.
//!
//! The same closed forms as of [`super::edges`] and [`super::far`], in plain arithmetic that compiles
//! to SIMD.

// So that all is compiled for each kind of processor.
#![allow(clippy::inline_always)]

use std::ops::Range;

use super::edges::Edges;
use crate::numerics::simd_math::{arctangent, ln, ln_of_ratio};

/// `4 pi` times the stress `[xx, yy, zz, xy, yz, xz]`, and `4 pi G` times the displacement.
pub(super) type Field = [f64; 9];
/// What is computed together: numbers of one loop that compiles to SIMD.
pub(super) const ROOM: usize = 64;
/// Sums of fields, for each number of the loop its own: all of the first component, then all of the second.
pub(super) type Sums = [f64; 9 * ROOM];
pub(super) const NOTHING: Sums = [0.0; 9 * ROOM];

/// Keeps logarithms and quotients finite where what they are multiplied with vanishes.
const TINY: f64 = f64::MIN_POSITIVE;

/// The sum of all.
pub(super) fn total(sums: &Sums) -> Field {
    std::array::from_fn(|k| sums[k * ROOM..(k + 1) * ROOM].iter().sum())
}

/// Adds a field to the sums of one number of the loop.
#[inline(always)]
pub(super) fn add_to(sums: &mut Sums, i: usize, field: &Field) {
    for k in 0..9 {
        sums[k * ROOM + i] += field[k];
    }
}

/// Sides of elements, as of [`Edges`], column by column.
#[derive(Debug, Clone, Default)]
pub(super) struct Sides {
    x: Vec<f64>,
    y: Vec<f64>,
    tx: Vec<f64>,
    ty: Vec<f64>,
    length: Vec<f64>,
    load: [Vec<f64>; 3],
}

/// Point forces on the surface, column by column.
#[derive(Debug, Clone, Default)]
pub(super) struct Forces {
    x: Vec<f64>,
    y: Vec<f64>,
    force: [Vec<f64>; 3],
}

impl Sides {
    pub(super) fn len(&self) -> usize {
        self.x.len()
    }

    /// Adds all sides of some elements at the end.
    pub(super) fn extend(&mut self, edges: &Edges) {
        for ([x, y], [tx, ty], length, load) in edges.sides() {
            self.x.push(x);
            self.y.push(y);
            self.tx.push(tx);
            self.ty.push(ty);
            self.length.push(length);
            self.load.iter_mut().zip(load).for_each(|(column, load)| column.push(load));
        }
    }

    /// Adds the fields of a range of them at a point.
    #[inline(always)]
    pub(super) fn add(
        &self,
        range: Range<usize>,
        [x, y, z]: [f64; 3],
        poisson: f64,
        sums: &mut Sums,
    ) {
        for first in range.clone().step_by(ROOM) {
            let n = (range.end - first).min(ROOM);
            let (sx, sy) = (&self.x[first..][..n], &self.y[first..][..n]);
            let (tx, ty) = (&self.tx[first..][..n], &self.ty[first..][..n]);
            let length = &self.length[first..][..n];
            let (px, py) = (&self.load[0][first..][..n], &self.load[1][first..][..n]);
            let pz = &self.load[2][first..][..n];
            for i in 0..n {
                let side = Side {
                    from: [x - sx[i], y - sy[i]],
                    along: [tx[i], ty[i]],
                    length: length[i],
                    load: [px[i], py[i], pz[i]],
                };
                add_to(sums, i, &side.field(z, poisson));
            }
        }
    }
}

/// One side, seen from a point.
struct Side {
    from: [f64; 2],
    along: [f64; 2],
    length: f64,
    load: [f64; 3],
}

impl Side {
    #[inline(always)]
    fn field(&self, z: f64, poisson: f64) -> Field {
        let ([dx, dy], [tx, ty], length) = (self.from, self.along, self.length);
        let (t0, h) = (dx * tx + dy * ty, dx * ty - dy * tx);
        let t1 = t0 - length;
        let square = h * h + z * z;
        let (r0, r1) = ((t0 * t0 + square).sqrt(), (t1 * t1 + square).sqrt());
        let (s0, s1) = ((r0 + z).max(TINY), (r1 + z).max(TINY));
        // 1/(r s), from which 1/r and 1/s.
        let (q0, q1) = (1.0 / (r0 * s0).max(TINY), 1.0 / (r1 * s1).max(TINY));
        let (i0, i1) = (r0 * q0, r1 * q1);
        let inverse =
            ln_of_ratio::<false>(r0 + r1 + length, (r0 + r1 - length).max(1e-30 * length));
        let (ln0, ln1) = (ln(s0), ln(s1));
        // As of `Edges`: angles of both ends, one subtracted from the other as complex numbers.
        let (y0, x0) = (t0 * h * (t0 * t0 + h * h), s0 * (h * h * r0 + z * t0 * t0));
        let (y1, x1) = (t1 * h * (t1 * t1 + h * h), s1 * (h * h * r1 + z * t1 * t1));
        let angle = arctangent(y0 * x1 - y1 * x0, x0 * x1 + y0 * y1);
        // Second derivatives of Omega: tt, nt, zz, nn, nz, tz.
        let tt = t1 * i1 - t0 * i0;
        let shallow = [tt, h * (i1 - i0), inverse, -tt - inverse, angle, ln0 - ln1];
        // z times those of its derivative by z.
        let reach = z / square.max(TINY) * (t0 * (s0 * q0) - t1 * (s1 * q1));
        let tt = z * (t0 * q0 - t1 * q1);
        let deep = [
            tt,
            z * h * (q0 - q1),
            -z * reach,
            z * reach - tt,
            -h * reach,
            z * (s0 * q0 - s1 * q1),
        ];
        let stress = self.stress(poisson, &shallow, &deep);
        // First derivatives along the side, its normal and the depth.
        let [_, _, zz, _, nz, _] = shallow;
        let first = [
            z * (ln0 - ln1) - (r0 - r1),
            z * nz - h * zz,
            t0 * ln0 - t1 * ln1 - length + z * zz + h * nz,
        ];
        let [u, v, w] = self.displacement(z, poisson, &shallow, first);
        let [xx, yy, zz, xy, yz, xz] = stress;
        [xx, yy, zz, xy, yz, xz, u, v, w]
    }

    /// `xx, yy, xy, xz, yz` of a tensor of the side's directions.
    #[inline(always)]
    fn axes(&self, [tt, nt, _, nn, nz, tz]: &[f64; 6]) -> [f64; 5] {
        let [tx, ty] = self.along;
        let (nx, ny) = (ty, -tx);
        [
            nx * nx * nn + 2.0 * nx * tx * nt + tx * tx * tt,
            ny * ny * nn + 2.0 * ny * ty * nt + ty * ty * tt,
            nx * ny * nn + (nx * ty + ny * tx) * nt + tx * ty * tt,
            nx * nz + tx * tz,
            ny * nz + ty * tz,
        ]
    }

    #[inline(always)]
    fn stress(&self, poisson: f64, shallow: &[f64; 6], deep: &[f64; 6]) -> [f64; 6] {
        let ([tx, ty], [x, y, z]) = (self.along, self.load);
        let (nx, ny) = (ty, -tx);
        let across = nx * x + ny * y;
        let ([xx, yy, xy, xz, yz], [dxx, dyy, dxy, dxz, dyz]) =
            (self.axes(shallow), self.axes(deep));
        let ([_, _, zz, _, nz, _], [_, _, dzz, _, dnz, _]) = (*shallow, *deep);
        let (four, nu) = (2.0 * zz, 4.0 * poisson);
        let psi_xx = -across * xx - z * nx * xz;
        let psi_yy = -across * yy - z * ny * yz;
        let psi_xy = -across * xy - z * nx * yz;
        [
            -2.0 * nx * x * four + 2.0 * z * nx * xz - nu * psi_yy
                + 2.0 * (across * dxx + z * nx * dxz),
            -2.0 * ny * y * four + 2.0 * z * ny * yz - nu * psi_xx
                + 2.0 * (across * dyy + z * ny * dyz),
            2.0 * z * nz + 2.0 * (across * dzz - z * dnz),
            -(nx * y + ny * x) * four
                + 2.0 * z * nx * yz
                + nu * psi_xy
                + 2.0 * (across * dxy + z * nx * dyz),
            2.0 * y * nz + 2.0 * (across * dyz + z * ny * dzz),
            2.0 * x * nz + 2.0 * (across * dxz + z * nx * dzz),
        ]
    }

    #[inline(always)]
    fn displacement(
        &self,
        depth: f64,
        poisson: f64,
        shallow: &[f64; 6],
        [in_t, in_n, in_z]: [f64; 3],
    ) -> [f64; 3] {
        let ([tx, ty], [x, y, z]) = (self.along, self.load);
        let (nx, ny) = (ty, -tx);
        let across = nx * x + ny * y;
        let (in_x, in_y) = (nx * in_n + tx * in_t, ny * in_n + ty * in_t);
        let [_, _, _, xz, yz] = self.axes(shallow);
        let [_, _, zz, _, nz, _] = *shallow;
        let nu = 2.0 * poisson;
        let psi = [
            -across * in_x - z * nx * in_z,
            -across * in_y - z * ny * in_z,
            z * in_n - across * in_z,
        ];
        [
            2.0 * x * in_n + z * nx * in_z + nu * psi[0] + depth * (across * xz + z * nx * zz),
            2.0 * y * in_n + z * ny * in_z + nu * psi[1] + depth * (across * yz + z * ny * zz),
            z * in_n + (1.0 - nu) * psi[2] - depth * (z * nz - across * zz),
        ]
    }
}

impl Forces {
    pub(super) fn len(&self) -> usize {
        self.x.len()
    }

    pub(super) fn push(&mut self, [x, y]: [f64; 2], force: [f64; 3]) {
        self.x.push(x);
        self.y.push(y);
        self.force.iter_mut().zip(force).for_each(|(column, force)| column.push(force));
    }

    /// Adds the fields of a range of them at a point (Boussinesq, Cerruti).
    #[inline(always)]
    pub(super) fn add(
        &self,
        range: Range<usize>,
        [x, y, z]: [f64; 3],
        poisson: f64,
        sums: &mut Sums,
    ) {
        for first in range.clone().step_by(ROOM) {
            let n = (range.end - first).min(ROOM);
            let (px, py) = (&self.x[first..][..n], &self.y[first..][..n]);
            let (fx, fy) = (&self.force[0][first..][..n], &self.force[1][first..][..n]);
            let fz = &self.force[2][first..][..n];
            for i in 0..n {
                let from = [x - px[i], y - py[i], z];
                add_to(sums, i, &point_force(from, [fx[i], fy[i], fz[i]], poisson));
            }
        }
    }
}

/// The field of a force `[X, Y, Z]` seen from a point away from it.
#[inline(always)]
fn point_force([dx, dy, dz]: [f64; 3], [fx, fy, fz]: [f64; 3], poisson: f64) -> Field {
    let compressible = 1.0 - 2.0 * poisson;
    let inverse = 1.0 / (dx * dx + dy * dy + dz * dz).sqrt();
    let [x, y, z] = [dx * inverse, dy * inverse, dz * inverse];
    let unit = 2.0 * inverse * inverse;
    let below = 1.0 / (1.0 + z);
    let square = below * below;
    // Without volume changes stresses are radial; what they add acts along the surface alone.
    let along = fx * x + fy * y;
    let radial = -3.0 * unit * (along + fz * z);
    let share = unit * compressible;
    let bend = share * (fz * (2.0 + z) * square + along * (square + 2.0 * square * below));
    let mean = share * (fz * (z - below) + along * (1.0 - square));
    let turn = share * square;
    let in_plane = radial + bend;
    let sunk = fz * (z - compressible * below);
    let straight = 1.0 + compressible * below;
    let bent = along * (1.0 - compressible * square) + sunk;
    [
        in_plane * x * x + mean - 2.0 * turn * fx * x,
        in_plane * y * y + mean - 2.0 * turn * fy * y,
        radial * z * z,
        in_plane * x * y - turn * (fx * y + fy * x),
        radial * y * z,
        radial * x * z,
        inverse * (fx * straight + x * bent),
        inverse * (fy * straight + y * bent),
        inverse * (fz * (z * z + 1.0 + compressible) + along * (z + compressible * below)),
    ]
}
