//! Facets around the vertices of a surface.

use crate::geometry::Surface;

/// Facets around every vertex, body by body: bodies may share nodes, and the faces of one are none of another's.
pub(crate) struct FacetsAround {
    /// One vertex after the other, ascending, and where they begin.
    facets: Vec<u32>,
    starts: Vec<usize>,
    /// The body of every facet.
    body: Vec<u32>,
}

impl FacetsAround {
    pub(crate) fn new<const D: usize>(surface: &Surface<D>) -> Self {
        let mut starts = vec![0; surface.nodes.len() + surface.centroids.len() + 1];
        surface.facets.iter().flatten().for_each(|&vertex| starts[vertex as usize + 1] += 1);
        (1..starts.len()).for_each(|k| starts[k] += starts[k - 1]);
        let (mut next, mut facets) = (starts.clone(), vec![0; D * surface.facets.len()]);
        for (number, facet) in surface.facets.iter().enumerate() {
            for &vertex in facet {
                facets[next[vertex as usize]] = number as u32;
                next[vertex as usize] += 1;
            }
        }
        let mut body = vec![0; surface.facets.len()];
        for (number, range) in surface.ranges.iter().enumerate() {
            body[range.clone()].fill(number as u32);
        }
        Self { facets, starts, body }
    }

    /// Around a vertex those of the body that a facet is of, ascending.
    pub(crate) fn of_body(&self, facet: usize, vertex: u32) -> impl Iterator<Item = usize> {
        let all = &self.facets[self.starts[vertex as usize]..self.starts[vertex as usize + 1]];
        all.iter().map(|&other| other as usize).filter(move |&other| self.body[other] == self.body[facet])
    }

    /// The body of a facet.
    pub(crate) fn body(&self, facet: usize) -> u32 {
        self.body[facet]
    }
}
