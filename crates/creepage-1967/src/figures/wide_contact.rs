//! Pure spin at `a/b = 5`, which the thesis gave up.

use creepage::coulomb::{Exact, Resolution};
use creepage::variational::{
    Chain, Procedure, Settings, Start, TractionBound, Variational, VariationalSolution,
};
use creepage::{Creepage, Status};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("wide", "Pure spin at a/b = 5, dropped in section 5.33", make);

const A_OVER_B: f64 = 5.0;
/// Largest spin of the picture.
const LARGEST: f64 = 5.0;
const TOP: f64 = 1.2;
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
    let spins = spaced(0.05, LARGEST, 99);
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
         have a peak, and are within {:.3} of μN of the full theory. Of low degree they cannot follow the \
         strong spin of so wide a contact.",
        farthest(&kept, &full)
    );
    let cold = cold(&theory(TractionBound::Unchecked)?, &creepages);
    let agreement = vec![failure(&cold, &full), care(&cold, &of_1967)];
    Ok(Reproduction::figure(&sheet(&of_1967, curve, kept, full), caption, data, agreement))
}

impl Case {
    fn new(creepage: &Creepage, found: &VariationalSolution) -> Self {
        Self {
            chi: creepage.chi(),
            force: found.solution.force.fy,
            converged: found.solution.status != Status::NotConverged,
            aberrations: found.aberrations as f64 / found.points.len() as f64,
        }
    }
}

/// From large spin down, by Newton's method as printed.
fn as_in_1967(theory: &Variational, creepages: &[Creepage]) -> Vec<Case> {
    let mut chain = Chain::new(theory, Procedure::OF_1967);
    let solve = |creepage: &Creepage| Case::new(creepage, &chain.solve(*creepage, None).found);
    let mut cases: Vec<_> = creepages.iter().rev().map(solve).collect();
    cases.reverse();
    cases
}

/// Each spin by itself from full sliding.
fn cold(theory: &Variational, creepages: &[Creepage]) -> Vec<Case> {
    let solve = |creepage: &Creepage| {
        let start = &Start::FullSliding;
        Case::new(creepage, &theory.solve_by(Procedure::OF_1967, *creepage, start, None))
    };
    creepages.iter().map(solve).collect()
}

impl Case {
    fn is_doubtful(&self) -> bool {
        !self.converged || self.aberrations > 0.1
    }
}

/// Spins that fail, of those that exceed the force of friction, and the most aberrations.
fn trouble(cases: &[Case]) -> (usize, String) {
    let failed = cases.iter().filter(|case| !case.converged).count();
    let beyond = cases.iter().filter(|case| case.force > 1.0).count();
    let most = cases.iter().map(|case| case.aberrations).fold(0.0, f64::max);
    let doubtful: Vec<_> =
        cases.iter().filter(|case| case.is_doubtful()).map(|case| case.chi).collect();
    let [first, last] = [doubtful.first(), doubtful.last()].map(|chi| chi.copied().unwrap_or(0.0));
    let words = format!(
        "{} of 100 spins, from χ = {first:.1} to {last:.1}: {failed} do not converge, {beyond} exceed μN, \
         aberrations at up to {:.0} % of the points",
        doubtful.len(),
        100.0 * most
    );
    (doubtful.len(), words)
}

/// "The numerical method failed to give results in a large portion of the curve of pure spin, situated
/// around the peak": it did not converge, or had aberrations and a force above that of friction.
fn failure(cold: &[Case], full: &Curve) -> Comparison {
    let (_, words) = trouble(cold);
    let peak = full.iter().max_by(|one, two| one[1].total_cmp(&two[1])).map_or(0.0, |peak| peak[0]);
    let fails = |kind: fn(&Case) -> bool| cold.iter().any(kind);
    let near = cold.iter().filter(|case| (case.chi - peak).abs() < 0.26 && case.is_doubtful());
    Comparison::claim(
        "chapter 5 in pure spin, a/b = 5, each spin from full sliding",
        "fails around the peak: no convergence, or many aberrations and f above 1",
        words,
        // Half of the eleven spins about the peak.
        fails(|case| !case.converged) && fails(|case| case.force > 1.0) && near.count() > 5,
    )
    .because("the thesis does not say which spins, steps and starts it tried")
    .remark(&format!("the full theory has its peak at χ = {peak:.2}"))
}

/// "By taking special care in the choice of the initial value, the trouble could be concentrated in a
/// smaller portion of the curve".
fn care(cold: &[Case], chained: &[Case]) -> Comparison {
    let (without, _) = trouble(cold);
    let (count, words) = trouble(chained);
    Comparison::claim(
        "the same in a chain from large spin down",
        "with special care trouble in a smaller portion, and many aberrations",
        words,
        count < without && count > 0,
    )
    .because("the thesis does not say which spins, steps and starts it tried")
}

fn sheet(cases: &[Case], of_1967: Curve, kept: Curve, full: Curve) -> Sheet {
    // Curves are cut at the frame, marks put below its top.
    let doubtful = cases.iter().filter(|case| case.is_doubtful());
    let panel =
        Panel::new(Axis::new([0.0, LARGEST], axes::chi()), Axis::new([0.0, TOP], axes::fy()))
            .height(400.0)
            .named(of_1967, OF_1967, Label::new("as in 1967"))
            .named(kept, THIRD, Label::new("bound kept"))
            .named(full, FULL, Label::new("full theory"))
            .marks(doubtful.map(|case| [case.chi, case.force.min(0.98 * TOP)]).collect(), DOUBTFUL);
    Sheet::new(ITEM.title)
        .note(axes::setting(&[("a/b", "5"), ("σ", "0.28"), ("ξ", "0"), ("η", "0")]))
        .panel(panel)
        .key(DOUBTFUL, Label::new("failed, or with many aberrations"))
}
