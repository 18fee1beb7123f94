//! What is known of the contact at nodes and at points, for output, for friction and for other methods of solution.

mod nodal_contact;
mod point_of_contact;

pub use nodal_contact::{NodalContact, NodeStatus};
pub(super) use point_of_contact::points_of_contact;
pub use point_of_contact::{PointOfContact, SideOfPoint};
