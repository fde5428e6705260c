//! Table 1 of the thesis: the elliptic integrals `C` and `D` as functions of `g`.

use creepage::special::CompleteIntegrals;

use crate::printed::{Entry, Printed, TableError};

/// Stands for the limit of a slender ellipse: what is left out is of the order `g^2 ln g`.
const SLENDER: f64 = 1e-7;

/// Table 1 of Kalker (1967), 22 entries, each beside the value computed by the library.
///
/// # Errors
/// [`TableError`] when the table that the library was built with is damaged.
pub fn table1() -> Result<Vec<Entry>, TableError> {
    let printed = Printed::read(include_str!("../data/table1.csv"))?;
    printed.into_iter().map(entry).collect()
}

fn entry(row: Printed) -> Result<Entry, TableError> {
    let is_limit = !row.split().0.is_empty();
    let g = if is_limit { SLENDER } else { row.argument };
    let integrals = CompleteIntegrals::new(g);
    let value = match &row.quantity[..] {
        "C" => integrals.c,
        "D" => integrals.d,
        _ => return Err(row.meaningless()),
    };
    let growing = if is_limit { (4.0 / g).ln() } else { 0.0 };
    row.against(value - growing)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Verdict;

    #[test]
    fn all_22_entries_are_right() {
        let table = table1().unwrap();
        assert_eq!(table.len(), 22);
        assert!(table.iter().all(|entry| entry.verdict == Verdict::Right), "{table:?}");
    }
}
