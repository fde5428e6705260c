//! The page that the programme of 1967 printed of every case (5.24, Fig. 12): what a person needs
//! to judge a solution of chapter 5.

mod network;
mod numbers;
mod text;

use creepage::variational::{MeshPoint, NewtonStep, Variational, VariationalSolution};
use creepage::{Creepage, Status};

use network::Network;
use numbers::Numbers;

/// One solved case of a series, to be printed.
#[derive(Debug, Clone, Copy)]
pub struct Page<'a> {
    /// The theory that solved it.
    pub theory: &'a Variational,
    /// Spin, magnitude of the creepage, and its angle from the rolling direction (degrees).
    pub loops: [f64; 3],
    /// Creepage and spin.
    pub creepage: Creepage,
    /// The course of the iteration.
    pub steps: &'a [NewtonStep],
    /// The solution.
    pub found: &'a VariationalSolution,
    /// Cells of the mesh along `x` and `y`.
    pub mesh: [usize; 2],
    /// Lines `y`, in units of the major semi-axis, of which the points are listed.
    pub lines: &'a [f64],
}

/// Headings and numbers of the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PageStyle {
    /// English headings, numbers as they are written today.
    English,
    /// The Dutch headings and the number formats of 1967.
    Of1967,
}

impl Page<'_> {
    /// The page, line for line in the order of Fig. 12.
    #[must_use]
    pub fn text(&self, style: PageStyle) -> String {
        let (words, numbers) = match style {
            PageStyle::English => (&text::ENGLISH, Numbers::Modern),
            PageStyle::Of1967 => (&text::DUTCH, Numbers::Of1967),
        };
        text::Writer::new(words, numbers).page(self)
    }

    fn converged(&self) -> bool {
        self.found.solution.status != Status::NotConverged
    }

    fn network(&self) -> Network {
        let ellipse = self.theory.ellipse();
        let places = self.found.points.iter().map(|point| {
            let [x, y] = point.field.position;
            [x / ellipse.a(), y / ellipse.b()]
        });
        Network::new(self.mesh, places, &self.found.points)
    }

    /// The points of the line at `y` (in units of the major semi-axis): the mesh's own in `x`, as
    /// far as they lie inside the ellipse.
    fn line(&self, y: f64) -> Vec<MeshPoint> {
        let ellipse = self.theory.ellipse();
        let y = y * ellipse.major();
        let cells = self.mesh[0];
        let x = |i: usize| ellipse.a() * ((2 * i + 1) as f64 / cells as f64 - 1.0);
        let inside = |x: &f64| (x / ellipse.a()).powi(2) + (y / ellipse.b()).powi(2) < 1.0;
        let positions: Vec<_> = (0..cells).map(x).filter(inside).map(|x| [x, y]).collect();
        self.theory.points(self.creepage, &self.found.tau, &positions)
    }
}
