//! What friction costs: evaluation and tangent with it beside those without, and a step begun and committed, all exact: the least
//! of several times on one thread, in one run.
//!
//! `cargo bench -p fmc-benchmarks --bench friction` prints a table.

use fmc_contact::contact::{Friction, TangentPart};
use fmc_contact::{Bodies, CellBlock, CellType, Contact, EnergyLaw, Estimator, Options, Surface};
use fmc_shapes::{Mesh, cuboid_tet4};
use std::time::Instant;

/// A law of a stiffness.
type Law = fn(f64) -> EnergyLaw;

const LAWS: [(Law, &str); 2] = [(EnergyLaw::depth, "depth"), (EnergyLaw::fiber, "fiber")];

fn main() {
    println!("{:30} force, ms   with   tangent, ms   with   begin + commit, by the force", "");
    for (law, name) in LAWS {
        for (cells, faces) in [(8, "8² on 10²"), (16, "16² on 20²")] {
            for by_h in [0.005, 0.05, 0.3] {
                let fine = cells * 5 / 4;
                let lower = block([0.0, 0.0, -0.5], [1.0, 1.0, 0.0], [fine, fine, fine / 2], 1);
                let upper = block([0.0; 3], [1.0, 1.0, 0.5], [cells, cells, cells / 2], 2);
                row(&format!("{name}, {faces}, {by_h} h"), law(1.0), &lower, &upper, by_h / fine as f64);
            }
        }
    }
}

/// A block whose inner nodes are moved at random.
fn block(low: [f64; 3], high: [f64; 3], cells: [usize; 3], seed: u64) -> Mesh<3> {
    let inner = |x: &[f64; 3]| (0..3).all(|i| x[i] > low[i] + 1e-9 && x[i] < high[i] - 1e-9);
    cuboid_tet4(low, high, cells).jittered(0.2, seed, inner)
}

fn row(name: &str, law: EnergyLaw, lower: &Mesh<3>, upper: &Mesh<3>, depth: f64) {
    let mut all = lower.clone();
    all.append(upper);
    let mut ids = vec![0; lower.cell_count()];
    ids.resize(lower.cell_count() + upper.cell_count(), 1);
    let block = CellBlock { cell_type: CellType::Tet4, conn: &all.conn };
    let surface = Surface::from_cells(&all.coords, &[block], Bodies::Ids(&ids)).expect("a valid mesh");
    let mut start = all.coords.clone();
    start[lower.coords.len()..].iter_mut().for_each(|x| x[2] -= depth);
    // A tenth of the penetration sideways: some stick, and some slide.
    let mut coords = start.clone();
    coords[lower.coords.len()..].iter_mut().for_each(|x| x[0] += 0.1 * depth * x[1]);
    let contact = |coefficient: f64| {
        let friction = Friction { coefficient, ..Friction::default() };
        let options = Options { estimator: Estimator::Exact, friction, ..Options::new(law) };
        let mut contact = Contact::new(surface.clone(), options).expect("valid options");
        if coefficient > 0.0 {
            contact.begin_step(&start).expect("a step");
        }
        contact
    };
    let (mut smooth, mut rough) = (contact(0.0), contact(0.3));
    let force = |contact: &mut Contact<3>, x: &[[f64; 3]]| drop(contact.evaluate(x).expect("a force"));
    let tangent =
        |contact: &mut Contact<3>, x: &[[f64; 3]]| drop(contact.tangent(x, TangentPart::Full).expect("a tangent"));
    let forces = [&mut smooth, &mut rough].map(|contact| least(&coords, contact, force));
    let tangents = [&mut smooth, &mut rough].map(|contact| least(&coords, contact, tangent));
    let step = least(&coords, &mut rough, |contact, x| {
        contact.commit_step(x).expect("a committed step");
        contact.begin_step(x).expect("a step");
    });
    println!(
        "{name:30} {:9.2} {:6.2} {:13.2} {:6.2} {:8.2}",
        forces[0],
        forces[1] / forces[0],
        tangents[0],
        tangents[1] / tangents[0],
        step / forces[0],
    );
}

/// Least time in milliseconds at coordinates that move a little from call to call, as a host's do.
fn least(coords: &[[f64; 3]], contact: &mut Contact<3>, work: impl Fn(&mut Contact<3>, &[[f64; 3]])) -> f64 {
    (0..8).fold(f64::INFINITY, |least, round| {
        let shift = 1e-9 * f64::from(round);
        let moved: Vec<[f64; 3]> = coords.iter().map(|x| [x[0] + shift, x[1], x[2]]).collect();
        let start = Instant::now();
        work(contact, &moved);
        if round == 0 { least } else { least.min(1e3 * start.elapsed().as_secs_f64()) }
    })
}
