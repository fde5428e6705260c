//! Strips as sources of displacement, several of them seen from a point at once: from the table
//! where it reaches them, by quadrature beyond.

// So that all is compiled for each kind of processor; loops over lanes index several arrays at once.
#![allow(clippy::inline_always, clippy::needless_range_loop)]

use std::array::from_fn;
use std::f64::consts::PI;

use super::kernel::{Integrals, View, log_integrals, log_slopes};
use super::rules::{CENTRED, Node, RULES};
use super::side::{Places, TABLE, TABULATED};
use super::strip::Strip;
use crate::numerics::simd_math::{LANES, Lanes, each, ln};

/// Neighbouring strips whose pressures have `T` terms.
#[derive(Debug, Clone, Copy)]
pub(in crate::normal) struct Sources<const T: usize> {
    y: Lanes,
    width: Lanes,
    centre: Lanes,
    half: Lanes,
    pressure: [Lanes; T],
    /// How many there are; the last one stands for those that are missing.
    count: usize,
}

/// What sources displace a point by for the unit of each term, and how the displacement follows their
/// places.
#[derive(Debug, Clone, Copy)]
pub(super) struct Displacements<const T: usize> {
    pub(super) value: [Lanes; T],
    /// By the point's `x` over a source's half length; zero for the point's own strip, with which
    /// it moves.
    pub(super) by_x: Lanes,
    /// By the logarithm of a common factor of the distances of both sides.
    pub(super) by_e: Lanes,
}

impl<const T: usize> Sources<T> {
    /// All strips, in their order.
    pub(in crate::normal) fn all(strips: &[Strip]) -> Vec<Self> {
        strips.chunks(LANES).filter_map(Self::new).collect()
    }

    fn new(strips: &[Strip]) -> Option<Self> {
        let last = strips.last()?;
        let of = |value: &dyn Fn(&Strip) -> f64| each(|l| value(strips.get(l).unwrap_or(last)));
        Some(Self {
            y: of(&|strip| strip.y),
            width: of(&|strip| strip.width),
            centre: of(&|strip| strip.centre),
            half: of(&|strip| strip.half),
            pressure: from_fn(|k| of(&|strip| strip.pressure[k])),
            count: strips.len(),
        })
    }

    /// How many strips there are.
    #[inline(always)]
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// Displacement at a point by the pressures of all.
    #[inline(always)]
    pub(in crate::normal) fn displacement(&self, at: [f64; 2]) -> f64 {
        self.sum(&self.displacements::<false>(at, None))
    }

    /// What these displacements come to with the pressures.
    #[inline(always)]
    pub(super) fn sum(&self, displacements: &Displacements<T>) -> f64 {
        self.by_source(displacements).iter().take(self.count).sum()
    }

    /// The same of each source.
    #[inline(always)]
    pub(super) fn by_source(&self, Displacements { value, .. }: &Displacements<T>) -> Lanes {
        each(|l| (0..T).map(|k| self.pressure[k][l] * value[k][l]).sum::<f64>())
    }

    /// Adds the derivatives of a displacement at `x` to a row: by the terms of each source's pressure,
    /// and with `SLOPES` by its centre in half lengths unless that is known, and by the logarithm of its
    /// half length. Returns that by `x`.
    #[inline(always)]
    pub(super) fn add_to<const SLOPES: bool>(
        &self,
        row: &mut [f64],
        x: f64,
        found: &Displacements<T>,
    ) -> f64 {
        let (size, value) = (T + if T == CENTRED { 1 } else { 2 }, self.by_source(found));
        for (l, own) in row.chunks_exact_mut(size).take(self.count).enumerate() {
            for k in 0..T {
                own[k] += found.value[k][l];
            }
            if SLOPES {
                let distance = (x - self.centre[l]) / self.half[l];
                if T != CENTRED {
                    own[T] -= found.by_x[l];
                }
                own[size - 1] += value[l] - distance * found.by_x[l] - found.by_e[l];
            }
        }
        (0..self.count).map(|l| found.by_x[l] / self.half[l]).sum()
    }

    /// Displacements at a point, which may lie on the middle line of one of them, `own`; with `SLOPES`
    /// also their derivatives.
    #[inline(always)]
    pub(super) fn displacements<const SLOPES: bool>(
        &self,
        [x, y]: [f64; 2],
        own: Option<usize>,
    ) -> Displacements<T> {
        let Self { centre, half, width, .. } = self;
        let x = each(|l| (x - centre[l]) / half[l]);
        // Seen from the side on which both are as far up as possible: the integrals are the same.
        let across = each(|l| (y - self.y[l]).abs());
        let low = each(|l| (across[l] - width[l]) / half[l]);
        let high = each(|l| (across[l] + width[l]) / half[l]);
        let seen = Seen { x, low, high };
        let far = Places::new(&x.map(f64::abs), &high);
        let reached = far.are_tabulated().map(|is_reached| is_reached && T <= TABULATED);
        let mut found = Displacements::NONE;
        if reached.contains(&true) {
            found = self.tabulated::<SLOPES>(&seen, &far);
        }
        let some_are_beyond = T <= TABULATED && reached.contains(&false);
        if let Some(nodes) = some_are_beyond.then(|| seen.nodes(reached)).flatten() {
            let far = self.far::<SLOPES>(&seen, nodes);
            found.replace(&far, |l| !reached[l]);
        } else {
            for l in (0..self.count).filter(|l| !reached[*l]) {
                let view = View { x: x[l], low: low[l], high: high[l], own: own == Some(l) };
                let near = view.by_quadrature::<T, SLOPES>(&RULES, &self.pressures_of(l));
                found.replace(&Displacements::all(near), |other| other == l);
            }
        }
        if let Some(own) = own {
            found.by_x[own] = 0.0;
        }
        found.scaled(half)
    }

    #[inline(always)]
    fn pressures_of(&self, l: usize) -> [f64; T] {
        from_fn(|k| self.pressure[k][l])
    }

    /// The integrals of [`View`] by a few points, for sources far enough away.
    #[inline(always)]
    fn far<const SLOPES: bool>(
        &self,
        Seen { x, low, high }: &Seen,
        nodes: &[Node],
    ) -> Displacements<T> {
        let mut found = Displacements::NONE;
        for Node { s, weights } in nodes {
            let d = each(|l| x[l] - s);
            let above = each(|l| (high[l] * high[l] + d[l] * d[l]).sqrt());
            let below = each(|l| (low[l] * low[l] + d[l] * d[l]).sqrt());
            let log = each(|l| ln((high[l] + above[l]) / (low[l] + below[l])));
            for k in 0..T {
                for l in 0..LANES {
                    found.value[k][l] += weights[k] * log[l];
                }
            }
            if SLOPES {
                let weight = each(|l| (0..T).map(|k| self.pressure[k][l] * weights[k]).sum());
                // high/above - low/below over d, where nothing cancels.
                let slope = each(|l| {
                    let square = (high[l] - low[l]) * (high[l] + low[l]);
                    let sum = high[l] * below[l] + low[l] * above[l];
                    weight[l] * d[l] * square / (above[l] * below[l] * sum)
                });
                for l in 0..LANES {
                    found.by_x[l] -= slope[l];
                    found.by_e[l] += d[l] * slope[l];
                }
            }
        }
        found
    }

    /// The integrals of [`View`] from the table.
    #[inline(always)]
    fn tabulated<const SLOPES: bool>(
        &self,
        Seen { x, low, .. }: &Seen,
        far: &Places,
    ) -> Displacements<T> {
        let near = Places::new(&x.map(f64::abs), &low.map(f64::abs));
        // The polynomials are even or odd.
        let sign: [Lanes; T] =
            from_fn(|k| each(|l| if k % 2 == 1 { 1f64.copysign(x[l]) } else { 1.0 }));
        let pressure: [Lanes; T] = from_fn(|k| each(|l| sign[k][l] * self.pressure[k][l]));
        let far = TABLE.sides::<T, SLOPES>(far, &pressure);
        let near = TABLE.sides::<T, SLOPES>(&near, &pressure);
        // A point between both sides sees them in opposite directions.
        let side = each(|l| if low[l] < 0.0 { 1.0 } else { -1.0 });
        let mut found = Displacements {
            value: from_fn(|k| each(|l| far.value[k][l] + side[l] * near.value[k][l])),
            by_x: each(|l| far.by_x[l] + side[l] * near.by_x[l]),
            by_e: each(|l| far.by_e[l] + side[l] * near.by_e[l]),
        };
        for l in (0..LANES).filter(|l| low[*l] < 0.0) {
            let logs = log_integrals::<T>(x[l].abs());
            for k in 0..T {
                found.value[k][l] -= 2.0 * logs[k];
            }
            if SLOPES {
                found.by_x[l] -= 2.0 * log_slopes::<T>(x[l].abs(), &from_fn(|k| pressure[k][l]));
            }
        }
        Displacements {
            value: from_fn(|k| each(|l| sign[k][l] * found.value[k][l])),
            by_x: each(|l| found.by_x[l] * 1f64.copysign(x[l])),
            ..found
        }
    }
}

/// Where the sides of sources are seen from a point, in half lengths, the nearer one below.
#[derive(Debug, Clone, Copy)]
struct Seen {
    x: Lanes,
    low: Lanes,
    high: Lanes,
}

impl Seen {
    /// Points of quadrature that are enough for all sources the table does not reach; `None` where
    /// one is too near, or beside the point.
    #[inline(always)]
    fn nodes(&self, reached: [bool; LANES]) -> Option<&'static [Node]> {
        let near = Places::new(&self.x.map(f64::abs), &self.low).mean();
        let nearest = (0..LANES)
            .filter(|l| !reached[*l])
            .map(|l| if self.low[l] > 0.0 { near[l] } else { 0.0 });
        RULES.few(nearest.fold(f64::INFINITY, f64::min))
    }
}

impl<const T: usize> Displacements<T> {
    const NONE: Self = Self { value: [[0.0; LANES]; T], by_x: [0.0; LANES], by_e: [0.0; LANES] };

    /// The same for all sources.
    #[inline(always)]
    fn all(Integrals { value, by_x, by_e }: Integrals<T>) -> Self {
        let all = |number: f64| [number; LANES];
        Self { value: value.map(all), by_x: all(by_x), by_e: all(by_e) }
    }

    #[inline(always)]
    fn replace(&mut self, by: &Self, which: impl Fn(usize) -> bool) {
        for l in 0..LANES {
            if which(l) {
                for k in 0..T {
                    self.value[k][l] = by.value[k][l];
                }
                (self.by_x[l], self.by_e[l]) = (by.by_x[l], by.by_e[l]);
            }
        }
    }

    /// Integrals over half lengths as displacements.
    #[inline(always)]
    fn scaled(self, half: &Lanes) -> Self {
        let scaled = |lanes: Lanes| each(|l| half[l] / PI * lanes[l]);
        Self { value: self.value.map(scaled), by_x: scaled(self.by_x), by_e: scaled(self.by_e) }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::normal::strip_system::MAX_TERMS;

    /// One strip of half length 1, seen from `(x, 0)`.
    fn one(low: f64, high: f64) -> Sources<TABULATED> {
        let [y, width] = [-0.5 * (low + high), 0.5 * (high - low)];
        let pressure = [0.7, 0.3, -0.2, 0.1, 0.0, 0.0, 0.0, 0.0];
        let strip = Strip { y, width, centre: 0.0, half: 1.0, pressure, band: 0 };
        Sources::new(&[strip]).unwrap()
    }

    fn is_tabulated(x: f64, high: f64) -> bool {
        Places::new(&[x.abs(); LANES], &[high; LANES]).are_tabulated()[0]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        /// Random places, near and far: cubics err most in the table's cells next to a strip's ends,
        /// where slopes are those of a root; they serve Newton's method only.
        #[test]
        fn the_table_is_the_integral(
            x in -1.4..1.4_f64, own in 0..5, scale in -3.0..-0.3_f64, place in -1.0..5.0_f64, part in 0.0..1.0_f64,
        ) {
            let (own, width) = (own == 0, 10.0_f64.powf(scale));
            let x = if own { x / 1.5 } else { x };
            let low = if own { -width } else { width * place };
            let high = if own { width } else { low + 2.0 * width * part };
            let view = View { x, low, high, own }.upright();
            prop_assume!(is_tabulated(x, view.high));
            let strip = one(low, high);
            let found = strip.displacements::<true>([x, 0.0], own.then_some(0));
            let expected = view.by_quadrature::<MAX_TERMS, true>(
                &RULES,
                &[0.7, 0.3, -0.2, 0.1, 0.0, 0.0, 0.0, 0.0],
            );
            for (found, expected) in found.value.iter().zip(expected.value) {
                let found = PI * found[0];
                prop_assert!((found - expected).abs() < 5e-6, "{view:?}: {found} {expected}");
            }
            let [by_x, by_e] = [found.by_x[0], found.by_e[0]].map(|by| PI * by);
            prop_assert!((by_e - expected.by_e).abs() < 1e-3, "{view:?}");
            // Between the sides quadrature finds no slope: it would be a principal value.
            let is_near_end = (x.abs() - 1.0).hypot(view.low) < 0.05;
            let size = expected.by_x.abs().max(1.0);
            let by_x = (by_x - expected.by_x) / size;
            prop_assert!(is_near_end || view.low < 0.0 || by_x.abs() < 1e-4, "{view:?}: {by_x:e}");
        }
    }

    /// Where a root meets a logarithm, cubics err most.
    #[test]
    fn the_table_is_the_integral_next_to_an_end() {
        let sizes = || (0..24).map(|k| 10.0_f64.powf(-6.0 + 0.25 * f64::from(k)));
        for (beyond, high) in sizes().flat_map(|one| sizes().map(move |other| (one, other))) {
            for (sign, part) in [(1.0, -0.9), (1.0, -0.2), (1.0, 0.5), (-1.0, -0.4), (-1.0, 0.7)] {
                let view = View { x: 1.0 + sign * beyond, low: part * high, high, own: false };
                if !is_tabulated(view.x, high) {
                    continue;
                }
                let found = one(view.low, high).displacements::<false>([view.x, 0.0], None);
                let expected = view.by_quadrature::<MAX_TERMS, false>(&RULES, &[]);
                for (found, expected) in found.value.iter().zip(expected.value) {
                    let error = PI * found[0] - expected;
                    assert!(error.abs() < 5e-6, "{view:?}: {error:e}");
                }
            }
        }
    }

    /// Between the sides of a strip of another band, beyond its end.
    #[test]
    fn slopes_of_the_table_are_those_of_its_values() {
        const DIFFERENCE_STEP: f64 = 1e-5;
        for (x, low, high) in [(1.2, -0.1, 0.3), (-1.1, -0.2, 0.25), (0.4, 0.05, 0.2)] {
            assert!(is_tabulated(x, high));
            let strip = one(low, high);
            let at = |x: f64| {
                let found = strip.displacements::<true>([x, 0.0], None);
                (PI * strip.sum(&found), PI * found.by_x[0])
            };
            let by_x =
                (at(x + DIFFERENCE_STEP).0 - at(x - DIFFERENCE_STEP).0) / (2.0 * DIFFERENCE_STEP);
            // Within a cubic they are the same but for what the difference leaves out.
            assert!((at(x).1 - by_x).abs() < 1e-7, "{x}: {} {by_x}", at(x).1);
        }
    }

    /// A block that is not full, some of its strips beyond the table's reach, one the point's own.
    #[test]
    fn strips_seen_together_are_those_seen_alone() {
        let strip = |k: u32| Strip {
            y: f64::from(k) * 0.4,
            width: 0.2,
            centre: 0.1 * f64::from(k),
            half: 1.0 / f64::from(k + 1),
            pressure: [1.0, 0.5, -0.3, 0.2, 0.0, 0.0, 0.0, 0.0],
            band: 0,
        };
        let strips: Vec<Strip> = (0..11).map(strip).collect();
        let at = [strips[2].centre + 0.3 * strips[2].half, strips[2].y];
        let together = Sources::<TABULATED>::all(&strips);
        let sum: f64 = together.iter().map(|some| some.displacement(at)).sum();
        let alone = strips.iter().flat_map(|one| Sources::<TABULATED>::all(&[*one]));
        let of_each: f64 = alone.map(|one| one.displacement(at)).sum();
        // As many points serve all of a block as its nearest strip needs: alone each errs by 2e-6 at most.
        assert!((sum / of_each - 1.0).abs() < 2e-6, "{sum} {of_each}");
    }
}
