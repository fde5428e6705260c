//! Proposition IV, 2: the area of adhesion splits in two or more.

use creepage::unsteady::Motion;

use super::rolling_on::{self, Station, parts};
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("iv-2-split", "Proposition IV, 2. The area of adhesion splits", make);

/// Length of a step, over `a`.
const STEP_LENGTH: f64 = 0.0125;

fn make() -> Result<Reproduction, GalleryError> {
    let cases = [creeping()?, reversed()?];
    let names = ["ξ = 6 after a shift by 0.64 μN", "force of ±0.8 μN that changes sign"];
    let mut data = Data::new(rolling_on::COLUMNS);
    for (name, stations) in names.iter().zip(&cases) {
        rolling_on::collect(&mut data, name, stations);
    }
    let most = cases.iter().flatten().map(parts).max().unwrap_or(0);
    let claim = |printed: &str, least: usize| {
        Comparison::claim(
            format!("area of adhesion, cylinders, {least} parts or more"),
            printed,
            format!("up to {most} parts at a time"),
            most >= least,
        )
    };
    let agreement = vec![claim("can split into two parts", 2), claim("or into more", 3)];
    let caption = "Two cylinders. Above, shifted by 0.64 μN and then rolled with a creepage ξ = 6, \
        one and a half times that of bodily sliding. A slip area opens in the middle of what adheres. \
        Below, a force of 0.8 μN that changes sign each 0.25 a. What the leading edge takes in under one \
        force slips again under the next, at a place that moves back with the material. Parts narrower \
        than 0.08 a, two or three elements, are not counted. Full theory, line contact, σ = 0.28. The \
        thesis has the statement alone.";
    Ok(Reproduction::figure(&sheet(&cases), caption, data, agreement))
}

fn creeping() -> Result<Vec<Station>, GalleryError> {
    let mut rolling = rolling_on::shifted(0.64)?;
    let motion = Motion::from(rolling_at([6.0, 0.0, 0.0]));
    Ok(rolling_on::roll(&mut rolling, &motion, STEP_LENGTH, 96)?)
}

/// A force that changes its sign time and again.
fn reversed() -> Result<Vec<Station>, GalleryError> {
    let mut rolling = rolling_on::shifted(0.0)?;
    let mut stations = Vec::new();
    for sign in [1.0, -1.0, 1.0, -1.0, 1.0, -1.0] {
        let motion = Motion::forces(sign * 0.8, 0.0);
        stations.extend(rolling_on::roll(&mut rolling, &motion, STEP_LENGTH, 20)?);
    }
    Ok(stations)
}

fn sheet(cases: &[Vec<Station>; 2]) -> Sheet {
    let headings = [
        Label::default().symbol("ξ").plain(" = 6 after a shift by 0.64 ").symbol("μN"),
        Label::new("force of ±0.8 ").symbol("μN").plain(" that changes sign"),
    ];
    let mut sheet = Sheet::new(ITEM.title);
    for (stations, heading) in cases.iter().zip(headings) {
        sheet = sheet.panel(rolling_on::panel(stations).heading(heading));
    }
    sheet.key(Fill::ADHESION, Label::new("adhesion")).key(Fill::SLIP, Label::new("slip"))
}
