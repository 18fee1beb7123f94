//! Meshes of the benchmark shapes, as plain arrays.
//!
//! Everything is a [`Mesh`]: node coordinates and connectivity. Cells are positively oriented, facets point outwards,
//! and the same arguments give the same bits. The crate knows nothing of contact: tests, benches and hosts hand the
//! arrays on.
//!
//! ```
//! use fmc_shapes::rectangle_quad4;
//! let mut two = rectangle_quad4([0.0, 0.0], [1.0, 1.0], [4, 4]);
//! two.append(&rectangle_quad4([0.0, 0.0], [1.0, 1.0], [3, 3]).translated([0.9, 0.2]));
//! assert_eq!(two.cell_count(), 25);
//! ```

mod ball;
mod boundary;
mod cone;
mod coned;
mod cuboid;
mod disc;
mod graded_ball;
mod graded_block;
mod graded_disc;
mod grid;
mod icosphere;
mod jitter;
mod measure;
mod mesh;
mod mixed;
mod motion;
mod orient;
mod patch;
mod polygon;
mod quadrangulated;
mod quadrilaterals;
mod random;
mod rectangle;
mod rotation;
mod rounded;
mod second_order;
mod skew;
mod splitmix;
mod star;
mod tetrahedra;
mod tetrahedron;
mod triangulated;
mod weld;

pub use ball::ball_tet4;
pub use boundary::boundary_faces;
pub use cone::{cone_surface, cone_tet4};
pub use coned::coned;
pub use cuboid::{cuboid_hex8, cuboid_surface, cuboid_tet4};
pub use disc::{disc_quad4, disc_tri3, fan_tri3, half_disc_quad4, half_disc_tri3};
pub use graded_ball::graded_quarter_half_ball_tet4;
pub use graded_block::{graded_block_hex8, graded_block_quad4, graded_block_tet4, graded_block_tri3};
pub use graded_disc::{graded_half_disc_tri3, graded_quarter_disc_tri3};
pub use grid::{geometric, grid_hex8, grid_quad4, grid_tet4, grid_tri3, uniform};
pub use icosphere::icosphere;
pub use mesh::Mesh;
pub use mixed::{cuboid_mixed, cuboid_pyramid5, cuboid_wedge6};
pub use patch::{patch_quad4, quadrilateral_quad4};
pub use polygon::{polygon, regular_polygon, star_polygon};
pub use quadrilaterals::quadrilaterals_quad4;
pub use random::{random_polygon, random_polyhedron, random_rotation};
pub use rectangle::{Diagonals, rectangle_quad4, rectangle_tri3};
pub use rotation::rotation_onto;
pub use second_order::second_order;
pub use splitmix::Splitmix;
pub use star::{star_quad4, star_tri3};
pub use tetrahedron::tetrahedron_tet4;
