//! The command line.

use std::path::PathBuf;

use clap::{Parser, Subcommand};

/// Rolling contact of two elastic bodies with dry friction: creepage and spin in, tangential
/// force and moment out.
#[derive(Debug, Parser)]
#[command(name = "creepage", version, arg_required_else_help = true, after_help = AFTER_HELP)]
pub(crate) struct Args {
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
    /// The report goes to standard output; with --out, also report.json, points.csv,
    /// contact.svg and contact.png into a directory.
    Solve(SolveArgs),
    /// Solve many cases: CSV in, the same rows with forces appended out.
    ///
    /// The input needs the columns `a_over_b`, poisson, xi, eta, chi, in any order: the ratio of
    /// the contact's semi-axes (along over across the rolling direction), the combined
    /// Poisson's ratio, and the dimensionless creepages. Further columns pass through. Appended
    /// are fx, fy (in units of mu N), mz (mu N c), status and message. A row that is no case
    /// gets the status `invalid` and the reason in `message`; the others are solved, and the
    /// exit code is then 3.
    Batch(BatchArgs),
    /// Solve a series of cases of the numerical theory (Kalker 1967, chapter 5).
    ///
    /// The sweep file names the contact, the loops over spin and creepage, and how each case
    /// starts from the one before it; chains of cases run on all cores (`RAYON_NUM_THREADS` limits
    /// them). Solved cases are kept in FILE.journal until FILE is whole: a sweep that was
    /// interrupted goes on where it was when it is started again. The result is the same, bit
    /// for bit, on any number of cores, interrupted or not. The exit code is 3 when a case did
    /// not converge.
    Sweep(SweepArgs),
    /// The contact ellipse and the pressure of a case, without rolling.
    Hertz(HertzArgs),
    /// List the theories: what each assumes, and what it is good for.
    Theories,
    /// Write a commented example of a case file; an existing file is left alone.
    Init(InitArgs),
    /// Print the JSON schema of case files, for editors and validators.
    Schema,
}

#[derive(Debug, clap::Args)]
pub(crate) struct SolveArgs {
    /// Case file; `creepage init` writes an example.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
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
pub(crate) struct BatchArgs {
    /// Theory to use; `creepage theories` lists them.
    #[arg(long, value_name = "NAME")]
    pub(crate) theory: String,
    /// CSV file with the cases; standard input if not given.
    #[arg(long = "in", value_name = "FILE")]
    pub(crate) input: Option<PathBuf>,
    /// CSV file for the results; it appears when it is whole. Standard output if not given.
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, clap::Args)]
pub(crate) struct SweepArgs {
    /// Sweep file.
    #[arg(value_name = "SWEEP.toml")]
    pub(crate) sweep: PathBuf,
    /// File for the results; it appears when it is whole.
    #[arg(long, value_name = "FILE")]
    pub(crate) out: PathBuf,
    /// Format of the file; by default its name tells: .csv, .json, .nc or .txt.
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
pub(crate) struct HertzArgs {
    /// Case file; [creepage], [solve] and the friction may be left out.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct InitArgs {
    /// File to write; standard output if not given.
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}
