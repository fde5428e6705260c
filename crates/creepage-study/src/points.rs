//! `points.csv`: the field at the theory's mesh, in SI units.

use creepage::{FieldPoint, Hertz};

use crate::SolvedCase;
use crate::error::ReportError;
use crate::gap::OnAreas;

const HEADER: [&str; 11] = [
    "x_m",
    "y_m",
    "traction_x_pa",
    "traction_y_pa",
    "bound_pa",
    "slip_x",
    "slip_y",
    "region",
    "T",
    "S",
    "frictional_power_per_metre_j_per_m3",
];
/// The last column where the rolling velocity is known.
const WATTS: &str = "frictional_power_w_per_m2";

impl SolvedCase {
    /// The points as CSV; a cell is empty where the number does not exist.
    pub(crate) fn points_csv(&self) -> Result<Vec<u8>, ReportError> {
        if let Some(on_areas) = OnAreas::of(self) {
            return on_areas.field().csv();
        }
        let mut writer = csv::Writer::from_writer(Vec::new());
        let watts = self.case.speed().map(|_| WATTS);
        writer.write_record(HEADER.into_iter().chain(watts))?;
        for point in &self.points() {
            let watts = self.case.speed().map(|speed| cell(speed * self.power_density(point)));
            writer.write_record(self.row(point).into_iter().chain(watts))?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }

    fn row(&self, point: &FieldPoint) -> [String; 11] {
        let scaling = self.scaling();
        let bound = self.bound(point.position);
        let (t, s) = t_and_s(point, bound, self.slip_unit());
        [
            cell(point.position[0] * scaling.length),
            cell(point.position[1] * scaling.length),
            cell(point.traction[0] * scaling.traction),
            cell(point.traction[1] * scaling.traction),
            cell(bound * scaling.traction),
            cell(point.slip[0] * scaling.slip),
            cell(point.slip[1] * scaling.slip),
            point.region.name().into(),
            cell(t),
            cell(s),
            cell(self.power_density(point)),
        ]
    }

    /// The traction bound `mu Z` over its largest value, at a position in units of `c`.
    pub(crate) fn bound(&self, position: [f64; 2]) -> f64 {
        let [a, b] = self.semi_axes();
        let (x, y) = (position[0] / a, position[1] / b);
        (1.0 - x * x - y * y).max(0.0).sqrt()
    }

    /// The theories' unit of slip, `mu c / rho`, in that of (5.6), `mu f00`: the thesis's
    /// `(1 - sigma) E / (2 sqrt g)`.
    fn slip_unit(&self) -> f64 {
        let f00 = |hertz: &Hertz| hertz.peak_pressure() / hertz.pair().shear_modulus();
        let f00 = self.case.hertz().map_or(f64::NAN, f00);
        self.scaling().slip / (self.case.friction() * f00)
    }
}

/// `T = |X' - s/|s||^2` and `S = |s|^2` of (5.6): with `X'` the traction over its bound and `s`
/// the slip in units of `mu f00`. NaN where they do not exist: without slip, or at the edge.
fn t_and_s(point: &FieldPoint, bound: f64, slip_unit: f64) -> (f64, f64) {
    let slip = point.slip.map(|component| component * slip_unit);
    let magnitude = slip[0].hypot(slip[1]);
    let gap = [0, 1].map(|i| point.traction[i] / bound - slip[i] / magnitude);
    let t = gap[0] * gap[0] + gap[1] * gap[1];
    (if t.is_finite() { t } else { f64::NAN }, magnitude * magnitude)
}

/// The shortest text that reads back as the same number.
fn cell(value: f64) -> String {
    if value.is_finite() { format!("{value:e}") } else { String::new() }
}

#[cfg(test)]
mod tests {
    use creepage::Region;

    use super::*;
    use crate::Case;
    use crate::testing::{CURVE, SLIDING, Trial, case, report, solved};

    #[test]
    fn t_and_s_of_a_hand_worked_point() {
        let point = FieldPoint {
            position: [0.0, 0.0],
            traction: [0.3, 0.4],
            slip: [0.0, 0.2],
            region: Region::Slip,
        };
        // X' = (.6, .8), s/|s| = (0, 1): T = .36 + .04; s = (0, .6): S = .36. Rounding only.
        let (t, s) = t_and_s(&point, 0.5, 3.0);
        assert!((t - 0.4).abs() < 1e-15 && (s - 0.36).abs() < 1e-15);
    }

    #[test]
    fn no_slip_and_no_bound_leave_t_empty() {
        let mut point = FieldPoint {
            position: [1.0, 0.0],
            traction: [0.0, 0.0],
            slip: [0.0, 0.0],
            region: Region::Adhesion,
        };
        let (t, s) = t_and_s(&point, 0.5, 1.0);
        assert_eq!((cell(t), cell(s)), (String::new(), "0e0".into()));
        point.slip = [1.0, 0.0];
        assert!(t_and_s(&point, 0.0, 1.0).0.is_nan());
    }

    #[test]
    fn the_rows_are_in_si_units() {
        let report = report(2.25, SLIDING, CURVE);
        let contact = report.case.hertz().unwrap();
        let csv = String::from_utf8(report.points_csv().unwrap()).unwrap();
        let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
        assert_eq!(rows[0], HEADER);
        assert_eq!(rows.len(), 4);
        let row: Vec<f64> = rows[2].iter().map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
        let bound = 0.3 * contact.peak_pressure() * (1.0_f64 - 0.25 - 0.0625).sqrt();
        let unit = 0.3 * 6e-3 / contact.rho();
        let slip = [CURVE[0] - CURVE[2] / 6.0, CURVE[1] + CURVE[2] * 0.75].map(|s| s * unit);
        // (1 - sigma) E / (2 sqrt g), with E from the same ellipse, makes S of the slip.
        let ellipse = contact.ellipse();
        let a = 0.72 * ellipse.integrals().e / (2.0 * ellipse.g().sqrt());
        let s = (slip[0].hypot(slip[1]) / unit * a).powi(2);
        let traction = slip.map(|component| bound * component / slip[0].hypot(slip[1]));
        let [x, y, traction_x, traction_y] = [4.5e-3, 1e-3, traction[0], traction[1]];
        let expected = [x, y, traction_x, traction_y, bound, slip[0], slip[1]];
        for (cell, expected) in row.iter().zip(expected).chain([(&row[9], s)]) {
            // A handful of roundings.
            assert!((cell / expected - 1.0).abs() < 1e-12, "{cell} {expected}");
        }
        assert_eq!(rows[2][7], "slip");
        assert!(row[8] < 1e-25); // sliding exactly along the slip
        let power = traction[0] * slip[0] + traction[1] * slip[1];
        assert!((row[10] / power - 1.0).abs() < 1e-12, "{row:?}");
    }

    #[test]
    fn with_a_speed_the_power_is_in_watts_too() {
        let case = Case { speed: Some(20.0), ..case(1.0, CURVE) };
        let csv = solved(&case, SLIDING).points_csv().unwrap();
        let csv = String::from_utf8(csv).unwrap();
        let mut lines = csv.lines();
        assert!(lines.next().unwrap().ends_with(&format!("{},{WATTS}", HEADER[10])));
        for line in lines {
            let cells: Vec<f64> =
                line.split(',').skip(10).map(|cell| cell.parse().unwrap()).collect();
            // One rounding, and traction times slip of zero at the edge.
            assert!((cells[1] - 20.0 * cells[0]).abs() <= 1e-15 * cells[1], "{line}");
        }
    }

    #[test]
    fn unknown_slip_is_an_empty_cell() {
        let csv = report(1.0, Trial::Sticking, CURVE).points_csv().unwrap();
        let csv = String::from_utf8(csv).unwrap();
        assert!(csv.lines().nth(2).unwrap().ends_with(",,,adhesion,,,"), "{csv}");
    }
}
