//! The command `creepage`: reads a case, solves it, reports.

mod accuracy;
mod args;
mod batch;
mod cases;
mod coefficients;
mod conicity;
mod curve;
mod failure;
mod gap;
mod init;
mod input;
mod outcome;
mod output;
mod profile;
mod reproduce;
mod statics;
mod stresses;
mod sweep;
mod table;
mod table_build;
mod theories;

use std::process::ExitCode;

use clap::Parser;

use args::{Args, Command};
use failure::Failure;
use outcome::Outcome;

fn main() -> ExitCode {
    match run(&Args::parse().command) {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Doubtful) => ExitCode::from(3),
        Err(failure) => failure.code().map_or(ExitCode::SUCCESS, |code| {
            output::say(&format!("error: {failure}"));
            ExitCode::from(code)
        }),
    }
}

fn run(command: &Command) -> Result<Outcome, Failure> {
    match command {
        Command::Solve(args) => return cases::solve(args),
        Command::Batch(args) => return batch::run(args),
        Command::Sweep(args) => return sweep::run(args),
        Command::Conicity(args) => return conicity::run(args),
        Command::Profile(args) => profile::run(args)?,
        Command::Stresses(args) => return stresses::run(args),
        Command::Hertz(args) => cases::hertz(args)?,
        Command::Statics(args) => statics::run(args)?,
        Command::Reproduce(args) => reproduce::run(args)?,
        Command::Theories(args) => theories::run(args)?,
        Command::Coefficients(args) => coefficients::run(args)?,
        Command::Curve(args) => curve::run(args)?,
        Command::Accuracy(args) => accuracy::run(args)?,
        Command::Table(args) => table::run(args)?,
        Command::Init(args) => init::run(args)?,
        Command::Schema(args) => output::print(&format!("{:#}", args.of.schema()))?,
    }
    Ok(Outcome::Done)
}
