//! The structs that a context reads and gives, and what they become: views of arrays, meshes, options, shapes, results.
//!
//! A struct that one function alone takes stands beside it, in `calls`.

pub(super) mod boundary_facet;
pub(super) mod choice;
pub(super) mod cohesive;
pub(super) mod conductance;
pub(super) mod contact_point;
pub(super) mod csr;
pub(super) mod directions;
pub(super) mod equilibrium;
pub(super) mod equilibrium_result;
pub(super) mod evaluation;
pub(super) mod friction_law;
pub(super) mod gap_constraint;
pub(super) mod gradients;
pub(super) mod in_parts;
pub(super) mod kept_tangent;
pub(super) mod law;
pub(super) mod law_point;
pub(super) mod mesh;
pub(super) mod multiplier;
pub(super) mod nodal_lists;
pub(super) mod option_values;
pub(super) mod options;
pub(super) mod own_law;
pub(super) mod partner;
pub(super) mod placement;
pub(super) mod pose;
pub(super) mod shape;
pub(super) mod signed_distance;
pub(super) mod slip_row;
pub(super) mod tie;
pub(super) mod view;
pub(super) mod worn_row;
