//! Quantities of a rectangle sheared to and fro.

use creepage::statics::ShearedRectangle;
use creepage::{Ellipse, Layer, SolidPair};

use super::StaticsReport;
use super::build::{found, given, pair_numbers, pressed};
use super::field::Field;
use super::path::Path;
use crate::report::{
    Report,
    Unit::{Joule, Metre, Newton, NewtonPerMetre, Pascal, PascalPerMetre, Percent},
};
use crate::{CaseError, StaticsError};

impl<'a> StaticsReport<'a> {
    /// A rectangle under `[normal_force, friction]`, after each of its `steps`.
    ///
    /// # Errors
    /// [`StaticsError::NoSteps`] for a path without a step.
    pub fn sheared_rectangle(
        pair: SolidPair,
        [normal_force, friction]: [f64; 2],
        layer: Option<Layer>,
        steps: &'a [ShearedRectangle],
    ) -> Result<Self, StaticsError> {
        let last = steps.last().ok_or(StaticsError::NoSteps)?;
        let [a, b] = last.half_lengths();
        let ellipse = Ellipse::new(a, b).map_err(CaseError::invalid("contact"))?;
        let used = 100.0 * last.force().abs() / last.friction_force();
        let plastic = last.plastic_displacement();
        let mut numbers = Report::default();
        rectangle(&mut numbers, [normal_force, friction], last);
        if let Some(layer) = layer {
            of_layer(&mut numbers, layer);
        }
        pair_numbers(&mut numbers, pair);
        found(&mut numbers)
            .number("force", "force in the end", Newton, last.force())
            .number("friction_used", "force, share of mu N", Percent, used)
            .number("traction", "traction in the end", Pascal, last.traction())
            .number("shift", "shift in the end", Metre, last.shift())
            .number("plastic_displacement", "plastic displacement", Metre, plastic)
            .number("sliding_way", "way slid", Metre, last.sliding_way())
            .number("dissipated", "work turned to heat", Joule, last.dissipated())
            .number("stiffness", "stiffness", NewtonPerMetre, last.compliance().recip())
            .number("approach", "approach at the centre", Metre, last.approach());
        if let Some(stress) = last.yield_stress() {
            found(&mut numbers).number("yield_stress", "yield stress in the end", Pascal, stress);
        }
        Ok(Self {
            cautions: Vec::new(),
            problem: "sheared-rectangle",
            title: "Rectangle of uniform pressure, sheared to and fro",
            ellipse,
            numbers,
            field: Field::Rectangle(last),
            path: Path::Sheared(steps),
        })
    }
}

fn rectangle(numbers: &mut Report, [normal_force, friction]: [f64; 2], last: &ShearedRectangle) {
    let [a, b] = last.half_lengths();
    pressed(numbers, normal_force, friction);
    given(numbers)
        .number("half_length_rolling", "half-length along x", Metre, a)
        .number("half_length_lateral", "half-length along y", Metre, b)
        .number("pressure", "pressure", Pascal, last.pressure());
}

fn of_layer(numbers: &mut Report, layer: Layer) {
    let (thickness, modulus) = (layer.thickness(), layer.shear_modulus());
    given(numbers).number("layer_thickness", "layer, thickness", Metre, thickness).number(
        "layer_shear_modulus",
        "layer, shear modulus",
        Pascal,
        modulus,
    );
    if let Some(plasticity) = layer.plasticity() {
        let (stress, slope) = (plasticity.yield_stress, plasticity.slope);
        given(numbers).number("layer_yield_stress", "layer, yield stress", Pascal, stress).number(
            "layer_slope",
            "layer, slope",
            PascalPerMetre,
            slope,
        );
    }
}
