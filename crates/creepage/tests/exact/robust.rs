//! An answer to whatever is asked with sense, a refusal of the rest.

use creepage::coulomb::{Automatic, Exact, Resolution};
use creepage::{Contact, Creepage, Ellipse, Status};
use proptest::prelude::*;

use crate::common::contact;
use crate::support::{components, exact, solve};

#[test]
fn senseless_input_is_refused() {
    for ratio in [1e3, 1e-3] {
        assert!(Exact::new(&contact(ratio, 0.3), Resolution::FAST).is_err());
    }
    for ratio in [f64::NAN, 0.0, -1.0] {
        assert!(Ellipse::from_ratio(ratio).is_err());
    }
    for poisson in [0.6, f64::NAN] {
        assert!(Contact::new(Ellipse::from_ratio(1.0).unwrap(), poisson).is_err());
    }
    assert!(Resolution::new(2, 10).is_err() && Resolution::new(10, 1000).is_err());
    assert!(Resolution::new(200, 200).is_err() && Resolution::new(usize::MAX, 3).is_err());
    assert!(Automatic::new(&contact(1.0, 0.3), 0.0).is_err());
    assert!(Creepage::new(f64::INFINITY, 0.0, 0.0).is_err());
}

/// A long contact with slight spin, on which Newton's method stagnates without many sweeps.
#[test]
fn a_long_contact_with_slight_spin_is_solved() {
    let theory = exact(9.303_062_181_718_207, 0.483_015_682_733_850_4, Resolution::STANDARD);
    let case = [-2.793_671_270_413_084_8e-5, 0.115_676_810_196_619_5, 1.687_957_098_504_991_4e-3];
    assert_eq!(solve(&theory, case).status, Status::Solved);
}

/// No force can err by more than twice what friction can have: nor do error bars, however large the spin.
#[test]
fn error_bars_end_where_friction_does() {
    let theory = exact(1.0, 0.28, Resolution::FAST);
    for spin in [1e4, 1e10, 1e99] {
        let error = components(solve(&theory, [spin, spin, spin]).error);
        // On a circle the arm's root mean square under Hertz's pressure is the root of 2/5.
        let most = [2.0, 2.0, 2.0 * 0.4_f64.sqrt() + 1e-12];
        assert!(error.iter().zip(most).all(|(error, most)| *error <= most), "{spin}: {error:?}");
    }
}

/// Anything from next to nothing to full sliding, of either sign, or none.
fn any_size() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        (-13.8..6.9_f64).prop_map(f64::exp),
        (-13.8..6.9_f64).prop_map(|x| -x.exp())
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Whatever is asked, an answer comes: solved, finite, and no more than full friction.
    #[test]
    fn every_case_is_solved(
        ratio in (-3.9..3.9_f64).prop_map(f64::exp),
        poisson in 0.0..0.5_f64,
        cases in prop::collection::vec([any_size(), any_size(), any_size()], 20),
    ) {
        let theory = exact(ratio, poisson, Resolution::FAST);
        for case in cases {
            let found = solve(&theory, case);
            prop_assert_eq!(found.status, Status::Solved, "{:?}", case);
            prop_assert!(components(found.force).iter().all(|f| f.is_finite()));
            // Rounding.
            prop_assert!(found.force.magnitude() <= 1.0 + 1e-12);
        }
    }
}
