//! Fig. 21: tractions in pure spin, and the point about which they turn.

use creepage::Creepage;
use creepage::Ellipse;
use creepage::coulomb::{Exact, Resolution};
use creepage::variational::{Variational, Weight};

use super::tractions::{self, View};
use crate::prelude::*;

pub(crate) const ITEM: Item = Item::new("fig21", "Fig. 21. Tractions in pure spin", make);

const SPINS: [f64; 3] = [0.53, 1.24, 2.65];

fn make() -> Result<Reproduction, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let theory = chapter_5(1.0, STEEL, 3, Weight::Elliptic)?;
    let detailed = contact::detailed(1.0, STEEL)?;
    let mut data = Data::new(["curve", "chi", "x", "y"]);
    let mut sheet = Sheet::new(ITEM.title)
        .note(axes::setting(&[("a/b", "1"), ("σ", "0.28"), ("ξ", "0"), ("η", "0")]))
        .note(Label::new(
            "Upper halves: chapter 5. Lower halves: full theory. The other halves mirror them.",
        ))
        .columns(2);
    for chi in SPINS {
        let views = [
            View::new(circle, &contact::chapter_5(&theory, spin(chi)), contact::EDGE),
            View::new(circle, &contact::full(&detailed, spin(chi)), contact::EDGE_OF_ELEMENTS),
        ];
        for (name, view) in ["M = 3", "full theory"].into_iter().zip(&views) {
            view.collect(&mut data, name, chi);
        }
        sheet = sheet.panel(halves(circle, chi, &views));
    }
    let centres = [by_chapter_5(&theory), by_full_theory()?];
    data_of_centres(&mut data, &centres);
    let sheet = tractions::key(sheet.panel(centre_panel(&centres)))
        .key(OF_1967, Label::new("centre of rotation, chapter 5"))
        .key(FULL, Label::new("centre of rotation, full theory"));
    Ok(Reproduction::figure(&sheet, caption(&centres), data, agreement(&theory, &centres)))
}

fn spin(chi: f64) -> Creepage {
    rolling_at([0.0, 0.0, chi])
}

fn halves(circle: Ellipse, chi: f64, [above, below]: &[View; 2]) -> Panel {
    let heading = Label::default().symbol("χ").plain(" = ").number(&chi.to_string());
    let panel = contact::panel(circle, heading);
    let panel = above.draw(panel, |[_, y]| y < 0.0);
    contact::edge(below.draw(panel, |[_, y]| y > 0.0), circle)
}

/// Where on the `x`-axis the traction vanishes, as far as it does within the contact.
fn centre(field: &Field) -> Option<f64> {
    let xs = spaced(-0.995, 0.995, 398);
    let points = field(&xs.iter().map(|x| [*x, 0.0]).collect::<Vec<_>>());
    let pair =
        points.windows(2).find(|pair| pair[0].traction[1] < 0.0 && pair[1].traction[1] >= 0.0)?;
    let [[x, y], [u, v]] = [&pair[0], &pair[1]].map(|point| [point.position[0], point.traction[1]]);
    Some(x + (u - x) * y / (y - v))
}

/// From the first spin of the figure on.
fn spins(count: u32) -> Vec<f64> {
    spaced(0.5, 10.0, count)
}

fn by_chapter_5(theory: &Variational) -> Curve {
    let at = |chi: f64| centre(&contact::chapter_5(theory, spin(chi))).map(|x| [chi, x]);
    spins(114).into_iter().filter_map(at).collect()
}

fn by_full_theory() -> Result<Curve, GalleryError> {
    let theory = Exact::new(&like_bodies(1.0, STEEL)?, Resolution::FINE)?;
    let centre = |chi: f64| centre(&contact::full(&theory, spin(chi))).map(|x| [chi, x]);
    Ok(spins(38).into_iter().filter_map(centre).collect())
}

fn data_of_centres(data: &mut Data, [of_1967, today]: &[Curve; 2]) {
    for (name, curve) in [("centre, M = 3", of_1967), ("centre, full theory", today)] {
        for [chi, x] in curve {
            data.points(name, &[*chi], [&[*x, 0.0]]);
        }
    }
}

fn centre_panel([of_1967, today]: &[Curve; 2]) -> Panel {
    let x = Axis::new([0.0, 10.0], axes::chi());
    let y = Axis::new(
        [-1.0, 0.0],
        Label::new("centre of rotation ").symbol("x").plain("/").symbol("a"),
    );
    let pole = Label::new("spin pole: ").symbol("x").plain(" = 0");
    Panel::new(x, y).height(250.0).curve(today.clone(), FULL).curve(of_1967.clone(), OF_1967).text(
        [0.3, -0.06],
        Anchor::Start,
        pole,
    )
}

fn caption([of_1967, today]: &[Curve; 2]) -> String {
    let enters = |curve: &Curve| curve.first().map_or(f64::NAN, |point| point[0]);
    format!(
        "Circular contact, σ = 0.28, no creepage; chapter 5 with M = 3, W = W₁. Lines of constant \
         traction in per cent of Coulomb's bound, and the traction's direction. The traction turns \
         about a point that enters the contact at a spin of about {:.1} by chapter 5 and {:.1} by \
         the full theory, and then goes towards the spin pole in the middle. Chapter 5 smears the \
         traction about that point: in the full theory it is at its bound nearly everywhere.",
        enters(of_1967),
        enters(today)
    )
}

fn agreement(theory: &Variational, [_, today]: &[Curve; 2]) -> Vec<Comparison> {
    let ours = SPINS.map(|chi| centre(&contact::chapter_5(theory, spin(chi))));
    let words = |x: Option<f64>| x.map_or("none".to_owned(), |x| format!("x/a = {x:.2}"));
    let full = |chi: f64| {
        let near = today.iter().find(|point| point[0] >= chi).filter(|point| point[0] < chi + 0.2);
        words(near.map(|point| point[1]))
    };
    let line = |k: usize, printed: &str, holds: bool| {
        let quantity = format!("point X = Y = 0 inside the contact, χ = {}", SPINS[k]);
        let outside = "it is about to enter: at the trailing edge the traction of chapter 5 is down \
            to a tenth of its bound";
        Comparison::claim(quantity, printed, words(ours[k]), holds)
            .because(outside)
            .remark(&format!("full theory: {}", full(SPINS[k])))
    };
    vec![
        line(0, "none", ours[0].is_none()),
        line(1, "enters", ours[1].is_some()),
        line(2, "nearer to the centre", ours[2] > ours[1]),
    ]
}
