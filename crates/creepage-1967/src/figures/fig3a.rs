//! Fig. 3a: the creepage coefficients.

use creepage::approximate::linear::CreepageCoefficients;
use creepage::approximate::vermeulen_johnson::VermeulenJohnson;

use super::coefficients::{Shown, picture};
use crate::prelude::*;
use crate::tables::coefficients::table3;

pub(crate) const ITEM: Item =
    Item::new("fig3a", "Fig. 3a. The creepage coefficients C11 and C22", make);

fn make() -> Result<Reproduction, GalleryError> {
    let printed = table3()?.concat();
    let shown = [
        Shown { index: "11", top: 10.0, of: |c| c.c11 },
        Shown { index: "22", top: 10.0, of: |c| c.c22 },
    ];
    let (sheet, data) = picture(ITEM.title, &shown, &printed)?;
    let caption = "Creepage coefficients of linear theory (called Fig. 8 in the thesis's list of symbols). \
         Lines: converged; marks: Table 3 as printed, of degree 5.";
    let mut agreement = johnson()?;
    agreement.extend(similarity()?);
    Ok(Reproduction::figure(&sheet, caption, data, agreement))
}

/// Half the range of Johnson's C11 over its middle: as well as he could measure.
pub(super) const SCATTER: f64 = 0.3 / 4.1;
pub(super) const EXPERIMENT: &str = "an experiment; Johnson's C11 has a range of ±7 %";

/// Johnson's experiments with steel balls, in the text of section 4.33.
fn johnson() -> Result<Vec<Comparison>, GalleryError> {
    let ours = CreepageCoefficients::new(&like_bodies(1.0, STEEL)?)?;
    let within = (3.8..=4.4).contains(&ours.c11);
    let line = Comparison::claim(
        "C11 of the circle, by Johnson's experiments",
        "3.8 to 4.4",
        format!("{:.3}", ours.c11),
        within,
    );
    let c22 = Comparison::number("C22 of the circle, by Johnson's experiments", "3.47", ours.c22);
    Ok(vec![line, c22.within(SCATTER * 3.47, EXPERIMENT)])
}

/// (4.91): Johnson's and Vermeulen's dependence on the ratio of the semi-axes.
fn similarity() -> Result<Vec<Comparison>, GalleryError> {
    let poisson = 0.25;
    let round = CreepageCoefficients::of_degree(&like_bodies(1.0, poisson)?, 5)?;
    let round_law = VermeulenJohnson::new(&like_bodies(1.0, poisson)?)?;
    let reason = "cut, not rounded, or from fewer digits";
    let mut lines = Vec::new();
    for (a_over_b, words, c22, c11) in
        [(0.2, "a/b = 0.2", "1.07", "1.05"), (5.0, "b/a = 0.2", "0.94", "0.93")]
    {
        let ours = CreepageCoefficients::of_degree(&like_bodies(a_over_b, poisson)?, 5)?;
        let law = VermeulenJohnson::new(&like_bodies(a_over_b, poisson)?)?;
        let lateral = round.c22 * round_law.psi() / law.psi() / ours.c22;
        let along = round.c11 * round_law.phi() / law.phi() / ours.c11;
        let name = |c: &str| format!("{c} by (4.90) over {c}, {words}, σ = 0.25");
        lines.push(Comparison::number(name("C22"), c22, lateral).within(0.01, reason));
        lines.push(Comparison::number(name("C11"), c11, along).within(0.01, reason));
    }
    Ok(lines)
}
