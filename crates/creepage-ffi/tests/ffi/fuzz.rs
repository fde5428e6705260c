//! Hostile calls: whatever numbers and words come, a code comes back, and no panic.
//!
//! `CREEPAGE_FUZZ=100 cargo test -p creepage-ffi fuzz` tries a hundred times as many.

use std::env;
use std::ffi::CString;
use std::ptr::null_mut;

use creepage_ffi::*;
use proptest::prelude::*;

fn config(cases: u32) -> ProptestConfig {
    let times = env::var("CREEPAGE_FUZZ").ok().and_then(|times| times.parse().ok()).unwrap_or(1);
    ProptestConfig { cases: cases * times, failure_persistence: None, ..ProptestConfig::default() }
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![any::<f64>(), (-3.0..3.0_f64), (-12.0..12.0_f64).prop_map(|p| 10_f64.powf(p))]
}

#[test]
fn theories_and_creepages() {
    let name = prop_oneof![
        Just("polach".to_owned()),
        Just("linear".to_owned()),
        Just("strip".to_owned()),
        Just("shen-hedrick-elkins".to_owned()),
        "[a-z-]{0,12}",
    ];
    let options = prop_oneof![Just(String::new()), "[a-z]{1,9} = [0-9a-z.]{1,6}"];
    let creepages = proptest::collection::vec(number(), 6);
    let contact = (number(), number(), number());
    proptest!(config(400), |(name in name, options in options, contact in contact, c in creepages)| {
        let (name, options) = (CString::new(name).unwrap(), CString::new(options).unwrap());
        let (mut theory, mut forces, mut statuses) = (null_mut(), [0.0; 6], [0; 2]);
        let (a_over_b, poisson, kappa) = contact;
        // SAFETY: all point to what they should, or to nothing where that is allowed.
        unsafe {
            let (name, options) = (name.as_ptr(), options.as_ptr());
            let made = creepage_theory_new(
                name, options, a_over_b, poisson, kappa, &raw mut theory, null_mut(), 0,
            );
            prop_assert!(made == CREEPAGE_OK || theory.is_null());
            prop_assert!(made != CREEPAGE_DEFECT);
            if made == CREEPAGE_OK {
                let (out, told) = (forces.as_mut_ptr(), statuses.as_mut_ptr());
                let code = creepage_theory_force(
                    theory, 2, c.as_ptr(), out, null_mut(), null_mut(), told, null_mut(), 0,
                );
                creepage_theory_free(theory);
                prop_assert!(code == CREEPAGE_OK || code == CREEPAGE_INVALID);
                prop_assert!(forces.iter().all(|force| force.is_finite()));
            }
        }
    });
}

#[test]
fn bodies_and_loads() {
    let body = || proptest::collection::vec(number(), 4);
    proptest!(config(1000), |(upper in body(), lower in body(), angle in number(), load in number())| {
        let mut contact = [f64::NAN; 9];
        // SAFETY: all point to what they should, or to nothing where that is allowed.
        let code = unsafe {
            let (upper, lower, out) = (upper.as_ptr(), lower.as_ptr(), contact.as_mut_ptr());
            creepage_hertz(upper, lower, angle, load, out, null_mut(), null_mut(), 0)
        };
        prop_assert!(code == CREEPAGE_INVALID || code == CREEPAGE_OK);
        prop_assert!(code != CREEPAGE_OK || contact[..3].iter().all(|number| *number > 0.0));
    });
}
