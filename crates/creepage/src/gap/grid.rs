//! Gap on a rectangular grid, interpolated by products of cubics.

use super::cubic::{Cell, slopes};
use super::error::{GapError, all_finite};

/// Value, slopes and mixed slope at a point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Node {
    value: f64,
    by_x: f64,
    by_y: f64,
    mixed: f64,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Grid {
    x: Vec<f64>,
    y: Vec<f64>,
    nodes: Vec<Node>,
}

impl Grid {
    pub(super) fn new(points: &[[f64; 3]]) -> Result<Self, GapError> {
        const NEEDED: usize = 3;
        let [x, y, values] = in_rows(points, "gap", NEEDED)?;
        Ok(Self::of(x, y, &values))
    }

    /// Of values in rows of one y; both coordinates increase.
    pub(super) fn of(x: Vec<f64>, y: Vec<f64>, values: &[f64]) -> Self {
        let nodes = nodes(&x, &y, values);
        Self { x, y, nodes }
    }

    /// The value at the place of the grid next to this one.
    pub(super) fn within(&self, x: f64, y: f64) -> f64 {
        let clamped = |values: &[f64], at: f64| match values {
            [first, .., last] => at.clamp(*first, *last),
            _ => at,
        };
        self.at(clamped(&self.x, x), clamped(&self.y, y))
    }

    pub(super) fn at(&self, x: f64, y: f64) -> f64 {
        let (across, along) = (Cell::new(&self.y, y), Cell::new(&self.x, x));
        let corner = |i, j| self.nodes[(across.index + j) * self.x.len() + along.index + i];
        let row = |j: usize| {
            let (low, high): (Node, Node) = (corner(0, j), corner(1, j));
            let value = along.mix([low.value, high.value], [low.by_x, high.by_x]);
            (value, along.mix([low.by_y, high.by_y], [low.mixed, high.mixed]))
        };
        let ((low, low_slope), (high, high_slope)) = (row(0), row(1));
        across.mix([low, high], [low_slope, high_slope])
    }

    pub(super) fn x(&self) -> &[f64] {
        &self.x
    }

    pub(super) fn y(&self) -> &[f64] {
        &self.y
    }
}

/// The points `[x, y, value]` of a rectangular grid, given in any order: its `x`, its `y`, and its values in rows of
/// one `y`; at least `needed` different ones of each coordinate. `quantity` names the values in errors.
pub(crate) fn in_rows(
    points: &[[f64; 3]],
    quantity: &'static str,
    needed: usize,
) -> Result<[Vec<f64>; 3], GapError> {
    let column = |k: usize| points.iter().map(|point| point[k]).collect::<Vec<f64>>();
    for (k, quantity) in ["x", "y", quantity].into_iter().enumerate() {
        all_finite(quantity, &column(k))?;
    }
    let (x, y) = (distinct(column(0)), distinct(column(1)));
    for (quantity, count) in [("x", x.len()), ("y", y.len())] {
        if count < needed {
            return Err(GapError::TooFew { quantity, count, needed });
        }
    }
    let values = placed(points, &x, &y)?;
    Ok([x, y, values])
}

/// Values of a coordinate, increasing; those that differ by rounding only are one.
fn distinct(mut values: Vec<f64>) -> Vec<f64> {
    const ROUNDING: f64 = 1e-9;
    values.sort_by(f64::total_cmp);
    let range = values.last().zip(values.first()).map_or(0.0, |(last, first)| last - first);
    values.dedup_by(|later, first| *later - *first <= ROUNDING * range);
    values
}

fn nearest(values: &[f64], value: f64) -> usize {
    let above = values.partition_point(|&other| other < value).min(values.len() - 1);
    let nearer_below = above > 0 && value - values[above - 1] < (values[above] - value).abs();
    if nearer_below { above - 1 } else { above }
}

/// Gaps in rows of constant y.
fn placed(points: &[[f64; 3]], xs: &[f64], ys: &[f64]) -> Result<Vec<f64>, GapError> {
    let (columns, rows, count) = (xs.len(), ys.len(), points.len());
    // A hole is certain before anything as large as columns times rows is stored.
    let mut values = vec![f64::NAN; (columns * rows).min(4 * count + 16)];
    let mut seen_outside = false;
    for &[x, y, gap] in points {
        match values.get_mut(nearest(ys, y) * columns + nearest(xs, x)) {
            Some(value) if value.is_nan() => *value = gap,
            Some(_) => return Err(GapError::SamePlace { x, y }),
            None => seen_outside = true,
        }
    }
    match values.iter().position(|value| value.is_nan()) {
        None if !seen_outside && values.len() == columns * rows => Ok(values),
        hole => {
            let at = hole.unwrap_or(0);
            Err(GapError::Hole { x: xs[at % columns], y: ys[at / columns], columns, rows, count })
        }
    }
}

fn nodes(x: &[f64], y: &[f64], values: &[f64]) -> Vec<Node> {
    let columns = x.len();
    let by_x = along_rows(x, values);
    let by_y = along_columns(y, values, columns);
    // Limited slopes do not commute; the mean of both orders treats x and y alike.
    let (one, other) = (along_columns(y, &by_x, columns), along_rows(x, &by_y));
    (0..values.len())
        .map(|i| Node {
            value: values[i],
            by_x: by_x[i],
            by_y: by_y[i],
            mixed: f64::midpoint(one[i], other[i]),
        })
        .collect()
}

fn along_rows(x: &[f64], values: &[f64]) -> Vec<f64> {
    values.chunks(x.len()).flat_map(|row| slopes(x, row)).collect()
}

fn along_columns(y: &[f64], values: &[f64], columns: usize) -> Vec<f64> {
    let mut result = vec![0.0; values.len()];
    for column in 0..columns {
        let line: Vec<f64> = values.iter().skip(column).step_by(columns).copied().collect();
        for (row, slope) in slopes(y, &line).into_iter().enumerate() {
            result[row * columns + column] = slope;
        }
    }
    result
}
