//! Table 2: the shape of the contact ellipse.

use creepage_validation::table2;

use super::entries::{Block, Table};
use crate::error::GalleryError;
use crate::item::{Item, Reproduction};

pub(crate) const ITEM: Item =
    Item::new("table2", "Table 2. g, |e|, K, E as functions of tau", make);

fn make() -> Result<Reproduction, GalleryError> {
    let block = Block { argument: "tau [deg]", columns: 10, entries: table2()? };
    let table = Table { item: ITEM, key: "tau_deg", blocks: vec![block] };
    let caption = "The ratio of the semi-axes of a Hertz contact by the curvatures of the bodies, \
        (3.48). The thesis took the table from older ones (Love; Jahnke and Emde).";
    Ok(table.reproduction(caption, "computed with 40 digits, (3.48) is satisfied by ours"))
}
