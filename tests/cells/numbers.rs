//! Other numbers of nodes, other orders of cells and of blocks: the same forces.

use crate::scene::{Scene, consistent_lines, distance, exact, norm, table::exactly};
use crate::{boxes, pair, shaken};
use fmc_contact::contact::TangentPart;
use fmc_contact::{EnergyLaw, Options};
use fmc_shapes::Splitmix;

fn shuffled(random: &mut Splitmix, n: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..n).collect();
    (1..n).rev().for_each(|k| order.swap(k, (random.unit() * (k + 1) as f64) as usize));
    order
}

/// The scene with nodes, cells of each block, and blocks in another order; where each node went.
fn renumbered(scene: &Scene<3>, seed: u64) -> (Scene<3>, Vec<usize>) {
    let random = &mut Splitmix::new(seed);
    let place = shuffled(random, scene.coords.len());
    let mut other = scene.clone();
    scene.coords.iter().zip(&place).for_each(|(x, &to)| other.coords[to] = *x);
    let mut ids = &scene.ids[..];
    let mut blocks = Vec::new();
    for (cell_type, conn) in &scene.blocks {
        let size = cell_type.node_count();
        let (of_block, rest) = ids.split_at(conn.len() / size);
        ids = rest;
        let order = shuffled(random, of_block.len());
        let nodes = |&cell: &usize| conn[cell * size..(cell + 1) * size].iter().map(|&n| place[n as usize] as u32);
        let conn: Vec<u32> = order.iter().flat_map(nodes).collect();
        blocks.push((*cell_type, conn, order.iter().map(|&cell| of_block[cell]).collect::<Vec<i64>>()));
    }
    let order = shuffled(random, blocks.len());
    other.blocks = order.iter().map(|&k| (blocks[k].0, blocks[k].1.clone())).collect();
    other.ids = order.iter().flat_map(|&k| blocks[k].2.clone()).collect();
    (other, place)
}

#[test]
fn do_not_matter() {
    let lower = boxes([-0.2, -0.1, -1.0], [1.5, 1.2, 0.0], [3, 2, 3]);
    let upper = boxes([0.1, 0.1, -0.1], [1.3, 1.0, 0.6], [2, 2, 3]);
    let laws = [exact(), exactly(EnergyLaw::depth(5.0)), exactly(EnergyLaw::fiber(5.0)), consistent_lines(0.04, 2)];
    for (k, (below, above)) in lower.iter().zip(upper.iter().rev()).enumerate() {
        let mut scene = pair(below, above);
        scene.coords = shaken(&scene.coords, 0.01, 9);
        let (other, place) = renumbered(&scene, k as u64);
        for options in laws {
            let (expected, found) = (scene.evaluate(options), other.evaluate(options));
            let forces: Vec<[f64; 3]> = place.iter().map(|&to| found.forces[to]).collect();
            assert!((found.volume / expected.volume - 1.0).abs() < 1e-12, "{:?}", options.law);
            let off = distance(&forces, &expected.forces) / norm(&expected.forces);
            assert!(off < 1e-11, "{k}, {:?}: {off}", options.law);
        }
    }
}

/// Nor does the number of threads: the same bits, tangent included.
#[test]
fn of_threads_do_not_matter_to_the_last_bit() {
    let lower = boxes([-0.2, -0.1, -1.0], [1.5, 1.2, 0.0], [3, 3, 3]);
    let upper = boxes([0.1, 0.1, -0.1], [1.3, 1.0, 0.6], [3, 2, 3]);
    for (below, above) in lower.iter().zip(upper.iter().rev()) {
        let mut scene = pair(below, above);
        scene.coords = shaken(&scene.coords, 0.01, 9);
        for options in [exact(), exactly(EnergyLaw::depth(5.0)), exactly(EnergyLaw::fiber(5.0))] {
            let of = |threads: usize| {
                let contact = scene.contact(Options { threads, ..options });
                contact.evaluate_tangent(&scene.coords, TangentPart::Full).expect("valid coordinates")
            };
            let one = of(1);
            assert!([2, 5].map(of).iter().all(|other| *other == one), "{:?}", options.law);
        }
    }
}
