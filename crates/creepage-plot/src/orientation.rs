//! The three axes of a picture from above, and how they are to be looked at.

use crate::format::significant;
use crate::label::Label;
use crate::mark::Ink;
use crate::plane::Plane;
use crate::scene::{Point, Scene, Type};
use crate::theme::{DARK, GREY};

/// Height of the axes and the words for them.
pub(crate) const HEIGHT: f64 = 96.0;

pub(crate) fn draw(scene: &mut Scene, [x, y]: Point, plane: &Plane) {
    let [centre_x, centre_y] = [x + 10.0, y + 14.0];
    scene.arrow([centre_x + 8.0, centre_y], [centre_x + 42.0, centre_y], 1.6, DARK);
    scene.arrow([centre_x, centre_y + 8.0], [centre_x, centre_y + 42.0], 1.6, DARK);
    // An arrow's tail feathers: z points away from the reader.
    scene.circle([centre_x, centre_y], 8.0, Ink::fill("#ffffff").outlined(DARK, 1.6));
    for sign in [-1.0, 1.0] {
        let d = 5.6;
        let ends = [[centre_x - d, centre_y - sign * d], [centre_x + d, centre_y + sign * d]];
        scene.line(&ends, Ink::line(DARK, 1.4));
    }
    for (symbol, at) in [("x", [34.0, -7.0]), ("y", [8.0, 44.0]), ("z", [-6.0, -13.0])] {
        let at = [centre_x + at[0], centre_y + at[1]];
        scene.text(at, Type::new(15.0, DARK), &Label::default().symbol(symbol));
    }
    for (line, label) in words(plane).iter().enumerate() {
        let style = Type::new(13.5, if line < 3 { GREY } else { DARK });
        scene.text([x + 70.0, y + 19.0 + 19.0 * line as f64], style, label);
    }
}

fn words(plane: &Plane) -> Vec<Label> {
    let mut lines = vec![
        Label::new("seen from above:"),
        Label::default().symbol("x").plain(" forward, ").symbol("y").plain(" to the right,"),
        Label::default().symbol("z").plain(" down into the lower body"),
    ];
    if !plane.is_to_scale() {
        let stretch = plane.stretch();
        let (axis, times) = if stretch > 1.0 { ("x", stretch) } else { ("y", stretch.recip()) };
        let label = Label::default().symbol(axis).plain(" enlarged ");
        lines.push(label.number(&significant(times, 3)).plain(" times"));
    }
    lines
}
