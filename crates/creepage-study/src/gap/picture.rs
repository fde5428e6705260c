//! The picture of contact areas of any shape, seen from above: pressure in one panel; adhesion,
//! slip and traction in the other.

use std::collections::BTreeMap;

use creepage::SiForce;
use creepage::coulomb::ElementField;
use creepage::normal::{Band, NormalContact, Patch};
use creepage::{Scaling, Status};
use creepage_plot::format::{Scale, fixed, quantity, round_below, significant};
use creepage_plot::theme::ARROW;
use creepage_plot::{Axis, Bands, Contour, Fill, Label, Panel, Pen, Point, Sample, Sheet};

use super::view::OnAreas;
use crate::text::status_words;

/// Millimetres to a metre: the unit of the axes.
const MM: f64 = 1e3;
/// Tractions below this share of their bound are rounding errors, and not drawn.
const NOISE: f64 = 1e-9;
const EDGE: Pen = Pen::OUTLINE;

/// How the areas lie on the sheet.
struct View {
    /// Ranges of x and y (mm).
    range: [[f64; 2]; 2],
    /// Panels side by side.
    columns: usize,
    /// Units of the sheet to a millimetre, along x and y.
    scale: [f64; 2],
    height: f64,
}

impl View {
    /// Width of a frame in a sheet of one or two columns, and the heights that a frame may have.
    const WIDTH: [f64; 2] = [632.0, 285.0];
    const HEIGHT: [f64; 2] = [150.0, 700.0];
    /// White around the areas, over their extent.
    const MARGIN: f64 = 0.08;

    fn new(patches: &[Patch]) -> Self {
        let union = |one: [f64; 2], other: [f64; 2]| [one[0].min(other[0]), one[1].max(other[1])];
        let all = patches
            .iter()
            .map(Patch::extent)
            .fold([[f64::INFINITY, f64::NEG_INFINITY]; 2], |[x, y], extent| {
                [union(x, extent.x), union(y, extent.y)]
            });
        let range = all.map(|[low, high]| {
            let margin = Self::MARGIN * (high - low);
            [MM * (low - margin), MM * (high + margin)]
        });
        let span = range.map(|[low, high]| high - low);
        let columns = if span[1] > 0.8 * span[0] { 2 } else { 1 };
        let width = Self::WIDTH[columns - 1];
        let [least, most] = Self::HEIGHT;
        let height = (width * span[1] / span[0]).clamp(least, most);
        Self { range, columns, scale: [width / span[0], height / span[1]], height }
    }

    /// `x` forward to the right, `y` to the right of that, down the sheet.
    fn panel(&self, heading: &str) -> Panel {
        let [x, [low, high]] = self.range;
        let name = |symbol: &str| Label::default().symbol(symbol).plain(" (mm)");
        let panel = Panel::new(Axis::new(x, name("x")), Axis::new([high, low], name("y")));
        panel.height(self.height).heading(Label::new(heading))
    }

    /// How many times larger `x` is drawn than `y`.
    fn stretch(&self) -> f64 {
        self.scale[0] / self.scale[1]
    }

    fn note(&self) -> Label {
        let label = Label::new("seen from above: ").symbol("x").plain(" forward (rolling), ");
        let label = label.symbol("y").plain(" to the right");
        let stretch = self.stretch();
        if (stretch - 1.0).abs() < 1e-6 {
            return label;
        }
        let (axis, times) = if stretch > 1.0 { ("x", stretch) } else { ("y", stretch.recip()) };
        let label = label.plain("; ").symbol(axis).plain(" enlarged ");
        label.number(&significant(times, 3)).plain(" times")
    }
}

impl OnAreas<'_> {
    /// The contact areas seen from above, as SVG.
    pub(crate) fn contact_svg(&self) -> String {
        let share = self.solved.adhesion_share();
        AreasPicture {
            title: "Rolling contact on areas of any shape",
            contact: self.contact,
            elements: self.elements,
            scaling: self.scaling,
            status: self.solution.status,
            friction: self.solved.case.friction(),
            force: self.solved.force(),
            share,
        }
        .svg()
    }
}

/// Contact areas of any shape, rolled.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AreasPicture<'a> {
    pub(crate) title: &'a str,
    pub(crate) contact: &'a NormalContact,
    pub(crate) elements: &'a [ElementField],
    pub(crate) scaling: Scaling,
    pub(crate) status: Status,
    pub(crate) friction: f64,
    /// On the lower body.
    pub(crate) force: SiForce,
    /// Adhesion area over contact area.
    pub(crate) share: f64,
}

impl<'a> AreasPicture<'a> {
    /// The areas seen from above.
    pub(crate) fn svg(&self) -> String {
        self.sheet().svg()
    }

    fn sheet(&self) -> Sheet {
        let view = View::new(self.contact.patches());
        let mut sheet = Sheet::new(self.title).columns(view.columns);
        if self.status != Status::Solved {
            sheet = sheet.note(Label::new(status_words(self.status)));
        }
        sheet = sheet.note(self.setting()).note(self.result()).note(view.note());
        let bands = self.pressure();
        let pressure = bands.fill(view.panel("pressure"), &self.areas());
        sheet = sheet.panel(self.edges(pressure));
        let regions = self.edges(self.regions(view.panel("adhesion, slip, traction")));
        let (traction, sample) = self.arrows(regions, &view);
        sheet = sheet.panel(traction);
        sheet = bands
            .entries("Pa")
            .into_iter()
            .fold(sheet, |sheet, (fill, name)| sheet.key(fill, name));
        self.key(sheet, sample)
    }

    fn key(&self, sheet: Sheet, sample: Option<(Sample, f64)>) -> Sheet {
        let share = self.share;
        let area =
            |name: &str, share: f64| Label::new(&format!("{name}, {} %", fixed(100.0 * share, 1)));
        let sheet = sheet
            .key(Fill::ADHESION, area("adhesion", share))
            .key(Fill::SLIP, area("slip", 1.0 - share));
        match sample {
            Some((sample, traction)) => {
                let size = quantity(traction, "Pa", 3);
                sheet.key(sample, Label::new("traction ").number(&size))
            }
            None => sheet.key(Sample::Blank, Label::new("no traction")),
        }
    }

    /// Load, friction, area and pressure.
    fn setting(&self) -> Label {
        let gap = "\u{2003}";
        let is = |label: Label, value: &str| label.plain(" = ").number(value);
        let contact = self.contact;
        let load = quantity(contact.load().value, "N", 4);
        let label = is(Label::default().symbol("N"), &load);
        let label = is(label.plain(gap).symbol("μ"), &significant(self.friction, 4));
        let area = format!("{} mm²", significant(MM * MM * contact.area().value, 4));
        let label = label.plain(gap).plain("area ").number(&area);
        let label = label.plain(gap).plain("peak pressure ");
        label.number(&quantity(contact.peak_pressure().value, "Pa", 4))
    }

    /// The force on the lower body.
    fn result(&self) -> Label {
        let newton = Scale::of(self.scaling.force, "N", 4);
        let newton_metre = Scale::of(self.scaling.force * self.scaling.length, "N m", 4);
        let SiForce { longitudinal, lateral, moment } = self.force;
        let is = |label: Label, symbol: &str, index: &str, value: &str| {
            label.plain("\u{2003}").indexed(symbol, index).plain(" = ").number(value)
        };
        let label = is(Label::new("on the lower body"), "F", "x", &newton.write(longitudinal));
        let label = is(label, "F", "y", &newton.write(lateral));
        is(label, "M", "z", &newton_metre.write(moment))
    }

    /// The area of each band.
    fn areas(&self) -> Vec<Vec<Point>> {
        self.bands().map(|band| closed_sides(&sides(band))).collect()
    }

    fn bands(&self) -> impl Iterator<Item = &Band> {
        self.contact.patches().iter().flat_map(Patch::bands)
    }

    /// The two sides of each band; where one goes over into others there is no edge.
    fn edges(&self, panel: Panel) -> Panel {
        self.bands().fold(panel, |panel, band| panel.curves(&sides(band), EDGE))
    }

    fn pressure(&self) -> Bands {
        Bands::up_to(self.contact.peak_pressure().value, |level| {
            self.bands().flat_map(|band| above(band, level)).collect()
        })
    }

    /// What adheres, on a ground of slip.
    fn regions(&self, panel: Panel) -> Panel {
        let all = |element| self.within_band(element, |_| Some([0.0, 1.0]));
        let slip: Vec<Vec<Point>> = self.elements.iter().map(all).collect();
        let part = |element| self.within_band(element, |up| adhering(element, up));
        let adhesion = self.elements.iter().map(part).filter(|polygon| !polygon.is_empty());
        let adhesion: Vec<Vec<Point>> = adhesion.collect();
        // Neighbours leave a hairline between them unless they overlap.
        let seam = |fill: Fill| Pen { colour: fill.colour, dashes: "", width: 0.8 };
        let panel = panel.outlines(&slip, seam(Fill::SLIP)).area(slip, Fill::SLIP);
        panel.outlines(&adhesion, seam(Fill::ADHESION)).area(adhesion, Fill::ADHESION)
    }

    /// An element (mm), or its `part` from the trailing side, 0, to the leading, 1, by how far up it is;
    /// bent along with its band: its own straight sides leave a band that is curved as sharply as near
    /// a blunt tip.
    fn within_band(
        &self,
        element: &ElementField,
        part: impl Fn(f64) -> Option<[f64; 2]>,
    ) -> Vec<Point> {
        const ROWS: u32 = 6;
        let corners = rows(element).map(|row| row.map(|(corner, _)| self.metres(corner)));
        let ends = self.sides_within_band(corners);
        let row = |k: u32| {
            let up = f64::from(k) / f64::from(ROWS);
            let ([y, from, to], part) = (ends(up)?, part(up)?);
            Some(part.map(|part| [MM * (from + part * (to - from)), MM * y]))
        };
        let rows: Vec<[Point; 2]> = (0..=ROWS).filter_map(row).collect();
        let trailing = rows.iter().map(|row| row[0]);
        trailing.chain(rows.iter().rev().map(|row| row[1])).collect()
    }

    fn metres(&self, [x, y]: Point) -> Point {
        [self.scaling.length * x, self.scaling.length * y]
    }

    /// `y` and the sides' `x` of an element with these corners, by how far up it is.
    fn sides_within_band(
        &self,
        [[a, b], [c, d]]: [[Point; 2]; 2],
    ) -> impl Fn(f64) -> Option<[f64; 3]> {
        let between = |from: f64, to: f64, up: f64| from + up * (to - from);
        let [low, high] = [f64::midpoint(a[1], b[1]), f64::midpoint(c[1], d[1])];
        let sides = [f64::midpoint(a[0], c[0]), f64::midpoint(b[0], d[0])];
        let (x, y) = (f64::midpoint(sides[0], sides[1]), f64::midpoint(low, high));
        let ends_here = |band: &Band| band.ends(y).filter(|[from, to]| (*from..=*to).contains(&x));
        let band = self.bands().find_map(|band| Some((band, ends_here(band)?)));
        move |up| {
            let y = between(low, high, up);
            let Some((band, [from, to])) = band else {
                return Some([y, between(a[0], c[0], up), between(b[0], d[0], up)]);
            };
            let [rear, front] = band.ends(y)?;
            let [p, q] = sides.map(|side| ((side - from) / (to - from)).clamp(0.0, 1.0));
            Some([y, between(rear, front, p), between(rear, front, q)])
        }
    }

    /// Tractions as arrows on a lattice over the areas, and a sample of a round traction.
    fn arrows(&self, panel: Panel, view: &View) -> (Panel, Option<(Sample, f64)>) {
        const LENGTH: f64 = 0.92;
        let pitch = self.pitch(view);
        let Some(largest) = self.elements.iter().max_by(|a, b| size(a).total_cmp(&size(b))) else {
            return (panel, None);
        };
        if size(largest) < NOISE {
            return (panel, None);
        }
        let unit = LENGTH * pitch / size(largest);
        let placed = self.placed(view, pitch, largest).into_iter();
        let panel = placed.fold(panel, |panel, (middle, element)| {
            let half = [0, 1].map(|k| 0.5 * unit * element.point.traction[k]);
            let end =
                |sign: f64| [0, 1].map(|k| (pitch * middle[k] + sign * half[k]) / view.scale[k]);
            panel.arrow(end(-1.0), end(1.0), 1.6, ARROW)
        });
        let round = round_below(size(largest) * self.scaling.traction);
        let length = unit * round / self.scaling.traction;
        (panel, Some((Sample::Arrow { colour: ARROW, length }, round)))
    }

    /// Distance between arrows on the sheet: some ninety of them in all.
    fn pitch(&self, view: &View) -> f64 {
        const ARROWS: f64 = 90.0;
        const RANGE: [f64; 2] = [14.0, 40.0];
        let area = MM * MM * self.contact.area().value * view.scale[0] * view.scale[1];
        (area / ARROWS).sqrt().clamp(RANGE[0], RANGE[1])
    }

    /// Elements with the places of their arrows, in pitches of the lattice: that around each node. The largest traction
    /// has its own place where no node lies in its element, and so has an element far from all nodes, as of an area
    /// between two of their lines.
    fn placed(
        &self,
        view: &View,
        pitch: f64,
        largest: &'a ElementField,
    ) -> Vec<(Point, &'a ElementField)> {
        let on_lattice = |place: Point| {
            [0, 1].map(|k| MM * self.scaling.length * place[k] * view.scale[k] / pitch)
        };
        let own_place = |element: &ElementField| on_lattice(element.point.position);
        let mut nodes = BTreeMap::new();
        for element in self.elements {
            for node in nodes_in(element.corners.map(on_lattice)) {
                nodes.entry(node).or_insert((node.map(f64::from), element));
            }
        }
        let alone: Vec<_> =
            self.elements.iter().filter(|one| is_far(own_place(one), &nodes)).collect();
        for element in alone {
            let [cell, place] = [own_place(element).map(f64::round), own_place(element)];
            let off = |place: Point| (place[0] - cell[0]).hypot(place[1] - cell[1]);
            let best = nodes.entry(cell.map(quantized)).or_insert((place, element));
            if off(place) < off(best.0) {
                *best = (place, element);
            }
        }
        if !nodes.values().any(|(_, element)| std::ptr::eq(*element, largest)) {
            let place = own_place(largest);
            nodes.insert(place.map(|at| quantized(at.round())), (place, largest));
        }
        nodes.into_values().collect()
    }
}

/// The size of an element's traction.
fn size(element: &ElementField) -> f64 {
    element.point.traction[0].hypot(element.point.traction[1])
}

/// The nodes, at whole numbers, in a convex quadrangle.
fn nodes_in(corners: [Point; 4]) -> Vec<[i32; 2]> {
    let ends = [0, 1].map(|k| {
        let [low, high] =
            corners.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| {
                [low.min(at[k]), high.max(at[k])]
            });
        quantized(low.ceil())..=quantized(high.floor())
    });
    let is_within = |node: &[i32; 2]| {
        let [x, y] = node.map(f64::from);
        let turns = [0, 1, 2, 3].map(|k: usize| {
            let [[a, b], [c, d]] = [corners[k], corners[(k + 1) % 4]];
            (c - a) * (y - b) - (d - b) * (x - a)
        });
        turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0)
    };
    let [along, across] = ends;
    along.flat_map(|x| across.clone().map(move |y| [x, y])).filter(is_within).collect()
}

/// Whether a place is farther than a pitch from all nodes that have an arrow.
fn is_far(place: Point, nodes: &BTreeMap<[i32; 2], (Point, &ElementField)>) -> bool {
    let [x, y] = place.map(|at| quantized(at.round()));
    let around = |k: i32| [x - 1 + k % 3, y - 1 + k / 3];
    !(0..9).any(|k| nodes.contains_key(&around(k)))
}

#[allow(clippy::cast_possible_truncation)] // a few hundred cells
fn quantized(at: f64) -> i32 {
    at as i32
}

/// The corners of an element with their distances from the border of adhesion: the lower two, then the
/// upper, each from the trailing side.
fn rows(element: &ElementField) -> [[(Point, f64); 2]; 2] {
    let [a, b, c, d] = element.corners;
    let [p, q, r, s] = element.beyond;
    let mut corners = [(a, p), (b, q), (c, r), (d, s)];
    corners.sort_by(|one, other| one.0[1].total_cmp(&other.0[1]));
    let [a, b, c, d] = corners;
    let from_trailing = |one: (Point, f64), other: (Point, f64)| {
        if one.0[0] <= other.0[0] { [one, other] } else { [other, one] }
    };
    [from_trailing(a, b), from_trailing(c, d)]
}

/// The part of an element that adheres, from the trailing side, 0, to the leading, 1, by how far up it is.
fn adhering(element: &ElementField, up: f64) -> Option<[f64; 2]> {
    let [low, high] = rows(element).map(|row| row.map(|(_, beyond)| beyond));
    let [rear, front] = [0, 1].map(|k| low[k] + up * (high[k] - low[k]));
    let border = rear / (rear - front);
    match (rear <= 0.0, front <= 0.0) {
        (true, true) => Some([0.0, 1.0]),
        (true, false) => Some([0.0, border]),
        (false, true) => Some([border, 1.0]),
        (false, false) => None,
    }
}

/// The trailing and the leading side of a band (mm), from low to high y.
fn sides(band: &Band) -> [Vec<Point>; 2] {
    const SIDE_POINTS: u32 = 120;
    let [low, high] = band.y();
    // Closer together towards the ends, where the sides turn.
    let places = (0..=SIDE_POINTS).map(|k| {
        let share =
            0.5 - 0.5 * (std::f64::consts::PI * f64::from(k) / f64::from(SIDE_POINTS)).cos();
        (low + (high - low) * share).clamp(low, high)
    });
    let rows: Vec<_> = places.filter_map(|y| band.ends(y).map(|ends| (y, ends))).collect();
    [0, 1].map(|side: usize| rows.iter().map(|(y, ends)| [MM * ends[side], MM * y]).collect())
}

fn closed_sides([trailing, leading]: &[Vec<Point>; 2]) -> Vec<Point> {
    trailing.iter().chain(leading.iter().rev()).copied().collect()
}

/// The part of a band with a pressure above a level (mm): traced on the unit disc, each line of
/// which goes over into a line of the band.
fn above(band: &Band, level: f64) -> Vec<Vec<Point>> {
    let [low, high] = band.y();
    let at = |[u, v]: Point| {
        let y = (f64::midpoint(low, high) + 0.5 * (high - low) * v).clamp(low, high);
        let [from, to] = band.ends(y).unwrap_or_default();
        let share = u / (1.0 - v * v).max(1e-12).sqrt();
        [f64::midpoint(from, to) + 0.5 * (to - from) * share, y]
    };
    let is_above = |place: &Point| {
        let [x, y] = at(*place);
        band.pressure(x, y) > level
    };
    let contour = Contour::trace(|places| places.iter().map(is_above).collect());
    let millimetres = |place: Point| at(place).map(|metres| MM * metres);
    contour.polygons.into_iter().map(|p| p.into_iter().map(millimetres).collect()).collect()
}
