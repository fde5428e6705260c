//! Node of a map: the contacts of a wheel at one place under one load, solved by the full theory in some thirty motions,
//! then two ellipses each.

use creepage::coulomb::{NonHertzian, NonHertzianSolved, Resolution};
use creepage::normal::{self, NormalContact};
use creepage::table::Table;
use creepage::theory::Solved;
use creepage::{SiCreepage, SiForce};
use creepage_map::{Contour, Patch, Sample, Sloped, fit};
use creepage_rail::{Contact, Position};
use creepage_wheelset::{PressedContacts, WheelsetSolver};

use super::MapBuildError;
use super::image::Image;
use crate::case::CaseError;

/// Coefficients of friction at which the spin of pure rolling is sampled.
const FRICTIONS: [f64; 3] = [0.12, 0.3, 0.6];
/// Amplitudes of creepage, in parts of that at which linear theory has all of the friction force, and the
/// number of directions of each.
const AMPLITUDES: [(f64, u32); 4] = [(0.5, 3), (1.2, 3), (2.5, 2), (6.0, 1)];
/// The directions of each coefficient of friction are turned by so much against the last (rad).
const TURN: f64 = 0.35;
/// Amplitude of the three samples near zero, and of those near the spin of pure rolling.
const SLIGHT: [f64; 2] = [0.03, 0.2];
/// A slope counts as the force that it makes at this amplitude.
const SLOPE: f64 = 0.5;
/// Spin (rad/m) below which a contact is sampled as if it had this: a curve needs more than none.
const LEAST_SPIN: f64 = 0.08;
/// Contacts with a smaller part of the wheel's load are left out.
const TRIFLE: f64 = 1e-3;

/// Place of the right-hand image of a wheel, and the builder.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place<'a> {
    pub(super) image: Image<'a>,
    pub(super) y: f64,
    pub(super) roll: f64,
    pub(super) solids: normal::Resolution,
    pub(super) rolling: Resolution,
}

impl Place<'_> {
    /// The contacts under a vertical load (N), from a height nearly there.
    pub(super) fn patches(
        &self,
        solver: &WheelsetSolver<'_>,
        (table, poisson): (&Table, f64),
        [load, height]: [f64; 2],
    ) -> Result<Vec<Patch>, MapBuildError> {
        let pressed = self.under(solver, load, height)?;
        let vertical = vertical(&pressed);
        if vertical <= 0.0 {
            return Err(MapBuildError::NotPressed { y: self.y, load });
        }
        let mut patches = Vec::new();
        for (contact, normal) in &pressed {
            if is_counted(contact, normal, vertical) {
                patches.push(self.patch((contact, normal), vertical, (table, poisson))?);
            }
        }
        // The flattest first: a tread before a flange.
        patches.sort_by(|a, b| a.angle.value.abs().total_cmp(&b.angle.value.abs()));
        Ok(patches)
    }

    /// Geometry of the contacts (share, angle, y, z of [`Patch`]) under a load, in the order of
    /// [`Place::patches`], of which there must be `count`; `height` is that at which the load is met.
    pub(super) fn geometry(
        &self,
        solver: &WheelsetSolver<'_>,
        height: f64,
        count: usize,
    ) -> Result<Option<Vec<[f64; 4]>>, MapBuildError> {
        let Self { y, roll, .. } = *self;
        let position = self.image.track(Position { y, z: height, roll, yaw: 0.0 });
        let pressed = solver.press_at((self.image.side(), position), self.solids, &Vec::new())?;
        let (sense, vertical) = (self.image.sense(), vertical(&pressed));
        let mut all: Vec<[f64; 4]> = pressed
            .iter()
            .filter(|(contact, normal)| is_counted(contact, normal, vertical))
            .map(|(contact, normal)| {
                let [_, y, z] = contact.reference;
                [normal.load().value / vertical, sense * contact.angle, sense * y, z]
            })
            .collect();
        all.sort_by(|a, b| a[1].abs().total_cmp(&b[1].abs()));
        Ok((all.len() == count).then_some(all))
    }

    /// Pressed until the load is met nearly: what is left changes forces in proportion.
    fn under<'a>(
        &self,
        solver: &WheelsetSolver<'a>,
        load: f64,
        height: f64,
    ) -> Result<PressedContacts<'a>, MapBuildError> {
        const ROUNDS: usize = 5;
        const LOAD_TOLERANCE: f64 = 3e-3;
        let rest = self.image.touch([self.y, self.roll, 0.0])?;
        let mut depth = (height - rest).max(1e-6);
        let mut pressed = Vec::new();
        for _ in 0..ROUNDS {
            let Self { y, roll, .. } = *self;
            let position = self.image.track(Position { y, z: rest + depth, roll, yaw: 0.0 });
            pressed = solver.press_at((self.image.side(), position), self.solids, &pressed)?;
            let found = vertical(&pressed);
            if (found / load - 1.0).abs() < LOAD_TOLERANCE {
                break;
            }
            let times = if found > 0.0 { (load / found).cbrt().powi(2) } else { 2.0 };
            depth *= times.clamp(0.5, 2.0);
        }
        Ok(pressed)
    }

    fn patch(
        &self,
        (contact, normal): (&Contact<'_>, &NormalContact),
        vertical: f64,
        (table, poisson): (&Table, f64),
    ) -> Result<Patch, MapBuildError> {
        let sense = self.image.sense();
        // Friction of one: force over `mu N` depends on creepage over `mu` alone.
        let theory = NonHertzian::new(normal, 1.0, self.rolling);
        let theory =
            theory.map_err(CaseError::invalid("contact")).map_err(MapBuildError::from_case)?;
        let scaling = theory.scaling();
        let [[back, front], across] = extent(normal);
        let contour = Contour {
            scale: [scaling.slip.recip(), scaling.length / scaling.slip],
            length: front - back,
            across: if sense > 0.0 { across } else { [-across[1], -across[0]] },
        };
        let samples = self.samples(contact, &theory)?;
        let fitted = fit(table, poisson, &samples, &contour)?;
        let [x, s] = normal.centroid();
        let [_, y, z] = contact.reference;
        Ok(Patch {
            share: Sloped::level(normal.load().value / vertical),
            angle: Sloped::level(sense * contact.angle),
            y: Sloped::level(sense * y),
            z: Sloped::level(z),
            approach: contact.approach,
            centroid: [x, sense * s],
            peak_pressure: normal.peak_pressure().value,
            area: normal.area().value,
            ellipses: fitted.ellipses,
            residual: fitted.residual,
        })
    }

    /// Answers of the full theory: at each of some spins of pure rolling over friction, spin alone and
    /// creepage in some directions; and near zero.
    fn samples(
        &self,
        contact: &Contact<'_>,
        theory: &NonHertzian,
    ) -> Result<Vec<Sample>, MapBuildError> {
        let scaling = theory.scaling();
        let slight = SLIGHT[0] * scaling.slip;
        let ask =
            |[longitudinal, lateral, spin]: [f64; 3]| SiCreepage { longitudinal, lateral, spin };
        let mut all = Vec::new();
        let mut solved: Option<NonHertzianSolved<'_>> = None;
        // A force at a creepage; one that counts more is met as its difference from the last that counts once.
        let mut sample = |at: [f64; 3], weight: f64| -> Result<(), MapBuildError> {
            let given = scaling.creepage(ask(at)).map_err(CaseError::invalid("motion"));
            let given = given.map_err(MapBuildError::from_case)?;
            match &mut solved {
                Some(solved) => solved.resolve_at(given, |_| [0.0; 2]),
                None => solved = Some(theory.solve(given)),
            }
            if let Some(solved) = &solved {
                let SiForce { longitudinal, lateral, moment } =
                    scaling.si_force(solved.solution().force);
                let over = [longitudinal, lateral, moment].map(|part| part / scaling.force);
                all.push(Sample { weight, ..mirrored(self.image.sense(), at, over) });
            }
            Ok(())
        };
        for axis in 0..3 {
            let mut at = [0.0; 3];
            at[axis] = if axis == 2 { slight / scaling.length } else { slight };
            sample(at, SLOPE / SLIGHT[0])?;
        }
        // Linear theory's slope tells the creepage at which all of the friction force is used.
        let lever = self.image.radius();
        let spin = -contact.angle.sin() / lever;
        let spin = if spin.abs() < LEAST_SPIN { LEAST_SPIN.copysign(spin) } else { spin };
        let full = 0.9 * scaling.slip;
        for (turn, friction) in FRICTIONS.into_iter().enumerate() {
            let spin = spin / friction;
            sample([0.0, 0.0, spin], 1.0)?;
            let unit = full + 0.3 * spin.abs() * scaling.length;
            let near = if turn % 2 == 0 { SLIGHT[1] * unit } else { -SLIGHT[1] * unit };
            sample([near, 0.0, spin], SLOPE / SLIGHT[1])?;
            sample([0.0, near, spin], SLOPE / SLIGHT[1])?;
            for (amplitude, count) in AMPLITUDES {
                for k in 0..count {
                    let angle = TURN * turn as f64
                        + std::f64::consts::TAU * (f64::from(k) + amplitude) / f64::from(count);
                    let (sin, cos) = angle.sin_cos();
                    let size = amplitude * unit;
                    sample([size * cos, size * sin, spin], 1.0)?;
                }
            }
        }
        // Slopes near pure rolling: differences from its own force.
        let mut own: Option<Sample> = None;
        for sample in &mut all {
            let [along, across, _] = sample.creepage;
            let is_slope = sample.weight > 1.0;
            match own {
                Some(own) if is_slope => {
                    sample.from = Some(own.creepage);
                    (0..3).for_each(|k| sample.force[k] -= own.force[k]);
                }
                _ if !is_slope && along == 0.0 && across == 0.0 => own = Some(*sample),
                _ => {}
            }
        }
        Ok(all)
    }
}

/// Whether a contact carries enough of the wheel's load.
fn is_counted(contact: &Contact<'_>, normal: &NormalContact, vertical: f64) -> bool {
    normal.load().value * contact.angle.cos() > TRIFLE * vertical
}

/// A sample of the right-hand image.
fn mirrored(sense: f64, [along, across, spin]: [f64; 3], [fx, fs, mz]: [f64; 3]) -> Sample {
    let creepage = [along, sense * across, sense * spin];
    Sample::new(creepage, [fx, sense * fs, sense * mz])
}

/// Vertical part of the normal forces (N).
pub(super) fn vertical(pressed: &PressedContacts<'_>) -> f64 {
    pressed.iter().map(|(contact, normal)| normal.load().value * contact.angle.cos()).sum()
}

/// Extent of the areas along and across (m), from the reference point.
fn extent(normal: &NormalContact) -> [[f64; 2]; 2] {
    let nothing = [f64::INFINITY, f64::NEG_INFINITY];
    let union = |one: [f64; 2], other: [f64; 2]| [one[0].min(other[0]), one[1].max(other[1])];
    let areas = normal.patches().iter().map(normal::Patch::extent);
    areas.fold([nothing; 2], |[x, s], area| [union(x, area.x), union(s, area.y)])
}
