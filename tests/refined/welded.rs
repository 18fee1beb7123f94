//! Meshes whose cells have nodes of their own, welded: all is as of the merged mesh.

use crate::scene::{Scene, exact, table::exactly};
use fmc_contact::contact::TangentPart;
use fmc_contact::{Bodies, CellBlock, CellType, Contact, EnergyLaw, Error, Options, Surface, Warning};
use fmc_shapes::{Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3, second_order};

const WELD: f64 = 1e-4;

/// Nodes in the order in which cells name them, so that those of the welded mesh are in the same order.
fn in_order<const D: usize>(mesh: &Mesh<D>) -> Mesh<D> {
    let mut number = vec![u32::MAX; mesh.coords.len()];
    let (mut coords, mut conn) = (Vec::new(), Vec::new());
    for &node in &mesh.conn {
        if number[node as usize] == u32::MAX {
            number[node as usize] = coords.len() as u32;
            coords.push(mesh.coords[node as usize]);
        }
        conn.push(number[node as usize]);
    }
    Mesh { coords, conn, nodes_per_cell: mesh.nodes_per_cell }
}

/// The same cells, each with nodes of its own: node k is node `conn[k]` of the mesh.
fn soup<const D: usize>(mesh: &Mesh<D>) -> Mesh<D> {
    let coords = mesh.conn.iter().map(|&node| mesh.coords[node as usize]).collect();
    Mesh { coords, conn: (0..mesh.conn.len() as u32).collect(), nodes_per_cell: mesh.nodes_per_cell }
}

fn welded<const D: usize>(scene: &Scene<D>, tolerance: f64) -> Result<Surface<D>, Error> {
    let block = |(cell_type, conn): &(CellType, Vec<u32>)| (*cell_type, conn.clone());
    let blocks: Vec<_> = scene.blocks.iter().map(block).collect();
    let blocks: Vec<_> = blocks.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
    Surface::from_cells_welded(&scene.coords, &blocks, Bodies::Ids(&scene.ids), tolerance)
}

/// Two bodies, both merged and both as cells with nodes of their own, and the merged node of every other.
fn both<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) -> (Scene<D>, Scene<D>, Vec<usize>) {
    let (lower, upper) = (in_order(lower), in_order(upper));
    let merged_of = lower.conn.iter().map(|&node| node as usize);
    let of_upper = upper.conn.iter().map(|&node| lower.coords.len() + node as usize);
    let merged_of = merged_of.chain(of_upper).collect();
    (Scene::of(&[&lower, &upper]), Scene::of(&[&soup(&lower), &soup(&upper)]), merged_of)
}

/// Coordinates a little bent, so that nothing is special.
fn bent<const D: usize>(x: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|axis| x[axis] + 0.01 * x[(axis + 1) % D] * x[axis])
}

fn as_merged<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>, laws: &[Options]) {
    let (merged, torn, merged_of) = both(lower, upper);
    let surface = welded(&torn, WELD).expect("copies are welded");
    assert_eq!(surface.welded_node_count(), torn.coords.len() - merged.coords.len());
    assert_eq!(surface.facet_count(), merged.surface().facet_count());
    for options in laws {
        let mut contact = Contact::new(surface.clone(), *options).expect("options");
        let mut coords: Vec<_> = merged.coords.iter().map(bent).collect();
        coords.iter_mut().zip(&merged.coords).for_each(|(x, at)| x[0] += 1e-3 * at[D - 1]);
        let own: Vec<_> = merged_of.iter().map(|&node| coords[node]).collect();
        let of_merged = merged.contact(*options);
        let expected = of_merged.evaluate(&coords).expect("forces");
        let found = contact.evaluate(&own).expect("forces");
        assert!(expected.energy > 0.0);
        assert!((found.energy / expected.energy - 1.0).abs() < 1e-12, "{} {}", found.energy, expected.energy);
        assert!(!found.warnings.iter().any(|warning| matches!(warning, Warning::CoincidingFaces { .. })));
        let mut sums = vec![[0.0; D]; coords.len()];
        for (force, &node) in found.forces.iter().zip(&merged_of) {
            (0..D).for_each(|axis| sums[node][axis] += force[axis]);
        }
        let size: f64 = expected.bodies[1].force.iter().map(|f| f.abs()).sum();
        for (sum, force) in sums.iter().zip(&expected.forces) {
            (0..D).for_each(|axis| assert!((sum[axis] - force[axis]).abs() < 1e-12 * size, "{sum:?} {force:?}"));
        }
        // Fields are those of the merged node, and their areas add up to its own.
        let [fields, of_merged] = [contact.nodal_contact(&own), of_merged.nodal_contact(&coords)].map(Result::unwrap);
        let mut areas = vec![0.0; coords.len()];
        for (node, &of) in merged_of.iter().enumerate() {
            areas[of] += fields.area[node];
            let [p, expected] = [fields.pressure[node], of_merged.pressure[of]];
            assert!((p - expected).abs() <= 1e-9 * (p.abs() + expected.abs()), "{p} for {expected}");
            assert_eq!(fields.status[node], of_merged.status[of]);
        }
        let near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-9 * b.abs();
        assert!(areas.iter().zip(&of_merged.area).all(near), "{areas:?}");
        // For any number of threads the same bits.
        contact.set_options(Options { threads: 3, ..*options }).expect("threads");
        assert_eq!(contact.evaluate(&own).expect("forces").forces, found.forces);
    }
}

#[test]
fn forces_and_fields_of_the_merged_mesh() {
    let laws = [exact(), exactly(EnergyLaw::fiber(4.0)), exactly(EnergyLaw::depth(4.0))];
    let (lower, upper) = (
        rectangle_quad4([0.0; 2], [1.0; 2], [4, 4]),
        rectangle_tri3([0.13, 0.97], [0.77, 1.5], [3, 2], Diagonals::Alternating),
    );
    as_merged(&lower, &upper, &laws);
    as_merged(&second_order(&lower, 9), &second_order(&upper, 6), &laws);
    let (lower, upper) =
        (cuboid_hex8([0.0; 3], [1.0; 3], [2, 2, 2]), cuboid_tet4([0.13, 0.2, 0.97], [0.77, 0.71, 1.5], [2, 2, 1]));
    as_merged(&lower, &upper, &laws);
    as_merged(&second_order(&lower, 20), &second_order(&upper, 10), &laws[2..]);
}

/// Copies that the host moves apart: one energy, of which forces and tangent are the derivatives; forces and moments balance.
#[test]
fn copies_that_lie_apart() {
    let (_, torn, _) = both(
        &cuboid_hex8([0.0; 3], [1.0; 3], [2, 2, 2]),
        &cuboid_tet4([0.13, 0.2, 0.97], [0.77, 0.71, 1.5], [2, 2, 1]),
    );
    let surface = welded(&torn, WELD).expect("copies are welded");
    let contact = Contact::new(surface, exactly(EnergyLaw::depth(4.0))).expect("options");
    let mut random = Splitmix::new(7);
    let mut moved = |size: f64| -> Vec<[f64; 3]> {
        torn.coords.iter().map(|_| std::array::from_fn(|_| size * (random.unit() - 0.5))).collect()
    };
    let add = |x: &[[f64; 3]], by: &[[f64; 3]], t: f64| -> Vec<[f64; 3]> {
        x.iter().zip(by).map(|(x, v)| std::array::from_fn(|axis| x[axis] + t * v[axis])).collect()
    };
    let at = add(&torn.coords, &moved(2e-3), 1.0);
    let along = moved(1.0);
    let found = contact.evaluate(&at).expect("forces");
    let size: f64 = found.forces.as_flattened().iter().map(|f| f.abs()).sum();
    for axis in 0..3 {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        let sum: f64 = found.forces.iter().map(|f| f[axis]).sum();
        let moment: f64 = at.iter().zip(&found.forces).map(|(x, f)| x[next] * f[last] - x[last] * f[next]).sum();
        assert!(sum.abs() < 1e-13 * size && moment.abs() < 1e-13 * size, "{sum} {moment} of {size}");
    }
    let step = 1e-5;
    let [ahead, behind] = [step, -step].map(|t| contact.evaluate(&add(&at, &along, t)).expect("forces"));
    let dot = |a: &[[f64; 3]], b: &[[f64; 3]]| -> f64 {
        a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a * b).sum()
    };
    let slope = (ahead.energy - behind.energy) / (2.0 * step);
    let by_force = -dot(&found.forces, &along);
    assert!((slope - by_force).abs() < 1e-6 * by_force.abs(), "{slope} {by_force}");
    let (_, tangent) = contact.evaluate_tangent(&at, TangentPart::Full).expect("a tangent");
    let product = tangent.product(&along);
    for (node, product) in product.iter().enumerate() {
        for axis in 0..3 {
            let slope = -(ahead.forces[node][axis] - behind.forces[node][axis]) / (2.0 * step);
            assert!((slope - product[axis]).abs() < 1e-5 * size / 0.03, "{node}: {slope} {}", product[axis]);
        }
    }
}

/// Parts that are connected by welding alone are one body, and coordinates with seven digits suffice.
#[test]
fn bodies_of_welded_parts() {
    let [left, right] = [rectangle_quad4([0.0; 2], [1.0; 2], [3, 3]), rectangle_quad4([1.0, 0.0], [2.0, 1.0], [3, 3])];
    let scene = Scene::of(&[&left, &right]);
    let blocks: Vec<_> = scene.blocks.iter().map(|(of, conn)| CellBlock { cell_type: *of, conn }).collect();
    let rounded: Vec<_> = scene.coords.iter().map(|x| x.map(|x| f64::from((x / 3.0) as f32) * 3.0)).collect();
    let of = |tolerance| Surface::from_cells_welded(&rounded, &blocks, Bodies::Connected, tolerance).expect("a mesh");
    assert_eq!([of(0.0), of(1e-6)].map(|surface| surface.body_count()), [2, 1]);
    assert_eq!([of(0.0), of(1e-6)].map(|surface| surface.welded_node_count()), [0, 4]);
    assert_eq!(of(1e-6).facet_count(), 18);
    // Two bodies that touch stay two.
    let surface = welded(&scene, 1e-6).expect("a mesh");
    assert_eq!((surface.body_count(), surface.welded_node_count()), (2, 0));
}

#[test]
fn what_would_collapse_cells_is_refused() {
    let mut scene = Scene::of(&[&soup(&rectangle_quad4([0.0; 2], [1.0; 2], [2, 2]))]);
    scene.coords[4 * 2 + 1][0] -= 0.25;
    for tolerance in [0.25, 0.3, 1.0] {
        let refused = welded(&scene, tolerance).err();
        assert_eq!(refused, Some(Error::Collapsed { cell: 2, length: 0.25, tolerance }));
    }
    for tolerance in [-1e-9, f64::NAN, f64::INFINITY] {
        let refused = welded(&scene, tolerance).err();
        assert!(matches!(refused, Some(Error::NotPositive { name: "weld", .. })), "{refused:?}");
    }
    // A chain of nodes of other cells, each within the tolerance of the next.
    let mut coords = vec![[0.0, 0.0], [0.9, 0.0], [0.0, 0.9]];
    for x in [0.3, 0.6] {
        coords.extend([[x, 0.0], [x, -1.0], [x + 1.0, -1.0]]);
    }
    let conn: Vec<u32> = (0..9).collect();
    let blocks = [CellBlock { cell_type: CellType::Tri3, conn: &conn }];
    let refused = Surface::from_cells_welded(&coords, &blocks, Bodies::Ids(&[0; 3]), 0.31).err();
    assert_eq!(refused, Some(Error::Collapsed { cell: 0, length: 0.9, tolerance: 0.31 }));
    let text = refused.map(|error| error.counted_from(1).to_string()).unwrap_or_default();
    assert!(text.contains("cell 1 that are 9.000e-1 apart"), "{text}");
}
