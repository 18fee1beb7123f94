//! Finite elements: bodies of cells of first and second order, their energy, forces, stiffness and stress.
//!
//! Elements are `Tri3` and `Tet4` with one Gauss point, `Quad4` with 2 × 2 `Hex8` with 2 × 2 × 2, and `Wedge6` with 3 × 2; of second order `Tri6` with
//! three, `Tet10` with four, `Quad8` and `Quad9` with 3 × 3, `Hex20` and `Hex27` with 3 × 3 × 3, `Wedge15` with 3 × 3. A part may have cells of several types on the same nodes. All are isoparametric, with curved
//! edges where the nodes in their middle say so, and without any reduced integration or stabilisation; linear quadrilaterals and hexahedra may have incompatible modes (`Model::with_incompatible_modes`). 2D is plane strain or plane stress, per unit thickness, or the section (r, z) of bodies of revolution, as whole rings. Everything is referred
//! to the undeformed configuration (total Lagrangian): gradients of the shape functions are computed once.
//!
//! With H = ∂u/∂X, the displacement gradient, W the energy density of the [`Material`] and P = ∂W/∂H:
//!
//! ```text
//! energy     E(u)  = ∫ W(H) dV                                  Model::internal
//! force      f_a   = ∂E/∂u_a  = ∫ P ∇N_a dV                     Model::internal
//! stiffness  K_ab  = ∂f_a/∂u_b = ∫ ∇N_a · ∂P/∂H · ∇N_b dV       Model::tangent
//! mass       m_a   = ∫ ρ N_a dV   (row sum: diagonal; second order: scaled ∫ ρ N_a² dV)   Model::lumped_mass
//! ```
//!
//! so that a body in motion obeys m ü = external − internal. Sums run over fixed blocks in a fixed order: the number of
//! threads changes no bit.

mod assembly;
mod bending;
mod cofactor;
mod constraints;
mod cube_root;
mod elements;
mod error;
mod extrapolated;
mod face_quadrature;
mod faces;
mod frequency;
mod internal;
mod linear_elastic;
mod load;
mod mass;
mod material;
mod model;
mod modes;
mod neo_hookean;
mod part;
mod quadrature;
mod response;
mod rings;
mod shape;
mod stiffness;
mod stress;
mod tangent;
mod tensor;
mod triplets;
mod wedge;

pub use constraints::Constraints;
pub use error::Error;
pub use faces::Face;
pub use material::{Law, Material};
pub use model::{Cells, Model};
pub use part::Part;
pub use stress::Stress;
pub use triplets::Triplets;
