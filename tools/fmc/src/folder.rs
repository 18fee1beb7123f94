//! Folders of results.

use anyhow::Result;
use fmc_mesh_io::FolderLock;
use std::path::Path;

/// Keeps a folder for this process until what comes back is dropped; says if the last one was cut off.
///
/// # Errors
/// If another process writes into it.
pub(crate) fn taken(folder: &Path) -> Result<FolderLock> {
    let lock = FolderLock::take(folder)?;
    if let Some(number) = lock.cut_off {
        eprintln!("{}: process {number}, which wrote here before, did not come to its end", folder.display());
    }
    Ok(lock)
}
