//! The edges and corners between the flat faces of a convex solid.

use crate::geometry::Vector;
use std::collections::BTreeMap;

/// Where two faces meet: an edge, in 2D a corner.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ridge {
    pub(crate) faces: [u32; 2],
    /// Corners at its ends; in 2D both are the same.
    pub(crate) ends: [u32; 2],
}

/// All of them, and the corners at which edges end, each with those edges; none of the latter in 2D.
pub(crate) struct Ridges {
    pub(crate) ridges: Vec<Ridge>,
    pub(crate) corners: Vec<(u32, Vec<u32>)>,
}

impl Ridges {
    /// Those of faces of one or several facets. An edge that several facets divide is one.
    pub(super) fn new<const D: usize>(facets: &[[u32; D]], points: &[Vector<D>], face_of: &[u32]) -> Self {
        // By the corners of a side of a facet, the faces beside it.
        let mut sides: BTreeMap<[u32; 2], Vec<u32>> = BTreeMap::new();
        for (facet, face) in facets.iter().zip(face_of) {
            for k in 0..D {
                let (p, q) = (facet[(k + 1) % D], facet[(k + D - 1) % D]);
                sides.entry([p.min(q), p.max(q)]).or_default().push(*face);
            }
        }
        let mut between: BTreeMap<[u32; 2], Vec<u32>> = BTreeMap::new();
        for (ends, faces) in &sides {
            for (n, p) in faces.iter().enumerate() {
                for q in faces[n + 1..].iter().filter(|q| *q != p) {
                    between.entry([*p.min(q), *p.max(q)]).or_default().extend(ends);
                }
            }
        }
        let ridge = |(faces, corners): (&[u32; 2], &Vec<u32>)| {
            let from_first = |corner: &u32| points[*corner as usize] - points[corners[0] as usize];
            let farther = |p: Vector<D>, q: Vector<D>| if q.norm() > p.norm() { q } else { p };
            let direction = corners.iter().map(from_first).fold(Vector::zeros(), farther);
            let by_place = |p: &&u32, q: &&u32| {
                let [at_p, at_q] = [p, q].map(|corner| from_first(corner).dot(&direction));
                at_p.total_cmp(&at_q).then(p.cmp(q))
            };
            let ends = corners.iter().min_by(by_place).zip(corners.iter().max_by(by_place));
            ends.map(|(first, last)| Ridge { faces: *faces, ends: [*first, *last] })
        };
        let ridges: Vec<Ridge> = between.iter().filter_map(ridge).collect();
        let mut corners: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (number, ridge) in ridges.iter().enumerate().filter(|(_, ridge)| ridge.ends[0] != ridge.ends[1]) {
            ridge.ends.iter().for_each(|end| corners.entry(*end).or_default().push(number as u32));
        }
        Self { ridges, corners: corners.into_iter().collect() }
    }
}
