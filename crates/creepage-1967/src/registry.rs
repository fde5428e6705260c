//! Registry of all reproducible items, in the order of the thesis, and then of results that it could not know.

use crate::figures::{
    adhesion_splits, angles, border_jumps, convergence, edge_energy, fig2, fig3, fig3a, fig3b,
    fig4, fig5, fig7, fig9, fig10, fig11, fig12, fig13, fig14, fig15, fig16, fig17, fig18, fig19,
    fig20, fig21, fig22, fig23, fig24, free_rolling, histories, islands, judgement, negative_order,
    pure_spin_ball, sliding_with_kappa, transients, tubes, tubes_in_space, unsteady_chapter_5,
    wide_contact,
};
use crate::item::Item;
use crate::tables::{claims, table1, table2, table3, table4, table5};

const ITEMS: &[Item] = &[
    fig2::ITEM,
    fig3::ITEM,
    fig4::ITEM,
    fig5::ITEM,
    table1::ITEM,
    table2::ITEM,
    fig7::ITEM,
    edge_energy::ITEM,
    table3::ITEM,
    fig3a::ITEM,
    fig3b::ITEM,
    fig9::ITEM,
    fig10::ITEM,
    fig11::ITEM,
    table4::ITEM,
    table5::ITEM,
    fig12::ITEM,
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
    wide_contact::ITEM,
    tubes::ITEM,
    tubes_in_space::ITEM,
    fig24::A,
    fig24::B,
    fig24::C,
    angles::ITEM,
    claims::ITEM,
    unsteady_chapter_5::ITEM,
    histories::ITEM,
    negative_order::ITEM,
    sliding_with_kappa::ITEM,
    free_rolling::ITEM,
    border_jumps::ITEM,
    adhesion_splits::ITEM,
    transients::ITEM,
    pure_spin_ball::ITEM,
    judgement::ITEM,
    islands::ITEM,
    convergence::ITEM,
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
