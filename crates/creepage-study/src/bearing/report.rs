//! What is reported of a solved bearing: text, JSON, files and the pictures of the hottest ball's contacts.

use std::path::{Path, PathBuf};

use creepage::Status;
use creepage_bearing::{SolvedBall, SolvedBearing, SolvedRace};
use creepage_plot::format::{fixed, quantity, significant};
use serde::Serialize;

use super::file::{BearingCase, BearingCaseError};
use crate::Caution;
use crate::error::ReportError;
use crate::file_set::write_all;
use crate::gap::{AreaField, AreasPicture};
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

/// `report.json` of a bearing. Key names carry their units; a number that is not finite is `null`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BearingReportJson {
    /// Version of this program.
    pub creepage_version: &'static str,
    /// The theory's name.
    pub theory: &'static str,
    /// One word: the worst of all contacts.
    pub status: &'static str,
    /// Cautions in words; else `null`.
    pub caution: Option<String>,
    /// What the balls carry along the axis (N).
    pub axial_load_n: f64,
    /// What they carry radially (N).
    pub radial_load_n: f64,
    /// Displacement of the inner ring along the axis (m).
    pub axial_displacement_m: f64,
    /// Its radial displacement (m).
    pub radial_displacement_m: f64,
    /// Heat of all contacts (W).
    pub heat_w: f64,
    /// Of those at the inner race (W).
    pub inner_heat_w: f64,
    /// Of those at the outer race (W).
    pub outer_heat_w: f64,
    /// Moment of friction about the axis (N m).
    pub friction_moment_n_m: f64,
    /// Mean angular velocity of the balls' orbit (rad/s): a cage's; null where nothing turns.
    pub orbit_rad_per_s: Option<f64>,
    /// The largest sliding speed (m/s).
    pub largest_sliding_speed_m_per_s: f64,
    /// The largest contact pressure (Pa).
    pub peak_pressure_pa: f64,
    /// How many balls are like each of those listed.
    pub alike: usize,
    /// Each ball.
    pub balls: Vec<BearingBallJson>,
}

/// One ball.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BearingBallJson {
    /// Its place, from that of the radial load (rad).
    pub azimuth_rad: f64,
    /// Angular velocity of its orbit (rad/s).
    pub orbit_rad_per_s: Option<f64>,
    /// Its own angular velocity in that frame (rad/s).
    pub rotation_rad_per_s: Option<f64>,
    /// Angle of its axis from the bearing's (rad).
    pub pitch_rad: Option<f64>,
    /// Its angular velocity about the direction around the bearing (rad/s): gyroscopic slip.
    pub yaw_rate_rad_per_s: Option<f64>,
    /// Centrifugal force (N).
    pub centrifugal_force_n: f64,
    /// Gyroscopic moment (N m).
    pub gyroscopic_moment_n_m: f64,
    /// The inner contact; null where the ball does not touch it.
    pub inner: Option<BearingRaceJson>,
    /// The outer contact.
    pub outer: Option<BearingRaceJson>,
}

/// One contact of a ball.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BearingRaceJson {
    /// Contact angle (rad).
    pub contact_angle_rad: f64,
    /// Load (N).
    pub normal_force_n: f64,
    /// Semi-axis along rolling (m).
    pub semi_axis_rolling_m: f64,
    /// Semi-axis across (m).
    pub semi_axis_lateral_m: f64,
    /// Peak pressure (Pa).
    pub peak_pressure_pa: f64,
    /// Approach (m).
    pub approach_m: f64,
    /// Rolling speed (m/s).
    pub rolling_speed_m_per_s: Option<f64>,
    /// Longitudinal creepage of the ball against the ring, in the middle.
    pub longitudinal_creepage: Option<f64>,
    /// Lateral creepage.
    pub lateral_creepage: Option<f64>,
    /// Spin (rad/m).
    pub spin_rad_per_m: Option<f64>,
    /// Heathcote's creepage at the end of the ellipse, beyond that in its middle.
    pub heathcote_creepage: Option<f64>,
    /// Force of the ball on the ring along rolling (N).
    pub longitudinal_n: Option<f64>,
    /// Across (N).
    pub lateral_n: Option<f64>,
    /// Moment about the normal (N m).
    pub moment_n_m: Option<f64>,
    /// Adhesion area over contact area.
    pub adhesion_share: Option<f64>,
    /// The largest sliding speed (m/s).
    pub sliding_speed_m_per_s: f64,
    /// Heat (W).
    pub heat_w: f64,
}

const RACES: [&str; 2] = ["inner", "outer"];

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

    /// The report, ready for `serde_json`.
    #[must_use]
    pub fn json(&self) -> BearingReportJson {
        let (solved, cautions) = (&self.solved, self.cautions());
        BearingReportJson {
            creepage_version: env!("CARGO_PKG_VERSION"),
            theory: self.case.theory_name(),
            status: solved.status().name(),
            caution: (!cautions.is_empty()).then(|| Caution::words(&cautions)),
            axial_load_n: solved.load[0],
            radial_load_n: solved.load[1],
            axial_displacement_m: solved.displacement[0],
            radial_displacement_m: solved.displacement[1],
            heat_w: solved.heat,
            inner_heat_w: self.heat_of(0),
            outer_heat_w: self.heat_of(1),
            friction_moment_n_m: solved.moment,
            orbit_rad_per_s: self.orbit(),
            largest_sliding_speed_m_per_s: self.largest(|found| found.sliding_speed),
            peak_pressure_pa: self.largest(|found| found.hertz.peak_pressure()),
            alike: solved.alike,
            balls: solved.balls.iter().map(BearingBallJson::new).collect(),
        }
    }

    /// A short report for a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        let (mut lines, report) = (Lines::default(), self.json());
        let status = self.solved.status();
        lines.headline(&format!("Theory {}: {}", report.theory, status_words(status)), status);
        for caution in self.cautions().iter().filter(|one| !matches!(one, Caution::Status(_))) {
            lines.caution(&caution.to_string());
        }
        lines.heading("Bearing");
        lines.row("axial load", &quantity(report.axial_load_n, "N", 5));
        lines.row("radial load", &quantity(report.radial_load_n, "N", 5));
        lines.row("axial displacement", &quantity(report.axial_displacement_m, "m", 5));
        lines.row("radial displacement", &quantity(report.radial_displacement_m, "m", 5));
        lines.row("heat", &quantity(report.heat_w, "W", 5));
        lines.row("  inner race", &quantity(report.inner_heat_w, "W", 5));
        lines.row("  outer race", &quantity(report.outer_heat_w, "W", 5));
        lines.row("moment of friction", &quantity(report.friction_moment_n_m, "N m", 5));
        if let Some(orbit) = report.orbit_rad_per_s {
            lines.row("orbit of the balls", &format!("{} rad/s", significant(orbit, 6)));
        }
        lines.row("peak pressure", &quantity(report.peak_pressure_pa, "Pa", 5));
        lines.row(
            "largest sliding speed",
            &quantity(report.largest_sliding_speed_m_per_s, "m/s", 5),
        );
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
        let mut json = serde_json::to_string_pretty(&self.json())?;
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

impl BearingBallJson {
    fn new(ball: &SolvedBall) -> Self {
        let motion = ball.motion;
        let race = |race: usize| Some(BearingRaceJson::new(ball, race, &ball.races[race]?));
        Self {
            azimuth_rad: ball.azimuth,
            orbit_rad_per_s: motion.map(|motion| motion.orbit),
            rotation_rad_per_s: motion.map(|motion| motion.rotation),
            pitch_rad: motion.map(|motion| motion.pitch),
            yaw_rate_rad_per_s: motion.map(|motion| motion.yaw_rate),
            centrifugal_force_n: ball.centrifugal,
            gyroscopic_moment_n_m: ball.gyroscopic,
            inner: race(0),
            outer: race(1),
        }
    }
}

impl BearingRaceJson {
    fn new(ball: &SolvedBall, race: usize, found: &SolvedRace) -> Self {
        let (hertz, friction) = (&found.hertz, found.friction);
        let slip = ball.motion.map(|motion| motion.slip[race]);
        let half = hertz.ellipse().b();
        Self {
            contact_angle_rad: found.angle,
            normal_force_n: hertz.normal_force(),
            semi_axis_rolling_m: hertz.ellipse().a(),
            semi_axis_lateral_m: half,
            peak_pressure_pa: hertz.peak_pressure(),
            approach_m: hertz.approach(),
            rolling_speed_m_per_s: ball.motion.map(|motion| motion.speed[race]),
            longitudinal_creepage: slip.map(|slip| slip.creepage.longitudinal),
            lateral_creepage: slip.map(|slip| slip.creepage.lateral),
            spin_rad_per_m: slip.map(|slip| slip.creepage.spin),
            heathcote_creepage: slip.map(|slip| slip.heathcote * half * half),
            longitudinal_n: friction.map(|friction| friction.force.longitudinal),
            lateral_n: friction.map(|friction| friction.force.lateral),
            moment_n_m: friction.map(|friction| friction.force.moment),
            adhesion_share: friction.map(|friction| friction.adhesion_share),
            sliding_speed_m_per_s: found.sliding_speed,
            heat_w: found.heat,
        }
    }
}

fn ball_lines(ball: &SolvedBall, is_one_of_many: bool, lines: &mut Lines) {
    let name = if is_one_of_many { "Hottest ball" } else { "Each ball" };
    lines.heading(name);
    if is_one_of_many {
        lines.row("azimuth", &format!("{} degrees", fixed(ball.azimuth.to_degrees(), 2)));
    }
    lines.row("centrifugal force", &quantity(ball.centrifugal, "N", 5));
    lines.row("gyroscopic moment", &quantity(ball.gyroscopic, "N m", 5));
    if let Some(motion) = ball.motion {
        lines.row("rotation", &format!("{} rad/s", significant(motion.rotation, 6)));
        lines.row("pitch of its axis", &format!("{} degrees", fixed(motion.pitch.to_degrees(), 3)));
    }
    for (race, name) in RACES.into_iter().enumerate() {
        let Some(found) = ball.races[race] else {
            lines.heading(&format!("  {name} race: no contact"));
            continue;
        };
        let json = BearingRaceJson::new(ball, race, &found);
        lines.heading(&format!("  {name} race"));
        lines.row("contact angle", &format!("{} degrees", fixed(found.angle.to_degrees(), 3)));
        lines.row("normal force", &quantity(json.normal_force_n, "N", 5));
        let axis = |metres: f64| format!("{} mm", significant(1e3 * metres, 4));
        lines.row("semi-axis along rolling", &axis(json.semi_axis_rolling_m));
        lines.row("semi-axis across", &axis(json.semi_axis_lateral_m));
        lines.row("peak pressure", &quantity(json.peak_pressure_pa, "Pa", 5));
        let mut optional = |name: &str, value: Option<f64>, unit: &str| {
            if let Some(value) = value {
                lines.row(name, &format!("{} {unit}", significant(value, 5)));
            }
        };
        optional("rolling speed", json.rolling_speed_m_per_s, "m/s");
        optional("spin", json.spin_rad_per_m, "rad/m");
        optional("longitudinal creepage", json.longitudinal_creepage, "");
        optional("lateral creepage", json.lateral_creepage, "");
        optional("Heathcote's creepage", json.heathcote_creepage, "");
        optional("force along rolling", json.longitudinal_n, "N");
        optional("force across", json.lateral_n, "N");
        optional("moment of spin", json.moment_n_m, "N m");
        optional("adhesion, share of area", json.adhesion_share.map(|share| 100.0 * share), "%");
        lines.row("largest sliding speed", &quantity(json.sliding_speed_m_per_s, "m/s", 4));
        lines.row("heat", &quantity(json.heat_w, "W", 5));
    }
}
