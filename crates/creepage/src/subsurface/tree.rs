//! Tree of elements: those far from a point are taken together.
//!
//! Elements are sorted into boxes that are halved again and again. For points away from a box its
//! tractions are point forces at the nodes of Gauss's rule, `N` by `N`, with the same moments up to
//! `N - 1` along each side, and for a traction that is the same all over up to `2 N - 1`: the field of a
//! point force is interpolated between the nodes. Of a point it is analytic in an ellipse
//! around each side of the box, whose foci are the side's ends: with `rho` the sum of its semi-axes over
//! half the side, the error falls as `rho^-N`. A box is far where `rho` is at least [`RHO`]
//! for both sides; one that is not is asked for its halves, and the elements of the last for their
//! closed forms.

use std::num::NonZeroUsize;
use std::ops::Range;

use gauss_quad::GaussLegendre;
use pulp::{Arch, Simd, WithSimd};

use super::edges::Edges;
use super::element::Element;
use super::many::{Field, Forces, NOTHING, Sides, total};

/// Nodes along each side of a box.
const N: usize = 6;
/// Sums of the semi-axes of the ellipses of analyticity, over half a side: at least.
const RHO: f64 = 5.0;
/// Elements of the last boxes, at most.
const LAST: usize = 6;
/// Halvings, at most: boxes in boxes wait on a stack of this size.
const MAX_DEPTH: usize = 48;

/// A box of elements.
#[derive(Debug, Clone)]
struct Cell {
    middle: [f64; 2],
    half: [f64; 2],
    /// Its tractions as point forces.
    forces: Range<usize>,
    inside: Inside,
}

#[derive(Debug, Clone)]
enum Inside {
    Halves([usize; 2]),
    Sides(Range<usize>),
}

/// Elements with their tractions, in lengths over the largest distance from the origin.
#[derive(Debug, Clone, Default)]
pub(super) struct Tree {
    cells: Vec<Cell>,
    forces: Forces,
    sides: Sides,
    /// The unit of length.
    reach: f64,
}

/// An element on its way into a box.
struct Placed {
    element: Element,
    middle: [f64; 2],
}

/// Gauss's rule on `[-1, 1]` with the weights of interpolation between its nodes.
struct Rule {
    nodes: [f64; N],
    weights: [f64; N],
    barycentric: [f64; N],
}

/// Point forces at the nodes of a box.
type Nodal = [[[f64; 3]; N]; N];

impl Tree {
    pub(super) fn new(elements: &[Element], signs: [f64; 3]) -> Self {
        let corners = elements.iter().flat_map(Element::corners);
        let reach = corners.fold(0.0, |reach: f64, [x, y]| reach.max(x.hypot(*y)));
        let mut tree = Self { reach, ..Self::default() };
        if !(reach > 0.0 && reach.recip().is_finite()) {
            return tree;
        }
        let placed = |element: &Element| {
            let element = element.scaled(reach.recip());
            let (_, middle) = element.area_and_centroid();
            Placed { element, middle }
        };
        let mut placed: Vec<_> = elements.iter().map(placed).collect();
        tree.add(&mut placed, signs, &Rule::new(), 0);
        tree
    }

    pub(super) fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// `4 pi` times the stress and `4 pi G` times the displacement.
    pub(super) fn field(&self, point: [f64; 3], poisson: f64) -> Field {
        let at = point.map(|part| part / self.reach);
        let mut field = Arch::new().dispatch(Visit { tree: self, at, poisson });
        field[6..].iter_mut().for_each(|part| *part *= self.reach);
        field
    }

    /// Adds a box of elements and those inside; its place and its point forces.
    fn add(
        &mut self,
        elements: &mut [Placed],
        signs: [f64; 3],
        rule: &Rule,
        depth: usize,
    ) -> (usize, Nodal) {
        let corners = || elements.iter().flat_map(|one| one.element.corners().iter().copied());
        let (middle, half) = around(corners());
        let place = self.cells.len();
        self.cells.push(Cell { middle, half, forces: 0..0, inside: Inside::Sides(0..0) });
        let mut nodal = [[[0.0; 3]; N]; N];
        let (centre, spread) = around(elements.iter().map(|one| one.middle));
        let axis = usize::from(spread[1] > spread[0]);
        let is_last = elements.len() <= LAST || depth + 2 >= MAX_DEPTH || spread[axis] <= 0.0;
        let inside = if is_last {
            for Placed { element, .. } in elements.iter() {
                rule.spread(element, signs, [middle, half], &mut nodal);
            }
            let edges = Edges::new(elements.iter().flat_map(|one| one.element.sides(signs)));
            let first = self.sides.len();
            self.sides.extend(&edges);
            Inside::Sides(first..self.sides.len())
        } else {
            elements.sort_by(|one, two| one.middle[axis].total_cmp(&two.middle[axis]));
            let cut = elements.partition_point(|one| one.middle[axis] < centre[axis]);
            let (low, high) = elements.split_at_mut(cut.clamp(1, elements.len() - 1));
            Inside::Halves([low, high].map(|part| {
                let (index, own) = self.add(part, signs, rule, depth + 1);
                let from = [self.cells[index].middle, self.cells[index].half];
                rule.gather(&own, from, [middle, half], &mut nodal);
                index
            }))
        };
        let first = self.forces.len();
        for (j, row) in nodal.iter().enumerate() {
            for (i, force) in row.iter().enumerate() {
                let node = [rule.nodes[i], rule.nodes[j]];
                self.forces.push([0, 1].map(|k| middle[k] + half[k] * node[k]), *force);
            }
        }
        let forces = first..self.forces.len();
        self.cells[place] = Cell { middle, half, forces, inside };
        (place, nodal)
    }
}

/// Middle and half the lengths of the box around points.
fn around(points: impl Iterator<Item = [f64; 2]>) -> ([f64; 2], [f64; 2]) {
    let ends = points.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], at| {
        [[0, 1].map(|k| at[k].min(low[k])), [0, 1].map(|k| at[k].max(high[k]))]
    });
    let [low, high] = ends;
    ([0, 1].map(|k| 0.5 * (low[k] + high[k])), [0, 1].map(|k| 0.5 * (high[k] - low[k])))
}

impl Rule {
    fn new() -> Self {
        let mut rule = Self { nodes: [0.0; N], weights: [0.0; N], barycentric: [1.0; N] };
        let gauss = GaussLegendre::new(NonZeroUsize::MIN.saturating_add(N - 1));
        for (k, (node, weight)) in gauss.as_node_weight_pairs().iter().enumerate() {
            (rule.nodes[k], rule.weights[k]) = (*node, *weight);
        }
        for (k, weight) in rule.barycentric.iter_mut().enumerate() {
            let others = (0..N).filter(|i| *i != k);
            *weight = others.map(|i| 1.0 / (rule.nodes[k] - rule.nodes[i])).product();
        }
        rule
    }

    /// Interpolation from the nodes to a place: products of the distances from all nodes but one.
    fn basis(&self, at: f64) -> [f64; N] {
        let (mut basis, mut below, mut above) = (self.barycentric, 1.0, 1.0);
        for (basis, node) in basis.iter_mut().zip(&self.nodes) {
            *basis *= below;
            below *= at - node;
        }
        for (basis, node) in basis.iter_mut().zip(&self.nodes).rev() {
            *basis *= above;
            above *= at - node;
        }
        basis
    }

    /// Adds the tractions of an element: integrals over quadrilaterals, the element's fan, one after the
    /// other with their signs, so that it may be of any shape.
    fn spread(
        &self,
        element: &Element,
        signs: [f64; 3],
        [middle, half]: [[f64; 2]; 2],
        nodal: &mut Nodal,
    ) {
        let (corners, traction) = (element.corners(), element.traction());
        let mut own = [[0.0; N]; N];
        let scaled =
            |[x, y]: [f64; 2]| [over(x - middle[0], half[0]), over(y - middle[1], half[1])];
        let first = scaled(corners[0]);
        let mut k = 1;
        while k + 1 < corners.len() {
            let [p, q] = [corners[k], corners[k + 1]].map(scaled);
            let r = corners.get(k + 2).map_or(q, |corner| scaled(*corner));
            self.integrate([first, p, q, r], &mut own);
            k += 2;
        }
        let area = half[0] * half[1] * if element.is_clockwise() { -1.0 } else { 1.0 };
        for (nodal, own) in nodal.iter_mut().flatten().zip(own.as_flattened()) {
            (0..3).for_each(|i| nodal[i] += area * own * signs[i] * traction[i]);
        }
    }

    /// Adds the integrals of products of the basis over a quadrilateral, negative clockwise.
    fn integrate(&self, [p, q, r, s]: [[f64; 2]; 4], own: &mut [[f64; N]; N]) {
        for (u, first) in self.nodes.iter().zip(&self.weights) {
            for (v, second) in self.nodes.iter().zip(&self.weights) {
                let (u, v) = (0.5 * (1.0 + u), 0.5 * (1.0 + v));
                let mix = |k: usize| {
                    let (low, high) = (p[k] + u * (q[k] - p[k]), s[k] + u * (r[k] - s[k]));
                    let along = (1.0 - v) * (q[k] - p[k]) + v * (r[k] - s[k]);
                    [low + v * (high - low), along, high - low]
                };
                let ([x, xu, xv], [y, yu, yv]) = (mix(0), mix(1));
                let share = 0.25 * first * second * (xu * yv - xv * yu);
                let (by_x, by_y) = (self.basis(x), self.basis(y));
                for (row, by_y) in own.iter_mut().zip(by_y) {
                    for (value, by_x) in row.iter_mut().zip(by_x) {
                        *value += share * by_y * by_x;
                    }
                }
            }
        }
    }

    /// Adds the point forces of a box to those of the box around.
    fn gather(&self, own: &Nodal, from: [[f64; 2]; 2], to: [[f64; 2]; 2], nodal: &mut Nodal) {
        let basis = |k: usize| {
            self.nodes
                .map(|node| self.basis(over(from[0][k] + from[1][k] * node - to[0][k], to[1][k])))
        };
        let (by_x, by_y) = (basis(0), basis(1));
        for (forces, by_y) in own.iter().zip(&by_y) {
            let mut row = [[0.0; 3]; N];
            for (force, by_x) in forces.iter().zip(&by_x) {
                for (sum, share) in row.iter_mut().zip(by_x) {
                    (0..3).for_each(|i| sum[i] += share * force[i]);
                }
            }
            for (sums, share) in nodal.iter_mut().zip(by_y) {
                for (sum, force) in sums.iter_mut().zip(&row) {
                    (0..3).for_each(|i| sum[i] += share * force[i]);
                }
            }
        }
    }
}

/// A quotient that is nothing where the divisor is, the size of a box without width.
fn over(value: f64, size: f64) -> f64 {
    if size > 0.0 { value / size } else { 0.0 }
}

impl Cell {
    /// Whether a point is outside the ellipses, turned around the box's sides, and thus on the far side of
    /// all singularities.
    #[inline]
    fn is_far_from(&self, [x, y, z]: [f64; 3]) -> bool {
        const LONG: f64 = 0.5 * (RHO + 1.0 / RHO);
        const SHORT: f64 = 0.5 * (RHO - 1.0 / RHO);
        let [hx, hy] = self.half;
        let [dx, dy] = [(x - self.middle[0]).abs(), (y - self.middle[1]).abs()];
        let [beyond_x, beyond_y] = [(dx - hx).max(0.0), (dy - hy).max(0.0)];
        let is_outside = |along: f64, beyond: f64, half: f64| {
            let across = beyond * beyond + z * z;
            along * along * (1.0 / (LONG * LONG)) + across * (1.0 / (SHORT * SHORT)) > half * half
        };
        is_outside(dx, beyond_y, hx) && is_outside(dy, beyond_x, hy)
    }
}

struct Visit<'a> {
    tree: &'a Tree,
    at: [f64; 3],
    poisson: f64,
}

impl WithSimd for Visit<'_> {
    type Output = Field;

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Field {
        let Self { tree, at, poisson } = self;
        let mut sums = NOTHING;
        let (mut waiting, mut count) = ([0_usize; MAX_DEPTH], usize::from(!tree.is_empty()));
        while count > 0 {
            count -= 1;
            let cell = &tree.cells[waiting[count]];
            if cell.is_far_from(at) {
                tree.forces.add(cell.forces.clone(), at, poisson, &mut sums);
                continue;
            }
            match &cell.inside {
                Inside::Sides(sides) => tree.sides.add(sides.clone(), at, poisson, &mut sums),
                Inside::Halves([low, high]) => {
                    (waiting[count], waiting[count + 1]) = (*low, *high);
                    count += 2;
                }
            }
        }
        total(&sums)
    }
}
