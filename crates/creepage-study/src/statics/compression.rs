//! Unlike balls pressed together with friction: their numbers.

use creepage::statics::Compression;
use creepage::{Ellipse, Hertz};

use super::StaticsReport;
use super::build::{pair_numbers, pressed};
use super::field::Field;
use super::path::Path;
use super::quantity::Quantity;
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
        let found = vec![
            Quantity::new("approach_m", "approach", compression.approach(), "m"),
            Quantity::new("contact_radius_m", "contact, radius", edge, "m"),
            Quantity::new("adhesion_radius_m", "adhesion, radius", adhesion, "m"),
            Quantity::new(
                "adhesion_percent",
                "adhesion, share of area",
                100.0 * share * share,
                "%",
            ),
            Quantity::new("peak_pressure_pa", "peak pressure", centre, "Pa"),
            Quantity::new("peak_traction_pa", "peak traction", tractions.fold(0.0, f64::max), "Pa"),
            Quantity::new(
                "approach_without_friction_m",
                "approach without friction",
                contact.approach(),
                "m",
            ),
            Quantity::new(
                "peak_pressure_without_friction_pa",
                "peak pressure without friction",
                contact.peak_pressure(),
                "Pa",
            ),
        ];
        let (given, _) = pressed(contact, compression.friction());
        let radius = vec![
            Quantity::new("radius_m", "radius of both together", compression.radius(), "m")
                .symbol("R", ""),
        ];
        Ok(Self {
            cautions: Vec::new(),
            problem: "compression",
            title: "Unlike balls pressed together with friction",
            ellipse,
            given: [given, radius, pair_numbers(contact.pair())].concat(),
            found,
            field: Field::Compression(compression),
            path: Path::None,
        })
    }
}
