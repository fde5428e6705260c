//! Table 1: the elliptic integrals `C` and `D`.

use creepage_validation::table1;

use super::entries::{Block, Table};
use crate::error::GalleryError;
use crate::item::{Item, Reproduction};

pub(crate) const ITEM: Item = Item::new("table1", "Table 1. C and D as functions of g", make);

fn make() -> Result<Reproduction, GalleryError> {
    let block = Block { argument: "g", columns: 6, entries: table1()? };
    let table = Table { item: ITEM, key: "g", blocks: vec![block] };
    let caption = "The complete elliptic integrals that chapters 3 and 4 are written in. At g = 0 \
        stand the limits of slender ellipses.";
    Ok(table.reproduction(caption, ""))
}
