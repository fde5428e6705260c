//! The command `creepage`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(creepage_cli::command(std::env::args_os()))
}
