//! The page as text.

use std::fmt::Write;

use creepage::Region;
use creepage::halfspace::Polynomial;
use creepage::variational::MeshPoint;

use super::Page;
use super::network::Cell;
use super::numbers::{Numbers, angle};

/// The headings.
pub(super) struct Words {
    loops: &'static str,
    creepage: &'static str,
    change: &'static str,
    mean: &'static str,
    converged: &'static str,
    not_converged: &'static str,
    force: &'static str,
    traction: &'static str,
    slip: &'static str,
    aberrations: &'static str,
    aberration: &'static str,
    counts: &'static str,
    contact: &'static str,
    points: &'static str,
    line: &'static str,
}

pub(super) const DUTCH: Words = Words {
    loops: "SPIN,MICROSLIP,HOEK:",
    creepage: "UPSX,UPSY,PHI :",
    change: "TOEG GEV",
    mean: "GEMAFW:",
    converged: "CONVER",
    not_converged: "CYCLE",
    force: "FX FY MZ:",
    traction: "TAU",
    slip: "UVX",
    aberrations: "AFWIJKINGEN:",
    aberration: "T,S,Y,X,F,S,HOEK:",
    counts: "G,H,A,OPP:",
    contact: "CONTACTVLAK:",
    points: "T,S,INT,X,F,FW,ANF,WS,ARS:",
    line: "Y:",
};

pub(super) const ENGLISH: Words = Words {
    loops: "spin chi, creepage upsilon, angle alpha:",
    creepage: "creepage along x, along y, spin (units of P and Q):",
    change: "tolerance, change ",
    mean: "  mean integrand ",
    converged: "converged",
    not_converged: "NOT CONVERGED",
    force: "fx, fy, mz:",
    traction: "traction polynomials X', Y': coefficients of 1, x, y, x^2, xy, y^2, ... each",
    slip: "slip polynomials P/2, Q/2: coefficients of 1, x, y, x^2, xy, y^2, ... each",
    aberrations: "aberrations, points with T > S and |X'| > 1:",
    aberration: "T, S, line, column, |X'|, slip, angle from traction to slip:",
    counts: "areas of slip, areas of adhesion, aberrations, points in adhesion:",
    contact: "contact area: . slip, H adhesion, A aberration; area numbers, slip negative",
    points: "T, S, integrand, x, |X'|, traction, its angle, slip, its angle:",
    line: "y =",
};

pub(super) struct Writer<'a> {
    words: &'a Words,
    numbers: Numbers,
    text: String,
}

impl<'a> Writer<'a> {
    pub(super) fn new(words: &'a Words, numbers: Numbers) -> Self {
        Self { words, numbers, text: String::new() }
    }

    pub(super) fn page(mut self, page: &Page) -> String {
        self.creepage(page);
        self.iteration(page);
        self.force(page);
        let traction = page.theory.traction_polynomials(&page.found.tau);
        self.coefficients(
            self.words.traction,
            traction.as_ref().map_or(&[], |found| &found[..]),
            1.0,
        );
        let slip = page.theory.slip_polynomials(page.creepage, &page.found.tau);
        self.coefficients(self.words.slip, slip.as_ref().map_or(&[], |found| &found[..]), 0.5);
        self.areas(page);
        self.points(page);
        self.text
    }

    fn line(&mut self, line: &str) {
        self.text.push_str(line.trim_end());
        self.text.push('\n');
    }

    fn fixed(&self, values: impl IntoIterator<Item = f64>, decimals: usize) -> String {
        values.into_iter().map(|value| self.numbers.fixed(value, decimals)).collect()
    }

    fn creepage(&mut self, page: &Page) {
        let [chi, upsilon, alpha] = page.loops;
        let loops = self.fixed([chi, upsilon], 4) + &self.numbers.fixed(alpha, 2);
        self.line(&format!("{}{loops}", self.words.loops));
        let scale = page.theory.slip_scale();
        let spin = scale * page.creepage.chi() * page.theory.ellipse().major();
        let creepage =
            self.fixed([scale * page.creepage.xi(), scale * page.creepage.eta(), spin], 4);
        self.line(&format!("{}{creepage}", self.words.creepage));
    }

    fn iteration(&mut self, page: &Page) {
        for step in page.steps {
            let [tolerance, change, mean] = [step.tolerance, step.change, step.mean_integrand]
                .map(|value| self.numbers.floating(value));
            let words = self.words;
            self.line(&format!("{}{tolerance} {change} {}{mean}", words.change, words.mean));
        }
        let words = self.words;
        self.line(if page.converged() { words.converged } else { words.not_converged });
    }

    fn force(&mut self, page: &Page) {
        let force = page.found.solution.force;
        let force = self.fixed([force.fx, force.fy, force.mz], 4);
        self.line(&format!("{}{force}", self.words.force));
    }

    /// Six coefficients a line, the polynomials one after the other.
    fn coefficients(&mut self, heading: &str, polynomials: &[Polynomial], factor: f64) {
        self.line(heading);
        let coefficients: Vec<f64> =
            polynomials.iter().flat_map(|polynomial| polynomial.coefficients().to_vec()).collect();
        for six in coefficients.chunks(6) {
            let line: Vec<_> =
                six.iter().map(|value| self.numbers.floating(factor * value)).collect();
            self.line(&line.join(" "));
        }
    }

    fn areas(&mut self, page: &Page) {
        let network = page.network();
        self.line(self.words.aberrations);
        for (point, [x, y]) in page.found.points.iter().zip(network.places()) {
            if point.aberrant {
                self.aberration(point, [x, y], page.theory.slip_scale());
            }
        }
        let [slip, adhesion] = network.areas();
        let (aberrations, points) = (page.found.aberrations, network.adhering());
        self.line(&format!(
            "{} {slip:>4} {adhesion:>4} {aberrations:>4} {points:>4}",
            self.words.counts
        ));
        self.line(self.words.contact);
        for (number, cells) in network.lines() {
            let picture: String = cells.iter().map(|cell| symbol(cell.as_ref())).collect();
            let mut line = format!("{number:>4}  {picture}  ");
            for cell in cells {
                // Writing to a string cannot fail.
                let _ = write!(line, " {:>2}", cell.map_or(0, |cell| cell.area));
            }
            self.line(&line);
        }
    }

    fn aberration(&mut self, point: &MeshPoint, [x, y]: [isize; 2], slip_scale: f64) {
        let traction = point.field.traction;
        let slip = point.field.slip.map(|component| slip_scale * component);
        let turn = (angle(traction) - angle(slip)).abs();
        let between = turn.min(360.0 - turn);
        let [t, s] = [point.t, point.s].map(|value| self.numbers.floating(value));
        let sizes = self.fixed([point.reduced_traction, point.s.sqrt()], 4);
        let between = self.numbers.fixed(between, 1);
        self.line(&format!("{}{t} {s} {y:>4} {x:>4}{sizes}{between}", self.words.aberration));
    }

    fn points(&mut self, page: &Page) {
        if page.lines.is_empty() {
            return;
        }
        self.line(self.words.points);
        for &y in page.lines {
            self.line(&format!("{}{}", self.words.line, self.numbers.fixed(y, 4)));
            for point in page.line(y) {
                self.point(&point, page.theory.ellipse().major());
            }
        }
    }

    fn point(&mut self, point: &MeshPoint, major: f64) {
        let field = &point.field;
        let [tx, ty] = field.traction;
        let values: Vec<_> =
            [point.t, point.s, point.integrand].map(|value| self.numbers.floating(value)).into();
        let sizes =
            self.fixed([field.position[0] / major, point.reduced_traction, tx.hypot(ty)], 4);
        let of_traction = self.numbers.fixed(angle(field.traction), 1);
        let slip = self.numbers.fixed(point.s.sqrt(), 4);
        let of_slip = self.numbers.fixed(angle(field.slip), 1);
        self.line(&format!("{} {sizes}{of_traction}{slip}{of_slip}", values.join(" ")));
    }
}

fn symbol(cell: Option<&Cell>) -> char {
    match cell {
        None => ' ',
        Some(cell) if cell.aberrant => 'A',
        Some(cell) if cell.region == Region::Adhesion => 'H',
        Some(_) => '.',
    }
}
