//! The adjoint of an equilibrium against differences of the whole search.

use super::bodies::{Block, Host};
use fmc_contact::contact::equilibrium::{DriverOptions, Goal};
use fmc_contact::contact::{Contact, EnergyLaw, Friction, GradientRequest, Options, TangentPart};
use fmc_contact::{Error, Pose};
use fmc_shapes::Splitmix;
use nalgebra::DVector;

const STIFFNESS: f64 = 3e6;

/// What a press hangs on.
#[derive(Clone, Copy)]
struct Press {
    push: f64,
    load: f64,
    floor: f64,
    stiffness: f64,
    young: f64,
}

/// Changes one of them by so much.
type Change = fn(&mut Press, f64);

const PRESS: Press = Press { push: 0.02, load: 2e3, floor: 0.0, stiffness: STIFFNESS, young: 1.0 };

/// A block on a wider one on a floor, pressed by its top, whose nodes are held.
fn pressed(of: Press) -> (Host, Contact<2>, Vec<f64>) {
    let wide = Block { low: [-0.6, 0.0], high: [1.5, 0.9], cells: 3 };
    let mut host = Host::new(&[wide, Block { low: [0.1, 0.9], high: [0.9, 1.6], cells: 3 }]);
    host.add_weight(0, [of.load, 0.3 * of.load]);
    host.stiffness *= of.young;
    let is_top = |x: [f64; 2]| x[1] > 1.59;
    // On a floor without friction the lower one is held along it by a node.
    host.hold(0, |x| is_top(x) || x == [-0.6, 0.9]);
    host.hold(1, is_top);
    let mut contact = host.contact(Some(0.0), 0.0);
    contact.set_options(Options::new(EnergyLaw::depth(of.stiffness))).expect("options");
    contact.set_pose(0, Pose::at([0.0, of.floor])).expect("a pose");
    let ends: Vec<f64> = host.coords.iter().flat_map(|x| [0.0, if is_top(*x) { -of.push } else { 0.0 }]).collect();
    // To the rounding of the residual, so that differences of 1e-4 know eight digits.
    let options = DriverOptions { tolerance: 1e-13, ..DriverOptions::default() };
    let found =
        host.solved_with(&mut contact, Some(&ends), options).unwrap_or_else(|refusal| panic!("{}", refusal.text));
    assert!(found.warnings.is_empty() && found.updates == 0, "{:?}", found.warnings);
    (host, contact, found.x)
}

fn random(count: usize, seed: u64) -> Vec<f64> {
    let mut random = Splitmix::new(seed);
    (0..count).map(|_| random.between(-1.0, 1.0)).collect()
}

fn placed(host: &Host, x: &[f64]) -> Vec<[f64; 2]> {
    host.coords.iter().zip(x.as_chunks::<2>().0).map(|(x, u)| [x[0] + u[0], x[1] + u[1]]).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// λ of the system with this right side.
fn transposed(host: &Host, contact: &Contact<2>, x: &[f64], right: &[f64]) -> Vec<f64> {
    let mut matrix = host.stiffness.clone();
    for (row, col, value) in contact.tangent(&placed(host, x), TangentPart::Full).expect("a tangent").triplets() {
        if row < matrix.nrows() && col < matrix.ncols() {
            matrix[(row, col)] += value;
        }
    }
    let (mut matrix, mut right) = (matrix.transpose(), DVector::from_column_slice(right));
    for (k, _) in host.free.iter().enumerate().filter(|(_, free)| !**free) {
        matrix.row_mut(k).fill(0.0);
        matrix.column_mut(k).fill(0.0);
        (matrix[(k, k)], right[k]) = (1.0, 0.0);
    }
    matrix.lu().solve(&right).expect("a matrix that is regular").as_slice().to_vec()
}

/// J is a sum of unknowns, and of forces by the stiffness, with factors chosen at random.
#[test]
fn derivatives_are_those_of_the_search() {
    let (host, contact, x) = pressed(PRESS);
    let (by_x, factors) = (random(x.len(), 1), random(x.len(), 2));
    let by_forces: Vec<[f64; 2]> =
        factors.as_chunks::<2>().0.iter().map(|row| row.map(|factor| factor / STIFFNESS)).collect();
    let value = |of: Press| {
        let (host, contact, x) = pressed(of);
        let forces = contact.evaluate(&placed(&host, &x)).expect("forces").forces;
        dot(&by_x, &x) + dot(by_forces.as_flattened(), forces.as_flattened())
    };
    let goal = Goal { by_x: &by_x, by_forces: Some(&by_forces) };
    let nothing = GradientRequest::default();
    let right = contact.adjoint(&host.unknowns(), &x, &goal, None, &nothing).expect("a right side").right;
    let balance = transposed(&host, &contact, &x, &right);
    let request = GradientRequest { positions: true, stiffness: true, ..nothing };
    let found = contact.adjoint(&host.unknowns(), &x, &goal, Some(&balance), &request).expect("derivatives");
    let of_bodies = (&host.stiffness * DVector::from_column_slice(&balance)).as_slice().to_vec();
    let prescribed: Vec<f64> = found.right.iter().zip(&of_bodies).map(|(right, of)| right - of).collect();
    let size = found.right.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    for (k, left) in prescribed.iter().enumerate().filter(|(k, _)| host.free[*k]) {
        // Rounding of sums of K, whose entries are 1e6, by a balance of about 1e-5.
        assert!(left.abs() < 1e-9 * size, "{k}: {left:e} of {size:e}");
    }
    let forces = (&host.stiffness * DVector::from_column_slice(&x)).as_slice().to_vec();
    let tops = (0..host.coords.len()).filter(|&node| host.coords[node][1] > 1.59);
    let by_push: f64 = tops.map(|node| -prescribed[2 * node + 1]).sum();
    let by_stiffness: f64 = found.gradients.pairs.iter().map(|pair| pair.stiffness).sum();
    assert_eq!(found.gradients.pairs.len(), 2);
    let cases: [(&str, f64, f64, Change); 5] = [
        ("load", dot(&balance, &host.load) / PRESS.load, 1.0, |of, by| of.load += by),
        ("modulus", -dot(&balance, &forces), 1e-4, |of, by| of.young += by),
        ("prescribed", by_push, 1e-6, |of, by| of.push += by),
        ("position", found.gradients.positions[0][1], 1e-6, |of, by| of.floor += by),
        ("stiffness", by_stiffness, 1e-4 * STIFFNESS, |of, by| of.stiffness += by),
    ];
    for (name, exact, step, change) in cases {
        let at = |by: f64| {
            let mut of = PRESS;
            change(&mut of, by);
            value(of)
        };
        let slope = (at(step) - at(-step)) / (2.0 * step);
        // Of x that is known to 1e-13 by a step of 1e-4 of what moves, squared, and by 1e-4 of it linearly.
        assert!(exact != 0.0 && (exact / slope - 1.0).abs() < 1e-6, "{name}: {exact:e} {slope:e}");
    }
}

#[test]
fn what_is_not_known_is_refused() {
    let (host, mut contact, x) = pressed(PRESS);
    let by_x = vec![1.0; x.len()];
    let goal = Goal { by_x: &by_x, by_forces: None };
    let (nothing, unknowns) = (GradientRequest::default(), host.unknowns());
    let refused = |contact: &Contact<2>, request: &GradientRequest, part: &str| {
        let error = contact.adjoint(&unknowns, &x, &goal, None, request).expect_err("no adjoint");
        assert!(matches!(error, Error::Unsupported { .. }) && error.to_string().contains(part), "{error}");
    };
    refused(&contact, &GradientRequest { slip: true, ..nothing }, "by the slip between steps");
    let short = contact.adjoint(&unknowns, &x, &Goal { by_x: &by_x[1..], ..goal }, None, &nothing);
    assert!(matches!(short, Err(Error::Length { array: "by_x", .. })));
    let wrong = vec![f64::NAN; x.len()];
    let wrong = contact.adjoint(&unknowns, &x, &goal, Some(&wrong), &nothing);
    assert_eq!(wrong, Err(Error::NonFiniteStiffness { array: "balance", entry: 0 }));
    contact.set_options(Options { friction: Friction::coulomb(0.2), ..*contact.options() }).expect("options");
    refused(&contact, &nothing, "with friction");
    // The search finds the stiffness, and moves surfaces out.
    let mut contact = host.contact(Some(0.0), 0.0);
    let ends: Vec<f64> = host.coords.iter().flat_map(|x| [0.0, if x[1] > 1.59 { -0.02 } else { 0.0 }]).collect();
    host.solved(&mut contact, Some(&ends)).expect("an equilibrium");
    refused(&contact, &nothing, "with multipliers");
}
