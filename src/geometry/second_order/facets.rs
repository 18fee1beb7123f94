//! Facets of second order that are given without cells, divided as the faces of cells are.

use super::division::{Division, Points};
use super::entities::Entities;
use crate::Error;
use crate::geometry::mesh::cells::check_nodes;
use crate::geometry::{CellType, FacetBlock, FacetType};

impl Entities {
    /// Those of a facet of second order; `None` for straight ones.
    fn of_facet(facet_type: FacetType) -> Option<Self> {
        match facet_type {
            FacetType::Line3 => Some(Self { corners: 2, edges: &[[0, 1]], quads: &[], has_middle: false }),
            FacetType::Tri6 => Self::of(CellType::Tri6),
            FacetType::Quad8 => Self::of(CellType::Quad8),
            FacetType::Quad9 => Self::of(CellType::Quad9),
            _ => None,
        }
    }

    /// The straight parts of a facet by their points: one at every corner, and that between the middles of a triangle.
    fn parts_of_facet(&self) -> Vec<Vec<usize>> {
        let at = |corner| (0..self.corners).map(|other| self.between(corner, other)).collect();
        let inner = (self.corners == 3).then(|| vec![3, 4, 5]);
        (0..self.corners).map(at).chain(inner).collect()
    }
}

impl Division {
    /// The straight parts of facets, in their order, and the division; `None` where all are straight.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::Dimension`], [`Error::NodeOutOfRange`], [`Error::RepeatedNode`],
    /// [`Error::NonConforming`].
    pub(crate) fn of_facets<const D: usize>(
        node_count: usize,
        blocks: &[FacetBlock],
    ) -> Result<(Option<Self>, Vec<Vec<u32>>), Error> {
        let mut facets = Vec::new();
        for (block, FacetBlock { facet_type, conn }) in blocks.iter().enumerate() {
            if facet_type.dimension() != D {
                return Err(Error::Dimension { block, expected: D, found: facet_type.dimension() });
            }
            let size = facet_type.node_count();
            if conn.len() % size != 0 {
                return Err(Error::Length { array: "conn", expected: size, found: conn.len() });
            }
            for nodes in conn.chunks_exact(size) {
                check_nodes(facets.len(), nodes, node_count)?;
                facets.push((*facet_type, nodes));
            }
        }
        let is_straight = |facet_type: FacetType| facet_type.corner_count() == facet_type.node_count();
        if facets.iter().all(|(facet_type, _)| is_straight(*facet_type)) {
            return Ok((None, facets.into_iter().map(|(_, nodes)| nodes.to_vec()).collect()));
        }
        let mut points = Points::of_facets(node_count);
        let mut all = Self::none(node_count);
        all.starts.push(0);
        let mut parts = Vec::new();
        for (number, &(facet_type, nodes)) in facets.iter().enumerate() {
            all.corners.extend_from_slice(&nodes[..facet_type.corner_count()]);
            all.starts.push(all.corners.len());
            let before = parts.len();
            match Entities::of_facet(facet_type) {
                Some(entities) => {
                    let local = points.of_cell(number as u32, nodes, &entities)?;
                    let of_part = |part: Vec<usize>| part.into_iter().map(|point| local[point]).collect();
                    parts.extend(entities.parts_of_facet().into_iter().map(of_part));
                }
                None => {
                    points.all_corners(number as u32, nodes)?;
                    parts.push(nodes.to_vec());
                }
            }
            all.facets.extend((before..parts.len()).map(|_| number as u32));
        }
        if D == 3 {
            // In the plane an edge belongs to one facet only: its chord may be another's.
            for (number, (_, nodes)) in facets.iter().enumerate().filter(|(_, (of, _))| is_straight(*of)) {
                let edges = (0..nodes.len()).map(|k| [nodes[k], nodes[(k + 1) % nodes.len()]]);
                points.check_straight(number, edges)?;
            }
        }
        all.interpolation = points.interpolation(node_count, parts.iter().flatten());
        Ok((Some(all), parts))
    }
}
