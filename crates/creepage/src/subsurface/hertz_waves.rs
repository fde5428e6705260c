//! The field of Hertz's pressure and of tractions in proportion to it, several directions at a time.
//!
//! The sums of `(1 - r^2)^(1/2)` over the lines across the unit disc are `pi/2 (1 - h^2)` in all directions, so
//! that a direction's potential of [`super::waves`] is that of a parabola, with
//! `Q_0 = ln((zeta + 1)/(zeta - 1))/2`:
//!
//! ```math
//! f = \frac12 \int_{-1}^{1} \frac{1 - h^2}{\zeta - h} \, dh = (1 - \zeta^2) Q_0 + \zeta, \qquad
//! f' = 2 - 2 \zeta Q_0, \qquad f'' = -2 Q_0 + \frac{2 \zeta}{\zeta^2 - 1}
//! ```

// So that all is compiled for each kind of processor.
#![allow(clippy::inline_always)]

use std::f64::consts::PI;
use std::ops::Range;

use pulp::{Arch, Simd, WithSimd};

use super::many::{Field, NOTHING, ROOM, Sums, add_to, total};
use super::wave::Source;
use crate::ellipse::Ellipse;
use crate::numerics::simd_math::{arctangent, ln_of_ratio};

/// Directions over half a turn: of the first sum, and of as many as double it each time.
const DIRECTIONS: [usize; 5] = [16, 16, 32, 64, 128];
/// Two sums that agree to this part of the traction are right to much better, as of
/// [`super::directions`].
const AGREEMENT: f64 = 1e-10;
/// More slender ellipses and points farther away, over the major semi-axis, are left to the general way.
const SLENDER: f64 = 0.1;
const FARTHEST: f64 = 20.0;

/// Tractions in proportion to Hertz's pressure, prepared.
#[derive(Debug, Clone)]
pub(super) struct HertzWaves {
    ellipse: Ellipse,
    /// Of `[X, Y, Z]`: factors of the parabola.
    strength: [f64; 3],
    directions: Directions,
}

/// Unit normals of lines on the disc, and of the same lines on the ellipse, with half its width along them.
#[derive(Debug, Clone, Default)]
struct Directions {
    circle: [Vec<f64>; 2],
    normal: [Vec<f64>; 2],
    half_width: Vec<f64>,
}

impl HertzWaves {
    /// `None` for tractions that are not in proportion to Hertz's pressure, and for slender ellipses.
    pub(super) fn new(source: &Source) -> Option<Self> {
        let ellipse = source.ellipse;
        if source.is_singular() || source.degree() != 2 || ellipse.g() < SLENDER {
            return None;
        }
        let (mut directions, mut coarser) = (Directions::default(), 0);
        for count in DIRECTIONS {
            // The first sum begins at zero, the others half a step beside those before.
            let first = if coarser == 0 { 0.0 } else { 0.5 };
            let spacing = PI / count.max(coarser) as f64;
            for k in 0..count {
                let wave = source.wave(spacing * (k as f64 + first));
                (0..2).for_each(|axis| directions.circle[axis].push(wave.circle[axis]));
                (0..2).for_each(|axis| directions.normal[axis].push(wave.normal[axis]));
                directions.half_width.push(wave.half_width);
            }
            coarser += count;
        }
        Some(Self { ellipse, strength: source.parabola(), directions })
    }

    /// `4 pi` times the stress, and `4 pi G` times the displacement; `None` where sums over so many
    /// directions do not settle.
    pub(super) fn field(&self, point @ [x, y, z]: [f64; 3], poisson: f64) -> Option<Field> {
        let major = self.ellipse.a().max(self.ellipse.b());
        if x.hypot(y).hypot(z) > FARTHEST * major {
            return None;
        }
        Arch::new().dispatch(Add { waves: self, point, poisson })
    }
}

struct Add<'a> {
    waves: &'a HertzWaves,
    point: [f64; 3],
    poisson: f64,
}

impl WithSimd for Add<'_> {
    type Output = Option<Field>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Option<Field> {
        let Self { waves: HertzWaves { ellipse, strength, directions }, point, poisson } = self;
        let [x, y, depth] = point;
        let at = [x / ellipse.a(), y / ellipse.b()];
        let size = strength.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        let mut sums = NOTHING;
        let (mut done, mut coarse): (usize, Option<Field>) = (0, None);
        for count in DIRECTIONS {
            directions.add(
                done..done + count,
                [at[0], at[1], depth],
                *strength,
                poisson,
                &mut sums,
            );
            done += count;
            let fine = total(&sums).map(|sum| sum * (PI / done as f64));
            let unit = ellipse.minor();
            let apart = coarse.map(|coarse| {
                let apart = |k: usize| (coarse[k] - fine[k]).abs() / if k < 6 { 1.0 } else { unit };
                (0..9).map(apart).fold(0.0_f64, f64::max)
            });
            if apart.is_some_and(|apart| apart <= AGREEMENT * size) {
                return Some(fine);
            }
            coarse = Some(fine);
        }
        None
    }
}

impl Directions {
    /// Adds what a range of directions contributes to the field at a depth below a place of the disc.
    #[inline(always)]
    fn add(
        &self,
        range: Range<usize>,
        [x, y, depth]: [f64; 3],
        strength: [f64; 3],
        poisson: f64,
        sums: &mut Sums,
    ) {
        for first in range.clone().step_by(ROOM) {
            let n = (range.end - first).min(ROOM);
            let (cos, sin) = (&self.circle[0][first..][..n], &self.circle[1][first..][..n]);
            let (nx, ny) = (&self.normal[0][first..][..n], &self.normal[1][first..][..n]);
            let half_width = &self.half_width[first..][..n];
            for i in 0..n {
                let direction = Direction { normal: [nx[i], ny[i]], half_width: half_width[i] };
                let from_end = cos[i] * x + sin[i] * y - 1.0;
                add_to(sums, i, &direction.field(from_end, depth, strength, poisson));
            }
        }
    }
}

/// One direction.
struct Direction {
    normal: [f64; 2],
    half_width: f64,
}

impl Direction {
    /// What it contributes to the field where `zeta` is `1 + from_end - i depth/half_width`.
    #[inline(always)]
    fn field(&self, from_end: f64, depth: f64, strength: [f64; 3], poisson: f64) -> Field {
        let down = depth / self.half_width;
        let (near, far) = (from_end, from_end + 2.0);
        let (near_square, far_square) =
            ((near * near + down * down).max(1e-60), (far * far + down * down).max(1e-60));
        // Q_0, on the cut the limit from below.
        let (qr, qi) = (
            0.25 * ln_of_ratio::<false>(far_square, near_square),
            0.5 * (arctangent(-down, far) - arctangent(-down, near)),
        );
        // zeta, and its square less one.
        let (zr, zi) = (from_end + 1.0, -down);
        let (sr, si) = (near * far - down * down, -down * (near + far));
        let (f_r, f_i) = (zr - (sr * qr - si * qi), zi - (sr * qi + si * qr));
        let (first_r, first_i) = (2.0 - 2.0 * (zr * qr - zi * qi), -2.0 * (zr * qi + zi * qr));
        let per = 2.0 / (near_square * far_square);
        let (second_r, second_i) =
            (per * (zr * sr + zi * si) - 2.0 * qr, per * (zi * sr - zr * si) - 2.0 * qi);
        let ([nx, ny], [x, y, z]) = (self.normal, strength);
        let across = nx * x + ny * y;
        let nu = 4.0 * poisson;
        // Real parts of S/w^2, and both of z S/w^3.
        let source = 2.0 * (z * first_r - across * first_i);
        let deep =
            [down * (-across * second_r - z * second_i), down * (z * second_r - across * second_i)];
        let pressed = 4.0 * (z * first_r - deep[0]) - nu * source;
        // The same of S/w.
        let width = 2.0 * self.half_width;
        let along = width * (2.0 * poisson * (z * f_r - across * f_i) - z * f_r)
            - 2.0 * depth * (across * first_r + z * first_i);
        [
            8.0 * nx * x * first_i - nx * nx * pressed - nu * source,
            8.0 * ny * y * first_i - ny * ny * pressed - nu * source,
            -4.0 * (z * first_r + deep[0]),
            4.0 * (nx * y + ny * x) * first_i - nx * ny * pressed,
            -4.0 * y * first_r + 4.0 * ny * deep[1],
            -4.0 * x * first_r + 4.0 * nx * deep[1],
            2.0 * width * x * f_i + nx * along,
            2.0 * width * y * f_i + ny * along,
            width * (z * f_i + (1.0 - 2.0 * poisson) * (across * f_r + z * f_i))
                + 2.0 * depth * (z * first_r - across * first_i),
        ]
    }
}
