//! Forces of wheels in steps over the distance.

use creepage_plot::{Axis, Label, Panel, Pen, Point, Sheet};

/// Forces on the left and the right rail along x, y, z (N) at distances (m).
pub(super) fn forces(way: &[(f64, [Option<[f64; 3]>; 2])]) -> String {
    let last = way.last().map_or(1.0, |(distance, _)| 1e3 * distance);
    let traces = |axis: usize| {
        [0, 1].map(|side: usize| -> Vec<Point> {
            let point = |(distance, forces): &(f64, [Option<[f64; 3]>; 2])| {
                Some([1e3 * distance, 1e-3 * forces[side]?[axis]])
            };
            way.iter().filter_map(point).collect()
        })
    };
    let sheet = Sheet::new("Forces on the rails over the distance rolled");
    let names = ["longitudinal (kN)", "lateral (kN)", "vertical (kN)"];
    let sheet = names.into_iter().enumerate().fold(sheet, |sheet, (axis, name)| {
        let traces = traces(axis);
        let along = Axis::new([0.0, last], Label::new("distance rolled (mm)"));
        let along = if axis == 2 { along } else { along.shared() };
        let up = Axis::new(range(&traces), Label::new(name));
        let panel = Panel::new(along, up).height(220.0);
        let drawn = traces.into_iter().enumerate().filter(|(_, trace)| !trace.is_empty());
        sheet.panel(drawn.fold(panel, |panel, (side, trace)| panel.curve(trace, Pen::of(side))))
    });
    let is_there = |side: usize| way.iter().any(|(_, forces)| forces[side].is_some());
    ["left", "right"]
        .into_iter()
        .enumerate()
        .filter(|(side, _)| is_there(*side))
        .fold(sheet, |sheet, (side, name)| sheet.key(Pen::of(side), Label::new(name)))
        .svg()
}

/// From zero to what is reached, with some air.
fn range(traces: &[Vec<Point>; 2]) -> [f64; 2] {
    let values = traces.iter().flatten().map(|point| point[1]);
    let [low, high] = values.fold([0.0_f64; 2], |[low, high], y| [low.min(y), high.max(y)]);
    let air = (0.06 * (high - low)).max(1e-3);
    [low - air, high + air]
}
