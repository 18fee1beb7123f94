//! The exact estimator in 2D against independent clipping, pair by pair.

use crate::halfspaces::overlap;
use crate::scene::{Scene, distance, exact, norm};
use fmc_shapes::{
    Diagonals, Mesh, Splitmix, disc_tri3, fan_tri3, random_polygon, rectangle_tri3, star_polygon, star_tri3,
};

/// Area of the part of one convex polygon inside another, both counter-clockwise (Sutherland and Hodgman 1974).
fn common_area(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let mut piece = a.to_vec();
    for (k, p) in b.iter().enumerate() {
        let q = b[(k + 1) % b.len()];
        let left = |x: &[f64; 2]| (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
        let mut kept = Vec::new();
        for (m, x) in piece.iter().enumerate() {
            let y = piece[(m + 1) % piece.len()];
            let (s, t) = (left(x), left(&y));
            if s >= 0.0 {
                kept.push(*x);
            }
            if s * t < 0.0 {
                kept.push(std::array::from_fn(|i| x[i] + s / (s - t) * (y[i] - x[i])));
            }
        }
        piece = kept;
    }
    let Some(&o) = piece.first() else { return 0.0 };
    let cross = |x: [f64; 2], y: [f64; 2]| (x[0] - o[0]) * (y[1] - o[1]) - (x[1] - o[1]) * (y[0] - o[0]);
    piece.iter().zip(piece.iter().cycle().skip(1)).map(|(x, y)| 0.5 * cross(*x, *y)).sum()
}

/// Corners at random angles on an ellipse: convex, with edges of very different lengths.
fn convex_corners(random: &mut Splitmix, count: usize) -> Vec<[f64; 2]> {
    let mut angles: Vec<f64> = (0..count).map(|_| random.between(0.0, std::f64::consts::TAU)).collect();
    // At least one corner in each third, so that the centre is inside.
    (0..3).for_each(|k| angles[k] = (k as f64 + random.between(0.1, 0.9)) * std::f64::consts::TAU / 3.0);
    angles.sort_by(f64::total_cmp);
    let offset = [random.between(-0.6, 0.6), random.between(-0.6, 0.6)];
    angles.iter().map(|t| [1.3 * t.cos() + offset[0], 0.7 * t.sin() + offset[1]]).collect()
}

fn fan(corners: &[[f64; 2]]) -> Mesh<2> {
    let middle = std::array::from_fn(|i| corners.iter().map(|x| x[i]).sum::<f64>() / corners.len() as f64);
    fan_tri3(middle, &fmc_shapes::polygon(corners, 1))
}

#[test]
fn convex_polygons_clip_each_other() {
    let mut random = Splitmix::new(1);
    let mut overlapping = 0;
    for _ in 0..200 {
        let (a, b) = (convex_corners(&mut random, 3 + overlapping % 6), convex_corners(&mut random, 7));
        let (angle, shift) = (random.between(0.0, 6.0), random.between(0.0, 2.0));
        let b: Vec<[f64; 2]> = fan(&b).rotated(angle).translated([shift, 0.3]).coords[1..].to_vec();
        let expected = common_area(&a, &b);
        let contact = Scene::of(&[&fan(&a), &fan(&b)]).evaluate(exact());
        // Roundoff is relative to the bodies, of size 1, not to what is left of them.
        assert!((contact.volume - expected).abs() < 1e-14, "{} instead of {expected}", contact.volume);
        overlapping += usize::from(expected > 1e-3);
    }
    assert!(overlapping > 100);
}

/// Volume and nodal derivatives to 1e-12 of their size.
fn agrees(a: &Mesh<2>, b: &Mesh<2>) {
    let contact = Scene::of(&[a, b]).evaluate(exact());
    let (volume, mut gradient, of_b) = overlap(a, b);
    assert!((contact.volume / volume - 1.0).abs() < 1e-12, "{} instead of {volume}", contact.volume);
    gradient.extend(of_b);
    let forces: Vec<[f64; 2]> = contact.forces.iter().map(|f| f.map(|f| -f)).collect();
    assert!(distance(&forces, &gradient) < 1e-12 * norm(&gradient));
}

#[test]
fn concave_polygons_clip_each_other() {
    for seed in 0..30 {
        let mut random = Splitmix::new(seed);
        let a = random_polygon(5 + seed as usize % 9, 1.0, 0.6, seed);
        let b =
            random_polygon(7, 1.2, 0.6, seed + 100).translated([random.between(0.0, 1.2), random.between(0.0, 1.0)]);
        agrees(&a, &b);
        // A small body about a corner of a large one.
        let corner = b.coords[3];
        agrees(&b, &a.scaled(1e-3).translated(corner));
    }
}

#[test]
fn star_in_a_block() {
    let star = fan_tri3([0.0; 2], &star_polygon(10, 1.0, 0.5, 8)).rotated(0.1).translated([0.03, 0.9]);
    agrees(&star, &rectangle_tri3([-1.5, -1.0], [1.5, 0.0], [23, 7], Diagonals::Alternating));
}

#[test]
fn fine_meshes_of_every_shape() {
    let shapes = [
        disc_tri3(1.0, 40),
        star_tri3(5, 1.1, 0.5, 7, 2),
        rectangle_tri3([-0.9, -0.6], [0.8, 0.9], [9, 6], Diagonals::Alternating).jittered(0.2, 3, |_| true),
    ];
    for (k, a) in shapes.iter().enumerate() {
        for (m, b) in shapes.iter().enumerate() {
            let angle = 0.37 + 0.11 * (3 * k + m) as f64;
            agrees(a, &b.clone().rotated(angle).translated([0.51, -0.73]));
        }
    }
}
