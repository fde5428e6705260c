//! Checks of numbers before a theory uses them: range, and the error that names the quantity.

/// A number outside the range in which a theory is defined.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{quantity} = {} is not valid: it must be {valid}", short(*value))]
pub struct InvalidValue {
    /// The quantity's name, as in the function's signature.
    pub quantity: &'static str,
    /// The value that was given.
    pub value: f64,
    /// What the value must be, in words that follow "it must be".
    pub valid: &'static str,
}

/// A number as a person writes it: without hundreds of digits.
fn short(value: f64) -> String {
    let plain = !value.is_finite() || value == 0.0 || (1e-5..1e16).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
}

pub(crate) fn require(
    condition: bool,
    quantity: &'static str,
    value: f64,
    valid: &'static str,
) -> Result<f64, InvalidValue> {
    if condition { Ok(value) } else { Err(InvalidValue { quantity, value, valid }) }
}

pub(crate) fn positive(quantity: &'static str, value: f64) -> Result<f64, InvalidValue> {
    require(value.is_finite() && value > 0.0, quantity, value, "finite and greater than zero")
}

pub(crate) fn finite(quantity: &'static str, value: f64) -> Result<f64, InvalidValue> {
    require(value.is_finite(), quantity, value, "a finite number")
}

/// A ratio of semi-axes within a range.
pub(crate) fn ratio(
    value: f64,
    [low, high]: [f64; 2],
    valid: &'static str,
) -> Result<f64, InvalidValue> {
    require((low..=high).contains(&value), "a_over_b", value, valid)
}

pub(crate) fn poisson(value: f64) -> Result<f64, InvalidValue> {
    require((0.0..=0.5).contains(&value), "poisson", value, "between 0 and 0.5")
}
