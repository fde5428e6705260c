//! Richardson extrapolation from two grids, and the error bar of its result.

use super::mesh::fit;
use crate::ellipse::Ellipse;
use crate::{Contact, Creepage, Force};

/// The error of the finer grid falls with the square of the elements' size, so that the
/// difference of two grids of ratio 2 is three times the finer's error.
const BEYOND: f64 = 1.0 / 3.0;
/// By how much less of `fx`, `fy` and `mz` is extrapolated with the pole of strong spin inside: its
/// place among the strips decides on the error of `fx` then, and changes from grid to grid.
const LESS: [f64; 3] = [1.0, 0.05, 0.25];
/// Where the pole goes from inside to outside, by the square of its distance over the ellipse's.
const EDGE: [f64; 2] = [0.64, 1.21];
/// Where spin goes from weak to strong.
const STRONG: [f64; 2] = [1.0, 3.0];

/// A value of a coarser grid and one with twice its elements along and across, extrapolated.
pub(crate) fn extrapolate(coarse: f64, fine: f64) -> f64 {
    fine + BEYOND * (fine - coarse)
}

/// Error bars are this times a scale that falls with the elements' size, for like bodies at 400
/// elements, by which factor more with the pole inside, and for dissimilar ones: of `fx`, `fy` and `mz`.
///
/// Chosen on 300 random cases of like and 300 of dissimilar bodies (a/b .15-6, sigma 0-.5, creepage to 3, spin
/// to 8, kappa/mu .01-3) at the three named resolutions, against 96 x 80 elements, those of dissimilar bodies
/// again on 650 with more elements. Of 1,219 and 800 others (`bench exact -- accuracy`) they cover 95 to 97 and 96
/// to 99 %. Half of them are three to four and five to six times as long as the error; with normal errors of known
/// variance it would be 2.9 times at 95 %.
const LIKE: [f64; 3] = [0.78, 1.55, 0.74];
const POLE: [f64; 3] = [2.2, 1.0, 1.5];
const UNLIKE: [f64; 3] = [8.3, 5.3, 4.7];
/// How many times longer bars are on contacts so long that elements no longer fit the edge, where errors fall
/// more slowly. Chosen on 120 random cases (a/b 6-50) against 52 x 44 elements.
const UNFITTED: [f64; 3] = [1.0, 2.5, 6.0];
/// Power of the number of elements with which bars fall less than the scale, of like bodies, and of
/// dissimilar ones.
const SLOWER: [[f64; 3]; 2] = [[0.1, 0.0, 0.0], [-0.25; 3]];
/// Of `kappa/mu`, where bodies go from like to dissimilar.
const DISSIMILAR: f64 = 0.3;
/// Lower bounds of the error bar, as fractions of the component's own and of the largest difference between the
/// grids: errors may fall more slowly than the extrapolation takes them to.
const MIN_ERROR_FRACTION: [f64; 2] = [0.2, 0.05];
/// Increase of the first of these fractions as creepage vanishes: the traction of adhesion is infinite along
/// the trailing edge, and errors fall more slowly than with the square of the elements' size.
const ADHERING: f64 = 0.6;
/// Least bars of `fx`, `fy` and `mz` at 400 elements as creepage vanishes, of the largest of the force: slip is narrower
/// than an element then on both grids, whose differences tell little. With more elements they fall with the power 3/2.
///
/// Chosen on 200 random cases (a/b .15-6, sigma 0-.5, creepage and spin of any size from .01 to 1) at the three named
/// resolutions, against 72 x 60 elements: without them bars of `mz` covered 74, 80 and 90 %. Of 150 others
/// (`bench exact -- accuracy 150 77 72 60`) they cover 100, 98 and 97 %.
const NARROW: [f64; 3] = [0.7, 0.6, 1.2];
/// Part of the largest such difference that counts for each component: it may agree by chance.
const CHANCE: f64 = 0.05;

/// Richardson factors of the difference between two grids, and the error bar.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extrapolation {
    /// Of `fx`, `fy` and `mz`.
    beyond: [f64; 3],
    /// How strongly the pole of the spin disturbs, from 0 to 1, and its derivatives by `xi`, `eta`
    /// and `chi`.
    pole: [f64; 4],
    /// Factors of the error bars, of like and of dissimilar bodies.
    bars: [[f64; 2]; 3],
    /// Of all error bars, for the length of the contact.
    longer: [f64; 3],
    /// What no force and no moment can err by: twice what friction can have.
    most: [f64; 3],
}

impl Extrapolation {
    /// Without a look at the pole.
    pub(crate) const PLAIN: Self = Self {
        beyond: [BEYOND; 3],
        pole: [0.0; 4],
        bars: [[0.0; 2]; 3],
        longer: [1.0; 3],
        most: [f64::INFINITY; 3],
    };

    /// On an ellipse. Between dissimilar bodies slip turns elsewhere than around the pole.
    pub(crate) fn new(contact: &Contact, creepage: Creepage) -> Self {
        let kappa = contact.kappa_over_mu().abs();
        let like = 1.0 / (1.0 + (kappa / DISSIMILAR).powi(2));
        let pole = pole(contact.ellipse(), creepage).map(|value| like * value);
        let bar = |k: usize| {
            let alike = LIKE[k] * POLE[k].powf(pole[0]) * (1.0 + creepage.chi.abs()).sqrt();
            [like * alike, (1.0 - like) * UNLIKE[k] * (1.0 + kappa).cbrt()]
        };
        let beyond = LESS.map(|less| BEYOND * (1.0 - less * pole[0]));
        let loose = 1.0 - fit(contact.ellipse().ratio());
        let longer = UNFITTED.map(|times| 1.0 + (times - 1.0) * loose);
        let most = [2.0, 2.0, 2.0 * largest_arm(contact.ellipse().ratio())];
        Self { beyond, pole, bars: [0, 1, 2].map(bar), longer, most }
    }

    /// The extrapolated force of a coarser and a finer grid in steady rolling, projected on `|f| <= mu N`: that
    /// cannot increase the error.
    pub(crate) fn force(&self, forces: [Force; 2]) -> Force {
        let force = self.unbounded(forces);
        let size = force.fx.hypot(force.fy).max(1.0);
        Force { fx: force.fx / size, fy: force.fy / size, ..force }
    }

    fn unbounded(&self, [coarse, fine]: [Force; 2]) -> Force {
        combine(coarse, fine, |k, coarse, fine| fine + self.beyond[k] * (fine - coarse))
    }

    /// Error bars of that force: the more the finer grid's force is, and the more it differs from the
    /// coarser's, and the fewer elements the finer has.
    pub(crate) fn error_bar(&self, [coarse, fine]: [Force; 2], elements: usize) -> Force {
        let apart = combine(coarse, fine, |_, coarse, fine| (fine - coarse).abs());
        let (size, most) = (largest(fine), largest(apart));
        let elements = elements as f64;
        let narrow = size * (1.0 - size).max(0.0) * (400.0 / elements).powf(1.5) / 400.0;
        let least = MIN_ERROR_FRACTION[0] + ADHERING * (1.0 - size).max(0.0).powi(4);
        combine(apart, apart, |k, own, _| {
            let scale = (size * (own + CHANCE * most).sqrt()).sqrt() / elements;
            let [alike, unlike] =
                [0, 1].map(|i| self.bars[k][i] * (elements / 400.0).powf(SLOWER[i][k]));
            let from_scale = ((alike + unlike) * scale).max(NARROW[k] * narrow);
            let bar =
                self.longer[k] * from_scale.max(least * own).max(MIN_ERROR_FRACTION[1] * most);
            bar.min(self.most[k])
        })
    }

    /// Its derivatives by `xi`, `eta` and `chi`, from those of both grids.
    pub(crate) fn derivative(&self, forces: [Force; 2], by: [[Force; 3]; 2]) -> [Force; 3] {
        let [coarse, fine] = forces;
        let force = self.unbounded(forces);
        [0, 1, 2].map(|k| {
            let weights = LESS.map(|less| -BEYOND * less * self.pole[k + 1]);
            let by_weights = combine(coarse, fine, |i, coarse, fine| weights[i] * (fine - coarse));
            let own = self.unbounded([by[0][k], by[1][k]]);
            within(force, combine(own, by_weights, |_, own, by_weights| own + by_weights))
        })
    }
}

/// The force of a coarser and of a finer grid, extrapolated: no bound, for the load may change.
pub(crate) fn extrapolate_force([coarse, fine]: [Force; 2]) -> Force {
    combine(coarse, fine, |_, coarse, fine| extrapolate(coarse, fine))
}

/// The change of a force that friction bounds, by that of the force without the bound.
fn within(force: Force, change: Force) -> Force {
    let size = force.fx.hypot(force.fy);
    if size <= 1.0 {
        return change;
    }
    let [x, y] = [force.fx / size, force.fy / size];
    let across = (x * change.fy - y * change.fx) / size;
    Force { fx: -y * across, fy: x * across, ..change }
}

/// How strongly the pole of the spin disturbs, from 0 to 1, and its derivatives by `xi`, `eta` and
/// `chi`.
fn pole(ellipse: Ellipse, Creepage { xi, eta, chi }: Creepage) -> [f64; 4] {
    let (strong, d_strong) = ramp(chi.abs(), STRONG);
    if strong <= 0.0 {
        return [0.0; 4];
    }
    let [p, q] = [eta / (chi * ellipse.a()), xi / (chi * ellipse.b())];
    let distance = p * p + q * q;
    let (outside, d_outside) = ramp(distance, EDGE);
    let by = -strong * d_outside;
    [
        strong * (1.0 - outside),
        by * 2.0 * q / (chi * ellipse.b()),
        by * 2.0 * p / (chi * ellipse.a()),
        d_strong * chi.signum() * (1.0 - outside) - by * 2.0 * distance / chi,
    ]
}

/// A smooth way from 0 to 1 between two places, and its slope.
fn ramp(at: f64, [from, to]: [f64; 2]) -> (f64, f64) {
    let t = ((at - from) / (to - from)).clamp(0.0, 1.0);
    (t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / (to - from))
}

/// Error bars on contacts of any shape.
///
/// Half the difference of the grids, half the largest such difference, for a component may agree
/// by chance, and for the same reason a fraction of the force that falls with the size of elements.
/// Chosen on 96 random contacts and creepages (a/b .15-6, sigma 0-.5, creepage to 3, spin to 8)
/// against a grid of four times the standard one's elements: 99 to 100 % of each component's errors
/// are inside at the fast and at the standard resolution. On 208 random gaps and creepages to 1 (standard)
/// 99.5 to 100 % are, and half of the bars are more than 19 times as long as the error.
pub(crate) fn error_bar(forces: [Force; 2], elements: usize) -> Force {
    bar_with_border(forces, BORDER / elements as f64)
}

/// The arm of friction about the centre that its moment cannot exceed, over `c`: by Cauchy the root of the mean square
/// distance under Hertz's pressure, `(a^2 + b^2) / 5`.
fn largest_arm(a_over_b: f64) -> f64 {
    (0.2 * (a_over_b + a_over_b.recip())).sqrt()
}

/// Part of a force, times the number of elements, that the border of adhesion may hide.
const BORDER: f64 = 0.5;

/// The same of steady rolling on one area.
///
/// The fraction of the force is what it changes by as the border of adhesion moves by a fraction of an element. In
/// Carter's contact, whose force is `1 - (h/a)^2` with an adhesion of half-width `h`, that goes with
/// `h/a = sqrt(1 - f)`, and over strips with no more (Cauchy): where all slides, nothing of it is left. On 300 wheels
/// (`bench coverage -- 150 20261202`) 98.7 and 97.0 % of the longitudinal and lateral errors are inside, and half of the
/// bars are more than 21 and 14 times as long as the error.
pub(crate) fn error_bar_of_one_area(forces: [Force; 2], elements: usize) -> Force {
    let [_, fine] = forces;
    bar_with_border(forces, BORDER / elements as f64 * adhering(fine))
}

/// Adhesion along rolling over the contact's length, as Carter's contact has it under this force.
fn adhering(force: Force) -> f64 {
    (1.0 - force.magnitude()).max(0.0).sqrt()
}

/// What error bars on one area, of a force over `mu N` on so many elements, leave out because its border of adhesion is
/// known: to be added where the force was not found on two grids, but carried from elsewhere.
#[must_use]
pub fn hidden_by_border(force: Force, elements: usize) -> f64 {
    BORDER / elements as f64 * largest(force) * (1.0 - adhering(force))
}

fn bar_with_border([coarse, fine]: [Force; 2], border: f64) -> Force {
    let apart = combine(coarse, fine, |_, coarse, fine| (fine - coarse).abs());
    let common = 0.5 * largest(apart) + border * largest(fine);
    combine(apart, apart, |_, own, _| 0.5 * own + common)
}

fn combine(a: Force, b: Force, by: impl Fn(usize, f64, f64) -> f64) -> Force {
    Force { fx: by(0, a.fx, b.fx), fy: by(1, a.fy, b.fy), mz: by(2, a.mz, b.mz) }
}

fn largest(force: Force) -> f64 {
    force.fx.abs().max(force.fy.abs()).max(force.mz.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Central differences of step 1e-6: their error is of order 1e-9.
    fn assert_derivative_is_that_of(forces: [Force; 2]) {
        let contact = Contact::new(Ellipse::from_ratio(1.7).unwrap(), 0.3).unwrap();
        let at = |[xi, eta, chi]: [f64; 3]| {
            let creepage = Creepage::new(xi, eta, chi).unwrap();
            Extrapolation::new(&contact, creepage)
        };
        for case in [[0.3, -1.9, 2.2], [1.0, 1.0, -1.6], [-0.5, 0.2, 2.9], [0.1, 0.2, 0.9]] {
            let found = at(case).derivative(forces, [[Force::default(); 3]; 2]);
            for k in 0..3 {
                let force = |step: f64| {
                    let mut moved = case;
                    moved[k] += step;
                    at(moved).force(forces).components()
                };
                let ([ahead, behind], found) = ([1e-6, -1e-6].map(force), found[k].components());
                for i in 0..3 {
                    let slope = (ahead[i] - behind[i]) / 2e-6;
                    assert!((slope - found[i]).abs() < 1e-8, "{case:?} {i} {k} {slope} {found:?}");
                }
            }
        }
    }

    const COARSE: Force = Force { fx: 0.1, fy: 0.5, mz: -0.2 };
    const FINE: Force = Force { fx: 0.3, fy: 0.4, mz: 0.1 };

    #[test]
    fn the_derivative_knows_that_the_weights_change() {
        assert_derivative_is_that_of([COARSE, FINE]);
    }

    /// Its direction and its moment are those without the bound, and so are the derivatives of these.
    #[test]
    fn no_force_is_larger_than_friction() {
        let larger = Force { fx: 0.9, ..FINE };
        let force = Extrapolation::PLAIN.force([COARSE, larger]);
        let without = extrapolate_force([COARSE, larger]);
        assert!(without.fx.hypot(without.fy) > 1.1);
        assert!((force.fx.hypot(force.fy) - 1.0).abs() < 1e-15);
        assert!((force.fx * without.fy - force.fy * without.fx).abs() < 1e-15);
        assert!((force.mz - without.mz).abs() < 1e-15);
        assert_derivative_is_that_of([COARSE, larger]);
    }
}
