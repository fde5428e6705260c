//! Table 5: how good degree 3 is, measured by degree 4.

use creepage::variational::Weight;

use super::weights::{MESH_OF_3, Spread, compared, forces, heading, row, spread, variants};
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("table5", "Table 5. Lateral force of degree 3 against that conjectured from 4", make);

/// Largest and mean of the print, for `W = 1` and `W = W1`.
const PRINTED: [(&str, [[&str; 2]; 2]); 2] = [
    ("pure lateral creepage", [["0.022", "0.009"], ["0.033", "0.011"]]),
    ("pure spin", [["0.044", "0.023"], ["0.029", "0.018"]]),
];
const WEIGHTS: [(Weight, &str); 2] = [(Weight::Uniform, "W = 1"), (Weight::Elliptic, "W = W1")];

fn make() -> Result<Reproduction, GalleryError> {
    let mut text = heading(ITEM.title);
    let mut data = Data::new(["case", "printed_max", "printed_mean", "max", "mean"]);
    let (mut agreement, mut ours) = (Vec::new(), Vec::new());
    for (kind, (name, printed)) in PRINTED.into_iter().enumerate() {
        for ((weight, words), printed) in WEIGHTS.into_iter().zip(printed) {
            let variants = variants(kind, |mesh, creepages| {
                let of = |weight| forces(mesh, 4, weight, creepages);
                let (one, two) = (of(Weight::Uniform)?, of(Weight::Elliptic)?);
                let conjectured: Vec<_> =
                    one.iter().zip(&two).map(|(a, b)| 0.5 * (a + b)).collect();
                Ok(spread(&conjectured, &forces(MESH_OF_3, 3, weight, creepages)?))
            })?;
            let name = format!("{name}, {words}");
            let [max, mean] = variants[0];
            let [p, q] = printed;
            data.push([(&name).into(), p.into(), q.into(), max.into(), mean.into()]);
            text.push_str(&row(&name, printed, variants[0]));
            agreement.extend(compared(&name, printed, &variants));
            ours.push(variants[0]);
        }
    }
    agreement.extend(ranking(&ours));
    let caption = "The lateral force of degree 3 against the mean of degree 4 with both weights, \
        circle, σ = 0.28. By this table the thesis chose M = 3 and W = W₁ for all that follows.";
    Ok(Reproduction::table(text.trim_end().to_owned(), caption, data, agreement))
}

/// "W = 1 performed better in the case of pure lateral creepage, and W = W1 in pure spin."
fn ranking(ours: &[Spread]) -> Vec<Comparison> {
    let line = |name: &str, better: &str, [good, bad]: [Spread; 2]| {
        Comparison::claim(
            format!("better weight in {name}"),
            better,
            format!("means {:.4} and {:.4}", good[1], bad[1]),
            good[1] < bad[1],
        )
    };
    vec![
        line("pure lateral creepage", "W = 1", [ours[0], ours[1]]),
        line("pure spin", "W = W1", [ours[3], ours[2]]),
    ]
}
