//! What can be reproduced, in the order of the thesis.

use crate::figures::{
    angles, convergence, fig2, fig3, fig3a, fig3b, fig10, fig11, fig13, fig14, fig15, fig16, fig17,
    fig18, fig19, fig20, fig21, fig22, fig23, fig24, islands, judgement,
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
    fig3a::ITEM,
    fig3b::ITEM,
    fig10::ITEM,
    fig11::ITEM,
    fig13::ITEM,
    fig14::ITEM,
    fig15::ITEM,
    fig16::ITEM,
    fig17::ITEM,
    fig18::ITEM,
    fig19::ITEM,
    fig20::ITEM,
    fig21::ITEM,
    fig22::ITEM,
    fig23::ITEM,
    fig24::A,
    fig24::B,
    fig24::C,
    judgement::ITEM,
    islands::ITEM,
    convergence::ITEM,
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
