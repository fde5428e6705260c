//! `points.csv`: what happens in each element, in SI units.

use creepage::coulomb::ElementField;
use creepage_plot::signed_area;

use super::view::OnAreas;
use crate::error::ReportError;

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

impl OnAreas<'_> {
    /// The elements as CSV: strip by strip, each from the leading edge.
    pub(crate) fn points_csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(HEADER)?;
        for element in self.elements {
            writer.write_record(self.row(element))?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
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
            cell(element.bound * scaling.traction / self.solved.case.friction()),
            cell(area),
            cell(traction_x * slip_x + traction_y * slip_y),
        ]
    }
}

/// The shortest text that reads back as the same number.
fn cell(value: f64) -> String {
    if value.is_finite() { format!("{value:e}") } else { String::new() }
}
