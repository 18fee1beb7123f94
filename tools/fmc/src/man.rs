//! `fmc man`: the pages of the manual, made from the same source as `--help`, so that they agree.

use anyhow::{Context, Result};
use clap::Command;
use clap_mangen::Man;
use std::io;
use std::path::{Path, PathBuf};

/// Write the pages of the manual, fmc.1 and one for each command, into a folder
#[derive(clap::Args, Debug)]
#[command(hide = true)]
pub(crate) struct ManArgs {
    /// Folder, made where it is missing
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// Writes the pages.
pub(crate) fn run(command: Command, args: &ManArgs) -> Result<()> {
    let mut command = command.disable_help_subcommand(true);
    command.build();
    std::fs::create_dir_all(&args.folder)
        .and_then(|()| write_pages(command, &args.folder))
        .with_context(|| format!("the pages cannot be written to {}", args.folder.display()))
}

/// The page of a command and the pages of its subcommands.
fn write_pages(command: Command, folder: &Path) -> io::Result<()> {
    for below in command.get_subcommands().filter(|below| !below.is_hide_set()) {
        write_pages(below.clone(), folder)?;
    }
    let source = concat!("fmc-contact ", env!("CARGO_PKG_VERSION"));
    Man::new(command).source(source).manual("Commands of fmc-contact").generate_to(folder).map(drop)
}
