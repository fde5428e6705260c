//! Field of constant tractions on polygons, in closed form.
//!
//! A derivative along the surface of an integral over a polygon is an integral along its sides, so
//! the field is a sum over sides, each with the *jump* of the traction across it: a side that two
//! elements share is done once, and one between equal tractions not at all.
//!
//! Along a side, `t` runs from the point to the side's points against the side's direction, `h` is
//! the distance along its normal, out of the element. The primitives of the derivatives of
//! `Omega` are written so that nothing cancels on either side of the element and at any depth:
//! the logarithm of two neighbouring corners is one logarithm, and the two arctangents are one.

use std::collections::HashMap;

/// A side with the jump of `[X, Y, Z]` across it: what is on its left less what is on its right.
#[derive(Debug, Clone, Copy)]
pub(super) struct EdgeLoad {
    pub ends: [[f64; 2]; 2],
    pub load: [f64; 3],
}

/// A side, prepared.
#[derive(Debug, Clone, Copy)]
struct Edge {
    start: [f64; 2],
    /// Unit vector along the side; its normal is `(ty, -tx)`.
    along: [f64; 2],
    length: f64,
    load: [f64; 3],
}

/// All sides of a set of elements.
#[derive(Debug, Clone, Default)]
pub(super) struct Edges {
    edges: Vec<Edge>,
}

impl Edges {
    /// Joins sides with the same ends, in either direction.
    pub(super) fn new(sides: impl Iterator<Item = EdgeLoad>) -> Self {
        let mut known: HashMap<[u64; 4], usize> = HashMap::new();
        let mut edges: Vec<Edge> = Vec::new();
        for EdgeLoad { ends: [start, end], load } in sides {
            let ([dx, dy], [tx, ty]) = ([end[0] - start[0], end[1] - start[1]], [start, end]);
            let length = dx.hypot(dy);
            if length == 0.0 {
                continue;
            }
            if let Some(&twin) = known.get(&key(ty, tx)) {
                edges[twin].load.iter_mut().zip(load).for_each(|(sum, own)| *sum -= own);
            } else if let Some(&same) = known.get(&key(tx, ty)) {
                edges[same].load.iter_mut().zip(load).for_each(|(sum, own)| *sum += own);
            } else {
                known.insert(key(tx, ty), edges.len());
                edges.push(Edge { start, along: [dx / length, dy / length], length, load });
            }
        }
        edges.retain(|edge| edge.load.iter().any(|jump| *jump != 0.0));
        Self { edges }
    }

    /// The sides: start, unit vector along, length, and jump of the traction.
    pub(super) fn sides(&self) -> impl Iterator<Item = ([f64; 2], [f64; 2], f64, [f64; 3])> {
        self.edges.iter().map(|edge| (edge.start, edge.along, edge.length, edge.load))
    }

    /// `4 pi` times the stress, `[xx, yy, zz, xy, yz, xz]`.
    pub(super) fn stress(&self, point: [f64; 3], poisson: f64) -> [f64; 6] {
        let mut sum = [0.0; 6];
        for edge in &self.edges {
            let part = edge.stress(point, poisson);
            sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        }
        sum
    }

    /// `4 pi G` times the displacement.
    pub(super) fn displacement(&self, point: [f64; 3], poisson: f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for edge in &self.edges {
            let part = edge.displacement(point, poisson);
            sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        }
        sum
    }
}

/// A key of two ends; adding zero makes one of the two zeros.
fn key([x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> [u64; 4] {
    [x0, y0, x1, y1].map(|value| (value + 0.0).to_bits())
}

/// A symmetric tensor without trace, of the side's normal, its direction and the depth.
#[derive(Debug, Clone, Copy)]
struct Local {
    nn: f64,
    nt: f64,
    tt: f64,
    nz: f64,
    tz: f64,
    zz: f64,
}

/// The same in the directions of the axes.
struct Axes {
    xx: f64,
    yy: f64,
    xy: f64,
    xz: f64,
    yz: f64,
    zz: f64,
}

/// A point seen from the side: its distances from both ends.
struct Seen {
    t: [f64; 2],
    h: f64,
    z: f64,
    r: [f64; 2],
}

impl Seen {
    /// The integral of `1/r` along the side.
    fn inverse(&self, length: f64) -> f64 {
        // On the side itself it is infinite, as the stress is.
        let beyond = (self.r[0] + self.r[1] - length).max(1e-30 * length);
        (2.0 * length / beyond).ln_1p()
    }

    /// The integral of `h / (r (r + z))`: the angle of the side, less that seen from the depth.
    fn angle(&self) -> f64 {
        let Self { h, z, .. } = *self;
        let [(y0, x0), (y1, x1)] = [0, 1].map(|k| {
            let (t, r) = (self.t[k], self.r[k]);
            (t * h * (t * t + h * h), (r + z) * (h * h * r + z * t * t))
        });
        // Scaled: products of the two would be of sixteenth degree in lengths.
        let (s0, s1) = (size(x0, y0), size(x1, y1));
        let ((y0, x0), (y1, x1)) = ((y0 / s0, x0 / s0), (y1 / s1, x1 / s1));
        (y0 * x1 - y1 * x0).atan2(x0 * x1 + y0 * y1)
    }

    /// Integrals along the side of the derivatives of `Omega` by `t`, `h` and `z`.
    fn first_derivatives(&self, local: &Local) -> [f64; 3] {
        let Seen { t, h, z, r } = *self;
        let omega = [0, 1].map(|k| z * nonzero(r[k] + z).ln() - r[k]);
        let lengthwise = [0, 1].map(|k| t[k] * nonzero(r[k] + z).ln() - t[k]);
        [
            omega[0] - omega[1],
            z * local.nz - h * local.zz,
            lengthwise[0] - lengthwise[1] + z * local.zz + h * local.nz,
        ]
    }
}

/// A divisor of the size of both.
fn size(x: f64, y: f64) -> f64 {
    (x.abs() + y.abs()).max(f64::MIN_POSITIVE)
}

/// A divisor that is never zero.
fn nonzero(value: f64) -> f64 {
    value.max(f64::MIN_POSITIVE)
}

impl Edge {
    fn normal(&self) -> [f64; 2] {
        [self.along[1], -self.along[0]]
    }

    fn seen(&self, [x, y, z]: [f64; 3]) -> Seen {
        let ([dx, dy], [tx, ty]) = ([x - self.start[0], y - self.start[1]], self.along);
        let first = dx * tx + dy * ty;
        let (t, h) = ([first, first - self.length], dx * ty - dy * tx);
        Seen { t, h, z, r: t.map(|t| (t * t + h * h + z * z).sqrt()) }
    }

    /// Integrals along the side of the second derivatives of `Omega`, and `z` times those of its
    /// derivative by `z`.
    fn second_derivatives(&self, seen: &Seen) -> [Local; 2] {
        let Seen { t, h, z, r } = *seen;
        let (inverse, angle) = (seen.inverse(self.length), seen.angle());
        let sums = [nonzero(r[0] + z), nonzero(r[1] + z)];
        let tt = t[1] / sums[1] - t[0] / sums[0];
        let shallow = Local {
            tt,
            nt: h / sums[1] - h / sums[0],
            zz: inverse,
            nn: -tt - inverse,
            nz: angle,
            tz: (sums[0] / sums[1]).ln(),
        };
        let per = [0, 1].map(|k| z / nonzero(r[k] * sums[k]));
        let slant = z / nonzero(h * h + z * z);
        let reach = slant * (t[0] / nonzero(r[0]) - t[1] / nonzero(r[1]));
        let tt = t[0] * per[0] - t[1] * per[1];
        let deep = Local {
            tt,
            nt: h * (per[0] - per[1]),
            zz: -z * reach,
            nn: z * reach - tt,
            nz: -h * reach,
            tz: z / nonzero(r[0]) - z / nonzero(r[1]),
        };
        [shallow, deep]
    }

    fn axes(&self, local: &Local) -> Axes {
        let ([tx, ty], [nx, ny]) = (self.along, self.normal());
        let Local { nn, nt, tt, nz, tz, zz } = *local;
        Axes {
            xx: nx * nx * nn + 2.0 * nx * tx * nt + tx * tx * tt,
            yy: ny * ny * nn + 2.0 * ny * ty * nt + ty * ty * tt,
            xy: nx * ny * nn + (nx * ty + ny * tx) * nt + tx * ty * tt,
            xz: nx * nz + tx * tz,
            yz: ny * nz + ty * tz,
            zz,
        }
    }

    /// With `psi = X_x + Y_y + Z_z` of the potentials of the three tractions, the stress is
    /// `2 (T_k,jzz + T_j,kzz) - 2 Z_jkz + 4 sigma psi_jk ... - 2 z psi_jkz`.
    fn stress(&self, point: [f64; 3], poisson: f64) -> [f64; 6] {
        let seen = self.seen(point);
        let [local, deep_local] = self.second_derivatives(&seen);
        let (i, j) = (self.axes(&local), self.axes(&deep_local));
        let ([nx, ny], [x, y, z]) = (self.normal(), self.load);
        let across = nx * x + ny * y;
        let (four, nu) = (2.0 * i.zz, 4.0 * poisson);
        let psi_xx = -across * i.xx - z * nx * i.xz;
        let psi_yy = -across * i.yy - z * ny * i.yz;
        let psi_xy = -across * i.xy - z * nx * i.yz;
        let deep = |own: f64, n: f64, below: f64| 2.0 * (across * own + z * n * below);
        [
            -2.0 * nx * x * four + 2.0 * z * nx * i.xz - nu * psi_yy + deep(j.xx, nx, j.xz),
            -2.0 * ny * y * four + 2.0 * z * ny * i.yz - nu * psi_xx + deep(j.yy, ny, j.yz),
            2.0 * z * local.nz + 2.0 * (across * j.zz - z * deep_local.nz),
            -(nx * y + ny * x) * four + 2.0 * z * nx * i.yz + nu * psi_xy + deep(j.xy, nx, j.yz),
            2.0 * y * local.nz + deep(j.yz, ny, j.zz),
            2.0 * x * local.nz + deep(j.xz, nx, j.zz),
        ]
    }

    fn displacement(&self, point: [f64; 3], poisson: f64) -> [f64; 3] {
        let seen = self.seen(point);
        let [local, _] = self.second_derivatives(&seen);
        let depth = seen.z;
        let ([nx, ny], [tx, ty], [x, y, z]) = (self.normal(), self.along, self.load);
        let across = nx * x + ny * y;
        let [in_t, in_n, in_z] = seen.first_derivatives(&local);
        let (in_x, in_y) = (nx * in_n + tx * in_t, ny * in_n + ty * in_t);
        let i = self.axes(&local);
        // psi_x, psi_y, psi_z, then psi_xz, psi_yz, psi_zz.
        let psi = [
            -across * in_x - z * nx * in_z,
            -across * in_y - z * ny * in_z,
            z * in_n - across * in_z,
        ];
        let deep = [
            -across * i.xz - z * nx * i.zz,
            -across * i.yz - z * ny * i.zz,
            z * local.nz - across * i.zz,
        ];
        let nu = 2.0 * poisson;
        [
            2.0 * x * in_n + z * nx * in_z + nu * psi[0] - depth * deep[0],
            2.0 * y * in_n + z * ny * in_z + nu * psi[1] - depth * deep[1],
            z * in_n + (1.0 - nu) * psi[2] - depth * deep[2],
        ]
    }
}
