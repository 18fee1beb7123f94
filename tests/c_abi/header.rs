//! `include/fmc_contact.h` is what the sources say.

use std::path::Path;
use std::{env, fs};

/// In the order in which the header is read best.
const SOURCES: [&str; 50] = [
    "version",
    "status",
    "failure",
    "last_error",
    "options",
    "option_keys",
    "view",
    "mesh",
    "stateless",
    "stateless_step",
    "creation",
    "facet_block",
    "context",
    "boundary_facet",
    "boundary_facets",
    "point_weights",
    "basis",
    "patches",
    "friction",
    "reference",
    "tangent",
    "compressed_rows",
    "obstacle_rotations",
    "evaluate_tangent",
    "stable_step",
    "communicator",
    "parts_creation",
    "in_parts",
    "parts",
    "parts_getters",
    "placement",
    "contact_step",
    "condensation",
    "evaluation",
    "getters",
    "pair_options",
    "nodal_lists",
    "nodal_contact",
    "contact_point",
    "contact_points",
    "gap_constraint",
    "gap_constraints",
    "multiplier",
    "augmentation",
    "pose",
    "part",
    "obstacle",
    "obstacle_list",
    "signed_distance",
    "stiffness",
];

fn generated(root: &Path) -> String {
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml");
    let mut builder = cbindgen::Builder::new().with_config(config);
    for source in SOURCES {
        builder = builder.with_src(root.join(format!("src/capi/{source}.rs")));
    }
    let mut header = Vec::new();
    builder.generate().expect("a header").write(&mut header);
    String::from_utf8(header).expect("text")
}

/// A difference is a change of contract: run `make header`, look at it, and tell the CHANGELOG.
#[test]
fn the_committed_header_is_the_generated_one() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let path = root.join("include/fmc_contact.h");
    let header = generated(root);
    if env::var_os("UPDATE_HEADER").is_some() {
        fs::write(&path, &header).expect("include/fmc_contact.h can be written");
    }
    let committed = fs::read_to_string(&path).unwrap_or_default();
    let differs = committed.lines().zip(header.lines()).position(|(old, new)| old != new);
    assert!(committed == header, "include/fmc_contact.h is not what src/capi says (line {differs:?}): make header");
}
