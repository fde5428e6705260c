//! The error bars: what they promise holds.

use creepage::Theory;
use creepage::coulomb::{Automatic, Resolution};

use crate::common::{at, contact};
use crate::support::{Found, components, exact, solve};

/// How many components of the force are as near to the true ones as their bars say.
fn covered(found: &Found, truth: &Found) -> usize {
    let pairs = components(found.force).into_iter().zip(components(truth.force));
    let within = pairs.zip(components(found.error));
    within.filter(|((value, truth), bar)| (value - truth).abs() <= *bar).count()
}

/// The error bar of the fast resolution against the fine one, which is ten times as accurate, on
/// contacts and creepages of every kind. The bar is made for 95 %.
#[test]
fn the_error_bar_holds() {
    let (mut inside, mut all) = (0, 0);
    for (ratio, poisson) in
        [(0.2, 0.1), (0.6, 0.45), (1.0, 0.28), (1.7, 0.0), (3.0, 0.35), (5.0, 0.2)]
    {
        let [fast, fine] = [Resolution::FAST, Resolution::FINE]
            .map(|resolution| exact(ratio, poisson, resolution));
        for k in 0..30 {
            let t = f64::from(k) + ratio;
            let case = [3.0 * (1.3 * t).sin(), 3.0 * (2.1 * t).cos(), 8.0 * (0.7 * t).sin()];
            inside += covered(&solve(&fast, case), &solve(&fine, case));
            all += 3;
        }
    }
    assert!(inside * 100 >= all * 95, "{inside} of {all}");
}

/// The same at the standard resolution on contacts longer than those that bars were made for, from slight
/// creepage to full sliding.
#[test]
fn the_error_bar_holds_on_long_contacts() {
    let (mut inside, mut all) = (0, 0);
    for (ratio, poisson) in [(12.0, 0.3), (20.0, 0.1), (35.0, 0.45)] {
        let [standard, fine] = [Resolution::STANDARD, Resolution::FINE]
            .map(|resolution| exact(ratio, poisson, resolution));
        // About where half of such a contact slides.
        let (creepage, spin) = (0.3 / ratio, 4.0 / ratio.powf(1.6));
        for k in 0..16 {
            let t = f64::from(k) + ratio;
            let [x, y] = [(1.3 * t).sin(), (2.1 * t).cos()].map(|part| creepage * part);
            let case = [x, y, 2.0 * spin * (0.7 * t).sin()];
            inside += covered(&solve(&standard, case), &solve(&fine, case));
            all += 3;
        }
    }
    assert!(inside * 100 >= all * 95, "{inside} of {all}");
}

/// The values of a grid and of one with twice the elements agree within both their bars.
#[test]
fn refined_values_agree_within_their_bars() {
    let (mut inside, mut all) = (0, 0);
    for (ratio, poisson) in [(0.25, 0.4), (0.7, 0.0), (1.0, 0.28), (2.2, 0.15), (5.0, 0.28)] {
        let [coarse, fine] = [(12, 10), (24, 20)]
            .map(|(along, across)| exact(ratio, poisson, Resolution::new(along, across).unwrap()));
        for k in 0..24 {
            let t = f64::from(k) - ratio;
            let case = [3.0 * (1.9 * t).cos(), 3.0 * (1.1 * t).sin(), 8.0 * (2.3 * t).sin()];
            let [one, two] = [&coarse, &fine].map(|theory| solve(theory, case));
            let bars = components(one.error).into_iter().zip(components(two.error));
            let values = components(one.force).into_iter().zip(components(two.force));
            for ((one, two), (bar, bar_two)) in values.zip(bars) {
                all += 1;
                inside += usize::from((one - two).abs() <= bar + bar_two);
            }
        }
    }
    assert!(inside * 100 >= all * 95, "{inside} of {all}");
}

#[test]
fn automatic_refines_until_the_bar_is_small() {
    let theory = Automatic::new(&contact(1.0, 0.28), 0.004).unwrap();
    for case in [[3.0, 0.0, 0.0], [0.5, 0.5, 1.0], [0.0, 0.0, 2.0]] {
        let error = theory.solve(at(case)).error.unwrap();
        assert!(error.fx.max(error.fy) <= 0.004, "{case:?} {error:?}");
    }
}
