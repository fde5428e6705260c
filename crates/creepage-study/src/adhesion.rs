//! How much of elements adheres.

use creepage::coulomb::ElementField;
use creepage_plot::signed_area;

/// Adhesion area over contact area, 0 to 1.
pub(crate) fn share(elements: &[ElementField]) -> f64 {
    let adhering = |element: &ElementField| signed_area(&element.adhering()).abs();
    let whole = |element: &ElementField| signed_area(&element.corners).abs();
    elements.iter().map(adhering).sum::<f64>() / elements.iter().map(whole).sum::<f64>()
}
