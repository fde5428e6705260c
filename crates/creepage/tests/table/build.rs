//! What can be tabulated, and what is told while it is.

use std::sync::atomic::{AtomicUsize, Ordering};

use creepage::Contact;
use creepage::approximate::linear::Linear;
use creepage::approximate::saturated::Saturated;
use creepage::approximate::vermeulen_johnson::VermeulenJohnson;
use creepage::table::{Axis, BuildError, Spec, build};

use super::fixtures::{Prepared, quiet, spec};

#[test]
fn a_theory_without_a_table_is_refused() {
    let small = spec([4, 4, 4], 10);
    let saturated = |contact: &Contact| -> Prepared { Ok(Box::new(Saturated::new(contact)?)) };
    let error = build(&small, saturated, &quiet).unwrap_err();
    assert!(matches!(error, BuildError::NotLinearAtZero { .. }), "{error}");
    let linear = |contact: &Contact| -> Prepared { Ok(Box::new(Linear::new(contact)?)) };
    let error = build(&small, linear, &quiet).unwrap_err();
    assert!(matches!(error, BuildError::Unbounded { .. }), "{error}");
    let error = build(&Spec { a_over_b: Axis::fixed(-1.0), ..small }, linear, &quiet).unwrap_err();
    assert!(matches!(error, BuildError::Invalid(_)), "{error}");
    for intervals in [[3, 4, 4], [4, 5, 4], [4, 4, 0], [4, 4, 401]] {
        assert!(build(&spec(intervals, 0), linear, &quiet).is_err());
    }
}

/// Vermeulen and Johnson's theory says of itself that it knows no spin.
#[test]
fn nodes_that_the_theory_doubts_are_counted_and_every_step_is_told() {
    let small = spec([4, 4, 4], 10);
    let steps = AtomicUsize::new(0);
    let count = || {
        steps.fetch_add(1, Ordering::Relaxed);
    };
    let law = |contact: &Contact| -> Prepared { Ok(Box::new(VermeulenJohnson::new(contact)?)) };
    let table = build(&small, law, &count).unwrap();
    assert_eq!(steps.into_inner(), small.steps());
    // Of the line of pure spin and three rows of five lines, four nodes each.
    assert_eq!(table.doubtful(), 4 * (1 + 3 * 5));
}
