//! A rectangle sheared to and fro: its numbers.

use creepage::statics::ShearedRectangle;
use creepage::{Ellipse, Layer, SolidPair};

use super::StaticsReport;
use super::build::pair_numbers;
use super::field::Field;
use super::path::Path;
use super::quantity::Quantity;
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
        let mut found = vec![
            Quantity::new("force_n", "force in the end", last.force(), "N"),
            Quantity::new("friction_used_percent", "force, share of mu N", used, "%"),
            Quantity::new("traction_pa", "traction in the end", last.traction(), "Pa"),
            Quantity::new("shift_m", "shift in the end", last.shift(), "m"),
            Quantity::new("plastic_displacement_m", "plastic displacement", plastic, "m"),
            Quantity::new("sliding_way_m", "way slid", last.sliding_way(), "m"),
            Quantity::new("dissipated_j", "work turned to heat", last.dissipated(), "J"),
            Quantity::new("stiffness_n_per_m", "stiffness", last.compliance().recip(), "N/m"),
            Quantity::new("approach_m", "approach at the centre", last.approach(), "m"),
        ];
        if let Some(stress) = last.yield_stress() {
            let name = "yield stress in the end";
            found.push(Quantity::new("yield_stress_pa", name, stress, "Pa"));
        }
        let given = given([normal_force, friction], last);
        Ok(Self {
            cautions: Vec::new(),
            problem: "sheared-rectangle",
            title: "Rectangle of uniform pressure, sheared to and fro",
            ellipse,
            given: [given, of_layer(layer), pair_numbers(pair)].concat(),
            found,
            field: Field::Rectangle(last),
            path: Path::Sheared(steps),
        })
    }
}

fn given([normal_force, friction]: [f64; 2], rectangle: &ShearedRectangle) -> Vec<Quantity> {
    let [a, b] = rectangle.half_lengths();
    vec![
        Quantity::new("normal_force_n", "normal force N", normal_force, "N").symbol("N", ""),
        Quantity::new("friction", "friction mu", friction, "").symbol("μ", ""),
        Quantity::new("half_length_rolling_m", "half-length along x", a, "m"),
        Quantity::new("half_length_lateral_m", "half-length along y", b, "m"),
        Quantity::new("pressure_pa", "pressure", rectangle.pressure(), "Pa"),
    ]
}

fn of_layer(layer: Option<Layer>) -> Vec<Quantity> {
    let Some(layer) = layer else { return Vec::new() };
    let (thickness, modulus) = (layer.thickness(), layer.shear_modulus());
    let mut numbers = vec![
        Quantity::new("layer_thickness_m", "layer, thickness", thickness, "m"),
        Quantity::new("layer_shear_modulus_pa", "layer, shear modulus", modulus, "Pa"),
    ];
    if let Some(plasticity) = layer.plasticity() {
        let (stress, slope) = (plasticity.yield_stress, plasticity.slope);
        numbers.push(Quantity::new("layer_yield_stress_pa", "layer, yield stress", stress, "Pa"));
        numbers.push(Quantity::new("layer_slope_pa_per_m", "layer, slope", slope, "Pa/m"));
    }
    numbers
}
