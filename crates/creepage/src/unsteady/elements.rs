//! Elements and influence of a rolling contact, which do not change from step to step; and what particles bring along from upstream where friction has a memory or a layer yields.

use super::history::{Ages, Past, TimeLevel, Weights};
use crate::coulomb::forcing;
use crate::coulomb::friction_bound::Arriving;
use crate::coulomb::grid::Grid;
use crate::coulomb::influence::Displacements;
use crate::coulomb::mesh::{Mesh, StripGrading};
use crate::coulomb::stencil::SlipStencil;
use crate::friction_law::RollingFriction;
use crate::layer::Layer;
use crate::{Ellipse, Scaling};

/// One element of a strip, in units of `c`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Element {
    pub strip: usize,
    /// Centre.
    pub x: f64,
    pub y: f64,
    /// Points of displacement: that at the centre, the next upstream and the one after it.
    pub nodes: [usize; 3],
    /// Steps upstream between these; the first element has one only, to the leading edge.
    pub steps: [f64; 2],
    pub area: f64,
}

/// The points of displacement of a strip, from its leading edge.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    pub first: usize,
    pub x: Vec<f64>,
    pub y: f64,
    /// Half-length on the middle line.
    pub half_length: f64,
}

/// What is between the bodies, besides a constant coefficient of friction.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Surface {
    pub friction: Option<RollingFriction>,
    pub layer: Option<Layer>,
}

/// Elements, points of displacement, and the displacements there by tractions and pressure.
#[derive(Debug)]
pub(crate) struct Elements {
    /// With the slip of steady rolling.
    pub steady: Grid,
    /// Half-width of the rounded corner of Coulomb's law where nothing is remembered.
    pub rounding: f64,
    pub all: Vec<Element>,
    pub rows: Vec<Row>,
    /// Of all points, by tractions over their bounds.
    pub displacements: Displacements,
    /// Of the bodies.
    pub poisson: f64,
    /// Traction bounds of all elements, in the unit of those that move points by a unit.
    pub units: Vec<f64>,
    /// Of all points, by the pressure of dissimilar bodies.
    pub by_pressure: Vec<[f64; 2]>,
    /// The contact, for particles that enter it from the side; a line contact has no sides.
    pub semi_axes: [f64; 2],
    /// Whether there is a layer between the bodies: it keeps its thickness while the contact grows.
    pub has_layer: bool,
}

impl Elements {
    /// The elements of a grid, whose unit of slip over the largest traction bound is `slip_unit` in
    /// units of `G`.
    pub(crate) fn new(steady: Grid, poisson: f64, slip_unit: f64, semi_axes: [f64; 2]) -> Self {
        let rounding = steady.rounding;
        // From step to step a rounded corner would let adhering elements creep.
        let mut steady = Grid { rounding: 0.0, ..steady };
        let stencils: Vec<_> = steady.mesh.strips.iter().map(SlipStencil::steady).collect();
        let points: Vec<_> = stencils.iter().map(|stencil| stencil.points.clone()).collect();
        let units = steady.pressure.units(slip_unit);
        let displacements = Displacements::new(&steady.mesh, poisson, &points, units.clone());
        steady.influence = displacements.slip();
        steady.combine(&displacements, &of_all_points(&stencils));
        let mesh = &steady.mesh;
        let mut first = 0;
        let mut rows = Vec::with_capacity(points.len());
        for (strip, points) in mesh.strips.iter().zip(&points) {
            let (x, y) = (points.iter().map(|point| point[0]).collect(), strip.y());
            let half_length = 0.5 * (strip.half_length[0] + strip.half_length[1]);
            rows.push(Row { first, x, y, half_length });
            first += points.len();
        }
        let all = mesh.all().map(|(strip, i)| {
            Element::new(strip, &rows[strip], i, area(mesh.strips[strip].corners(i)))
        });
        let all = all.collect();
        let by_pressure = vec![[0.0; 2]; first];
        let has_layer = false;
        Self {
            steady,
            rounding,
            all,
            rows,
            displacements,
            poisson,
            units,
            by_pressure,
            semi_axes,
            has_layer,
        }
    }

    /// Hertz's contact in the units of [`Grid::hertz`]. Strips narrow towards the sides, for a shift
    /// slips all around the edge.
    pub(crate) fn hertz(
        ellipse: Ellipse,
        poisson: f64,
        kappa_over_mu: f64,
        [along, strips]: [usize; 2],
    ) -> Self {
        let mesh = Mesh::with_sides(ellipse, along, strips, StripGrading::NARROW);
        let slip_unit = (1.0 - poisson) * ellipse.integrals().e / (2.0 * ellipse.g().sqrt());
        let grid = Grid::hertz(ellipse, poisson, kappa_over_mu, mesh);
        let mut elements = Self::new(grid, poisson, slip_unit, [ellipse.a(), ellipse.b()]);
        if kappa_over_mu != 0.0 {
            let factor = kappa_over_mu / slip_unit;
            let at = |[x, y]: [f64; 2]| forcing::displacement(ellipse, [x, y]).map(|u| factor * u);
            let points = elements.rows.iter().flat_map(|row| row.x.iter().map(|x| [*x, row.y]));
            elements.by_pressure = points.map(at).collect();
        }
        elements
    }

    /// The same with friction that depends on the slip or the place, and with a layer, in the units
    /// `scaling`.
    pub(crate) fn with_surface(mut self, surface: &Surface, scaling: Scaling) -> Self {
        let Surface { friction, layer } = *surface;
        if let Some(layer) = layer {
            let own = self.steady.displacements_of(layer, scaling);
            self.displacements = self.displacements.with_own(&own);
            self.has_layer = true;
        }
        let bare = Grid { rounding: self.rounding, ..self.steady };
        let steady = bare.with_resistance(friction, layer, scaling);
        self.rounding = steady.rounding;
        Self { steady: Grid { rounding: 0.0, ..steady }, ..self }
    }

    /// Number of points of displacement.
    pub(crate) fn points(&self) -> usize {
        self.by_pressure.len()
    }
}

/// The stencils' weights with points counted from strip to strip.
fn of_all_points(stencils: &[SlipStencil]) -> Vec<[(usize, f64); 3]> {
    let mut first = 0;
    let of_strip = |stencil: &SlipStencil| {
        let own = first;
        first += stencil.points.len();
        let from_own =
            move |weights: &[(usize, f64); 3]| weights.map(|(point, w)| (own + point, w));
        stencil.weights.iter().map(from_own).collect::<Vec<_>>()
    };
    stencils.iter().flat_map(of_strip).collect()
}

impl Element {
    fn new(strip: usize, row: &Row, i: usize, area: f64) -> Self {
        let second = i.max(1) - 1;
        let step = |k: usize| row.x[k] - row.x[k + 1];
        Self {
            strip,
            x: row.x[i + 1],
            y: row.y,
            nodes: [row.first + i + 1, row.first + i, row.first + second],
            steps: [step(i), if i == 0 { 0.0 } else { step(i - 1) }],
            area,
        }
    }
}

/// Area of a trapezium between two lines of constant `y`.
fn area([a, b, c, d]: [[f64; 2]; 4]) -> f64 {
    0.5 * ((c[0] - a[0]) * (d[1] - b[1]) - (d[0] - b[0]) * (c[1] - a[1])).abs()
}

impl Elements {
    /// Friction, slip and plastic displacement of the particles now at all elements, one step of elements
    /// upstream, in a step of `length` to the size `scale`. What enters the contact has friction at rest and
    /// a layer that has not yielded.
    pub(crate) fn arriving(&self, past: &Past, length: f64, scale: f64) -> Vec<Arriving> {
        let ages = past.seen_after(length, scale, true);
        let arriving = |(index, element): (usize, &Element)| {
            let step = element.steps[0] * scale;
            let back = step.min(ages.origin());
            let upstream = (element.steps[1] > 0.0).then(|| index - 1);
            arriving_before(past, &ages, (back, back / step), (index, upstream))
        };
        self.all.iter().enumerate().map(arriving).collect()
    }

    /// The same while the bodies are shifted: particles stay where they are.
    pub(crate) fn staying(&self, level: &TimeLevel) -> Vec<Arriving> {
        let of = |element: usize| {
            let plastic = level.friction[2].get(element).copied().unwrap_or(0.0);
            Arriving { present: 0.0, friction: 1.0, slip: 0.0, plastic, step: 0.0 }
        };
        (0..self.all.len()).map(of).collect()
    }
}

/// A particle now at element `index`, where it was `back`, `ahead` of the way to the element `upstream`.
fn arriving_before(
    past: &Past,
    ages: &Ages,
    (back, ahead): (f64, f64),
    (index, upstream): (usize, Option<usize>),
) -> Arriving {
    let (scale, weights) = (ages.scales[0], ages.weights(back));
    let Weights { present, levels, .. } = weights;
    let step = back / scale;
    let mut arriving = Arriving { present, friction: 0.0, slip: 0.0, plastic: 0.0, step };
    if upstream.is_none() {
        arriving.friction = present;
    }
    for (level, weight) in levels {
        let of = |of: usize, element: usize| past.0[level].friction[of].get(element).copied();
        let known = |k: usize| of(k, upstream?);
        arriving.friction += weight * known(0).unwrap_or(1.0);
        arriving.slip += weight / scale * known(1).unwrap_or(0.0);
        let [here, there] = [of(2, index), known(2)].map(|plastic| plastic.unwrap_or(0.0));
        arriving.plastic += weight * (ahead * there + (1.0 - ahead) * here);
    }
    if upstream.is_none() {
        arriving.present = 0.0;
    }
    arriving.plastic = arriving.plastic.max(0.0);
    arriving
}
