//! `include/fmc_contact.h` is what the sources say.

use super::program::root;

/// In the order in which the header is read best.
const SOURCES: [&str; 53] = [
    "calls/version",
    "boundary/status",
    "boundary/status_class",
    "boundary/failure",
    "boundary/last_error",
    "structs/options",
    "calls/options/option_keys",
    "structs/view",
    "structs/mesh",
    "calls/evaluation/friction_step",
    "calls/evaluation/stateless",
    "calls/mesh/creation",
    "calls/mesh/facet_block",
    "context/state",
    "structs/boundary_facet",
    "calls/mesh/boundary_facets",
    "calls/mesh/point_weights",
    "structs/csr",
    "calls/mesh/basis",
    "calls/steps/patches",
    "calls/steps/friction",
    "calls/mesh/reference",
    "calls/tangent/entries",
    "calls/tangent/compressed_rows",
    "calls/obstacles/obstacle_rotations",
    "calls/evaluation/evaluate_tangent",
    "calls/steps/stable_step",
    "calls/ranks/communicator",
    "calls/ranks/parts_creation",
    "structs/in_parts",
    "calls/ranks/parts",
    "calls/ranks/parts_getters",
    "structs/placement",
    "calls/solver/contact_step",
    "calls/solver/condensation",
    "structs/evaluation",
    "calls/results/getters",
    "calls/options/pair_options",
    "structs/nodal_lists",
    "calls/results/nodal_contact",
    "structs/contact_point",
    "calls/results/contact_points",
    "structs/gap_constraint",
    "calls/results/gap_constraints",
    "structs/multiplier",
    "calls/steps/augmentation",
    "structs/pose",
    "../geometry/shapes",
    "structs/shape",
    "calls/obstacles/obstacle",
    "calls/obstacles/obstacle_list",
    "structs/signed_distance",
    "calls/options/stiffness",
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
