//! What can be reproduced, in the order of the thesis.

use crate::figures::{
    angles, fig2, fig3, fig3a, fig3b, fig4, fig5, fig10, fig11, fig12, fig13, fig14, fig15,
};
use crate::item::Item;
use crate::tables::{table1, table2, table3, table4, table5};

const ITEMS: &[Item] = &[
    table1::ITEM,
    table2::ITEM,
    table3::ITEM,
    table4::ITEM,
    table5::ITEM,
    fig2::ITEM,
    fig3::ITEM,
    fig4::ITEM,
    fig5::ITEM,
    fig3a::ITEM,
    fig3b::ITEM,
    fig10::ITEM,
    fig11::ITEM,
    fig12::ITEM,
    fig13::ITEM,
    fig14::ITEM,
    fig15::ITEM,
    angles::ITEM,
];

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
