//! Corrections of the friction law in elements near the spin pole, where slip turns within an element.
//!
//! Around the pole of strong spin rigid slip changes its sign within the width of a strip, and the area
//! that adheres there is narrower than an element. An element that either adhered or slid as a whole would
//! hold the pole to the middle of its strip until it jumps to the next, and the force with it. With the
//! slip `u + g y` across a strip of half-width `h` the mean of its direction is `u / (g h)`, no jump: an
//! element gives way by `g h` times its traction. The elastic slip takes `g` away where elements
//! are small enough to resolve it, so that what gives way falls with the square of the elements' size, as
//! the error of the force does; and no more than elastic slip holds the pole where they are not.

use super::forcing::SlipForcing;

/// The largest slip by which adhesion gives way, over elastic slip, which is of order one. Chosen on 300
/// random cases against 96 x 80 elements, confirmed on 250 others.
const LEFT: f64 = 0.6;

/// Fraction by which strong spin narrows the regularization, and the spin that counts as strong: adhesion at the pole
/// vanishes at once as spin grows, and a wide regularization keeps some. At weak spin its width keeps forces smooth. Chosen on 500 random cases against 96 x 80 elements and 50 lines of creepage.
const NARROWER: [f64; 2] = [0.4, 1.0];

/// The part of the corner's width that is left at a spin, and its derivative.
pub(super) fn corner(spin: f64) -> [f64; 2] {
    let [less, strong] = NARROWER;
    let part = 1.0 / (1.0 + (strong / spin).powi(4));
    let slope = if spin == 0.0 { 0.0 } else { 4.0 * part * (1.0 - part) / spin };
    [1.0 - less * part, -less * slope]
}

/// Sets how adhesion gives way, in parts of each element's weight of slip.
pub(super) fn set_spin_compliance(half_widths: &[f64], weights: &[f64], forcing: &mut SlipForcing) {
    let spin = forcing.spin;
    forcing.compliance.clear();
    forcing.compliance.extend(half_widths.iter().zip(weights).map(|(half_width, weight)| {
        let turned = (spin * half_width).abs();
        let resolved = 1.0 / (1.0 + turned * turned);
        let slip = turned * turned * resolved;
        let slope = 2.0 * half_width * spin.signum() * turned * resolved * resolved;
        [slip, slope].map(|value| LEFT * weight * value)
    }));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Central differences of step 1e-6.
    #[test]
    fn the_corner_is_smooth_at_every_spin() {
        for spin in [0.0, 1e-200, 1e-3, -0.4, 1.0, -1.7, 30.0, 1e100] {
            let [part, slope] = corner(spin);
            let [ahead, behind] = [1e-6, -1e-6].map(|h| corner(spin + h)[0]);
            assert!((0.6..=1.0).contains(&part), "{spin} {part}");
            assert!((slope - (ahead - behind) / 2e-6).abs() < 1e-9, "{spin} {slope}");
        }
    }
}
