//! `include/fmc_contact.h` is what the sources say, in sections, in the order of use.

use super::program::root;
use std::fs;

/// A heading of the header, with the sources of what stands under it.
pub(crate) type Section = (&'static str, &'static [&'static str]);

/// In the order in which a host meets them. Within a section types come before functions.
pub(crate) const SECTIONS: [Section; 21] = [
    ("Version", &["calls/version"]),
    ("Statuses, and the text of an error", &["boundary/status", "boundary/status_class", "boundary/last_error"]),
    ("Options", &["structs/law", "structs/options", "calls/options/option_keys", "calls/options/stiffness"]),
    ("Arrays of the host, and its mesh", &["structs/view", "structs/mesh"]),
    (
        "Create a context",
        &[
            "context/state",
            "calls/mesh/creation",
            "calls/mesh/facet_block",
            "calls/options/context_options",
            "calls/mesh/counts",
            "calls/options/interrupt",
        ],
    ),
    (
        "The mesh without deformation, and unknowns of the host",
        &["calls/mesh/reference", "calls/mesh/surfaces", "structs/csr", "calls/mesh/basis"],
    ),
    (
        "Obstacles",
        &[
            "structs/pose",
            "../geometry/shapes",
            "structs/signed_distance",
            "structs/shape",
            "calls/obstacles/obstacle",
            "calls/obstacles/obstacle_list",
        ],
    ),
    (
        "Options of single pairs",
        &[
            "structs/partner",
            "calls/options/pair_interface",
            "calls/options/pair_options",
            "calls/options/orthotropic_pair",
            "calls/options/ppr_pair",
            "structs/own_law",
            "calls/options/own_law_pair",
            "structs/friction_law",
            "calls/options/friction_law_pair",
        ],
    ),
    (
        "Evaluate: forces, totals and warnings",
        &["structs/evaluation", "calls/evaluation/evaluate", "calls/results/getters"],
    ),
    (
        "Tangent",
        &[
            "calls/tangent/entries",
            "calls/tangent/compressed_rows",
            "calls/evaluation/evaluate_tangent",
            "calls/obstacles/obstacle_rotations",
        ],
    ),
    (
        "Steps: friction, patches, the longest step of explicit dynamics",
        &["calls/steps/friction", "calls/steps/patches", "calls/steps/stable_step", "calls/steps/step_limit"],
    ),
    ("Gaps and overlaps at the start", &["calls/steps/adjustment"]),
    ("Penetration tolerance (method of multipliers)", &["structs/multiplier", "calls/steps/augmentation"]),
    (
        "Equilibrium at the end of a load step",
        &["structs/equilibrium", "structs/equilibrium_result", "calls/solver/equilibrium"],
    ),
    (
        "Equilibrium with condensed bodies",
        &["structs/placement", "calls/solver/contact_step", "calls/solver/condensation"],
    ),
    (
        "Outputs: at nodes, at points, on facets",
        &[
            "structs/nodal_lists",
            "calls/results/nodal_contact",
            "structs/contact_point",
            "calls/results/contact_points",
            "structs/gap_constraint",
            "calls/results/gap_constraints",
            "structs/tie",
            "calls/results/ties",
            "calls/options/added_ties",
            "structs/conductance",
            "calls/results/flux",
            "structs/cohesive",
            "calls/results/cohesive",
            "structs/law_point",
            "calls/results/law_points",
            "structs/boundary_facet",
            "calls/mesh/boundary_facets",
            "calls/mesh/point_weights",
            "structs/gradients",
            "structs/directions",
            "calls/results/gradients",
            "calls/solver/adjoint",
        ],
    ),
    ("Wear", &["calls/steps/wear"]),
    (
        "Restart",
        &[
            "calls/steps/slip",
            "calls/steps/friction_history",
            "calls/steps/damage",
            "calls/steps/law_history",
            "calls/steps/multipliers",
        ],
    ),
    (
        "Ranks, and a mesh in parts",
        &[
            "calls/ranks/communicator",
            "calls/ranks/parts_creation",
            "structs/in_parts",
            "calls/ranks/parts",
            "calls/ranks/parts_getters",
        ],
    ),
    ("Free a context", &["calls/mesh/release"]),
    ("All in one call, without a context", &["calls/evaluation/friction_step", "calls/evaluation/stateless"]),
];

pub(crate) fn header() -> String {
    let config = cbindgen::Config::from_file(root().join("cbindgen.toml")).expect("cbindgen.toml");
    let guard = config.include_guard.clone().expect("a guard");
    let mut text = format!("{}\n#ifndef {guard}\n#define {guard}\n\n", config.header.clone().expect("a head"));
    for include in &config.sys_includes {
        text += &format!("#include <{include}>\n");
    }
    text += "\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n";
    let plain =
        cbindgen::Config { header: None, include_guard: None, sys_includes: Vec::new(), cpp_compat: false, ..config };
    for (title, sources) in SECTIONS {
        text += &format!("\n{}\n\n{}\n", heading(title), declared(&plain, sources).trim());
    }
    text + &format!("\n#ifdef __cplusplus\n}}  // extern \"C\"\n#endif\n\n#endif  // {guard}\n")
}

/// The line of a heading.
pub(crate) fn heading(title: &str) -> String {
    format!("// ---- {title} {}", "-".repeat(100 - title.len()))
}

/// What some sources declare, also what only other sections use. Of others' types they know the names.
fn declared(config: &cbindgen::Config, sources: &[&str]) -> String {
    let (mut config, mut builder) = (config.clone(), cbindgen::Builder::new());
    for source in sources {
        let path = root().join(format!("src/capi/{source}.rs"));
        let code = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{source}: {error}"));
        config.export.include.extend(code.lines().filter_map(public_type).map(str::to_owned));
        builder = builder.with_src(path);
    }
    let builder = builder.with_config(config);
    let mut text = Vec::new();
    builder.generate().expect("declarations").write(&mut text);
    String::from_utf8(text).expect("text")
}

/// The type of the header that a line of Rust declares.
fn public_type(line: &str) -> Option<&str> {
    let name = ["pub struct ", "pub enum ", "pub type "].iter().find_map(|kind| line.strip_prefix(kind))?;
    name.split(|letter: char| !letter.is_alphanumeric() && letter != '_').next().filter(|name| name.starts_with("fmc_"))
}
