//! A case file to be edited.

pub(crate) const WHEEL_ON_RAIL: &str = r#"
[upper]
shear_modulus = 82e9
poisson = 0.28
radius_rolling = 0.46
radius_lateral = "flat"

[lower]
shear_modulus = 82e9
poisson = 0.28
radius_rolling = "flat"
radius_lateral = 0.3

[contact]
normal_force = 80e3
friction = 0.3

[creepage]
longitudinal = -1.5e-3
lateral = 1e-3
spin = 0.2
"#;

/// The file with the first `old` replaced by `new`.
pub(crate) fn edited(old: &str, new: &str) -> String {
    assert!(WHEEL_ON_RAIL.contains(old), "{old} is not in the file");
    WHEEL_ON_RAIL.replacen(old, new, 1)
}
