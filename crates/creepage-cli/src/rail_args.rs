//! The command line of wheels and rails: wheelsets, conicity, profiles.

use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(group = clap::ArgGroup::new("axes").multiple(true))]
pub(crate) struct WheelsetArgs {
    /// Wheelset file.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// Directory for the report and the pictures; made if need be.
    #[arg(long, value_name = "DIR", conflicts_with = "table")]
    pub(crate) out: Option<PathBuf>,
    /// Print the report as JSON.
    #[arg(long, conflicts_with = "table")]
    pub(crate) json: bool,
    /// Report how the forces change with the wheelset's position and motion too: total derivatives,
    /// what is found following what is given.
    #[arg(long, conflicts_with = "table")]
    pub(crate) derivatives: bool,
    /// NetCDF file for a table over any of `--y`, `--yaw`, `--roll`, `--z` and `--axle-load` in place of the file's
    /// own; it appears when it is whole.
    #[arg(long, value_name = "FILE.nc", requires = "axes")]
    pub(crate) table: Option<PathBuf>,
    /// Lateral positions of the table: first, last (m), and how many.
    #[arg(long, num_args = 3, value_names = ["FROM", "TO", "COUNT"], requires = "table", group = "axes",
          allow_negative_numbers = true)]
    pub(crate) y: Option<Vec<f64>>,
    /// Yaws of the table: first, last (rad), and how many; the file's own if not given.
    #[arg(long, num_args = 3, value_names = ["FROM", "TO", "COUNT"], requires = "table", group = "axes",
          allow_negative_numbers = true)]
    pub(crate) yaw: Option<Vec<f64>>,
    /// Rolls of the table: first, last (rad), and how many.
    #[arg(long, num_args = 3, value_names = ["FROM", "TO", "COUNT"], requires = "table", group = "axes",
          allow_negative_numbers = true)]
    pub(crate) roll: Option<Vec<f64>>,
    /// Heights of the table, down, in place of a load: first, last (m), and how many.
    #[arg(long, num_args = 3, value_names = ["FROM", "TO", "COUNT"], requires = "table", group = "axes",
          allow_negative_numbers = true, conflicts_with = "axle_load")]
    pub(crate) z: Option<Vec<f64>>,
    /// Axle loads of the table: first, last (N), and how many.
    #[arg(long, num_args = 3, value_names = ["FROM", "TO", "COUNT"], requires = "table", group = "axes",
          allow_negative_numbers = true)]
    pub(crate) axle_load: Option<Vec<f64>>,
}

#[derive(Debug, clap::Args)]
pub(crate) struct ConicityArgs {
    /// Wheelset file.
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,
    /// Print the difference of rolling radii, right less left, over the lateral position instead:
    /// `y_m`, `radius_difference_m` by .1 mm as far as contact exists.
    #[arg(long)]
    pub(crate) radius_difference: bool,
    /// Let the wheelset roll until both wheels touch; the standard leaves roll out.
    #[arg(long)]
    pub(crate) roll: bool,
    /// Directory for conicity.csv, `radius_difference.csv` and a picture of radius difference and
    /// places of contact, geometry.svg and geometry.png; made if need be.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, clap::Args)]
pub(crate) struct ProfileArgs {
    /// Profile files, or standard profiles by their names: S1002, UIC60 and the others of a case file.
    #[arg(value_name = "PROFILE", required_unless_present_any = ["survey", "list"])]
    pub(crate) profiles: Vec<PathBuf>,
    /// Measure many files, such as "measured/**/*.whl", on all cores into one CSV file, --out FILE.csv, a row
    /// each: flange height, thickness and slope, hollow, worn area against --reference, conicity at 3 mm on
    /// --rail, roughness, notes, or why one cannot be read. A survey that is killed goes on where it was.
    #[arg(long, value_name = "PATTERN", num_args = 1.., requires = "out",
          conflicts_with_all = ["profiles", "json", "convert"])]
    pub(crate) survey: Vec<String>,
    /// List the standard profiles and where their numbers are from.
    #[arg(long, conflicts_with_all = ["profiles", "survey", "out"])]
    pub(crate) list: bool,
    /// With --survey: the rails, a name or a file.
    #[arg(long, value_name = "PROFILE", requires = "survey")]
    pub(crate) rail: Option<PathBuf>,
    /// Their cant (rad).
    #[arg(
        long,
        value_name = "RAD",
        default_value_t = 0.025,
        requires = "rail",
        allow_negative_numbers = true
    )]
    pub(crate) cant: f64,
    /// The gauge (m).
    #[arg(
        long,
        value_name = "METRES",
        default_value_t = 1.435,
        requires = "rail",
        allow_negative_numbers = true
    )]
    pub(crate) gauge: f64,
    /// Depth below the rails' tops at which it is measured (m).
    #[arg(
        long,
        value_name = "METRES",
        default_value_t = 0.014,
        requires = "rail",
        allow_negative_numbers = true
    )]
    pub(crate) gauge_height: f64,
    /// Distance between the flange backs (m).
    #[arg(
        long,
        value_name = "METRES",
        default_value_t = 1.36,
        requires = "rail",
        allow_negative_numbers = true
    )]
    pub(crate) back_to_back: f64,
    /// The flange back's y in the profiles (m).
    #[arg(long, value_name = "METRES", default_value_t = -0.07, requires = "survey", allow_negative_numbers = true)]
    pub(crate) flange_back: f64,
    /// Nominal radius of the wheels (m).
    #[arg(
        long,
        value_name = "METRES",
        default_value_t = 0.46,
        requires = "rail",
        allow_negative_numbers = true
    )]
    pub(crate) radius: f64,
    /// With --survey: the profile when it was new, a name or a file.
    #[arg(long, value_name = "PROFILE", requires = "survey")]
    pub(crate) reference: Option<PathBuf>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Directory for the pictures and the converted files; made if need be. With --survey the CSV file.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Write each profile in this format too.
    #[arg(long, value_name = "FORMAT", requires = "out")]
    pub(crate) convert: Option<ProfileFormat>,
    /// What the profile belongs to, where the file does not say.
    #[arg(long)]
    pub(crate) role: Option<RoleName>,
    /// The side to take from a file that holds both.
    #[arg(long)]
    pub(crate) side: Option<SideName>,
    /// Length of the file's unit (m), such as 0.001 or 0.0254; as the format has it, else found by
    /// the profile's size, if not given.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    pub(crate) unit: Option<f64>,
    /// Where y grows to in the file.
    #[arg(long)]
    pub(crate) y: Option<LateralSense>,
    /// Where z grows to in the file.
    #[arg(long)]
    pub(crate) z: Option<UprightSense>,
    /// Smooth the profile: waves of this length (m) keep half of their amplitude.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    pub(crate) smooth: Option<f64>,
}

/// What a profile belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum RoleName {
    /// A wheel's profile
    Wheel,
    /// A rail's profile
    Rail,
}

/// A side of the track, in the direction of travel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum SideName {
    /// The left wheel or rail
    Left,
    /// The right wheel or rail
    Right,
}

/// A sense of the lateral axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum LateralSense {
    /// Away from the track's centre
    FieldSide,
    /// To the track's centre
    TrackSide,
}

/// A sense of the upright axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum UprightSense {
    /// Into the rail
    Down,
    /// Into the wheel
    Up,
}

/// Formats of profile files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum ProfileFormat {
    /// Simpack: .prr, .prw
    Simpack,
    /// `MiniProf`: .ban, .whl
    Miniprof,
    /// VAMPIRE: .rai, .whe
    Vampire,
    /// GENSYS: .rail, .wheel
    Gensys,
    /// Two columns in millimetres: .txt
    Columns,
}
