//! The command line.

use std::path::PathBuf;

use clap::{Parser, Subcommand};

use crate::reproduce::Item;

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
    /// The contact ellipse and the pressure of a case, without rolling.
    Hertz(HertzArgs),
    /// Solve a contact without rolling: a die, a shift, a twist, or a shift with partial slip.
    ///
    /// The case file has [upper], [lower] and [contact] as for `solve`, and [statics] with
    /// problem = "die" (`offset_x`, `offset_y`), "shift" (`force_x`, `force_y`), "twist" (moment) or
    /// "partial-slip" (`force_x`, `force_y`), in SI units. The report goes to standard output; with
    /// --out, also report.json, points.csv, contact.svg and contact.png into a directory.
    Statics(StaticsArgs),
    /// Compute tables of Kalker's thesis of 1967 again, beside the printed entries.
    Reproduce(ReproduceArgs),
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
pub(crate) struct HertzArgs {
    /// Case file; [creepage], [solve] and the friction may be left out.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// Print JSON.
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
pub(crate) struct ReproduceArgs {
    /// What to reproduce.
    #[arg(value_name = "NAME", required = true)]
    pub(crate) items: Vec<Item>,
    /// Directory for the tables as CSV; made if need be.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, clap::Args)]
pub(crate) struct InitArgs {
    /// File to write; standard output if not given.
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}
