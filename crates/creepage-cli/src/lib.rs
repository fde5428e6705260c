//! The command `creepage`: reads a case, solves it, reports. Its `main` is here, so that the Python
//! package can bring the command too.

mod about;
mod accuracy;
mod args;
mod batch;
mod batch_args;
mod bearing;
mod cases;
mod coefficients;
mod completions;
mod conicity;
mod curve;
mod failure;
mod fit;
mod fmu;
mod import;
mod init;
mod input;
mod map;
mod outcome;
mod output;
mod profile;
mod rail_args;
mod reproduce;
mod roll;
mod roll_wheels;
mod statics;
mod stresses;
mod survey;
mod sweep;
mod table;
mod table_build;
mod theories;
mod wear;
mod wheelset;

use std::ffi::OsString;

use clap::Parser;

use args::{Args, Command};
use failure::Failure;
use outcome::Outcome;

/// Runs the command with these arguments, of which the first is its own name; gives the exit code.
#[must_use]
pub fn command(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let args = match Args::try_parse_from(arguments) {
        Ok(args) => args,
        Err(error) => {
            // A closed output is no reason for another code.
            let _ = error.print();
            return u8::try_from(error.exit_code()).unwrap_or(2);
        }
    };
    if args.quiet {
        output::be_quiet();
    }
    match run(&args.command) {
        Ok(Outcome::Done) => 0,
        Ok(Outcome::Doubtful) => 3,
        Err(failure) => failure.code().map_or(0, |code| {
            output::complain(&failure.to_string());
            code
        }),
    }
}

fn run(command: &Command) -> Result<Outcome, Failure> {
    match command {
        Command::Solve(args) => return cases::solve(args),
        Command::Batch(args) => return batch::run(args),
        Command::Sweep(args) => return sweep::run(args),
        Command::Wheelset(args) => return wheelset::run(args),
        Command::Map(args) => return map::run(args),
        Command::Wear(args) => return wear::run(args),
        Command::Fmu(args) => return fmu::run(args),
        Command::Roll(args) => return roll::run(args),
        Command::Import(args) => return import::run(args),
        Command::Conicity(args) => return conicity::run(args),
        Command::Profile(args) => return profile::run(args),
        Command::Stresses(args) => return stresses::run(args),
        Command::Hertz(args) => cases::hertz(args)?,
        Command::Bearing(args) => return bearing::run(args),
        Command::Statics(args) => statics::run(args)?,
        Command::Reproduce(args) => reproduce::run(args)?,
        Command::Theories(args) => theories::run(args)?,
        Command::Coefficients(args) => coefficients::run(args)?,
        Command::Curve(args) => curve::run(args)?,
        Command::Fit(args) => return fit::run(args),
        Command::Accuracy(args) => accuracy::run(args)?,
        Command::Table(args) => return table::run(args),
        Command::Init(args) => init::run(args)?,
        Command::Completions(args) => completions::completions(args)?,
        Command::Man(args) => completions::man(args)?,
        Command::Schema(args) => output::print(&format!("{:#}", args.of.schema()))?,
    }
    Ok(Outcome::Done)
}
