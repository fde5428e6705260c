//! The colours of an animation: as many as fit into a byte.

use std::collections::BTreeMap;

use resvg::tiny_skia::{Pixmap, PremultipliedColorU8};

type Colour = [u8; 3];

/// The colour that changes nothing has the number 0.
pub(crate) const UNCHANGED: u8 = 0;
/// Colours beside that one.
const COLOURS: usize = 255;

/// Numbered colours, and the number of every colour met so far.
#[derive(Debug)]
pub(crate) struct Palette {
    colours: Vec<Colour>,
    numbers: BTreeMap<Colour, u8>,
}

impl Palette {
    /// The colours that are the most frequent in some pictures; of equally frequent ones the darkest
    /// first, so that it is the same on every machine.
    pub(crate) fn of(samples: &[Pixmap]) -> Self {
        let mut counts: BTreeMap<Colour, usize> = BTreeMap::new();
        for pixel in samples.iter().flat_map(Pixmap::pixels) {
            *counts.entry(colour(*pixel)).or_default() += 1;
        }
        let mut colours: Vec<_> = counts.into_iter().collect();
        colours.sort_by_key(|(colour, count)| (usize::MAX - count, *colour));
        colours.truncate(COLOURS);
        let colours = colours.into_iter().map(|(colour, _)| colour).collect();
        Self { colours, numbers: BTreeMap::new() }
    }

    /// Red, green and blue of all colours from number 0 on.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        [&[0; 3], self.colours.as_flattened()].concat()
    }

    /// The number of the nearest colour for each pixel.
    pub(crate) fn indices(&mut self, picture: &Pixmap) -> Vec<u8> {
        picture.pixels().iter().map(|pixel| self.number(colour(*pixel))).collect()
    }

    fn number(&mut self, colour: Colour) -> u8 {
        if let Some(number) = self.numbers.get(&colour) {
            return *number;
        }
        let distance = |other: &Colour| -> u32 {
            (0..3).map(|i| u32::from(colour[i].abs_diff(other[i])).pow(2)).sum()
        };
        let all = (1..=u8::MAX).zip(&self.colours);
        let number = all.min_by_key(|(_, other)| distance(other)).map_or(1, |(number, _)| number);
        self.numbers.insert(colour, number);
        number
    }
}

/// On a white sheet nothing is transparent.
fn colour(pixel: PremultipliedColorU8) -> Colour {
    [pixel.red(), pixel.green(), pixel.blue()]
}
