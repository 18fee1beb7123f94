//! A mesh that ranks hold in parts: each gives its own cells, and has of the others only those near the contact.
//!
//! Boxes of the bodies, gathered from all ranks, tell where bodies can be in contact. The cells that reach there, with those
//! whose facets their depths are measured from, are gathered on all ranks and make up a mesh of their own, numbered in the
//! order of the whole. What is measured on it has the bits of the whole mesh, and is shared among the ranks.
//!
//! `mesh_part` (what a rank gives) · `own_mesh` (what it keeps) · `border` (faces between ranks) · `places` (where bodies are,
//! and where they may be in contact) · `selection` (which cells that takes) · `anchors` (facets from which depths are measured)
//! · `zone` (the cells gathered) · `carried` (what was begun or kept, for other cells) · `partitioned_contact` (all of it) · `slip` (what a restart needs)

mod anchors;
mod border;
mod carried;
mod mesh_part;
mod own_mesh;
mod partitioned_contact;
mod places;
mod selection;
mod slip;
mod zone;

pub use mesh_part::MeshPart;
pub use partitioned_contact::{GatheredCounts, PartitionedContact};
pub use slip::CarriedSlip;
