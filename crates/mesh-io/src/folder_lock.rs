//! Folders that one program at a time writes into.

use anyhow::{Context, Result, bail};
use std::fs::{self, File, TryLockError};
use std::io::{Read, Seek, Write};
use std::path::Path;

/// Name of the file that is locked. It stays when all is done, empty then.
const NAME: &str = ".lock";

/// A folder that no other process takes until this is dropped, however this one ends: the system takes the lock back.
#[derive(Debug)]
pub struct FolderLock {
    file: File,
    /// Number of a process that had the folder and did not come to its end.
    pub cut_off: Option<u32>,
}

impl FolderLock {
    /// Takes a folder, which is made if it is not there.
    ///
    /// # Errors
    /// If another process has it, whose number is told, or it cannot be written into.
    pub fn take(folder: &Path) -> Result<Self> {
        fs::create_dir_all(folder).with_context(|| format!("{} cannot be made", folder.display()))?;
        let path = folder.join(NAME);
        let opened = File::options().read(true).write(true).create(true).truncate(false).open(&path);
        let mut file = opened.with_context(|| format!("{} cannot be written", path.display()))?;
        let locked = file.try_lock();
        let mut text = String::new();
        // What is no number says nothing of a process.
        let _ = file.read_to_string(&mut text);
        let owner: Option<u32> = text.trim().parse().ok();
        match locked {
            Err(TryLockError::WouldBlock) => {
                let who = owner.map_or("another process".to_owned(), |number| format!("process {number}"));
                bail!(
                    "{} is written into by {who}; wait for its end, or give another folder by --out",
                    folder.display()
                );
            }
            // Some network file systems have no locks: the number alone, which a process that ended early leaves behind.
            Err(TryLockError::Error(_)) | Ok(()) => {}
        }
        let lock = Self { file, cut_off: owner };
        lock.put(&std::process::id().to_string()).with_context(|| format!("{} cannot be written", path.display()))?;
        Ok(lock)
    }

    fn put(&self, text: &str) -> std::io::Result<()> {
        let mut file = &self.file;
        file.set_len(0)?;
        file.rewind()?;
        file.write_all(text.as_bytes())
    }
}

impl Drop for FolderLock {
    fn drop(&mut self) {
        // A number that stays is told to the next one; the lock itself goes with the file.
        let _ = self.put("");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_has_one_owner() {
        let folder = std::env::temp_dir().join(format!("fmc-folder-lock-{}", std::process::id()));
        let first = FolderLock::take(&folder).unwrap();
        assert_eq!(first.cut_off, None);
        let refused = FolderLock::take(&folder).unwrap_err().to_string();
        assert!(refused.contains(&format!("by process {}", std::process::id())), "{refused}");
        drop(first);
        assert_eq!(fs::read_to_string(folder.join(NAME)).unwrap(), "");
        // As a process leaves it that was killed.
        fs::write(folder.join(NAME), "4711").unwrap();
        assert_eq!(FolderLock::take(&folder).unwrap().cut_off, Some(4711));
        assert_eq!(FolderLock::take(&folder).unwrap().cut_off, None);
        fs::remove_dir_all(&folder).unwrap();
    }
}
