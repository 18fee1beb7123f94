//! A body that overlaps itself is two bodies that do.

use crate::depth;
use crate::scene::table::exactly;
use crate::scene::{Scene, distance, size_sum};
use fmc_contact::contact::PairOptions;
use fmc_contact::overlap::Partner;
use fmc_contact::{Bodies, CellBlock, CellType, Contact, ContactForces, EnergyLaw, Options, Surface};
use fmc_shapes::{Diagonals, Mesh, cuboid_tet4, rectangle_quad4, rectangle_tri3};

#[test]
fn two_blocks_under_one_number() {
    let lower = rectangle_tri3([0.0, -1.0], [1.0, 0.0], [5, 5], Diagonals::Same).rotated(0.1);
    let upper = rectangle_tri3([0.1, -0.1], [0.8, 0.6], [3, 4], Diagonals::Alternating);
    as_two(&lower, &upper);
    let lower = cuboid_tet4([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [3, 3, 3]).rotated([1.0, 2.0, 3.0], 0.1);
    let upper = cuboid_tet4([0.1, 0.2, -0.1], [0.8, 0.9, 0.6], [2, 3, 2]);
    as_two(&lower, &upper);
}

fn as_two<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) {
    // Depths are found while they are apart.
    let away = upper.clone().mapped(|x| x.map(|x| x + 5.0));
    let coords = Scene::of(&[lower, upper]).coords;
    let of = |scene: Scene<D>, options| scene.contact(options).evaluate(&coords).expect("valid coordinates");
    let two = of(Scene::of(&[lower, &away]), depth(7.0));
    let one = of(Scene::new().with(lower, 0).with(&away, 0), Options { self_contact: true, ..depth(7.0) });
    assert!(two.volume > 1e-3 && two.energy > 0.0);
    assert!((one.volume - two.volume).abs() < 1e-12, "{} {}", one.volume, two.volume);
    assert!((one.energy - two.energy).abs() < 1e-12 * two.energy);
    assert!(distance(&one.forces, &two.forces) < 1e-12 * size_sum(&two.forces));
    // A mean over all of the boundary of the overlap, or of those over what each body has of it.
    let [of_one, of_two] = [&one, &two].map(|found| found.pairs[0].pressure);
    assert!(of_two > 0.0 && (of_one / of_two - 1.0).abs() < 0.2, "{of_one} {of_two}");
}

/// Of a body in two pieces, one of which has facets where another body lies inside the other piece: both press.
#[test]
fn a_body_in_two_pieces_presses_with_both() {
    let large = rectangle_quad4([0.0, 0.0], [3.0, 3.0], [6, 6]);
    let small = rectangle_quad4([1.5, 1.2], [2.1, 2.1], [3, 4]).rotated(0.1);
    let probe = rectangle_tri3([1.3, 1.4], [1.7, 1.8], [3, 3], Diagonals::Same).rotated(0.03);
    // Depths are found while they are apart.
    let away = small.clone().mapped(|x| x.map(|x| x + 9.0));
    let coords = Scene::of(&[&probe, &large, &small]).coords;
    let of = |scene: Scene<2>, apart: [usize; 2]| {
        let mut contact = scene.contact(depth(7.0));
        let excluded = PairOptions { excluded: true, ..PairOptions::default() };
        if apart[0] != apart[1] {
            contact.set_pair_options(apart.map(Partner::Body), Some(excluded)).expect("two bodies");
        }
        contact.evaluate(&coords).expect("valid coordinates")
    };
    let three = of(Scene::of(&[&probe, &large, &away]), [1, 2]);
    let two = of(Scene::new().with(&probe, 0).with(&large, 1).with(&away, 1), [1, 1]);
    assert!(three.pairs.len() == 2 && three.pairs.iter().all(|pair| pair.energy > 0.0), "{:?}", three.pairs);
    assert!((two.energy / three.energy - 1.0).abs() < 1e-12, "{} {}", two.energy, three.energy);
    assert!(distance(&two.forces, &three.forces) < 1e-12 * size_sum(&three.forces));
}

/// A mesh cut open along an edge line: nodes for which `is_cut` holds are doubled for the cells on the far side of it, which
/// have their middle where `is_beyond` holds. The nodes of those cells.
fn cut_open(
    mesh: &Mesh<2>,
    is_cut: impl Fn(&[f64; 2]) -> bool,
    is_beyond: impl Fn(&[f64; 2]) -> bool,
) -> (Mesh<2>, Vec<bool>) {
    let mut mesh = mesh.clone();
    let count = mesh.coords.len();
    let mut doubled = vec![None; count];
    for cell in mesh.conn.chunks_mut(4) {
        let middle = [0, 1].map(|i| cell.iter().map(|&n| mesh.coords[n as usize][i]).sum::<f64>() / 4.0);
        if is_beyond(&middle) {
            for node in cell {
                let x = mesh.coords[*node as usize];
                if is_cut(&x) {
                    *node = *doubled[*node as usize].get_or_insert_with(|| {
                        mesh.coords.push(x);
                        mesh.coords.len() as u32 - 1
                    });
                }
            }
        }
    }
    let mut of_far_cells = vec![false; mesh.coords.len()];
    for cell in mesh.conn.chunks(4) {
        let middle = [0, 1].map(|i| cell.iter().map(|&n| mesh.coords[n as usize][i]).sum::<f64>() / 4.0);
        cell.iter().for_each(|&n| of_far_cells[n as usize] |= is_beyond(&middle));
    }
    (mesh, of_far_cells)
}

/// A mesh as one body with itself, or as the bodies that hang together, at other coordinates.
fn at(mesh: &Mesh<2>, coords: &[[f64; 2]], options: Options) -> ContactForces<2> {
    let block = CellBlock { cell_type: CellType::Quad4, conn: &mesh.conn };
    let surface = Surface::from_cells(&mesh.coords, &[block], Bodies::Connected).expect("a valid mesh");
    let self_contact = surface.body_count() == 1;
    let contact = Contact::new(surface, Options { self_contact, ..options }).expect("valid options");
    contact.evaluate(coords).expect("valid coordinates")
}

/// Sum of the forces on some nodes, and sum and moment of all, by the sum of sizes.
fn balance(found: &ContactForces<2>, coords: &[[f64; 2]], is_meant: impl Fn(usize) -> bool) -> ([f64; 2], [f64; 3]) {
    let (mut part, mut all) = ([0.0; 2], [0.0; 3]);
    for (n, (f, x)) in found.forces.iter().zip(coords).enumerate() {
        for i in 0..2 {
            all[i] += f[i];
            part[i] += if is_meant(n) { f[i] } else { 0.0 };
        }
        all[2] += x[0] * f[1] - x[1] * f[0];
    }
    (part, all.map(|sum| sum / size_sum(&found.forces)))
}

/// With the law `fiber` the reference is the other one's own two bodies as well.
fn laws() -> [Options; 2] {
    [depth(1e6), exactly(EnergyLaw::fiber(1e6))]
}

/// A square with a slit that closes linearly, 0.001 deep at its mouth, beside the same square cut in two: E = k d² l / 6.
#[test]
fn a_slit_that_closes() {
    let square = rectangle_quad4([0.0; 2], [1.0; 2], [20, 10]);
    let is_upper = |x: &[f64; 2]| x[1] > 0.5;
    let slit = |tip: f64| cut_open(&square, |x| (x[1] - 0.5).abs() < 1e-9 && x[0] > tip + 1e-6, is_upper);
    let ((one, upper_of_one), (two, upper_of_two)) = (slit(0.3), slit(-1.0));
    let closed = |mesh: &Mesh<2>, upper: &[bool]| -> Vec<[f64; 2]> {
        let close = |(x, &upper): (&[f64; 2], &bool)| {
            let is_face = upper && (x[1] - 0.5).abs() < 1e-9;
            [x[0], x[1] - if is_face { 1e-3 * (x[0] - 0.3) / 0.7 } else { 0.0 }]
        };
        mesh.coords.iter().zip(upper).map(close).collect()
    };
    for options in laws() {
        let (x, y) = (closed(&one, &upper_of_one), closed(&two, &upper_of_two));
        let (found, expected) = (at(&one, &x, options), at(&two, &y, options));
        assert!((found.energy / expected.energy - 1.0).abs() < 1e-3, "{} for {}", found.energy, expected.energy);
        assert!((found.energy / (1e6 * 1e-6 * 0.7 / 6.0) - 1.0).abs() < 0.01, "{}", found.energy);
        let (force, sums) = balance(&found, &x, |n| upper_of_one[n] && (one.coords[n][1] - 0.5).abs() < 0.11);
        let of_two = expected.bodies[1].force[1];
        assert!((force[1] / of_two - 1.0).abs() < 5e-3, "{} for {of_two}", force[1]);
        if options.law.is_fiber() {
            continue;
        }
        assert!(sums.iter().all(|sum| sum.abs() < 1e-12), "{sums:?}");
    }
}

/// A U whose arms are bent until they overlap, beside the same U cut in two at its base.
#[test]
fn the_arms_of_a_u() {
    let mut u = rectangle_quad4([-0.45, -0.2], [0.45, 0.0], [18, 4]);
    u.append(&rectangle_quad4([-0.45, 0.0], [-0.05, 1.0], [8, 20]));
    u.append(&rectangle_quad4([0.05, 0.0], [0.45, 1.0], [8, 20]));
    let u = u.welded(1e-9);
    let halves = cut_open(&u, |x| x[0].abs() < 1e-9, |x| x[0] > 0.0).0;
    let bent = |mesh: &Mesh<2>| -> Vec<[f64; 2]> {
        mesh.coords.iter().map(|x| [x[0] - x[0].signum() * 0.06 * x[1].max(0.0).powi(2), x[1]]).collect()
    };
    for options in laws() {
        let (x, y) = (bent(&u), bent(&halves));
        let (found, expected) = (at(&u, &x, options), at(&halves, &y, options));
        assert!(expected.energy > 0.0 && expected.bodies.len() == 2 && found.bodies.len() == 1);
        assert!((found.energy / expected.energy - 1.0).abs() < 1e-3, "{} for {}", found.energy, expected.energy);
        let (force, sums) = balance(&found, &x, |n| u.coords[n][0] > 0.0);
        let of_two = expected.bodies[1].force[0];
        assert!((force[0] / of_two - 1.0).abs() < 1e-3, "{} for {of_two}", force[0]);
        let limit = if options.law.is_fiber() { 1e-3 } else { 1e-12 };
        assert!(sums.iter().all(|sum| sum.abs() < limit), "{sums:?}");
    }
}
