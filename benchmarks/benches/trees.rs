//! The tree of boxes beside parry's `Bvh`, in one run: building, refitting, queries by a box, pairs of two trees.
//!
//! Boxes are those of the facets of two spheres that overlap by 5 % of their radius, 163 840 triangles in all. Each row is
//! the least of [`ROUNDS`] times, in milliseconds, and what parry takes in parts of the own tree's time.

#![allow(dead_code, missing_docs)]

#[path = "../../src/geometry/primitives/aabb.rs"]
mod aabb;
#[path = "../../src/geometry/primitives/tree.rs"]
mod tree;

use aabb::Aabb;
use fmc_shapes::{Mesh, icosphere};
use geometry::Vector;
use parry3d_f64::bounding_volume::{Aabb as TheirBox, BoundingVolume};
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use std::hint::black_box;
use std::time::Instant;
use tree::Tree;

/// What these files import.
mod geometry {
    /// Point or vector of `D` components.
    pub(crate) type Vector<const D: usize> = nalgebra::SVector<f64, D>;
}

const ROUNDS: usize = 9;

fn boxes(mesh: &Mesh<3>) -> Vec<Aabb<3>> {
    let corner = |&node: &u32| Vector::<3>::from(mesh.coords[node as usize]);
    mesh.facets().iter().map(|facet| Aabb::of(&facet.each_ref().map(corner))).collect()
}

fn theirs(aabb: &Aabb<3>) -> TheirBox {
    let [mins, maxs] = [aabb.min, aabb.max].map(|x| [x[0], x[1], x[2]].into());
    TheirBox { mins, maxs }
}

/// Least time of a call in milliseconds, and what it returned.
fn least<T>(mut call: impl FnMut() -> T) -> (f64, T) {
    let mut best = f64::INFINITY;
    for _ in 1..ROUNDS {
        let start = Instant::now();
        black_box(call());
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
    }
    (best, call())
}

fn row<T: PartialEq + std::fmt::Debug>(what: &str, own: (f64, T), parry: (f64, T)) {
    assert_eq!(own.1, parry.1, "{what}");
    println!("{what:10} {:9.3} {:9.3}   parry / own {:.2}", own.0, parry.0, parry.0 / own.0);
}

fn main() {
    let ball = icosphere(1.0, 6);
    let other = ball.clone().rotated([1.0, 2.0, 3.0], 0.7).translated([0.3, 0.4, 1.884_807_682_498_071_6]);
    let [a, b] = [boxes(&ball), boxes(&other)];
    let [pa, pb] = [&a, &b].map(|boxes| boxes.iter().map(theirs).collect::<Vec<_>>());
    println!("{} boxes      own     parry  (ms)", a.len() + b.len());

    let built = least(|| Tree::new(&a));
    for strategy in [BvhBuildStrategy::Binned, BvhBuildStrategy::Ploc] {
        let parry = least(|| Bvh::from_leaves(strategy, &pa));
        row("build", (built.0, ()), (parry.0, ()));
    }
    let (mut tree, there) = (built.1, Tree::new(&b));
    let (mut bvh, bvh_there) =
        (Bvh::from_leaves(BvhBuildStrategy::Binned, &pa), Bvh::from_leaves(BvhBuildStrategy::Binned, &pb));

    // The boxes stay where they are: what is written is the same, the work too.
    let own = least(|| {
        let of_leaf: Vec<Aabb<3>> = (tree.leaves())
            .map(|items| items.iter().fold(Aabb::empty(), |sum, &i| sum.union(&a[i as usize])))
            .collect();
        tree.refit(&|leaf| of_leaf[leaf], false);
    });
    let mut workspace = BvhWorkspace::default();
    let parry = least(|| {
        for (leaf, aabb) in pa.iter().enumerate() {
            bvh.insert_or_update_partially(*aabb, leaf as u32, 0.0);
        }
        bvh.refit(&mut workspace);
    });
    row("refit", own, parry);

    let queries: Vec<usize> = (0..b.len()).step_by(41).collect();
    let large: Vec<Aabb<3>> = queries.iter().map(|&q| b[q].inflated(0.05)).collect();
    let own = least(|| {
        let mut found = 0usize;
        for query in &large {
            tree.visit(|node| node.meets(query), |item| found += usize::from(a[item as usize].meets(query)));
        }
        found
    });
    let theirs: Vec<TheirBox> = large.iter().map(theirs).collect();
    let parry = least(|| {
        theirs
            .iter()
            .map(|query| bvh.intersect_aabb(query).filter(|&leaf| pa[leaf as usize].intersects(query)).count())
            .sum()
    });
    row("boxes", own, parry);

    let own = least(|| {
        let mut pairs = 0usize;
        tree.visit_pairs(&there, [&a, &b], |_, _| pairs += 1);
        pairs
    });
    let parry = least(|| {
        let pairs = bvh.leaf_pairs(&bvh_there, |p, q| p.intersects(q));
        pairs.filter(|&(i, j)| pa[i as usize].intersects(&pb[j as usize])).count()
    });
    row("pairs", own, parry);
}
