//! Element field of areas of any shape, in SI units: as CSV, and as VTK for `ParaView` and others that read its legacy format.

use creepage::coulomb::ElementField;
use creepage::{Region, Scaling};
use creepage_plot::signed_area;

use crate::error::ReportError;
use crate::vtk::Vtk;

const HEADER: [&str; 10] = [
    "x_m",
    "y_m",
    "traction_x_pa",
    "traction_y_pa",
    "slip_x",
    "slip_y",
    "region",
    "pressure_pa",
    "area_m2",
    "frictional_power_per_metre_j_per_m3",
];

/// Solved elements of one plane of contact.
pub(crate) struct AreaField<'a> {
    pub(crate) elements: &'a [ElementField],
    pub(crate) scaling: Scaling,
    /// The largest coefficient.
    pub(crate) friction: f64,
    /// The theory's name.
    pub(crate) theory: &'static str,
}

impl AreaField<'_> {
    /// The elements as CSV: strip by strip, each from the leading edge.
    pub(crate) fn csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(HEADER)?;
        for element in self.elements {
            writer.write_record(self.row(element))?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }

    /// The elements with pressure, tractions, areas, and slip and frictional power where the theory
    /// gives them.
    pub(crate) fn vtk(&self) -> String {
        let (elements, scaling) = (self.elements, self.scaling);
        let count = elements.len();
        let mut vtk = Vtk(format!(
            "# vtk DataFile Version 3.0\n\
             creepage {}: theory {}; SI units, on the lower body, x along rolling\n\
             ASCII\nDATASET POLYDATA\nPOINTS {} float\n",
            env!("CARGO_PKG_VERSION"),
            self.theory,
            4 * count,
        ));
        let corners = elements.iter().flat_map(|element| element.corners);
        vtk.rows(corners.map(|[x, y]| [x * scaling.length, y * scaling.length, 0.0]));
        vtk.line(&format!("POLYGONS {count} {}", 5 * count));
        for i in 0..count {
            let first = 4 * i;
            vtk.line(&format!("4 {first} {} {} {}", first + 1, first + 2, first + 3));
        }
        vtk.line(&format!("CELL_DATA {count}"));
        let pressure = scaling.traction / self.friction;
        vtk.scalars("pressure_pa", elements.iter().map(|element| pressure * element.bound));
        let traction =
            |element: &ElementField| element.point.traction.map(|t| t * scaling.traction);
        vtk.vectors("traction_pa", elements.iter().map(traction));
        let sticks =
            |element: &ElementField| f64::from(u8::from(element.point.region == Region::Adhesion));
        vtk.scalars("adhesion", elements.iter().map(sticks));
        if elements.iter().all(|element| element.point.slip.iter().all(|slip| slip.is_finite())) {
            let slip = |element: &ElementField| element.point.slip.map(|s| s * scaling.slip);
            vtk.vectors("slip", elements.iter().map(slip));
            let power = |element: &ElementField| {
                let (traction, slip) = (traction(element), slip(element));
                traction[0] * slip[0] + traction[1] * slip[1]
            };
            vtk.scalars("frictional_power_per_metre_j_per_m3", elements.iter().map(power));
        }
        vtk.0
    }

    fn row(&self, element: &ElementField) -> [String; 10] {
        let (scaling, point) = (self.scaling, element.point);
        let [x, y] = point.position.map(|at| at * scaling.length);
        let [traction_x, traction_y] = point.traction.map(|t| t * scaling.traction);
        let [slip_x, slip_y] = point.slip.map(|slip| slip * scaling.slip);
        let area = signed_area(&element.corners).abs() * scaling.length * scaling.length;
        [
            cell(x),
            cell(y),
            cell(traction_x),
            cell(traction_y),
            cell(slip_x),
            cell(slip_y),
            point.region.name().into(),
            cell(element.bound * scaling.traction / self.friction),
            cell(area),
            cell(traction_x * slip_x + traction_y * slip_y),
        ]
    }
}

/// The shortest text that reads back as the same number.
fn cell(value: f64) -> String {
    if value.is_finite() { format!("{value:e}") } else { String::new() }
}
