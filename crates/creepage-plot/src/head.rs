//! Title block above a picture.

use crate::ink::Ink;
use crate::label::Label;
use crate::scene::{Anchor, Scene, Type};
use crate::theme::{DARK, GREY, MARGIN, RED};

/// A title, words at its right, lines of small words below it, and a warning.
#[derive(Debug, Clone, Default)]
pub(crate) struct Head {
    pub(crate) title: String,
    /// The title is not drawn: it stands elsewhere.
    pub(crate) hides_title: bool,
    pub(crate) aside: String,
    pub(crate) notes: Vec<Label>,
    pub(crate) banner: Option<String>,
}

impl Head {
    /// Height of all of it.
    pub(crate) fn height(&self) -> f64 {
        let banner = if self.banner.is_some() { 44.0 } else { 0.0 };
        60.0 - self.shift() + 23.0 * self.notes.len() as f64 + banner
    }

    /// How much higher all is without the title.
    fn shift(&self) -> f64 {
        if self.hides_title { 34.0 } else { 0.0 }
    }

    /// Draws it on a sheet of that width.
    pub(crate) fn draw(&self, scene: &mut Scene, width: f64) {
        let grey = Type::new(16.0, GREY);
        if !self.hides_title {
            scene.text([MARGIN, 42.0], Type::new(21.0, DARK).bold(), &Label::new(&self.title));
        }
        if !self.aside.is_empty() {
            let right = [width - MARGIN, 42.0];
            scene.text(right, grey.anchored(Anchor::End), &Label::new(&self.aside));
        }
        let mut baseline = 46.0 - self.shift();
        for note in &self.notes {
            baseline += 23.0;
            scene.text([MARGIN, baseline], grey, note);
        }
        if let Some(words) = &self.banner {
            let (top, size) = (baseline + 17.0, [width - 2.0 * MARGIN, 32.0]);
            scene.rectangle([MARGIN, top], size, 4.0, Ink::fill("#fdecea").outlined(RED, 1.5));
            let style = Type::new(15.5, RED).bold().anchored(Anchor::Middle);
            scene.text([0.5 * width, top + 21.5], style, &Label::new(words));
        }
    }
}
