//! Proposition V: a ball between congruent contacts rolls with pure spin.

use creepage::coulomb::{Exact, Resolution};
use creepage::{Contact, Creepage, Ellipse, Hertz, InvalidValue, Radii, Solid, SolidPair, Theory};
use nalgebra::{Matrix3, Vector3};
use rayon::prelude::*;

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("v-pure-spin", "Proposition V. A ball between two races", make);

/// A thrust bearing: ball of 12.7 mm, both raceways plane rings of this mean radius (m).
const BALL: f64 = 6.35e-3;
const PITCH: f64 = 25e-3;
const LOAD: f64 = 200.0;
const FRICTION: f64 = 0.1;
/// Groove radius over the ball's diameter: of the one race, and of the other in turn.
const FIXED: f64 = 0.52;
const OTHERS: [f64; 13] =
    [0.505, 0.51, 0.515, 0.517, 0.5185, 0.5195, 0.52, 0.5205, 0.5215, 0.523, 0.525, 0.53, 0.54];
/// From where the ball's rotation is sought, beside that of pure spin.
const STARTS: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [0.6, -0.4, 0.3], [-0.3, 0.8, -0.5]];

/// The contact with one race.
struct Race {
    theory: Exact,
    /// `mu c / rho`, `mu / rho`, `c`.
    units: [f64; 3],
}

impl Race {
    fn new(conformity: f64) -> Result<Self, GalleryError> {
        let steel = Solid::new(80e9, 0.3)?;
        let ball = Radii { rolling: BALL, lateral: BALL };
        let groove = Radii { rolling: f64::INFINITY, lateral: -2.0 * conformity * BALL };
        let hertz = Hertz::new(SolidPair::new(steel, steel), ball, groove, 0.0, LOAD)?;
        let ratio = hertz.ellipse().a() / hertz.ellipse().b();
        let contact = Contact::new(Ellipse::from_ratio(ratio)?, 0.3)?;
        let c = (hertz.ellipse().a() * hertz.ellipse().b()).sqrt();
        let rho = hertz.rho();
        Ok(Self {
            theory: Exact::new(&contact, Resolution::STANDARD)?,
            units: [FRICTION * c / rho, FRICTION / rho, c],
        })
    }

    /// Forces over `mu N` and moment over `mu N` (m), with their derivatives by creepages and spin (1/m).
    fn forces(
        &self,
        [longitudinal, lateral, spin]: [f64; 3],
    ) -> Result<[[f64; 3]; 4], InvalidValue> {
        let [creep, turn, c] = self.units;
        let at = |x: f64, y: f64, phi: f64| -> Result<[f64; 3], InvalidValue> {
            let creepage = Creepage::new(x / creep, y / creep, phi / turn)?;
            let [fx, fy, mz] = self.theory.solve(creepage).force.components();
            Ok([fx, fy, mz * c])
        };
        let h = 1e-3;
        let here = at(longitudinal, lateral, spin)?;
        let by = |moved: [f64; 3], step: f64| [0, 1, 2].map(|k| (moved[k] - here[k]) / step);
        Ok([
            here,
            by(at(longitudinal + h * creep, lateral, spin)?, h * creep),
            by(at(longitudinal, lateral + h * creep, spin)?, h * creep),
            by(at(longitudinal, lateral, spin + h * turn)?, h * turn),
        ])
    }
}

/// What the ball's rotation adds to that of pure spin in both contacts: creepages and spin (1/m), and how
/// many steps it took.
struct Rotation {
    added: Vector3<f64>,
    residual: f64,
}

/// The rotation about which no moment is left. Each contact in its own frame, which is the other's turned
/// by half a turn about the lateral direction: `(p, q, s + w)` here is `(p, -q, s - w)` there.
fn balanced(races: [&Race; 2], spin: f64, start: [f64; 3]) -> Result<Rotation, InvalidValue> {
    const MAX_NEWTON_STEPS: usize = 40;
    let [creep, turn, _] = races[0].units;
    let mut added = Vector3::from(start).component_mul(&Vector3::new(creep, creep, turn));
    let moments = |added: &Vector3<f64>| -> Result<(Vector3<f64>, Matrix3<f64>), InvalidValue> {
        let [p, q, w] = [added[0], added[1], added[2]];
        let one = races[0].forces([p, q, spin + w])?;
        let two = races[1].forces([p, -q, spin - w])?;
        // About the lateral, the rolling and the normal direction.
        let sign = [1.0, -1.0, -1.0];
        let moment = |k: usize| one[0][k] + sign[k] * two[0][k];
        let slope =
            |k: usize, by: usize| one[1 + by][k] + sign[k] * [1.0, -1.0, -1.0][by] * two[1 + by][k];
        Ok((Vector3::from_fn(|k, _| moment(k)), Matrix3::from_fn(slope)))
    };
    let size = |moment: &Vector3<f64>| {
        Vector3::new(moment[0], moment[1], moment[2] / races[0].units[2]).norm()
    };
    let (mut here, mut slope) = moments(&added)?;
    for _ in 0..MAX_NEWTON_STEPS {
        if size(&here) < 1e-9 {
            break;
        }
        let Some(step) = slope.lu().solve(&(-here)) else { break };
        let mut shorter = 1.0;
        while shorter > 1e-3 {
            let next = added + shorter * step;
            let (there, slope_there) = moments(&next)?;
            if size(&there) < size(&here) {
                (added, here, slope) = (next, there, slope_there);
                break;
            }
            shorter *= 0.5;
        }
        if shorter <= 1e-3 {
            break;
        }
    }
    Ok(Rotation { added, residual: size(&here) })
}

fn make() -> Result<Reproduction, GalleryError> {
    let spin = 1.0 / PITCH;
    let fixed = Race::new(FIXED)?;
    let rows: Result<Vec<[f64; 6]>, GalleryError> = OTHERS
        .par_iter()
        .map(|other| {
            let race = Race::new(*other)?;
            let found = balanced([&fixed, &race], spin, STARTS[0])?;
            let [creep, turn, _] = fixed.units;
            let [p, q, w] = [found.added[0] / creep, found.added[1] / creep, found.added[2] / turn];
            let fy = fixed.forces([found.added[0], found.added[1], spin + found.added[2]])?[0][1];
            Ok([*other, p, q, w, fy, found.residual])
        })
        .collect();
    let rows = rows?;
    let congruent = Race::new(FIXED)?;
    let mut spread = 0.0_f64;
    for start in STARTS {
        let found = balanced([&fixed, &congruent], spin, start)?;
        let [creep, turn, _] = fixed.units;
        let off = [found.added[0] / creep, found.added[1] / creep, found.added[2] / turn];
        spread =
            off.into_iter().chain([found.residual]).fold(spread, |most, one| most.max(one.abs()));
    }
    let mut data = Data::new([
        "other groove over the ball's diameter",
        "xi",
        "eta",
        "chi added",
        "fy",
        "residual",
    ]);
    for row in &rows {
        data.push(row.map(Into::into));
    }
    let chi = spin / fixed.units[1];
    let most = |k: usize| rows.iter().map(|row| row[k].abs()).fold(0.0, f64::max);
    let agreement = vec![
        Comparison::claim(
            "creepages of a ball between congruent contacts",
            "pure spin",
            format!(
                "ξ, η and unequal spin below {spread:.0e}, from three starts; χ = {chi:.2} in both"
            ),
            spread < 1e-5,
        ),
        Comparison::claim(
            "the same where the other groove’s radius is 0.505 to 0.54 of the ball’s diameter",
            "(pure spin is said of congruent contacts)",
            format!(
                "η up to {:.3}, spins up to {:.2} apart in χ, ξ below {:.0e}",
                most(2),
                2.0 * most(3),
                most(1)
            ),
            most(2) > 0.01,
        ),
    ];
    let caption = "A ball of 12.7 mm between the two plane races of a thrust bearing, mean radius 25 mm, 200 N, μ = 0.1, no cage, slow. Its rotation \
        is found from the balance of its moments, by the full theory in both contacts. One groove has a radius of 0.52 of the ball’s \
        diameter, the other that of the abscissa. Where both are alike, either contact is the other turned by half a turn about the lateral \
        direction. The moments about the rolling and the normal direction cancel, and no creepage is needed. \
        The lateral forces of both contacts point the same way; a small difference of the contact angles carries them. \
        Between unlike grooves it is not so. The race with the larger moment of spin nearly holds the ball, which spins on the other \
        alone (“race control”), and creeps a little across. The thesis has the statement alone.";
    Ok(Reproduction::figure(&sheet(&rows), caption, data, agreement))
}

fn sheet(rows: &[[f64; 6]]) -> Sheet {
    const ENDS: [f64; 2] = [0.5, 0.545];
    let column = |k: usize| rows.iter().map(|row| [row[0], row[k]]).collect::<Curve>();
    let frame = |top: f64, heading: Label| {
        let x = Label::new("radius of the other groove over the ball’s diameter");
        Panel::new(Axis::new(ENDS, x), Axis::new([-top, top], heading))
            .height(230.0)
            .curve(vec![[ENDS[0], 0.0], [ENDS[1], 0.0]], Pen::GUIDE)
            .curve(vec![[FIXED, -top], [FIXED, top]], Pen::GUIDE)
    };
    let drawn = |panel: Panel, k: usize, pen: Pen| {
        panel.curve(column(k), pen).marks(column(k), Mark::open(Shape::Circle, pen.colour))
    };
    let most = |k: usize| rows.iter().map(|row| row[k].abs()).fold(0.0, f64::max);
    let spins = frame(
        1.15 * most(3),
        Label::new("spin ").symbol("χ").plain(" beyond half of that of the races"),
    );
    let creepages = frame(1.15 * most(2), Label::new("creepage"));
    Sheet::new(ITEM.title)
        .panel(drawn(spins, 3, THIRD))
        .panel(drawn(drawn(creepages, 1, FULL), 2, SECOND))
        .key(THIRD, Label::new("spin"))
        .key(FULL, Label::new("longitudinal creepage ").symbol("ξ"))
        .key(SECOND, Label::new("lateral creepage ").symbol("η"))
}
