//! Cost of the exact estimator inside an explicit step, on one thread, with every energy law.
//!
//! Two impacts, each in the positions that it passes: far apart, apart but with boxes that meet, and overlapping.
//! The internal force of a linear element host costs 0.25–0.4 ms (star) and 8–10 ms (blocks) on one core of the same
//! machine; contact is meant to stay below a fifth of that.

use criterion::{Criterion, criterion_group, criterion_main};
use fmc_contact::{Bodies, CellBlock, CellType, Contact, EnergyLaw, Estimator, Options, Surface};
use fmc_shapes::{Mesh, cuboid_tet4, rectangle_quad4, star_quad4};
use std::time::Duration;

/// A moving body against a resting one, and how far it has come towards it in every position.
struct Impact<const D: usize> {
    name: &'static str,
    cell_type: CellType,
    moving: Mesh<D>,
    resting: Mesh<D>,
    /// Travel along the last axis.
    positions: &'static [(&'static str, f64)],
}

/// The paper's star, 192 Quad4, falls on a block of 950 Quad4. Its tip touches the block at 0.
fn star() -> Impact<2> {
    let moving = star_quad4(4, 0.1, 0.03, 12, 2).translated([0.0013, 0.0]);
    let resting = rectangle_quad4([-0.1, -0.3], [0.1, -0.1], [50, 19]);
    let positions = &[("apart", 0.01), ("1 mm deep", -1e-3), ("5 mm deep", -5e-3), ("20 mm deep", -2e-2)];
    Impact { name: "star on block, 1 142 Quad4", cell_type: CellType::Quad4, moving, resting, positions }
}

/// A block on a block, face on face, meshes 21 : 20 and 50 mm off each other: 100 920 Tet4, cells of 0.05 m.
/// The faces bulge by a twentieth of a cell, as those of a deformed body do.
fn blocks() -> Impact<3> {
    let resting = cuboid_tet4([0.0; 3], [1.0; 3], [20, 20, 20]);
    let mut moving = cuboid_tet4([0.03, 0.02, 1.0], [1.03, 1.02, 2.0], [21, 21, 20]);
    for x in &mut moving.coords {
        x[2] += 0.0025 * (3.0 * x[0]).cos() * (2.0 * x[1]).cos() * (2.0 - x[2]);
    }
    let positions = &[
        ("apart", 0.1),
        ("boxes meet", 0.0025),
        ("1 % of a cell deep", -0.0005),
        ("half a cell deep", -0.025),
        ("three cells deep", -0.15),
    ];
    Impact { name: "block on block, 100 920 Tet4", cell_type: CellType::Tet4, moving, resting, positions }
}

fn measure<const D: usize>(criterion: &mut Criterion, impact: &Impact<D>) {
    let mut both = impact.moving.clone();
    both.append(&impact.resting);
    let ids: Vec<i64> = (0..both.cell_count()).map(|c| i64::from(c >= impact.moving.cell_count())).collect();
    let block = CellBlock { cell_type: impact.cell_type, conn: &both.conn };
    let surface = Surface::from_cells(&both.coords, &[block], Bodies::Ids(&ids)).expect("a valid mesh");
    let laws = [("volume", EnergyLaw::volume(1.0)), ("fiber", EnergyLaw::fiber(1.0)), ("depth", EnergyLaw::depth(1.0))];
    let mut group = criterion.benchmark_group(impact.name);
    for (position, travel) in impact.positions {
        let mut coords = both.coords.clone();
        coords[..impact.moving.coords.len()].iter_mut().for_each(|x| x[D - 1] += travel);
        for (law, energy) in laws {
            let options = Options { estimator: Estimator::Exact, ..Options::new(energy) };
            let contact = Contact::new(surface.clone(), options).expect("valid options");
            let forces = contact.evaluate(&coords).expect("valid coordinates");
            println!(
                "{position}, {law}: {} facets, {} pieces, V = {:e}",
                forces.facet_count, forces.crossing_count, forces.volume
            );
            group.bench_function(format!("{position}, {law}"), |b| b.iter(|| contact.evaluate(&coords)));
        }
    }
    group.finish();
}

fn impacts(criterion: &mut Criterion) {
    measure(criterion, &star());
    measure(criterion, &blocks());
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(30).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2));
    targets = impacts
}
criterion_main!(benches);
