//! Table 3: the creepage and spin coefficients.

use creepage::approximate::linear::CreepageCoefficients;

use super::coefficients::{Coefficient, table3};
use super::entries::{Block, Table};
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("table3", "Table 3. The creepage and spin coefficients", make);

const KNOWN: &str = "by the thesis's own method, of degree 5, which gives the 222 others";

fn make() -> Result<Reproduction, GalleryError> {
    let printed = table3()?;
    let far = |one: &Coefficient| {
        let print: f64 = one.entry.printed.parse().unwrap_or(f64::NAN);
        (print / one.converged - 1.0).abs()
    };
    let worst = printed.iter().flatten().map(far).fold(0.0, f64::max);
    let mut agreement = vec![degree_7(&printed)?];
    agreement.extend(in_the_text()?);
    let blocks = printed.into_iter().zip(["a/b", "b/a"]).map(|(block, argument)| Block {
        argument,
        columns: 10,
        entries: block.into_iter().map(|coefficient| coefficient.entry).collect(),
    });
    let table = Table { item: ITEM, key: "g", blocks: blocks.collect() };
    let caption = format!(
        "Creepage and spin coefficients of linear theory by polynomials of degree 5, as the \
         thesis calculated them. The first row, a/b = 0, is analytic and is not computed. From \
         the converged values the print is off by {:.1} % at most.",
        100.0 * worst
    );
    let mut reproduction = table.reproduction(&caption, KNOWN);
    reproduction.agreement.extend(agreement);
    Ok(reproduction)
}

/// "The solution with 2K + v = 5 had a relative error of less than 1 % from that with 7."
fn degree_7(printed: &[Vec<Coefficient>; 2]) -> Result<Comparison, GalleryError> {
    let (mut worst, mut beyond): (f64, usize) = (0.0, 0);
    for one in printed.iter().flatten() {
        let of_degree = |degree| {
            CreepageCoefficients::of_degree(&like_bodies(one.a_over_b, one.poisson)?, degree)
        };
        let pick = |c: CreepageCoefficients| match &one.name[..] {
            "C11" => c.c11,
            "C22" => c.c22,
            "C23" => c.c23,
            _ => c.c33,
        };
        let error = (pick(of_degree(5)?) / pick(of_degree(7)?) - 1.0).abs();
        worst = worst.max(error);
        beyond += usize::from(error > 0.01);
    }
    let ours = format!("up to {:.1} %, above 1 % in {beyond} of 228 entries", 100.0 * worst);
    let line = Comparison::claim("degree 5 from degree 7", "less than 1 %", ours, beyond == 0);
    Ok(line.because("the thesis tried a few a/b only; the entries are at b/a = 0.1 and 0.2"))
}

/// The values of section 4.33 for a circle of steel.
fn in_the_text() -> Result<Vec<Comparison>, GalleryError> {
    let ours = CreepageCoefficients::of_degree(&like_bodies(1.0, STEEL)?, 5)?;
    let reason = "one unit of the last digit; between the entries for σ = 1/4 and 1/2 of Table 3 \
        a straight line gives the print";
    let line = |name: &str, printed, ours| {
        Comparison::number(format!("{name} of the circle, σ = 0.28"), printed, ours)
            .within(0.01, reason)
    };
    Ok(vec![
        line("C11", "4.22", ours.c11),
        line("C22", "3.71", ours.c22),
        line("C23", "1.49", ours.c23),
    ])
}
