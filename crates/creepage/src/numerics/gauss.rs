//! Rules of Gauss on (-1, 1) with few points, where a table is known when the program is compiled; other rules come from
//! the crate `gauss-quad`.

/// Places and weights of two points.
pub(crate) const GAUSS_2: [(f64, f64); 2] =
    [(-0.577_350_269_189_625_8, 1.0), (0.577_350_269_189_625_8, 1.0)];

/// Places and weights of three points.
pub(crate) const GAUSS_3: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

/// Places and weights of four points.
pub(crate) const GAUSS_4: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// Places and weights of those of ten points that are positive; the others are their mirror images.
pub(crate) const HALF_OF_GAUSS_10: [(f64, f64); 5] = [
    (0.148_874_338_981_631_21, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_36),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// A rule of `n` points integrates powers up to `2 n - 1`, and errs on the next even one.
    #[test]
    fn powers_are_integrated_up_to_the_degree_of_each_rule() {
        let mirrored = HALF_OF_GAUSS_10.map(|(at, weight)| (-at, weight));
        let ten = [mirrored, HALF_OF_GAUSS_10].concat();
        for rule in [&GAUSS_2[..], &GAUSS_3[..], &GAUSS_4[..], &ten[..]] {
            let sum = |power: i32| -> f64 { rule.iter().map(|(at, w)| w * at.powi(power)).sum() };
            let points = i32::try_from(rule.len()).unwrap();
            for power in 0..2 * points {
                let exact = if power % 2 == 0 { 2.0 / f64::from(power + 1) } else { 0.0 };
                // Roundings of ten places and weights.
                assert!((sum(power) - exact).abs() < 1e-15, "{points} points, power {power}");
            }
            let missed = (sum(2 * points) - 2.0 / f64::from(2 * points + 1)).abs();
            assert!(missed > 1e-7, "{points} points: {missed}");
        }
    }
}
