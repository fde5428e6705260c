//! The field of constant tractions on polygons, in closed form.
//!
//! A derivative along the surface of an integral over a polygon is an integral along its sides, so
//! the field is a sum over sides, each with the *jump* of the traction across it: a side that two
//! elements share is done once, and one between equal tractions not at all.
//!
//! Along a side, `t` runs from the point to the side's points against the side's direction, `h` is
//! the distance along its normal, out of the element. The primitives of the derivatives of
//! `Omega` are written so that nothing cancels on either side of the element and at any depth:
//! the logarithm of two neighbouring corners is one logarithm, and the two arctangents are one.

// What is not inlined is not compiled for the processor's vector instructions.
#![allow(clippy::inline_always)]

use std::collections::HashMap;

use pulp::Arch;

use super::lanes::{LANES, Lanes};

/// A side with the jump of `[X, Y, Z]` across it: what is on its left less what is on its right.
#[derive(Debug, Clone, Copy)]
pub(super) struct EdgeLoad {
    pub ends: [[f64; 2]; 2],
    pub load: [f64; 3],
}

/// A side.
#[derive(Debug, Clone, Copy)]
struct Edge {
    start: [f64; 2],
    /// Unit vector along the side; its normal is `(ty, -tx)`.
    along: [f64; 2],
    length: f64,
    load: [f64; 3],
}

/// Four sides, side by side.
#[derive(Debug, Clone, Copy)]
struct Group {
    start: [Lanes; 2],
    along: [Lanes; 2],
    length: Lanes,
    load: [Lanes; 3],
}

/// All sides of a set of elements.
#[derive(Debug, Clone)]
pub(super) struct Edges {
    groups: Vec<Group>,
    arch: Arch,
}

impl Default for Edges {
    fn default() -> Self {
        Self { groups: vec![], arch: Arch::new() }
    }
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
        Self { groups: edges.chunks(LANES).map(Group::new).collect(), ..Self::default() }
    }

    /// `4 pi` times the stress, `[xx, yy, zz, xy, yz, xz]`.
    pub(super) fn stress(&self, point: [f64; 3], poisson: f64) -> [f64; 6] {
        self.arch.dispatch(|| total(&self.groups, |group| group.stress(point, poisson)))
    }

    /// `4 pi G` times the displacement.
    pub(super) fn displacement(&self, point: [f64; 3], poisson: f64) -> [f64; 3] {
        self.arch.dispatch(|| total(&self.groups, |group| group.displacement(point, poisson)))
    }
}

#[inline(always)]
fn total<const N: usize>(groups: &[Group], part: impl Fn(&Group) -> [Lanes; N]) -> [f64; N] {
    let mut sum = [Lanes::default(); N];
    for group in groups {
        let part = part(group);
        for i in 0..N {
            sum[i] = sum[i] + part[i];
        }
    }
    sum.map(Lanes::sum)
}

/// A key of two ends; adding zero makes one of the two zeros.
fn key([x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> [u64; 4] {
    [x0, y0, x1, y1].map(|value| (value + 0.0).to_bits())
}

/// A symmetric tensor without trace, of the side's normal, its direction and the depth.
#[derive(Debug, Clone, Copy)]
struct Local {
    nn: Lanes,
    nt: Lanes,
    tt: Lanes,
    nz: Lanes,
    tz: Lanes,
    zz: Lanes,
}

/// The same in the directions of the axes.
struct Axes {
    xx: Lanes,
    yy: Lanes,
    xy: Lanes,
    xz: Lanes,
    yz: Lanes,
    zz: Lanes,
}

/// A point seen from the side: its distances from both ends, and one over them.
struct Seen {
    t: [Lanes; 2],
    h: Lanes,
    z: Lanes,
    r: [Lanes; 2],
    per_r: [Lanes; 2],
}

impl Seen {
    /// The integral of `1/r` along the side.
    #[inline(always)]
    fn inverse(&self, length: Lanes) -> Lanes {
        let around = self.r[0] + self.r[1];
        // On the side itself it is infinite, as the stress is.
        ((around + length) / (around - length).max(1e-30 * length)).ln()
    }

    /// The integral of `h / (r (r + z))`: the angle of the side, less that seen from the depth.
    #[inline(always)]
    fn angle(&self) -> Lanes {
        let end = |k: usize| {
            let [t, h, z] = [self.t[k], self.h, self.z].map(|length| length * self.per_r[k]);
            (t * h * (t * t + h * h), (Lanes::all(1.0) + z) * (h * h + z * t * t))
        };
        let ((y0, x0), (y1, x1)) = (end(0), end(1));
        (y0 * x1 - y1 * x0).atan2(x0 * x1 + y0 * y1)
    }

    /// Integrals along the side of the derivatives of `Omega` by `t`, `h` and `z`.
    #[inline(always)]
    fn first_derivatives(&self, local: &Local) -> [Lanes; 3] {
        let Self { t, h, z, r, .. } = *self;
        let logarithm = r.map(|r| (r + z).nonzero().ln());
        [
            z * (logarithm[0] - logarithm[1]) - r[0] + r[1],
            z * local.nz - h * local.zz,
            t[0] * logarithm[0] - t[0] - t[1] * logarithm[1] + t[1] + z * local.zz + h * local.nz,
        ]
    }
}

impl Group {
    /// Four sides, or fewer and some without load.
    fn new(edges: &[Edge]) -> Self {
        let of = |value: fn(&Edge) -> f64, none: f64| {
            Lanes::from_fn(|i| edges.get(i).map_or(none, value))
        };
        Self {
            start: [of(|edge| edge.start[0], 0.0), of(|edge| edge.start[1], 0.0)],
            along: [of(|edge| edge.along[0], 1.0), of(|edge| edge.along[1], 0.0)],
            length: of(|edge| edge.length, 1.0),
            load: [
                of(|edge| edge.load[0], 0.0),
                of(|edge| edge.load[1], 0.0),
                of(|edge| edge.load[2], 0.0),
            ],
        }
    }

    #[inline(always)]
    fn normal(&self) -> [Lanes; 2] {
        [self.along[1], -self.along[0]]
    }

    #[inline(always)]
    fn seen(&self, point: [f64; 3]) -> Seen {
        let [x, y, z] = point.map(Lanes::all);
        let ([dx, dy], [tx, ty]) = ([x - self.start[0], y - self.start[1]], self.along);
        let first = dx * tx + dy * ty;
        let (t, h) = ([first, first - self.length], dx * ty - dy * tx);
        let r = t.map(|t| (t * t + h * h + z * z).sqrt());
        Seen { t, h, z, r, per_r: r.map(|r| r.nonzero().recip()) }
    }

    /// Integrals along the side of the second derivatives of `Omega`, and `z` times those of its
    /// derivative by `z`.
    #[inline(always)]
    fn second_derivatives(&self, seen: &Seen) -> [Local; 2] {
        let Seen { t, h, z, r, per_r } = *seen;
        let (inverse, angle) = (seen.inverse(self.length), seen.angle());
        let sums = r.map(|r| (r + z).nonzero());
        let per_sum = sums.map(Lanes::recip);
        let tt = t[1] * per_sum[1] - t[0] * per_sum[0];
        let shallow = Local {
            tt,
            nt: h * (per_sum[1] - per_sum[0]),
            zz: inverse,
            nn: -tt - inverse,
            nz: angle,
            tz: (sums[0] * per_sum[1]).ln(),
        };
        let per = [0, 1].map(|k| z * per_r[k] * per_sum[k]);
        let reach = z / (h * h + z * z).nonzero() * (t[0] * per_r[0] - t[1] * per_r[1]);
        let tt = t[0] * per[0] - t[1] * per[1];
        let deep = Local {
            tt,
            nt: h * (per[0] - per[1]),
            zz: -z * reach,
            nn: z * reach - tt,
            nz: -h * reach,
            tz: z * (per_r[0] - per_r[1]),
        };
        [shallow, deep]
    }

    #[inline(always)]
    fn axes(&self, local: &Local) -> Axes {
        let ([tx, ty], [nx, ny]) = (self.along, self.normal());
        let Local { nn, nt, tt, nz, tz, zz } = *local;
        Axes {
            xx: nx * nx * nn + 2.0 * (nx * tx * nt) + tx * tx * tt,
            yy: ny * ny * nn + 2.0 * (ny * ty * nt) + ty * ty * tt,
            xy: nx * ny * nn + (nx * ty + ny * tx) * nt + tx * ty * tt,
            xz: nx * nz + tx * tz,
            yz: ny * nz + ty * tz,
            zz,
        }
    }

    /// With `psi = X_x + Y_y + Z_z` of the potentials of the three tractions, the in-plane stress is
    /// `2 (T_k,jzz + T_j,kzz) - 2 Z_jkz + 4 sigma (psi_jk + delta_jk psi_zz) - 2 z psi_jkz`; of the
    /// others the first term (of `zz` half of it) and the last are left.
    #[inline(always)]
    fn stress(&self, point: [f64; 3], poisson: f64) -> [Lanes; 6] {
        let seen = self.seen(point);
        let [local, deep_local] = self.second_derivatives(&seen);
        let (i, j) = (self.axes(&local), self.axes(&deep_local));
        let ([nx, ny], [x, y, z]) = (self.normal(), self.load);
        let (across, nu) = (nx * x + ny * y, 4.0 * poisson);
        let psi_xx = -across * i.xx - z * nx * i.xz;
        let psi_yy = -across * i.yy - z * ny * i.yz;
        let psi_xy = -across * i.xy - z * nx * i.yz;
        let deep = |own: Lanes, n: Lanes, below: Lanes| across * own + z * n * below;
        let twice = [
            -2.0 * (nx * x * i.zz) + z * nx * i.xz + deep(j.xx, nx, j.xz),
            -2.0 * (ny * y * i.zz) + z * ny * i.yz + deep(j.yy, ny, j.yz),
            z * local.nz + across * j.zz - z * deep_local.nz,
            -(nx * y + ny * x) * i.zz + z * nx * i.yz + deep(j.xy, nx, j.yz),
            y * local.nz + deep(j.yz, ny, j.zz),
            x * local.nz + deep(j.xz, nx, j.zz),
        ];
        let [xx, yy, zz, xy, yz, xz] = twice.map(|value| 2.0 * value);
        [xx - nu * psi_yy, yy - nu * psi_xx, zz, xy + nu * psi_xy, yz, xz]
    }

    #[inline(always)]
    fn displacement(&self, point: [f64; 3], poisson: f64) -> [Lanes; 3] {
        let seen = self.seen(point);
        let [local, _] = self.second_derivatives(&seen);
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
            2.0 * (x * in_n) + z * nx * in_z + nu * psi[0] - seen.z * deep[0],
            2.0 * (y * in_n) + z * ny * in_z + nu * psi[1] - seen.z * deep[1],
            z * in_n + (1.0 - nu) * psi[2] - seen.z * deep[2],
        ]
    }
}
