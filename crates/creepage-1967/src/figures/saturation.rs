//! Shared computation of Figs 10 and 11: forces when all of the contact slides as if rigid, over the position of the
//! spin pole, `xi/chi = upsilon cos alpha`, `eta/chi = upsilon sin alpha` (4.104).

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use creepage::InvalidValue;
use creepage::approximate::saturated::Saturated;
use creepage::coulomb::{Exact, Resolution};
use creepage::{Creepage, Force, Theory};

use crate::prelude::*;

/// Distances of the pole of which lines are drawn.
const UPSILONS: [f64; 6] = [0.25, 0.5, 0.75, 1.0, 1.5, 2.5];
const ALPHAS: [f64; 7] = [0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0];
/// Side of a diagram, two beside each other.
pub(super) const SIDE: f64 = 285.0;
/// Spin at which the full theory is asked.
const LARGE: f64 = 20.0;
const ASKED: [(f64, f64); 9] = [
    (0.5, 0.0),
    (0.5, 45.0),
    (0.5, 90.0),
    (1.0, 0.0),
    (1.0, 45.0),
    (1.0, 90.0),
    (1.5, 15.0),
    (1.5, 45.0),
    (1.5, 75.0),
];

/// One ratio of the semi-axes.
pub(super) struct Diagram {
    g: f64,
    theory: Saturated,
    /// `(upsilon, alpha)` and the force by the full theory at a large spin.
    full: Vec<([f64; 2], Force)>,
}

fn creepage(upsilon: f64, alpha: f64, chi: f64) -> Creepage {
    let (sin, cos) = alpha.to_radians().sin_cos();
    rolling_at([chi * upsilon * cos, chi * upsilon * sin, chi])
}

impl Diagram {
    pub(super) fn new(g: f64) -> Result<Self, InvalidValue> {
        let exact = Exact::new(&like_bodies(g, STEEL)?, Resolution::FINE)?;
        let solve = |(upsilon, alpha)| {
            ([upsilon, alpha], exact.solve(creepage(upsilon, alpha, LARGE)).force)
        };
        let full = ASKED.map(solve).to_vec();
        Ok(Self { g, theory: Saturated::new(&like_bodies(g, STEEL)?)?, full })
    }

    pub(super) fn at(&self, upsilon: f64, alpha: f64) -> Force {
        self.theory.solve(creepage(upsilon, alpha, 1.0)).force
    }

    /// Largest distance of the full theory's forces.
    fn apart(&self) -> f64 {
        let apart = |([upsilon, alpha], force): &([f64; 2], Force)| {
            let ours = self.at(*upsilon, *alpha);
            (ours.fx - force.fx).hypot(ours.fy - force.fy)
        };
        self.full.iter().map(apart).fold(0.0, f64::max)
    }

    /// Largest angle (degrees) between force and creepage.
    pub(super) fn largest_turn(&self) -> f64 {
        let turn = |upsilon: f64, alpha: f64| {
            let force = self.at(upsilon, alpha);
            (force.fy.atan2(force.fx).to_degrees() - alpha).abs()
        };
        let turns = UPSILONS.iter().flat_map(|u| ALPHAS.map(|alpha| turn(*u, alpha)));
        turns.fold(0.0, f64::max)
    }

    /// The repeated integrals (4.103) as the thesis computed them, against our closed forms and
    /// chord integrals.
    pub(super) fn quadrature(&self) -> Comparison {
        let mut worst: f64 = 0.0;
        for upsilon in UPSILONS {
            for alpha in ALPHAS {
                let (ours, theirs) = (self.at(upsilon, alpha), integrals(self.g, upsilon, alpha));
                worst = worst.max((ours.fx - theirs[0]).abs()).max((ours.fy - theirs[1]).abs());
            }
        }
        let ours = format!("within {worst:.0e} of (4.106) and of chords");
        // A square root at the pole limits the plain rule.
        Comparison::claim(
            format!("forces for g = {} by (4.103)", self.g),
            "the integrals",
            ours,
            worst < 1e-4,
        )
        .remark("the numbers themselves are in the picture of 1967 only")
    }

    fn panel(&self) -> Panel {
        let x = Axis::new([0.0, 1.12], axes::fx());
        let y = Axis::new([0.0, 1.12], axes::fy());
        let point = |force: Force| [force.fx, force.fy];
        let mut panel = Panel::new(x, y).to_scale();
        for alpha in ALPHAS {
            // From the pole in the centre to the pole at infinity.
            let shares = spaced(0.0, 0.5 * PI * 0.9999, 90);
            let radial = shares.iter().map(|share| point(self.at(share.tan(), alpha))).collect();
            panel = panel.curve(radial, SECOND.wide(1.9));
        }
        for upsilon in UPSILONS {
            let arc = spaced(0.0, 90.0, 60).into_iter().map(|alpha| point(self.at(upsilon, alpha)));
            let name = Label::default().number(&upsilon.to_string());
            panel = panel.named(arc.collect(), OF_1967.wide(1.9), name);
        }
        let rim =
            spaced(0.0, FRAC_PI_2, 60).iter().map(|angle| [angle.cos(), angle.sin()]).collect();
        panel = panel.curve(rim, OF_1967.wide(1.2));
        for alpha in &ALPHAS[1..6] {
            let (sin, cos) = alpha.to_radians().sin_cos();
            let at = [1.03 * cos, 1.03 * sin - 0.012];
            panel = panel.text(at, Anchor::Start, Label::new(&format!("{alpha}°")));
        }
        panel.marks(self.full.iter().map(|(_, force)| point(*force)).collect(), FULL_MARK)
    }
}

/// `f_x`, `f_y` by (4.103), the midpoint rule in both angles.
fn integrals(g: f64, upsilon: f64, alpha: f64) -> [f64; 2] {
    let (sin, cos) = alpha.to_radians().sin_cos();
    let (xi, eta, root) = (upsilon * cos, upsilon * sin, g.sqrt());
    let (thetas, psis) = (240_u32, 480_u32);
    let (dt, dp) = (FRAC_PI_2 / f64::from(thetas), TAU / f64::from(psis));
    let mut sum = [0.0; 2];
    for i in 0..thetas {
        let st = ((f64::from(i) + 0.5) * dt).sin();
        for j in 0..psis {
            let (sp, cp) = ((f64::from(j) + 0.5) * dp).sin_cos();
            let distance = (root * st * cp + eta).hypot(st * sp / root - xi);
            let weight = st * st * distance * dt * dp;
            sum = [sum[0] - weight * sp, sum[1] + weight * cp];
        }
    }
    [1.5 * root / PI * sum[0], 1.5 / (PI * root) * sum[1]]
}

/// The picture, a panel a ratio, and its numbers.
pub(super) fn picture(title: &str, diagrams: &[Diagram]) -> (Sheet, Data) {
    let mut data = Data::new(["theory", "g", "upsilon", "alpha_deg", "fx", "fy", "mz"]);
    let mut sheet = Sheet::new(title).columns(2);
    for diagram in diagrams {
        let mut push = |name: &str, upsilon: f64, alpha: f64, force: Force| {
            let numbers = [diagram.g, upsilon, alpha, force.fx, force.fy, force.mz];
            data.push([name.into()].into_iter().chain(numbers.map(Into::into)));
        };
        for upsilon in UPSILONS {
            for alpha in ALPHAS {
                push("large creepage and spin", upsilon, alpha, diagram.at(upsilon, alpha));
            }
        }
        for ([upsilon, alpha], force) in &diagram.full {
            push("full theory", *upsilon, *alpha, *force);
        }
        let heading = Label::default().symbol("g").plain(&format!(" = {}", diagram.g));
        sheet = sheet.panel(diagram.panel().heading(heading));
    }
    let full = Label::new("full theory, ").symbol("χ").plain(&format!(" = {LARGE}"));
    let sheet = sheet
        .key(OF_1967.wide(1.9), Label::default().symbol("υ").plain(" constant: number at its end"))
        .key(SECOND.wide(1.9), Label::default().symbol("α").plain(" constant: angle at its end"))
        .key(FULL_MARK, full);
    (sheet, data)
}

/// What is said below.
pub(super) fn caption(first: &str, diagrams: &[Diagram]) -> String {
    let apart = diagrams.iter().map(Diagram::apart).fold(0.0, f64::max);
    format!(
        "{first} Elastic deformation is neglected: the whole contact slides about the spin pole, \
         ξ/χ = υ cos α, η/χ = υ sin α (4.104). The points are the full theory at χ = {LARGE}. They \
         differ by at most {apart:.3} μN, because elasticity still adds a force towards +y. The \
         text of the thesis does not say which lines it draws; these are ours."
    )
}
