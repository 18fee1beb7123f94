//! The cells that all ranks have, since they may be in contact.

use super::anchors::Anchors;
use super::own_mesh::{OwnMesh, SentCell};
use crate::Error;
use crate::geometry::{Bodies, CellBlock, CellType, Surface, Vector};
use crate::ranks::{Ranks, packed};
use std::collections::BTreeMap;

/// A node as it is sent.
#[derive(Clone, Debug)]
struct SentNode<const D: usize> {
    number: u64,
    reference: Vector<D>,
    in_symmetry_plane: bool,
}

packed!(SentNode<D> { number, reference, in_symmetry_plane });

/// A facet, whatever else was gathered: its cell and the face of it, and its place among the parts of that face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct FacetName {
    pub(super) cell: u64,
    pub(super) face: u32,
    pub(super) part: u32,
}

/// Numbers of what was gathered, in the order in which it is numbered here.
#[derive(Clone, Debug, Default)]
pub(super) struct Zone {
    pub(super) nodes: Vec<u64>,
    /// The own node of each, where there is one.
    pub(super) own: Vec<Option<u32>>,
    /// The rank that tells where it is.
    sender: Vec<u32>,
    pub(super) cells: Vec<u64>,
    pub(super) facets: Vec<FacetName>,
}

impl Zone {
    /// Gathers own cells of all ranks, and those from whose facets their depths are measured. `in_symmetry_plane` marks own
    /// nodes. Returns the surface, and the nodes marked.
    pub(super) fn gather<const D: usize>(
        own: &OwnMesh<D>,
        selected: &[u32],
        anchors: Option<&Anchors<D>>,
        in_symmetry_plane: &[bool],
        ranks: &Ranks,
    ) -> Result<(Self, Surface<D>, Vec<bool>), Error> {
        let mut selected = selected.to_vec();
        selected.extend(&own.first_cells);
        selected.sort_unstable();
        selected.dedup();
        let mut found = Gathered::<D>::default();
        found.add(own, &selected, in_symmetry_plane, ranks)?;
        if let Some(anchors) = anchors {
            let place = |number: u64| found.nodes[&number].1.reference;
            let mut others = anchors.of_cells(&found.cells, place, ranks)?;
            others.retain(|cell| selected.binary_search(cell).is_err());
            found.add(own, &others, in_symmetry_plane, ranks)?;
        }
        let built = found.build(own);
        ranks.agree(built, 4)
    }

    /// Coordinates of the nodes, of the own coordinates of all ranks.
    ///
    /// # Errors
    /// [`Error::RanksDiffer`] where a node is in two places.
    pub(super) fn coords<const D: usize>(&self, own: &[[f64; D]], ranks: &Ranks) -> Result<Vec<[f64; D]>, Error> {
        let here = ranks.rank() as u32;
        let of_node = |(own_node, sender): (&Option<u32>, &u32)| {
            own_node.filter(|_| *sender == here).map(|node| own[node as usize])
        };
        let sent: Vec<[f64; D]> = self.own.iter().zip(&self.sender).filter_map(of_node).collect();
        let mut received: Vec<_> = ranks.gather_lists(&sent)?.into_iter().map(Vec::into_iter).collect();
        let next = |sender: &u32| {
            received.get_mut(*sender as usize).and_then(Iterator::next).ok_or(Error::RanksDiffer { rank: 0 })
        };
        let coords: Vec<[f64; D]> = self.sender.iter().map(next).collect::<Result<_, _>>()?;
        let elsewhere = self.own.iter().zip(&coords).zip(&self.sender).find(|((own_node, x), _)| {
            own_node.is_some_and(|node| own[node as usize].map(f64::to_bits) != x.map(f64::to_bits))
        });
        ranks.agree(elsewhere.map_or(Ok(()), |(_, &rank)| Err(Error::RanksDiffer { rank: rank as usize })), 5)?;
        Ok(coords)
    }

    /// Number of every facet here.
    pub(super) fn facet_numbers(&self) -> BTreeMap<FacetName, usize> {
        self.facets.iter().enumerate().map(|(number, name)| (*name, number)).collect()
    }
}

/// What came from all ranks.
#[derive(Default)]
struct Gathered<const D: usize> {
    cells: Vec<SentCell>,
    /// By number, with the first rank that sent it.
    nodes: BTreeMap<u64, (u32, SentNode<D>)>,
}

impl<const D: usize> Gathered<D> {
    fn add(&mut self, own: &OwnMesh<D>, cells: &[u32], in_symmetry_plane: &[bool], ranks: &Ranks) -> Result<(), Error> {
        let mut nodes: Vec<u32> = cells.iter().flat_map(|&cell| own.nodes(cell as usize)).copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        let sent = nodes.iter().map(|&node| SentNode {
            number: own.node_numbers[node as usize],
            reference: own.reference[node as usize].into(),
            in_symmetry_plane: in_symmetry_plane.get(node as usize).copied().unwrap_or(false),
        });
        let sent: Vec<SentNode<D>> = sent.collect();
        for (rank, nodes) in ranks.gather_lists(&sent)?.into_iter().enumerate() {
            for node in nodes {
                self.nodes.entry(node.number).or_insert((rank as u32, node));
            }
        }
        let sent: Vec<SentCell> = cells.iter().map(|&cell| own.sent(cell as usize)).collect();
        self.cells.extend(ranks.gather_lists(&sent)?.into_iter().flatten());
        Ok(())
    }

    fn build(mut self, own: &OwnMesh<D>) -> Result<(Zone, Surface<D>, Vec<bool>), Error> {
        self.cells.sort_unstable_by_key(|cell| cell.number);
        if self.cells.windows(2).any(|two| two[0].number == two[1].number) {
            return Err(Error::Unsupported {
                what: "a cell that two parts of a mesh have, or a number that two cells have",
            });
        }
        let nodes: Vec<u64> = self.nodes.keys().copied().collect();
        let node = |number: &u64| nodes.partition_point(|other| other < number) as u32;
        let mut blocks: Vec<(CellType, Vec<u32>)> = Vec::new();
        for cell in &self.cells {
            let Some(kind) = CellType::of_vtk_number(cell.kind.into()) else {
                return Err(Error::Unsupported { what: "a cell of a type that only another rank knows" });
            };
            match blocks.last_mut().filter(|(last, _)| *last == kind) {
                Some((_, conn)) => conn.extend(cell.nodes.iter().map(node)),
                None => blocks.push((kind, cell.nodes.iter().map(node).collect())),
            }
        }
        let blocks: Vec<CellBlock> =
            blocks.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
        let ids: Vec<i64> = self.cells.iter().map(|cell| own.body_ids[cell.body as usize]).collect();
        let reference: Vec<[f64; D]> = self.nodes.values().map(|(_, node)| node.reference.into()).collect();
        let mut surface = Surface::from_cells(&reference, &blocks, Bodies::Ids(&ids))?;
        let surface_faces: Vec<u8> = self.cells.iter().map(|cell| cell.surface_faces).collect();
        surface.make_submesh(&surface_faces, &own.whole)?;
        let cells: Vec<u64> = self.cells.iter().map(|cell| cell.number).collect();
        let mut parts: BTreeMap<(u64, u32), u32> = BTreeMap::new();
        let names = surface.boundary_facets().into_iter().map(|facet| {
            let (cell, face) = (cells[facet.cell.unwrap_or(0)], facet.local_face.unwrap_or(0) as u32);
            let next = parts.entry((cell, face)).or_default();
            *next += 1;
            FacetName { cell, face, part: *next - 1 }
        });
        let facets = names.collect();
        let zone = Zone {
            own: nodes.iter().map(|&number| own.node_of(number)).collect(),
            sender: self.nodes.values().map(|(rank, _)| *rank).collect(),
            nodes,
            cells,
            facets,
        };
        Ok((zone, surface, self.nodes.values().map(|(_, node)| node.in_symmetry_plane).collect()))
    }
}
