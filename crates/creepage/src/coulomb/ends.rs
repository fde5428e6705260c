//! The steps over which the elastic slip of a strip's elements is taken.

use super::elements::Elements;

/// Ends of the steps along the middle line of a strip: the leading edge, then the elements' centres.
#[derive(Debug)]
pub(super) struct Ends {
    x: Vec<f64>,
    pub y: f64,
}

impl Ends {
    pub(super) fn new(elements: &Elements, strip: usize) -> Self {
        let [edge, y] = elements.middle_cut(strip, 0);
        let cut = |i: usize| elements.middle_cut(strip, i)[0];
        let centres = (0..elements.along).map(|i| 0.5 * (cut(i) + cut(i + 1)));
        Self { x: std::iter::once(edge).chain(centres).collect(), y }
    }

    pub(super) fn at(&self, end: usize) -> [f64; 2] {
        [self.x[end], self.y]
    }

    /// Length of the step that ends at `end`.
    pub(super) fn length(&self, end: usize) -> f64 {
        self.x[end - 1] - self.x[end]
    }

    fn middle(&self, step: usize) -> f64 {
        0.5 * (self.x[step] + self.x[step + 1])
    }

    /// How far to extrapolate from the middles of the last two steps to the element's centre;
    /// the first element has one step only.
    pub(super) fn extrapolation(&self, i: usize) -> f64 {
        if i == 0 {
            return 0.0;
        }
        (self.middle(i) - self.x[i + 1]) / (self.middle(i - 1) - self.middle(i))
    }

    /// Where the slip of each element is that of its steps extrapolated.
    pub(super) fn places(&self) -> impl Iterator<Item = [f64; 2]> {
        let places = std::iter::once(self.middle(0)).chain(self.x[2..].iter().copied());
        places.map(|x| [x, self.y])
    }

    /// Slip of each element by a displacement that is given at the ends.
    pub(super) fn slip(&self, displacement: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
        let over = move |step: usize, k: usize| {
            (displacement[step][k] - displacement[step + 1][k]) / self.length(step + 1)
        };
        (0..self.x.len() - 1).map(move |i| {
            let (by, before) = (self.extrapolation(i), i.saturating_sub(1));
            [0, 1].map(|k| over(i, k) + by * (over(i, k) - over(before, k)))
        })
    }
}
