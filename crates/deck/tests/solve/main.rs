//! Input files from their keywords to their results.

mod adjust;
mod analytical_surfaces;
mod bending;
mod blocks;
mod blocks_text;
mod elements;
mod equations;
mod frd;
mod free_turns;
mod friction;
mod hertz;
mod local_axes;
mod page;
mod pair_surfaces;
mod refusals;
mod reports;
mod rigid;
mod rigid_surfaces;
mod rings;
mod rubber;
mod scene;
mod self_contact;
mod slopes;
mod steps;
mod tied_surfaces;
mod typical;
