//! Row solver of each simplified theory: tractions in one row of cells, in units of the largest bound.

use super::rows::Row;
use super::springs::Springs;
use crate::approximate::dual::Real;
use crate::approximate::strip::{Strip, StripNumbers, unit};
use crate::normal::SLIP_UNIT;

/// Traction and slip of a cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell<R> {
    pub(super) traction: [R; 2],
    /// NaN where the theory does not give it.
    pub(super) slip: [R; 2],
    pub(super) slides: bool,
}

/// The creepage of a row.
#[derive(Debug, Clone, Copy)]
pub(super) struct RowCreepage<R> {
    /// At the centre of pressure of its patch.
    pub(super) centre: [R; 3],
    /// At the origin.
    pub(super) creepage: [R; 3],
    /// What is added in this row.
    pub(super) more: [f64; 2],
}

impl<R: Real> RowCreepage<R> {
    /// Slip of the bodies as if rigid.
    pub(super) fn slip(&self, [x, y]: [f64; 2]) -> [R; 2] {
        let [xi, eta, chi] = self.creepage;
        [xi - chi * y + self.more[0], eta + chi * x + self.more[1]]
    }
}

/// Springs marched through from the leading end, by tractions over their bound.
struct March<R> {
    traction: [R; 2],
    /// Growth of the traction over `slip times length`, longitudinal, lateral and by spin.
    stiffness: [R; 3],
}

impl<R: Real> March<R> {
    fn new(springs: &Springs, at: &RowCreepage<R>) -> Self {
        let stiffness = springs.stiffnesses(at.centre).map(|s| s * SLIP_UNIT);
        Self { traction: [R::constant(0.0); 2], stiffness }
    }

    /// The step to the middle of cell `i`; the slip that its bound leaves.
    fn step(
        &mut self,
        row: &Row,
        springs: &Springs,
        i: usize,
        bound: f64,
        at: &RowCreepage<R>,
    ) -> Cell<R> {
        let whole = row.step();
        // Traction vanishes at the leading end, half a cell before the first middle.
        let step = if i == 0 { 0.5 * whole } else { whole };
        let place = [row.middle(i) + 0.5 * step, row.y];
        let [_, _, chi] = at.creepage;
        let [x, y] = [0, 1].map(|k| place[k] - springs.centroid[k]);
        let ([l1, l2, l3], by_spin) = (self.stiffness, [-chi * y, chi * x]);
        let rigid = at.slip(place);
        let growth = [
            (rigid[0] - by_spin[0]) * l1 + by_spin[0] * l3,
            (rigid[1] - by_spin[1]) * l2 + by_spin[1] * l3,
        ];
        let trial = [0, 1].map(|k| self.traction[k] + growth[k] * step);
        let size = (trial[0] * trial[0] + trial[1] * trial[1]).sqrt();
        let slides = size.value() > bound;
        let zero = R::constant(0.0);
        let mut slip = [zero; 2];
        if slides {
            let scale = R::constant(bound) / size;
            self.traction = trial.map(|t| t * scale);
            let lost = -scale + 1.0;
            // Spin has springs of its own: the stiffness is that by which the rigid slip as a whole loads them.
            let sizes = [growth, rigid].map(|[x, y]| (x * x + y * y).sqrt());
            let stiffness = if sizes[1].value() > 0.0 { sizes[0] / sizes[1] } else { l1 };
            slip = trial.map(|t| t * lost / (stiffness * step));
        } else {
            self.traction = trial;
        }
        Cell { traction: self.traction, slip, slides }
    }
}

/// FASTSIM with blended flexibilities.
pub(super) fn fastsim<R: Real>(
    row: &Row,
    bounds: &[f64],
    springs: &Springs,
    at: &RowCreepage<R>,
    mut visit: impl FnMut(usize, Cell<R>),
) {
    let mut march = March::new(springs, at);
    for (i, bound) in bounds.iter().enumerate() {
        visit(i, march.step(row, springs, i, *bound, at));
    }
}

/// Slip everywhere, of the bodies as if rigid.
pub(super) fn saturated<R: Real>(
    row: &Row,
    bounds: &[f64],
    at: &RowCreepage<R>,
    mut visit: impl FnMut(usize, Cell<R>),
) {
    for (i, bound) in bounds.iter().enumerate() {
        let slip = at.slip([row.middle(i), row.y]);
        let traction = unit(slip).map(|n| n * *bound);
        visit(i, Cell { traction, slip, slides: true });
    }
}

/// Springs without a bound, one for each component of creepage.
pub(super) fn linear<R: Real>(
    row: &Row,
    springs: &Springs,
    at: &RowCreepage<R>,
    mut visit: impl FnMut(usize, Cell<R>),
) {
    let zero = R::constant(0.0);
    let mut traction = [zero; 2];
    for i in 0..row.cells.len() {
        let step = if i == 0 { 0.5 * row.step() } else { row.step() };
        let growth = springs.three(at.centre, [row.middle(i) + 0.5 * step, row.y]);
        traction = [0, 1].map(|k| traction[k] + growth[k] * (SLIP_UNIT * step));
        visit(i, Cell { traction, slip: [zero; 2], slides: false });
    }
}

/// Strip theory's traction in adhesion and FASTSIM's direction in slip; in the cell where one goes
/// over into the other, by the parts of it.
pub(super) fn fastrip<R: Real>(
    row: &Row,
    bounds: &[f64],
    springs: &Springs,
    at: &RowCreepage<R>,
    poisson: f64,
    mut visit: impl FnMut(usize, Cell<R>),
) {
    let strip = own_strip(row, bounds, springs, at, poisson);
    let mut march = March::new(springs, at);
    for (i, bound) in bounds.iter().enumerate() {
        let marched = march.step(row, springs, i, *bound, at);
        let turned = unit(marched.traction).map(|n| n * *bound);
        let u = 1.0 - (2.0 * i as f64 + 1.0) / bounds.len() as f64;
        let (traction, share) = match &strip {
            Some(strip) => {
                let share = strip.sliding_share(u, bounds.len());
                let stuck = strip.traction(u, *bound);
                ([0, 1].map(|k| stuck[k] + (turned[k] - stuck[k]) * share), share.value())
            }
            None => (turned, 1.0),
        };
        let slides = share >= 0.5;
        let slip = if slides { f64::NAN } else { 0.0 };
        visit(i, Cell { traction, slip: [R::constant(slip); 2], slides });
    }
}

/// Whether the slip area of a row by strip theory is narrower than a cell.
pub(super) fn slides_less_than_a_cell(
    row: &Row,
    bounds: &[f64],
    springs: &Springs,
    at: &RowCreepage<f64>,
    poisson: f64,
) -> bool {
    own_strip(row, bounds, springs, at, poisson)
        .is_some_and(|own| own.strip.depth * (bounds.len() as f64) < 1.0)
}

/// A row as strip theory has it, with lengths in units of its half-length.
struct OwnStrip<R> {
    strip: Strip<R>,
    spin: R,
    /// Bound in the middle of the semi-ellipse that carries the same load.
    peak: f64,
}

/// `None` where the spin is beyond strip theory's bound, or the row slides all over.
///
/// With the pressure `rho sqrt(h^2 - x^2)` strip theory asks for the creepages over `4 rho h`, the
/// spin over `4 rho`; factors make the ellipse's coefficients of plane strips'.
fn own_strip<R: Real>(
    row: &Row,
    bounds: &[f64],
    springs: &Springs,
    at: &RowCreepage<R>,
    poisson: f64,
) -> Option<OwnStrip<R>> {
    use std::f64::consts::PI;
    let mean = bounds.iter().sum::<f64>() / bounds.len() as f64;
    let peak = 4.0 / PI * mean;
    let of = &springs.coefficients;
    let factors = [
        4.0 * of.c11 / (PI * PI),
        4.0 * of.c22 / (PI * PI),
        3.0 * of.c23 / (PI * springs.ratio.sqrt()),
    ];
    let [xi, eta, chi] = at.centre;
    let off = [row.centre - springs.centroid[0], row.y - springs.centroid[1]];
    let unit = 0.5 * SLIP_UNIT / peak;
    let spin = chi * (factors[2] * unit * row.half);
    let turn = chi * (factors[2] * unit);
    let free = (1.0 - poisson).recip();
    let numbers = StripNumbers {
        longitudinal: xi * (factors[0] * unit) - turn * (off[1] * free),
        lateral: eta * (factors[1] * unit) + turn * off[0],
        spin,
        shear: 0.0,
    };
    if spin.value().abs() >= 1.0 {
        return None;
    }
    let strip = numbers.strip(0.0);
    (strip.depth.value() < 1.0).then_some(OwnStrip { strip, spin, peak })
}

impl<R: Real> OwnStrip<R> {
    /// The part of the cell at `u` of `count` that lies in the slip area, which ends at `2 D - 1`.
    fn sliding_share(&self, u: f64, count: usize) -> R {
        let share = (self.strip.depth * 2.0 + -1.0 - R::constant(u)) * (0.5 * count as f64) + 0.5;
        if share.value() <= 0.0 {
            R::constant(0.0)
        } else if share.value() >= 1.0 {
            R::constant(1.0)
        } else {
            share
        }
    }

    /// Traction in adhesion, at most the bound.
    fn traction(&self, u: f64, bound: f64) -> [R; 2] {
        let inside = (-self.strip.depth * 2.0 + (1.0 + u)) * (1.0 - u);
        let root = if inside.value() > 0.0 { inside.sqrt() } else { R::constant(0.0) };
        let adhering = root * self.peak;
        let traction = if self.strip.depth.value() > 0.0 {
            let [nx, ny] = self.strip.direction();
            [nx * bound - nx * adhering, ny * bound - (ny - self.spin) * adhering]
        } else {
            [R::constant(0.0), self.spin * bound]
        };
        let size = (traction[0] * traction[0] + traction[1] * traction[1]).sqrt();
        if size.value() > bound {
            let scale = R::constant(bound) / size;
            return traction.map(|t| t * scale);
        }
        traction
    }
}
