//! What can be reproduced, in the order of the thesis.

use crate::figures::fig13;
use crate::item::Item;
use crate::tables::{table1, table2};

const ITEMS: &[Item] = &[table1::ITEM, table2::ITEM, fig13::ITEM];

/// Every table and figure that can be reproduced, in the order of the thesis.
#[must_use]
pub fn registry() -> &'static [Item] {
    ITEMS
}

/// The item of that name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Item> {
    ITEMS.iter().find(|item| item.name == name)
}
