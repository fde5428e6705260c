//! Arguments of `batch`.

use std::path::PathBuf;

#[derive(Debug, Default, clap::Args)]
pub(crate) struct BatchArgs {
    /// Theory to use; `creepage theories` lists them. With --case, that of the case file if not
    /// given.
    #[arg(long, value_name = "NAME", required_unless_present_any = ["case", "table"])]
    pub(crate) theory: Option<String>,
    /// Look forces up in this table of creep force, in place of a theory.
    #[arg(long, value_name = "FILE.nc", conflicts_with = "theory")]
    pub(crate) table: Option<PathBuf>,
    /// Case file from which the rows differ; they are then in SI units. With the file of a wheelset
    /// any of these columns may be given: y, z, roll, yaw; `axle_load`, `roll_moment`, friction;
    /// speed, `pitch_rate`, `lateral_velocity`, `vertical_velocity`, `roll_rate`, `yaw_rate`; where
    /// surfaces vary along rolling s, pitch. An empty field is the file's own.
    #[arg(long, value_name = "CASE.toml")]
    pub(crate) case: Option<PathBuf>,
    /// CSV file with the cases; standard input if not given, or if it is -.
    #[arg(long = "in", value_name = "FILE")]
    pub(crate) input: Option<PathBuf>,
    /// Option of the theory, as in [solve] of a case file: resolution=fine, grid=[20,20]; may be
    /// given several times.
    #[arg(long = "option", value_name = "KEY=VALUE", requires = "theory")]
    pub(crate) options: Vec<String>,
    /// CSV file for the results; it appears when it is whole, and a pipe or a device is written to in
    /// place. Standard output if not given. A run that is killed may leave a hidden
    /// .FILE.*.partial.
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}
