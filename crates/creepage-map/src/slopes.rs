//! Slopes of a node's contacts: of their geometry and of their ellipses, along the map's place and along the logarithm
//! of the load, by differences of neighbouring nodes.

use creepage::Creepage;
use creepage::table::Table;
use nalgebra::{DMatrix, DVector};

use crate::error::MapError;
use crate::patch::{Ellipse, EllipseSlopes, From, Patch, Prepared, Sloped};
use crate::wheel::RollingNode;

/// Coefficients of friction at which the spin of pure rolling is asked.
const FRICTIONS: [f64; 3] = [0.12, 0.3, 0.6];
/// Amplitudes of creepage, in parts of that at which linear theory has all of the friction force.
const AMPLITUDES: [f64; 4] = [0.1, 0.5, 1.2, 2.5];
/// Directions of each amplitude.
const DIRECTIONS: u32 = 4;
/// Spin (rad/m) below which a contact is asked as if it had this.
const LEAST_SPIN: f64 = 0.08;
/// A change of numbers by their own size is worth at least this of the forces (root mean square, of `mu N`).
const LEAST_RESIDUAL: f64 = 1e-3;
/// Blending asks a node up to this part of a cell away.
const REACH: f64 = 1.0 / 3.0;

/// Gives each node's contacts their slopes, of the parabola through it and its neighbours; at an end, or where a
/// neighbour has other contacts, of one side. `radius` (m) of the wheel tells the spin of pure rolling.
///
/// The geometry is differenced. Numbers of two ellipses are not, for two pairs of quite different numbers may have
/// the same forces: the *forces* of the neighbours' ellipses are differenced at creepages all over the range of
/// friction, and the slopes of the node's own numbers meet these by least squares.
///
/// # Errors
/// [`MapError::Invalid`] where a ratio is not in the table.
pub fn slopes(
    nodes: &mut [RollingNode],
    loads: &[f64],
    radius: f64,
    (table, poisson): (&Table, f64),
) -> Result<(), MapError> {
    let logs: Vec<f64> = loads.iter().map(|load| load.ln()).collect();
    let places: Vec<f64> = nodes.iter().map(|node| node.place).collect();
    let prepared = |patch: &Patch| {
        let level = Patch { ellipses: patch.ellipses.map(Ellipse::level), ..*patch };
        Prepared::new(&level, table, poisson)
    };
    let known = nodes
        .iter()
        .map(|node| {
            let record = |record: &Vec<Patch>| record.iter().map(prepared).collect();
            node.loads.iter().map(record).collect::<Result<Vec<Vec<Prepared>>, _>>()
        })
        .collect::<Result<Vec<_>, _>>()?;
    for (n, node) in nodes.iter_mut().enumerate() {
        for (l, record) in node.loads.iter_mut().enumerate() {
            let slots = record.len();
            for (slot, patch) in record.iter_mut().enumerate() {
                let of = |n: usize, l: usize| {
                    let record = known.get(n)?.get(l)?;
                    (record.len() == slots).then(|| record.get(slot)).flatten()
                };
                let own = &known[n][l][slot];
                let along_place = beside(&places, n, |n| of(n, l));
                let along_load = beside(&logs, l, |l| of(n, l));
                let fits = Differences { own, radius, table };
                let by_place = fits.slopes(along_place, |_| 0.0);
                let by_load = fits.slopes(along_load, |step| step);
                for (e, ellipse) in patch.ellipses.iter_mut().enumerate() {
                    (ellipse.by_place, ellipse.by_load) = (by_place[e], by_load[e]);
                }
                geometry(patch, &own.patch, along_place, |s, slope| s.by_place = slope);
                geometry(patch, &own.patch, along_load, |s, slope| s.by_load = slope);
            }
        }
    }
    Ok(())
}

/// Neighbours before and after, each with its distance.
type Neighbours<'a> = [Option<(f64, &'a Prepared)>; 2];

fn beside<'a>(
    axis: &[f64],
    k: usize,
    of: impl Fn(usize) -> Option<&'a Prepared>,
) -> Neighbours<'a> {
    [k.checked_sub(1), Some(k + 1)].map(|beside| {
        let beside = beside?;
        Some((axis.get(beside)? - axis[k], of(beside)?))
    })
}

/// The slope of the parabola through a node and its neighbours, of differences from the node over distances;
/// that of one side where the other is missing.
fn parabola(differences: [Option<(f64, f64)>; 2]) -> f64 {
    let rates = differences.map(|one| one.map(|(step, by)| (step.abs(), by / step)));
    match rates {
        [Some((before, one)), Some((after, other))] => {
            (one * after + other * before) / (before + after)
        }
        [Some((_, one)), None] | [None, Some((_, one))] => one,
        [None, None] => 0.0,
    }
}

/// Slopes of the geometry of a patch along one axis.
fn geometry(
    patch: &mut Patch,
    own: &Patch,
    beside: Neighbours<'_>,
    set: impl Fn(&mut Sloped, f64),
) {
    type Part = fn(&mut Patch) -> &mut Sloped;
    let parts: [Part; 4] = [|p| &mut p.y, |p| &mut p.z, |p| &mut p.angle, |p| &mut p.share];
    for part in parts {
        let value = |of: &Patch| part(&mut { *of }).value;
        let by =
            beside.map(|one| one.map(|(step, other)| (step, value(&other.patch) - value(own))));
        set(part(patch), parabola(by));
    }
}

/// A patch whose ellipses' slopes are sought.
struct Differences<'a> {
    own: &'a Prepared,
    radius: f64,
    table: &'a Table,
}

/// `ln k_x` along and across, `ln k_p`, `s` over a length, of both ellipses; the first one's weight.
const NUMBERS: usize = 9;

impl Differences<'_> {
    /// Slopes of both ellipses; `grown` is the logarithm of the load that a step adds.
    fn slopes(&self, beside: Neighbours<'_>, grown: impl Fn(f64) -> f64) -> [EllipseSlopes; 2] {
        let steps = beside.map(|one| one.map_or(0.0, |(step, _)| step.abs()));
        let wide = steps[0].max(steps[1]);
        if wide <= 0.0 {
            return [EllipseSlopes::default(); 2];
        }
        let asked = self.creepages();
        let length = self.own.patch.area.max(0.0).sqrt().max(1e-6);
        let (mut by, mut change) =
            (DMatrix::zeros(2 * asked.len(), NUMBERS), DVector::zeros(2 * asked.len()));
        let (mut moments, mut moment_by) =
            (DMatrix::zeros(asked.len(), 6), DMatrix::zeros(asked.len(), NUMBERS));
        let mut moment_change = DVector::zeros(asked.len());
        for (n, at) in asked.iter().enumerate() {
            let changes = beside.map(|one| {
                one.map(|(step, other)| {
                    let own = self.own.friction(self.table, *at, &From::new(0.0, grown(step)));
                    let other = other.friction(self.table, *at, &From::new(0.0, 0.0));
                    (step, [0, 1, 2].map(|k: usize| other[k] - own[k]))
                })
            });
            let slope = |k: usize| parabola(changes.map(|one| one.map(|(step, by)| (step, by[k]))));
            // Over the wider of both cells.
            (change[2 * n], change[2 * n + 1]) = (wide * slope(0), wide * slope(1));
            moment_change[n] = wide * slope(2) / length;
            for e in 0..2 {
                let (force, rows) = self.derivatives(e, *at, length);
                for k in 0..4 {
                    by[(2 * n, 4 * e + k)] = rows[0][k];
                    by[(2 * n + 1, 4 * e + k)] = rows[1][k];
                    moment_by[(n, 4 * e + k)] = rows[2][k] / length;
                }
                let sense = if e == 0 { 1.0 } else { -1.0 };
                by[(2 * n, 8)] += sense * force[0];
                by[(2 * n + 1, 8)] += sense * force[1];
                for (k, part) in [force[2], force[0], force[1]].into_iter().enumerate() {
                    moments[(n, 3 * e + k)] = part;
                }
            }
        }
        let believed =
            self.own.patch.residual.max(LEAST_RESIDUAL) * (2.0 * asked.len() as f64).sqrt();
        let found = ridge(&by, &change, believed);
        let left = moment_change - moment_by * &found;
        let moment = ridge(&moments, &left, believed);
        self.bounded(&found, &moment, [wide, length])
    }

    /// The numbers' changes over a cell as slopes, kept so small that within the reach of blending no scale turns
    /// and no weight leaves 0 to 1.
    fn bounded(
        &self,
        found: &DVector<f64>,
        moment: &DVector<f64>,
        [wide, length]: [f64; 2],
    ) -> [EllipseSlopes; 2] {
        let [one, other] = self.own.patch.ellipses;
        let room = one.weight.min(other.weight).max(0.0) / REACH;
        let weight = found[8].clamp(-room, room) / wide;
        [(0, weight), (1, -weight)].map(|(e, weight): (usize, f64)| {
            let k = 4 * e;
            let scale = |k: usize| found[k].clamp(-1.0, 1.0) / wide;
            EllipseSlopes {
                along: scale(k),
                across: scale(k + 1),
                spin: scale(k + 2),
                offset: found[k + 3].clamp(-1.0, 1.0) * length / wide,
                weight,
                moment: [0, 1, 2].map(|i: usize| moment[3 * e + i] * length / wide),
            }
        })
    }

    /// Creepage along and across, and spin, over friction: of pure rolling at some coefficients, alone and with
    /// creepage of some sizes and directions.
    fn creepages(&self) -> Vec<[f64; 3]> {
        let ellipses = &self.own.patch.ellipses;
        let mean = |of: fn(&Ellipse) -> f64| -> f64 {
            ellipses.iter().map(|ellipse| ellipse.weight * of(ellipse)).sum()
        };
        let slip = mean(|e| e.by_creepage).recip();
        let per_spin = mean(|e| e.by_spin) * slip;
        let spin = -self.own.patch.angle.value.sin() / self.radius;
        let spin = if spin.abs() < LEAST_SPIN { LEAST_SPIN.copysign(spin) } else { spin };
        let mut all = Vec::new();
        for (turn, friction) in FRICTIONS.into_iter().enumerate() {
            let spin = spin / friction;
            all.push([0.0, 0.0, spin]);
            let unit = 0.9 * slip + 0.3 * spin.abs() * per_spin;
            for amplitude in AMPLITUDES {
                for k in 0..DIRECTIONS {
                    let part = f64::from(k) + turn as f64 / FRICTIONS.len() as f64;
                    let (sin, cos) =
                        (std::f64::consts::TAU * part / f64::from(DIRECTIONS)).sin_cos();
                    all.push([amplitude * unit * cos, amplitude * unit * sin, spin]);
                }
            }
        }
        all
    }

    /// Force and moment of an ellipse, and the derivatives of what it adds to force and moment (m) by its numbers.
    fn derivatives(
        &self,
        e: usize,
        [x, y, spin]: [f64; 3],
        length: f64,
    ) -> ([f64; 3], [[f64; 4]; 3]) {
        let Ellipse { by_creepage, by_spin, offset, weight, moment, .. } =
            self.own.patch.ellipses[e];
        let along = by_creepage * (x - spin * offset);
        let (across, turn) = (by_creepage * y, by_spin * spin);
        let at = Creepage::new(along, across, turn).unwrap_or_default();
        let (force, by) = self.own.slice(self.table, e).force_and_derivative(at);
        let force = force.components();
        let shift = -by_creepage * spin * length;
        let steps =
            |row: [f64; 3]| [row[0] * along, row[1] * across, row[2] * turn, row[0] * shift];
        let [dx, dy, dm] = by.map(steps);
        let of_moment =
            [0, 1, 2, 3].map(|k: usize| dm[k] * moment[0] + dx[k] * moment[1] + dy[k] * moment[2]);
        (force, [dx.map(|part| part * weight), dy.map(|part| part * weight), of_moment])
    }
}

/// Least squares in which a change of one is worth `believed` of what is to be met.
fn ridge(by: &DMatrix<f64>, right: &DVector<f64>, believed: f64) -> DVector<f64> {
    let mut normal = by.tr_mul(by);
    for k in 0..normal.nrows() {
        normal[(k, k)] += believed * believed;
    }
    let gradient = by.tr_mul(right);
    let none = DVector::zeros(gradient.len());
    normal.cholesky().map_or(none, |factor| factor.solve(&gradient))
}
