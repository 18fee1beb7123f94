//! Cost of one evaluation in the context form, on one thread, beside the accuracy that it buys.
//!
//! `cargo bench` prints, per case, the time of one evaluation and the crossings (for `exact`: clipped pieces) per
//! second; above each, the error of the nodal forces against the exact estimator, root mean square over eight seeds.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use fmc_contact::{
    Bodies, CellBlock, CellType, Contact, EnergyLaw, Estimator, FiberOptions, Options, Resolution, Surface,
};
use fmc_shapes::{Mesh, ball_tet4, icosphere, rectangle_quad4, star_quad4};

/// Two bodies, their coordinates and what to call them.
struct Case<const D: usize> {
    name: &'static str,
    surface: Surface<D>,
    coords: Vec<[f64; D]>,
}

fn case<const D: usize>(name: &'static str, meshes: &[Mesh<D>; 2], cell_type: Option<CellType>) -> Case<D> {
    let mut both = meshes[0].clone();
    both.append(&meshes[1]);
    let ids: Vec<i64> = (0..both.cell_count()).map(|c| i64::from(c >= meshes[0].cell_count())).collect();
    let surface = match cell_type {
        Some(cell_type) => {
            let block = CellBlock { cell_type, conn: &both.conn };
            Surface::from_cells(&both.coords, &[block], Bodies::Ids(&ids))
        }
        None => Surface::from_facets(&both.coords, &both.facets(), Bodies::Ids(&ids)),
    };
    Case { name, surface: surface.expect("a valid mesh"), coords: both.coords }
}

/// The paper's star, 5 mm deep in its block: 241 and 1 020 nodes.
fn star_and_block() -> Case<2> {
    let star = star_quad4(4, 0.1, 0.03, 12, 2).translated([0.0, -0.007]);
    let block = rectangle_quad4([-0.1, -0.302], [0.1, -0.102], [50, 19]);
    case("star and block", &[star, block], Some(CellType::Quad4))
}

const TOUCH: [f64; 3] = [0.3, 0.4, 1.884_807_682_498_071_6]; // length 1.95: an overlap of 5 % of the radius

fn spheres() -> Case<3> {
    let ball = icosphere(1.0, 5);
    let other = ball.clone().rotated([1.0, 2.0, 3.0], 0.7).translated(TOUCH);
    case("two spheres, 40 960 triangles", &[ball, other], None)
}

fn balls() -> Case<3> {
    let ball = ball_tet4(1.0, 5, 1);
    let other = ball.clone().rotated([1.0, 2.0, 3.0], 0.7).translated(TOUCH);
    case("two balls, 40 960 Tet4", &[ball, other], Some(CellType::Tet4))
}

fn options(estimator: Estimator) -> Options {
    Options { estimator, ..Options::new(EnergyLaw::volume(1.0)) }
}

fn lines(spacing: Option<f64>, seed: u64) -> Options {
    let resolution = spacing.map_or(Resolution::Auto, Resolution::Spacing);
    options(Estimator::Fibers(FiberOptions { resolution, seed, ..FiberOptions::default() }))
}

fn forces<const D: usize>(case: &Case<D>, options: Options) -> Vec<[f64; D]> {
    let contact = Contact::new(case.surface.clone(), options).expect("valid options");
    contact.evaluate(&case.coords).expect("valid coordinates").forces
}

/// Root mean square, over eight seeds, of the relative error of the nodal forces.
fn error<const D: usize>(case: &Case<D>, spacing: Option<f64>) -> f64 {
    let exact = forces(case, options(Estimator::Exact));
    let size: f64 = exact.iter().flatten().map(|f| f * f).sum();
    let squared = |seed| -> f64 {
        let sampled = forces(case, lines(spacing, seed));
        sampled.iter().flatten().zip(exact.iter().flatten()).map(|(f, e)| (f - e).powi(2)).sum()
    };
    ((0..8).map(squared).sum::<f64>() / 8.0 / size).sqrt()
}

fn measure<const D: usize>(criterion: &mut Criterion, case: &Case<D>, what: &str, options: Options) {
    let contact = Contact::new(case.surface.clone(), options).expect("valid options");
    let crossings = contact.evaluate(&case.coords).expect("valid coordinates").crossing_count;
    let mut group = criterion.benchmark_group(case.name);
    group.throughput(Throughput::Elements(crossings as u64));
    // In turn, as a host's coordinates change: at those of the last call a contact need not be brought to them.
    let moved: Vec<[f64; D]> = case.coords.iter().map(|x| x.map(|x| x + 1e-9)).collect();
    let mut turns = [&case.coords, &moved].into_iter().cycle();
    group.bench_function(what, |b| b.iter(|| contact.evaluate(turns.next().expect("without end"))));
    group.finish();
}

fn evaluation(criterion: &mut Criterion) {
    let star = star_and_block();
    let spheres = spheres();
    let balls = balls();
    println!("{}, lines: force error {:.2} %", star.name, 100.0 * error(&star, None));
    measure(criterion, &star, "lines", lines(None, 0));
    measure(criterion, &star, "exact", options(Estimator::Exact));
    for (what, spacing) in [("lines, automatic", None), ("lines, 25 000 crossings", Some(4.25e-3))] {
        println!("{}, {what}: force error {:.2} %", spheres.name, 100.0 * error(&spheres, spacing));
        measure(criterion, &spheres, what, lines(spacing, 0));
    }
    measure(criterion, &balls, "exact", options(Estimator::Exact));
}

criterion_group!(benches, evaluation);
criterion_main!(benches);
