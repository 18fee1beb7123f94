//! The cells of a mesh: checked connectivity, neighbours, orientation.

use super::components::{Components, sorted_ids};
use super::hanging::{HangingNode, LoneFace, Meeting, meetings};
use crate::Error;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Bodies, CellBlock, CellType, Vector};
use std::ops::Range;

/// A number that no node has; pads faces with fewer than four nodes.
const NO_NODE: u32 = u32::MAX;

/// A number that no cell has: what lies behind a face on the boundary.
const NO_CELL: u32 = u32::MAX;

/// Cells with checked connectivity, whatever their types, in the order given.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cells {
    types: Vec<CellType>,
    offsets: Vec<usize>,
    conn: Vec<u32>,
    /// Cells of each block as given: all of one type.
    blocks: Vec<Range<usize>>,
    /// Cell of the same body behind every face; a cell has no more faces than nodes, and shares its place in `conn`.
    neighbours: Vec<u32>,
    /// Pairs of cells of which the first has a face that meets several smaller ones, sorted.
    smaller: Vec<(u32, u32)>,
    /// Nodes that hang in the middle of larger faces.
    hanging: Vec<HangingNode>,
    /// Faces in space that meet smaller ones, with the nodes of these.
    refined: Vec<RefinedFace>,
    /// Whether a cell's node order is opposite to the one that encloses a positive volume.
    flipped: Vec<bool>,
    /// Body index of every cell.
    pub(crate) body: Vec<u32>,
    /// Bit f is set where face f lies on the boundary of the body.
    pub(crate) boundary: Vec<u8>,
}

/// A face in space that meets smaller ones: where it is bent, they do not lie on it, and depth within it is another than on them.
#[derive(Clone, Debug)]
pub(in crate::geometry) struct RefinedFace {
    pub(in crate::geometry) cell: u32,
    pub(in crate::geometry) face: u8,
    /// Nodes of the smaller ones, seen from inside the cell counter-clockwise, as far as the cell is not mirrored.
    pub(in crate::geometry) parts: Vec<Vec<u32>>,
}

/// Face `face` of cell `cell`, found by its sorted nodes.
#[derive(Clone, Copy)]
struct Face {
    key: [u32; 4],
    cell: u32,
    face: u8,
}

impl Cells {
    /// Copies and checks connectivity. Orientation, bodies and boundary are still unset.
    pub(crate) fn new<const D: usize>(node_count: usize, blocks: &[CellBlock]) -> Result<Self, Error> {
        let mut cells = Self { offsets: vec![0], ..Self::default() };
        for (block, CellBlock { cell_type, conn }) in blocks.iter().enumerate() {
            if cell_type.dimension() != D {
                return Err(Error::Dimension { block, expected: D, found: cell_type.dimension() });
            }
            let size = cell_type.node_count();
            if conn.len() % size != 0 {
                return Err(Error::Length { array: "conn", expected: size, found: conn.len() });
            }
            let first = cells.len();
            for nodes in conn.chunks_exact(size) {
                check_nodes(cells.len(), nodes, node_count)?;
                cells.types.push(*cell_type);
                cells.conn.extend_from_slice(nodes);
                cells.offsets.push(cells.conn.len());
            }
            cells.blocks.push(first..cells.len());
        }
        if cells.len() == 0 { Err(Error::Empty) } else { Ok(cells) }
    }

    pub(crate) fn len(&self) -> usize {
        self.types.len()
    }

    pub(crate) fn cell_type(&self, cell: usize) -> CellType {
        self.types[cell]
    }

    /// Whether the node order encloses a negative volume.
    pub(crate) fn is_flipped(&self, cell: usize) -> bool {
        self.flipped[cell]
    }

    pub(crate) fn nodes(&self, cell: usize) -> &[u32] {
        &self.conn[self.offsets[cell]..self.offsets[cell + 1]]
    }

    /// Cells of the same body behind the faces of a cell.
    pub(crate) fn neighbours(&self, cell: usize) -> impl Iterator<Item = &u32> {
        let all = &self.neighbours[self.offsets[cell]..self.offsets[cell + 1]];
        let first = self.smaller.partition_point(|(large, _)| (*large as usize) < cell);
        let smaller = self.smaller[first..].iter().take_while(move |(large, _)| *large as usize == cell);
        all.iter().filter(|&&other| other != NO_CELL).chain(smaller.map(|(_, small)| small))
    }

    /// Faces in space that meet smaller ones.
    pub(in crate::geometry) fn refined(&self) -> &[RefinedFace] {
        &self.refined
    }

    /// Whether faces meet smaller ones.
    pub(crate) fn is_refined(&self) -> bool {
        !self.smaller.is_empty()
    }

    /// Nodes that hang in the middle of larger faces, ascending.
    pub(crate) fn hanging(&self) -> &[HangingNode] {
        &self.hanging
    }

    /// For every block with some of these cells: its type, its cells and their nodes one after the other. Blocks may be many, where
    /// collapsed cells stand between others.
    pub(in crate::geometry) fn blocks_of(
        &self,
        cells: Range<usize>,
    ) -> impl Iterator<Item = (CellType, Range<usize>, &[u32])> {
        let first = self.blocks.partition_point(|block| block.end <= cells.start);
        let within = self.blocks[first..].iter().take_while(move |block| block.start < cells.end);
        within.filter(|block| !block.is_empty()).map(|cells| {
            let conn = &self.conn[self.offsets[cells.start]..self.offsets[cells.end]];
            (self.types[cells.start], cells.clone(), conn)
        })
    }

    /// Cells of every block as given, those without cells left out.
    pub(crate) fn block_ranges(&self) -> impl Iterator<Item = Range<usize>> {
        self.blocks.iter().filter(|cells| !cells.is_empty()).cloned()
    }

    /// Nodes of a face, counter-clockwise seen from outside the body.
    pub(crate) fn face_nodes(&self, cell: usize, face: usize) -> Vec<u32> {
        let nodes = self.nodes(cell);
        let local = self.types[cell].faces()[face].iter().map(|&n| nodes[n]);
        if self.flipped[cell] { local.rev().collect() } else { local.collect() }
    }

    /// Sets bodies, orientation and boundary from the neighbours that share a face.
    pub(crate) fn connect<const D: usize>(&mut self, coords: &[[f64; D]], bodies: Bodies) -> Result<Vec<i64>, Error> {
        let ids: Option<&[i64]> = match bodies {
            Bodies::Connected => None,
            Bodies::Ids(ids) if ids.len() == self.len() => Some(ids),
            Bodies::Ids(ids) => {
                return Err(Error::Length { array: "body_ids", expected: self.len(), found: ids.len() });
            }
        };
        let mut faces = self.faces();
        faces.sort_unstable_by_key(|f| (f.key, f.cell));
        let mut groups = Components::new(self.len());
        let mut lone = Vec::new();
        self.boundary = vec![0; self.len()];
        self.neighbours = vec![NO_CELL; self.conn.len()];
        for same in faces.chunk_by(|f, g| f.key == g.key) {
            let nodes = [same[0].key[0] as usize, same[0].key[1] as usize];
            self.check_repeated(same, ids)?;
            match same {
                [f, g] if ids.is_none_or(|ids| ids[f.cell as usize] == ids[g.cell as usize]) => {
                    let agree = self.cycle(f) != self.cycle(g);
                    if !groups.join(f.cell, g.cell, !agree) {
                        return Err(Error::InconsistentOrientation { facet: g.cell as usize, nodes });
                    }
                    for (here, there) in [(f, g), (g, f)] {
                        self.neighbours[self.offsets[here.cell as usize] + here.face as usize] = there.cell;
                    }
                }
                [] | [_] | [_, _] => {
                    for f in same {
                        self.boundary[f.cell as usize] |= 1 << f.face;
                    }
                    if let [f] = same {
                        lone.push(self.lone_face(f, ids));
                    }
                }
                [_, _, third, ..] => return Err(Error::NonManifold { facet: third.cell as usize, nodes }),
            }
        }
        self.join_refined(&lone, coords, &mut groups)?;
        self.orient(coords, &mut groups)?;
        let labels: Vec<i64> = match ids {
            Some(ids) => ids.to_vec(),
            None => {
                let mut number = vec![-1; self.len()];
                let mut count = 0;
                (0..self.len() as u32)
                    .map(|cell| {
                        let root = groups.find(cell).0 as usize;
                        if number[root] < 0 {
                            number[root] = count;
                            count += 1;
                        }
                        number[root]
                    })
                    .collect()
            }
        };
        let body_ids = sorted_ids(&labels);
        self.body = labels.iter().map(|id| body_ids.partition_point(|b| b < id) as u32).collect();
        Ok(body_ids)
    }

    /// Refuses two cells of one body, among those that share a face, that have all their nodes in common.
    fn check_repeated(&self, same: &[Face], ids: Option<&[i64]>) -> Result<(), Error> {
        for (place, f) in same.iter().enumerate() {
            for g in &same[place + 1..] {
                let cells = [f.cell as usize, g.cell as usize];
                let [nodes, others] = cells.map(|cell| self.nodes(cell));
                let is_one_body = ids.is_none_or(|ids| ids[cells[0]] == ids[cells[1]]);
                if is_one_body && nodes.len() == others.len() && nodes.iter().all(|node| others.contains(node)) {
                    return Err(Error::RepeatedCell { cells });
                }
            }
        }
        Ok(())
    }

    fn lone_face(&self, face: &Face, ids: Option<&[i64]>) -> LoneFace {
        let cell = face.cell as usize;
        let nodes = self.nodes(cell);
        let local = self.types[cell].faces()[face.face as usize];
        LoneFace {
            cell: face.cell,
            face: face.face,
            id: ids.map_or(0, |ids| ids[cell]),
            nodes: local.iter().map(|&n| nodes[n]).collect(),
        }
    }

    /// Takes faces that meet smaller ones for inner faces.
    fn join_refined<const D: usize>(
        &mut self,
        lone: &[LoneFace],
        coords: &[[f64; D]],
        groups: &mut Components,
    ) -> Result<(), Error> {
        let (met, hanging) = meetings(lone, coords)?;
        let area = |face: &LoneFace| area_of(&face.nodes, coords);
        for Meeting { large, small } in met {
            let large = &lone[large];
            let agree = |small: &LoneFace| area(large).dot(&area(small)) < 0.0;
            self.boundary[large.cell as usize] &= !(1 << large.face);
            if D == 3 {
                let part = |face: &usize| {
                    let nodes = lone[*face].nodes.clone();
                    if agree(&lone[*face]) { nodes } else { nodes.into_iter().rev().collect() }
                };
                let parts = small.iter().map(part).collect();
                self.refined.push(RefinedFace { cell: large.cell, face: large.face, parts });
            }
            for small in small.into_iter().map(|face| &lone[face]) {
                if !groups.join(large.cell, small.cell, !agree(small)) {
                    let nodes = [small.nodes[0] as usize, small.nodes[1] as usize];
                    return Err(Error::InconsistentOrientation { facet: small.cell as usize, nodes });
                }
                self.boundary[small.cell as usize] &= !(1 << small.face);
                self.neighbours[self.offsets[small.cell as usize] + small.face as usize] = large.cell;
                self.smaller.push((large.cell, small.cell));
            }
        }
        self.smaller.sort_unstable();
        self.hanging = hanging;
        Ok(())
    }

    fn faces(&self) -> Vec<Face> {
        let mut faces = Vec::new();
        for cell in 0..self.len() {
            let nodes = self.nodes(cell);
            for (face, local) in self.types[cell].faces().iter().enumerate() {
                let mut key = [NO_NODE; 4];
                for (k, &n) in local.iter().enumerate() {
                    key[k] = nodes[n];
                }
                key.sort_unstable();
                faces.push(Face { key, cell: cell as u32, face: face as u8 });
            }
        }
        faces
    }

    /// Orientation of the face as given by the cell: decided by the successor of its lowest node.
    fn cycle(&self, face: &Face) -> bool {
        let cell = face.cell as usize;
        let nodes = self.nodes(cell);
        let local = self.types[cell].faces()[face.face as usize];
        let size = local.len();
        let lowest = (0..size).min_by_key(|&k| nodes[local[k]]).unwrap_or(0);
        let at = |k: usize| nodes[local[k % size]];
        if size == 2 { lowest == 0 } else { at(lowest + 1) < at(lowest + size - 1) }
    }

    /// Turns every connected group of cells so that its volume is positive, then checks each cell.
    fn orient<const D: usize>(&mut self, coords: &[[f64; D]], groups: &mut Components) -> Result<(), Error> {
        let mut volume = vec![0.0; self.len()];
        let relative: Vec<(usize, bool)> = (0..self.len() as u32)
            .map(|cell| {
                let (root, turned) = groups.find(cell);
                (root as usize, turned)
            })
            .collect();
        for (cell, &(root, turned)) in relative.iter().enumerate() {
            let measure: f64 = self.jacobians(cell, coords).sum();
            volume[root] += if turned { -measure } else { measure };
        }
        self.flipped = relative.iter().map(|&(root, turned)| turned != (volume[root] < 0.0)).collect();
        self.check_all(coords)
    }
}

/// Normal of a face times its measure (up to a factor), in the sense of its nodes: 2D to the right of the way.
fn area_of<const D: usize>(nodes: &[u32], coords: &[[f64; D]]) -> Vector<D> {
    let x = |node: u32| Vector::<D>::from(coords[node as usize]);
    let corners = |k: usize| -> [Vector<D>; D] {
        std::array::from_fn(|c| x(nodes[(if c == 0 { 0 } else { k + c - 1 }) % nodes.len()]))
    };
    let parts = if D == 2 { 1..2 } else { 1..nodes.len() - 1 };
    parts.map(|k| area_vector(&corners(k))).sum()
}

/// Checks the ids of one cell or facet.
pub(crate) fn check_nodes(cell: usize, nodes: &[u32], node_count: usize) -> Result<(), Error> {
    for (k, &node) in nodes.iter().enumerate() {
        if node as usize >= node_count {
            return Err(Error::NodeOutOfRange { cell, node: node.into(), node_count });
        }
        if nodes[..k].contains(&node) {
            return Err(Error::RepeatedNode { cell, node: node as usize });
        }
    }
    Ok(())
}
