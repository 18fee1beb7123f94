//! What a record was computed from.

use super::job::{Job, Size, Work};
use crate::case::MeshSource;
use anyhow::{Context, Result};
use fnv::FnvHasher;
use serde::{Deserialize, Serialize};
use std::hash::{Hash, Hasher};

/// Fingerprints of all that decides what comes out of a run; a record with another stamp is out of date.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Stamp {
    /// Of the program, as [`program`] gives it.
    pub program: String,
    /// Of the case with its variant, what it expects and its mesh files.
    pub case: String,
}

/// Fingerprint of the running program: its version alone would not tell two builds apart.
///
/// # Errors
/// If its file cannot be read.
pub fn program() -> Result<String> {
    let path = std::env::current_exe().context("the program does not know its file")?;
    let bytes = std::fs::read(&path).with_context(|| format!("{} cannot be read", path.display()))?;
    Ok(format!("{} {}", env!("CARGO_PKG_VERSION"), hash(&bytes)))
}

impl Stamp {
    /// The stamp of a job.
    ///
    /// # Errors
    /// If the case cannot be written as TOML or a mesh file cannot be read.
    pub fn of(job: &Job, size: Size, camera: Option<[f64; 3]>, program: &str) -> Result<Self> {
        let case = match &job.work {
            // Kernel checks are part of the program.
            Work::Kernel(name) => hash(&(name, size as u8)),
            Work::Case(work) => {
                let (document, case) = &**work;
                let mut meshes = Vec::new();
                for body in &case.bodies {
                    if let MeshSource::File { path, .. } = &body.mesh {
                        let path = document.folder.join(path);
                        let bytes = std::fs::read(&path);
                        meshes.push(bytes.with_context(|| format!("{} cannot be read", path.display()))?);
                    }
                }
                hash(&(toml::to_string(case)?, &job.variant, meshes, format!("{camera:?}")))
            }
        };
        Ok(Self { program: program.to_owned(), case })
    }
}

/// 64 bits against mistakes, not against malice.
fn hash(value: &impl Hash) -> String {
    let mut hasher = FnvHasher::default();
    value.hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}
