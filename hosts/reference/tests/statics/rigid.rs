//! Nodes that move rigidly: carried on arcs, and joined.

use crate::scene::{exact, part};
use fmc_contact::{CellType, EnergyLaw};
use fmc_shapes::rectangle_quad4;
use fmc_solid::fem::{Constraints, Model};
use fmc_solid::statics::{Carried, Equilibrium, Follower, Path, Problem, Rigid, RigidMotion, StaticsError};
use std::ops::ControlFlow;

/// Two squares side by side, far from one another.
fn squares() -> Model<2> {
    let square = |x: f64| part("square", CellType::Quad4, rectangle_quad4([x, 0.0], [x + 1.0, 1.0], [3, 3]));
    Model::new(vec![square(0.0), square(8.0)]).unwrap()
}

fn solved(problem: Problem<2>, steps: usize, reached: &mut dyn FnMut(&Equilibrium<2>)) -> Equilibrium<2> {
    let mut at = Equilibrium::new(problem).unwrap();
    let path = Path { steps, ..Path::default() };
    at.follow_telling(path, &mut |_| ControlFlow::Continue(()), reached).unwrap();
    at
}

/// After every part of a quarter turn the nodes are where they have turned by that part: not on the chord to the end. Rounding.
#[test]
fn carried_nodes_are_on_their_arcs() {
    let model = squares();
    let (nodes, centre, angle): (Vec<usize>, [f64; 2], f64) =
        (model.nodes_of(0).collect(), [-1.0, 2.0], 0.5 * std::f64::consts::PI);
    let place = |x: [f64; 2], angle: f64| {
        let arm = [x[0] - centre[0], x[1] - centre[1]];
        let (s, c) = angle.sin_cos();
        [c * arm[0] - s * arm[1] - arm[0] + 0.4 * angle, s * arm[0] + c * arm[1] - arm[1]]
    };
    let coords = model.coords().to_vec();
    let mut supports = Constraints::default();
    supports.fix(model.nodes_where(1, |x| x[1] == 0.0));
    for &node in &nodes {
        place(coords[node], angle).into_iter().enumerate().for_each(|(axis, u)| supports.prescribe([node], axis, u));
    }
    let ends = [
        RigidMotion { translation: [0.0; 2], rotation: [0.0; 3] },
        RigidMotion { translation: [0.4 * angle, 0.0], rotation: [0.0, 0.0, angle] },
    ];
    let rigid = Rigid { carried: vec![Carried { nodes: nodes.clone(), centre, ends }], ..Rigid::default() };
    let mut loads = Vec::new();
    solved(Problem { supports, rigid, ..Problem::new(model, exact(EnergyLaw::depth(1e4))) }, 3, &mut |at| {
        loads.push(at.load());
        for &node in &nodes {
            let expected = place(coords[node], at.load() * angle);
            let u = at.displacement()[node];
            assert!((0..2).all(|axis| (u[axis] - expected[axis]).abs() < 1e-14), "{u:?} {expected:?}");
        }
    });
    assert_eq!(loads.len(), 3);
}

/// A square whose upper side is joined along y goes down by as much under a force as it needs to be pushed down with that force: sides held along
/// x, so that both are F = (λ + 2μ) u, to the residual.
#[test]
fn what_is_joined_moves_as_one_under_a_force() {
    let model = squares();
    let top = model.nodes_where(0, |x| x[1] == 1.0);
    let mut supports = Constraints::default();
    supports.fix(model.nodes_where(1, |x| x[1] == 0.0));
    supports.prescribe(model.nodes_where(0, |x| x[1] == 0.0), 1, 0.0);
    supports.prescribe(model.nodes_of(0), 0, 0.0);
    let mut load = vec![[0.0; 2]; model.node_count()];
    load[top[2]][1] = -7.0;
    let joined: Vec<usize> = top.iter().map(|node| node * 2 + 1).collect();
    let material = model.parts()[0].material;
    let rigid = Rigid { joined: vec![joined.clone()], ..Rigid::default() };
    let problem = Problem { supports, load, rigid, ..Problem::new(model, exact(EnergyLaw::depth(1e4))) };
    let at = solved(problem, 1, &mut |_| ());
    let expected = -7.0 / (material.lame() + 2.0 * material.shear_modulus());
    assert!(top.iter().all(|&node| (at.displacement()[node][1] / expected - 1.0).abs() < 1e-9), "{expected}");
    // All but one of them was loaded by what joins them: together nothing.
    let sum: f64 = top.iter().map(|&node| at.balance().residual[node][1]).sum();
    assert!(sum.abs() < 1e-8 && at.balance().residual[top[0]][1].abs() > 1.0);
    assert_eq!(at.equation_count(), 2 * (16 - 4) + 2 * 4 + 1);
}

#[test]
fn joins_that_overlap_are_refused() {
    let refused = |joined: Vec<Vec<usize>>, held: usize| {
        let model = squares();
        let mut supports = Constraints::default();
        supports.fix([held]);
        let rigid = Rigid { joined, ..Rigid::default() };
        Equilibrium::new(Problem { supports, rigid, ..Problem::new(model, exact(EnergyLaw::depth(1e4))) }).err()
    };
    assert_eq!(refused(vec![vec![2, 4], vec![4, 6]], 9), Some(StaticsError::Joined { node: 2, axis: 0 }));
    assert_eq!(refused(vec![vec![2, 18]], 9), Some(StaticsError::Joined { node: 9, axis: 0 }));
    assert_eq!(refused(vec![vec![4, 3]], 9), Some(StaticsError::Joined { node: 1, axis: 1 }));
    assert_eq!(refused(vec![vec![2, 640]], 9), Some(StaticsError::Joined { node: 320, axis: 0 }));
    assert_eq!(refused(vec![vec![2, 4], vec![7, 9]], 9), None);
}

/// An edge that follows one of its nodes by a weight of 1 is the edge that is joined; and with a weight and a constant forces have the weights of the
/// motions: virtual work. The residual of the search is 1e-9 of the forces.
#[test]
fn followers_move_by_their_weights_and_hand_on_what_they_bear() {
    let solved_with = |rigid: fn(&[usize]) -> Rigid<2>, pressed: bool| {
        let model = squares();
        let top = model.nodes_where(0, |x| x[1] == 1.0);
        let mut supports = Constraints::default();
        supports.fix(model.nodes_where(1, |x| x[1] == 0.0));
        supports.prescribe(model.nodes_where(0, |x| x[1] == 0.0), 1, 0.0);
        supports.prescribe(model.nodes_of(0), 0, 0.0);
        let mut load = vec![[0.0; 2]; model.node_count()];
        load[top[2]][1] = if pressed { -7.0 } else { 0.0 };
        let rigid = rigid(&top.iter().map(|node| node * 2 + 1).collect::<Vec<_>>());
        let at = solved(
            Problem { supports, load, rigid, ..Problem::new(model, exact(EnergyLaw::depth(1e4))) },
            3,
            &mut |_| (),
        );
        let all: Vec<[f64; 2]> =
            top.iter().map(|&node| [at.displacement()[node][1], at.balance().residual[node][1]]).collect();
        all
    };
    let joined = solved_with(|edge| Rigid { joined: vec![edge.to_vec()], ..Rigid::default() }, true);
    let followed = solved_with(
        |edge| {
            let of = |&freedom: &usize| Follower { freedom, of: vec![(edge[0], 1.0)], apart: None };
            Rigid { followers: edge[1..].iter().map(of).collect(), ..Rigid::default() }
        },
        true,
    );
    for (a, b) in joined.iter().zip(&followed) {
        assert!((a[0] - b[0]).abs() < 1e-8 * a[0].abs() && (a[1] - b[1]).abs() < 1e-7, "{a:?} {b:?}");
    }
    let levered = solved_with(
        |edge| {
            let of = |&freedom: &usize| Follower { freedom, of: vec![(edge[0], -0.5)], apart: Some(0.01) };
            Rigid { followers: edge[1..].iter().map(of).collect(), ..Rigid::default() }
        },
        false,
    );
    let work: f64 = levered[0][1] - 0.5 * levered[1..].iter().map(|of| of[1]).sum::<f64>();
    assert!(work.abs() < 1e-8 && levered[0][1].abs() > 1e-3, "{levered:?}");
    assert!(levered[1..].iter().all(|of| (of[0] + 0.5 * levered[0][0] - 0.01).abs() < 1e-15), "{levered:?}");
}

#[test]
fn followers_that_are_held_or_followed_are_refused() {
    let refused = |followers: Vec<Follower>| {
        let model = squares();
        let mut supports = Constraints::default();
        supports.fix([9]);
        let rigid = Rigid { followers, ..Rigid::default() };
        Equilibrium::new(Problem { supports, rigid, ..Problem::new(model, exact(EnergyLaw::depth(1e4))) }).err()
    };
    let one = |freedom: usize, of: usize| Follower { freedom, of: vec![(of, 1.0)], apart: None };
    assert_eq!(refused(vec![one(18, 2)]), Some(StaticsError::Joined { node: 9, axis: 0 }));
    assert_eq!(refused(vec![one(2, 4), one(2, 6)]), Some(StaticsError::Joined { node: 1, axis: 0 }));
    assert_eq!(refused(vec![one(2, 4), one(4, 6)]), Some(StaticsError::Joined { node: 2, axis: 0 }));
    assert_eq!(refused(vec![one(2, 640)]), Some(StaticsError::Joined { node: 320, axis: 0 }));
    assert_eq!(refused(vec![one(2, 4), one(6, 18)]), None);
}
