//! The C ABI: checks, conversions and the panic boundary; no mechanics. `include/fmc_contact.h` is made from it.
//!
//! Every entry runs in [`boundary`]: a panic becomes a status, an error leaves its text behind, nothing is printed.
//! Pointers become slices in [`pointer`] and [`view`], once, at the entry; ids, options and poses become the types of
//! the crate in [`mesh`], [`options`] and [`pose`]; from there on it is safe Rust. A `Session` hides the dimension.
//! Results are kept in the context as plain C structs until the next successful evaluation.
//!
//! The library has no state but two: the text of a thread's last error, and the panic hook (see [`boundary`]).

// C names, so that a search for a name of the header finds it here.
#![allow(non_camel_case_types)]
// The functions are reached through their symbols, not through paths.
#![allow(unreachable_pub)]
// Whom a caller in C must obey is in the text of every function; "Safety" headings would go into the header.
#![allow(clippy::missing_safety_doc)]

mod augmentation;
mod basis;
mod boundary;
mod boundary_facet;
mod boundary_facets;
mod communicator;
mod compressed_rows;
mod condensation;
mod contact_point;
mod contact_points;
mod contact_step;
mod context;
mod creation;
mod dimension;
mod evaluate_tangent;
mod evaluation;
mod facet_block;
mod failure;
mod friction;
mod gap_constraint;
mod gap_constraints;
mod getters;
mod in_parts;
mod kept_tangent;
mod last_error;
mod mesh;
mod multiplier;
mod nodal_contact;
mod nodal_lists;
mod obstacle;
mod obstacle_list;
mod obstacle_rotations;
mod option_keys;
mod option_values;
mod options;
mod pair_options;
mod part;
mod partner;
mod parts;
mod parts_creation;
mod parts_getters;
mod patches;
mod placement;
mod point_weights;
mod pointer;
mod pose;
mod reference;
mod resident;
mod session;
mod shape;
mod signed_distance;
mod stable_step;
mod stateless;
mod stateless_step;
mod status;
mod stiffness;
mod tangent;
mod version;
mod view;

#[cfg(test)]
mod tests;
