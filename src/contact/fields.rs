//! What is known of the contact at nodes and at points, for output, for friction and for other methods of solution.

mod nodal_contact;
mod point_of_contact;
mod points;

pub use nodal_contact::{NodalContact, NodeStatus};
pub use point_of_contact::{PointOfContact, SideOfPoint};
pub(super) use points::points_of_contact;
