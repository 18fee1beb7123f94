//! Cost of the internal force, the inner loop of explicit dynamics, per Gauss point and on one thread.
//!
//! `cargo bench -p fmc-benchmarks --bench elements` prints Gauss points per second as `elem/s`.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use fmc_contact::CellType;
use fmc_shapes::{Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4};
use fmc_solid::fem::{Law, Material, Model, Part};

fn measure<const D: usize>(c: &mut Criterion, cell_type: CellType, mesh: Mesh<D>, points_per_cell: u64) {
    let mut group = c.benchmark_group(format!("internal force/{cell_type:?}"));
    group.throughput(Throughput::Elements(points_per_cell * mesh.cell_count() as u64));
    for law in [Law::LinearElastic, Law::NeoHookean] {
        let material = Material { law, young: 73.2e6, poisson: 0.4, density: 1010.0 };
        let part = Part { name: String::new(), cell_type, mesh: mesh.clone(), material };
        let model = Model::new(vec![part]).expect("a valid part");
        let displacement: Vec<[f64; D]> = model.coords().iter().map(|x| x.map(|x| 0.01 * (x + x * x))).collect();
        let mut force = displacement.clone();
        group.bench_function(format!("{law:?}"), |b| b.iter(|| model.internal(&displacement, &mut force)));
    }
}

fn elements(c: &mut Criterion) {
    measure(c, CellType::Quad4, rectangle_quad4([0.0; 2], [1.0; 2], [32, 32]), 4);
    measure(c, CellType::Tri3, rectangle_quad4([0.0; 2], [1.0; 2], [32, 32]).triangulated(), 1);
    measure(c, CellType::Tet4, cuboid_tet4([0.0; 3], [1.0; 3], [26; 3]), 1);
    measure(c, CellType::Hex8, cuboid_hex8([0.0; 3], [1.0; 3], [16; 3]), 8);
}

criterion_group!(benches, elements);
criterion_main!(benches);
