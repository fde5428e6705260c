//! Distributions along a roller's length: pressure, load, friction and heat.

use creepage::coulomb::ElementField;
use creepage::normal::{Band, NormalContact, Patch};
use creepage_plot::format::{Scale, quantity};
use creepage_plot::{Axis, Label, Panel, Pen, Point, Sheet, signed_area};

use super::view::OnAreas;
use crate::error::ReportError;
use crate::{AnyCase, Caution, SolvedCase};

const HEADER: [&str; 7] = [
    "y_m",
    "half_width_m",
    "pressure_pa",
    "load_n_per_m",
    "force_x_n_per_m",
    "force_y_n_per_m",
    "frictional_power_per_metre_j_per_m2",
];
/// Places at which the pressure is looked at for its caution, and from which part of the half-length on an end.
const PLACES: u32 = 400;
const END: f64 = 0.5;

/// A roller's length, in which its edges begin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roller {
    /// Its length with its rounded edges (m).
    pub length: f64,
    /// Half the length between them (m).
    pub half_straight: f64,
}

impl Roller {
    /// The peak by an end where it exceeds that of the middle half, and contact on the rounded edges.
    pub(super) fn caution(&self, contact: &NormalContact) -> Option<Caution> {
        let at = |k: u32| self.length * (f64::from(k) / f64::from(PLACES) - 0.5);
        let reach =
            contact.patches().iter().map(Patch::extent).fold([0.0f64; 2], |reach, area| {
                [reach[0].min(area.y[0]), reach[1].max(area.y[1])]
            });
        // The rows of the solution too: an edge's peak is narrower than a place.
        let bands = contact.patches().iter().flat_map(Patch::bands);
        let places = (0..=PLACES).map(at).chain(bands.flat_map(Band::rows));
        let (mut middle, mut end) = (0.0f64, [0.0; 2]);
        for y in places {
            let pressure = contact.pressure(0.0, y);
            if y.abs() < END * 0.5 * self.length {
                middle = middle.max(pressure);
            } else if pressure > end[1] {
                end = [y, pressure];
            }
        }
        let on_edge = reach.iter().any(|y| y.abs() > self.half_straight);
        let [y, peak] = end;
        (on_edge || peak > Caution::EDGE * middle).then_some(Caution::RollerEnd {
            peak,
            middle,
            y,
            on_edge,
        })
    }
}

/// What happens on a row of elements, over its width.
#[derive(Debug, Clone, Copy)]
struct AlongRow {
    y: f64,
    half_width: f64,
    pressure: f64,
    load: f64,
    force: [f64; 2],
    heat: f64,
}

impl OnAreas<'_> {
    fn along(&self) -> Vec<AlongRow> {
        let bands = || self.contact.patches().iter().flat_map(Patch::bands);
        // A peak by an end is narrower than a row of rolling: the rows of the pressure in it, and its middle.
        let pressed: Vec<f64> = bands().flat_map(Band::rows).collect();
        let largest = |y: f64, width: f64| {
            let within = pressed.iter().copied().filter(|at| (at - y).abs() <= 0.5 * width);
            let places = within.chain(std::iter::once(y));
            places.map(|at| self.contact.pressure(0.0, at)).fold(0.0, f64::max)
        };
        let (scaling, load) = (self.scaling, self.contact.load().value);
        let borders = |element: &ElementField| element.corners.map(|[_, y]| y.to_bits());
        let same = |one: &ElementField, two: &ElementField| borders(one) == borders(two);
        let row = |row: &[ElementField]| {
            let [low, high] = [0, 1].map(|k: usize| scaling.length * row[0].corners[k][1]);
            let (y, width) = (low.midpoint(high), (high - low).abs());
            let area = |element: &ElementField| {
                signed_area(&element.corners).abs() * scaling.length * scaling.length
            };
            let sum =
                |value: &dyn Fn(&ElementField) -> f64| row.iter().map(value).sum::<f64>() / width;
            let force = |k: usize| sum(&|one| one.point.traction[k] * scaling.traction * area(one));
            let ends = bands().find_map(|band| band.ends(y));
            AlongRow {
                y,
                half_width: ends.map_or(0.0, |[rear, front]| 0.5 * (front - rear)),
                pressure: largest(y, width),
                load: sum(&|one| one.share * load),
                force: [force(0), force(1)],
                heat: sum(&|one| one.power * scaling.force * scaling.slip),
            }
        };
        let mut along: Vec<AlongRow> = self.elements.chunk_by(same).map(row).collect();
        along.sort_by(|one, two| one.y.total_cmp(&two.y));
        along
    }
}

impl SolvedCase {
    /// `along.csv` and the picture of a roller over its length; `None` for other bodies.
    pub(crate) fn along_roller(&self) -> Option<Result<(Vec<u8>, String), ReportError>> {
        let AnyCase::Gap(case) = &self.case else { return None };
        let (roller, along) = (case.roller?, OnAreas::of(self)?.along());
        Some(csv(&along).map(|table| (table, svg(&roller, &along))))
    }
}

fn csv(along: &[AlongRow]) -> Result<Vec<u8>, ReportError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(HEADER)?;
    for row in along {
        let [x, y] = row.force;
        let numbers = [row.y, row.half_width, row.pressure, row.load, x, y, row.heat];
        writer.write_record(
            numbers.map(
                |value| {
                    if value.is_finite() { format!("{value:e}") } else { String::new() }
                },
            ),
        )?;
    }
    writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
}

/// Its name, its unit, and the number of a row.
type Quantity = (&'static str, &'static str, fn(&AlongRow) -> f64);

fn svg(roller: &Roller, along: &[AlongRow]) -> String {
    let half = 0.5e3 * roller.length;
    let axis = || Axis::new([-half, half], Label::default().symbol("y").plain(" (mm)"));
    let mut sheet = Sheet::new("Along the roller");
    let values: [Quantity; 3] = [
        ("largest pressure", "Pa", |row| row.pressure),
        ("load", "N/m", |row| row.load),
        ("frictional power per metre rolled", "J/m2", |row| row.heat),
    ];
    for (name, unit, value) in values {
        let most = along.iter().map(value).filter(|value| value.is_finite()).fold(0.0, f64::max);
        if most <= 0.0 {
            continue;
        }
        let scale = Scale::of(most, unit, 3);
        let upright = Axis::new(
            [0.0, 1.1 * most / scale.factor],
            Label::new(&format!("{name} ({})", scale.unit)),
        );
        let curve: Vec<Point> =
            along.iter().map(|row| [1e3 * row.y, value(row) / scale.factor]).collect();
        let heading = Label::new("largest ").number(&quantity(most, unit, 3));
        let panel = Panel::new(axis(), upright).height(200.0).heading(heading);
        sheet = sheet.panel(panel.curve(curve, Pen::of(0)));
    }
    sheet.svg()
}
