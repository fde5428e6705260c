//! Fig. 11: the force for large creepage and spin, circle.

use super::saturation::{self, Diagram};
use crate::comparison::Comparison;
use crate::error::GalleryError;
use crate::item::{Item, Reproduction};

pub(crate) const ITEM: Item =
    Item::new("fig11", "Fig. 11. Force for large creepage and spin, circle", make);

fn make() -> Result<Reproduction, GalleryError> {
    let diagram = Diagram::new(1.0)?;
    let (sheet, data) = saturation::picture(ITEM.title, std::slice::from_ref(&diagram))?;
    let caption = saturation::caption("Circle.", std::slice::from_ref(&diagram));
    let turned = diagram.largest_turn();
    let direction = Comparison::claim(
        "direction of the force for g = 1",
        "always in the direction of the creepage",
        format!("within {turned:.0e}°"),
        // Rounding, of an angle of sixty degrees.
        turned < 1e-9,
    );
    let edge = Comparison::number(
        "f for the pole on the edge, 9π/32",
        "0.88357293",
        diagram.at(1.0, 0.0).fx,
    );
    let mut agreement = vec![direction, edge];
    agreement.push(diagram.quadrature());
    Ok(Reproduction::figure(&sheet, caption, data, agreement))
}
