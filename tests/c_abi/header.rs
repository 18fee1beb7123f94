//! `include/fmc_contact.h` is what the sources say.

use super::program::root;

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

pub(crate) fn header() -> String {
    let root = root();
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml");
    let mut builder = cbindgen::Builder::new().with_config(config);
    for source in SOURCES {
        builder = builder.with_src(root.join(format!("src/capi/{source}.rs")));
    }
    let mut header = Vec::new();
    builder.generate().expect("a header").write(&mut header);
    String::from_utf8(header).expect("text")
}
