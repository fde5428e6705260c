//! Command-line arguments of `creepage` (clap).

use std::path::PathBuf;

use clap::{Parser, Subcommand};

use crate::about::{CompletionsArgs, InitArgs, ManArgs, SchemaArgs};
use crate::batch_args::BatchArgs;
use crate::fmu::FmuArgs;
use crate::import::ImportArgs;
use crate::map::MapArgs;
use crate::rail_args::{ConicityArgs, ProfileArgs, WheelsetArgs};
use crate::reproduce::ReproduceArgs;
use crate::table::TableArgs;
use crate::wear::WearArgs;

/// Rolling contact of two elastic bodies with dry friction: creepage and spin in, tangential
/// force and moment out.
#[derive(Debug, Parser)]
#[command(name = "creepage", version, arg_required_else_help = true, after_help = AFTER_HELP)]
pub(crate) struct Args {
    /// Say nothing but what went wrong: no cautions, notes, bars or names of files.
    #[arg(long, short, global = true)]
    pub(crate) quiet: bool,
    #[command(subcommand)]
    pub(crate) command: Command,
}

const AFTER_HELP: &str = "\
Exit codes:
  0  done
  1  failed on the way, such as a full disk
  2  wrong command line or input; nothing was written
  3  done, but not all of it can be used: a solution did not converge, or `batch` met rows
     that are no cases

A first run:
  creepage init --out case.toml
  creepage solve case.toml --out result

Data goes to standard output, words to standard error. NO_COLOR is respected.";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Solve one case and report forces, areas of adhesion and slip, and heat.
    ///
    /// A case file with a section [wanted] gives forces in place of creepages; the creepages
    /// are found. Forces beyond friction's reach are refused, with the most that was reached.
    ///
    /// A case file with a section [gap] gives the undeformed distance of bodies of any shape in
    /// place of their radii.
    ///
    /// The report goes to standard output; with --out, also report.json, points.csv, contact.svg
    /// and contact.png into a directory, and contact.vtk (the field for VTK programs).
    Solve(SolveArgs),
    /// Solve many cases: CSV in, the same rows with forces appended out.
    ///
    /// Without --case the input needs the columns `a_over_b`, poisson, xi, eta, chi, in any order.
    /// These are the ratio of the contact's semi-axes (along over across the rolling direction),
    /// the combined Poisson's ratio, and the dimensionless creepages. A column `kappa_over_mu` may
    /// say how unlike the bodies are (kappa over the coefficient of friction). The theory `exact`
    /// counts it; with other theories `message` says what neglecting it may cost. Appended are fx,
    /// fy (in units of mu N), mz (mu N c), by a theory with error bars also `fx_error`, `fy_error`,
    /// `mz_error`, then status and message.
    ///
    /// With --case the rows are in SI units: columns longitudinal, lateral, spin, `normal_force`,
    /// friction, `upper_radius_rolling`, `upper_radius_lateral`, `lower_radius_rolling`,
    /// `lower_radius_lateral`, `semi_axis_rolling`, `semi_axis_lateral`, speed. A quantity without a
    /// column is the case file's, and so is the theory unless --theory is given. Appended before the
    /// columns above are `longitudinal_n`, `lateral_n`, `moment_n_m` (of the upper body on the lower),
    /// `frictional_power_per_metre_j_per_m`, and with a speed `frictional_power_w`.
    ///
    /// Further columns pass through. Columns may be separated by semicolons or tabs, and lines that
    /// begin with # may stand above the header. A row that is no case gets the status `invalid` and
    /// the reason in `message`; the others are solved, and the exit code is then 3.
    Batch(BatchArgs),
    /// Solve a series of cases of the numerical theory (Kalker 1967, chapter 5).
    ///
    /// The sweep file names the contact, the loops over spin and creepage, and how each case starts
    /// from the one before it. Chains of cases run on all cores (`RAYON_NUM_THREADS` limits them).
    /// Solved cases are kept in FILE.journal until FILE is complete: a sweep that was interrupted
    /// goes on where it was when it is started again. Ctrl-C or a kill loses the case in hand, one
    /// a core. A power failure also loses the cases of the last 10 ms and of the disk's delay. The
    /// result is the same, bit for bit, on any number of cores, interrupted or not. The exit code
    /// is 3 when a case did not converge.
    Sweep(SweepArgs),
    /// Roll a contact as a table says: creepages or forces over the distance, from any start.
    ///
    /// The case file has [upper], [lower] and [contact] as for `solve`, or [contact] `line_load`
    /// for cylinders; [start] traction = "none", "steady" or "shift"; no [creepage]. The history is
    /// a CSV file. It has `distance` [m] and one column for each component of the motion:
    /// longitudinal, lateral, spin; or xi, eta, chi; or `longitudinal_force`, `lateral_force`,
    /// moment. A component without a column has zero creepage. `normal_force` may change too. The
    /// motion of a row acts from the distance of the row before, or zero, to its own; finer steps
    /// in between are the program's affair.
    ///
    /// The result, one row a row of the history, has `distance_m`, xi, eta, chi, fx, fy, mz,
    /// `longitudinal_n`, `lateral_n`, `moment_n_m`, `adhesion_share` and status. It goes to standard
    /// output as it comes; with --out into DIR/history.csv, with pictures, and a run that was
    /// interrupted goes on where it was. The exit code is 3 when a row did not converge.
    ///
    /// With a wheelset file wheels roll in steps, tractions going on from position to position. The
    /// table has `distance` [m] and what of s, pitch, y, z, roll, yaw, `wheel_load`, `axle_load`,
    /// `roll_moment`, speed, `pitch_rate`, `lateral_velocity`, `vertical_velocity`, `roll_rate`,
    /// `yaw_rate` differs from the file. The result has the forces on each rail.
    Roll(RollArgs),
    /// The contact ellipse and the pressure of a case, without rolling.
    Hertz(HertzArgs),
    /// Solve a contact without rolling: a die, a shift, a twist, a shift with partial slip, one to and fro, balls
    /// pressed together, or a layer sheared under a rectangle.
    ///
    /// The case file has [upper], [lower] and [contact] as for `solve`, and [statics] with a
    /// problem, in SI units. It is "die" (`offset_x`, `offset_y`), "shift" (`force_x`, `force_y`),
    /// "twist" (moment), "partial-slip" (`force_x`, `force_y`) or "shift-path" (`along` "x" or "y",
    /// `steps` of `force` or `shift`). "compression" is for unlike balls under `normal_force`, with
    /// friction; "sheared-rectangle" (`half_length_rolling`, `half_length_lateral`, `along`,
    /// `steps`) is for a [layer]. The report goes to standard output; with --out, also report.json,
    /// points.csv, contact.svg and contact.png into a directory, of a path also path.csv, path.svg
    /// and path.png.
    Statics(StaticsArgs),
    /// Solve a ball bearing: loads, spin, sliding and heat of every ball.
    ///
    /// The file has four sections, in SI units. [bearing] has `pitch_diameter`, `balls`,
    /// `contact_angle`, `friction`, and `axial_load` and `radial_load` or `ball_load`. [ball] has
    /// diameter, density and material, [inner] and [outer] have osculation and speed. The report
    /// goes to standard output; with --out, also report.json and of the hottest ball's two contacts
    /// pictures, CSV and VTK into a directory.
    Bearing(BearingArgs),
    /// Stresses inside one of the two bodies of a case.
    ///
    /// With --points, CSV goes to standard output, rows as in P.csv. Its columns are x, y, z [m]
    /// and sxx, syy, szz, sxy, syz, sxz [Pa], positive in tension. Then come the equivalent
    /// stresses `von_mises` and tresca, the principal stresses s1, s2, s3, and the displacements u,
    /// v, w [m], w into the body. Without --points there is a report on the largest equivalent
    /// stress. With --out a directory gets stresses.csv (the points, or the section y = 0) and a
    /// picture of that section, stresses.svg and stresses.png. Without --points it also gets a
    /// block of the body, stresses.vtk.
    Stresses(StressesArgs),
    /// Compute the tables and figures of Kalker's thesis of 1967 again, beside what was printed.
    ///
    /// What was compared goes to standard output. With --out, each figure goes into a directory as
    /// SVG, PNG and CSV, each table as CSV and text. With `all` there are also a gallery page
    /// (index.html) and the table of agreement (agreement.csv, agreement.md).
    Reproduce(ReproduceArgs),
    /// List the theories: what each assumes, costs, errs by, and is good for.
    Theories(TheoriesArgs),
    /// Creepage and spin coefficients of linear theory.
    ///
    /// Forces and moment for vanishing creepage and spin, of the upper body on the lower:
    /// `F_x` = `G c^2 C11 upsilon_x`, `F_y` = `G c^2 (C22 upsilon_y + C23 c phi)`,
    /// `M_z` = `G c^3 (C32 upsilon_y + C33 c phi)`, with `c^2 = a b`.
    Coefficients(CoefficientsArgs),
    /// Creep-force curves of several theories in one picture.
    ///
    /// One component of the creepage runs through a range, the others stay as the case has them.
    /// The CSV goes to standard output; with --out, curve.csv, curve.svg and curve.png go into a
    /// directory.
    Curve(CurveArgs),
    /// Find friction from measured forces, with its uncertainty.
    ///
    /// POINTS.csv needs at least one of the columns longitudinal, lateral, spin (rad/m). It needs
    /// at least one force: `longitudinal_force`, `lateral_force` (N, of the upper body on the
    /// lower), or `longitudinal_coefficient`, `lateral_coefficient` (force over normal force). It
    /// may have `normal_force` (N) where it differs from the case's, and uncertainty, one standard
    /// deviation of the forces in their unit. The coefficient of friction, and with --slope a
    /// factor of the initial slope, are those whose forces by the theory are nearest to the points
    /// (least squares). Points that do not belong to the others are left out and named; so are rows
    /// that cannot be read, and the exit code is then 3.
    Fit(FitArgs),
    /// Solve the contacts of a wheelset on its track: where wheels and rails touch, and the forces
    /// there.
    ///
    /// The wheelset file has wheels and rails by their profiles, names or files beside it, the
    /// wheelset's position, its load or height, and its motion. The report goes to standard output;
    /// with --out, also report.json and pictures into a directory.
    Wheelset(WheelsetArgs),
    /// Build the contact map of a wheelset: forces of the full theory by look-up, in microseconds.
    ///
    /// The wheelset file is as for `wheelset`. Both wheels are pressed and rolled by the full
    /// theory at places from side to side, closer together where areas of contact join. The map's
    /// error is measured at other random states and kept in it. What is built is kept in
    /// FILE.nc.journal until FILE.nc is whole: a run that was interrupted goes on where it was.
    /// Minutes on two cores.
    Map(MapArgs),
    /// Wear of wheels and rails over distance: profiles, flange measures, conicity.
    ///
    /// The wheelset file has [wear]: situations with their shares of the distance (inline or a CSV table), a law,
    /// distance or passages. Step by step all contacts are solved on all cores, and the smoothed depth is taken off
    /// along the normals. DIR gets the profiles of every stop as files that `wheelset` reads, wear.csv,
    /// profiles.csv, report.json and pictures. What is run so far is kept in DIR/wear.state: a run that was
    /// interrupted goes on where it was, to the same profiles, bit for bit. The exit code is 3 when a situation
    /// did not converge.
    Wear(WearArgs),
    /// Make a Functional Mock-up Unit (FMI 2.0 or 3.0) of a contact map or a wheelset, for vehicle simulation
    Fmu(FmuArgs),
    /// Equivalent conicity of a wheelset on its track by EN 15302, over the amplitude.
    ///
    /// The wheelset file needs [wheel], [rail], [track], and `back_to_back` of [wheelset]; profiles
    /// are names or files beside it. CSV goes to standard output: `amplitude_m`, conicity for
    /// amplitudes of 1.0 to 7.5 mm, an amplitude being half of what the wheelset swings from side
    /// to side. Where contact ends before, the conicity is left empty, and the exit code is 3.
    Conicity(ConicityArgs),
    /// Read profile files of wheels and rails: what they are, what was found, assumed, repaired.
    ///
    /// With --out, a picture of each profile (SVG and PNG) goes into a directory, with --convert
    /// also the profile in another format.
    Profile(ProfileArgs),
    /// Write case files from an input file (.inp) of the program CONTACT, modules 1 and 3, one a case.
    ///
    /// Each case file has the input file's name and the number of the case. Its first lines say
    /// which command solves it and what of the case has no counterpart; standard error says so too.
    /// Units become SI, signs ours; profiles are found beside the input file, whatever the case of
    /// their letters, and copied. A case that cannot be said at all is named with the cause, and
    /// the exit code is 3. An input file that cannot be read ends with the line and what was
    /// expected there; then nothing is written.
    Import(ImportArgs),
    /// Measure how far each theory is from the full one.
    ///
    /// Prints a table in Markdown with the distribution of errors: those of the force `(f_x, f_y)`
    /// in per cent of mu N, those of the moment in per cent of mu N c.
    Accuracy(AccuracyArgs),
    /// Tables of creep force: built once from a theory, looked up in a hundred nanoseconds.
    Table(TableArgs),
    /// Write a commented example of a case file; an existing file is left alone.
    Init(InitArgs),
    /// Print the script by which a shell completes the command.
    Completions(CompletionsArgs),
    /// Print the manual page, or write those of all subcommands.
    Man(ManArgs),
    /// Print the JSON schema of case, statics, sweep or wheelset files, for editors and validators.
    Schema(SchemaArgs),
}

#[derive(Debug, clap::Args)]
pub(crate) struct TheoriesArgs {
    /// Print what is known of each theory as JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Clone, clap::Args)]
pub(crate) struct SolveArgs {
    /// Case file, or - for standard input; `creepage init` writes an example.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// Further case files, whose reports follow; with --out each file has a directory of its own,
    /// named as the file.
    #[arg(value_name = "MORE.toml")]
    pub(crate) more: Vec<PathBuf>,
    /// Theory to use in place of the case file's; `creepage theories` lists them.
    #[arg(long, value_name = "NAME")]
    pub(crate) theory: Option<String>,
    /// Directory for the report, the points and the pictures; made if need be.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Print the report as JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct SweepArgs {
    /// Sweep file.
    #[arg(value_name = "SWEEP.toml")]
    pub(crate) sweep: PathBuf,
    /// File for the results; it appears when it is whole.
    #[arg(long, value_name = "FILE")]
    pub(crate) out: PathBuf,
    /// Format of the file; by default as its name ends: .csv, .json, .nc or .txt.
    #[arg(long)]
    pub(crate) format: Option<SeriesFormat>,
}

/// Formats of the results of a series.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum SeriesFormat {
    /// A row a case.
    Csv,
    /// An object a case.
    Json,
    /// A variable a column, for xarray and pandas (classic NetCDF).
    Netcdf,
    /// The page of Fig. 12 of the thesis for every case, with English headings.
    Page,
    /// The page as it was printed in 1967, in Dutch.
    #[value(name = "page-1967")]
    Page1967,
}

#[derive(Debug, clap::Args)]
pub(crate) struct RollArgs {
    /// Case file.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// How the bodies move, in CSV.
    #[arg(long, value_name = "H.csv")]
    pub(crate) history: PathBuf,
    /// Directory for history.csv and the pictures; made if need be.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, clap::Args)]
pub(crate) struct HertzArgs {
    /// Case file; [creepage], [solve] and the friction may be left out.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct CoefficientsArgs {
    /// Ratio of the contact's semi-axes, along over across the rolling direction: 1e-3 to 1e3.
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true)]
    pub(crate) a_over_b: f64,
    /// Combined Poisson's ratio, 0 to 0.5.
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true)]
    pub(crate) poisson: f64,
    /// Calculate as Kalker did in 1967, with polynomials of this degree; Table 3 of the thesis
    /// is of degree 5. Converged to 1e-6 if not given.
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    pub(crate) degree: Option<usize>,
    /// Coefficients of creepage that varies with the distance rolled as a wave of this length, in
    /// semi-axes along the rolling direction, 0.5 at least. They are complex numbers, whose angle
    /// is how far the force is ahead.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, conflicts_with = "degree")]
    pub(crate) wavelength: Option<f64>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct CurveArgs {
    /// Case file; `creepage init` writes an example.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// Theories to compare, separated by commas; the case file's if not given.
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub(crate) theory: Vec<String>,
    /// What to vary; what moves the force most in this case if not given.
    #[arg(long, value_name = "QUANTITY")]
    pub(crate) vary: Option<Quantity>,
    /// First value, in the unit of the quantity to vary; zero if not given.
    #[arg(long, value_name = "VALUE", requires = "vary", allow_hyphen_values = true)]
    pub(crate) from: Option<f64>,
    /// Last value; well into full sliding if not given.
    #[arg(long, value_name = "VALUE", requires = "vary", allow_hyphen_values = true)]
    pub(crate) to: Option<f64>,
    /// Measured points to lay over the curves, a CSV file with columns as for `fit`; without --vary the
    /// creepage that varies most in it is varied.
    #[arg(long, value_name = "POINTS.csv")]
    pub(crate) data: Option<PathBuf>,
    /// Number of points on each curve.
    #[arg(long, value_name = "N", default_value_t = 201, allow_negative_numbers = true,
          value_parser = clap::value_parser!(u16).range(2..=10_001))]
    pub(crate) points: u16,
    /// Directory for curve.csv, curve.svg and curve.png; made if need be.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, clap::Args)]
pub(crate) struct FitArgs {
    /// Measured points, a CSV file.
    #[arg(value_name = "POINTS.csv")]
    pub(crate) points: PathBuf,
    /// Case file: the bodies, the load, and what the points do not say of the creepage; its friction
    /// is found.
    #[arg(long, value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// Theory to use in place of the case file's; `creepage theories` lists them.
    #[arg(long, value_name = "NAME")]
    pub(crate) theory: Option<String>,
    /// Find a factor of the initial slope too: creepages count that many times.
    #[arg(long)]
    pub(crate) slope: bool,
    /// Directory for fit.json, fit.csv, fit.svg and fit.png; made if need be.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Print the report as JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

/// A component of the creepage, as case files name it, and its unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Quantity {
    /// Longitudinal creepage
    Longitudinal,
    /// Lateral creepage
    Lateral,
    /// Spin (rad/m)
    Spin,
    /// Dimensionless longitudinal creepage
    Xi,
    /// Dimensionless lateral creepage
    Eta,
    /// Dimensionless spin
    Chi,
}

#[derive(Debug, clap::Args)]
pub(crate) struct AccuracyArgs {
    /// Theories to measure, separated by commas; all if not given.
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub(crate) theory: Vec<String>,
    /// Measure over a grid of 3220 cases: a/b from 0.2 to 5, spin to 2, creepage in every
    /// direction. The theory `exact` solves them at its fine resolution; a minute on two cores.
    #[arg(long)]
    pub(crate) grid: bool,
    /// Print JSON, with errors as parts of one.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BearingArgs {
    /// Bearing file.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// Directory for the report and the pictures; made if need be.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Print the report as JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct StaticsArgs {
    /// Statics file.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// Directory for the report, the points and the pictures; made if need be.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Print the report as JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct StressesArgs {
    /// Case file; `creepage init` writes an example.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// CSV file with columns x, y, z [m], z from the surface into the body.
    #[arg(long, value_name = "P.csv")]
    pub(crate) points: Option<PathBuf>,
    /// The body.
    #[arg(long, default_value = "lower")]
    pub(crate) body: BodyName,
    /// Theory to use in place of the case file's; `creepage theories` lists them.
    #[arg(long, value_name = "NAME")]
    pub(crate) theory: Option<String>,
    /// Directory for the stresses and the picture; made if need be.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

/// One of the two bodies, as case files name it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum BodyName {
    /// Such as a rail.
    Lower,
    /// Such as a wheel.
    Upper,
}
