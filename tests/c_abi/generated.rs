//! What is written from the sources, and committed: the header from src/capi, and from the header the C interface as Fortran,
//! Python and the fuzz targets see it.

mod fortran;
mod fuzz;
mod pointers;
mod python;

use super::declarations::Declarations;
use super::header::header;
use super::program::root;
use std::{env, fs};

type Writer = fn(&Declarations) -> String;

const FROM_THE_HEADER: [(&str, Writer); 5] = [
    ("bindings/fortran/fmc_contact_c.f90", fortran::module),
    ("bindings/python/src/fmc_contact/_constants.py", python::constants),
    ("bindings/python/src/fmc_contact/_structs.py", python::structs),
    ("bindings/python/src/fmc_contact/_signatures.py", python::signatures),
    ("fuzz/src/interface/declarations.rs", fuzz::declarations),
];

/// A difference is a change of contract: run `make header`, look at it, and tell the CHANGELOG.
#[test]
fn generated_files_are_what_the_sources_say() {
    let header = header();
    let declared = Declarations::of(&header);
    let written = FROM_THE_HEADER.map(|(path, write)| (path, write(&declared)));
    let files = std::iter::once(("include/fmc_contact.h", header)).chain(written);
    let mut stale = Vec::new();
    for (path, text) in files {
        let file = root().join(path);
        if env::var_os("UPDATE_HEADER").is_some() {
            fs::write(&file, &text).unwrap_or_else(|error| panic!("{path}: {error}"));
        }
        let committed = fs::read_to_string(&file).unwrap_or_default();
        if committed != text {
            let line = committed.lines().zip(text.lines()).position(|(old, new)| old != new);
            stale.push(format!("{path}, after line {line:?}"));
        }
    }
    assert!(stale.is_empty(), "not what src/capi says: {stale:?}: make header");
}
