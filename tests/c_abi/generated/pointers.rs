//! What a pointer to numbers or structs leads to: one, or an array.

use crate::declarations::Variable;

/// Pointers to numbers that are written, one number each, not an array.
const SCALARS: [&str; 18] = [
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
    "point_count",
    "rank_one_count",
    "renumbered",
    "row_count",
    "shape",
    "step",
    "stiffness",
    "volume",
];

/// Pointers to structs that are arrays, but for coordinates.
const ARRAYS: [&str; 5] = ["blocks", "facets", "parts", "points", "rows"];

/// What is read is an array, whatever its name: one number is passed by value.
pub(super) fn is_array(pointer: &Variable) -> bool {
    match pointer.of_type.starts_with("fmc_") {
        true => pointer.of_type != "fmc_coords" && ARRAYS.contains(&pointer.name.as_str()),
        false => pointer.is_const || !SCALARS.contains(&pointer.name.as_str()),
    }
}
