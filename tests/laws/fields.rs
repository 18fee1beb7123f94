//! Pressure, gap, area and normal at nodes, and contact points: against the forces, and against what the geometry says.

use crate::pairs::{plane_scene, solid_scene};
use crate::scene::table::{by_laws, estimators, exactly, is_depth, laws, local_laws, table};
use crate::scene::{Scene, by_lines, distance, norm, size_sum};
use fmc_contact::contact::{NodalContact, NodeStatus};
use fmc_contact::overlap::Partner;
use fmc_contact::{Contact, ContactForces, EnergyLaw, Obstacle, Pose, Shape};
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, disc_tri3, rectangle_quad4, rectangle_tri3};

/// F = −p A n at every node; normals are unit vectors, or zero where there is no force.
fn carry_the_forces<const D: usize>(field: &NodalContact<D>, found: &ContactForces<D>) {
    let scale = norm(&found.forces);
    for (node, force) in found.forces.iter().enumerate() {
        let carried = carried(field, node);
        assert!((0..D).all(|i| (carried[i] - force[i]).abs() <= 1e-14 * scale), "node {node}: {carried:?} {force:?}");
    }
}

/// −p A n.
fn carried<const D: usize>(field: &NodalContact<D>, node: usize) -> [f64; D] {
    field.normal[node].map(|n| -field.pressure[node] * field.area[node] * n)
}

/// The law `depth` has forces on inner nodes as well, which fields have at the surface above: their sum is that of the body.
fn carry_the_resultants<const D: usize>(scene: &Scene<D>, field: &NodalContact<D>, contact: &Contact<D>) {
    let found = contact.evaluate(&scene.coords).unwrap();
    let on_surface: Vec<u32> = contact.boundary_facets().into_iter().flat_map(|facet| facet.nodes).collect();
    for (body, resultant) in found.bodies.iter().enumerate() {
        let mut sum = [0.0; D];
        for node in scene.nodes_of(body) {
            (0..D).for_each(|i| sum[i] += carried(field, node)[i]);
            let is_inner = !on_surface.contains(&(node as u32));
            assert!(!is_inner || (field.pressure[node], field.area[node]) == (0.0, 0.0), "inner node {node}");
        }
        let off = distance(&[sum], &[resultant.force]);
        assert!(off <= 1e-14 * size_sum(&found.forces), "{sum:?} {:?}", resultant.force);
    }
}

/// Values at nodes are those of a contact, or none.
fn make_sense<const D: usize>(field: &NodalContact<D>) {
    for node in 0..field.pressure.len() {
        let length = field.normal[node].iter().map(|n| n * n).sum::<f64>().sqrt();
        assert!(length == 0.0 || (length - 1.0).abs() < 1e-14, "node {node}: {length}");
        let touches = field.status[node] == NodeStatus::Touching;
        assert!(touches || (field.gap[node], field.pressure[node]) == (0.0, 0.0) || length > 0.0, "node {node}");
        assert!(field.pressure[node] >= 0.0 && field.area[node] >= 0.0 && field.gap[node] <= 0.0);
    }
}

fn of_scenes<const D: usize>(scene: impl Fn(u64) -> Scene<D>, seeds: u64) {
    for seed in 0..seeds {
        let scene = scene(seed);
        for options in table(1.0) {
            let contact = scene.contact(options);
            let found = contact.evaluate(&scene.coords).unwrap();
            let field = contact.nodal_contact(&scene.coords).unwrap();
            make_sense(&field);
            match is_depth(&options.law) {
                true => carry_the_resultants(&scene, &field, &contact),
                false => carry_the_forces(&field, &found),
            }
        }
    }
}

#[test]
fn nodal_fields_carry_the_forces() {
    of_scenes(plane_scene, 6);
    of_scenes(solid_scene, 2);
}

/// A block 0.01 deep in a wider one of another mesh: k δ everywhere, and the area of the block.
fn on_a_flat<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) {
    let depth = 0.01;
    let sunk = upper.clone().mapped(|mut x| {
        x[D - 1] -= depth;
        x
    });
    let scene = Scene::of(&[lower, &sunk]);
    for options in by_laws(estimators(1.0).into_iter().take(3), &laws(1.0)) {
        let contact = scene.contact(options);
        let field = contact.nodal_contact(&scene.coords).unwrap();
        let pressure = match options.law {
            EnergyLaw::Volume { stiffness, .. } => stiffness,
            EnergyLaw::Depth { stiffness } => stiffness * depth,
            _ => contact.evaluate(&scene.coords).unwrap().pairs[0].pressure,
        };
        // Bottom nodes of the upper block that are not on its side walls, which the law "volume" presses as well.
        let mut count = 0;
        for node in scene.nodes_of(1) {
            let x = &scene.coords[node];
            let is_inner = (0..D - 1).all(|i| (0.3..0.7).contains(&x[i])) && x[D - 1] < -0.5 * depth;
            if is_inner {
                count += 1;
                let found =
                    [field.local_pressure[node], field.pressure[node]].map(|found| (found / pressure - 1.0).abs());
                // The force of the law "depth" depends on the cells below too, by its error of the patch test.
                let of_force = if is_depth(&options.law) { 1e-3 } else { 1e-9 };
                assert!(found[0] < 1e-9 && found[1] < of_force, "{options:?}: {found:?}");
                let off = (field.gap[node] + depth).abs() / depth;
                // The mean over a pair knows walls too, and lines.
                let is_of_pair = matches!(options.law, EnergyLaw::Volume { .. });
                assert!(off < if is_of_pair { 0.1 } else { 1e-9 }, "{options:?}: {}", field.gap[node]);
                // Sampling turns the force of the law "volume" a little.
                assert!((field.normal[node][D - 1] + 1.0).abs() < 1e-4, "{options:?}: {:?}", field.normal[node]);
                assert_eq!(field.status[node], NodeStatus::Touching);
            }
        }
        assert!(count > 0);
        assert!(scene.coords.iter().zip(&field.status).all(|(x, s)| x[D - 1] < 0.4 || *s == NodeStatus::Apart));
    }
}

#[test]
fn a_flat_patch_has_one_pressure() {
    on_a_flat(
        &rectangle_quad4([-0.5, -1.0], [1.5, 0.0], [9, 4]),
        &rectangle_tri3([0.0; 2], [1.0, 0.5], [10, 4], Diagonals::Alternating),
    );
    on_a_flat(
        &cuboid_tet4([-0.5, -0.5, -1.0], [1.5, 1.5, 0.0], [5, 5, 3]),
        &cuboid_hex8([0.0; 3], [1.0, 1.0, 0.5], [6, 6, 2]),
    );
}

/// A disc of radius 1, sunk into a half-space as it is: the pressure is k times the depth of each of its points, which
/// falls as a parabola. Facets are 1/24 of the half width.
#[test]
fn a_parabola_of_pressure_to_a_hundredth() {
    let half_width: f64 = 0.12;
    let depth = 1.0 - (1.0 - half_width * half_width).sqrt();
    let edges = (std::f64::consts::TAU / (half_width / 24.0)).round() as usize;
    let disc = disc_tri3(1.0, edges).translated([0.0, 1.0 - depth]);
    for options in [exactly(EnergyLaw::fiber(1e3)), by_lines(EnergyLaw::fiber(1e3))] {
        let mut contact = Scene::of(&[&disc]).contact(options);
        contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 2]) }).unwrap();
        let field = contact.nodal_contact(&disc.coords).unwrap();
        let (mut count, mut squares) = (0, 0.0);
        for (x, pressure) in disc.coords.iter().zip(&field.pressure).filter(|(_, pressure)| **pressure > 0.0) {
            let off = (pressure - (-1e3 * x[1]).max(0.0)) / (1e3 * depth);
            // The last node knows of the half of its facets alone that is in contact.
            let is_last = x[0].abs() > half_width * (1.0 - 1.0 / 24.0);
            assert!(off.abs() < if is_last { 0.025 } else { 0.005 }, "{options:?} {x:?}: {off}");
            squares += off * off;
            count += 1;
        }
        assert!((squares / f64::from(count)).sqrt() < 0.01);
        assert!(count >= 45, "{count}");
    }
}

fn points_add_up<const D: usize>(scene: &Scene<D>) {
    for options in by_laws(estimators(1.0).into_iter().take(3), &local_laws(1.0)) {
        let contact = scene.contact(options);
        let found = contact.evaluate(&scene.coords).unwrap();
        let points = contact.contact_points(&scene.coords).unwrap();
        assert_eq!(points.is_empty(), found.pairs.is_empty());
        let mut volume = 0.0;
        for point in &points {
            volume -= point.area * point.gap;
            let [first, second] = &point.sides;
            for i in 0..D {
                // Outwards of the first side the second side's end lies behind.
                let between = first.position[i] - second.position[i];
                let along = -point.gap * point.normal[i];
                assert!((between - along).abs() < 1e-9, "{point:?}");
            }
            for (side, partner) in point.sides.iter().zip(point.partners) {
                assert_eq!(side.node_count > 0, matches!(partner, Partner::Body(_)));
                let weights = &side.weights[..side.node_count];
                assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-9);
                for i in 0..D {
                    let nodes = side.nodes.iter().zip(weights);
                    let place: f64 = nodes.map(|(&node, weight)| weight * scene.coords[node as usize][i]).sum();
                    assert!((place - side.position[i]).abs() < 1e-9, "{point:?}");
                }
                let cell = side.cell.expect("a cell");
                let conn: Vec<u32> = scene.blocks.iter().flat_map(|block| block.1.clone()).collect();
                let of_cell = &conn[cell * (1 << D)..][..1 << D];
                assert!(side.nodes[..side.node_count].iter().all(|node| of_cell.contains(node)), "{point:?}");
            }
        }
        let expected: f64 = found.pairs.iter().map(|pair| pair.volume).sum();
        assert!((volume / expected - 1.0).abs() < 1e-12, "{volume} {expected}");
    }
}

#[test]
fn contact_points_name_their_sides() {
    let lower = rectangle_quad4([-0.5, -1.0], [1.5, 0.0], [9, 4]);
    points_add_up(&Scene::of(&[&lower, &rectangle_quad4([0.0, -0.03], [1.0, 0.5], [4, 2]).rotated(0.02)]));
    let lower = cuboid_hex8([-0.5, -0.5, -1.0], [1.5, 1.5, 0.0], [5, 5, 3]);
    let upper = cuboid_hex8([0.0, 0.0, -0.03], [1.0, 1.0, 0.5], [3, 3, 2]).rotated([1.0, 0.3, 0.0], 0.02);
    points_add_up(&Scene::of(&[&lower, &upper]));
}
