//! Faces between cells of different ranks: they are no surface.

use super::mesh_part::MeshPart;
use super::own_mesh::{OwnMesh, box_of};
use crate::Error;
use crate::geometry::Surface;
use crate::geometry::boundary::facet_sags::MostCurved;
use crate::geometry::boundary::submesh::{LoneFace, Whole};
use crate::geometry::primitives::aabb::Aabb;
use crate::ranks::{Ranks, packed};
use std::collections::{BTreeMap, BTreeSet};

impl<const D: usize> OwnMesh<D> {
    /// Takes a part of a mesh, on all ranks together.
    ///
    /// # Errors
    /// As [`Surface::from_cells`], on the rank whose part is at fault; on others [`Error::OnOtherRank`].
    pub(super) fn new(part: &MeshPart<D>, ranks: &Ranks) -> Result<Self, Error> {
        let mut own = ranks.agree(Self::of(part), D as u64)?;
        let mut ids: Vec<i64> = own.surface.iter().flat_map(|surface| surface.body_ids()).copied().collect();
        ids = ranks
            .gather_lists(&ids.iter().map(|id| *id as u64).collect::<Vec<_>>())?
            .concat()
            .iter()
            .map(|id| *id as i64)
            .collect();
        ids.sort_unstable();
        ids.dedup();
        ranks.agree(if ids.is_empty() { Err(Error::Empty) } else { Ok(()) }, 0)?;
        own.body = part.body_ids.iter().map(|id| ids.partition_point(|other| other < id) as u32).collect();
        own.body_ids = ids;
        let lone = own.surface.as_ref().map_or(Ok(Vec::new()), Surface::lone_faces);
        let lone = ranks.agree(lone, 1)?;
        let Border { surface_faces, first_cells, whole } = find(&own, &lone, ranks)?;
        own.first_cells = own.cells_of(&first_cells);
        (own.surface_faces, own.whole) = (surface_faces, whole);
        let own_surface =
            own.surface.as_mut().map_or(Ok(()), |surface| surface.make_submesh(&own.surface_faces, &own.whole));
        ranks.agree(own_surface, 2)?;
        own.surface_vertices = own.vertices();
        own.whole.most_curved = own.most_curved(ranks)?;
        let sizes = ranks.gather_lists(&[own.mean_extent()])?;
        own.cell_size = sizes.into_iter().flatten().fold(0.0, f64::max);
        Ok(own)
    }
}

impl<const D: usize> OwnMesh<D> {
    /// How curved faces are at most, by body of the whole mesh.
    fn most_curved(&self, ranks: &Ranks) -> Result<Vec<MostCurved>, Error> {
        let mut bodies = vec![MostCurved::default(); self.body_ids.len()];
        for surface in self.surface.iter() {
            for (body, most) in surface.most_curved().into_iter().enumerate() {
                bodies[self.body_of(surface, body)] = most;
            }
        }
        for of_rank in ranks.gather_lists(&bodies)? {
            bodies.iter_mut().zip(of_rank).for_each(|(most, here)| *most = most.max(here));
        }
        Ok(bodies)
    }
}

packed!(MostCurved { height, curvature, rise });

/// What is known where the parts of all ranks have been held against one another.
struct Border<const D: usize> {
    /// Bit f of an own cell: its face f is surface of the whole mesh.
    pub(super) surface_faces: Vec<u8>,
    /// Number of one cell of every body: the first on the surface, whose depths are measured from facets that are near.
    pub(super) first_cells: Vec<u64>,
    pub(super) whole: Whole<D>,
}

/// Body and corners of a face, ascending.
type Key = (u32, Vec<u64>);

/// Finds the surface of the whole mesh among the faces of own cells that have no own cell behind them.
///
/// # Errors
/// [`Error::NonManifold`] for a face of more than two cells.
fn find<const D: usize>(own: &OwnMesh<D>, lone: &[LoneFace], ranks: &Ranks) -> Result<Border<D>, Error> {
    let boxes = boxes(own, ranks)?;
    // Only what lies in the box of another rank can be that one's too.
    let may_have = |corners: &[u32]| -> Vec<usize> {
        let aabb = box_of(corners, &own.reference);
        let aabb = aabb.inflated(aabb.rounding());
        let others = boxes.iter().enumerate().filter(|(rank, _)| *rank != ranks.rank());
        others.filter(|(_, other)| other.meets(&aabb)).map(|(rank, _)| rank).collect()
    };
    let key = |face: &LoneFace| -> Key {
        let mut numbers: Vec<u64> = face.corners.iter().map(|&node| own.node_numbers[node as usize]).collect();
        numbers.sort_unstable();
        (own.body[face.cell], numbers)
    };
    let mut sent = vec![Vec::new(); boxes.len()];
    for face in lone {
        may_have(&face.corners).into_iter().for_each(|rank| sent[rank].push(key(face)));
    }
    let mut of_others: BTreeMap<Key, usize> = BTreeMap::new();
    for key in ranks.exchange(&sent)?.into_iter().flatten() {
        *of_others.entry(key).or_default() += 1;
    }
    let behind: Vec<usize> = lone.iter().map(|face| of_others.get(&key(face)).copied().unwrap_or(0)).collect();
    let crowded = lone.iter().zip(&behind).find(|(_, count)| **count > 1).map_or(Ok(()), |(face, _)| {
        let nodes = [face.corners[0] as usize, face.corners[1] as usize];
        Err(Error::NonManifold { facet: face.cell, nodes })
    });
    ranks.agree(crowded, 3)?;
    let mut surface_faces = vec![0; own.len()];
    for (face, _) in lone.iter().zip(&behind).filter(|(_, count)| **count == 0) {
        surface_faces[face.cell] |= 1 << face.face;
    }
    let (surface_nodes, points) = own.surface.as_ref().map_or_else(
        || (vec![Vec::new(); own.body_ids.len()], vec![0; own.body_ids.len()]),
        |surface| on_surface(own, surface, &surface_faces),
    );
    let mut sent = vec![Vec::new(); boxes.len()];
    let named = |body: usize, node: u32| (body as u32, own.node_numbers[node as usize]);
    for (body, nodes) in surface_nodes.iter().enumerate() {
        for &node in nodes {
            may_have(&[node]).into_iter().for_each(|rank| sent[rank].push(named(body, node)));
        }
    }
    // A node of several ranks counts for the first of them.
    let counted: BTreeSet<(u32, u64)> = ranks.exchange(&sent)?.into_iter().take(ranks.rank()).flatten().collect();
    let first_cells = first_cells(own, &surface_faces);
    let mut sent: Vec<(usize, bool, u64)> = Vec::with_capacity(points.len());
    for (body, nodes) in surface_nodes.iter().enumerate() {
        let is_mine = |node: &&u32| !counted.contains(&named(body, **node));
        let (is_inner, cell) = first_cells[body];
        sent.push((points[body] + nodes.iter().filter(is_mine).count(), is_inner, cell));
    }
    let of_ranks = ranks.gather_lists(&sent)?;
    let of_body = |body: usize| of_ranks.iter().map(move |of_rank| of_rank[body]);
    let surface_node_counts = (0..points.len()).map(|body| of_body(body).map(|(count, ..)| count).sum()).collect();
    let first = |body| of_body(body).map(|(_, is_inner, cell)| (is_inner, cell)).min().map_or(0, |(_, cell)| cell);
    let first_cells = (0..points.len()).map(first).collect();
    let reference_box = boxes.iter().fold(Aabb::empty(), |all, aabb| all.union(aabb));
    Ok(Border {
        surface_faces,
        first_cells,
        whole: Whole { surface_node_counts, reference_box, most_curved: Vec::new() },
    })
}

/// By rank, the box of the nodes of its faces that have no own cell behind them; those of second order bulge beyond their corners.
fn boxes<const D: usize>(own: &OwnMesh<D>, ranks: &Ranks) -> Result<Vec<Aabb<D>>, Error> {
    let nodes = own.surface.iter().flat_map(|surface| &surface.nodes);
    let own_box = box_of(nodes.filter(|node| (**node as usize) < own.node_count()), &own.reference);
    let boxes = ranks.gather_lists(&[[own_box.min, own_box.max]])?.concat();
    Ok(boxes.into_iter().map(|[min, max]| Aabb { min, max }).collect())
}

/// Whether it has no face on the surface, and number of the first own cell of every body, those on the surface before others.
fn first_cells<const D: usize>(own: &OwnMesh<D>, surface_faces: &[u8]) -> Vec<(bool, u64)> {
    let mut first = vec![(true, u64::MAX); own.body_ids.len()];
    for ((&body, faces), &number) in own.body.iter().zip(surface_faces).zip(&own.cell_numbers) {
        let first = &mut first[body as usize];
        *first = (*first).min((*faces == 0, number));
    }
    first
}

/// Own nodes on the surface of the whole mesh, by body, and how many other points there are of cells of second order.
fn on_surface<const D: usize>(
    own: &OwnMesh<D>,
    surface: &Surface<D>,
    surface_faces: &[u8],
) -> (Vec<Vec<u32>>, Vec<usize>) {
    let mut nodes = vec![BTreeSet::new(); own.body_ids.len()];
    for facet in surface.boundary_facets() {
        if let (Some(cell), Some(face)) = (facet.cell, facet.local_face)
            && surface_faces[cell] >> face & 1 == 1
        {
            nodes[own.body[cell] as usize].extend(facet.nodes);
        }
    }
    let is_node = |node: &u32| (*node as usize) < own.node_count();
    let points = nodes.iter().map(|nodes| nodes.iter().filter(|node| !is_node(node)).count()).collect();
    (nodes.into_iter().map(|nodes| nodes.into_iter().filter(is_node).collect()).collect(), points)
}
