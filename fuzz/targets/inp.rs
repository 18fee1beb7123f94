//! Abaqus input files of any content: a mesh with valid indices, or an error.
#![no_main]

use fmc_fuzz::mesh_io::Mesh;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let mut file = b"*".to_vec();
    file.extend(bytes.strip_prefix(b"*").unwrap_or(bytes));
    if let Ok(mesh) = fmc_fuzz::as_file("inp", &file, Mesh::read) {
        let node_count = mesh.points.len();
        assert!(mesh.cells().all(|(_, nodes, _, _)| nodes.iter().all(|&n| (n as usize) < node_count)));
        assert!(mesh.instances.iter().all(|instance| instance.nodes.end <= node_count));
        let _ = mesh.kind();
    }
});
