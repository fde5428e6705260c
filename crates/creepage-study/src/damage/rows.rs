//! Rows of elements through which the material runs, across the contact.

use creepage::coulomb::ElementField;
use creepage::damage::{ElementState, Row};
use creepage::{Region, Scaling, SiCreepage};

use crate::SolvedCase;

/// Rows across, and elements along each.
const ROWS: u8 = 60;
const ELEMENTS: u8 = 80;

impl SolvedCase {
    /// Rows of equal width, each of elements of equal length over its own. `None` where the theory
    /// gives no slip.
    pub(super) fn rows(&self) -> Option<Vec<Row>> {
        self.sliding_rows().filter(|rows| {
            // A theory without slip, as the linear one, has a field that does no work.
            let power = |row: &Row| ElementState::power_per_metre(&row.elements);
            rows.iter().map(power).sum::<f64>() >= 0.5 * self.power_per_metre()
        })
    }

    fn sliding_rows(&self) -> Option<Vec<Row>> {
        let creepage = self.scaling().si_creepage(self.creepage());
        if self.areas().is_some() {
            let rows = of_elements(self.elements(), self.scaling(), self.load().value, creepage);
            let slips = rows.iter().flat_map(|row| &row.elements).flat_map(|element| element.slip);
            return slips.into_iter().all(f64::is_finite).then_some(rows);
        }
        let strips = of_elements(self.elements(), self.scaling(), self.load().value, creepage);
        let heat = |row: &Row| ElementState::power_per_metre(&row.elements) / row.width;
        let heat: Vec<[f64; 2]> = strips.iter().map(|row| [row.y, heat(row)]).collect();
        let row = |j: u8| {
            let mut row = self.wear_row(middle(j, ROWS))?;
            if let Some(heat) = between(&heat, row.y) {
                let heat = heat * row.width;
                give_heat(&mut row, heat, self.case.friction(), creepage);
            }
            Some(row)
        };
        (0..ROWS).map(row).collect()
    }

    /// The row at `t` of the half-width.
    fn wear_row(&self, t: f64) -> Option<Row> {
        let (hertz, scaling) = (self.case.hertz()?, self.scaling());
        let ellipse = hertz.ellipse();
        let root = ((1.0 - t) * (1.0 + t)).sqrt();
        let places: Vec<_> = (0..ELEMENTS).map(|i| [root * middle(i, ELEMENTS), t]).collect();
        let width = 2.0 * ellipse.b() / f64::from(ROWS);
        let length = 2.0 * ellipse.a() * root / f64::from(ELEMENTS);
        let field = self.field(&self.positions(&places));
        let element = |(point, [x, y]): (&creepage::FieldPoint, &[f64; 2])| {
            let slides = point.region == Region::Slip;
            let slip = if slides { point.slip } else { [0.0; 2] };
            let known = slip.iter().all(|s| s.is_finite());
            known.then(|| ElementState {
                pressure: (1.0 - x * x - y * y).max(0.0).sqrt() * hertz.peak_pressure(),
                traction: point.traction.map(|t| t * scaling.traction),
                slip: slip.map(|s| s * scaling.slip),
                area: length * width,
                length,
            })
        };
        let elements = field.iter().zip(&places).map(element).collect::<Option<_>>()?;
        Some(Row { y: t * ellipse.b(), width, elements })
    }
}

/// The value at `y` of rising places with values, interpolated; that of the end beyond. `None` without any.
fn between(values: &[[f64; 2]], y: f64) -> Option<f64> {
    let above = values.partition_point(|[place, _]| *place < y).min(values.len().checked_sub(1)?);
    let below = above.saturating_sub(1);
    let ([from, low], [to, high]) = (values[below], values[above]);
    let share = if to > from { ((y - from) / (to - from)).clamp(0.0, 1.0) } else { 1.0 };
    Some(low + share * (high - low))
}

/// Gives a row this heat per metre rolled (J/m): what it lacks slides in its first element, at the trailing
/// edge, where slip is narrower than elements; where it has more, all slip is less.
fn give_heat(row: &mut Row, heat: f64, friction: f64, creepage: SiCreepage) {
    let own = ElementState::power_per_metre(&row.elements);
    if heat < own {
        let part = heat / own;
        row.elements.iter_mut().for_each(|element| element.slip = element.slip.map(|s| part * s));
    } else if let Some(last) = row.elements.first() {
        let rigid = rigid_slip(creepage, [0.0, row.y]);
        row.elements.extend(sliding_edge(last, friction * last.pressure, heat - own, rigid));
    }
}

/// Size of the slip of rigid bodies at a place (m), over the rolling velocity.
fn rigid_slip(SiCreepage { longitudinal, lateral, spin }: SiCreepage, [x, y]: [f64; 2]) -> f64 {
    (longitudinal - spin * y).hypot(lateral + spin * x)
}

/// What slides at the trailing edge of an element that adheres for the rest: at the traction bound, along
/// its traction, as fast as rigid bodies would, and so wide that this much turns to heat per metre rolled
/// (J/m).
fn sliding_edge(element: &ElementState, bound: f64, heat: f64, slip: f64) -> Option<ElementState> {
    let size = element.traction[0].hypot(element.traction[1]);
    let area = heat / (bound * slip);
    let along = element.traction.map(|traction| traction / size);
    let slides = area > 0.0 && area.is_finite() && size > 0.0;
    slides.then(|| ElementState {
        traction: along.map(|part| bound * part),
        slip: along.map(|part| slip * part),
        area,
        length: area * element.length / element.area,
        ..*element
    })
}

/// Middle of piece `k` of `count` between -1 and 1.
pub(crate) fn middle(k: u8, count: u8) -> f64 {
    (2.0 * f64::from(k) + 1.0) / f64::from(count) - 1.0
}

/// The rows of elements that come strip by strip; `normal` is the load (N).
pub(crate) fn of_elements(
    elements: &[ElementField],
    scaling: Scaling,
    normal: f64,
    creepage: SiCreepage,
) -> Vec<Row> {
    let borders = |element: &ElementField| element.corners.map(|[_, y]| y.to_bits());
    let same = |one: &ElementField, two: &ElementField| borders(one) == borders(two);
    let rows = elements.chunk_by(same).map(|row| {
        let states: Vec<_> =
            row.iter().flat_map(|element| states(element, scaling, normal, creepage)).collect();
        let [low, high] = row.first().map_or([0.0; 2], |first| [0, 1].map(|k| first.corners[k][1]));
        Row {
            y: scaling.length * 0.5 * (low + high),
            width: scaling.length * (high - low).abs(),
            elements: states,
        }
    });
    rows.collect()
}

/// An element, and what slides at its trailing edge beyond what it resolves.
pub(crate) fn states(
    element: &ElementField,
    scaling: Scaling,
    normal: f64,
    creepage: SiCreepage,
) -> impl Iterator<Item = ElementState> + use<> {
    let [p, q, r, s] = element.corners;
    let cross = (r[0] - p[0]) * (s[1] - q[1]) - (s[0] - q[0]) * (r[1] - p[1]);
    let area = 0.5 * cross.abs() * scaling.length * scaling.length;
    let mut state = ElementState {
        pressure: element.share * normal / area,
        traction: element.point.traction.map(|t| t * scaling.traction),
        slip: element.point.slip.map(|s| s * scaling.slip),
        area,
        length: scaling.length * 0.5 * (p[0] + q[0] - r[0] - s[0]).abs(),
    };
    // The element's heat, with that of slip narrower than itself.
    let heat = scaling.force * scaling.slip * element.power;
    let own = ElementState::power_per_metre(&[state]);
    if own.is_finite() && heat < own {
        state.slip = state.slip.map(|s| s * heat / own);
    }
    let rigid = rigid_slip(creepage, element.point.position.map(|at| scaling.length * at));
    let edge = sliding_edge(&state, element.bound * scaling.traction, heat - own, rigid);
    std::iter::once(state).chain(edge)
}
