//! `[gap] roller`: a roller by its design.

use std::f64::consts::{FRAC_PI_2, PI};

use creepage::gap::{Gap, GapError, Rolling};
use creepage::{InvalidValue, SolidPair};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::CaseError;

/// Points between the edges, closer to each other near these, and points of each edge.
const INNER: u32 = 240;
const EDGE: u32 = 24;
/// Part of an edge's radius to which it is round: it falls by .8 of the radius, more than any approach.
const REACH: f64 = 0.98;
/// Beyond, the side goes on along the edge's tangent, over this part of the length in as many points.
const EXTENSION: f64 = 0.3;
const SIDE: u32 = 12;
/// The radius of an edge where none is given (m).
const USUAL_EDGE: f64 = 2e-4;

/// A roller on a straight body, with its axis along y. What the profile falls by is the sum of crown, logarithmic
/// profile, end relief and rounded edges.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct RollerSection {
    /// Radius (m).
    radius: f64,
    /// Radius along rolling of what it rolls on (m): flat where it is left out, negative where it is hollow, as an
    /// outer ring.
    on: Option<f64>,
    /// Length with its rounded edges (m).
    pub(super) length: f64,
    /// Radius of a crown all along (m).
    crown: Option<f64>,
    /// Load (N) for which a logarithmic profile (Lundberg's) makes the pressure the same all along.
    logarithmic: Option<f64>,
    /// Relief of both ends.
    #[serde(default)]
    #[schemars(with = "ReliefSection")]
    relief: Option<ReliefSection>,
    /// Angle between the axes in the plane of both normals (rad): positive brings the end at +y nearer.
    #[serde(default)]
    tilt: f64,
    /// Radius of the rounded edges (m); 2e-4 by default.
    edge: Option<f64>,
}

/// Ends that fall as arcs from where the middle part is left.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ReliefSection {
    /// Length of each, with the edge (m).
    length: f64,
    /// Radius of the arc (m).
    radius: f64,
}

impl RollerSection {
    /// Half the length between the rounded edges (m).
    pub(super) fn half_straight(&self) -> f64 {
        0.5 * self.length - self.edge.unwrap_or(USUAL_EDGE)
    }

    pub(super) fn gap(&self, pair: SolidPair) -> Result<Result<Gap, GapError>, CaseError> {
        self.check()?;
        let y = self.stations();
        let gap: Vec<f64> = y.iter().map(|y| self.fall(*y, pair) - self.tilt * y).collect();
        let curvature = self.radius.recip() + self.on.map_or(0.0, f64::recip);
        Ok(Gap::section(&y, &gap, Rolling::Radius(curvature.recip())))
    }

    fn check(&self) -> Result<(), CaseError> {
        let of = |quantity: &'static str, value: f64, is_valid: bool, valid: &'static str| {
            let invalid = InvalidValue { quantity, value, valid };
            if is_valid { Ok(()) } else { Err(CaseError::Invalid { section: "gap", invalid }) }
        };
        let Self { radius, on, length, crown, logarithmic, relief, tilt, edge } = *self;
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let half = 0.5 * length;
        of("roller radius", radius, positive(radius), "above 0 m")?;
        of("roller length", length, positive(length), "above 0 m")?;
        if let Some(on) = on {
            let fits = on.is_finite() && (on > 0.0 || on < -radius);
            of("roller on", on, fits, "above 0 m, or below minus the roller's radius")?;
        }
        let edge = edge.unwrap_or(USUAL_EDGE);
        of("roller edge", edge, positive(edge) && edge < 0.25 * length, "above 0, below length/4")?;
        if let Some(crown) = crown {
            of("roller crown", crown, positive(crown) && crown >= length, "the length at least")?;
        }
        if let Some(load) = logarithmic {
            of("roller logarithmic", load, positive(load), "above 0 N")?;
        }
        if let Some(ReliefSection { length, radius }) = relief {
            let fits = length > edge && length < half;
            of("roller relief length", length, fits, "above edge, below half the roller's length")?;
            of(
                "roller relief radius",
                radius,
                radius.is_finite() && radius >= length,
                "its length at least",
            )?;
        }
        of("roller tilt", tilt, tilt.abs() <= 0.05, "-0.05 to 0.05 rad")
    }

    /// Places along the roller, up to where the edges have fallen by more than any approach.
    fn stations(&self) -> Vec<f64> {
        let (half, inner) = (0.5 * self.length, self.half_straight());
        let even = |k: u32, count: u32| f64::from(k) / f64::from(count);
        let middle = (0..=INNER).map(|k| inner * (FRAC_PI_2 * (2.0 * even(k, INNER) - 1.0)).sin());
        let turned = |k: u32| (half - inner) * (REACH.asin() * even(k, EDGE)).sin();
        let end = inner + turned(EDGE);
        let beside = |k: u32| end + EXTENSION * self.length * even(k, SIDE) * even(k, SIDE);
        let outer = || (1..=EDGE).map(|k| inner + turned(k)).chain((1..=SIDE).map(beside));
        let low: Vec<f64> = outer().map(|y| -y).collect();
        low.into_iter().rev().chain(middle).chain(outer()).collect()
    }

    /// What the profile falls by at `y` (m).
    fn fall(&self, y: f64, pair: SolidPair) -> f64 {
        // Of an arc: without the difference of large numbers.
        let arc =
            |radius: f64, by: f64| by * by / (radius + ((radius - by) * (radius + by)).sqrt());
        let (half, inner) = (0.5 * self.length, self.half_straight());
        // The side falls by its own slope alone.
        let end = inner + REACH * (half - inner);
        let beside = (y.abs() - end).max(0.0);
        let y = y.clamp(-end, end);
        let logarithmic = self.logarithmic.map_or(0.0, |load| {
            // Of a line load w, `w/(pi E*) ln(1/(1 - (2y/L)^2))`: G. Lundberg, Forschung Ing.-Wesen 10 (1939).
            let modulus = pair.shear_modulus() / (1.0 - pair.poisson());
            -load / self.length / (PI * modulus) * (-(y / half) * (y / half)).ln_1p()
        });
        let crown = self.crown.map_or(0.0, |radius| arc(radius, y));
        let relief = self
            .relief
            .map_or(0.0, |relief| arc(relief.radius, (y.abs() - half + relief.length).max(0.0)));
        let edge = arc(half - inner, (y.abs() - inner).max(0.0));
        crown + logarithmic + relief + edge + REACH.asin().tan() * beside
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::{Caution, GapFile, SolvedCase, solve_gap};

    /// A roller of 10 mm radius on a flat, steel, with more keys.
    fn solved(roller: &str, load: f64) -> SolvedCase {
        let text = format!(
            "upper = {{ shear_modulus = 82e9, poisson = 0.28 }}
            lower = {{ shear_modulus = 82e9, poisson = 0.28 }}
            gap = {{ roller = {{ {roller} }} }}
            contact = {{ normal_force = {load:?}, friction = 0.1 }}
            creepage = {{ longitudinal = 1e-3 }}
            solve = {{ theory = 'fastsim' }}"
        );
        solve_gap(&GapFile::read(&text).unwrap().case("".as_ref()).unwrap()).unwrap()
    }

    const MODULUS: f64 = 82e9 / 0.72;

    /// Pressure in the middle line at places over half the length.
    fn pressures(solved: &SolvedCase, half: f64, places: &[f64]) -> Vec<f64> {
        let contact = solved.areas().unwrap();
        places.iter().map(|part| contact.pressure(0.0, part * half)).collect()
    }

    fn end(solved: &SolvedCase) -> Option<(f64, bool)> {
        solved.cautions.iter().find_map(|caution| match caution {
            Caution::RollerEnd { peak, middle, on_edge, .. } => Some((peak / middle, *on_edge)),
            _ => None,
        })
    }

    /// A straight roller is a line contact in its middle: `p0 = sqrt(w E*/(pi R))`, with peaks at its edges.
    #[test]
    fn the_middle_of_a_straight_roller_is_a_line_contact() {
        let solved = solved("radius = 0.01, length = 0.02", 10e3);
        let contact = solved.areas().unwrap();
        // The load of a short piece in the middle, and its length.
        let load: f64 = contact
            .patches()
            .iter()
            .flat_map(creepage::normal::Patch::bands)
            .map(|band| band.moments([-1e-3, 1e-3], [-1.0, 1.0]).force)
            .sum::<f64>()
            / 2e-3;
        let peak = (load * MODULUS / (PI * 0.01)).sqrt();
        let found = contact.pressure(0.0, 0.0);
        // Line contact to first order: the load varies along over more than ten half-widths; rows are interpolated.
        assert!((found / peak - 1.0).abs() < 0.01, "{found:e} {peak:e}");
        // Ends carry more than their part: the middle has less than the mean.
        let mean = 10e3 / 0.02;
        assert!(load < 1.02 * mean && load > 0.9 * mean, "{load:e} {mean:e}");
        let (times, on_edge) = end(&solved).unwrap();
        assert!(times > 1.2 && on_edge, "{times}");
    }

    /// Lundberg's profile under its load: the pressure of a line contact all along, to some per cent. Under half of
    /// it the ends carry less.
    #[test]
    fn a_logarithmic_profile_makes_the_pressure_level() {
        let design = 10e3;
        let roller = "radius = 0.01, length = 0.02, logarithmic = 10e3, edge = 1e-4";
        let level = solved(roller, design);
        let right = (design / 0.02 * MODULUS / (PI * 0.01)).sqrt();
        for (part, found) in [0.0, 0.3, 0.6, 0.8, 0.9].iter().zip(pressures(
            &level,
            0.01,
            &[0.0, 0.3, 0.6, 0.8, 0.9],
        )) {
            // The integral of line loads is level to .2 % up to .9; the half-space beyond the ends is finite here by
            // edges of 1 % of the half-length, and the width .1 mm is of the order of the edge.
            assert!((found / right - 1.0).abs() < 0.03, "{part} {}", found / right);
        }
        let half = pressures(&solved(roller, 0.5 * design), 0.01, &[0.0, 0.9]);
        assert!(half[1] < 0.95 * half[0], "{half:?}");
        let over = solved(roller, 2.0 * design);
        let (times, _) = end(&over).unwrap();
        assert!(times > 1.05, "{times}");
    }

    /// A crown that ends within the length is Hertz's ellipse.
    #[test]
    fn a_crown_is_an_ellipse() {
        use creepage::{Hertz, Radii, Solid, SolidPair};
        let solved = solved("radius = 0.01, length = 0.02, crown = 0.5", 500.0);
        let steel = Solid::new(82e9, 0.28).unwrap();
        let [crown, flat] =
            [0.5, f64::INFINITY].map(|lateral| Radii { rolling: f64::INFINITY, lateral });
        let hertz = Hertz::new(
            SolidPair::new(steel, steel),
            Radii { rolling: 0.01, ..crown },
            flat,
            0.0,
            500.0,
        )
        .unwrap();
        let found = solved.areas().unwrap().peak_pressure().value;
        // The standard resolution's error of the pressure.
        assert!((found / hertz.peak_pressure() - 1.0).abs() < 5e-3, "{found:e}");
        assert_eq!(end(&solved), None);
    }

    /// Tilted, the load moves to the end that is brought nearer; the hollow race opens less.
    #[test]
    fn a_tilted_roller_is_pressed_at_one_end() {
        let roller = "radius = 0.01, length = 0.02, logarithmic = 10e3, tilt = 1e-3";
        let tilted = solved(roller, 10e3);
        assert!(tilted.areas().unwrap().centroid()[1] > 1e-3);
        assert!(end(&tilted).unwrap().0 > 1.1);
        let other = solved(&roller.replace("1e-3", "-1e-3"), 10e3);
        let [one, two] = [&tilted, &other].map(|solved| solved.areas().unwrap().centroid()[1]);
        // Mirror images, to the solver's end.
        assert!((one + two).abs() < 1e-3 * one, "{one} {two}");
        let [ring, flat] = ["radius = 0.01, on = -0.04", "radius = 0.013333333333333334"]
            .map(|radii| solved(&format!("{radii}, length = 0.02, logarithmic = 10e3"), 10e3));
        let [ring, flat] = [ring, flat].map(|solved| solved.areas().unwrap().area().value);
        assert!((ring / flat - 1.0).abs() < 1e-9, "{ring:e} {flat:e}");
    }

    #[test]
    fn what_is_no_roller_is_refused() {
        for (roller, said) in [
            ("radius = -0.01, length = 0.02", "roller radius"),
            ("radius = 0.01, length = 0.0", "roller length"),
            ("radius = 0.01, length = 0.02, on = -0.005", "roller on"),
            ("radius = 0.01, length = 0.02, edge = 0.006", "roller edge"),
            ("radius = 0.01, length = 0.02, crown = 0.01", "roller crown"),
            ("radius = 0.01, length = 0.02, logarithmic = -1.0", "roller logarithmic"),
            ("radius = 0.01, length = 0.02, tilt = 1.0", "roller tilt"),
            (
                "radius = 0.01, length = 0.02, relief = { length = 0.02, radius = 1.0 }",
                "relief length",
            ),
            (
                "radius = 0.01, length = 0.02, relief = { length = 2e-3, radius = 1e-3 }",
                "relief radius",
            ),
            ("radius = 0.01, length = 0.02, crow = 0.01", "crow"),
        ] {
            let text = format!(
                "upper = {{ shear_modulus = 82e9, poisson = 0.28 }}
                lower = {{ shear_modulus = 82e9, poisson = 0.28 }}
                gap = {{ roller = {{ {roller} }} }}
                contact = {{ normal_force = 1e3, friction = 0.1 }}
                creepage = {{ longitudinal = 1e-3 }}"
            );
            let read = GapFile::read(&text).and_then(|file| file.case("".as_ref()));
            let words = read.unwrap_err().to_string();
            assert!(words.contains(said), "{words}");
        }
    }
}
