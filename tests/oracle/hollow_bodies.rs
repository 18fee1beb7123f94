//! Concave bodies, and bodies with holes and cavities.

use crate::membership::{cover, thrown};
use crate::scene::{Scene, exact, lines};
use fmc_contact::{Bodies, Contact, ContactForces, Options, Surface};
use fmc_shapes::{
    Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_surface, patch_quad4, polygon, random_polygon, random_polyhedron,
    rectangle_quad4, rectangle_tri3,
};

/// The frame between the squares of half sides 1 and 2, in four by `n` blocks of quadrilaterals.
fn frame(n: usize) -> Mesh<2> {
    let corner = |k: usize| [[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]][k % 4];
    let mut mesh: Option<Mesh<2>> = None;
    for k in 0..4 {
        let side = patch_quad4([2, n], |u, v| {
            std::array::from_fn(|i| (1.0 + u) * ((1.0 - v) * corner(k)[i] + v * corner(k + 1)[i]))
        });
        match &mut mesh {
            Some(mesh) => mesh.append(&side),
            None => mesh = Some(side),
        }
    }
    mesh.unwrap().welded(1e-9)
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() < tolerance, "{found} instead of {expected}");
}

#[test]
fn hole_of_a_frame_is_not_inside() {
    for options in [exact(), lines(0.004, 1)] {
        // Lines: about a thousand per family, each off by half a spacing at either end, at random.
        let tolerance = if options == exact() { 1e-13 } else { 4e-4 };
        // A block in the hole, one across a corner of it, and one that covers all of it.
        let in_hole = rectangle_quad4([-0.9; 2], [0.8, 0.9], [3, 3]).rotated(0.02);
        assert_eq!(Scene::of(&[&frame(5), &in_hole]).evaluate(options).volume, 0.0);
        let at_corner = rectangle_quad4([0.5, 0.4], [1.5, 1.6], [3, 4]);
        close(Scene::of(&[&frame(5), &at_corner]).evaluate(options).volume, 1.2 - 0.5 * 0.6, tolerance);
        let over_all = rectangle_quad4([-3.0; 2], [3.0; 2], [4, 4]).rotated(0.3);
        close(Scene::of(&[&frame(5), &over_all]).evaluate(options).volume, 12.0, 12.0 * tolerance);
        // The frame on itself, turned by an eighth: two squares less what the holes take. With s(a) the area of a square
        // of half side a cut by one of half side b at 45°: rings of [1, 2] in both.
        let turned = frame(4).rotated(std::f64::consts::FRAC_PI_4);
        let octagon = |half: f64| 8.0 * (2f64.sqrt() - 1.0) * half * half;
        // The hole of either lies wholly in the other's outline (√2 < 2), so V = octagon(2) − 2·4 + octagon(1).
        let volume = octagon(2.0) - 8.0 + octagon(1.0);
        close(Scene::of(&[&frame(5), &turned]).evaluate(options).volume, volume, 12.0 * tolerance);
    }
}

/// A cavity bounded by facets that turn their back to it, and belongs to the body around it.
fn hollow_box(thickness: f64) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let (outer, inner) = (
        cuboid_surface([-1.0; 3], [1.0; 3], [3; 3]),
        cuboid_surface([thickness - 1.0; 3], [1.0 - thickness; 3], [2; 3]),
    );
    let first = outer.coords.len() as u32;
    let mut facets = outer.facets();
    facets.extend(inner.facets().iter().map(|f| [f[0] + first, f[2] + first, f[1] + first]));
    ([outer.coords, inner.coords].concat(), facets)
}

fn evaluate<const D: usize>(coords: &[[f64; D]], facets: &[[u32; D]], options: Options) -> ContactForces<D> {
    let surface = Surface::from_facets(coords, facets, Bodies::Connected).unwrap();
    assert_eq!(surface.body_count(), 2);
    Contact::new(surface, options).unwrap().evaluate(coords).unwrap()
}

#[test]
fn cavity_of_a_box_is_not_inside() {
    for options in [exact(), lines(0.03, 1)] {
        let tolerance = if options == exact() { 1e-13 } else { 2e-3 };
        // A rod through two walls of 0.25, and a block in the cavity.
        for (min, max, volume) in [
            ([-1.5, -0.2, -0.3], [1.5, 0.3, 0.2], 0.5 * 0.25),
            ([-0.5; 3], [0.6; 3], 0.0),
            ([0.0; 3], [0.9; 3], 0.9f64.powi(3) - 0.75f64.powi(3)),
        ] {
            let (mut coords, mut facets) = hollow_box(0.25);
            let other = cuboid_surface(min, max, [2; 3]);
            let first = coords.len() as u32;
            coords.extend(&other.coords);
            facets.extend(other.facets().iter().map(|f| f.map(|n| n + first)));
            let contact = evaluate(&coords, &facets, options);
            close(contact.volume, volume, tolerance);
        }
    }
}

#[test]
fn cavity_of_a_polygon_is_not_inside() {
    // An L with a square hole in its foot, against a bar across foot and hole.
    let l = polygon(&[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]], 3);
    let hole = polygon(&[[1.5, 0.25], [1.5, 0.75], [2.0, 0.75], [2.0, 0.25]], 2);
    let bar = polygon(&[[0.5, 0.5], [2.5, 0.5], [2.5, 2.0], [0.5, 2.0]], 4);
    let mut mesh = l.clone();
    mesh.append(&hole);
    mesh.append(&bar);
    // 2 × 1/2 in the foot less 1/2 × 1/4 of the hole; 1/2 × 1 in the upright, above the foot.
    let volume = 1.0 - 0.125 + 0.5;
    for (options, tolerance) in [(exact(), 1e-14), (lines(0.003, 2), 1e-3)] {
        close(evaluate(&mesh.coords, &mesh.facets(), options).volume, volume, tolerance);
    }
}

/// The overlap of random concave bodies by throwing points; within 4 standard errors, which is 0.006 % of the time
/// not enough.
#[test]
fn concave_bodies_by_throwing_points() {
    for seed in 0..6 {
        let mut random = Splitmix::new(seed);
        let a = random_polygon(9, 1.0, 0.7, seed);
        let b = random_polygon(11, 1.0, 0.7, seed + 20).translated([random.between(0.0, 0.8), 0.4]);
        let [volume, error] = thrown([[-2.0; 2], [2.0; 2]], 200_000, seed, |x| cover(&a, x) * cover(&b, x));
        for options in [exact(), lines(0.005, seed)] {
            close(Scene::of(&[&a, &b]).evaluate(options).volume, volume, 4.0 * error + 1e-3);
        }
        let a = random_polyhedron(1, 1.0, 0.5, 1, seed);
        let b = random_polyhedron(0, 1.0, 0.5, 1, seed + 20).translated([random.between(0.2, 0.8), 0.3, 0.4]);
        let [volume, error] = thrown([[-1.6; 3], [1.6; 3]], 100_000, seed, |x| match cover(&b, x) {
            0 => 0,
            n => n * cover(&a, x),
        });
        for options in [exact(), lines(0.04, seed)] {
            close(Scene::of(&[&a, &b]).evaluate(options).volume, volume, 4.0 * error + 2e-3);
        }
    }
}

/// A tooth of a comb between two teeth of another: contact on both sides, no box holds the overlaps apart.
#[test]
fn combs_in_each_other() {
    let comb = |shift: f64| {
        let mut mesh = rectangle_tri3([0.0, -0.5], [7.0, 0.0], [14, 1], Diagonals::Same);
        for k in 0..4 {
            let x = 2.0 * k as f64;
            mesh.append(&rectangle_tri3([x, 0.0], [x + 1.0, 2.0], [2, 3], Diagonals::Same));
        }
        mesh.welded(1e-9).translated([shift, 0.0])
    };
    // The upper one turned by half a turn: its teeth, 1 wide, stand in gaps of 1, shifted by 0.1, and reach 1.5 deep.
    let upper = comb(0.0).rotated(std::f64::consts::PI).translated([8.1, 2.5]);
    for (options, tolerance) in [(exact(), 1e-12), (lines(0.004, 1), 2e-3)] {
        let contact = Scene::of(&[&comb(0.0), &upper]).evaluate(options);
        // Teeth of the upper one at 1.1 + 2k … 2.1 + 2k: each overlaps the lower's next tooth, where there is one.
        close(contact.volume, 3.0 * 0.1 * 1.5, tolerance);
        close(contact.bodies[1].force[0], -3.0 * 1.5, 10.0 * tolerance);
    }
}

/// A hexahedral shell around a hexahedral core that is a little too large for it.
#[test]
fn core_in_a_tight_shell() {
    let solid = cuboid_hex8([-1.5; 3], [1.5; 3], [3; 3]);
    let mut shell = solid.clone();
    shell.conn = solid.cells().enumerate().filter(|(cell, _)| *cell != 13).flat_map(|(_, c)| c.to_vec()).collect();
    let core = cuboid_hex8([-0.52; 3], [0.52; 3], [2; 3]);
    for (options, tolerance) in [(exact(), 1e-13), (lines(0.01, 1), 1e-3)] {
        let contact = Scene::of(&[&shell, &core]).evaluate(options);
        close(contact.volume, 1.04f64.powi(3) - 1.0, tolerance);
        // It is held from all sides.
        assert!(contact.bodies[1].force.iter().all(|f| f.abs() < 10.0 * tolerance));
    }
}
