//! Quantities of unlike balls pressed together with friction.

use creepage::statics::Compression;
use creepage::{Ellipse, Hertz};

use super::StaticsReport;
use super::build::{found, given, pair_numbers, pressed};
use super::field::Field;
use super::path::Path;
use crate::report::{
    Report,
    Unit::{Metre, Pascal, Percent},
};
use crate::{CaseError, StaticsError};

impl<'a> StaticsReport<'a> {
    /// Unlike bodies of revolution pressed together; `contact` is that without friction, `compression` the solution.
    ///
    /// # Errors
    /// None for a solution under a load.
    pub fn compression(
        contact: &Hertz,
        compression: &'a Compression,
    ) -> Result<Self, StaticsError> {
        let (edge, adhesion) = (compression.contact_radius(), compression.stick_radius());
        let ellipse = Ellipse::new(edge, edge).map_err(CaseError::invalid("contact"))?;
        let tractions = compression.rings().map(|(_, [_, traction], _)| traction.abs());
        let [centre, _] = compression.at(0.0);
        let share = adhesion / edge;
        let mut numbers = Report::default();
        pressed(&mut numbers, contact.normal_force(), compression.friction());
        given(&mut numbers).number(
            "radius",
            "radius of both together",
            Metre,
            compression.radius(),
        );
        pair_numbers(&mut numbers, contact.pair());
        found(&mut numbers)
            .number("approach", "approach", Metre, compression.approach())
            .number("contact_radius", "contact, radius", Metre, edge)
            .number("adhesion_radius", "adhesion, radius", Metre, adhesion)
            .number("adhesion", "adhesion, share of area", Percent, 100.0 * share * share)
            .number("peak_pressure", "peak pressure", Pascal, centre)
            .number("peak_traction", "peak traction", Pascal, tractions.fold(0.0, f64::max))
            .number(
                "approach_without_friction",
                "approach without friction",
                Metre,
                contact.approach(),
            )
            .number(
                "peak_pressure_without_friction",
                "peak pressure without friction",
                Pascal,
                contact.peak_pressure(),
            );
        Ok(Self {
            cautions: Vec::new(),
            problem: "compression",
            title: "Unlike balls pressed together with friction",
            ellipse,
            numbers,
            field: Field::Compression(compression),
            path: Path::None,
        })
    }
}
