//! Fig. 11: the force for large creepage and spin, circle.

use creepage::Force;

use super::saturation::{self, Diagram};
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig11", "Fig. 11. Force for large creepage and spin, circle", make);

fn make() -> Result<Reproduction, GalleryError> {
    let diagram = Diagram::new(1.0)?;
    let (sheet, data) = saturation::picture(ITEM.title, std::slice::from_ref(&diagram));
    let caption = saturation::caption("Circle.", std::slice::from_ref(&diagram));
    let turned = diagram.largest_turn();
    let direction = Comparison::claim(
        "direction of the force for g = 1",
        "always in the direction of the creepage",
        format!("within {turned:.0e}°"),
        // Rounding, of an angle of sixty degrees.
        turned < 1e-9,
    );
    let agreement = vec![direction, diagram.quadrature()];
    let sheet = sheet.columns(2).width(856.0).panel(simpler(&diagram));
    Ok(Reproduction::figure(&sheet, caption, data, agreement))
}

const MOMENT: Pen = Pen { colour: "#8e24aa", dashes: "6 3", width: 2.4 };

/// "So fig. 11 could have a simpler form": force and moment over the distance of the pole.
fn simpler(diagram: &Diagram) -> Panel {
    let distances = spaced(0.0, 3.0, 150);
    let curve = |of: fn(&Force) -> f64| {
        distances.iter().map(|upsilon| [*upsilon, of(&diagram.at(*upsilon, 0.0))]).collect()
    };
    let x = Label::new("distance of the spin pole over ").symbol("c").plain(", ").symbol("υ");
    let y = Label::default()
        .symbol("f")
        .plain(" = ")
        .symbol("F/μN")
        .plain(", ")
        .indexed("m", "z")
        .plain(" = ")
        .indexed("M", "z")
        .symbol("/μNc");
    Panel::new(Axis::new([0.0, 3.0], x), Axis::new([0.0, 1.12], y))
        .named(curve(|force| force.fx), THIRD, Label::default().symbol("f"))
        .named(curve(|force| force.mz), MOMENT, Label::default().indexed("m", "z"))
        .height(saturation::SIDE)
}
