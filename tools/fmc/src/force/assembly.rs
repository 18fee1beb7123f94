//! Several meshes as one.

use anyhow::{Result, ensure};
use fmc_contact::{Bodies, CellBlock, CellType, Error, FacetBlock, FacetType, Surface};
use fmc_mesh_io::{Kind, Mesh};

/// The meshes of all files, one behind the other: nodes, and cells, are numbered through from 0.
pub(super) struct Assembly<const D: usize> {
    pub(super) meshes: Vec<Mesh>,
    pub(super) kind: Kind,
    pub(super) coords: Vec<[f64; D]>,
    /// First node of every mesh.
    pub(super) node_starts: Vec<u32>,
    /// Blocks of all meshes, with nodes numbered through.
    blocks: Vec<(CellType, Vec<u32>)>,
}

/// Triangles of a quadrilateral facet: cut along the diagonal from its first node.
const HALVES: [[usize; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

impl<const D: usize> Assembly<D> {
    pub(super) fn new(meshes: Vec<Mesh>, kind: Kind) -> Result<Self> {
        let node_count: usize = meshes.iter().map(|mesh| mesh.points.len()).sum();
        ensure!(u32::try_from(node_count).is_ok(), "{node_count} nodes are more than 32 bits can number");
        let mut assembly =
            Self { meshes: Vec::new(), kind, coords: Vec::new(), node_starts: Vec::new(), blocks: Vec::new() };
        for mesh in meshes {
            let start = assembly.coords.len() as u32;
            assembly.node_starts.push(start);
            assembly.coords.extend(mesh.points.iter().map(|x| -> [f64; D] { std::array::from_fn(|axis| x[axis]) }));
            for block in &mesh.blocks {
                assembly.blocks.push((block.cell_type, block.conn.iter().map(|node| node + start).collect()));
            }
            assembly.meshes.push(mesh);
        }
        Ok(assembly)
    }

    /// Number of cells.
    pub(super) fn cell_count(&self) -> usize {
        self.meshes.iter().map(Mesh::cell_count).sum()
    }

    /// Cells as type and nodes, in their order.
    pub(super) fn cells(&self) -> impl Iterator<Item = (CellType, &[u32])> {
        self.blocks
            .iter()
            .flat_map(|(cell_type, conn)| conn.chunks_exact(cell_type.node_count()).map(|nodes| (*cell_type, nodes)))
    }

    /// Boundary of bodies given by an id per cell, or of connected ones.
    pub(super) fn surface(&self, ids: Option<&[i64]>) -> Result<Surface<D>, Error> {
        let bodies = ids.map_or(Bodies::Connected, Bodies::Ids);
        if self.is_curved_surface() {
            let blocks: Vec<FacetBlock> = self
                .blocks
                .iter()
                .map(|(of_type, conn)| FacetBlock { facet_type: facet_type(*of_type), conn })
                .collect();
            return Surface::from_facet_blocks(&self.coords, &blocks, bodies);
        }
        if self.kind == Kind::Surface {
            let facets: Vec<([u32; D], usize)> = self.facets().collect();
            let ids: Option<Vec<i64>> = ids.map(|ids| facets.iter().map(|(_, cell)| ids[*cell]).collect());
            let facets: Vec<[u32; D]> = facets.into_iter().map(|(nodes, _)| nodes).collect();
            return Surface::from_facets(&self.coords, &facets, ids.as_deref().map_or(Bodies::Connected, Bodies::Ids));
        }
        let blocks: Vec<CellBlock> =
            self.blocks.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
        Surface::from_cells(&self.coords, &blocks, bodies)
    }

    /// Whether the cells are facets in space some of which are of second order: facets are then numbered as the cells are.
    fn is_curved_surface(&self) -> bool {
        self.kind == Kind::Surface && self.blocks.iter().any(|(of_type, _)| of_type.straight() != *of_type)
    }

    /// The cell that an error of the module names.
    pub(super) fn cell_of_error(&self, number: usize) -> usize {
        if self.kind != Kind::Surface || self.is_curved_surface() {
            return number;
        }
        self.facets().nth(number).map_or(0, |(_, cell)| cell)
    }

    /// Cells of a surface as triangles, each with the cell that it belongs to.
    fn facets(&self) -> impl Iterator<Item = ([u32; D], usize)> {
        self.cells().enumerate().flat_map(|(cell, (cell_type, nodes))| {
            let halves = if cell_type == CellType::Quad4 { &HALVES[..] } else { &HALVES[..1] };
            // Of a quadrilateral with a repeated node, a triangle, one half is left; what is neither is for the module to name.
            let is_whole = |half: &&[usize; 3]| {
                let [a, b, c] = half.map(|k| nodes[k]);
                a != b && b != c && c != a
            };
            let is_triangle = halves.iter().filter(is_whole).count() == 1;
            let pieces = halves.iter().filter(move |half| !is_triangle || is_whole(half));
            pieces.map(move |piece| (std::array::from_fn(|k| nodes[piece[k]]), cell))
        })
    }

    /// Where a cell stands, file and instance, and its number there.
    pub(super) fn cell_origin(&self, mut cell: usize) -> (String, u64) {
        for contents in &self.meshes {
            match contents.cell(cell) {
                Some((_, nodes, tag, _)) => return (place(contents, nodes[0] as usize), tag),
                None => cell -= contents.cell_count(),
            }
        }
        unreachable!("cells come from meshes")
    }

    /// Where a node stands, file and instance, and its number there.
    pub(super) fn node_origin(&self, node: usize) -> (String, u64) {
        let mesh = self.node_starts.partition_point(|&start| start as usize <= node) - 1;
        let node = node - self.node_starts[mesh] as usize;
        (place(&self.meshes[mesh], node), self.meshes[mesh].node_tags[node])
    }
}

/// The file, and the instance in it to which a node belongs: numbers are unique within one only.
fn place(mesh: &Mesh, node: usize) -> String {
    match mesh.instances.iter().find(|instance| instance.nodes.contains(&node)) {
        Some(instance) => format!("{}, {}", mesh.file, instance.name),
        None => mesh.file.clone(),
    }
}

/// What a cell of a plane is as a facet in space.
fn facet_type(cell_type: CellType) -> FacetType {
    match cell_type {
        CellType::Tri3 => FacetType::Tri3,
        CellType::Tri6 => FacetType::Tri6,
        CellType::Quad4 => FacetType::Quad4,
        CellType::Quad8 => FacetType::Quad8,
        CellType::Quad9 => FacetType::Quad9,
        other => unreachable!("{other:?} in a surface"),
    }
}
