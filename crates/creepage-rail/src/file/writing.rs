//! Writer of profile files, in mm to a tenth of a nanometre.

use std::fmt::Write as _;

use super::Format;
use crate::{Profile, Role};

/// The text of a profile file, with points at most `spacing` (m) apart and at every joint.
///
/// VAMPIRE gets the profile on both sides. Corners of the profile are found again by readers as
/// far as they turn by more than 30 degrees.
#[must_use]
pub fn write(profile: &Profile, format: Format, spacing: f64) -> String {
    let curve = profile.curve();
    let points = curve.stations(spacing.max(1e-6)).into_iter().map(|s| curve.at(s));
    let points: Vec<[f64; 2]> = points.map(|point| [1e3 * point.y, 1e3 * point.z]).collect();
    let role = profile.role();
    match format {
        Format::Simpack => simpack(role, &points),
        Format::MiniProf => miniprof(role, &points),
        Format::Vampire => vampire(role, &points),
        Format::Gensys => {
            "# y to the track side, z down; mm\n".to_owned() + &rows(&points, -1.0, 1.0)
        }
        Format::Columns => {
            "# y to the field side, z down; mm\n".to_owned() + &rows(&points, 1.0, 1.0)
        }
        Format::Json => json(role, &points),
    }
}

/// One line a point, its axes turned as the format has them.
fn rows(points: &[[f64; 2]], y_sense: f64, z_sense: f64) -> String {
    points.iter().fold(String::new(), |mut text, [y, z]| {
        // Nothing fails in writing to a string.
        let _ = writeln!(text, "{:.7} {:.7}", y_sense * y, z_sense * z);
        text
    })
}

fn json(role: Role, points: &[[f64; 2]]) -> String {
    let rows: Vec<String> = points.iter().map(|[y, z]| format!("[{y:.7}, {z:.7}]")).collect();
    let rows = rows.join(",\n  ");
    format!("{{\"profile\": \"{role}\", \"units\": \"mm\", \"points\": [\n  {rows}\n]}}\n")
}

fn simpack(role: Role, points: &[[f64; 2]]) -> String {
    let kind = i32::from(role == Role::Wheel);
    format!(
        "header.begin\n  version = 1\n  type = {kind} ! 0 rail, 1 wheel\nheader.end\n\
         spline.begin\n  units.len.f = 1000.0 ! mm\n  units.ang.f = 1.0\n\
         point.begin\n{}point.end\nspline.end\n",
        rows(points, 1.0, 1.0)
    )
}

fn miniprof(role: Role, points: &[[f64; 2]]) -> String {
    let count = points.len();
    format!(
        "ProgramName=creepage\nProfile={role}\nXYPoints={count}\nColumnDef=X,Y\n\n{}",
        rows(points, -1.0, -1.0)
    )
}

fn vampire(role: Role, points: &[[f64; 2]]) -> String {
    let heading = match role {
        Role::Wheel => "WHEELPROFILE\ncreepage\nTREADDATUM EUROPEAN 70.0\nFLANGEBACK 1360.0\n",
        Role::Rail => "RAILPROFILE\ncreepage\nGAUGEPOINT EUROPEAN 14.0\nGAUGE 1435.0\n",
    };
    points.iter().fold(heading.to_owned(), |mut text, [y, z]| {
        let _ = writeln!(text, "{:.7} {z:.7} {y:.7} {z:.7}", -y);
        text
    })
}
