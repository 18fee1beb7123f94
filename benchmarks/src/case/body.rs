//! Elastic bodies.

use fmc_contact::CellType;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// `[[bodies]]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Name, unique among bodies and obstacles.
    pub name: String,
    /// Its mesh: a shape, or a file.
    pub mesh: MeshSource,
    /// Its material.
    pub material: Material,
    /// Velocity of every node at the start, `[D]`, in m/s; zero if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub initial_velocity: Option<Vec<f64>>,
    /// Inclination of the inner lines of a block, relative to its width. It makes an irregular mesh.
    #[serde(default)]
    pub skew: f64,
    /// Rotation about the origin, before `position` is added, in degrees: counter-clockwise in 2D, about z in 3D.
    #[serde(default)]
    pub rotation: f64,
    /// Shift of the mesh, `[D]`, in m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position: Option<Vec<f64>>,
}

impl Body {
    /// Whether it moves at the start.
    pub fn moves(&self) -> bool {
        self.initial_velocity.iter().flatten().any(|v| *v != 0.0)
    }
}

/// `material`
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Energy of deformation.
    pub law: MaterialLaw,
    /// Young's modulus, Pa.
    pub young: f64,
    /// Poisson's ratio, above −1 and below 0.5.
    pub poisson: f64,
    /// Mass density in the reference configuration, kg/m³.
    pub density: f64,
}

/// Names of material laws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MaterialLaw {
    /// Small strain.
    LinearElastic,
    /// Compressible, finite strain: W = G/2 (J^(−2/3) I₁ − 3) + K/2 (J − 1)².
    NeoHookean,
}

/// Kind of cell that a generator makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum CellKind {
    /// Triangles.
    Tri3,
    /// Quadrilaterals.
    Quad4,
    /// Tetrahedra.
    Tet4,
    /// Hexahedra.
    Hex8,
    /// Triangles of second order.
    Tri6,
    /// Quadrilaterals of second order, without a node in their middle.
    Quad8,
    /// Quadrilaterals of second order.
    Quad9,
    /// Tetrahedra of second order.
    Tet10,
    /// Hexahedra of second order, without nodes in their faces and their middle.
    Hex20,
    /// Hexahedra of second order.
    Hex27,
}

impl CellKind {
    /// As the contact module calls it.
    pub fn cell_type(self) -> CellType {
        match self {
            CellKind::Tri3 => CellType::Tri3,
            CellKind::Quad4 => CellType::Quad4,
            CellKind::Tet4 => CellType::Tet4,
            CellKind::Hex8 => CellType::Hex8,
            CellKind::Tri6 => CellType::Tri6,
            CellKind::Quad8 => CellType::Quad8,
            CellKind::Quad9 => CellType::Quad9,
            CellKind::Tet10 => CellType::Tet10,
            CellKind::Hex20 => CellType::Hex20,
            CellKind::Hex27 => CellType::Hex27,
        }
    }

    /// The kind of first order with the same corners.
    pub fn straight(self) -> Self {
        match self {
            CellKind::Tri3 | CellKind::Tri6 => CellKind::Tri3,
            CellKind::Quad4 | CellKind::Quad8 | CellKind::Quad9 => CellKind::Quad4,
            CellKind::Tet4 | CellKind::Tet10 => CellKind::Tet4,
            CellKind::Hex8 | CellKind::Hex20 | CellKind::Hex27 => CellKind::Hex8,
        }
    }
}

/// `mesh`: a shape with its measures, or a file. Lengths in m.
///
/// A shape that has cells of first order has the same cells of second order too, with nodes in the middle of their edges. The edges are
/// straight. Edges on the surface of a disc or ball are curved: their middles lie on the circle or sphere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "shape", rename_all = "kebab-case", rename_all_fields = "snake_case", deny_unknown_fields)]
pub enum MeshSource {
    /// Rectangle with sides along the axes; `tri3` (diagonals alternating) or `quad4`.
    Rectangle {
        /// Kind of cell.
        cell: CellKind,
        /// Lower left corner.
        min: [f64; 2],
        /// Upper right corner.
        max: [f64; 2],
        /// Cells along x and y.
        cells: [usize; 2],
    },
    /// Convex quadrilateral; `quad4`.
    Quadrilateral {
        /// Kind of cell.
        cell: CellKind,
        /// Corners, counter-clockwise.
        corners: [[f64; 2]; 4],
        /// Cells along the first and the second side.
        cells: [usize; 2],
    },
    /// Convex quadrilaterals joined to one body; `quad4`. Common sides must be divided alike.
    Quadrilaterals {
        /// Kind of cell.
        cell: CellKind,
        /// The quadrilaterals.
        parts: Vec<QuadrilateralPart>,
    },
    /// Star about the origin, its first tip on the x axis; `tri3` or `quad4`.
    Star {
        /// Kind of cell.
        cell: CellKind,
        /// Number of tips.
        tips: usize,
        /// Radius of the tips.
        outer: f64,
        /// Radius of the corners between them.
        inner: f64,
        /// Edges on each side of a tip, more than four times `half_width`.
        side_edges: usize,
        /// Cells from the axis of a tip to its side.
        half_width: usize,
    },
    /// Disc about the origin; `tri3` or `quad4`.
    Disc {
        /// Kind of cell.
        cell: CellKind,
        /// Radius.
        radius: f64,
        /// Edges on the circle.
        edges: usize,
    },
    /// Lower half of a disc with its tip at the origin, fine there; `tri3`, or `quad4`: triangles twice as large cut into three.
    GradedHalfDisc {
        /// Kind of cell.
        cell: CellKind,
        /// Radius.
        radius: f64,
        /// Size of the cells at the tip.
        finest: f64,
        /// Distance from the tip up to which they are that fine.
        fine_to: f64,
        /// Growth of the cell size per length beyond.
        growth: f64,
    },
    /// Box with faces across the axes; `tet4` or `hex8`.
    Cuboid {
        /// Kind of cell.
        cell: CellKind,
        /// Lowest corner.
        min: [f64; 3],
        /// Highest corner.
        max: [f64; 3],
        /// Cells along x, y and z.
        cells: [usize; 3],
    },
    /// Tetrahedron; `tet4`.
    Tetrahedron {
        /// Kind of cell.
        cell: CellKind,
        /// Corners.
        corners: [[f64; 3]; 4],
        /// Edges on each side.
        edges: usize,
    },
    /// Ball about the origin; `tet4`.
    Ball {
        /// Kind of cell.
        cell: CellKind,
        /// Radius.
        radius: f64,
        /// Number of refinements of the icosahedron on its surface.
        level: usize,
        /// Layers from the centre to the surface.
        layers: usize,
    },
    /// Block [0, size₀] × … × [−size, 0], fine about its corner at the origin; `tri3`, `quad4`, `tet4` or `hex8`.
    GradedBlock {
        /// Kind of cell.
        cell: CellKind,
        /// Sides, `[D]`.
        size: Vec<f64>,
        /// Side of the core, which has equal cells.
        fine: f64,
        /// Cells along a side of the core.
        cells: usize,
        /// Layers of cells around the core.
        shells: usize,
    },
    /// Quarter x, y ≥ 0 of a half-ball, its pole at the origin and its flat side at z = `radius`, fine at the pole; `tet4`.
    GradedHalfBall {
        /// Kind of cell.
        cell: CellKind,
        /// Radius.
        radius: f64,
        /// Size of the cells at the pole.
        finest: f64,
        /// Cells from the axis to the sphere, around the pole.
        edges: usize,
    },
    /// Mesh file, Gmsh 4.1 or VTU.
    File {
        /// Path, from the folder of the case file.
        path: PathBuf,
        /// Physical group whose cells are taken, by name or number; all cells if absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        group: Option<String>,
    },
}

/// A convex quadrilateral of several.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct QuadrilateralPart {
    /// Corners, counter-clockwise.
    pub corners: [[f64; 2]; 4],
    /// Cells along the first and the second side.
    pub cells: [usize; 2],
}

impl MeshSource {
    /// Kind of cell that a generator makes; a file says it itself.
    pub fn cell(&self) -> Option<CellKind> {
        self.clone().cell_mut().copied()
    }

    pub(super) fn cell_mut(&mut self) -> Option<&mut CellKind> {
        match self {
            MeshSource::Rectangle { cell, .. }
            | MeshSource::Quadrilateral { cell, .. }
            | MeshSource::Quadrilaterals { cell, .. }
            | MeshSource::Star { cell, .. }
            | MeshSource::Disc { cell, .. }
            | MeshSource::GradedHalfDisc { cell, .. }
            | MeshSource::Cuboid { cell, .. }
            | MeshSource::Tetrahedron { cell, .. }
            | MeshSource::Ball { cell, .. }
            | MeshSource::GradedBlock { cell, .. }
            | MeshSource::GradedHalfBall { cell, .. } => Some(cell),
            MeshSource::File { .. } => None,
        }
    }

    /// Dimension of the mesh that a generator makes; a file says it itself.
    pub fn dimension(&self) -> Option<usize> {
        match self {
            MeshSource::Rectangle { .. }
            | MeshSource::Quadrilateral { .. }
            | MeshSource::Quadrilaterals { .. }
            | MeshSource::Star { .. }
            | MeshSource::GradedHalfDisc { .. }
            | MeshSource::Disc { .. } => Some(2),
            MeshSource::Cuboid { .. }
            | MeshSource::Tetrahedron { .. }
            | MeshSource::Ball { .. }
            | MeshSource::GradedHalfBall { .. } => Some(3),
            MeshSource::GradedBlock { size, .. } => Some(size.len()),
            MeshSource::File { .. } => None,
        }
    }
}
