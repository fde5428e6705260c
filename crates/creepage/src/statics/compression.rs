//! Compression of two unlike bodies of revolution with friction, load step by load step.
//!
//! Pressure alone would move the surfaces against each other (2.11a,b); friction resists, and acts back
//! on the pressure (2.15c). All is symmetric about the axis. With `beta = kappa/(1 - sigma)`, pressure
//! `p` and radial traction `q` on the lower body, the displacement differences are
//!
//! ```math
//! \begin{aligned}
//! w &= \frac{2 (1 - \sigma)}{G} \left[ \iint J_0(kr) J_0(kr') \, p \, r' dr' dk
//!   - \beta \int_r^a q \, dr' \right] \\
//! u_r &= \frac{2 (1 - \sigma)}{G} \left[ \iint J_1(kr) J_1(kr') \, q \, r' dr' dk
//!   - \frac{\beta}{r} \int_0^r p \, r' dr' \right]
//! \end{aligned}
//! ```
//!
//! On rings `p` and `q/r` are constant; the integrals are complete elliptic ones.
//!
//! D. A. Spence, The Hertz contact problem with finite friction, J. Elasticity 5 (1975) 297-319.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use crate::check::{self, InvalidValue};
use crate::numerics::largest_magnitude;
use crate::solid::SolidPair;
use crate::special::CompleteIntegrals;
use crate::theory::{Region, Status};

/// Two bodies of revolution, pressed together step by step.
///
/// ```
/// use creepage::statics::Compression;
/// use creepage::{Solid, SolidPair};
/// // A rubber ball on steel: friction keeps the middle from spreading.
/// let pair = SolidPair::new(Solid::new(82e9, 0.28)?, Solid::new(1e6, 0.3)?);
/// let mut ball = Compression::new(pair, 0.1, 0.2, 5e-3, 30)?;
/// for step in 1..=30 {
///     ball.press((f64::from(step) / 30.0).powi(2) * 2.5e-4)?;
/// }
/// assert!(ball.stick_radius() > 0.0 && ball.stick_radius() < ball.contact_radius());
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Compression {
    /// `2 (1 - sigma)/G` (1/Pa).
    compliance: f64,
    curvature_radius: f64,
    friction: f64,
    /// Inner radii of the rings, and the outer one of the last (m).
    radii: Vec<f64>,
    /// `w` and `u` by `p`, and by `q/r`, over the compliance.
    response: [[DMatrix<f64>; 2]; 2],
    state: State,
}

#[derive(Debug, Clone)]
struct State {
    approach: f64,
    pressures: DVector<f64>,
    /// `q/r`.
    tractions: DVector<f64>,
    /// Radial displacement difference over the compliance.
    displacements: DVector<f64>,
    regions: Vec<Region>,
    status: Status,
}

impl Compression {
    /// Bodies whose undeformed distance is `r^2 / (2 radius)` (m), with `rings` rings out to `reach` (m).
    ///
    /// # Errors
    /// [`InvalidValue`] unless `radius`, `friction` and `reach` are finite and positive, and `rings`
    /// between 4 and 400.
    pub fn new(
        pair: SolidPair,
        radius: f64,
        friction: f64,
        reach: f64,
        rings: usize,
    ) -> Result<Self, InvalidValue> {
        check::positive("radius", radius)?;
        check::positive("friction", friction)?;
        check::positive("reach", reach)?;
        let valid = "between 4 and 400";
        check::require((4..=400).contains(&rings), "rings", rings as f64, valid)?;
        let radii: Vec<f64> = (0..=rings).map(|i| reach * i as f64 / rings as f64).collect();
        Ok(Self {
            compliance: 2.0 * (1.0 - pair.poisson()) / pair.shear_modulus(),
            curvature_radius: radius,
            friction,
            response: response(&radii, pair.kappa() / (1.0 - pair.poisson())),
            radii,
            state: State {
                approach: 0.0,
                pressures: DVector::zeros(rings),
                tractions: DVector::zeros(rings),
                displacements: DVector::zeros(rings),
                regions: vec![Region::Outside; rings],
                status: Status::Solved,
            },
        })
    }

    /// Bodies under `normal_force` (N) that grew from nothing, with `rings` rings in their contact.
    ///
    /// As load grows by itself all lengths, pressures and tractions grow in proportion, so that the steps go
    /// ring by ring at any scale and the last is brought to the load.
    ///
    /// # Errors
    /// [`InvalidValue`] as [`Compression::new`], unless `normal_force` is finite and positive, and `rings` at
    /// most 300.
    pub fn under_load(
        pair: SolidPair,
        radius: f64,
        friction: f64,
        normal_force: f64,
        rings: usize,
    ) -> Result<Self, InvalidValue> {
        check::positive("normal_force", normal_force)?;
        let valid = "between 4 and 300";
        check::require((4..=300).contains(&rings), "rings", rings as f64, valid)?;
        // Some rings to spare: friction moves the edge by less than one in ten.
        let spare = rings + rings / 10 + 1;
        let ring = check::positive("radius", radius)? / rings as f64;
        let mut grown = Self::new(pair, radius, friction, ring * spare as f64, spare)?;
        for step in 1..=rings {
            grown.press((ring * step as f64).powi(2) / radius)?;
        }
        let scale = (normal_force / grown.load()).cbrt();
        grown.scale(scale);
        Ok(grown)
    }

    /// Makes all lengths so many times larger: loads are its third power.
    fn scale(&mut self, scale: f64) {
        let square = scale * scale;
        self.radii.iter_mut().for_each(|radius| *radius *= scale);
        for [by_pressure, by_traction] in &mut self.response {
            *by_pressure *= scale;
            *by_traction *= square;
        }
        self.state.approach *= square;
        self.state.pressures *= scale;
        self.state.displacements *= square;
    }

    /// Goes to another approach (m), in one step: further or back. Steps should be small, for during a
    /// step slip is taken to have one direction.
    ///
    /// # Errors
    /// [`InvalidValue`] for an approach that is not finite, or that the rings do not reach.
    pub fn press(&mut self, approach: f64) -> Result<(), InvalidValue> {
        const TURNS: usize = 200;
        const TOLERANCE: f64 = 1e-9;
        let reach = self.radii.last().copied().unwrap_or(0.0);
        let valid = "finite and within the reach of the rings";
        let most = reach * reach / self.curvature_radius;
        check::require(approach <= most, "approach", approach, valid)?;
        let before = self.state.displacements.clone();
        self.state.approach = approach;
        self.state.status = Status::NotConverged;
        for _ in 0..TURNS {
            let last = (self.state.pressures.clone(), self.state.tractions.clone());
            self.touch();
            let settled = self.solve_tangential(&before);
            let size = self.state.pressures.amax();
            let change = largest_magnitude((&self.state.pressures - last.0).as_slice())
                + reach * largest_magnitude((&self.state.tractions - last.1).as_slice());
            if change <= TOLERANCE * size {
                if settled {
                    self.state.status = Status::Solved;
                }
                break;
            }
        }
        self.state.displacements = self.displacements();
        Ok(())
    }

    /// Pressures under the present tractions: none pulls, and no ring penetrates.
    fn touch(&mut self) {
        /// Updates of the set of rings that touch.
        const MAX_ACTIVE_SET_STEPS: usize = 100;
        let [by_pressure, by_traction] = &self.response[0];
        let needed = self.depths() - by_traction * &self.state.tractions;
        let mut pressed: Vec<bool> = needed.iter().map(|depth| *depth > 0.0).collect();
        for _ in 0..MAX_ACTIVE_SET_STEPS {
            let rings = positions(&pressed);
            self.state.pressures = on(by_pressure, &rings, &needed);
            let distance = by_pressure * &self.state.pressures - &needed;
            let next: Vec<bool> = (0..pressed.len())
                .map(|i| if pressed[i] { self.state.pressures[i] > 0.0 } else { distance[i] < 0.0 })
                .collect();
            if next == pressed {
                break;
            }
            pressed = next;
        }
        for (region, pressed) in self.state.regions.iter_mut().zip(pressed) {
            *region = match (pressed, *region) {
                (false, _) => Region::Outside,
                (true, Region::Outside) => Region::Adhesion,
                (true, other) => other,
            };
        }
    }

    /// Tractions under the present pressures; whether the areas of adhesion and slip settled.
    fn solve_tangential(&mut self, before: &DVector<f64>) -> bool {
        /// Updates of the areas of adhesion and slip.
        const MAX_ACTIVE_SET_STEPS: usize = 100;
        let [by_pressure, by_traction] = &self.response[1];
        let wanted = before - by_pressure * &self.state.pressures;
        let n = self.state.regions.len();
        let bounds: Vec<f64> = (0..n)
            .map(|i| self.friction * self.state.pressures[i] / middle(&self.radii, i))
            .collect();
        let state = &mut self.state;
        for _ in 0..MAX_ACTIVE_SET_STEPS {
            let sticks: Vec<bool> = state.regions.iter().map(|r| *r == Region::Adhesion).collect();
            let sliding = DVector::from_fn(n, |i, _| {
                let slides = state.regions[i] == Region::Slip;
                if slides { bounds[i].copysign(state.tractions[i]) } else { 0.0 }
            });
            let rest = &wanted - by_traction * &sliding;
            state.tractions = sliding + on(by_traction, &positions(&sticks), &rest);
            let moved = by_traction * &state.tractions - &wanted;
            if !state.change_regions(&moved, &bounds) {
                return true;
            }
        }
        false
    }

    /// Undeformed penetration over the compliance.
    fn depths(&self) -> DVector<f64> {
        let depth = |ring: usize| {
            let gap = 0.5 * self.middle(ring).powi(2) / self.curvature_radius;
            (self.state.approach - gap) / self.compliance
        };
        DVector::from_fn(self.radii.len() - 1, |ring, _| depth(ring))
    }

    fn displacements(&self) -> DVector<f64> {
        let [by_pressure, by_traction] = &self.response[1];
        by_pressure * &self.state.pressures + by_traction * &self.state.tractions
    }

    fn middle(&self, ring: usize) -> f64 {
        middle(&self.radii, ring)
    }

    /// Whether the last step was solved.
    #[must_use]
    pub fn status(&self) -> Status {
        self.state.status
    }

    /// Load (N).
    #[must_use]
    pub fn load(&self) -> f64 {
        let areas =
            self.radii.windows(2).map(|ring| PI * (ring[1] + ring[0]) * (ring[1] - ring[0]));
        areas.zip(&self.state.pressures).map(|(area, p)| area * p).sum()
    }

    /// Pressure and radial traction on the lower body, away from the axis, of each ring (Pa), with its
    /// middle radius (m) and what it does.
    pub fn rings(&self) -> impl Iterator<Item = (f64, [f64; 2], Region)> {
        let state = &self.state;
        (0..state.regions.len()).map(|i| {
            let r = self.middle(i);
            (r, [state.pressures[i], r * state.tractions[i]], state.regions[i])
        })
    }

    /// Approach of the bodies (m).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.state.approach
    }

    /// Radius of both bodies together (m): the undeformed distance is `r^2` over twice this.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.curvature_radius
    }

    /// Coefficient of friction.
    #[must_use]
    pub fn friction(&self) -> f64 {
        self.friction
    }

    /// Pressure, and radial traction on the lower body away from the axis (Pa), of the ring at `radius` (m); zero
    /// outside.
    #[must_use]
    pub fn at(&self, radius: f64) -> [f64; 2] {
        let ring = self.radii.partition_point(|inner| *inner <= radius);
        let state = &self.state;
        match ring.checked_sub(1).filter(|ring| *ring < state.regions.len()) {
            Some(ring) => [state.pressures[ring], radius * state.tractions[ring]],
            None => [0.0; 2],
        }
    }

    /// Outer radius of the pressed rings (m).
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.outer(|region| region != Region::Outside)
    }

    /// Outer radius of the rings that adhere (m).
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        self.outer(|region| region == Region::Adhesion)
    }

    fn outer(&self, of: impl Fn(Region) -> bool) -> f64 {
        let last = self.state.regions.iter().rposition(|region| of(*region));
        last.map_or(0.0, |ring| self.radii[ring + 1])
    }
}

impl State {
    /// What adheres too strongly slides, and what slides against its traction adheres; whether any
    /// does.
    fn change_regions(&mut self, moved: &DVector<f64>, bounds: &[f64]) -> bool {
        let mut changed = false;
        for (i, bound) in bounds.iter().enumerate() {
            let traction = self.tractions[i];
            let next = match self.regions[i] {
                Region::Adhesion if traction.abs() > *bound => Region::Slip,
                // Slip of the upper body over the lower is the negative of the change of u.
                Region::Slip if moved[i] * traction > 0.0 => Region::Adhesion,
                same => same,
            };
            changed |= next != self.regions[i];
            self.regions[i] = next;
        }
        changed
    }
}

fn middle(radii: &[f64], ring: usize) -> f64 {
    f64::midpoint(radii[ring], radii[ring + 1])
}

fn positions(chosen: &[bool]) -> Vec<usize> {
    (0..chosen.len()).filter(|i| chosen[*i]).collect()
}

/// The values on some rings that have the given effect there; zero on the others.
fn on(matrix: &DMatrix<f64>, rings: &[usize], effect: &DVector<f64>) -> DVector<f64> {
    let (n, mut values) = (rings.len(), DVector::zeros(effect.len()));
    if n == 0 {
        return values;
    }
    let part = DMatrix::from_fn(n, n, |i, k| matrix[(rings[i], rings[k])]);
    let right = DVector::from_fn(n, |i, _| effect[rings[i]]);
    if let Some(found) = part.lu().solve(&right) {
        rings.iter().zip(found.iter()).for_each(|(ring, value)| values[*ring] = *value);
    }
    values
}

/// See [`Compression::response`].
fn response(radii: &[f64], beta: f64) -> [[DMatrix<f64>; 2]; 2] {
    let n = radii.len() - 1;
    let ring = |of: fn(f64, f64) -> f64| {
        DMatrix::from_fn(n, n, |i, k| {
            let r = middle(radii, i);
            of(r, radii[k + 1]) - of(r, radii[k])
        })
    };
    let half_square = |from: f64, to: f64| 0.5 * (to * to - from * from).max(0.0);
    let beyond = DMatrix::from_fn(n, n, |i, k| {
        -beta * half_square(radii[k].max(middle(radii, i)), radii[k + 1])
    });
    let within = DMatrix::from_fn(n, n, |i, k| {
        let r = middle(radii, i);
        -beta / r * half_square(radii[k], radii[k + 1].min(r))
    });
    [[ring(by_pressure), beyond], [within, ring(by_shear)]]
}

/// `int J_0(kr) J_1(ks) s/k dk`: normal displacement at `r` by pressure one within `s`.
fn by_pressure(r: f64, s: f64) -> f64 {
    if s == 0.0 {
        return 0.0;
    }
    let m = (r / s).min(s / r).powi(2);
    let CompleteIntegrals { k, e, .. } = CompleteIntegrals::new((1.0 - m).sqrt());
    if r < s { 2.0 / PI * s * e } else { 2.0 / PI * r * (e - (1.0 - m) * k) }
}

/// `int J_1(kr) J_2(ks) s^2/k dk`: radial displacement at `r` by the traction `r` within `s`.
fn by_shear(r: f64, s: f64) -> f64 {
    if s == 0.0 {
        return 0.0;
    }
    let m = (r / s).min(s / r).powi(2);
    let CompleteIntegrals { k, e, .. } = CompleteIntegrals::new((1.0 - m).sqrt());
    if r < s {
        2.0 / (3.0 * PI) * r * s / m * ((2.0 * m - 1.0) * e + (1.0 - m) * k)
    } else {
        2.0 / (3.0 * PI) * r * r * ((2.0 - m) * e - 2.0 * (1.0 - m) * k)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against midpoint sums over a disc of (2.11c) for a radial traction `r`.
    #[test]
    fn rings_have_their_closed_forms() {
        const CELLS: i32 = 1200;
        for (r, s) in [(0.3, 1.0), (1.6, 1.0)] {
            let (mut normal, mut radial) = (0.0, 0.0);
            for (i, j) in (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| (i, j))) {
                let at = |i: i32| s * ((2.0 * f64::from(i) + 1.0) / f64::from(CELLS) - 1.0);
                let ([x, y], step) = ([at(i), at(j)], 2.0 * s / f64::from(CELLS));
                if x.hypot(y) < s {
                    let over = step * step / (x - r).hypot(y) / (2.0 * PI);
                    normal += over;
                    // For radial tractions the kernel is that of Poisson's ratio zero.
                    radial += over * x;
                }
            }
            // Staircases of the rim, and the cell at the singular point.
            assert!((by_pressure(r, s) - normal).abs() < 2e-3, "{r} {normal}");
            assert!((by_shear(r, s) - radial).abs() < 2e-3, "{r} {radial}");
        }
    }
}
