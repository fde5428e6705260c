//! Estimate of a solution's cost, told before it begins.

use creepage::coulomb::Resolution;
use creepage::theory::ResolutionSpec;
use creepage::{Contact, TheorySpec};

/// Elements from which on that is told.
const MANY: usize = 4000;
/// Bytes of an element's memory on the finer grid, the coarser one included, over the number of elements
/// across.
const BYTES: f64 = 1500.0;

/// What to say before the full theory solves a contact on very many elements; `None` for less.
#[must_use]
pub fn long_work(theory: &TheorySpec, contact: &Contact) -> Option<String> {
    let TheorySpec::Exact(options) = theory else { return None };
    let ResolutionSpec::Elements([along, across]) = options.resolution else { return None };
    let [along, across] = Resolution::new(along, across).ok()?.elements(contact);
    let count = along * across;
    let gigabytes = BYTES * count as f64 * across as f64 * 1e-9;
    (count > MANY).then(|| {
        format!(
            "{along} x {across} elements on this ellipse take seconds to minutes and some \
             {gigabytes:.1} GB; with slight creepage on a long contact they may not converge"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use creepage::Ellipse;

    #[test]
    fn only_very_many_elements_are_told_of() {
        let contact = Contact::new(Ellipse::from_ratio(6.0).unwrap(), 0.28).unwrap();
        let told =
            |options: &[&str]| long_work(&crate::theory_spec("exact", options).unwrap(), &contact);
        assert_eq!(told(&["resolution = fine"]), None);
        assert_eq!(told(&["resolution = [44, 36]"]), None);
        let words = told(&["resolution = [96, 72]"]).unwrap();
        assert!(words.contains("240 x 42 elements"), "{words}");
    }
}
