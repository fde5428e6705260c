//! `creepage table`: tables of creep force, built once and looked up.

use std::fmt::Write;
use std::path::PathBuf;

use clap::{Args, Subcommand};
use creepage::table::{Axis, Spread, Table};
use creepage::{Creepage, Force};
use serde::Serialize;

use crate::batch;
use crate::batch_args::BatchArgs;
use crate::failure::Failure;
use crate::input::read_table;
use crate::outcome::Outcome;
use crate::output::{print, to_json};
use crate::table_build::{self, BuildArgs};

#[derive(Debug, Args)]
pub(crate) struct TableArgs {
    #[command(subcommand)]
    command: TableCommand,
}

#[derive(Debug, Subcommand)]
enum TableCommand {
    /// Build a table of a theory, and measure its error.
    ///
    /// The theory is asked at the nodes, on all cores, then at random places between. FILE
    /// appears when it is whole. The full theory takes some minutes for one shape of the contact.
    Build(BuildArgs),
    /// Look a force up.
    Eval(EvalArgs),
    /// What a table holds, and how far it is from its theory.
    Info(InfoArgs),
}

#[derive(Debug, Args)]
struct EvalArgs {
    /// Table.
    #[arg(value_name = "FILE.nc")]
    table: PathBuf,
    /// Dimensionless longitudinal creepage.
    #[arg(long, value_name = "VALUE", default_value_t = 0.0, allow_hyphen_values = true)]
    xi: f64,
    /// Dimensionless lateral creepage.
    #[arg(long, value_name = "VALUE", default_value_t = 0.0, allow_hyphen_values = true)]
    eta: f64,
    /// Dimensionless spin.
    #[arg(long, value_name = "VALUE", default_value_t = 0.0, allow_hyphen_values = true)]
    chi: f64,
    /// Ratio of the contact's semi-axes; needed unless the table has but one.
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true)]
    a_over_b: Option<f64>,
    /// Combined Poisson's ratio; needed unless the table has but one.
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true)]
    poisson: Option<f64>,
    /// Print JSON.
    #[arg(long)]
    json: bool,
    /// CSV file of many look-ups, or - for standard input: columns xi, eta, chi, and `a_over_b` and
    /// poisson unless the table has but one. Appended are the columns of `batch`.
    #[arg(long = "in", value_name = "FILE", conflicts_with_all =
          ["xi", "eta", "chi", "a_over_b", "poisson", "json"])]
    input: Option<PathBuf>,
    /// CSV file for the forces of many look-ups; standard output if not given.
    #[arg(long, value_name = "FILE", requires = "input")]
    out: Option<PathBuf>,
}

#[derive(Debug, Args)]
struct InfoArgs {
    /// Table.
    #[arg(value_name = "FILE.nc")]
    table: PathBuf,
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

pub(crate) fn run(args: &TableArgs) -> Result<Outcome, Failure> {
    match &args.command {
        TableCommand::Build(args) => table_build::run(args)?,
        TableCommand::Eval(EvalArgs { table, input: Some(input), out, .. }) => {
            let (table, input, out) = (Some(table.clone()), Some(input.clone()), out.clone());
            return batch::run(&BatchArgs { table, input, out, ..BatchArgs::default() });
        }
        TableCommand::Eval(args) => eval(args)?,
        TableCommand::Info(args) => {
            let info = Info::of(&read_table(&args.table)?);
            print(&if args.json { to_json(&info)? } else { info.text() })?;
        }
    }
    Ok(Outcome::Done)
}

/// One look-up.
#[derive(Serialize)]
struct LookUp {
    a_over_b: f64,
    poisson: f64,
    xi: f64,
    eta: f64,
    chi: f64,
    fx: f64,
    fy: f64,
    mz: f64,
    /// Of `(fx, fy, mz)` (rows) by `(xi, eta, chi)` (columns).
    derivative: [[f64; 3]; 3],
    /// Largest measured error of the table's force.
    force_error: f64,
    /// Largest measured error of the table's moment.
    moment_error: f64,
}

fn eval(args: &EvalArgs) -> Result<(), Failure> {
    let table = read_table(&args.table)?;
    // Without a value the first node serves, if it is the only one.
    let value = |option, given: Option<f64>, Axis { low, high, nodes }: Axis| {
        let only = given.or((nodes == 1).then_some(low));
        only.ok_or(Failure::Needed { option, low, high })
    };
    let a_over_b = value("--a-over-b", args.a_over_b, table.a_over_b())?;
    let poisson = value("--poisson", args.poisson, table.poisson())?;
    let creepage = Creepage::new(args.xi, args.eta, args.chi)?;
    let (force, derivative) = table.at(a_over_b, poisson)?.force_and_derivative(creepage);
    let ([xi, eta, chi], Force { fx, fy, mz }) = (creepage.components(), force);
    let accuracy = table.accuracy();
    let [force_error, moment_error] = [accuracy.force.worst, accuracy.moment.worst];
    let found = LookUp {
        a_over_b,
        poisson,
        xi,
        eta,
        chi,
        fx,
        fy,
        mz,
        derivative,
        force_error,
        moment_error,
    };
    print(&if args.json { to_json(&found)? } else { found.text() })
}

impl LookUp {
    fn text(&self) -> String {
        let Self { fx, fy, mz, force_error, moment_error, .. } = *self;
        let mut text = String::new();
        let rows = [
            ("f_x", fx, force_error, "mu N"),
            ("f_y", fy, force_error, "mu N"),
            ("m_z", mz, moment_error, "mu N c"),
        ];
        for ((name, value, error, unit), [xi, eta, chi]) in rows.into_iter().zip(self.derivative) {
            // Writing to a string cannot fail.
            let _ = writeln!(
                text,
                "{name}  {value:>9.6} +- {error:.4} {unit:6}  \
                 by xi {xi:>9.6}  by eta {eta:>9.6}  by chi {chi:>9.6}"
            );
        }
        text
    }
}

/// What a table holds.
#[derive(Serialize)]
struct Info {
    theory: String,
    options: String,
    program: String,
    a_over_b: Range,
    poisson: Range,
    /// Along theta, phi and t.
    intervals: [usize; 3],
    /// Nodes at which the theory does not call its force solved.
    doubtful_nodes: usize,
    /// Number of random places at which the error was measured.
    error_places: usize,
    /// Number of further places, where the force bends most.
    error_hard_places: usize,
    /// In parts of `mu N`.
    force_error: Distribution,
    /// In parts of `mu N c`.
    moment_error: Distribution,
}

#[derive(Serialize)]
struct Range {
    low: f64,
    high: f64,
    nodes: usize,
}

#[derive(Serialize)]
struct Distribution {
    median: f64,
    p95: f64,
    p99: f64,
    worst: f64,
}

impl From<Axis> for Range {
    fn from(Axis { low, high, nodes }: Axis) -> Self {
        Self { low, high, nodes }
    }
}

impl From<Spread> for Distribution {
    fn from(Spread { median, p95, p99, worst }: Spread) -> Self {
        Self { median, p95, p99, worst }
    }
}

impl Info {
    fn of(table: &Table) -> Self {
        let (provenance, intervals) = (table.provenance(), table.intervals());
        let accuracy = table.accuracy();
        Self {
            theory: provenance.theory.clone(),
            options: provenance.options.clone(),
            program: provenance.program.clone(),
            a_over_b: table.a_over_b().into(),
            poisson: table.poisson().into(),
            intervals: [intervals.theta, intervals.phi, intervals.t],
            doubtful_nodes: table.doubtful(),
            error_places: accuracy.places,
            error_hard_places: accuracy.hard_places,
            force_error: accuracy.force.into(),
            moment_error: accuracy.moment.into(),
        }
    }

    fn text(&self) -> String {
        let [theta, phi, t] = self.intervals;
        let options =
            if self.options.is_empty() { String::new() } else { format!(", {}", self.options) };
        format!(
            "theory           {}{options}\nbuilt by         {}\na/b              {}\n\
             Poisson's ratio  {}\nintervals        {theta} x {phi} x {t} (theta, phi, t)\n\
             doubtful nodes   {}\n\n\
             error against the theory in per cent: at {} random places, the worst also where the\n\
             force bends most ({} places)\n\
             {:13} {:>7} {:>7} {:>7} {:>7}\n{}{}",
            self.theory,
            self.program,
            self.a_over_b.text(),
            self.poisson.text(),
            self.doubtful_nodes,
            self.error_places,
            self.error_hard_places,
            "",
            "median",
            "95 %",
            "99 %",
            "worst",
            self.force_error.row("of mu N"),
            self.moment_error.row("of mu N c"),
        )
    }
}

impl Range {
    fn text(&self) -> String {
        match self.nodes {
            1 => self.low.to_string(),
            nodes => format!("{} to {}, {nodes} nodes", self.low, self.high),
        }
    }
}

impl Distribution {
    fn row(&self, unit: &str) -> String {
        let percent = [self.median, self.p95, self.p99, self.worst].map(|error| 100.0 * error);
        let [median, p95, p99, worst] = percent;
        format!("{unit:13} {median:>7.3} {p95:>7.3} {p99:>7.3} {worst:>7.3}\n")
    }
}
