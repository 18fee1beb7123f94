//! Files that are whole under their names, or not there.

use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};

/// Writes a file beside its place, and moves it there once all of it is written: a full disk or an interruption
/// leaves what stood there before.
///
/// # Errors
/// If it cannot be written; nothing is left of it then.
pub fn write_whole(path: &Path, bytes: impl AsRef<[u8]>) -> Result<()> {
    let mut beside = path.as_os_str().to_owned();
    beside.push(".part");
    let beside = PathBuf::from(beside);
    // What is no plain file, such as /dev/stdout, cannot be replaced.
    if fs::metadata(path).is_ok_and(|there| !there.is_file()) {
        return fs::write(path, bytes).with_context(|| format!("{} cannot be written", path.display()));
    }
    let written = fs::write(&beside, bytes).and_then(|()| fs::rename(&beside, path));
    if written.is_err() {
        // It may not even have been begun.
        fs::remove_file(&beside).unwrap_or_default();
    }
    written.with_context(|| format!("{} cannot be written", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_or_stays_as_it_was() {
        let folder = std::env::temp_dir().join(format!("fmc-whole-file-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("numbers.json");
        write_whole(&path, "1").unwrap();
        write_whole(&path, "22").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "22");
        // A folder in the way of what is written beside: as good as a disk that is full.
        let beside = folder.join("numbers.json.part");
        fs::create_dir(&beside).unwrap();
        let error = write_whole(&path, "333").unwrap_err().to_string();
        assert!(error.ends_with("numbers.json cannot be written"), "{error}");
        assert_eq!(fs::read_to_string(&path).unwrap(), "22");
        fs::remove_dir_all(&folder).unwrap();
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_leaves_nothing() {
        // Writing to this device fails as a full disk does.
        assert!(write_whole(Path::new("/dev/full"), "1").is_err());
    }
}
