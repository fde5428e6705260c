//! Fig. 3b: the coefficients of spin.

use creepage::approximate::linear::CreepageCoefficients;

use super::coefficients::{POISSON, Shown, picture};
use super::fig3a::{EXPERIMENT, SCATTER};
use crate::prelude::*;
use crate::tables::coefficients::table3;

pub(crate) const ITEM: Item =
    Item::new("fig3b", "Fig. 3b. The coefficients C23 = −C32 and C33", make);

fn make() -> Result<Reproduction, GalleryError> {
    let printed = table3()?.concat();
    let shown = [
        Shown { index: "23", top: 5.0, of: |c| c.c23 },
        Shown { index: "33", top: 5.0, of: |c| c.c33 },
    ];
    let (sheet, data) = picture(ITEM.title, &shown, &printed)?;
    let caption = "Creepage and spin coefficients of linear theory (called Fig. 8 in the thesis's \
        list of symbols). Lines: converged; marks: Table 3 as printed, of degree 5. C23 leaves the \
        picture as b/a goes to 0, C33 as a/b does. That C32 = −C23, for which the thesis had no \
        explanation, follows from the reciprocal theorem. Johnson's own theory of infinitesimal spin on a circle \
        (J. Appl. Mech. 25, 1958, p. 332), with which the thesis says that there is a fairly large discrepancy, is not beside \
        it. Its formula is not in the thesis, and was not to be had. His measured C23 is.";
    Ok(Reproduction::figure(&sheet, caption, data, vec![reciprocity()?, johnson()?]))
}

/// "The feature that C32 = -C23 also persists in the case of elliptical contact areas."
fn reciprocity() -> Result<Comparison, GalleryError> {
    let mut worst: f64 = 0.0;
    for a_over_b in [0.1, 0.3, 0.5, 0.7, 1.0, 1.0 / 0.7, 2.0, 1.0 / 0.3, 10.0] {
        for (poisson, _) in POISSON {
            let c = CreepageCoefficients::of_degree(&like_bodies(a_over_b, poisson)?, 5)?;
            worst = worst.max((c.c32 / c.c23 + 1.0).abs());
        }
    }
    let ours = format!("to {:.1} % in degree 5", 100.0 * worst);
    // One unit of the three digits printed is up to 1 %.
    Ok(Comparison::claim("C32 = −C23 for ellipses", "persists", ours, worst < 0.01))
}

fn johnson() -> Result<Comparison, GalleryError> {
    let ours = CreepageCoefficients::new(&like_bodies(1.0, STEEL)?)?.c23;
    let line = Comparison::number("C23 of the circle, by Johnson's experiments", "1.53", ours);
    Ok(line.within(SCATTER * 1.53, EXPERIMENT))
}
