//! The paradox of 4.3: what the linear theory dissipates without slip.

use creepage::approximate::linear::Linear;
use creepage::{Creepage, Theory};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("edge-energy", "4.3. Energy lost at the trailing edge without slip", make);

/// Unit creepages, and their symbols.
const UNITS: [(&str, [f64; 3]); 3] =
    [("\u{3be}", [1.0, 0.0, 0.0]), ("\u{3b7}", [0.0, 1.0, 0.0]), ("\u{3c7}", [0.0, 0.0, 1.0])];
const RATIOS: [f64; 3] = [0.2, 1.0, 5.0];

fn make() -> Result<Reproduction, GalleryError> {
    let mut data = Data::new(["creepage", "a_over_b", "y_over_b", "energy_density"]);
    let mut worst: f64 = 0.0;
    let mut leading: f64 = 0.0;
    let mut curves = Vec::new();
    for ratio in RATIOS {
        let linear = Linear::new(&like_bodies(ratio, STEEL)?)?;
        for (symbol, parts) in UNITS {
            let creepage = rolling_at(parts);
            let (power, energy) = (linear.solved(creepage).power(), linear.edge_energy(creepage));
            worst = worst.max((energy.total() / power - 1.0).abs());
            leading = leading.max((energy.leading / power).abs());
            let curve = along(&linear, creepage, power);
            data.points(symbol, &[ratio], &curve);
            if (ratio - 1.0).abs() < f64::EPSILON {
                curves.push((symbol, curve));
            }
        }
    }
    let line = Comparison::claim(
        "energy lost at the edge by (4.41), (4.62) over force times creepage",
        "dissipation without slip: a paradox",
        format!("equal to {worst:.0e}; {leading:.0e} of it at the leading edge"),
        worst < 1e-5 && leading < 1e-5,
    );
    let reason =
        "coefficients are interpolated to 1e-6; a/b = 0.2, 1, 5, unit \u{3be}, \u{3b7} and \u{3c7}";
    let caption = "Where the elastic energy goes that the linear theory loses though nothing slips: along \
        the trailing edge, in parts of force times creepage, per length of y/b. Circular contact, \
        \u{3c3} = 0.28. The infinite traction inside the edge and the slip outside it, (4.41), are as at the \
        tip of a crack. The surfaces are torn apart there, and the energy set free is lost for the theory. \
        It equals force times creepage, so that the balance holds; in truth a narrow area of slip at the \
        trailing edge turns it to heat.";
    Ok(Reproduction::figure(&sheet(&curves), caption, data, vec![line.because(reason)]))
}

fn along(linear: &Linear, creepage: Creepage, power: f64) -> Curve {
    let at = |y: &f64| [*y, linear.edge_energy_density(creepage, *y) / power];
    spaced(-1.0, 1.0, 80).iter().map(at).collect()
}

fn sheet(curves: &[(&str, Curve)]) -> Sheet {
    let x = Axis::new([-1.0, 1.0], Label::default().symbol("y").plain("/").symbol("b"));
    let top = curves.iter().flat_map(|(_, curve)| curve).map(|point| point[1]).fold(0.0, f64::max);
    let y =
        Axis::new([0.0, 1.06 * top], Label::new("energy lost, in parts of force times creepage"));
    let mut panel = Panel::new(x, y).height(360.0);
    for (k, (_, curve)) in curves.iter().enumerate() {
        panel = panel.curve(curve.clone(), Pen::of(k));
    }
    let mut sheet = Sheet::new(ITEM.title)
        .note(axes::setting(&[("a/b", "1"), ("\u{3c3}", "0.28")]))
        .panel(panel);
    for (k, (symbol, _)) in curves.iter().enumerate() {
        sheet = sheet.key(Pen::of(k), Label::new("by ").symbol(symbol).plain(" alone"));
    }
    sheet
}
