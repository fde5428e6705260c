//! Table 2: the shape of the contact ellipse.

use creepage::{Hertz, HertzError, Radii, Solid, SolidPair};

use super::entries::{Block, Table};
use super::printed::{Entry, Row};
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("table2", "Table 2. g, |e|, K, E as functions of tau", make);

fn make() -> Result<Reproduction, GalleryError> {
    let block = Block { argument: "tau [deg]", columns: 10, entries: entries()? };
    let table = Table { item: ITEM, key: "tau_deg", blocks: vec![block] };
    let caption = "The ratio of the semi-axes of a Hertz contact by the curvatures of the bodies, \
        (3.48). The thesis took the table from older ones (Love; Jahnke and Emde).";
    Ok(table.reproduction(caption, "computed with 40 digits, (3.48) is satisfied by ours"))
}

/// Table 2 of Kalker (1967), 40 entries, each beside the value of the contact of two cylinders
/// whose relative curvatures have that `cos tau = |A - B|/(A + B)` (3.48). At `tau = 0` stand the
/// values of the most slender contact that is solved, and the limit of `K`, which grows with it.
fn entries() -> Result<Vec<Entry>, GalleryError> {
    let printed = Row::read(include_str!("../../data/table2.csv"))?;
    printed.into_iter().map(entry).collect()
}

fn entry(row: Row) -> Result<Entry, GalleryError> {
    let is_limit = row.argument == 0.0;
    let ellipse = crossed_cylinders(row.argument)?.ellipse();
    let (g, integrals) = (ellipse.g(), ellipse.integrals());
    let value = match &row.quantity[..] {
        "g" => g,
        "|e|" => ((1.0 - g) * (1.0 + g)).sqrt(),
        "K" if is_limit => f64::INFINITY,
        "K" => integrals.k,
        "E" => integrals.e,
        _ => return Err(row.meaningless()),
    };
    row.against(value)
}

/// Two cylinders across each other, with `A/B = cot^2(tau/2)`; of their material and their load
/// the shape of the contact knows nothing.
fn crossed_cylinders(degrees: f64) -> Result<Hertz, HertzError> {
    let half = 0.5 * degrees.to_radians();
    // A hair below the limit: the radii are rounded.
    let largest = (1.0 - 1e-12) * Hertz::MAX_CURVATURE_RATIO;
    let ratio = half.tan().powi(-2).min(largest);
    let flat = f64::INFINITY;
    let solid = Solid::new(1.0, 0.0)?;
    let upper = Radii { rolling: 1.0, lateral: flat };
    let lower = Radii { rolling: flat, lateral: ratio };
    Hertz::new(SolidPair::new(solid, solid), upper, lower, 0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::printed::Judgement;

    #[test]
    fn the_contact_satisfies_3_48b() {
        for degrees in [1.0, 10.0, 35.0, 60.0, 89.0, 90.0] {
            let ellipse = crossed_cylinders(degrees).unwrap().ellipse();
            let (i, g) = (ellipse.integrals(), ellipse.g());
            let cos = (1.0 - g * g) * (i.d - i.c) / i.e;
            // Rounding: the differences lose a digit or two.
            assert!((cos - degrees.to_radians().cos()).abs() < 1e-13, "{degrees}");
        }
    }

    #[test]
    fn the_wrong_entries_are_those_found_with_40_digits() {
        let table = entries().unwrap();
        assert_eq!(table.len(), 40);
        let wrong: Vec<_> = table
            .iter()
            .filter_map(|entry| match entry.verdict {
                Judgement::Right => None,
                Judgement::Off(units) => Some((&entry.quantity[..], entry.argument, units)),
            })
            .collect();
        let expected = [
            ("g", 60.0, -1),
            ("g", 50.0, -1),
            ("g", 40.0, -1),
            ("g", 20.0, -1),
            ("|e|", 70.0, -5),
            ("|e|", 60.0, -5),
            ("K", 70.0, 1),
            ("K", 60.0, 2),
            ("K", 50.0, 2),
            ("K", 40.0, 1),
            ("K", 30.0, 2),
            ("K", 20.0, 9),
            ("K", 10.0, -5),
            ("E", 60.0, -1),
            ("E", 10.0, 1),
        ];
        assert_eq!(wrong, expected);
    }

    /// `K` at the limit is not computed but grows without bound, as `ln(4/g)`.
    #[test]
    fn k_grows_as_the_ellipse_becomes_slender() {
        let at = |degrees| {
            let ellipse = crossed_cylinders(degrees).unwrap().ellipse();
            (ellipse.integrals().k, (4.0 / ellipse.g()).ln())
        };
        let ((near, near_log), (far, far_log)) = (at(1.0), at(0.04));
        // What is left out is of the order g^2 ln g, below 1e-4 at one degree.
        assert!((near - near_log).abs() < 1e-4 && (far - far_log).abs() < 1e-6 && far > near + 3.0);
    }
}
