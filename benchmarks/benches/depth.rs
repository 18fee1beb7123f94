//! What an evaluation of the law `depth` costs beside `volume` and `fiber`, all exact: the least of several times on one
//! thread, in one run.
//!
//! `cargo bench -p fmc-benchmarks --bench depth` prints a table.

use fmc_contact::contact::TangentPart;
use fmc_contact::{Bodies, CellBlock, CellType, Contact, EnergyLaw, Estimator, Options, Surface};
use fmc_shapes::{Mesh, ball_tet4, cuboid_tet4};
use std::time::Instant;

/// A law of a stiffness.
type Law = fn(f64) -> EnergyLaw;

const LAWS: [Law; 3] = [EnergyLaw::volume, EnergyLaw::fiber, EnergyLaw::depth];

fn main() {
    println!("{:34} {:>9} {:>9} {:>9} {:>9}   ms, and by that of volume", "", "volume", "fiber", "depth", "tangent");
    for (cells, name) in [(8, "8² on 10²"), (16, "16² on 20²")] {
        for by_h in [0.05, 0.3, 1.5] {
            let fine = cells * 5 / 4;
            let lower = block([0.0, 0.0, -0.5], [1.0, 1.0, 0.0], [fine, fine, fine / 2], 1);
            let upper = block([0.0; 3], [1.0, 1.0, 0.5], [cells, cells, cells / 2], 2);
            row(&format!("face {name}, {by_h} h deep"), &lower, &upper, by_h / fine as f64);
        }
    }
    for (layers, name) in [(6, "h = 0.15"), (11, "h = 0.09")] {
        for depth in [0.02, 0.1] {
            let level = if layers > 8 { 4 } else { 3 };
            let lower = ball_tet4(1.0, level, layers);
            let upper = ball_tet4(1.0, level, layers).rotated([1.0, 2.0, 3.0], 0.3).translated([0.0, 0.0, 2.0]);
            row(&format!("balls of radius 1, {name}, {depth} deep"), &lower, &upper, depth);
        }
    }
}

/// A block whose inner nodes are moved at random.
fn block(low: [f64; 3], high: [f64; 3], cells: [usize; 3], seed: u64) -> Mesh<3> {
    let inner = |x: &[f64; 3]| (0..3).all(|i| x[i] > low[i] + 1e-9 && x[i] < high[i] - 1e-9);
    cuboid_tet4(low, high, cells).jittered(0.2, seed, inner)
}

fn row(name: &str, lower: &Mesh<3>, upper: &Mesh<3>, depth: f64) {
    let mut all = lower.clone();
    all.append(upper);
    let mut ids = vec![0; lower.cell_count()];
    ids.resize(lower.cell_count() + upper.cell_count(), 1);
    let block = CellBlock { cell_type: CellType::Tet4, conn: &all.conn };
    let surface = Surface::from_cells(&all.coords, &[block], Bodies::Ids(&ids)).expect("a valid mesh");
    let mut coords = all.coords.clone();
    coords[lower.coords.len()..].iter_mut().for_each(|x| x[2] -= depth);
    let contact = |law: Law| {
        let options = Options { estimator: Estimator::Exact, ..Options::new(law(1.0)) };
        Contact::new(surface.clone(), options).expect("valid options")
    };
    let mut times: Vec<f64> = (LAWS.iter())
        .map(|law| least(&coords, &contact(*law), |contact, x| drop(contact.evaluate(x).expect("a force"))))
        .collect();
    times.push(least(&coords, &contact(EnergyLaw::depth), |contact, x| {
        drop(contact.tangent(x, TangentPart::Full).expect("a tangent"));
    }));
    let ratios: Vec<String> = times.iter().map(|time| format!("{:.1}", time / times[0])).collect();
    let times: Vec<String> = times.iter().map(|time| format!("{time:9.2}")).collect();
    println!("{name:34} {}   {}", times.join(" "), ratios.join(" "));
}

/// Least time in milliseconds at coordinates that move a little from call to call, as a host's do.
fn least(coords: &[[f64; 3]], contact: &Contact<3>, work: impl Fn(&Contact<3>, &[[f64; 3]])) -> f64 {
    (0..8).fold(f64::INFINITY, |least, round| {
        let shift = 1e-9 * f64::from(round);
        let moved: Vec<[f64; 3]> = coords.iter().map(|x| [x[0] + shift, x[1], x[2]]).collect();
        let start = Instant::now();
        work(contact, &moved);
        if round == 0 { least } else { least.min(1e3 * start.elapsed().as_secs_f64()) }
    })
}
