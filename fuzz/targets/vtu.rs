//! VTU files of any content: a mesh with valid indices, or an error; and the arrays of a result.
#![no_main]

use fmc_fuzz::mesh_io::{Mesh, read_fibers, read_floats};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let mut file = b"<".to_vec();
    file.extend(bytes.strip_prefix(b"<").unwrap_or(bytes));
    fmc_fuzz::as_file("vtu", &file, |path| {
        if let Ok(mesh) = Mesh::read(path) {
            let node_count = mesh.points.len();
            assert!(mesh.cells().all(|(_, nodes, _, _)| nodes.iter().all(|&n| (n as usize) < node_count)));
            let _ = mesh.kind();
        }
        let _ = read_floats(path, "force");
        let _ = read_fibers(path);
    });
});
