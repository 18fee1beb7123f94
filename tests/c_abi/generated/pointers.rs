//! What a pointer to numbers or structs leads to: one, or an array.

use crate::declarations::Variable;

/// Pointers to numbers that are written, one number each, not an array.
const SCALARS: [&str; 16] = [
    "code",
    "count",
    "direction_count",
    "entry_count",
    "factor",
    "facet_count",
    "body_count",
    "node_count",
    "obstacle",
    "offset_count",
    "rank_one_count",
    "renumbered",
    "shape",
    "step",
    "stiffness",
    "volume",
];

/// Pointers to structs that are arrays, but for coordinates.
const ARRAYS: [&str; 6] = ["blocks", "carried", "facets", "parts", "points", "rows"];

/// Lists of numbers as wide as the context's: what is `void *`, but for what a host has handed to callbacks.
pub(super) fn is_index_list(pointer: &Variable) -> bool {
    pointer.of_type == "void" && pointer.pointers == 1 && pointer.name != "user"
}

/// What is read is an array, whatever its name: one number is passed by value.
pub(super) fn is_array(pointer: &Variable) -> bool {
    match pointer.of_type.starts_with("fmc_") {
        true => pointer.of_type != "fmc_coords" && ARRAYS.contains(&pointer.name.as_str()),
        false => pointer.is_const || !SCALARS.contains(&pointer.name.as_str()),
    }
}
