//! What the default law costs on more and more threads, with the same bits on all.
//!
//! `cargo bench -p fmc-benchmarks --bench threads` prints a table up to the threads that the machine has. What was measured is left in
//! out/bench/threads.json for the pages.

mod kept;

use fmc_contact::contact::TangentPart;
use fmc_contact::{Bodies, CellBlock, CellType, Contact, EnergyLaw, Options, Surface};
use fmc_shapes::{Mesh, ball_tet4, cuboid_tet4};
use kept::keep;
use std::time::Instant;

const THREADS: [usize; 5] = [1, 2, 4, 8, 16];
const ROUNDS: usize = 7;

/// Two bodies of tetrahedra in contact.
fn scene(first: Mesh<3>, second: &Mesh<3>) -> (Surface<3>, Vec<[f64; 3]>) {
    let counts = [first.cell_count(), second.cell_count()];
    let mut all = first;
    all.append(second);
    let ids: Vec<i64> = counts.iter().enumerate().flat_map(|(id, &count)| vec![id as i64; count]).collect();
    let block = CellBlock { cell_type: CellType::Tet4, conn: &all.conn };
    (Surface::from_cells(&all.coords, &[block], Bodies::Ids(&ids)).expect("a valid mesh"), all.coords)
}

/// Plates that lie on one another, turned a little: nearly all facets of both are in contact.
fn plates(n: usize) -> (Surface<3>, Vec<[f64; 3]>) {
    let lower = cuboid_tet4([0.0, 0.0, 0.0], [1.0, 1.0, 0.02], [n, n, 1]);
    let upper = cuboid_tet4([0.01, 0.02, 0.019], [1.01, 1.02, 0.039], [n + 1, n - 1, 1]);
    scene(lower, &upper.rotated([0.0, 0.0, 1.0], 0.01))
}

/// Balls that overlap in a lens: a small part of the facets is in contact.
fn balls(n: usize) -> (Surface<3>, Vec<[f64; 3]>) {
    let ball = ball_tet4(1.0, n, 4);
    let other = ball.clone().rotated([1.0, 2.0, 3.0], 0.7).translated([0.3, 0.4, 1.88]);
    scene(ball, &other)
}

/// Least times in milliseconds of forces alone, and of forces and tangent, at coordinates that move a little from call to call; and the forces.
fn times(contact: &Contact<3>, coords: &[[f64; 3]]) -> ([f64; 2], Vec<[f64; 3]>) {
    let mut least = [f64::INFINITY; 2];
    for round in 1..=ROUNDS {
        let moved: Vec<[f64; 3]> = coords.iter().map(|x| [x[0] + 1e-9 * round as f64, x[1], x[2]]).collect();
        let clock = Instant::now();
        drop(contact.evaluate(&moved).expect("forces"));
        least[0] = least[0].min(1e3 * clock.elapsed().as_secs_f64());
        let moved: Vec<[f64; 3]> = moved.iter().map(|x| [x[0], x[1] + 1e-9, x[2]]).collect();
        let clock = Instant::now();
        drop(contact.evaluate_tangent(&moved, TangentPart::Full).expect("a tangent"));
        least[1] = least[1].min(1e3 * clock.elapsed().as_secs_f64());
    }
    (least, contact.evaluate(coords).expect("forces").forces)
}

fn main() {
    let most = std::thread::available_parallelism().map_or(1, usize::from);
    let mut figures = Vec::new();
    for (name, (surface, coords)) in [("plates", plates(63)), ("plates large", plates(140)), ("balls", balls(5))] {
        println!("{name}, {} facets: forces / forces and tangent in ms", surface.facet_count());
        let mut one = None;
        for threads in THREADS.into_iter().filter(|threads| *threads <= most) {
            let options = Options { threads, ..Options::new(EnergyLaw::depth(1.0)) };
            let contact = Contact::new(surface.clone(), options).expect("valid options");
            let ([force, both], forces) = times(&contact, &coords);
            let (first, bits) = one.get_or_insert(([force, both], forces.clone()));
            assert!(*bits == forces, "{threads} threads have other bits than one");
            let gains = [first[0] / force, first[1] / both];
            println!("{threads:>4} threads: {force:.2} / {both:.2} ({:.2} and {:.2} times faster)", gains[0], gains[1]);
            let of_count =
                serde_json::json!({"force": force, "both": both, "force_gain": gains[0], "both_gain": gains[1]});
            figures.push((format!("{name} {threads}"), of_count));
        }
    }
    keep("threads", figures);
}
