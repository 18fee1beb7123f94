//! Rigid faces look at what they are to press.

use super::Bodies;
use crate::Fault;
use crate::read::Deck;
use fmc_mesh_io::in_space;
use std::collections::{BTreeMap, BTreeSet};

/// Part of the thickness of a layer behind which nothing can be that presses its face: from there on its back is nearer.
const AT_BACK: f64 = 0.5;

/// A node at the front of a layer.
#[derive(Default)]
struct Corner {
    place: [f64; 3],
    thickness: f64,
    /// Of the faces about it: the outward unit normal, and the unit vector towards the middle.
    faces: Vec<[[f64; 3]; 2]>,
}

/// Nodes at the front of the layers among these bodies.
fn corners<const D: usize>(deck: &Deck, bodies: Bodies<D>, of: &BTreeSet<usize>) -> Vec<Corner> {
    let mut found: BTreeMap<u32, Corner> = BTreeMap::new();
    for ((_, nodes, ..), body) in deck.mesh.cells().zip(&bodies.places.body_of) {
        if !of.contains(body) || !bodies.places.is_layer[*body] {
            continue;
        }
        let count = if matches!(nodes.len(), 6 | 15) { 3 } else { 4 };
        // Of each corner, the place of its node and of that behind it.
        let pairs: Vec<[usize; 2]> = match D {
            2 => vec![[1, 2], [0, 3]],
            _ => (0..count).map(|k| [k + count, k]).collect(),
        };
        let at = |k: usize| deck.mesh.points[nodes[k] as usize];
        let front: Vec<[f64; 3]> = pairs.iter().map(|[front, _]| at(*front)).collect();
        // The front face has these in a circle; in the plane the second direction is across it.
        let [u, v] = match front[..] {
            [a, b] => [way(a, b), [0.0, 0.0, 1.0]],
            [a, b, c] => [way(a, b), way(a, c)],
            _ => [way(front[0], front[2]), way(front[1], front[3])],
        };
        let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let middle: [f64; 3] = std::array::from_fn(|k| front.iter().map(|x| x[k]).sum::<f64>() / front.len() as f64);
        for [front, back] in pairs {
            let outwards = way(at(back), at(front));
            let length = dot(normal, normal).sqrt() * dot(normal, outwards).signum();
            let inside = way(at(front), middle);
            let half = dot(inside, inside).sqrt();
            let corner = found.entry(nodes[front]).or_default();
            (corner.place, corner.thickness) = (at(front), dot(outwards, outwards).sqrt());
            corner.faces.push([normal.map(|n| n / length), inside.map(|x| x / half)]);
        }
    }
    found.into_values().collect()
}

/// Of the two surfaces of a contact pair, with the bodies of each, a rigid one does not have all of the other behind it.
pub(super) fn check_looks<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    (line, names): (usize, &[String; 2]),
    both: &[BTreeSet<usize>; 2],
) -> Result<(), Fault> {
    for (rigid, other) in [(0, 1), (1, 0)] {
        let corners = corners(deck, bodies, &both[rigid]);
        let apart = both[other].iter().filter(|body| !bodies.places.is_layer[**body]);
        // How far a node is behind the faces about the nearest corner, by the thickness there.
        let behind = |node: usize| {
            let x = in_space(&bodies.model.coords()[node]);
            let from = |corner: &Corner| {
                let mut way = way(corner.place, x);
                way[2] *= f64::from(u8::from(D == 3));
                way
            };
            let distance = |corner: &Corner| dot(from(corner), from(corner));
            let nearest = corners.iter().min_by(|p, q| distance(p).total_cmp(&distance(q)))?;
            // The face that it is most over tells; beside the edges of all, any.
            let along = nearest.faces.iter().map(|[normal, inside]| [*inside, *normal].map(|v| dot(v, from(nearest))));
            let [over, before] = along.clone().max_by(|p, q| p[0].total_cmp(&q[0]))?;
            let any = along.map(|[_, before]| before).fold(f64::NEG_INFINITY, f64::max);
            Some(-(if over > 0.0 { before } else { any }) / nearest.thickness)
        };
        let mut is_deep = false;
        // One node before it is enough.
        let is_behind = apart.flat_map(|body| bodies.model.nodes_of(*body)).filter_map(behind).all(|depth| {
            is_deep |= depth > AT_BACK;
            depth >= -1e-9
        });
        if is_behind && is_deep {
            let [a, b] = [&names[rigid], &names[other]];
            let message = format!(
                "all of {b} lies behind {a}: name the other side of its elements, SPOS or SNEG, or turn its profile round, whose outside is to the left"
            );
            return Err(Fault::new(line, message));
        }
    }
    Ok(())
}

fn way(from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| to[k] - from[k])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}
