//! The exact estimator against closed forms of squares and boxes, at every scale and place.

use crate::scene::{Scene, exact, lines};
use fmc_contact::ContactForces;
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};

/// Roundoff of some tens of operations.
const ROUNDING: f64 = 1e-12;

/// Size of a scene's bodies, and where they stand in units of it. Far away a coordinate of 1000 sizes keeps 2⁻⁵³·1000 of a
/// size, so that overlaps of a tenth of a size are known to 1e-12 of themselves; a volume takes D such differences.
const PLACES: [(f64, f64, f64); 4] =
    [(1.0, 0.0, ROUNDING), (1e-6, 0.0, ROUNDING), (1e6, 0.0, ROUNDING), (1.0, 1e3, 1e-9)];

fn close(found: f64, expected: f64, tolerance: f64, of: f64) {
    assert!((found - expected).abs() <= tolerance * of.abs(), "{found:e} instead of {expected:e}");
}

/// Square (0, 1)² and the same moved by (x, y), one cell each.
fn two_squares(size: f64, place: f64, offset: [f64; 2]) -> Scene<2> {
    let square = rectangle_quad4([0.0; 2], [1.0; 2], [1, 1]);
    let put = |mesh: Mesh<2>| mesh.scaled(size).translated([place * size, -0.7 * place * size]);
    Scene::of(&[&put(square.clone()), &put(square.translated(offset))])
}

#[test]
fn two_squares_overlap_in_a_rectangle() {
    let (x, y) = (0.7, 0.85);
    for (size, place, tolerance) in PLACES {
        let contact = two_squares(size, place, [x, y]).evaluate(exact());
        let (w, h) = (1.0 - x, 1.0 - y);
        close(contact.volume, w * h * size * size, tolerance, w * h * size * size);
        close(contact.contact_area, (w + h) * size, tolerance, size);
        // On the first square its right side from y to 1 and its top from x to 1 bound the overlap. ∫ N over the part
        // [s, 1] of a unit side is (1 − s²)/2 for the far end and (1 − s)²/2 for the near one.
        let (far, near) = (|s: f64| (1.0 - s * s) / 2.0, |s: f64| (1.0 - s) * (1.0 - s) / 2.0);
        let first = [[0.0, 0.0], [-near(y), 0.0], [0.0, -near(x)], [-far(y), -far(x)]];
        for (node, expected) in first.iter().enumerate() {
            // The second square is the first one turned by half a turn: node 0 takes the place of node 3, and so on.
            let opposite = contact.forces[4 + 3 - node];
            for axis in 0..2 {
                close(contact.forces[node][axis], expected[axis] * size, tolerance, size * w);
                close(opposite[axis], -expected[axis] * size, tolerance, size * w);
            }
        }
        close(contact.bodies[1].force[0], h * size, tolerance, size * w);
        close(contact.bodies[1].force[1], w * size, tolerance, size * w);
    }
}

#[test]
fn square_turned_in_a_square() {
    // Both have the same inscribed circle, which touches all sides of the common polygon: V = 2/(1 + sin φ + cos φ).
    for divisions in [1, 4, 7] {
        for angle in [0.1, 0.4, std::f64::consts::FRAC_PI_4, 1.2] {
            for (size, place, tolerance) in PLACES {
                let square = rectangle_tri3([-0.5; 2], [0.5; 2], [divisions; 2], Diagonals::Alternating);
                let centre = [place * size, 0.3 * place * size];
                let put = |mesh: Mesh<2>| mesh.rotated(0.3).scaled(size).translated(centre);
                let scene = Scene::of(&[&put(square.clone()), &put(square.rotated(angle))]);
                let contact = scene.evaluate(exact());
                let (s, c) = angle.sin_cos();
                close(contact.volume, 2.0 * size * size / (1.0 + s + c), tolerance, size * size);
                let resultant = &contact.bodies[1];
                let moment = resultant.moment[2] - (centre[0] * resultant.force[1] - centre[1] * resultant.force[0]);
                let slope = -2.0 * (c - s) / (1.0 + s + c).powi(2);
                close(moment, -slope * size * size, tolerance, size * size);
                close(resultant.force[0], 0.0, tolerance, size);
            }
        }
    }
}

/// Boxes (0, 1)×(0, 2)×(0, 3) and (0, 1)³ + (x, y, z).
fn two_boxes(size: f64, place: f64, offset: [f64; 3], cells: [[usize; 3]; 2], tetrahedra: bool) -> Scene<3> {
    let make = if tetrahedra { cuboid_tet4 } else { cuboid_hex8 };
    let put = |mesh: Mesh<3>| mesh.scaled(size).translated([place, -0.6 * place, 0.8 * place].map(|x| x * size));
    let a = make([0.0; 3], [1.0, 2.0, 3.0], cells[0]);
    let b = make([0.0; 3], [1.0; 3], cells[1]).translated(offset);
    Scene::of(&[&put(a), &put(b)])
}

fn check_boxes(contact: &ContactForces<3>, [w, h, d]: [f64; 3], size: f64, tolerance: f64) {
    close(contact.volume, w * h * d * size.powi(3), tolerance, w * h * d * size.powi(3));
    // The overlap [x, 1]×[y, 2]×[z, 3] shrinks when the small box moves up along any axis.
    for (axis, force) in [h * d, w * d, w * h].into_iter().enumerate() {
        close(contact.bodies[1].force[axis], force * size * size, tolerance, size * size);
        close(contact.bodies[0].force[axis], -force * size * size, tolerance, size * size);
    }
    close(contact.contact_area, (h * d + w * d + w * h) * size * size, tolerance, size * size);
}

#[test]
fn two_boxes_overlap_in_a_box() {
    for tetrahedra in [false, true] {
        for cells in [[[1; 3], [1; 3]], [[2, 3, 4], [3, 2, 2]]] {
            for (size, place, tolerance) in PLACES {
                let scene = two_boxes(size, place, [0.7, 1.45, 2.15], cells, tetrahedra);
                check_boxes(&scene.evaluate(exact()), [0.3, 0.55, 0.85], size, tolerance);
            }
        }
    }
}

#[test]
fn thin_overlaps_keep_their_digits() {
    // 1e-9 deep: the depth is a difference of coordinates of 1, known to 2⁻⁵³·1e9 ≈ 1e-7 of itself.
    let depth = 1e-9;
    let contact = two_squares(1.0, 0.0, [0.25, 1.0 - depth]).evaluate(exact());
    close(contact.volume, 0.75 * depth, 3e-7, 0.75 * depth);
    close(contact.bodies[1].force[1], 0.75, ROUNDING, 1.0);
    let scene = two_boxes(1.0, 0.0, [0.25, 0.3, 3.0 - depth], [[2; 3], [3; 3]], true);
    let contact = scene.evaluate(exact());
    close(contact.volume, 0.75 * depth, 3e-7, 0.75 * depth);
    close(contact.bodies[1].force[2], 0.75, ROUNDING, 1.0);
}

/// Lines see an overlap of any depth by those that cross it, some 100 here (2D) and 30 × 30.
#[test]
fn thin_overlaps_are_seen_by_lines() {
    for depth in [1e-3, 1e-6, 1e-9, 1e-12] {
        // Depths are differences of coordinates of 1.
        let rounding = 3e-16 / depth;
        let contact = two_squares(1.0, 0.0, [0.25, 1.0 - depth]).evaluate(lines(0.007, 1));
        close(contact.volume, 0.75 * depth, 0.02 + rounding, 0.75 * depth);
        close(contact.bodies[1].force[1], 0.75, 0.02, 1.0);
        let scene = two_boxes(1.0, 0.0, [0.25, 0.3, 3.0 - depth], [[2; 3], [3; 3]], true);
        let contact = scene.evaluate(lines(0.03, 1));
        close(contact.volume, 0.75 * depth, 0.02 + 3.0 * rounding, 0.75 * depth);
        close(contact.bodies[1].force[2], 0.75, 0.02, 1.0);
    }
}

/// A block within another keeps its own volume, by both estimators: spans are bounded by one body alone.
#[test]
fn blocks_within_blocks_keep_their_volume() {
    let outer = rectangle_quad4([-2.0; 2], [2.0; 2], [5, 5]);
    let inner = rectangle_quad4([-0.4; 2], [0.6, 0.5], [3, 3]).rotated(0.7);
    let scene = Scene::of(&[&outer, &inner]);
    close(scene.evaluate(exact()).volume, 0.9, ROUNDING, 1.0);
    // Two families of about 300 lines; each cut off end is wrong by at most half a spacing per line.
    close(scene.evaluate(lines(0.003, 1)).volume, 0.9, 1e-4, 1.0);
    let outer = cuboid_tet4([-2.0; 3], [2.0; 3], [3; 3]);
    let inner = cuboid_tet4([-0.4; 3], [0.6, 0.5, 0.4], [2; 3]).rotated([1.0, 2.0, 3.0], 0.7);
    close(Scene::of(&[&outer, &inner]).evaluate(exact()).volume, 0.72, ROUNDING, 1.0);
}
