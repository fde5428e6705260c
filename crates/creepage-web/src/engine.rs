//! Engine of the explorer: answers of the page's contact in numbers and words.

use std::fmt::Display;

use creepage::theory::{ExactOptions, NamedResolution, ResolutionSpec};
use creepage::{
    Contact, Creepage, Ellipse, FieldPoint, Hertz, Radii, Region, Solid, SolidPair, Solved, Theory,
    TheorySpec,
};

use crate::cells::{Cell, cells};

type Failure = Box<dyn std::error::Error>;

/// Two bodies, the upper first, in SI units.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bodies {
    pub(crate) modulus: [f64; 2],
    pub(crate) poisson: [f64; 2],
    pub(crate) rolling: [f64; 2],
    pub(crate) lateral: [f64; 2],
    pub(crate) load: f64,
    pub(crate) friction: f64,
}

impl Bodies {
    fn hertz(&self) -> Result<Hertz, Failure> {
        let solid = |k: usize| Solid::new(self.modulus[k], self.poisson[k]);
        let [upper, lower] =
            [0, 1].map(|k| Radii { rolling: self.rolling[k], lateral: self.lateral[k] });
        let pair = SolidPair::new(solid(0)?, solid(1)?);
        Ok(Hertz::new(pair, upper, lower, 0.0, self.load)?)
    }
}

/// The theories prepared for one contact, and the last answer.
#[derive(Default)]
pub(crate) struct Engine {
    contact: Option<Contact>,
    /// Each by its number and resolution, since it was first asked.
    prepared: Vec<([usize; 2], Box<dyn Theory>)>,
    pub(crate) numbers: Vec<f64>,
    pub(crate) words: String,
}

impl Engine {
    pub(crate) fn theories(&mut self) {
        let line = |spec: &TheorySpec| {
            let facts = spec.facts();
            format!("{}\t{}\t{}\n", facts.name, facts.assumes, facts.good_for)
        };
        self.words = TheorySpec::all().iter().map(line).collect();
    }

    pub(crate) fn ellipse(&mut self, a_over_b: f64, poisson: f64) -> bool {
        let contact = Ellipse::from_ratio(a_over_b)
            .and_then(|ellipse| Contact::new(ellipse, poisson))
            .map(|contact| (contact.clone(), contact.ellipse()));
        self.set_contact(contact)
    }

    pub(crate) fn bodies(&mut self, bodies: &Bodies) -> bool {
        let contact = bodies
            .hertz()
            .and_then(|hertz| Ok((hertz.with_friction(bodies.friction)?, hertz.ellipse())));
        self.set_contact(contact)
    }

    /// From here on all is asked of this contact; the ellipse is in metres where it has dimensions.
    fn set_contact<E: Display>(&mut self, contact: Result<(Contact, Ellipse), E>) -> bool {
        self.prepared.clear();
        self.contact = None;
        let Some((contact, ellipse)) = self.checked(contact) else { return false };
        let units = contact.scaling();
        self.numbers = vec![
            ellipse.a(),
            ellipse.b(),
            units.length,
            units.slip,
            units.force,
            units.traction,
            contact.poisson(),
            contact.kappa_over_mu(),
        ];
        self.contact = Some(contact);
        true
    }

    pub(crate) fn solve(&mut self, theory: [usize; 2], creepage: [f64; 3]) -> bool {
        let answer = self.asked(theory, creepage, |_, solved| numbers(solved));
        self.answer(answer)
    }

    pub(crate) fn show(&mut self, theory: [usize; 2], creepage: [f64; 3]) -> bool {
        let answer = self.asked(theory, creepage, |ellipse, solved| {
            let cells: Vec<Cell> = cells(ellipse).collect();
            let middles: Vec<[f64; 2]> = cells.iter().map(|cell| cell.middle).collect();
            let points = solved.field(&middles);
            let drawn = cells.iter().zip(&points).flat_map(|(cell, point)| drawn(cell, point));
            numbers(solved).into_iter().chain(drawn).collect()
        });
        self.answer(answer)
    }

    /// What the contact solved by a theory says, and the status.
    fn asked(
        &mut self,
        theory: [usize; 2],
        [xi, eta, chi]: [f64; 3],
        ask: impl FnOnce(Ellipse, &dyn Solved) -> Vec<f64>,
    ) -> Result<(Vec<f64>, &'static str), Failure> {
        let creepage = Creepage::new(xi, eta, chi)?;
        let theory = self.theory(theory)?;
        let solved = theory.solved(creepage);
        let numbers = ask(theory.contact().ellipse(), &*solved);
        Ok((numbers, solved.solution().status.name()))
    }

    fn answer(&mut self, answer: Result<(Vec<f64>, &'static str), Failure>) -> bool {
        let Some((numbers, status)) = self.checked(answer) else { return false };
        (self.numbers, self.words) = (numbers, status.into());
        true
    }

    fn theory(&mut self, wanted: [usize; 2]) -> Result<&dyn Theory, Failure> {
        let contact = self.contact.clone().ok_or("no contact is given")?;
        if !self.prepared.iter().any(|(theory, _)| *theory == wanted) {
            self.prepared.push((wanted, specified(wanted)?.prepare_on_ellipse(&contact)?));
        }
        let found = self.prepared.iter().find(|(theory, _)| *theory == wanted);
        Ok(&*found.ok_or("no such theory")?.1)
    }

    /// The value, or nothing with the reason in words.
    fn checked<T, E: Display>(&mut self, result: Result<T, E>) -> Option<T> {
        self.numbers.clear();
        result.map_err(|error| self.words = error.to_string()).ok()
    }
}

fn specified([theory, resolution]: [usize; 2]) -> Result<TheorySpec, Failure> {
    let spec = TheorySpec::all().into_iter().nth(theory).ok_or("no such theory")?;
    Ok(match (spec, resolution) {
        (TheorySpec::Exact(_), 0) => exact(NamedResolution::Fast),
        (TheorySpec::Exact(_), 2) => exact(NamedResolution::Fine),
        (spec, _) => spec,
    })
}

fn exact(resolution: NamedResolution) -> TheorySpec {
    let resolution = ResolutionSpec::Named(resolution);
    TheorySpec::Exact(ExactOptions { resolution, ..ExactOptions::default() })
}

fn numbers(solved: &dyn Solved) -> Vec<f64> {
    let solution = solved.solution();
    let errors = solution.error.map_or([f64::NAN; 3], |error| error.components());
    let mut numbers = solution.force.components().to_vec();
    numbers.extend(errors);
    numbers.push(solved.power());
    numbers
}

fn drawn(cell: &Cell, point: &FieldPoint) -> impl Iterator<Item = f64> {
    let slips = f64::from(u8::from(point.region == Region::Slip));
    let corners = cell.corners.into_iter().flatten();
    corners.chain(point.traction).chain(point.slip).chain([slips])
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: usize = 7;
    const CELL: usize = 13;

    #[test]
    fn forces_are_the_library_s() {
        let mut engine = Engine::default();
        assert!(engine.ellipse(1.5, 0.28));
        let contact = Contact::new(Ellipse::from_ratio(1.5).unwrap(), 0.28).unwrap();
        let creepage = Creepage::new(0.4, -0.2, 0.5).unwrap();
        for (theory, spec) in TheorySpec::all().iter().enumerate() {
            let own = spec.prepare(&contact).unwrap().solve(creepage);
            assert!(engine.solve([theory, 1], [0.4, -0.2, 0.5]), "{}", engine.words);
            assert_eq!(engine.numbers[..3], own.force.components());
            assert_eq!(engine.words, own.status.name());
        }
    }

    /// The traction of the cells, over their areas, is the force: elements are coarser than cells, so
    /// to a per cent.
    #[test]
    fn the_picture_adds_up_to_the_force() {
        let mut engine = Engine::default();
        assert!(engine.ellipse(0.7, 0.28) && engine.show([0, 1], [0.5, 0.1, 0.3]));
        let (head, drawn) = engine.numbers.split_at(HEAD);
        let mut sums = [0.0; 2];
        for cell in drawn.chunks_exact(CELL) {
            let [p, q] = [cell[4] - cell[0], cell[5] - cell[1]];
            let [r, s] = [cell[6] - cell[2], cell[7] - cell[3]];
            let area = 0.5 * (p * s - q * r);
            sums[0] += 1.5 / std::f64::consts::PI * area * cell[8];
            sums[1] += 1.5 / std::f64::consts::PI * area * cell[9];
        }
        assert!((sums[0] - head[0]).abs() < 0.01 && (sums[1] - head[1]).abs() < 0.01, "{sums:?}");
    }

    #[test]
    fn nonsense_is_answered_in_words() {
        let mut engine = Engine::default();
        assert!(!engine.solve([0, 1], [0.0; 3]) && engine.words.contains("no contact"));
        assert!(!engine.ellipse(1.0, 0.7) && engine.words.contains("poisson"));
        assert!(engine.ellipse(1.0, 0.3));
        assert!(!engine.solve([0, 1], [f64::NAN, 0.0, 0.0]) && engine.words.contains("xi"));
        assert!(!engine.solve([99, 1], [0.0; 3]) && engine.words.contains("no such theory"));
    }
}
