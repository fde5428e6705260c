//! Report of a solved bearing: text, JSON, files and the pictures of the hottest ball's contacts.

use std::path::{Path, PathBuf};

use creepage::Status;
use creepage_bearing::{SolvedBall, SolvedBearing, SolvedRace};

use super::file::{BearingCase, BearingCaseError};
use crate::Caution;
use crate::error::ReportError;
use crate::file_set::write_all;
use crate::gap::{AreaField, AreasPicture};
use crate::report::{
    Report, ReportPart, Shown,
    Unit::{
        Metre, MetrePerSecond, Newton, NewtonMetre, One, Pascal, Radian, RadianPerMetre,
        RadianPerSecond, Share, Watt,
    },
    Written, words,
};
use crate::sources::Sources;
use crate::text::{Lines, status_words};

/// A solved bearing with the case that it solves.
#[derive(Debug, Clone)]
pub struct BearingReport {
    /// The case.
    pub case: BearingCase,
    /// The solution.
    pub solved: SolvedBearing,
}

const RACES: [&str; 2] = ["inner", "outer"];
const DEGREES: f64 = 180.0 / std::f64::consts::PI;

impl BearingReport {
    /// Solves a case.
    ///
    /// # Errors
    /// As [`BearingCase::solve`].
    pub fn solve(case: BearingCase) -> Result<Self, BearingCaseError> {
        let solved = case.solve()?;
        Ok(Self { case, solved })
    }

    fn contacts(&self) -> impl Iterator<Item = (&SolvedBall, usize, &SolvedRace)> {
        self.solved.balls.iter().flat_map(|ball| {
            let races = ball.races.iter().enumerate();
            races.filter_map(move |(race, found)| Some((ball, race, found.as_ref()?)))
        })
    }

    /// Cautions, each once.
    #[must_use]
    pub fn cautions(&self) -> Vec<Caution> {
        let status = self.solved.status();
        let mut all: Vec<Caution> =
            (status != Status::Solved).then_some(Caution::Status(status)).into_iter().collect();
        let contacts = || self.contacts();
        let peak = |found: &SolvedRace| found.hertz.peak_pressure();
        let worst = contacts().max_by(|(.., a), (.., b)| peak(a).total_cmp(&peak(b)));
        if let Some((.., found)) = worst {
            all.extend(Caution::yields(peak(found), found.hertz.pair().shear_modulus(), None));
        }
        all.extend(Caution::large_friction(self.case.bearing.friction));
        // From one end of the ellipse to the other the surface turns.
        let turn = |(_, race, found): (&SolvedBall, usize, &SolvedRace)| {
            2.0 * (found.hertz.ellipse().b() / self.case.bearing.conforming_radius(race))
                .min(1.0)
                .asin()
        };
        all.extend(Caution::turns(contacts().map(turn).fold(0.0, f64::max)));
        all
    }

    fn heat_of(&self, race: usize) -> f64 {
        let own = self.contacts().filter(|(_, one, _)| *one == race);
        self.solved.alike as f64 * own.map(|(.., found)| found.heat).sum::<f64>()
    }

    /// Mean of all balls that turn (rad/s).
    fn orbit(&self) -> Option<f64> {
        let orbits: Vec<f64> =
            self.solved.balls.iter().filter_map(|ball| Some(ball.motion?.orbit)).collect();
        (!orbits.is_empty()).then(|| orbits.iter().sum::<f64>() / orbits.len() as f64)
    }

    fn largest(&self, of: impl Fn(&SolvedRace) -> f64) -> f64 {
        self.contacts().map(|(.., found)| of(found)).fold(0.0, f64::max)
    }

    /// The report; as `serde` sees it, `report.json`: `balls` are those that differ, `alike` says how many balls are like
    /// each of them; `inner` and `outer` of a ball are its contacts, `null` where it does not touch.
    #[must_use]
    pub fn report(&self) -> Report {
        let solved = &self.solved;
        let [axial, radial] = solved.load;
        let [axial_displacement, radial_displacement] = solved.displacement;
        let sliding = self.largest(|found| found.sliding_speed);
        let peak = self.largest(|found| found.hertz.peak_pressure());
        let caution = words(&self.cautions());
        let mut report = Report::solved(self.case.theory_name(), solved.status(), caution);
        report
            .section("", Shown::Contact)
            .number("axial_load", "axial load", Newton, axial)
            .number("radial_load", "radial load", Newton, radial)
            .number("axial_displacement", "axial displacement", Metre, axial_displacement)
            .number("radial_displacement", "radial displacement", Metre, radial_displacement)
            .number("heat", "heat", Watt, solved.heat)
            .number("inner_heat", "  inner race", Watt, self.heat_of(0))
            .number("outer_heat", "  outer race", Watt, self.heat_of(1))
            .number("friction_moment", "moment of friction", NewtonMetre, solved.moment)
            .written(Written::Digits(6))
            .number("orbit", "orbit of the balls", RadianPerSecond, self.orbit())
            .written(Written::USUAL)
            .number("peak_pressure", "peak pressure", Pascal, peak)
            .number("largest_sliding_speed", "largest sliding speed", MetrePerSecond, sliding);
        report.part("", "alike", ReportPart::Count(solved.alike));
        let balls = solved.balls.iter().map(of_ball).collect();
        report.part("", "balls", ReportPart::Reports(balls));
        report
    }

    /// A short report for a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        let (mut lines, status) = (Lines::default(), self.solved.status());
        let headline = format!("Theory {}: {}", self.case.theory_name(), status_words(status));
        lines.headline(&headline, status);
        for caution in self.cautions().iter().filter(|one| !matches!(one, Caution::Status(_))) {
            lines.caution(&caution.to_string());
        }
        lines.heading("Bearing");
        self.report().rows(&mut lines, Shown::Contact);
        if let Some(ball) = self.solved.worst() {
            ball_lines(ball, self.solved.balls.len() > 1, &mut lines);
        }
        lines.into_text()
    }

    /// The contacts of the hottest ball as pictures, `inner` and `outer`, by a theory that has a field.
    ///
    /// # Errors
    /// [`BearingCaseError`] as in solving.
    pub fn contact_svgs(&self) -> Result<Vec<(&'static str, String)>, BearingCaseError> {
        self.fields(|name, race, found, elements| {
            let friction = found.friction?;
            let title = format!("Ball on the {name} race");
            Some(
                AreasPicture {
                    title: &title,
                    contact: &race.normal,
                    elements,
                    scaling: race.scaling,
                    status: friction.status,
                    friction: self.case.bearing.friction,
                    force: friction.force,
                    share: friction.adhesion_share,
                }
                .svg(),
            )
        })
    }

    /// Something of each contact of the hottest ball.
    fn fields<T>(
        &self,
        of: impl Fn(
            &'static str,
            &creepage_bearing::RaceField,
            &SolvedRace,
            &[creepage::coulomb::ElementField],
        ) -> Option<T>,
    ) -> Result<Vec<(&'static str, T)>, BearingCaseError> {
        let Some(ball) = self.solved.worst() else { return Ok(Vec::new()) };
        let mut all = Vec::new();
        for (race, name) in RACES.into_iter().enumerate() {
            let field = self.case.bearing.race_field(ball, race, self.case.theory)?;
            if let (Some(field), Some(found)) = (field, ball.races[race])
                && let Some(made) = of(name, &field, &found, &field.elements)
            {
                all.push((name, made));
            }
        }
        Ok(all)
    }

    /// Writes `report.json`, and of the hottest ball `inner.svg`, `inner.png`, `inner.csv`, `inner.vtk` and the same of the
    /// outer race into `directory`, which is made when missing; files of those names are replaced, but none of `sources`.
    /// Gives the paths written.
    ///
    /// # Errors
    /// [`ReportError`]; what was made until then is removed.
    pub fn write(&self, directory: &Path, sources: &Sources) -> Result<Vec<PathBuf>, ReportError> {
        let mut json = serde_json::to_string_pretty(&self.report())?;
        json.push('\n');
        let mut files = vec![("report.json".to_owned(), json.into_bytes())];
        // What was solved once is solved again.
        for (name, svg) in self.contact_svgs().unwrap_or_default() {
            let png = creepage_plot::png(&svg)?;
            files.push((format!("{name}.svg"), svg.into_bytes()));
            files.push((format!("{name}.png"), png));
        }
        let tables = self.fields(|_, race, _, elements| {
            let field = AreaField {
                elements,
                scaling: race.scaling,
                friction: self.case.bearing.friction,
                theory: self.case.theory_name(),
            };
            Some((field.csv(), field.vtk()))
        });
        for (name, (csv, vtk)) in tables.unwrap_or_default() {
            files.push((format!("{name}.csv"), csv?));
            files.push((format!("{name}.vtk"), vtk.into_bytes()));
        }
        let files: Vec<(&str, &[u8])> =
            files.iter().map(|(name, content)| (&name[..], &content[..])).collect();
        write_all(directory, &files, sources)
    }
}

/// One ball; its azimuth is that from the radial load, its axis' pitch that from the bearing's axis.
fn of_ball(ball: &SolvedBall) -> Report {
    let motion = ball.motion;
    let mut report = Report::default();
    report
        .section("", Shown::Nowhere)
        .written(Written::Fixed(DEGREES, "degrees", 2))
        .number("azimuth", "azimuth", Radian, ball.azimuth)
        .number("orbit", "orbit", RadianPerSecond, motion.map(|motion| motion.orbit))
        .shown(Shown::Motion)
        .written(Written::Digits(6))
        .number("rotation", "rotation", RadianPerSecond, motion.map(|motion| motion.rotation))
        .written(Written::Fixed(DEGREES, "degrees", 3))
        .number("pitch", "pitch of its axis", Radian, motion.map(|motion| motion.pitch))
        .shown(Shown::Nowhere)
        .written(Written::USUAL)
        .number(
            "yaw_rate",
            "gyroscopic slip, about the direction around the bearing",
            RadianPerSecond,
            motion.map(|motion| motion.yaw_rate),
        )
        .shown(Shown::Force)
        .number("centrifugal_force", "centrifugal force", Newton, ball.centrifugal)
        .number("gyroscopic_moment", "gyroscopic moment", NewtonMetre, ball.gyroscopic);
    for (race, name) in RACES.into_iter().enumerate() {
        let contact = ball.races[race].as_ref().map(|found| of_race(ball, race, found));
        report.part("", name, ReportPart::Report(contact));
    }
    report
}

/// One contact of a ball: creepage is that of the ball against the ring, force that on the ring.
fn of_race(ball: &SolvedBall, race: usize, found: &SolvedRace) -> Report {
    let (hertz, friction) = (&found.hertz, found.friction);
    let slip = ball.motion.map(|motion| motion.slip[race]);
    let creepage = slip.map(|slip| slip.creepage);
    let force = friction.map(|friction| friction.force);
    let (a, b) = (hertz.ellipse().a(), hertz.ellipse().b());
    let plain = |unit| Written::Significant(1.0, unit, 5);
    let mut report = Report::default();
    report
        .section("", Shown::Contact)
        .written(Written::Fixed(DEGREES, "degrees", 3))
        .number("contact_angle", "contact angle", Radian, found.angle)
        .written(Written::USUAL)
        .number("normal_force", "normal force", Newton, hertz.normal_force())
        .written(Written::Significant(1e3, "mm", 4))
        .number("semi_axis_rolling", "semi-axis along rolling", Metre, a)
        .number("semi_axis_lateral", "semi-axis across", Metre, b)
        .written(Written::USUAL)
        .number("peak_pressure", "peak pressure", Pascal, hertz.peak_pressure())
        .shown(Shown::Nowhere)
        .number("approach", "approach", Metre, hertz.approach())
        .shown(Shown::Contact)
        .written(plain("m/s"))
        .number(
            "rolling_speed",
            "rolling speed",
            MetrePerSecond,
            ball.motion.map(|motion| motion.speed[race]),
        )
        .written(Written::USUAL)
        .number("spin", "spin", RadianPerMetre, creepage.map(|creepage| creepage.spin))
        .number(
            "longitudinal_creepage",
            "longitudinal creepage",
            One,
            creepage.map(|creepage| creepage.longitudinal),
        )
        .number(
            "lateral_creepage",
            "lateral creepage",
            One,
            creepage.map(|creepage| creepage.lateral),
        )
        // At the end of the ellipse, beyond that in its middle.
        .number(
            "heathcote_creepage",
            "Heathcote's creepage",
            One,
            slip.map(|slip| slip.heathcote * b * b),
        )
        .written(plain("N"))
        .number(
            "longitudinal",
            "force along rolling",
            Newton,
            force.map(|force| force.longitudinal),
        )
        .number("lateral", "force across", Newton, force.map(|force| force.lateral))
        .written(plain("N m"))
        .number("moment", "moment of spin", NewtonMetre, force.map(|force| force.moment))
        .written(Written::Significant(100.0, "%", 5))
        .number(
            "adhesion_share",
            "adhesion, share of area",
            Share,
            friction.map(|friction| friction.adhesion_share),
        )
        .written(Written::Digits(4))
        .number("sliding_speed", "largest sliding speed", MetrePerSecond, found.sliding_speed)
        .written(Written::USUAL)
        .number("heat", "heat", Watt, found.heat);
    report
}

fn ball_lines(ball: &SolvedBall, is_one_of_many: bool, lines: &mut Lines) {
    let report = of_ball(ball);
    lines.heading(if is_one_of_many { "Hottest ball" } else { "Each ball" });
    if is_one_of_many {
        report.columns(lines, "azimuth", ["azimuth_rad", "", ""]);
    }
    report.rows(lines, Shown::Force);
    report.rows(lines, Shown::Motion);
    for (race, name) in RACES.into_iter().enumerate() {
        match &ball.races[race] {
            None => lines.heading(&format!("  {name} race: no contact")),
            Some(found) => {
                lines.heading(&format!("  {name} race"));
                of_race(ball, race, found).rows(lines, Shown::Contact);
            }
        }
    }
}
