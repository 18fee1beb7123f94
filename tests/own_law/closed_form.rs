//! Laws with closed forms: a bond that stiffens, one that is not the same in both directions, and one that goes by the time step and by the place.

use crate::laws::{One, PointByPoint};
use crate::{held, in_space, in_the_plane, moved};
use fmc_contact::contact::{InterfaceLaw, LawFailure, LawPoints, LawResponse};
use fmc_contact::{Contact, Error};

/// t = k δ + c δ³ along every axis: on an area of 1 that is the force, and k δ²/2 + c δ⁴/4 the energy. Sums of areas, to rounding.
#[test]
fn a_bond_that_stiffens_carries_its_closed_form() {
    let (k, c) = (30.0, 4e3);
    let bond = move |jump: &[f64], _: &mut [f64]| {
        let dim = jump.len();
        let slope = |n: usize| if n / dim == n % dim { k + 3.0 * c * jump[n / dim].powi(2) } else { 0.0 };
        One {
            traction: jump.iter().map(|x| k * x + c * x.powi(3)).collect(),
            tangent: (0..dim * dim).map(slope).collect(),
            energies: [jump.iter().map(|x| 0.5 * k * x * x + 0.25 * c * x.powi(4)).sum(), 0.0],
        }
    };
    for gap in [0.0, 0.02] {
        for scene in &in_space(gap) {
            let contact = held(scene, PointByPoint { count: 0, law: bond });
            let by = [0.03, -0.01, 0.05];
            let found = contact.evaluate(&moved(scene, by)).expect("an evaluation");
            for (axis, x) in by.iter().enumerate() {
                let force: f64 = -found.forces[scene.first_node[1]..].iter().map(|f| f[axis]).sum::<f64>();
                assert!((force - (k * x + c * x.powi(3))).abs() < 1e-12, "{force}");
            }
            let energy: f64 = by.iter().map(|x| 0.5 * k * x * x + 0.25 * c * x.powi(4)).sum();
            assert!((found.energy - energy).abs() < 1e-14);
        }
    }
}

/// Stiffer along the first axis than along the second: they are the x and the y axis on a face across z, seen from the second body, whose normal
/// is −z and second axis n × x = −y.
#[test]
fn axes_are_those_that_are_documented() {
    let law = |jump: &[f64], _: &mut [f64]| One {
        traction: vec![0.0, 5.0 * jump[1], 2.0 * jump[2]],
        tangent: vec![0.0, 0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 2.0],
        energies: [0.0; 2],
    };
    for scene in &in_space(0.0) {
        let contact = held(scene, PointByPoint { count: 0, law });
        let coords = moved(scene, [0.03, 0.01, 0.0]);
        let found = contact.evaluate(&coords).expect("an evaluation");
        let force = |axis: usize| -found.forces[scene.first_node[1]..].iter().map(|f| f[axis]).sum::<f64>();
        assert!((force(0) - 0.15).abs() < 1e-14 && (force(1) - 0.02).abs() < 1e-14 && force(2).abs() < 1e-14);
        for point in contact.law_points(&coords).expect("points") {
            let expected = [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
            let off = point.axes.as_flattened().iter().zip(expected.as_flattened()).map(|(a, b)| (a - b).abs());
            assert!(off.fold(0.0, f64::max) < 1e-14);
            // The first body has slid the other way.
            assert!((point.jump[1] + 0.03).abs() < 1e-14 && (point.jump[2] - 0.01).abs() < 1e-14);
        }
    }
}

/// A dashpot of η(x) with the opening of the last step as history: t = η(x) (δ − δ₀)/Δt.
struct Dashpot;

impl InterfaceLaw for Dashpot {
    fn history_count(&self) -> usize {
        1
    }

    fn respond(&self, points: &LawPoints<'_>, response: &mut LawResponse<'_>) -> Result<(), LawFailure> {
        if points.time_step == 0.0 {
            return Err("a time step is wanted".into());
        }
        response.tractions.fill(0.0);
        response.tangents.fill(0.0);
        let dim = points.dim;
        for point in 0..points.count {
            let eta = 1.0 + points.references[point * dim];
            let opening = points.jumps[point * dim];
            response.tractions[point * dim] = eta * (opening - points.history[point]) / points.time_step;
            response.tangents[point * dim * dim] = eta / points.time_step;
            response.history[point] = opening;
        }
        Ok(())
    }
}

/// The mean of 1 + x over the face is 1.5, and quadrature has it exactly.
#[test]
fn a_dashpot_goes_by_the_time_step_the_place_and_its_history() {
    for scene in &in_the_plane(0.0) {
        let mut contact = held(scene, Dashpot);
        let error = contact.evaluate(&scene.coords).unwrap_err().to_string();
        assert_eq!(error, "the law of the interface of bodies 0 and 1: a time step is wanted");
        contact.set_time_step(0.25).expect("a time");
        contact.begin_step(&scene.coords).expect("a step");
        for (before, now) in [(0.0, 0.02), (0.02, 0.05), (0.05, 0.01)] {
            let coords = moved(scene, [0.0, now]);
            let found = contact.evaluate(&coords).expect("an evaluation");
            let force = -found.forces[scene.first_node[1]..].iter().map(|f| f[1]).sum::<f64>();
            assert!((force - 1.5 * (now - before) / 0.25).abs() < 1e-13);
            contact.commit_step(&coords).expect("a step");
        }
    }
}

/// Springs whose stiffness is the mean of a field on both sides: t = (T_A + T_B)/2 δ. Fields are linear along x, so that quadrature has the mean
/// over the face exactly: of 1 + x below and 3 above it is 2.25. A second field is not looked at.
struct Heated;

impl InterfaceLaw for Heated {
    fn respond(&self, points: &LawPoints<'_>, response: &mut LawResponse<'_>) -> Result<(), LawFailure> {
        let (dim, fields) = (points.dim, points.field_count);
        if fields != 2 {
            return Err(format!("{fields} fields").into());
        }
        response.tangents.fill(0.0);
        for point in 0..points.count {
            let [own, other] = [0, 1].map(|side| points.fields[(2 * point + side) * fields]);
            assert!((own - 1.0 - points.references[point * dim]).abs() < 1e-14 && (other - 3.0).abs() < 1e-14);
            for axis in 0..dim {
                response.tractions[point * dim + axis] = 0.5 * (own + other) * points.jumps[point * dim + axis];
                response.tangents[(point * dim + axis) * dim + axis] = 0.5 * (own + other);
            }
        }
        Ok(())
    }
}

#[test]
fn laws_go_by_fields_of_the_host() {
    for scene in &in_space(0.0) {
        let mut contact = held(scene, Heated);
        assert!(contact.evaluate(&scene.coords).unwrap_err().to_string().ends_with("0 fields"));
        let of_node = |(node, x): (usize, &[f64; 3])| {
            [if node < scene.first_node[1] { 1.0 + x[0] } else { 3.0 }, f64::from(node as u32)]
        };
        let values: Vec<f64> = scene.coords.iter().enumerate().flat_map(of_node).collect();
        contact.set_law_fields(2, &values).expect("fields");
        let force = |contact: &Contact<3>| {
            let found = contact.evaluate(&moved(scene, [0.0, 0.0, 0.02])).expect("an evaluation");
            -found.forces[scene.first_node[1]..].iter().map(|f| f[2]).sum::<f64>()
        };
        assert!((force(&contact) - 2.25 * 0.02).abs() < 1e-15);
        let found = values.len() - 1;
        assert_eq!(
            contact.set_law_fields(2, &values[1..]),
            Err(Error::Length { array: "values", expected: found + 1, found })
        );
        let mut wrong = values.clone();
        wrong[3] = f64::NAN;
        assert!(matches!(contact.set_law_fields(2, &wrong), Err(Error::BadEntry { array: "values", entry: 3, .. })));
        assert!((force(&contact) - 2.25 * 0.02).abs() < 1e-15);
    }
}
