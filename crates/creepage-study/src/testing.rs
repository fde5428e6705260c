//! Test theories in closed form, to report from, and contacts for them.

use creepage::theory::{Diagnostic, TheoryFacts};
use creepage::{
    Contact, Creepage, Ellipse, FieldPoint, Force, Hertz, Jacobian, Region, Solid, SolidPair,
    Solution, Solved, Statistics, Status, Theory, TheorySpec,
};
use creepage_plot::Boxes;

use crate::solve::SolvedTheory;
use crate::{AnyCase, Case, Caution, Given, SolvedCase};

/// Creepage along, across, and a spin whose pole lies inside every contact of [`case`].
pub(crate) const CURVE: [f64; 3] = [0.1, -0.1, 1.5];

pub(crate) fn creepage([xi, eta, chi]: [f64; 3]) -> Creepage {
    Creepage::new(xi, eta, chi).unwrap()
}

/// Steel on steel, 80 kN, a contact of `c = 6 mm`, friction 0.3.
pub(crate) fn case(a_over_b: f64, given: [f64; 3]) -> Case {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let unit = Ellipse::from_ratio(a_over_b).unwrap();
    let ellipse = Ellipse::new(6e-3 * unit.a(), 6e-3 * unit.b()).unwrap();
    let hertz = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3).unwrap();
    Case {
        hertz,
        friction: 0.3,
        contact: hertz.with_friction(0.3).unwrap(),
        solids: [steel; 2],
        given: Given::Creepage(creepage(given)),
        speed: None,
        smallest_radius: None,
        slip_by_groove: None,
        damage: None,
        heat: None,
        theory: TheorySpec::default(),
        sources: crate::Sources::default(),
    }
}

/// Kind of a test theory.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Trial {
    /// Complete sliding: traction at its bound along the rigid slip.
    Sliding(Status),
    /// An ellipse of adhesion, [`STICK`] times the contact's size, that touches the leading edge;
    /// traction along x, slip not given. Integrated, the traction gives `f_x = 1 - 0.7^3`.
    Sticking,
    /// Free rolling: adhesion everywhere, and no traction but rounding errors.
    Free,
}

/// Complete sliding, beyond the range of its theory.
pub(crate) const SLIDING: Trial = Trial::Sliding(Status::SpinTooLarge);

/// Size of the adhesion area of [`Trial::Sticking`] over that of the contact, in each direction.
pub(crate) const STICK: f64 = 0.7;

const FACTS: TheoryFacts = TheoryFacts {
    name: "test & trial",
    year: 1967,
    assumes: "",
    cost: "",
    error_percent: 0.0,
    good_for: "",
    options: &[],
    error_bars: false,
    derivative: false,
    dissimilar_bodies: false,
    moment: true,
    friction_laws: false,
};

/// A case solved by a trial.
pub(crate) fn solved(case: &Case, trial: Trial) -> SolvedCase {
    let theory: Box<dyn Theory> = Box::new(Tried { contact: case.contact.clone(), trial });
    let given = case.creepage().unwrap_or(creepage(CURVE));
    let held = SolvedTheory::new(theory, |theory| theory.solved(given));
    SolvedCase::new(AnyCase::Ellipse(case.clone()), &case.contact, &FACTS, held, |_, _| {
        let neglecting = TheorySpec::named("polach").unwrap();
        Caution::dissimilar(&neglecting, case.contact.kappa_over_mu()).into_iter().collect()
    })
}

/// The same in steel on steel.
pub(crate) fn report(a_over_b: f64, trial: Trial, given: [f64; 3]) -> SolvedCase {
    solved(&case(a_over_b, given), trial)
}

#[derive(Debug, Clone)]
struct Tried {
    contact: Contact,
    trial: Trial,
}

/// Height of the unit semi-ellipsoid over `(x, y)`.
fn ellipsoid(x: f64, y: f64) -> f64 {
    (1.0 - x * x - y * y).max(0.0).sqrt()
}

impl Tried {
    fn point(&self, creepage: Creepage, position: [f64; 2]) -> FieldPoint {
        let ellipse = self.contact.ellipse();
        let (x, y) = (position[0] / ellipse.a(), position[1] / ellipse.b());
        let inner = ellipsoid((x - 1.0 + STICK) / STICK, y / STICK);
        let rigid = creepage.rigid_slip(position);
        let magnitude = rigid[0].hypot(rigid[1]).max(f64::MIN_POSITIVE);
        let (traction, slip, sticks) = match self.trial {
            Trial::Sliding(_) => (rigid.map(|s| ellipsoid(x, y) * s / magnitude), rigid, false),
            Trial::Sticking => ([ellipsoid(x, y) - STICK * inner, 0.0], [f64::NAN; 2], inner > 0.0),
            Trial::Free => ([1e-17, 0.0], [0.0; 2], true),
        };
        let region = if sticks { Region::Adhesion } else { Region::Slip };
        FieldPoint { position, traction, slip, region }
    }
}

impl Theory for Tried {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solve(&self, _: Creepage) -> Solution {
        let (force, status) = match self.trial {
            Trial::Sliding(status) => (Force { fx: 0.6, fy: 0.5, mz: -0.1 }, status),
            Trial::Sticking => {
                (Force { fx: 1.0 - STICK.powi(3), ..Force::default() }, Status::Solved)
            }
            Trial::Free => (Force::default(), Status::Solved),
        };
        Solution { force, error: None, status, statistics: Statistics::default() }
    }

    fn jacobian(&self, _: Creepage) -> Option<Jacobian> {
        None
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        positions.iter().map(|position| self.point(creepage, *position)).collect()
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Box::new(TriedSolution { theory: self, creepage })
    }
}

struct TriedSolution<'t> {
    theory: &'t Tried,
    creepage: Creepage,
}

impl Solved for TriedSolution<'_> {
    fn creepage(&self) -> Creepage {
        self.creepage
    }

    fn solution(&self) -> Solution {
        self.theory.solve(self.creepage)
    }

    fn jacobian(&mut self) -> Option<Jacobian> {
        None
    }

    fn field(&self, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.theory.field(self.creepage, positions)
    }

    /// The centre, one point at `(a/2, b/4)`, one on the leading edge.
    fn points(&self) -> Option<Vec<FieldPoint>> {
        let ellipse = self.theory.contact.ellipse();
        let mesh = [[0.0, 0.0], [0.5 * ellipse.a(), 0.25 * ellipse.b()], [ellipse.a(), 0.0]];
        Some(self.field(&mesh))
    }

    fn dissipation(&self) -> Option<f64> {
        matches!(self.theory.trial, Trial::Sliding(_)).then_some(0.5)
    }

    fn diagnostics(&self) -> Vec<Diagnostic> {
        vec![
            Diagnostic { key: "mean_integrand", label: "mean of W T S", value: 1.25e-3 },
            Diagnostic { key: "unknown", label: "unknown", value: f64::NAN },
        ]
    }
}

/// Checks that nothing leaves the sheet, and that no two texts touch.
pub(crate) fn check_legible(svg: &str) -> Boxes {
    let boxes = Boxes::of(svg).unwrap();
    assert_eq!((boxes.off_the_sheet(), boxes.touching()), (None, None));
    boxes
}

/// Checks the same, and that no text covers the ellipse.
pub(crate) fn check_view(svg: &str, [centre, semi_axes]: [[f64; 2]; 2]) {
    let boxes = check_legible(svg);
    assert!(boxes.texts.len() > 15 && boxes.shapes.len() > 20);
    for b in &boxes.texts {
        let [[left, top], [right, bottom]] = [b.from, b.to];
        for place in [[left, top], [left, bottom], [right, top], [right, bottom]] {
            let [u, v] = [0, 1].map(|i| (place[i] - centre[i]) / semi_axes[i]);
            assert!(u.hypot(v) > 1.0, "{b:?}");
        }
    }
}
