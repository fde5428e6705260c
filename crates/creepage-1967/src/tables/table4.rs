//! Table 4: how much the weight function matters.

use creepage::variational::Weight;

use super::weights::{compared, forces, heading, row, spread, variants};
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("table4", "Table 4. Lateral force with W = 1 and with W = W1, degree 4", make);

const PRINTED: [(&str, [&str; 2]); 2] =
    [("pure lateral creepage", ["0.016", "0.009"]), ("pure spin", ["0.046", "0.016"])];

fn make() -> Result<Reproduction, GalleryError> {
    let mut text = heading(ITEM.title);
    let mut data = Data::new(["case", "printed_max", "printed_mean", "max", "mean"]);
    let mut agreement = Vec::new();
    for (kind, (name, printed)) in PRINTED.into_iter().enumerate() {
        let variants = variants(kind, |mesh, creepages| {
            let [uniform, elliptic] = [Weight::Uniform, Weight::Elliptic]
                .map(|weight| forces(mesh, 4, weight, creepages));
            Ok(spread(&uniform?, &elliptic?))
        })?;
        let [max, mean] = variants[0];
        data.push([name.into(), printed[0].into(), printed[1].into(), max.into(), mean.into()]);
        text.push_str(&row(name, printed, variants[0]));
        for [max, mean] in &variants[1..] {
            let other = "another mesh or set";
            data.push([
                format!("{name}, {other}").as_str().into(),
                "".into(),
                "".into(),
                (*max).into(),
                (*mean).into(),
            ]);
        }
        agreement.extend(compared(name, printed, &variants));
    }
    let caption = "The difference of the lateral force between the weights W = 1 and W = W₁ of \
        chapter 5, circle, σ = 0.28: it measures the uncertainty of degree 4. The mean is a \
        property of the method; the largest difference depends on the creepages tried.";
    Ok(Reproduction::table(text.trim_end().to_owned(), caption, data, agreement))
}
