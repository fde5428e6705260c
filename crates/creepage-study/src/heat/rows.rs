//! Heat of friction in the rows of a contact.

use creepage::coulomb::ElementField;
use creepage::damage::ElementState;
use creepage::temperature::{HeatRow, HeatedElement};
use creepage::{Region, Scaling, SiCreepage};

use super::HeatedRow;
use crate::SolvedCase;
use crate::damage::{middle, states};

/// Rows across, and elements along each, where a theory has none of its own.
const ROWS: u8 = 61;
const ELEMENTS: u8 = 100;

impl SolvedCase {
    /// Rows of the theory's own elements, or of equal ones where it has none; `None` where it gives no slip.
    pub(super) fn heated_rows(&self, speed: f64) -> Option<Vec<HeatedRow>> {
        let creepage = self.scaling().si_creepage(self.creepage());
        if self.elements().is_empty() {
            return self.rows_by_field(speed);
        }
        of_elements(self.elements(), self.scaling(), self.load().value, creepage, speed)
    }

    /// Rows of an ellipse by traction and slip at places.
    fn rows_by_field(&self, speed: f64) -> Option<Vec<HeatedRow>> {
        let hertz = self.case.hertz()?;
        let (a, b) = (hertz.ellipse().a(), hertz.ellipse().b());
        (0..ROWS)
            .map(|j| {
                let t = middle(j, ROWS);
                let root = ((1.0 - t) * (1.0 + t)).sqrt();
                let places: Vec<_> =
                    (0..ELEMENTS).rev().map(|i| [root * middle(i, ELEMENTS), t]).collect();
                let half = a * root / f64::from(ELEMENTS);
                let field = self.field(&self.positions(&places));
                let element = |(point, [x, _]): (&creepage::FieldPoint, &[f64; 2])| HeatedElement {
                    ends: [a * x - half, a * x + half],
                    heat: match point.region {
                        Region::Slip => speed * self.power_density(point).max(0.0),
                        // Where nothing slides nothing is heated; a slip that is not given is none of a theory.
                        _ if point.slip.iter().all(|slip| slip.is_finite()) => 0.0,
                        _ => f64::NAN,
                    },
                };
                let elements: Vec<_> = field.iter().zip(&places).map(element).collect();
                let heat = HeatRow::new(&elements).ok()?;
                Some(HeatedRow { y: t * b, width: 2.0 * b / f64::from(ROWS), heat })
            })
            .collect()
    }
}

/// Rows of elements that come strip by strip, each from the leading edge; `normal` is the load (N). What
/// slides in a part of an element at its trailing edge is heated there. `None` for slip that is not given.
pub(crate) fn of_elements(
    elements: &[ElementField],
    scaling: Scaling,
    normal: f64,
    creepage: SiCreepage,
    speed: f64,
) -> Option<Vec<HeatedRow>> {
    let borders = |element: &ElementField| element.corners.map(|[_, y]| y.to_bits());
    let same = |one: &ElementField, two: &ElementField| borders(one) == borders(two);
    elements
        .chunk_by(same)
        .map(|strip| {
            let across = strip.iter().flat_map(|element| element.corners.map(|[_, y]| y));
            let [low, high] = across.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| {
                [low.min(y), high.max(y)]
            });
            let width = scaling.length * (high - low);
            let mut row = Vec::with_capacity(strip.len() + 1);
            for element in strip {
                let mut parts = states(element, scaling, normal, creepage);
                let whole = parts.next()?;
                heated(
                    element,
                    scaling,
                    [whole, parts.next().unwrap_or_default()],
                    speed,
                    &mut row,
                );
            }
            let heat = HeatRow::new(&row).ok()?;
            Some(HeatedRow { y: 0.5 * scaling.length * (low + high), width, heat })
        })
        .collect()
}

/// An element as one that is heated, or as two where its trailing part slides faster.
fn heated(
    element: &ElementField,
    scaling: Scaling,
    [whole, edge]: [ElementState; 2],
    speed: f64,
    row: &mut Vec<HeatedElement>,
) {
    // The mean of both sides of a strip that tapers.
    let [front, beside, across, rear] = element.corners.map(|[x, _]| scaling.length * x);
    let ends = [0.5 * (across + rear), 0.5 * (front + beside)];
    let length = ends[1] - ends[0];
    let width = whole.area / length;
    let power = |state: ElementState| speed * ElementState::power_per_metre(&[state]).max(0.0);
    // Heat at the edge in no more than half of the element.
    let edge_length = edge.length.min(0.5 * length);
    let cut = ends[0] + edge_length;
    row.push(HeatedElement {
        ends: [cut, ends[1]],
        heat: power(whole) / (width * (ends[1] - cut)),
    });
    if edge_length > 0.0 {
        row.push(HeatedElement { ends: [ends[0], cut], heat: power(edge) / (width * edge_length) });
    }
}
