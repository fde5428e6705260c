//! Proposition IV, 1: the border between adhesion and slip jumps.

use creepage::unsteady::Motion;

use super::rolling_on::{self, Station, border};
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("iv-1-border", "Proposition IV, 1. The border of adhesion jumps", make);

const FORCE: f64 = 0.64;
/// Steps (over `a`) of the picture, and of the same distance again.
const STEP_LENGTH: f64 = 0.0125;
const STATION_COUNT: usize = 160;
/// Carter's border.
const CARTER: Pen = Pen { dashes: "3 4", ..Pen::OUTLINE };

fn make() -> Result<Reproduction, GalleryError> {
    let run = |step: f64, steps: usize| {
        let mut rolling = rolling_on::shifted(FORCE)?;
        rolling_on::roll(&mut rolling, &Motion::forces(FORCE, 0.0), step, steps)
    };
    let (stations, finer) =
        (run(STEP_LENGTH, STATION_COUNT)?, run(0.5 * STEP_LENGTH, 2 * STATION_COUNT)?);
    let [(at, jump), (_, half)] = [&stations, &finer].map(|stations| largest(stations));
    let mut data = Data::new(rolling_on::COLUMNS);
    rolling_on::collect(&mut data, "shifted, force held", &stations);
    let claim = Comparison::claim(
        "border between adhesion and slip, cylinders",
        "can jump",
        format!(
            "it jumps by {jump:.2} a in a step of {STEP_LENGTH} a at q = {:.2} a, by {half:.2} a in a step half \
             as long",
            stations[at].rolled.distance
        ),
        // A border that moves steadily goes half as far in half a step; one element is 0.03 a wide.
        jump > 0.2 && half > 0.9 * jump,
    );
    let caption = format!(
        "Two cylinders, shifted by a force of {FORCE} μN and then rolled under it. What enters adheres at \
         once: at the leading edge the border is at x = a from the first step on. Within the old area of \
         adhesion a slip area opens near q = 0.75 a, and what adheres behind it vanishes. The border \
         jumps forward by {jump:.2} a and creeps back to Carter’s place (dotted). Full theory, line \
         contact, σ = 0.28; 100 elements along the contact. The thesis has the statement alone."
    );
    let agreement = vec![claim];
    Ok(Reproduction::figure(&sheet(&stations, at), caption, data, agreement))
}

/// The largest jump of the border from one step to the next: after which, and how far.
fn largest(stations: &[Station]) -> (usize, f64) {
    let jumps = stations.windows(2).map(|pair| (border(&pair[1]) - border(&pair[0])).abs());
    let all = jumps.enumerate().map(|(k, jump)| (k + 1, jump));
    all.fold((0, 0.0), |most, one| if one.1 > most.1 { one } else { most })
}

fn sheet(stations: &[Station], at: usize) -> Sheet {
    // Carter's border: the share of adhesion is the root of 1 - F.
    let carter = 1.0 - 2.0 * (1.0 - FORCE).sqrt();
    let last = STEP_LENGTH * STATION_COUNT as f64;
    let areas = rolling_on::panel(stations).curve(vec![[0.0, carter], [last, carter]], CARTER);
    let chosen = [(at.saturating_sub(2), OF_1967), (at + 2, FULL)];
    let x = Axis::new([-1.0, 1.0], Label::default().symbol("x").plain("/").symbol("a"));
    let y = Axis::new([0.0, 1.05], Label::default().symbol("X").plain("/").indexed("μp", "0"));
    let bound = spaced(-1.0, 1.0, 120).into_iter().map(|x| [x, (1.0 - x * x).sqrt()]).collect();
    let mut tractions = Panel::new(x, y).height(230.0).curve(bound, Pen::GUIDE);
    let mut sheet = Sheet::new(ITEM.title)
        .key(Fill::ADHESION, Label::new("adhesion"))
        .key(Fill::SLIP, Label::new("slip"))
        .key(CARTER, Label::new("border of steady rolling (Carter)"));
    for (k, pen) in chosen {
        let Some(station) = stations.get(k) else { continue };
        tractions = tractions.curve(station.traction.clone(), pen);
        let label = Label::new("traction at ").symbol("q").plain("/").symbol("a").plain(" = ");
        sheet = sheet.key(pen, label.number(&format!("{:.3}", station.rolled.distance)));
    }
    sheet.panel(areas).panel(tractions).key(Pen::GUIDE, Label::new("Coulomb’s bound"))
}
