//! Meshes of the benchmark shapes.
