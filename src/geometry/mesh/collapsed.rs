//! Cells that name nodes repeatedly, taken for the smaller cells that they are.
//!
//! Meshers of hexahedra write wedges, pyramids and tetrahedra as hexahedra whose nodes fall together (Abaqus, Ansys), and triangles as
//! quadrilaterals. Which cell it is follows from its faces: of each, nodes that repeat one another count once, and what is left of them
//! must be the faces of a cell that there is. All others stay as they are, and are refused for the repeated node.

use crate::geometry::second_order::middle_edges;
use crate::geometry::{CellBlock, CellType};
use std::collections::BTreeMap;

/// Blocks without repeated nodes. Cells count as they were given.
pub(in crate::geometry) struct Collapsed {
    pub(in crate::geometry) blocks: Vec<(CellType, Vec<u32>)>,
    pub(in crate::geometry) faces: FacesAsGiven,
}

/// By cell that has become another one: for each of its faces, that of the cell as given, as VTK counts them.
pub(in crate::geometry) type FacesAsGiven = BTreeMap<u32, Vec<usize>>;

impl Collapsed {
    /// `None` where no cell has become another one, and where the blocks are no cells of this dimension, for others to refuse.
    pub(in crate::geometry) fn of<const D: usize>(blocks: &[CellBlock]) -> Option<Self> {
        let is_sound = |block: &CellBlock| {
            block.cell_type.dimension() == D && block.conn.len().is_multiple_of(block.cell_type.node_count())
        };
        let repeats = |block: &CellBlock| block.conn.chunks_exact(block.cell_type.node_count()).any(has_repeated);
        if !blocks.iter().all(is_sound) || !blocks.iter().any(repeats) {
            return None;
        }
        let mut found = Self { blocks: Vec::new(), faces: BTreeMap::new() };
        let mut cell = 0;
        for block in blocks {
            // What is one block stays one as far as it can.
            let mut last = None;
            for nodes in block.conn.chunks_exact(block.cell_type.node_count()) {
                let smaller = has_repeated(nodes).then(|| Smaller::of(block.cell_type, nodes)).flatten();
                let cell_type = smaller.as_ref().map_or(block.cell_type, |smaller| smaller.cell_type);
                if last != Some(cell_type) {
                    found.blocks.push((cell_type, Vec::new()));
                    last = Some(cell_type);
                }
                let conn = found.blocks.last_mut().map(|(_, conn)| conn);
                let own = smaller.as_ref().map_or(nodes, |smaller| &smaller.nodes);
                conn.into_iter().for_each(|conn| conn.extend_from_slice(own));
                if let Some(smaller) = smaller {
                    found.faces.insert(cell, smaller.faces);
                }
                cell += 1;
            }
        }
        (!found.faces.is_empty()).then_some(found)
    }
}

fn has_repeated(nodes: &[u32]) -> bool {
    nodes.iter().enumerate().any(|(k, node)| nodes[..k].contains(node))
}

/// The cell that one with repeated nodes is.
struct Smaller {
    cell_type: CellType,
    nodes: Vec<u32>,
    /// The face as given for each of its faces, as VTK counts them.
    faces: Vec<usize>,
}

impl Smaller {
    fn of(given: CellType, nodes: &[u32]) -> Option<Self> {
        let straight = given.straight();
        let least = straight.dimension();
        let mut rings: Vec<(usize, Vec<u32>)> = Vec::new();
        for (face, local) in straight.faces().iter().enumerate() {
            let mut ring: Vec<u32> = local.iter().map(|&k| nodes[k]).collect();
            ring.dedup();
            if ring.len() > 1 && ring.first() == ring.last() {
                ring.pop();
            }
            if has_repeated(&ring) {
                return None;
            }
            if ring.len() >= least {
                rings.push((face, ring));
            }
        }
        let (smaller, corners) = corners_of(&rings)?;
        let faces = smaller.faces().iter().map(|local| {
            let face: Vec<u32> = local.iter().map(|&k| corners[k]).collect();
            let same = |(_, ring): &&(usize, Vec<u32>)| is_turned(ring, &face);
            rings.iter().find(same).map(|(face, _)| straight.vtk_face(*face))
        });
        let faces = faces.collect::<Option<Vec<usize>>>()?;
        if straight == given {
            return Some(Self { cell_type: smaller, nodes: corners, faces });
        }
        let cell_type = of_second_order(given, smaller)?;
        let nodes = with_middles(given, nodes, cell_type, corners)?;
        Some(Self { cell_type, nodes, faces })
    }
}

/// The straight cell with these faces, seen from outside counter-clockwise, and its corners.
fn corners_of(rings: &[(usize, Vec<u32>)]) -> Option<(CellType, Vec<u32>)> {
    let of_size = |size: usize| rings.iter().map(|(_, ring)| ring).filter(move |ring| ring.len() == size);
    let others = |base: &[u32]| {
        let mut rest: Vec<u32> = rings.iter().flat_map(|(_, ring)| ring).copied().collect();
        rest.retain(|node| !base.contains(node));
        rest.sort_unstable();
        rest.dedup();
        rest
    };
    // The first face of a cell is seen from outside, its nodes are in the order from inside.
    let from_inside = |ring: &[u32]| -> Vec<u32> { ring.iter().rev().copied().collect() };
    match [2, 3, 4].map(|size| of_size(size).count()) {
        [3, 0, 0] => Some((CellType::Tri3, rings.iter().map(|(_, edge)| edge[0]).collect())),
        [0, 4, 0] => {
            let base = from_inside(of_size(3).next()?);
            let [apex] = others(&base)[..] else { return None };
            Some((CellType::Tet4, [&base[..], &[apex]].concat()))
        }
        [0, 4, 1] => {
            let base = from_inside(of_size(4).next()?);
            let [apex] = others(&base)[..] else { return None };
            Some((CellType::Pyramid5, [&base[..], &[apex]].concat()))
        }
        [0, 2, 3] => {
            let base = from_inside(of_size(3).next()?);
            let rest = others(&base);
            let next_to = |node: u32| {
                let sides = of_size(4).flat_map(|ring| (0..4).map(|k| [ring[k], ring[(k + 1) % 4]]));
                let mut ends = sides.filter(|ends| ends.contains(&node)).flatten();
                ends.find(|end| rest.contains(end))
            };
            let top = base.iter().map(|&node| next_to(node)).collect::<Option<Vec<u32>>>()?;
            Some((CellType::Wedge6, [base, top].concat()))
        }
        _ => None,
    }
}

/// Whether two faces are one, begun at another node.
fn is_turned(ring: &[u32], face: &[u32]) -> bool {
    let size = ring.len();
    size == face.len() && (0..size).any(|shift| (0..size).all(|k| ring[(k + shift) % size] == face[k]))
}

/// The cell of second order, serendipity as the given one is.
fn of_second_order(given: CellType, straight: CellType) -> Option<CellType> {
    match (given, straight) {
        // Nodes in the middle of faces would be in none of the smaller cells.
        (CellType::Quad9 | CellType::Hex27, _) => None,
        (_, CellType::Tri3) => Some(CellType::Tri6),
        (_, CellType::Tet4) => Some(CellType::Tet10),
        (_, CellType::Pyramid5) => Some(CellType::Pyramid13),
        (_, CellType::Wedge6) => Some(CellType::Wedge15),
        _ => None,
    }
}

/// Corners, and the nodes in the middle of their edges. An edge without length has its corner there; edges that have become one have one
/// node.
fn with_middles(given: CellType, nodes: &[u32], smaller: CellType, corners: Vec<u32>) -> Option<Vec<u32>> {
    let key = |a: u32, b: u32| [a.min(b), a.max(b)];
    let mut middles = BTreeMap::new();
    for (ends, &middle) in middle_edges(given).iter().zip(&nodes[given.straight().node_count()..]) {
        let [a, b] = ends.map(|k| nodes[k]);
        let expected = if a == b { a } else { *middles.entry(key(a, b)).or_insert(middle) };
        if middle != expected {
            return None;
        }
    }
    let mut all = corners;
    for [a, b] in middle_edges(smaller) {
        let middle = *middles.get(&key(all[*a], all[*b]))?;
        all.push(middle);
    }
    (!has_repeated(&all)).then_some(all)
}
