//! The fibers that an equilibrium leaves to look at.

use crate::indentation::{case, solved};
use fmc_benchmarks::run::traces;
use fmc_mesh_io::{fiber_grid, read_fibers};
use fmc_solid::statics::Equilibrium;
use std::collections::HashMap;

/// Edges that belong to one cell only, by their ends.
fn boundary(at: &Equilibrium<2>) -> Vec<[[f64; 2]; 2]> {
    let coords = at.coords();
    let mut count: HashMap<[u32; 2], usize> = HashMap::new();
    for number in 0..at.model().parts().len() {
        for (_, nodes) in at.model().cells(number) {
            for k in 0..nodes.len() {
                let [p, q] = [nodes[k], nodes[(k + 1) % nodes.len()]];
                *count.entry([p.min(q), p.max(q)]).or_default() += 1;
            }
        }
    }
    let outer = count.into_iter().filter(|(_, cells)| *cells == 1);
    outer.map(|(edge, _)| edge.map(|node| coords[node as usize])).collect()
}

fn distance(x: &[f64; 2], [p, q]: &[[f64; 2]; 2]) -> f64 {
    let along = [q[0] - p[0], q[1] - p[1]];
    let t = ((x[0] - p[0]) * along[0] + (x[1] - p[1]) * along[1]) / (along[0].powi(2) + along[1].powi(2));
    let t = t.clamp(0.0, 1.0);
    (p[0] + t * along[0] - x[0]).hypot(p[1] + t * along[1] - x[1])
}

#[test]
fn crossings_lie_on_the_block_or_on_the_wedge() {
    let coarse = ["bodies.block.mesh.cells=8", "bodies.block.mesh.shells=24", "contact.stiffness=1e7"];
    let case = case("wedge", None, &[&coarse[..], &["contact.spacing=1e-3"]].concat());
    let at = solved::<2>(&case).equilibrium;
    let traces = traces(&case, &at).unwrap();
    let edges = boundary(&at);
    let (mut on_block, mut on_wedge) = (0, 0);
    for x in traces.iter().flat_map(|trace| &trace.crossings) {
        // The wedge is y = |x|; rounding of coordinates of the block's size.
        let wedge = (x[1] - x[0].abs()).abs() < 1e-12;
        let block = edges.iter().any(|edge| distance(x, edge) < 1e-12);
        assert!(wedge || block, "{x:?} lies on neither");
        on_block += usize::from(block);
        on_wedge += usize::from(wedge);
    }
    // A stretch inside both begins at one of them and ends at the other.
    let crossings: usize = traces.iter().map(|trace| trace.crossings.len()).sum();
    assert!(crossings > 50 && on_block > crossings / 4 && on_wedge > crossings / 4, "{on_block} and {on_wedge}");
}

#[test]
fn a_file_holds_every_crossing() {
    let coarse = ["bodies.block.mesh.cells=[20, 20]", "bodies.punch.mesh.cells=[10, 15]"];
    let case = case("punch", None, &coarse);
    let at = solved::<2>(&case).equilibrium;
    let traces = traces(&case, &at).unwrap();
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("fibers_of_the_punch.vtu");
    fiber_grid(&traces, usize::MAX).write(&path).unwrap();
    let read = read_fibers(&path).unwrap();
    assert_eq!(read.len(), traces.len());
    for (read, trace) in read.iter().zip(&traces) {
        let flat: Vec<[f64; 3]> = trace.crossings.iter().map(|x| [x[0], x[1], 0.0]).collect();
        assert!(read.crossings == flat && flat.len() >= 2, "{read:?}");
    }
    fiber_grid(&traces, 7).write(&path).unwrap();
    assert_eq!(read_fibers(&path).unwrap().len(), 7);
}
