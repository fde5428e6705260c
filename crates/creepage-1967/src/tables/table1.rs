//! Table 1: the elliptic integrals `C` and `D`.

use creepage::special::CompleteIntegrals;

use super::entries::{Block, Table};
use super::printed::{Entry, Row};
use crate::prelude::*;

pub(crate) const ITEM: Item = Item::new("table1", "Table 1. C and D as functions of g", make);

fn make() -> Result<Reproduction, GalleryError> {
    let block = Block { argument: "g", columns: 6, entries: entries()? };
    let table = Table { item: ITEM, key: "g", blocks: vec![block] };
    let caption = "The complete elliptic integrals of chapters 3 and 4. The row g = 0 has the \
        limits of slender ellipses.";
    Ok(table.reproduction(caption, ""))
}

/// Stands for the limit of a slender ellipse: what is left out is of the order `g^2 ln g`.
const SLENDER: f64 = 1e-7;

/// Table 1 of Kalker (1967), 22 entries, each beside the value computed by the library.
fn entries() -> Result<Vec<Entry>, GalleryError> {
    let printed = Row::read(include_str!("../../data/table1.csv"))?;
    printed.into_iter().map(entry).collect()
}

fn entry(row: Row) -> Result<Entry, GalleryError> {
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
    use crate::tables::printed::Judgement;

    #[test]
    fn all_22_entries_are_right() {
        let table = entries().unwrap();
        assert_eq!(table.len(), 22);
        assert!(table.iter().all(|entry| entry.verdict == Judgement::Right), "{table:?}");
    }
}
