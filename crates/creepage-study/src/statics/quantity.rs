//! A number with its names and its unit.

use creepage_plot::Label;
use creepage_plot::format::{fixed, quantity, significant};

/// A number with its names and its unit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quantity {
    /// Its key in JSON, which ends in the unit.
    pub(super) key: &'static str,
    /// Its name in the text and in the picture.
    pub(super) name: &'static str,
    /// Letter and index, where the picture has them.
    pub(super) symbol: Option<[&'static str; 2]>,
    pub(super) value: f64,
    pub(super) unit: &'static str,
}

impl Quantity {
    pub(super) fn new(
        key: &'static str,
        name: &'static str,
        value: f64,
        unit: &'static str,
    ) -> Self {
        Self { key, name, symbol: None, value, unit }
    }

    /// The same with a letter and its index.
    pub(super) fn symbol(self, letter: &'static str, index: &'static str) -> Self {
        Self { symbol: Some([letter, index]), ..self }
    }

    /// The number and its unit.
    pub(super) fn written(&self, digits: usize) -> String {
        match self.unit {
            "" => significant(self.value, digits),
            "%" | "deg" => format!("{} {}", fixed(self.value, 2), self.unit),
            unit => quantity(self.value, unit, digits),
        }
    }

    /// `symbol = number unit`, where there is a symbol.
    pub(super) fn equation(&self) -> Option<Label> {
        let [letter, index] = self.symbol?;
        let label = Label::default();
        let label =
            if index.is_empty() { label.symbol(letter) } else { label.indexed(letter, index) };
        Some(label.plain(" = ").number(&self.written(4)))
    }
}
