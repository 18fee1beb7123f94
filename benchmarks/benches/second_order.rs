//! Cost of cells of second order beside the straight cells of the same facets: the parts into which they are divided, handed over
//! as a mesh of their own. One thread; force, and force with tangent.
//!
//! `cargo bench -p fmc-benchmarks --bench second_order` prints the ratios of the medians last.

use criterion::{Criterion, criterion_group, criterion_main};
use fmc_contact::contact::TangentPart;
use fmc_contact::{Bodies, CellBlock, CellType, Contact, EnergyLaw, Estimator, FiberOptions, Options, Surface};
use fmc_shapes::{Mesh, ball_tet4, disc_tri3, second_order};
use std::hint::black_box;
use std::time::Instant;

/// Straight cells of a cell of second order by its points.
const PARTS_OF_TRI6: [&[usize]; 4] = [&[0, 3, 5], &[3, 1, 4], &[5, 4, 2], &[3, 4, 5]];
const PARTS_OF_TET10: [&[usize]; 8] = [
    &[0, 4, 6, 7],
    &[4, 1, 5, 8],
    &[6, 5, 2, 9],
    &[7, 8, 9, 3],
    &[6, 8, 4, 5],
    &[6, 8, 5, 9],
    &[6, 8, 9, 7],
    &[6, 8, 7, 4],
];

/// A contact and the coordinates of its nodes.
struct Case<const D: usize> {
    contact: Contact<D>,
    coords: Vec<[f64; D]>,
}

fn contact<const D: usize>(
    coords: &[[f64; D]],
    cell_type: CellType,
    conn: &[u32],
    in_first: usize,
    options: Options,
) -> Contact<D> {
    let count = conn.len() / cell_type.node_count();
    let ids: Vec<i64> = (0..count).map(|cell| i64::from(cell >= in_first)).collect();
    let surface = Surface::from_cells(coords, &[CellBlock { cell_type, conn }], Bodies::Ids(&ids));
    Contact::new(surface.expect("a valid mesh"), options).expect("options")
}

/// The bodies in cells of second order, and the same facets on straight cells.
fn both<const D: usize>(
    bodies: [Mesh<D>; 2],
    [curved, straight]: [CellType; 2],
    parts: &[&[usize]],
    options: Options,
) -> [Case<D>; 2] {
    let in_first = bodies[0].cell_count();
    let [mut all, other] = bodies;
    all.append(&other);
    let of_curved = contact(&all.coords, curved, &all.conn, in_first, options);
    let weights = of_curved.point_weights();
    let point = |point: usize| {
        let row = weights.row(point);
        row.fold([0.0; D], |x, (node, w)| std::array::from_fn(|axis| x[axis] + w * all.coords[node as usize][axis]))
    };
    let points: Vec<[f64; D]> = (0..weights.point_count()).map(point).collect();
    let conn: Vec<u32> =
        all.cells().flat_map(|cell| parts.iter().flat_map(|part| part.iter().map(|&local| cell[local]))).collect();
    let of_straight = contact(&points, straight, &conn, in_first * parts.len(), options);
    assert_eq!(of_curved.surface().facet_count(), of_straight.surface().facet_count());
    let found = [
        of_curved.evaluate(&all.coords).expect("forces").energy,
        of_straight.evaluate(&points).expect("forces").energy,
    ];
    assert!((found[0] / found[1] - 1.0).abs() < 1e-9 && found[0] > 0.0, "the same facets: {found:?}");
    [Case { contact: of_curved, coords: all.coords }, Case { contact: of_straight, coords: points }]
}

impl<const D: usize> Case<D> {
    /// Coordinates that have moved a little since the last call, so that nothing is kept.
    fn step(&mut self) {
        let shift = self.coords[0][0] * 1e-15 + 1e-12;
        self.coords.iter_mut().for_each(|x| x[0] += shift);
    }

    fn force(&mut self) {
        self.step();
        black_box(self.contact.evaluate(&self.coords).expect("forces"));
    }

    fn tangent(&mut self) {
        self.step();
        black_box(self.contact.evaluate_tangent(&self.coords, TangentPart::Full).expect("forces"));
    }
}

fn measure<const D: usize>(c: &mut Criterion, name: &str, mut cases: [Case<D>; 2]) {
    type Call<const D: usize> = fn(&mut Case<D>);
    for (what, call) in [("force", Case::force as Call<D>), ("force and tangent", Case::tangent)] {
        let mut group = c.benchmark_group(format!("{name}/{what}"));
        for (of, case) in ["second order", "straight"].into_iter().zip(&mut cases) {
            group.bench_function(of, |b| b.iter(|| call(case)));
        }
        group.finish();
        let mut medians = [0.0; 2];
        for (median, case) in medians.iter_mut().zip(&mut cases) {
            let mut times: Vec<f64> = Vec::new();
            for _ in 0..31 {
                let start = Instant::now();
                call(case);
                times.push(start.elapsed().as_secs_f64());
            }
            times.sort_by(f64::total_cmp);
            *median = times[times.len() / 2];
        }
        println!("{name}, {what}: {:.2} times as long ({:.3} ms)", medians[0] / medians[1], 1e3 * medians[0]);
    }
}

fn laws() -> [(&'static str, Options); 4] {
    let exactly = |law| Options { estimator: Estimator::Exact, ..Options::new(law) };
    let lines = |law| Options { estimator: Estimator::Fibers(FiberOptions::default()), ..Options::new(law) };
    [
        ("exact volume", exactly(EnergyLaw::volume(1.0))),
        ("exact fiber", exactly(EnergyLaw::fiber(1.0))),
        ("exact depth", exactly(EnergyLaw::depth(1.0))),
        ("lines fiber", lines(EnergyLaw::fiber(1.0))),
    ]
}

fn second_order_cells(c: &mut Criterion) {
    for (law, options) in laws() {
        let disc = second_order(&disc_tri3(1.0, 256), 6).rounded([0.0; 2], 1.0);
        let other = disc.clone().rotated(0.3).translated([0.01, 1.95]);
        let types = [CellType::Tri6, CellType::Tri3];
        measure(c, &format!("discs of Tri6/{law}"), both([disc, other], types, &PARTS_OF_TRI6, options));
        let ball = second_order(&ball_tet4(1.0, 4, 1), 10).rounded([0.0; 3], 1.0);
        let other = ball.clone().rotated([1.0, 2.0, 3.0], 0.7).translated([0.3, 0.4, 1.884_807_682]);
        let types = [CellType::Tet10, CellType::Tet4];
        measure(c, &format!("balls of Tet10/{law}"), both([ball, other], types, &PARTS_OF_TET10, options));
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = second_order_cells
}
criterion_main!(benches);
