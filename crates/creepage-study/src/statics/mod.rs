//! Problems without rolling: text, JSON, points, picture.

mod build;
mod compression;
mod field;
mod of_case;
mod output;
mod path;
mod picture;
mod quantity;
mod sheared_rectangle;
mod slip_angle;

use creepage::Ellipse;

use crate::Caution;

use field::Field;
use path::Path;
use quantity::Quantity;

/// One solved problem of statics, ready to be shown.
///
/// ```
/// use creepage::statics::Die;
/// use creepage::{Ellipse, Solid};
/// use creepage_study::StaticsReport;
/// let (steel, base) = (Solid::new(82e9, 0.28)?, Ellipse::new(5e-3, 10e-3)?);
/// let die = Die::new(steel, base, 20e3, [1e-3, 0.0])?;
/// let report = StaticsReport::die(steel, base, 20e3, [1e-3, 0.0], &die)?;
/// assert!((report.json()["found"]["indentation_m"].as_f64().unwrap() - 6.02e-6).abs() < 1e-8);
/// println!("{}", report.text());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct StaticsReport<'a> {
    /// The problem's name in a file.
    problem: &'static str,
    title: &'static str,
    ellipse: Ellipse,
    given: Vec<Quantity>,
    found: Vec<Quantity>,
    field: Field<'a>,
    /// A path after each of its steps.
    path: Path<'a>,
    cautions: Vec<Caution>,
}
