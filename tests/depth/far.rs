//! Far from the origin, and with slivers: how cells are divided does not depend on rounding.

use crate::depth;
use crate::scene::{Scene, distance, size_sum};
use fmc_shapes::{Mesh, cuboid_hex8, cuboid_pyramid5, cuboid_tet4, cuboid_wedge6};

/// Energy and forces of two blocks, and of the same moved by a vector, in powers of ten of their size.
fn moved(block: &dyn Fn([usize; 3]) -> Mesh<3>) {
    for cells in [[1, 1, 1], [2, 1, 3], [2, 3, 2]] {
        let upper = block([cells[1], cells[2], cells[0]]).rotated([0.3, 1.0, 0.2], 0.4).translated([0.3, 0.2, 0.8]);
        let scene = Scene::of(&[&block(cells), &upper]);
        let here = scene.evaluate(depth(1.0));
        assert!(here.energy > 0.0);
        for power in 0..10 {
            let by = 10f64.powi(power);
            let shift = [0.31 * by, -0.77 * by, 0.55 * by];
            let mut there = scene.clone();
            there.coords.iter_mut().for_each(|x| (0..3).for_each(|i| x[i] += shift[i]));
            let found = there.evaluate(depth(1.0));
            // Of the coordinates' own rounding a small overlap is off by some tens.
            let rounding = 1e-9 + 50.0 * by * f64::EPSILON;
            let off = [
                (found.energy / here.energy - 1.0).abs(),
                distance(&found.forces, &here.forces) / size_sum(&here.forces),
            ];
            assert!(off.iter().all(|off| *off < rounding), "1e{power}, {cells:?}: {off:?}, not {rounding:.1e}");
        }
    }
}

#[test]
fn offsets_change_nothing() {
    moved(&|n| cuboid_tet4([0.0; 3], [1.0; 3], n));
    moved(&|n| cuboid_hex8([0.0; 3], [1.0; 3], n));
    moved(&|n| cuboid_wedge6([0.0; 3], [1.0; 3], n));
    moved(&|n| cuboid_pyramid5([0.0; 3], [1.0; 3], n));
}

/// A layer of cells below the surface that is 1e-2 to 1e-8 of the block thick bears what a thick one bears, and forces are in balance.
#[test]
fn slivers_bear_as_cells_do() {
    let pressed = |thin: Option<f64>| {
        let at = |x: [f64; 3]| {
            if x[2] == -0.25
                && let Some(thin) = thin
            {
                [x[0], x[1], -thin]
            } else {
                x
            }
        };
        let lower = cuboid_tet4([-2.0, -2.0, -1.0], [3.0, 3.0, 0.0], [5, 5, 4]).mapped(at);
        let upper = cuboid_tet4([0.2, 0.3, -1e-3], [0.7, 0.8, 0.5], [3, 3, 3]);
        Scene::of(&[&lower, &upper]).evaluate(depth(1.0))
    };
    let expected = pressed(None).bodies[1].force[2];
    for power in 2..9 {
        let found = pressed(Some(10f64.powi(-power)));
        let sum = (0..3).map(|i| found.forces.iter().map(|f| f[i]).sum::<f64>().abs()).fold(0.0, f64::max);
        assert!(sum < 1e-12 * size_sum(&found.forces), "1e-{power}: {sum:.1e}");
        let force = found.bodies[1].force[2];
        assert!((force / expected - 1.0).abs() < 1e-6, "1e-{power}: {force} of {expected}");
    }
}
