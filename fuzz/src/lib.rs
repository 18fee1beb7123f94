//! What the fuzz targets share: the C interface as a host in Rust sees it, host arrays that end where memory ends, and
//! programs of calls made from arbitrary bytes.

mod condensation;
pub mod guarded;
pub mod host;
mod in_parts;
pub mod interface;
pub mod leaks;
pub mod mesh;
pub mod number;
pub mod program;
pub mod timed;

/// Case documents.
#[cfg(feature = "cases")]
pub use fmc_benchmarks::case;

/// Readers of mesh files.
#[cfg(feature = "meshes")]
pub use fmc_mesh_io as mesh_io;

/// For a target that reads files: `bytes` as a file of this name in memory, whose path goes to `read`.
pub fn as_file<T>(name: &str, bytes: &[u8], read: impl FnOnce(&std::path::Path) -> T) -> T {
    let path = std::path::Path::new("/dev/shm").join(format!("fmc-fuzz-{}-{name}", std::process::id()));
    std::fs::write(&path, bytes).expect("room for a small file in memory");
    let result = read(&path);
    let _ = std::fs::remove_file(&path);
    result
}
