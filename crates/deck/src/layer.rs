//! Rigid faces as the front of a layer of cells: contact knows bodies by their inside, and a rigid surface has none of its own.
//!
//! `front` (a face) · `orient` (which way faces look) · `thickness` (how far the layer reaches behind them) · `cells` (what lies between)

mod cells;
mod front;
mod orient;
mod thickness;

pub(crate) use cells::Layer;
pub(crate) use front::Front;
pub(crate) use orient::{Twist, oriented};
pub(crate) use thickness::{Unfilled, to_back};
