//! Gaps as constraints: their values in closed form, and their derivatives against differences.

use crate::scene::{Scene, by_lines, exact};
use fmc_contact::contact::GapConstraints;
use fmc_contact::overlap::Partner;
use fmc_contact::{Contact, EnergyLaw, Error, Obstacle, Pose, Shape};
use fmc_shapes::{Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_tet4, disc_tri3, rectangle_quad4, rectangle_tri3};

/// A flat face over another: every row of its nodes has the gap, apart and overlapping, and the areas are the face.
fn flat<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>, area: f64) {
    for gap in [0.3, 1e-3, -1e-3] {
        let moved = upper.clone().mapped(|mut x| {
            x[D - 1] += gap;
            x
        });
        let scene = Scene::of(&[lower, &moved]);
        let found = scene.contact(exact()).gap_constraints(&scene.coords, 0.5).expect("gaps");
        let rows: Vec<usize> = (0..found.nodes.len())
            .filter(|&r| found.partners[r][0] == Partner::Body(1))
            .filter(|&r| scene.coords[found.nodes[r] as usize][D - 1] == gap)
            .collect();
        // Walls beside the face are not counted at its rim.
        assert_eq!(rows.len(), scene.nodes_of(1).filter(|&n| scene.coords[n][D - 1] == gap).count());
        for &r in &rows {
            assert!((found.gaps[r] / found.areas[r] - gap).abs() < 1e-12, "{gap}: {}", found.gaps[r] / found.areas[r]);
        }
        let sum: f64 = rows.iter().map(|&r| found.areas[r]).sum();
        assert!((sum - area).abs() < 1e-12, "{sum}");
    }
}

#[test]
fn of_flat_faces() {
    let lower = rectangle_tri3([-1.0, -1.0], [2.0, 0.0], [7, 2], Diagonals::Same);
    flat(&lower, &rectangle_quad4([0.0, 0.0], [1.0, 1.0], [5, 3]), 1.0);
    let lower = cuboid_tet4([-1.0, -1.0, -1.0], [2.0, 2.0, 0.0], [3, 3, 1]);
    flat(&lower, &cuboid_hex8([0.0; 3], [1.0; 3], [3, 3, 2]), 1.0);
}

/// Under a translation of everything no gap changes, and the derivative is that of the gaps.
fn follows<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], is_free: bool) {
    const REACH: f64 = 0.3;
    let at = |coords: &[[f64; D]]| contact.gap_constraints(coords, REACH).expect("gaps");
    let found = at(coords);
    assert!(found.gaps.iter().any(|g| *g < 0.0), "nothing is met");
    let entries = |r: usize| found.row_starts[r]..found.row_starts[r + 1];
    let size = found.slopes.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    for r in 0..found.nodes.len() {
        let columns = &found.columns[entries(r)];
        assert!(columns.windows(2).all(|pair| pair[0] < pair[1]) && columns.contains(&found.nodes[r]));
        let sum: [f64; D] = std::array::from_fn(|i| found.slopes[entries(r)].iter().map(|s| s[i]).sum());
        assert!(!is_free || sum.iter().all(|s| s.abs() < 1e-12 * size), "{sum:?}");
    }
    let row_of = |of: &GapConstraints<D>, r: usize| {
        (0..of.nodes.len()).find(|&k| of.nodes[k] == found.nodes[r] && of.partners[k] == found.partners[r])
    };
    let mut random = Splitmix::new(7);
    // Where a nearest point passes an edge within the step, the difference is spoiled.
    let (mut seen, mut missed) = (0, 0);
    for _ in 0..6 {
        let way: Vec<[f64; D]> = coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        let h = 1e-6;
        let moved = |h: f64| -> Vec<[f64; D]> {
            coords.iter().zip(&way).map(|(x, w)| std::array::from_fn(|i| x[i] + h * w[i])).collect()
        };
        let (more, less) = (at(&moved(h)), at(&moved(-h)));
        for r in 0..found.nodes.len() {
            let (Some(p), Some(m)) = (row_of(&more, r), row_of(&less, r)) else { continue };
            let slope = (more.gaps[p] - less.gaps[m]) / (2.0 * h);
            let said: f64 = entries(r)
                .map(|e| (0..D).map(|i| found.slopes[e][i] * way[found.columns[e] as usize][i]).sum::<f64>())
                .sum();
            seen += 1;
            missed += usize::from((slope - said).abs() > 1e-6 * size);
        }
    }
    println!("{missed} of {seen} differences crossed an edge");
    assert!(seen >= 30 && missed * 50 <= seen, "{missed} of {seen}");
}

#[test]
fn derivatives() {
    let upper = disc_tri3(0.5, 24).translated([0.1, 0.47]);
    let lower = rectangle_quad4([-1.0, -1.0], [1.0, 0.0], [6, 2]);
    let scene = Scene::of(&[&lower, &upper]);
    follows(&scene.contact(exact()), &scene.coords, true);
    let mut random = Splitmix::new(3);
    let lower = cuboid_tet4([-1.0, -1.0, -1.0], [1.0, 1.0, 0.0], [3, 3, 2]);
    let upper = cuboid_hex8([-0.5, -0.4, -0.03], [0.4, 0.5, 0.8], [2, 3, 2]);
    let mut scene = Scene::of(&[&lower, &upper]);
    scene.coords.iter_mut().flatten().for_each(|x| *x += random.between(-0.02, 0.02));
    follows(&scene.contact(exact()), &scene.coords, true);
}

#[test]
fn over_obstacles() {
    let block = rectangle_tri3([-0.5, 0.0], [0.5, 0.5], [6, 3], Diagonals::Alternating);
    let scene = Scene::of(&[&block]);
    for (shape, pose) in [
        (Shape::HalfSpace, Pose::at([0.0, 0.01])),
        (Shape::Ball { radius: 0.7 }, Pose::at([0.03, -0.69])),
        (Shape::Cuboid { half_extents: [0.3, 0.2] }, Pose::at([0.03, -0.19])),
    ] {
        let mut contact = scene.contact(exact());
        contact.add_obstacle(Obstacle { shape, pose }).expect("an obstacle");
        follows(&contact, &scene.coords, false);
    }
}

/// Laws and estimators have no part in it, what is out of reach has no row, and a reach must be one.
#[test]
fn depend_on_nothing_else() {
    let lower = rectangle_tri3([0.0, -1.0], [1.0, 0.0], [4, 4], Diagonals::Same);
    let scene = Scene::of(&[&lower, &rectangle_quad4([0.2, 0.1], [0.8, 0.5], [3, 2])]);
    let [one, other] = [exact(), by_lines(EnergyLaw::fiber(3.0))].map(|options| scene.contact(options));
    let found = one.gap_constraints(&scene.coords, 0.15).expect("gaps");
    assert_eq!(found, other.gap_constraints(&scene.coords, 0.15).expect("gaps"));
    assert!(!found.nodes.is_empty());
    assert!(one.gap_constraints(&scene.coords, 0.09).expect("gaps").nodes.is_empty());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(one.gap_constraints(&scene.coords, bad), Err(Error::NotPositive { name: "reach", .. })));
    }
}
