//! What the heights of curved faces add to the depth in the cells below them.
//!
//! Below a facet, and above it, the height is that at the foot of a point on it: a quadratic function of the point's barycentric
//! coordinates λ in the simplex that has the facet for a face. With w those of the foot of its last corner m on the facet, h_a and h_ab the
//! heights of the facet at its corners and in the middle of its edges,
//!
//! ```text
//! h = Σ_a h_a (λ_a + λ_m w_a) + 4 Σ_ab h_ab (λ_a + λ_m w_a)(λ_b + λ_m w_b)
//! ```
//!
//! Its values at the corner m and on the edges to it are those of all simplices there, as means: the function has no step anywhere. Where
//! facets meet at an edge of the body, and have other heights there, it depends on the facets that see it. Those that bend the other way than
//! the curved ones at the edge, a hole the rim of a pin, see the height of these, also on the first row of the face beside them. To all others it
//! is zero at the edge.

use super::divisions::Divisions;
use crate::geometry::boundary::facet_sags::{Bend, FacetSag, edge_count};
use crate::geometry::mesh::cells::Cells;
use crate::geometry::primitives::facet_slopes::foot;
use crate::geometry::{Surface, Vector};
use rustc_hash::{FxHashMap, FxHashSet};

/// A term of the height in a simplex: at a corner, by its number in the cell, or in the middle between two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SagTerm {
    pub(super) corners: [u8; 2],
    pub(super) height: f64,
}

/// Cells, how they are divided, and the heights of the facets.
pub(super) struct HeightsInCells<'a, const D: usize> {
    pub(super) surface: &'a Surface<D>,
    pub(super) cells: &'a Cells,
    pub(super) facets: &'a [FacetSag<D>],
    /// To which side each bends.
    pub(super) bends: &'a [Bend],
    pub(super) divisions: &'a Divisions,
    pub(super) division_of: &'a [u32],
}

/// A corner of simplices, the same in all cells of a body: its nodes, and the bits of their weights.
type Corner = (u32, Vec<(u32, u64)>);

/// Heights at a corner, or between two.
#[derive(Default)]
struct Heights {
    sum: f64,
    count: f64,
    /// That of the first facet there.
    of_facet: Option<f64>,
    /// Of facets that meet at an edge of the body there is none,
    differ: bool,
    /// but for that of the curved ones that fit those which see it: their sum and count, the least and the largest.
    of_fitting: Option<([f64; 2], [f64; 2])>,
}

/// Heights of one curved face at its rim differ by no more than this part, of facets that see it along normals of their own.
const DIFFERS: f64 = 1e-3;

struct Known {
    seen_by: Bend,
    numbers: FxHashMap<Corner, u32>,
    heights: FxHashMap<[u32; 2], Heights>,
}

impl<const D: usize> HeightsInCells<'_, D> {
    /// The terms of every simplex of the cells that have some, as facets that bend so see them.
    pub(super) fn terms(
        &self,
        is_surface: &impl Fn(usize) -> bool,
        seen_by: Bend,
    ) -> FxHashMap<u32, Vec<Vec<SagTerm>>> {
        let mut of_cell: FxHashMap<u32, Vec<usize>> = FxHashMap::default();
        for facet in (0..self.surface.facets.len()).filter(|&facet| is_surface(facet)) {
            of_cell.entry(self.surface.facet_cell[facet]).or_default().push(facet);
        }
        let (mut known, mut nodes) = (Known::new(seen_by), FxHashSet::default());
        // Sums do not depend on an order that is not ours.
        let mut own: Vec<_> = of_cell.iter().collect();
        own.sort_unstable();
        let mut at_surface = Vec::new();
        for (&cell, facets) in own {
            let (_, simplices) = self.divisions.get(self.division_of[cell as usize]);
            for simplex in simplices.iter().filter(|simplex| simplex.is_at_surface) {
                let Some((facet, of_facet)) = self.face_of(cell, &simplex.corners, facets) else { continue };
                let numbers = of_facet.map(|corner| known.number(self.corner(cell, corner)));
                let (sag, bend) = (&self.facets[facet], self.bends[facet]);
                (0..D).for_each(|k| known.add([numbers[k]; 2], sag.at_corners[k], Some(bend)));
                for k in 0..edge_count(D) {
                    known.add([numbers[k], numbers[(k + 1) % D]], sag.at_edges[k], Some(bend));
                }
                at_surface.push((facet, cell, simplex.corners, of_facet, numbers));
            }
        }
        for (facet, cell, corners, of_facet, numbers) in at_surface {
            let mut sag = FacetSag { at_corners: numbers.map(|number| known.height([number; 2])), ..FacetSag::FLAT };
            for k in 0..edge_count(D) {
                sag.at_edges[k] = known.height([numbers[k], numbers[(k + 1) % D]]);
            }
            // A flat face beside a rim has a height by that alone, which says nothing of what is below.
            if !sag.is_flat() && !self.facets[facet].is_flat() {
                self.add_below(cell, &corners, (&sag, &of_facet, &numbers), &mut known);
                let all = corners[..=D].iter().flat_map(|&corner| self.corner(cell, corner).1);
                nodes.extend(all.map(|(node, _)| node));
            }
        }
        let mut found = FxHashMap::default();
        for cell in 0..self.cells.len() as u32 {
            if !self.cells.nodes(cell as usize).iter().any(|node| nodes.contains(node)) {
                continue;
            }
            let (_, simplices) = self.divisions.get(self.division_of[cell as usize]);
            let of_simplices = simplices.iter().map(|simplex| self.terms_of(cell, &simplex.corners, &known));
            let of_simplices: Vec<Vec<SagTerm>> = of_simplices.collect();
            if of_simplices.iter().any(|terms| !terms.is_empty()) {
                found.insert(cell, of_simplices);
            }
        }
        found
    }

    /// Adds what the facet of a simplex says of its last corner, and of the edges to that.
    fn add_below(
        &self,
        cell: u32,
        corners: &[u8; 4],
        (sag, of_facet, numbers): (&FacetSag<D>, &[u8; D], &[u32; D]),
        known: &mut Known,
    ) {
        let Some(&last) = corners[..=D].iter().find(|corner| !of_facet.contains(corner)) else { return };
        let places = of_facet.map(|corner| self.place(cell, corner));
        let Some(w) = foot(&places, &self.place(cell, last)) else { return };
        let number = known.number(self.corner(cell, last));
        let is_edge = |k: usize, a: usize, b: usize| [k, (k + 1) % D] == [a, b] || [(k + 1) % D, k] == [a, b];
        let edge = |a: usize, b: usize| (0..edge_count(D)).find(|&k| is_edge(k, a, b));
        let height = |a: usize, b: usize| edge(a, b).map_or(0.0, |k| sag.at_edges[k]);
        let pairs = (0..D).flat_map(|a| (0..a).map(move |b| (a, b)));
        let products = pairs.map(|(a, b)| w[a] * w[b] * height(a, b)).sum::<f64>();
        known.add([number; 2], sag.at(&w), None);
        for a in 0..D {
            let others = (0..D).filter(|&b| b != a).map(|b| w[b] * height(a, b)).sum::<f64>();
            known.add([numbers[a], number], others - products, None);
        }
    }

    /// The terms of a simplex.
    fn terms_of(&self, cell: u32, corners: &[u8; 4], known: &Known) -> Vec<SagTerm> {
        let number = |&corner: &u8| Some((corner, *known.numbers.get(&self.corner(cell, corner))?));
        let numbers: Vec<(u8, u32)> = corners[..=D].iter().filter_map(number).collect();
        let mut terms = Vec::new();
        for (k, &(p, first)) in numbers.iter().enumerate() {
            for &(q, second) in &numbers[k..] {
                let height = known.height([first, second]);
                if height != 0.0 {
                    terms.push(SagTerm { corners: [p, q], height });
                }
            }
        }
        terms
    }

    /// The facet of a cell that a simplex has for a face, and the numbers of its corners in the cell.
    fn face_of(&self, cell: u32, corners: &[u8; 4], facets: &[usize]) -> Option<(usize, [u8; D])> {
        let faces = facets.iter().filter_map(|&facet| Some((facet, self.corners_in_cell(cell, facet)?)));
        faces.into_iter().find(|(_, of_facet)| of_facet.iter().all(|corner| corners[..=D].contains(corner)))
    }

    /// Numbers of the corners of a facet in its cell: those of nodes, then of the middles of faces.
    fn corners_in_cell(&self, cell: u32, facet: usize) -> Option<[u8; D]> {
        let nodes = self.cells.nodes(cell as usize);
        let mut found = [0; D];
        for (corner, &vertex) in found.iter_mut().zip(&self.surface.facets[facet]) {
            *corner = match self.surface.nodes.get(vertex as usize) {
                None => (nodes.len() + self.surface.facet_source[facet] as usize) as u8,
                Some(node) => nodes.iter().position(|n| n == node)? as u8,
            };
        }
        Some(found)
    }

    /// Weights of the nodes of a cell in a corner of its simplices.
    fn weights(&self, cell: u32, corner: u8) -> impl Iterator<Item = (u32, f64)> {
        let nodes = self.cells.nodes(cell as usize);
        let (points, _) = self.divisions.get(self.division_of[cell as usize]);
        let point = (corner as usize).checked_sub(nodes.len()).map(|point| &points[point].weights);
        let weight = move |k: usize| point.map_or(f64::from(u8::from(k == corner as usize)), |weights| weights[k]);
        nodes.iter().enumerate().map(move |(k, &node)| (node, weight(k))).filter(|(_, weight)| *weight != 0.0)
    }

    fn corner(&self, cell: u32, corner: u8) -> Corner {
        let mut all: Vec<_> = self.weights(cell, corner).map(|(node, weight)| (node, weight.to_bits())).collect();
        all.sort_unstable();
        (self.cells.body[cell as usize], all)
    }

    /// Where a corner lies without deformation.
    fn place(&self, cell: u32, corner: u8) -> Vector<D> {
        let reference = self.surface.reference();
        let terms = self.weights(cell, corner).map(|(node, weight)| Vector::from(reference[node as usize]) * weight);
        terms.fold(Vector::zeros(), |x, term| x + term)
    }
}

impl Known {
    fn new(seen_by: Bend) -> Self {
        Self { seen_by, numbers: FxHashMap::default(), heights: FxHashMap::default() }
    }

    fn number(&mut self, corner: Corner) -> u32 {
        let next = self.numbers.len() as u32;
        *self.numbers.entry(corner).or_insert(next)
    }

    /// Adds a height, of a facet that bends so or below the surface.
    fn add(&mut self, place: [u32; 2], height: f64, of_facet: Option<Bend>) {
        let [p, q] = place;
        let heights = self.heights.entry([p.min(q), p.max(q)]).or_default();
        // Each with the first: a sum of equal heights may be rounded.
        heights.differ |= of_facet.is_some() && *heights.of_facet.get_or_insert(height) != height;
        if of_facet.is_some_and(|bend| bend.fits(self.seen_by)) {
            let ([sum, count], [least, most]) = heights.of_fitting.get_or_insert(([0.0; 2], [height; 2]));
            (*sum, *count) = (*sum + height, *count + 1.0);
            (*least, *most) = (least.min(height), most.max(height));
        }
        heights.sum += height;
        heights.count += 1.0;
    }

    fn height(&self, [p, q]: [u32; 2]) -> f64 {
        match self.heights.get(&[p.min(q), p.max(q)]) {
            Some(heights) if !heights.differ => heights.sum / heights.count,
            Some(Heights { of_fitting: Some(([sum, count], [least, most])), .. })
                if most - least <= DIFFERS * most.abs().max(least.abs()) =>
            {
                sum / count
            }
            _ => 0.0,
        }
    }
}
