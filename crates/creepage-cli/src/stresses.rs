//! `creepage stresses`: stresses inside a body.

use creepage::Status;
use creepage_study::{Sources, StressFileError, Stresses, read_points, stress_csv};

use crate::args::{BodyName, StressesArgs};
use crate::failure::Failure;
use crate::input::{read_any_case, read_text, sources_of, theories};
use crate::outcome::Outcome;
use crate::output::{print, say, say_written, to_json};

/// The files first, then the stresses, so that a wrong `--out` prints nothing.
pub(crate) fn run(args: &StressesArgs) -> Result<Outcome, Failure> {
    let points = points(args)?;
    let stresses = prepare(args)?;
    let failed = |source| Failure::Stresses { path: args.case.clone(), source };
    let asked = points.map(|points| stresses.at(&points)).transpose().map_err(failed)?;
    if let Some(directory) = &args.out {
        let sources = sources_of(&args.case).with(&Sources::new(&args.points));
        let written =
            stresses.write(directory, &sources, asked.as_deref()).map_err(|error| match error {
                StressFileError::Report(error) => error.into(),
                StressFileError::Stress(source) => failed(source),
            })?;
        say_written(&written);
    }
    for words in stresses.cautions(asked.as_deref().unwrap_or_default()) {
        say(&format!("caution: {words}"));
    }
    match &asked {
        Some(points) if args.json => print(&to_json(&stresses.json("points", points))?)?,
        Some(points) => print(&String::from_utf8_lossy(&stress_csv(points)?))?,
        None => {
            let largest = stresses.largest().map_err(failed)?;
            print(&if args.json {
                let point = stresses.at(&[largest.point]).map_err(failed)?;
                to_json(&stresses.json("largest_von_mises", &point))?
            } else {
                stresses.text(&largest)
            })?;
        }
    }
    let status = stresses.solved.solution().status;
    Ok(if status == Status::NotConverged { Outcome::Doubtful } else { Outcome::Done })
}

fn points(args: &StressesArgs) -> Result<Option<Vec<[f64; 3]>>, Failure> {
    let Some(path) = &args.points else {
        return Ok(None);
    };
    let wrong = |source| Failure::Points { path: path.clone(), source };
    read_points(&read_text(path)?).map(Some).map_err(wrong)
}

fn prepare(args: &StressesArgs) -> Result<Stresses, Failure> {
    let case = read_any_case(&args.case)?;
    case.lies_in_a_plane("stresses")
        .map_err(|source| Failure::Gap { path: args.case.clone(), source: Box::new(source) })?;
    let [upper, lower] = case.solids();
    let theories = theories(args.theory.as_slice(), &case)?;
    let solved = case
        .solve(theories.first())
        .map_err(|source| Failure::Gap { path: args.case.clone(), source: Box::new(source) })?;
    let (solid, body) = match args.body {
        BodyName::Lower => (lower, creepage::subsurface::Body::Lower),
        BodyName::Upper => (upper, creepage::subsurface::Body::Upper),
    };
    Stresses::new(solved, solid, body)
        .map_err(|source| Failure::Stresses { path: args.case.clone(), source })
}
