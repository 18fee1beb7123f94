//! `fmc run`, `fmc list` and `fmc mesh` as a user runs them.

#[path = "../../../../benchmarks/tests/folder/folder.rs"]
mod folder;

mod command;
mod own;

use folder::Folder;
