//! Closed-form theories to report from, and contacts for them.

use creepage::rolling::{Creepage, FieldPoint, Force, Region, Solution, Status, Theory};
use creepage::{Ellipse, Hertz, Solid, SolidPair};
use creepage_plot::Boxes;
use creepage_theories::Detail;

use crate::report::{Answer, Report};

/// Creepage along, across, and a spin whose pole lies inside every contact of [`contact`].
pub(crate) const CURVE: Creepage = Creepage { xi: 0.1, eta: -0.1, chi: 1.5 };

/// Steel on steel, 80 kN, a contact of `c = 6 mm`.
pub(crate) fn contact(a_over_b: f64) -> Hertz {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let unit = Ellipse::from_ratio(a_over_b).unwrap();
    let ellipse = Ellipse::new(6e-3 * unit.a(), 6e-3 * unit.b()).unwrap();
    Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3).unwrap()
}

/// Height of the unit semi-ellipsoid over `(x, y)`.
fn ellipsoid(x: f64, y: f64) -> f64 {
    (1.0 - x * x - y * y).max(0.0).sqrt()
}

/// Complete sliding: traction at its bound along the rigid slip.
pub(crate) struct Sliding {
    pub(crate) ellipse: Ellipse,
    pub(crate) status: Status,
}

/// [`Sliding`] in [`contact`].
pub(crate) fn sliding(a_over_b: f64) -> Sliding {
    Sliding { ellipse: Ellipse::from_ratio(a_over_b).unwrap(), status: Status::SpinTooLarge }
}

impl Theory for Sliding {
    fn solve(&self, _: Creepage) -> Solution {
        Solution { force: Force { fx: 0.6, fy: 0.5, mz: -0.1 }, status: self.status }
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let point = |&position: &[f64; 2]| {
            let slip = creepage.rigid_slip(position);
            let magnitude = slip[0].hypot(slip[1]).max(f64::MIN_POSITIVE);
            let bound = ellipsoid(position[0] / self.ellipse.a(), position[1] / self.ellipse.b());
            let traction = slip.map(|component| bound * component / magnitude);
            FieldPoint { position, traction, slip, region: Region::Slip }
        };
        positions.iter().map(point).collect()
    }
}

/// An ellipse of adhesion, 0.7 times the contact's size, that touches the leading edge;
/// traction along x, slip not given. Integrated, the traction gives `f_x = 1 - 0.7^3`.
pub(crate) struct Sticking {
    ellipse: Ellipse,
}

/// Size of the adhesion area of [`Sticking`] over that of the contact, in each direction.
pub(crate) const STICK: f64 = 0.7;

/// [`Sticking`] in [`contact`].
pub(crate) fn sticking(a_over_b: f64) -> Sticking {
    Sticking { ellipse: Ellipse::from_ratio(a_over_b).unwrap() }
}

impl Theory for Sticking {
    fn solve(&self, _: Creepage) -> Solution {
        let force = Force { fx: 1.0 - STICK.powi(3), fy: 0.0, mz: 0.0 };
        Solution { force, status: Status::Solved }
    }

    fn field(&self, _: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let point = |&position: &[f64; 2]| {
            let (x, y) = (position[0] / self.ellipse.a(), position[1] / self.ellipse.b());
            let inner = ellipsoid((x - 1.0 + STICK) / STICK, y / STICK);
            FieldPoint {
                position,
                traction: [ellipsoid(x, y) - STICK * inner, 0.0],
                slip: [f64::NAN; 2],
                region: if inner > 0.0 { Region::Adhesion } else { Region::Slip },
            }
        };
        positions.iter().map(point).collect()
    }
}

/// Free rolling: adhesion everywhere, and no traction but rounding errors.
pub(crate) struct Free;

impl Theory for Free {
    fn solve(&self, _: Creepage) -> Solution {
        Solution { force: Force::default(), status: Status::Solved }
    }

    fn field(&self, _: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let (traction, slip) = ([1e-17, 0.0], [0.0; 2]);
        let point = |&position: &[f64; 2]| FieldPoint {
            position,
            traction,
            slip,
            region: Region::Adhesion,
        };
        positions.iter().map(point).collect()
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

/// Three mesh points: the centre, one at `(a/2, b/4)`, one on the leading edge.
pub(crate) fn report<'a>(
    contact: &'a Hertz,
    theory: &'a dyn Theory,
    creepage: Creepage,
) -> Report<'a> {
    let ellipse = Ellipse::from_ratio(contact.ellipse().ratio()).unwrap();
    let mesh = [[0.0, 0.0], [0.5 * ellipse.a(), 0.25 * ellipse.b()], [ellipse.a(), 0.0]];
    let answer = Answer {
        creepage,
        theory_name: "test & trial",
        theory,
        solution: theory.solve(creepage),
        points: theory.field(creepage, &mesh),
        details: vec![
            Detail { key: "mean_integrand", label: "mean of W T S", value: 1.25e-3 },
            Detail { key: "unknown", label: "unknown", value: f64::NAN },
        ],
    };
    Report::new(contact, 0.3, answer).unwrap()
}
