//! Input files from their keywords to their results.

mod adjust;
mod blocks;
mod blocks_text;
mod elements;
mod frd;
mod friction;
mod hertz;
mod page;
mod refusals;
mod reports;
mod rigid;
mod rubber;
mod scene;
mod steps;
mod tied_surfaces;
