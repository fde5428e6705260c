//! Parallel reproduction of many items.

use rayon::prelude::*;

use crate::error::GalleryError;
use crate::item::{Item, Reproduction};

/// Item with its reproduction.
#[derive(Debug, Clone)]
pub struct Made {
    /// The table or figure.
    pub item: &'static Item,
    /// Computed again.
    pub reproduction: Reproduction,
}

/// Makes `items` on all cores, in the order given; `done` is called after each.
///
/// The result is the same, bit for bit, on any number of cores.
///
/// # Errors
/// [`GalleryError`] of the first item that fails.
pub fn reproduce(
    items: &[&'static Item],
    done: impl Fn(&Item) + Sync,
) -> Result<Vec<Made>, GalleryError> {
    let make = |item: &&'static Item| {
        let reproduction = item.make()?;
        done(item);
        Ok(Made { item, reproduction })
    };
    items.par_iter().map(make).collect()
}
