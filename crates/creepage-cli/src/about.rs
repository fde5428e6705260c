//! Arguments of the commands about files and the command itself.

use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(crate) struct InitArgs {
    /// File to write; standard output if not given.
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, clap::Args)]
pub(crate) struct CompletionsArgs {
    /// The shell.
    pub(crate) shell: clap_complete::Shell,
}

#[derive(Debug, clap::Args)]
pub(crate) struct ManArgs {
    /// Directory for the pages; made if need be.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, clap::Args)]
pub(crate) struct SchemaArgs {
    /// The files to describe.
    #[arg(long, value_name = "FILES", default_value = "case")]
    pub(crate) of: FileKind,
}

/// The files that the commands read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum FileKind {
    /// Case files: `solve`, `curve`, `hertz`.
    Case,
    /// Bearing files: `bearing`.
    Bearing,
    /// Case files with [gap]: `solve`.
    Gap,
    /// Case files with [contact] `line_load`: `solve`.
    Line,
    /// Case files of a history: `roll`.
    Roll,
    /// Statics files: `statics`.
    Statics,
    /// Sweep files: `sweep`.
    Sweep,
    /// Wheelset files: `wheelset`, `conicity`.
    Wheelset,
}

impl FileKind {
    /// The schema of these files.
    pub(crate) fn schema(self) -> serde_json::Value {
        match self {
            Self::Case => creepage_study::json_schema(),
            Self::Bearing => creepage_study::bearing_json_schema(),
            Self::Gap => creepage_study::gap_json_schema(),
            Self::Line => creepage_study::line_json_schema(),
            Self::Roll => creepage_study::roll_json_schema(),
            Self::Statics => creepage_study::statics_json_schema(),
            Self::Sweep => creepage_study::sweep_json_schema(),
            Self::Wheelset => creepage_study::wheelset_json_schema(),
        }
    }
}
