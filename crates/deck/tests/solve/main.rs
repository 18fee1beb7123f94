//! Input files from their keywords to their results.

mod blocks;
mod frd;
mod friction;
mod hertz;
mod page;
mod refusals;
mod rubber;
mod scene;
mod steps;
