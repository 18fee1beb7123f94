//! A host with shape functions of its own: unknowns that move the nodes.

use crate::scene::{Scene, distance, norm, table::exactly};
use crate::{pair, rectangles};
use fmc_contact::contact::TangentPart;
use fmc_contact::{Basis, EnergyLaw, Error};
use fmc_shapes::{rectangle_quad4, second_order};

/// Rows of a matrix, one for every node.
struct Rows {
    starts: Vec<usize>,
    unknowns: Vec<u32>,
    weights: Vec<f64>,
    count: usize,
}

impl Rows {
    fn new(count: usize, rows: &[Vec<(u32, f64)>]) -> Self {
        let mut all = Self { starts: vec![0], unknowns: Vec::new(), weights: Vec::new(), count };
        for row in rows {
            all.unknowns.extend(row.iter().map(|(unknown, _)| *unknown));
            all.weights.extend(row.iter().map(|(_, weight)| *weight));
            all.starts.push(all.unknowns.len());
        }
        all
    }

    fn basis(&self) -> Basis<'_> {
        Basis { unknown_count: self.count, row_starts: &self.starts, unknowns: &self.unknowns, weights: &self.weights }
    }

    fn transposed(&self, forces: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut sums = vec![[0.0; 2]; self.count];
        for (row, ends) in self.starts.windows(2).enumerate() {
            for k in ends[0]..ends[1] {
                (0..2).for_each(|i| sums[self.unknowns[k] as usize][i] += self.weights[k] * forces[row][i]);
            }
        }
        sums
    }
}

/// Hierarchical functions: unknowns of corners, and bubbles of the edges, x_middle = mean of the ends + bubble.
fn hierarchical(scene: &Scene<2>) -> (Rows, Vec<[f64; 2]>) {
    let mut rows: Vec<Vec<(u32, f64)>> = (0..scene.coords.len() as u32).map(|node| vec![(node, 1.0)]).collect();
    let mut at = scene.coords.clone();
    for (cell_type, conn) in &scene.blocks {
        for cell in conn.chunks_exact(cell_type.node_count()) {
            let corners = cell_type.straight().node_count();
            for k in 0..corners {
                let (p, q, middle) = (cell[k], cell[(k + 1) % corners], cell[corners + k]);
                rows[middle as usize] = vec![(p, 0.5), (q, 0.5), (middle, 1.0)];
                at[middle as usize] = std::array::from_fn(|i| {
                    let of = |node: u32| scene.coords[node as usize][i];
                    of(middle) - 0.5 * (of(p) + of(q))
                });
            }
        }
    }
    (Rows::new(scene.coords.len(), &rows), at)
}

fn scene() -> Scene<2> {
    let lower = rectangles([0.0, -1.0], [1.5, 0.0], [3, 2]).swap_remove(0);
    let upper = second_order(&rectangle_quad4([0.2, -0.1], [1.3, 0.7], [2, 2]), 8);
    let scene = pair(&lower, &upper);
    Scene { coords: crate::shaken(&scene.coords, 0.01, 4), ..scene }
}

#[test]
fn forces_and_tangent_come_back_through_the_matrix() {
    let scene = scene();
    let (rows, at) = hierarchical(&scene);
    for law in [EnergyLaw::depth(5.0), EnergyLaw::volume(2.0)] {
        let plain = scene.contact(exactly(law));
        let mut contact = scene.contact(exactly(law));
        contact.set_basis(Some(&rows.basis())).expect("a basis");
        let (by_nodes, found) = (plain.evaluate(&scene.coords), contact.evaluate(&at));
        let (by_nodes, found) = (by_nodes.expect("forces"), found.expect("forces"));
        let expected = rows.transposed(&by_nodes.forces);
        assert!(distance(&found.forces, &expected) < 1e-12 * norm(&expected));
        assert!((found.energy - by_nodes.energy).abs() < 1e-12 * found.energy);
        assert!((found.bodies[1].force[1] - by_nodes.bodies[1].force[1]).abs() < 1e-12 * norm(&expected));
        let tangent = contact.tangent(&at, TangentPart::Full).expect("a tangent");
        let moved = |h: f64| -> Vec<[f64; 2]> {
            at.iter()
                .enumerate()
                .map(|(n, x)| [x[0] + h * ((n % 5) as f64 - 2.0), x[1] + h * ((n % 7) as f64 - 3.0)])
                .collect()
        };
        let direction: Vec<[f64; 2]> = (0..at.len()).map(|n| [(n % 5) as f64 - 2.0, (n % 7) as f64 - 3.0]).collect();
        let forces = |h: f64| contact.evaluate(&moved(h)).expect("forces").forces;
        let (plus, minus) = (forces(1e-7), forces(-1e-7));
        let slopes: Vec<[f64; 2]> =
            plus.iter().zip(&minus).map(|(p, m)| std::array::from_fn(|i| (m[i] - p[i]) / 2e-7)).collect();
        let product = tangent.product(&direction);
        assert!(distance(&slopes, &product) < 1e-6 * norm(&product));
        contact.set_basis(None).expect("nodes again");
        assert_eq!(contact.evaluate(&scene.coords).expect("forces"), by_nodes);
        contact.set_basis(Some(&rows.basis())).expect("a basis");
        // What lies in planes of symmetry, and fields, are those of the mesh.
        assert_eq!(contact.nodal_contact(&at).expect("fields").pressure.len(), scene.coords.len());
    }
}

/// Fewer unknowns than nodes: a rigid body with one unknown for its place and one for each axis.
#[test]
fn a_body_on_three_unknowns() {
    let scene = Scene::of(&[
        &rectangle_quad4([0.0, -1.0], [1.0, 0.0], [3, 2]),
        &rectangle_quad4([0.2, -0.1], [0.8, 0.4], [2, 2]),
    ]);
    let row = |node: usize| {
        let x = scene.coords[node];
        let first = if scene.nodes_of(0).contains(&node) { 0 } else { 3 };
        vec![(first, 1.0), (first + 1, x[0]), (first + 2, x[1])]
    };
    let rows = Rows::new(6, &(0..scene.coords.len()).map(row).collect::<Vec<_>>());
    let at = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].repeat(2);
    let plain = scene.evaluate(exactly(EnergyLaw::depth(5.0)));
    let mut contact = scene.contact(exactly(EnergyLaw::depth(5.0)));
    contact.set_basis(Some(&rows.basis())).expect("a basis");
    let found = contact.evaluate(&at).expect("forces");
    assert_eq!((found.forces.len(), contact.surface().unknown_count()), (6, 6));
    let [down, up] = [plain.bodies[0].force, plain.bodies[1].force];
    assert!(distance(&[found.forces[0], found.forces[3]], &[down, up]) < 1e-13);
    let masses = [1.0; 6];
    assert!(contact.stable_step(&at, &masses).expect("a step").is_finite());
    assert!(matches!(contact.evaluate(&scene.coords).err(), Some(Error::Length { array: "coords", expected: 6, .. })));
    contact.begin_step(&at).expect("a step");
    contact.set_reference(&at).expect("a reference");
}

#[test]
fn what_is_no_basis_is_refused() {
    let scene = scene();
    let (rows, at) = hierarchical(&scene);
    let refused = |change: &dyn Fn(&mut Rows)| {
        let mut changed = Rows {
            starts: rows.starts.clone(),
            unknowns: rows.unknowns.clone(),
            weights: rows.weights.clone(),
            count: rows.count,
        };
        change(&mut changed);
        let mut contact = scene.contact(exactly(EnergyLaw::depth(1.0)));
        let error = contact.set_basis(Some(&changed.basis())).expect_err("no basis");
        assert!(contact.evaluate(&scene.coords).is_ok(), "the mesh stays as it was");
        error
    };
    let count = rows.count;
    assert_eq!(
        refused(&|rows| rows.unknowns[3] = count as u32),
        Error::UnknownOutOfRange { row: 3, unknown: count as i64, count }
    );
    assert!(matches!(refused(&|rows| rows.weights[5] = f64::NAN), Error::Overflow { .. }));
    assert!(matches!(
        refused(&|rows| rows.starts.truncate(rows.starts.len() - 1)),
        Error::Length { array: "row_starts", .. }
    ));
    assert!(matches!(
        refused(&|rows| rows.weights.truncate(rows.weights.len() - 1)),
        Error::Length { array: "weights", .. }
    ));
    assert!(matches!(refused(&|rows| rows.starts.swap(1, 2)), Error::Unsupported { .. }));
    let mut contact = scene.contact(exactly(EnergyLaw::depth(1.0)));
    contact.set_basis(Some(&rows.basis())).expect("a basis");
    let mut broken = at;
    broken[2][1] = f64::NAN;
    assert_eq!(contact.evaluate(&broken).err(), Some(Error::NonFiniteCoordinate { node: 2, axis: 1 }));
}
