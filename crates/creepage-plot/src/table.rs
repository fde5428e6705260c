//! The table at the foot of a picture.

use crate::ink::Ink;
use crate::label::Label;
use crate::scene::{Scene, Type};
use crate::theme::{DARK, GREY, MARGIN, PALE};

/// A cell of a [`Table`].
#[derive(Debug, Clone)]
pub enum Cell {
    /// What a number is, in grey.
    Name(Label),
    /// A number.
    Number(Label),
}

/// Rows of cells between two hairlines.
#[derive(Debug, Clone)]
pub struct Table {
    columns: Vec<f64>,
    rows: Vec<(f64, Vec<Cell>)>,
}

impl Table {
    /// An empty table whose columns start at these places, in units of the sheet from its margin.
    #[must_use]
    pub fn new(columns: &[f64]) -> Self {
        Self { columns: columns.to_vec(), rows: Vec::new() }
    }

    /// Adds a row so far below the one before.
    #[must_use]
    pub fn row(mut self, pitch: f64, cells: Vec<Cell>) -> Self {
        self.rows.push((pitch, cells));
        self
    }

    pub(crate) fn height(&self) -> f64 {
        70.0 + self.rows.iter().map(|(pitch, _)| pitch).sum::<f64>()
    }

    pub(crate) fn draw(&self, scene: &mut Scene, top: f64, width: f64) {
        let mut rule = |y: f64| {
            scene.line(&[[MARGIN, y], [width - MARGIN, y]], Ink::line(PALE, 1.0));
        };
        rule(top + 8.0);
        rule(top + self.height() - 26.0);
        let mut baseline = top + 18.0;
        for (pitch, cells) in &self.rows {
            baseline += pitch;
            for (column, cell) in self.columns.iter().zip(cells) {
                let (style, label) = match cell {
                    Cell::Name(label) => (Type::new(15.0, GREY), label),
                    Cell::Number(label) => (Type::new(15.5, DARK), label),
                };
                scene.text([MARGIN + column, baseline], style, label);
            }
        }
    }
}
