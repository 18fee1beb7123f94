//! Pictures of bodies: meshes in the plane or in space, flat-coloured, as PNG.
//!
//! [`Fields`] are read back from the VTU files of a run; [`View`] turns cells into polygons in the plane, those in the back
//! first; [`Drawing`] fills them. A picture bears no text: what it shows is said beside it.

mod canvas;
mod colors;
mod fields;
mod outline;
mod view;

pub(super) use canvas::{Dot, Drawing, Patch, Stroke};
pub(super) use colors::{brightest, darker, opaque};
pub(super) use fields::{Cell, Fields};
pub(super) use outline::outline;
pub(super) use view::View;
