//! Fig. 10: the force for large creepage and spin, ellipses.

use super::saturation::{self, Diagram};
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig10", "Fig. 10. Force for large creepage and spin, ellipses", make);

fn make() -> Result<Reproduction, GalleryError> {
    let diagrams = [Diagram::new(0.5)?, Diagram::new(0.2)?];
    let (sheet, data) = saturation::picture(ITEM.title, &diagrams);
    let caption = saturation::caption("(a) g = 0.5, (b) g = 0.2, both with a < b.", &diagrams);
    let agreement = diagrams.iter().map(Diagram::quadrature).collect();
    Ok(Reproduction::figure(&sheet, caption, data, agreement))
}
