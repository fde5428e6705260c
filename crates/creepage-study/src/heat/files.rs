//! Temperatures as a table and as a picture.

use creepage_plot::{Axis, Label, Panel, Pen, Sheet};

use super::Heat;
use crate::error::ReportError;

/// Columns of a place in `temperature.csv`: where (m), heat of friction (W/m2), and temperatures.
pub(crate) const PLACE_HEADER: [&str; 5] =
    ["x", "y", "heat", "temperature_upper", "temperature_lower"];
/// The picture reaches so many half-lengths behind the middle of the contact.
const BEHIND: f64 = 5.0;
/// Points of a temperature curve.
const PICTURE_POINTS: u16 = 400;

impl Heat {
    /// `temperature.csv`, `temperature.svg` and `temperature.png`.
    pub(crate) fn files(&self) -> Result<Vec<(&'static str, Vec<u8>)>, ReportError> {
        let mut files = vec![("temperature.csv", self.csv()?)];
        if let Some(svg) = self.svg() {
            let png = creepage_plot::png(&svg)?;
            files.extend([("temperature.svg", svg.into_bytes()), ("temperature.png", png)]);
        }
        Ok(files)
    }

    /// A row for each end and middle of the elements, row by row across, each from the leading edge: place
    /// (m), heat of friction (W/m2), and the temperatures of both surfaces.
    ///
    /// # Errors
    /// [`ReportError`] as of the writer of CSV.
    pub fn csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(PLACE_HEADER)?;
        for record in self.records() {
            writer.write_record(record.map(|number| format!("{number:e}")))?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }

    /// The numbers of [`PLACE_HEADER`].
    pub(crate) fn records(&self) -> impl Iterator<Item = [f64; 5]> + '_ {
        self.rows.iter().enumerate().flat_map(move |(k, row)| {
            row.heat.places().map(move |x| {
                let [upper, lower] = self.temperatures(k, x);
                [x, row.y, row.heat.heat(x), upper, lower]
            })
        })
    }

    /// Temperatures along the hottest row, ahead of, in and behind the contact, as SVG; `None` where nothing
    /// is rubbed.
    #[must_use]
    pub fn svg(&self) -> Option<String> {
        let k = self.hottest_row()?;
        let [from, to] = self.rows[k].heat.ends()?;
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let at = |i: u16| 1.3 - (1.3 + BEHIND) * f64::from(i) / f64::from(PICTURE_POINTS);
        let along: Vec<f64> = (0..=PICTURE_POINTS).map(|i| middle + half * at(i)).collect();
        let temperatures: Vec<[f64; 2]> = along.iter().map(|x| self.temperatures(k, *x)).collect();
        let curve = |body: usize| -> Vec<[f64; 2]> {
            along.iter().zip(&temperatures).map(|(x, pair)| [1e3 * x, pair[body]]).collect()
        };
        let all = temperatures.iter().flatten().copied();
        let [low, high] = all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(value), high.max(value)]
        });
        let margin = 0.05 * (high - low);
        let x = Axis::new(
            [1e3 * (middle - BEHIND * half), 1e3 * (middle + 1.3 * half)],
            Label::default().symbol("x").plain(", mm"),
        );
        let y = Axis::new([low - margin, high + margin], Label::new("temperature, °C"));
        let edge = |x: f64| vec![[1e3 * x, low - margin], [1e3 * x, high + margin]];
        let panel = Panel::new(x, y)
            .curve(edge(from), Pen::GUIDE)
            .curve(edge(to), Pen::GUIDE)
            .curve(curve(0), Pen::of(0))
            .curve(curve(1), Pen::of(1));
        let sheet = Sheet::new("Temperature along the hottest row")
            .key(Pen::of(0), Label::new("upper body"))
            .key(Pen::of(1), Label::new("lower body"));
        Some(sheet.panel(panel).svg())
    }
}
