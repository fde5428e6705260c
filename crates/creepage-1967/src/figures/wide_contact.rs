//! Pure spin at `a/b = 5`, which the thesis gave up.

use creepage::coulomb::{Exact, Resolution};
use creepage::variational::{Chain, Procedure, Settings, TractionBound, Variational};
use creepage::{Creepage, Status};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("wide", "Pure spin at a/b = 5, dropped in section 5.33", make);

const A_OVER_B: f64 = 5.0;
const DOUBTFUL: Mark = Mark::open(Shape::Cross, "#8e24aa");

/// What the chain of 1967 gives at one spin.
struct Case {
    chi: f64,
    force: f64,
    converged: bool,
    /// Share of the points that are aberrations.
    aberrations: f64,
}

fn theory(bound: TractionBound) -> Result<Variational, GalleryError> {
    let settings = Settings { bound, ..Settings::default() };
    Ok(Variational::new(&like_bodies(A_OVER_B, STEEL)?, settings)?)
}

fn make() -> Result<Reproduction, GalleryError> {
    let spins = spaced(0.1, 10.0, 99);
    let creepages: Vec<_> = spins.iter().map(|chi| rolling_at([0.0, 0.0, *chi])).collect();
    let of_1967 = as_in_1967(&theory(TractionBound::Unchecked)?, &creepages);
    let kept = theory(TractionBound::Kept)?;
    let kept: Vec<_> = chained(&kept, &creepages);
    let kept = points(&spins, &kept, |force| force.fy);
    let exact = Exact::new(&like_bodies(A_OVER_B, STEEL)?, Resolution::STANDARD)?;
    let full: Vec<_> = exact.curve(&creepages).iter().map(|found| found.force).collect();
    let full = points(&spins, &full, |force| force.fy);
    let mut data = Data::new(["curve", "chi", "fy"]);
    let curve: Curve = of_1967.iter().map(|case| [case.chi, case.force]).collect();
    data.curve("M = 3, bound unchecked", &curve);
    data.curve("M = 3, bound kept", &kept);
    data.curve("full theory", &full);
    let caption = format!(
        "a/b = 5, σ = 0.28, no creepage; M = 3, W = W₁. Crosses: where Newton’s method as printed fails, \
         or a tenth of the points are aberrations. With the traction kept within its bound the same polynomials \
         are within {:.3} of μN of the full theory.",
        farthest(&kept, &full)
    );
    let agreement = vec![failure(&of_1967)];
    Ok(Reproduction::figure(&sheet(&of_1967, curve, kept, full), caption, data, agreement))
}

/// From large spin down, by Newton's method as printed.
fn as_in_1967(theory: &Variational, creepages: &[Creepage]) -> Vec<Case> {
    let mut chain = Chain::new(theory, Procedure::OF_1967);
    let solve = |creepage: &Creepage| {
        let found = chain.solve(*creepage, None).found;
        Case {
            chi: creepage.chi(),
            force: found.solution.force.fy,
            converged: found.solution.status != Status::NotConverged,
            aberrations: found.aberrations as f64 / found.points.len() as f64,
        }
    };
    let mut cases: Vec<_> = creepages.iter().rev().map(solve).collect();
    cases.reverse();
    cases
}

fn is_doubtful(case: &&Case) -> bool {
    !case.converged || case.aberrations > 0.1
}

/// "The numerical method failed to give results in a large portion of the curve of pure spin".
fn failure(cases: &[Case]) -> Comparison {
    let failed = cases.iter().filter(|case| !case.converged).count();
    let beyond = cases.iter().filter(|case| case.force > 1.0).count();
    let doubtful: Vec<_> = cases.iter().filter(is_doubtful).map(|case| case.chi).collect();
    let most = cases.iter().map(|case| case.aberrations).fold(0.0, f64::max);
    let [first, last] = [doubtful.first(), doubtful.last()].map(|chi| chi.copied().unwrap_or(0.0));
    let ours = format!(
        "of 100 spins up to 10, {failed} do not converge and {beyond} exceed μN; aberrations at up to {:.0} % of \
         the points; doubtful from χ = {first:.1} to {last:.1}",
        100.0 * most
    );
    Comparison::claim(
        "chapter 5 in pure spin, a/b = 5",
        "fails around the peak: no convergence, aberrations nearly everywhere, f above 1",
        ours,
        doubtful.len() > 10,
    )
    .because("a chain of steps of 0.1 in χ from full sliding down finds results that 1967 did not")
}

fn sheet(cases: &[Case], of_1967: Curve, kept: Curve, full: Curve) -> Sheet {
    // What exceeds the frame is cut.
    let panel = Panel::new(Axis::new([0.0, 10.0], axes::chi()), Axis::new([0.0, 1.2], axes::fy()))
        .height(400.0)
        .curve(of_1967, OF_1967)
        .curve(kept, THIRD)
        .curve(full, FULL)
        .marks(
            cases.iter().filter(is_doubtful).map(|case| [case.chi, case.force]).collect(),
            DOUBTFUL,
        );
    Sheet::new(ITEM.title)
        .note(axes::setting(&[("a/b", "5"), ("σ", "0.28"), ("ξ", "0"), ("η", "0")]))
        .panel(panel)
        .key(OF_1967, axes::degree(3).plain(", as in 1967"))
        .key(THIRD, axes::degree(3).plain(", bound kept"))
        .key(FULL, Label::new("full theory"))
        .key(DOUBTFUL, Label::new("failed, or with many aberrations"))
}
