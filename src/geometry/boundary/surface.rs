//! Boundary facets of bodies.

use super::submesh::Submesh;
use crate::Error;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::mesh::collapsed::{Collapsed, FacesAsGiven};
use crate::geometry::mesh::components::Components;
use crate::geometry::second_order::Division;
use crate::geometry::{Bodies, CellBlock, Vector};
use std::ops::Range;

/// Boundary facets of the bodies of a mesh, oriented outwards: their topology. Of coordinates only those of the
/// reference are kept, from which the law `depth` has its depths, where there are cells.
///
/// Facets have *vertices*: the nodes on the surface and, for quadrilateral faces, the face centroid (mean of the four
/// nodes), about which such a face is split into four triangles.
#[derive(Clone, Debug)]
pub struct Surface<const D: usize> {
    pub(in crate::geometry) node_count: usize,
    pub(in crate::geometry) body_ids: Vec<i64>,
    /// Node of every vertex that is a node, ascending.
    pub(crate) nodes: Vec<u32>,
    /// The four vertices whose mean is vertex `nodes.len() + i`.
    pub(crate) centroids: Vec<[u32; 4]>,
    /// Vertices of the facets, body after body.
    pub(crate) facets: Vec<[u32; D]>,
    /// Facets of every body.
    pub(crate) ranges: Vec<Range<usize>>,
    /// Cell of every facet; empty for surfaces given directly.
    pub(crate) facet_cell: Vec<u32>,
    /// Where every facet comes from: the face of its cell, or the facet as given.
    pub(crate) facet_source: Vec<u32>,
    /// Vertices of every body, ascending: its nodes, then its centroids.
    pub(crate) vertices: Vec<Vec<u32>>,
    /// Whether the facets of a body hang together, by body.
    one_sheet: Vec<bool>,
    /// Cells, where the surface was made from them.
    pub(crate) cells: Option<Cells>,
    /// Coordinates of all nodes without deformation; empty where there are no cells.
    reference: Vec<[f64; D]>,
    /// Where there are cells of second order, their division: all nodes named here are then its points.
    pub(in crate::geometry) division: Option<Division>,
    /// Faces of cells with repeated nodes, as those of the cells that were given.
    pub(in crate::geometry) collapsed: FacesAsGiven,
    /// Where these are some cells of a larger mesh, what lies outside of them.
    pub(crate) submesh: Option<Box<Submesh<D>>>,
}

impl<const D: usize> Surface<D> {
    /// Boundary of the cells of `blocks`, at node coordinates `coords`, `[node_count, D]`.
    ///
    /// A face that belongs to one cell, or to two of different bodies, is boundary. Coordinates serve to distinguish
    /// inside from outside: each connected group of cells is turned so that its volume is positive.
    ///
    /// In a mesh that is refined in part a face may meet smaller ones of the same body: an edge its halves, a triangle four
    /// triangles or two, a quadrilateral four, two halves or two triangles, if their nodes lie within 1e-9 of the middle
    /// (in lengths of the edge). These are inner faces. A node that hangs is where the nodes put it in whose middle it is,
    /// whatever its own coordinates are later, and forces on it are brought to these.
    ///
    /// A cell may name nodes repeatedly, as a hexahedron in which an edge or a face has become a point: it is the wedge, pyramid,
    /// tetrahedron or triangle that its faces make it, of second order too. Cells and their faces count as given.
    ///
    /// # Errors
    /// [`Error::Empty`], [`Error::Dimension`], [`Error::Length`], [`Error::NodeOutOfRange`], [`Error::RepeatedNode`] (a
    /// repeated node that leaves none of the cells that there are), [`Error::NonFiniteCoordinate`], [`Error::RepeatedCell`], [`Error::NonManifold`] (more than two cells at a face),
    /// [`Error::InconsistentOrientation`], [`Error::NonConforming`] (an edge that has a node in its middle in one of two
    /// cells; a node that hangs up to 1 % beside the middle), [`Error::Unsupported`] (nodes that hang beside cells of second
    /// order), [`Error::InvertedCell`], [`Error::InvertedCells`] (several, or quadrilaterals whose edges cross),
    /// [`Error::ZeroMeasure`].
    #[inline(never)]
    pub fn from_cells(coords: &[[f64; D]], blocks: &[CellBlock], bodies: Bodies) -> Result<Self, Error> {
        let Some(Collapsed { blocks, faces }) = Collapsed::of::<D>(blocks) else {
            return Self::of_distinct_nodes(coords, blocks, bodies);
        };
        let blocks: Vec<_> = blocks.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
        Ok(Self { collapsed: faces, ..Self::of_distinct_nodes(coords, &blocks, bodies)? })
    }

    /// The same of cells none of which names a node twice.
    fn of_distinct_nodes(coords: &[[f64; D]], blocks: &[CellBlock], bodies: Bodies) -> Result<Self, Error> {
        let Some(mut division) = Division::of::<D>(coords.len(), blocks)? else {
            return Self::of_straight_cells(coords, blocks, bodies)?.refined(coords, blocks);
        };
        let points = division.interpolation.points(coords)?;
        let straight = std::mem::take(&mut division.blocks);
        let blocks: Vec<_> =
            straight.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
        let ids = division.body_ids(bodies)?;
        let bodies = ids.as_deref().map_or(Bodies::Connected, Bodies::Ids);
        let surface = Self::of_straight_cells(&points, &blocks, bodies);
        let mut surface = surface.map_err(|error| division.folded(error, &points))?;
        if surface.cells.as_ref().is_some_and(Cells::is_refined) {
            return Err(Error::Unsupported { what: "hanging nodes in a mesh with cells of second order" });
        }
        division.orient(|straight| surface.cells.as_ref().is_some_and(|cells| cells.is_flipped(straight)));
        surface.division = Some(division);
        surface.check_curved(&points)?;
        Ok(surface)
    }

    pub(in crate::geometry) fn of_straight_cells(
        coords: &[[f64; D]],
        blocks: &[CellBlock],
        bodies: Bodies,
    ) -> Result<Self, Error> {
        let numbers = blocks.iter().map(|block| block.conn.len()).fold(coords.len(), usize::saturating_add);
        Error::check_room("cells and their surface", numbers.saturating_mul(BYTES_PER_NUMBER))?;
        let mut cells = Cells::new::<D>(coords.len(), blocks)?;
        check_finite(coords, (0..cells.len()).flat_map(|cell| cells.nodes(cell).iter().copied()))?;
        let body_ids = cells.connect(coords, bodies)?;
        let mut faces: Vec<(u32, [u32; 2], Vec<u32>)> = Vec::new();
        for cell in 0..cells.len() {
            for face in (0..8).filter(|face| cells.boundary[cell] >> face & 1 == 1) {
                faces.push((cells.body[cell], [cell as u32, face as u32], cells.face_nodes(cell, face)));
            }
        }
        faces.sort_by_key(|(body, _, _)| *body);
        let mut surface = Self::empty(coords.len(), body_ids, faces.iter().flat_map(|f| f.2.iter().copied()));
        for (body, source, nodes) in &faces {
            surface.push_face(*body, *source, nodes);
        }
        surface.collect_vertices();
        surface.cells = Some(cells);
        surface.reference = coords.to_vec();
        Ok(surface)
    }

    pub(in crate::geometry) fn empty(node_count: usize, body_ids: Vec<i64>, nodes: impl Iterator<Item = u32>) -> Self {
        const { assert!(D == 2 || D == 3, "the plane or space") };
        let mut nodes: Vec<u32> = nodes.collect();
        nodes.sort_unstable();
        nodes.dedup();
        Self {
            node_count,
            ranges: vec![0..0; body_ids.len()],
            body_ids,
            nodes,
            centroids: Vec::new(),
            facets: Vec::new(),
            facet_cell: Vec::new(),
            facet_source: Vec::new(),
            vertices: Vec::new(),
            one_sheet: Vec::new(),
            cells: None,
            reference: Vec::new(),
            division: None,
            collapsed: FacesAsGiven::new(),
            submesh: None,
        }
    }

    pub(in crate::geometry) fn collect_vertices(&mut self) {
        let of = |range: &Range<usize>| {
            let mut vertices: Vec<u32> = self.facets[range.clone()].iter().flatten().copied().collect();
            vertices.sort_unstable();
            vertices.dedup();
            vertices
        };
        self.vertices = self.ranges.iter().map(of).collect();
        let mut sheets = Components::new(self.nodes.len() + self.centroids.len());
        for facet in &self.facets {
            facet[1..].iter().for_each(|&v| {
                sheets.join(facet[0], v, false);
            });
        }
        for vertices in &self.vertices {
            let first = vertices.first().map(|&v| sheets.find(v).0);
            self.one_sheet.push(vertices.iter().all(|&v| Some(sheets.find(v).0) == first));
        }
    }

    /// Whether the surface of a body hangs together: it then has no cavity.
    pub(crate) fn is_one_sheet(&self, body: usize) -> bool {
        self.one_sheet[body]
    }

    /// Vertex of a node that is known to lie on the surface.
    fn vertex_of(&self, node: u32) -> u32 {
        self.nodes.partition_point(|&n| n < node) as u32
    }

    /// Adds an edge, a triangle or the four triangles of a quadrilateral.
    pub(in crate::geometry) fn push_face(&mut self, body: u32, source: [u32; 2], nodes: &[u32]) {
        let vertices: Vec<u32> = nodes.iter().map(|&n| self.vertex_of(n)).collect();
        if let Ok(facet) = <[u32; D]>::try_from(vertices.as_slice()) {
            return self.push(body, source, facet);
        }
        let centroid = (self.nodes.len() + self.centroids.len()) as u32;
        self.centroids.push(std::array::from_fn(|k| vertices[k]));
        for k in 0..4 {
            let corners = [vertices[k], vertices[(k + 1) % 4], centroid];
            self.push(body, source, std::array::from_fn(|c| corners[c]));
        }
    }

    fn push(&mut self, body: u32, [cell, source]: [u32; 2], facet: [u32; D]) {
        let range = &mut self.ranges[body as usize];
        if range.start == range.end {
            range.start = self.facets.len();
        }
        range.end = self.facets.len() + 1;
        self.facets.push(facet);
        self.facet_cell.push(cell);
        self.facet_source.push(source);
    }

    /// Coordinates of all nodes without deformation: those from which the surface was made. Empty where there are no
    /// cells.
    pub(crate) fn reference(&self) -> &[[f64; D]] {
        &self.reference
    }

    /// Nodes that move a vertex, with their weights: itself, or the four nodes about a centroid.
    pub(crate) fn nodes_of_vertex(&self, vertex: u32) -> impl Iterator<Item = (u32, f64)> {
        let (vertices, weight) = match (vertex as usize).checked_sub(self.nodes.len()) {
            None => (&[vertex][..], 1.0),
            Some(centroid) => (&self.centroids[centroid][..], 0.25),
        };
        let nodes: [u32; 4] = std::array::from_fn(|k| vertices.get(k).map_or(0, |&v| self.nodes[v as usize]));
        nodes.into_iter().take(vertices.len()).map(move |node| (node, weight))
    }

    /// Sets them; returns the points of those before.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a surface without cells, [`Error::Length`], [`Error::NonFiniteCoordinate`],
    /// [`Error::InvertedCell`], [`Error::ZeroMeasure`].
    pub(crate) fn set_reference(&mut self, coords: &[[f64; D]]) -> Result<Vec<[f64; D]>, Error> {
        let Some(cells) = &self.cells else {
            return Err(Error::Unsupported { what: "reference coordinates of a surface without cells" });
        };
        let points = self.mesh_points(coords)?;
        self.check_coords(&points, true)?;
        self.check_curved(&points)?;
        cells.check_range(0..cells.len(), &points).map_err(|error| self.in_host_numbers(error))?;
        Ok(std::mem::replace(&mut self.reference, points.into_owned()))
    }

    /// Takes points that it had before.
    pub(crate) fn restore_reference(&mut self, points: Vec<[f64; D]>) {
        self.reference = points;
    }

    /// Positions of the vertices at `coords`.
    pub(crate) fn points(&self, coords: &[[f64; D]]) -> Vec<Vector<D>> {
        let mut points = Vec::new();
        self.place(coords, &mut points);
        points
    }

    /// The same, into memory that is used again.
    pub(crate) fn place(&self, coords: &[[f64; D]], points: &mut Vec<Vector<D>>) {
        points.clear();
        points.reserve_exact(self.nodes.len() + self.centroids.len());
        points.extend(self.nodes.iter().map(|&n| Vector::<D>::from(coords[n as usize])));
        for four in &self.centroids {
            // In the order of node numbers: the same bits from either side of a face.
            let mut four = *four;
            four.sort_unstable();
            let sum = four.iter().fold(Vector::zeros(), |s, &v| s + points[v as usize]);
            points.push(sum * 0.25);
        }
    }

    /// Checks that coordinates fit, and that they are finite on the surface; with `inner`, wherever a node is used.
    pub(crate) fn check_coords(&self, coords: &[[f64; D]], inner: bool) -> Result<(), Error> {
        if coords.len() != self.node_count {
            return Err(Error::Length { array: "coords", expected: self.node_count, found: coords.len() });
        }
        // Nodes that nothing uses may be anything; that they are is rare.
        // Blocks without a branch for every number: a look at all of them is what every evaluation pays.
        let are_in_range = |block: &[f64]| block.iter().fold(true, |all, x| all & (x.abs() <= LARGEST));
        let is_small = |x: &f64| x.abs() < SMALLEST;
        if coords.as_flattened().chunks(512).all(are_in_range) && !coords.as_flattened().iter().all(is_small) {
            return Ok(());
        }
        match &self.cells {
            Some(cells) if inner => {
                check_finite(coords, (0..cells.len()).flat_map(|cell| cells.nodes(cell).iter().copied()))
            }
            _ => check_finite(coords, self.nodes.iter().copied()),
        }
    }

    /// Number of nodes of the whole mesh.
    pub fn node_count(&self) -> usize {
        self.division.as_ref().map_or(self.node_count, |division| division.interpolation.node_count())
    }

    /// Number of nodes on the surface of a body; where cells are of second order, of points at which its faces are divided.
    pub fn surface_node_count(&self, body: usize) -> usize {
        if let Some(submesh) = &self.submesh {
            return submesh.surface_node_counts[body];
        }
        self.vertices[body].partition_point(|&v| (v as usize) < self.nodes.len())
    }

    /// Number of facets; a quadrilateral face counts as four, and one of second order as all its parts: two for an edge, four
    /// for a triangle, sixteen for a quadrilateral.
    pub fn facet_count(&self) -> usize {
        self.facets.len()
    }

    /// Number of bodies.
    pub fn body_count(&self) -> usize {
        self.body_ids.len()
    }

    /// Ids of the bodies, ascending.
    pub fn body_ids(&self) -> &[i64] {
        &self.body_ids
    }

    /// Faces of the surface as corner nodes, with the index of their body; a quadrilateral face appears once, with four.
    #[inline(never)]
    pub fn faces(&self) -> Vec<(usize, Vec<u32>)> {
        match &self.division {
            Some(division) if division.is_divided() => match &self.cells {
                Some(cells) => self.whole_faces(division, cells),
                None => self.whole_facets(division),
            },
            _ => self.straight_faces(),
        }
    }

    fn straight_faces(&self) -> Vec<(usize, Vec<u32>)> {
        let mut faces = Vec::new();
        for (body, range) in self.ranges.iter().enumerate() {
            for facet in &self.facets[range.clone()] {
                match facet.map(|v| self.nodes.get(v as usize).copied()) {
                    nodes if nodes.iter().all(Option::is_some) => {
                        faces.push((body, nodes.iter().flatten().copied().collect()));
                    }
                    // The first of the four triangles about a centroid stands for the face.
                    _ => {
                        let four = self.centroids[facet[D - 1] as usize - self.nodes.len()];
                        if facet[0] == four[0] {
                            faces.push((body, four.iter().map(|&v| self.nodes[v as usize]).collect()));
                        }
                    }
                }
            }
        }
        faces
    }
}

/// What a node or a node of a cell comes to in cells, faces and depths, some 600 bytes for a hexahedron.
const BYTES_PER_NUMBER: usize = 80;

/// Coordinates beyond this have powers that a double does not hold: an energy is a volume by a length, a sixth power stands in between.
/// What comes of them would be wrong, or zero, without a word.
const LARGEST: f64 = 1e75;

/// Meshes whose coordinates are all below it: as above.
const SMALLEST: f64 = 1e-75;

/// Checks that the coordinates of these nodes are finite, and that their powers are numbers.
pub(in crate::geometry) fn check_finite<const D: usize>(
    coords: &[[f64; D]],
    nodes: impl Iterator<Item = u32>,
) -> Result<(), Error> {
    let mut largest = 0.0f64;
    for node in nodes {
        let x = &coords[node as usize];
        if let Some(axis) = x.iter().position(|x| !x.is_finite()) {
            return Err(Error::NonFiniteCoordinate { node: node as usize, axis });
        }
        largest = x.iter().fold(largest, |most, x| most.max(x.abs()));
    }
    // All zero is a mesh of cells without measure, which is told as such.
    if largest > LARGEST || largest > 0.0 && largest < SMALLEST {
        return Err(Error::Overflow {
            quantity: "largest coordinate, of which volumes and energies are powers,",
            value: largest,
        });
    }
    Ok(())
}
