//! The faces of bodies as a picture has them: cells in a plane; in space the boundary, seen from above a corner, what is far first.

use super::super::assembly::Assembly;
use super::super::division::Division;
use fmc_mesh_io::Kind;
use std::collections::HashMap;

/// A polygon of the picture.
pub(super) struct Face {
    pub(super) corners: Vec<[f64; 2]>,
    pub(super) body: usize,
}

/// Where a point, or a vector, is in the picture.
pub(super) fn flat<const D: usize>(x: &[f64; D]) -> [f64; 2] {
    if D == 2 {
        return [x[0], x[1]];
    }
    // From (1, 1, 1), z upwards.
    [(x[1] - x[0]) / 2.0_f64.sqrt(), (2.0 * x[2] - x[0] - x[1]) / 6.0_f64.sqrt()]
}

/// How near to the eye, where there is one.
fn nearness<const D: usize>(x: &[f64; D]) -> f64 {
    if D == 2 { 0.0 } else { x.iter().sum() }
}

pub(super) fn faces<const D: usize>(assembly: &Assembly<D>, division: &Division) -> Vec<Face> {
    let mut found: Vec<(f64, Face)> = Vec::new();
    let mut add = |nodes: &mut dyn Iterator<Item = u32>, body: usize| {
        let corners: Vec<&[f64; D]> = nodes.map(|node| &assembly.coords[node as usize]).collect();
        let mean = corners.iter().map(|x| nearness(x)).sum::<f64>() / corners.len() as f64;
        found.push((mean, Face { corners: corners.into_iter().map(flat).collect(), body }));
    };
    if assembly.kind == Kind::Solid {
        // A face of one cell alone is on the boundary.
        let mut seen: HashMap<Vec<u32>, usize> = HashMap::new();
        let of_all = || {
            assembly.cells().zip(&division.cell_bodies).flat_map(|((cell_type, nodes), &body)| {
                cell_type.faces().iter().map(move |face| (face.iter().map(move |&k| nodes[k]), body as usize))
            })
        };
        let sorted = |face: &mut dyn Iterator<Item = u32>| {
            let mut key: Vec<u32> = face.collect();
            key.sort_unstable();
            key
        };
        of_all().for_each(|(mut face, _)| *seen.entry(sorted(&mut face)).or_default() += 1);
        for (mut face, body) in of_all() {
            if seen[&sorted(&mut face.clone())] == 1 {
                add(&mut face, body);
            }
        }
    } else {
        for ((cell_type, nodes), &body) in assembly.cells().zip(&division.cell_bodies) {
            add(&mut nodes[..cell_type.straight().node_count()].iter().copied(), body as usize);
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.into_iter().map(|(_, face)| face).collect()
}
