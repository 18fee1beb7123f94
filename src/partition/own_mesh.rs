//! The cells of this rank.

use super::mesh_part::MeshPart;
use crate::Error;
use crate::geometry::boundary::submesh::Whole;
use crate::geometry::boundary::symmetry::Symmetry;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::{Bodies, CellType, Surface, Vector};
use crate::ranks::packed;
use rustc_hash::FxHashMap;

/// What a rank keeps of its own cells.
pub(super) struct OwnMesh<const D: usize> {
    /// Their surface, by itself; `None` where there are no cells.
    pub(super) surface: Option<Surface<D>>,
    pub(super) node_numbers: Vec<u64>,
    node_of_number: FxHashMap<u64, u32>,
    pub(super) cell_numbers: Vec<u64>,
    types: Vec<CellType>,
    offsets: Vec<usize>,
    conn: Vec<u32>,
    /// Index of the body of every cell.
    pub(super) body: Vec<u32>,
    /// Bit f of a cell: its face f, as VTK counts them, is surface of the whole mesh.
    pub(super) surface_faces: Vec<u8>,
    /// By body of the whole mesh, the vertices of its surface that are here.
    pub(super) surface_vertices: Vec<Vec<u32>>,
    /// Of all ranks.
    pub(super) body_ids: Vec<i64>,
    /// One cell of every body, of whatever rank, which are gathered so that each body has some: those that are here.
    pub(super) first_cells: Vec<u32>,
    pub(super) whole: Whole<D>,
    /// Mean extent of a cell, the largest of all ranks.
    pub(super) cell_size: f64,
    pub(super) reference: Vec<[f64; D]>,
}

/// A cell as it is sent.
#[derive(Clone, Debug)]
pub(super) struct SentCell {
    pub(super) number: u64,
    /// Its number in VTK.
    pub(super) kind: u8,
    pub(super) body: u32,
    pub(super) surface_faces: u8,
    pub(super) nodes: Vec<u64>,
}

packed!(SentCell { number, kind, body, surface_faces, nodes });

impl<const D: usize> OwnMesh<D> {
    /// A part of a mesh by itself.
    pub(super) fn of(part: &MeshPart<D>) -> Result<Self, Error> {
        let MeshPart { coords, node_numbers, blocks, cell_numbers, body_ids } = *part;
        let (mut types, mut offsets, mut conn) = (Vec::new(), vec![0], Vec::new());
        for block in blocks {
            for nodes in block.conn.chunks(block.cell_type.node_count()) {
                types.push(block.cell_type);
                conn.extend_from_slice(nodes);
                offsets.push(conn.len());
            }
        }
        let length = |array, expected, found| match expected == found {
            true => Ok(()),
            false => Err(Error::Length { array, expected, found }),
        };
        length("node_numbers", coords.len(), node_numbers.len())?;
        length("cell_numbers", types.len(), cell_numbers.len())?;
        length("body_ids", types.len(), body_ids.len())?;
        let surface = match types.is_empty() {
            true => None,
            false => Some(Surface::from_cells(coords, blocks, Bodies::Ids(body_ids))?),
        };
        let node_of_number: FxHashMap<u64, u32> =
            node_numbers.iter().enumerate().map(|(node, number)| (*number, node as u32)).collect();
        if node_of_number.len() != node_numbers.len() {
            return Err(Error::Unsupported { what: "two nodes of a part of a mesh with one number" });
        }
        Ok(Self {
            surface,
            node_numbers: node_numbers.to_vec(),
            node_of_number,
            cell_numbers: cell_numbers.to_vec(),
            types,
            offsets,
            conn,
            body: Vec::new(),
            surface_faces: Vec::new(),
            surface_vertices: Vec::new(),
            body_ids: Vec::new(),
            first_cells: Vec::new(),
            whole: Whole { surface_node_counts: Vec::new(), reference_box: Aabb::empty(), most_curved: Vec::new() },
            cell_size: 0.0,
            reference: coords.to_vec(),
        })
    }

    pub(super) fn len(&self) -> usize {
        self.types.len()
    }

    pub(super) fn node_count(&self) -> usize {
        self.node_numbers.len()
    }

    /// Nodes of a cell.
    pub(super) fn nodes(&self, cell: usize) -> &[u32] {
        &self.conn[self.offsets[cell]..self.offsets[cell + 1]]
    }

    /// The own node of a number, if there is one.
    pub(super) fn node_of(&self, number: u64) -> Option<u32> {
        self.node_of_number.get(&number).copied()
    }

    /// Box of a cell; around one of second order wider, since it bulges beyond its nodes.
    pub(super) fn cell_box(&self, cell: usize, coords: &[[f64; D]]) -> Aabb<D> {
        let aabb = box_of(self.nodes(cell), coords);
        if self.types[cell].straight() == self.types[cell] { aabb } else { aabb.inflated(0.5 * aabb.extent().max()) }
    }

    /// A cell as others are told of it.
    pub(super) fn sent(&self, cell: usize) -> SentCell {
        let nodes = self.nodes(cell).iter().map(|&node| self.node_numbers[node as usize]).collect();
        SentCell {
            number: self.cell_numbers[cell],
            kind: self.types[cell].vtk_number() as u8,
            body: self.body[cell],
            surface_faces: self.surface_faces[cell],
            nodes,
        }
    }

    /// Own cells of some numbers.
    pub(super) fn cells_of(&self, numbers: &[u64]) -> Vec<u32> {
        let mut numbers = numbers.to_vec();
        numbers.sort_unstable();
        (0..self.len() as u32)
            .filter(|&cell| numbers.binary_search(&self.cell_numbers[cell as usize]).is_ok())
            .collect()
    }

    /// Number of own facets that are surface of the whole mesh.
    pub(super) fn facet_count(&self) -> usize {
        let is_surface =
            |surface: &Surface<D>| (0..surface.facet_count()).filter(|&f| surface.is_surface_facet(f)).count();
        self.surface.as_ref().map_or(0, is_surface)
    }

    /// Index of a body of the own surface among all.
    pub(super) fn body_of(&self, surface: &Surface<D>, body: usize) -> usize {
        self.body_ids.partition_point(|id| *id < surface.body_ids()[body])
    }

    /// Bodies of the whole mesh of which a face that lies in no plane of symmetry is here.
    pub(super) fn bodies_with_surface(&self, symmetry: &Symmetry<D>) -> Vec<u64> {
        let of_surface = |surface: &Surface<D>| -> Vec<u64> {
            let found = surface.bodies_with_surface(symmetry).into_iter().enumerate().filter(|(_, has)| *has);
            found.map(|(body, _)| self.body_of(surface, body) as u64).collect()
        };
        self.surface.as_ref().map_or_else(Vec::new, of_surface)
    }

    /// Places of the vertices on the surface of the whole mesh, by body.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`].
    pub(super) fn boxes(&self, coords: &[[f64; D]]) -> Result<Vec<Aabb<D>>, Error> {
        let Some(surface) = &self.surface else { return Ok(vec![Aabb::empty(); self.body_ids.len()]) };
        let points = surface.points(&surface.mesh_points(coords)?);
        let of_body = |vertices: &Vec<u32>| Aabb::of(vertices.iter().map(|&vertex| &points[vertex as usize]));
        Ok(self.surface_vertices.iter().map(of_body).collect())
    }

    pub(super) fn vertices(&self) -> Vec<Vec<u32>> {
        let mut vertices = vec![Vec::new(); self.body_ids.len()];
        for surface in self.surface.iter() {
            for (body, range) in surface.ranges.iter().enumerate() {
                let facets = range.clone().filter(|&facet| surface.is_surface_facet(facet));
                let of_body = &mut vertices[self.body_of(surface, body)];
                of_body.extend(facets.flat_map(|facet| surface.facets[facet]));
                of_body.sort_unstable();
                of_body.dedup();
            }
        }
        vertices
    }

    pub(super) fn mean_extent(&self) -> f64 {
        let sum: f64 = (0..self.len()).map(|cell| self.cell_box(cell, &self.reference).extent().max()).sum();
        if self.len() == 0 { 0.0 } else { sum / self.len() as f64 }
    }
}

/// Box of some nodes.
pub(super) fn box_of<'a, const D: usize>(nodes: impl IntoIterator<Item = &'a u32>, coords: &[[f64; D]]) -> Aabb<D> {
    let mut aabb = Aabb::empty();
    nodes.into_iter().for_each(|&node| aabb.include(&Vector::from(coords[node as usize])));
    aabb
}
