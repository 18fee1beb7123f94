//! `fmc man`: the pages of the manual, made from what `--help` is made of, so that they cannot say anything else.

use anyhow::{Context, Result};
use std::path::PathBuf;

/// Write the pages of the manual, fmc.1 and one for each command, into a folder
#[derive(clap::Args, Debug)]
pub(crate) struct ManArgs {
    /// Folder, made where it is missing
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// Writes the pages.
pub(crate) fn run(command: clap::Command, args: &ManArgs) -> Result<()> {
    std::fs::create_dir_all(&args.folder)
        .and_then(|()| clap_mangen::generate_to(command, &args.folder))
        .with_context(|| format!("the pages cannot be written to {}", args.folder.display()))
}
