//! Rigid bodies and couplings: nodes that reference nodes move or load.

use crate::blocks_text::{block, elastic};
use crate::scene::{Outcome, said_in, solved_text};

/// A block held below, a punch above it that covers a part of its face, and what goes with the punch: a reference node beside both. The pressure by
/// penetration is given, so that problems that are one have one answer.
fn punch(gap: f64, rigid: &str, step: &str) -> String {
    block("BASE", 1, [3, 2, 2], [[0.0; 3], [3.0, 2.0, 1.0]])
        + &block("PUNCH", 101, [1, 1, 1], [[0.2, 0.1, 1.0 + gap], [1.5, 1.2, 1.5 + gap]])
        + "*NODE, NSET=REF\n900, 2., -1., 3.\n*NSET, NSET=SHAPE\nPUNCH_NODES\n"
        + &elastic(&["BASE", "PUNCH"], 1000.0, 0.3)
        + rigid
        + "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n2e4\n*CONTACT PAIR, INTERACTION=I\nS_PUNCH_LOW, S_BASE_HIGH\n"
        + "*BOUNDARY\nBASE_LOW, 1, 3\n"
        + step
}

const BODY: &str = "*RIGID BODY, ELSET=PUNCH, REF NODE=REF\n";

fn step(head: &str, body: &str) -> String {
    format!("*STEP{head}\n*STATIC\n{body}\n*NODE PRINT, NSET=BASE_LOW\nRF\n*END STEP\n")
}

/// The moment of what holds the base, about a point.
fn moment_of_base(outcome: &Outcome<3>, about: [f64; 3]) -> [f64; 3] {
    let step = outcome.steps.last().unwrap();
    let mut sum = [0.0; 3];
    for (((place, _), u), force) in outcome.contact.iter().zip(&outcome.displacement).zip(&step.reactions) {
        let arm: [f64; 3] = std::array::from_fn(|k| place[k] + u[k] - about[k]);
        for k in 0..3 {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            sum[k] += arm[i] * force[j] - arm[j] * force[i];
        }
    }
    sum
}

/// A rigid punch is its nodes, prescribed one by one: the same bits. Its reaction is the sum of theirs, its moment balances what holds the base: to the
/// residual of 1e-9 of the forces, with finite displacements, for which equilibrium is where bodies are.
#[test]
fn a_rigid_body_is_its_nodes_prescribed_one_by_one() {
    let driven = "*BOUNDARY\nREF, 3, 3, -0.05\nREF, 1, 2\nREF, 4, 6";
    let each = "*BOUNDARY\nPUNCH_NODES, 3, 3, -0.05\nPUNCH_NODES, 1, 2";
    let rigid = solved_text::<3>("rigid", &punch(0.01, BODY, &step(", NLGEOM", driven)));
    let nodes = solved_text::<3>("rigid-nodes", &punch(0.01, "", &step(", NLGEOM", each)));
    assert_eq!(rigid.displacement, nodes.displacement);
    let (step, reference) = (&rigid.steps[0], &rigid.steps[0].references[0]);
    let sum = (0..3).map(|k| nodes.steps[0].reactions[36..].iter().map(|force| force[k]).sum::<f64>());
    sum.zip(reference.force).for_each(|(sum, force)| assert!((sum - force).abs() < 1e-12, "{sum} {force}"));
    assert!(reference.label == 900 && reference.force[2] < -1.0 && reference.displacement == [0.0, 0.0, -0.05]);
    assert!(step.sets[0].1.iter().zip(reference.force).all(|(base, force)| (base + force).abs() < 1e-7), "{step:?}");
    let base = moment_of_base(&rigid, [2.0, -1.0, 2.95]);
    let off = base.iter().zip(reference.moment).map(|(b, m)| (b + m).abs()).fold(0.0, f64::max);
    assert!(off < 1e-7 && reference.moment[0].abs() > 1.0, "{base:?} {:?}", reference.moment);
    let table = fmc_deck::step_table(step);
    assert!(table.contains("reaction of this reference node") && table.contains("node 900"), "{table}");
}

/// Under a force a guided punch comes to rest where a punch that is driven there bears that force: the inverse problem. The gap closes first.
#[test]
fn a_force_on_a_guided_punch_is_the_reaction_where_it_rests() {
    for nlgeom in ["", ", NLGEOM"] {
        let guided = "*BOUNDARY\nREF, 1, 2\nREF, 4, 6\n*CLOAD\n900, 3, -20.";
        let loaded = solved_text::<3>("guided", &punch(0.02, BODY, &step(nlgeom, guided)));
        let reference = &loaded.steps[0].references[0];
        let down = reference.displacement[2];
        // Nothing holds it along z, and all of its nodes go by the same way.
        assert!(reference.force[2].abs() < 1e-7 && down < -0.02, "{reference:?}");
        assert!(loaded.displacement[36..].iter().all(|u| (u[2] - down).abs() < 1e-14 && u[0] == 0.0));
        assert!((loaded.steps[0].load[2] + 20.0).abs() < 1e-12);
        assert!((loaded.steps[0].sets[0].1[2] - 20.0).abs() < 1e-6, "{:?}", loaded.steps[0].sets);
        let driven = format!("*BOUNDARY\nREF, 1, 2\nREF, 4, 6\nREF, 3, 3, {down:?}");
        let driven = solved_text::<3>("driven", &punch(0.02, BODY, &step(nlgeom, &driven)));
        let other = &driven.steps[0].references[0];
        let scale = other.force[2].abs();
        assert!((other.force[2] + 20.0).abs() < 1e-6 * scale, "{other:?}");
        for k in 0..2 {
            assert!(
                (other.moment[k] - reference.moment[k]).abs() < 1e-6 * scale,
                "{:?} {:?}",
                other.moment,
                reference.moment
            );
        }
    }
}

/// A tool that is turned by a finite rotation vector: every node is where Rodrigues' formula has it. Small rotations without NLGEOM.
#[test]
fn a_tool_turns_about_its_reference_node() {
    let body = "*BOUNDARY\nREF, 1, 1, 0.3\nREF, 2, 3\nREF, 4, 4, 0.2\nREF, 5, 5, -0.4\nREF, 6, 6, 1.1";
    let turn = [0.2f64, -0.4, 1.1];
    let angle = turn.iter().map(|x| x * x).sum::<f64>().sqrt();
    let axis = turn.map(|x| x / angle);
    let cross = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
    };
    for nlgeom in [true, false] {
        let head = if nlgeom { ", NLGEOM" } else { "" };
        let text = punch(40.0, BODY, &step(head, body).replace("*STATIC", "*STATIC\n0.25, 1."));
        let outcome = solved_text::<3>("turned", &text);
        for ((place, _), u) in outcome.contact[36..].iter().zip(&outcome.displacement[36..]) {
            let arm: [f64; 3] = std::array::from_fn(|k| place[k] - [2.0, -1.0, 3.0][k]);
            let along: f64 = axis.iter().zip(arm).map(|(n, a)| n * a).sum();
            let normal = cross(axis, arm);
            for k in 0..3 {
                let turned = angle.cos() * arm[k] + angle.sin() * normal[k] + (1.0 - angle.cos()) * along * axis[k];
                let expected =
                    if nlgeom { turned - arm[k] } else { angle * normal[k] } + if k == 0 { 0.3 } else { 0.0 };
                assert!((u[k] - expected).abs() < 1e-13 * 40.0, "{u:?} {k} {expected}");
            }
        }
        // Nothing resists a rigid body by itself: its elements have no stress that counts beside 1000.
        assert!(outcome.steps[0].references[0].force.iter().all(|force| force.abs() < 1e-8), "{:?}", outcome.steps[0]);
    }
}

/// A bar of length 2 that is pulled by a face coupled to a node off its axis, with ν = 0: the closed forms of tension, F = E A u / L, and of its moment
/// about both reference nodes. In the plane along z of the bar nothing else moves.
#[test]
fn a_coupling_bears_force_and_moment() {
    let couplings = "*COUPLING, CONSTRAINT NAME=A, REF NODE=900, SURFACE=S_BAR_LOW\n*KINEMATIC\n1, 3\n\
                     *COUPLING, CONSTRAINT NAME=B, REF NODE=901, SURFACE=S_BAR_HIGH\n*KINEMATIC\n1, 6\n";
    let old = "*KINEMATIC COUPLING, REF NODE=900\nBAR_LOW, 1, 3\n*KINEMATIC COUPLING, REF NODE=901\nBAR_HIGH\n";
    let beams = "*MPC\nBEAM, BAR_LOW, 900\nBEAM, BAR_HIGH, 901\n";
    for couplings in [couplings, old, beams] {
        let text = bar(couplings, "*BOUNDARY\n900, ENCASTRE\n901, 3, 3, 0.1\n901, 1, 2\n901, 4, 6");
        let step = &solved_text::<3>("coupled", &text).steps[0];
        let [low, high] = [&step.references[0], &step.references[1]];
        // E A u/L = 1000 · 2 · 0.1/2; the axis is at (1, 0.5), the nodes are at (0, 0, −1) and (4, 2, 3): arms from these to it times the force.
        let close = |found: [f64; 3], expected: [f64; 3]| found.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-8);
        assert!(close(high.force, [0.0, 0.0, 100.0]) && close(low.force, [0.0, 0.0, -100.0]), "{low:?} {high:?}");
        assert!(close(high.moment, [-150.0, 300.0, 0.0]) && close(low.moment, [-50.0, 100.0, 0.0]), "{low:?} {high:?}");
    }
}

fn bar(rigid: &str, body: &str) -> String {
    block("BAR", 1, [2, 1, 2], [[0.0; 3], [2.0, 1.0, 2.0]])
        + "*NODE\n900, 0., 0., -1.\n901, 4., 2., 3.\n"
        + &elastic(&["BAR"], 1000.0, 0.0)
        + rigid
        + &format!("*STEP\n*STATIC\n{body}\n*END STEP\n")
}

/// Forces and moments on a distributing coupling: what holds the other end balances them, by statics alone. A uniform traction comes of a force at the
/// middle of a face: the stress is uniform.
#[test]
fn a_distributing_coupling_has_resultant_and_moment() {
    let held = "*COUPLING, CONSTRAINT NAME=A, REF NODE=900, SURFACE=S_BAR_LOW\n*KINEMATIC\n";
    let shared = format!("{held}*COUPLING, CONSTRAINT NAME=B, REF NODE=901, SURFACE=S_BAR_HIGH\n*DISTRIBUTING\n");
    let loads = "*BOUNDARY\n900, ENCASTRE\n*CLOAD\n901, 1, 3.\n901, 2, -5.\n901, 3, 7.\n901, 4, 11.\n901, 6, -13.";
    let low = solved_text::<3>("shared", &bar(&shared, loads)).steps[0].references[0].clone();
    let (force, moment, arm) = ([3.0, -5.0, 7.0], [11.0, 0.0, -13.0], [4.0, 2.0, 4.0]);
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let expected = -(moment[k] + arm[i] * force[j] - arm[j] * force[i]);
        assert!(
            (low.force[k] + force[k]).abs() < 1e-8 && (low.moment[k] - expected).abs() < 1e-7,
            "{low:?} {expected}"
        );
    }
    let middle = bar(&shared, "*BOUNDARY\nBAR_LOW, 1, 3\n*CLOAD\n901, 3, 14.")
        .replace(held, "")
        .replace("901, 4., 2., 3.", "901, 1., 0.5, 9.");
    let outcome = solved_text::<3>("traction", &middle);
    // Force by area; the lateral strain is 0 with ν = 0.
    assert!(crate::scene::largest_off(&outcome.stresses, [0.0, 0.0, 7.0, 0.0, 0.0, 0.0]) < 1e-9);
}

/// A second step with OP=NEW lets the punch go: what held it fades, and a force takes its place. The third drives it again.
#[test]
fn steps_release_and_take_up_a_reference_node() {
    let first = step("", "*BOUNDARY\nREF, 3, 3, -0.05\nREF, 1, 2\nREF, 4, 6");
    let second = step("", "*BOUNDARY, OP=NEW\nBASE_LOW, 1, 3\nREF, 1, 2\nREF, 4, 6\n*CLOAD\nREF, 3, -8.");
    let third = step("", "*BOUNDARY\nREF, 3, 3, -0.05\n*CLOAD, OP=NEW");
    let outcome = solved_text::<3>("released", &punch(0.0, BODY, &(first + &second + &third)));
    let of = |step: usize| &outcome.steps[step].references[0];
    assert!(of(0).force[2] < -8.0 && of(1).force[2].abs() < 1e-7, "{:?}", outcome.steps);
    assert!((outcome.steps[1].sets[0].1[2] - 8.0).abs() < 1e-6 && of(1).displacement[2] > -0.05);
    // The same state by the same motion: without friction the way does not count.
    assert!((of(2).force[2] / of(0).force[2] - 1.0).abs() < 1e-7, "{:?} {:?}", of(0), of(2));
}

/// A rigid plate tied to a bar pulls it: as much as it bears.
#[test]
fn a_rigid_body_can_be_tied() {
    let text = block("BAR", 1, [2, 2, 2], [[0.0; 3], [1.0, 1.0, 2.0]])
        + &block("PLATE", 101, [1, 1, 1], [[-0.5, -0.5, 2.0], [1.5, 1.5, 2.5]])
        + "*NODE\n900, 0.5, 0.5, 4.\n"
        + &elastic(&["BAR", "PLATE"], 1000.0, 0.0)
        + "*RIGID BODY, TIE NSET=PLATE_NODES, REF NODE=900\n*TIE, NAME=T, POSITION TOLERANCE=0.1\nS_BAR_HIGH, S_PLATE_LOW\n"
        + "*BOUNDARY\nBAR_LOW, 1, 3\n900, 1, 2\n900, 4, 6\n";
    for (body, nlgeom) in [("*BOUNDARY\n900, 3, 3, 0.02", ""), ("*CLOAD\n900, 3, 10.", "")] {
        let outcome =
            solved_text::<3>("tied-rigid", &(text.clone() + &step(nlgeom, body).replace("BASE_LOW", "BAR_LOW")));
        let off = crate::scene::largest_off(&outcome.stresses[..8], [0.0, 0.0, 10.0, 0.0, 0.0, 0.0]);
        // What ties leave apart: a part of 1e-6 of the displacement.
        assert!(off < 1e-5, "{body} {off:.2e}");
        assert!((outcome.steps[0].references[0].displacement[2] - 0.02).abs() < 2e-8, "{:?}", outcome.steps[0]);
    }
}

#[test]
fn what_reference_nodes_cannot_do_is_refused_by_line() {
    let all = "*BOUNDARY\nREF, 3, 3, -0.05\nREF, 1, 2\nREF, 4, 6";
    let good = punch(0.0, BODY, &step(", NLGEOM", all));
    assert_eq!(said_in::<3>(&good, "good.inp"), "nothing");
    let share = "*COUPLING, CONSTRAINT NAME=B, REF NODE=900, SURFACE=S_PUNCH_HIGH\n*DISTRIBUTING\n";
    let rows = [
        ("REF, 4, 6", "REF, 5, 6", "degree of freedom 4 of node 900, of *RIGID BODY of line"),
        (
            "REF, 3, 3, -0.05\nREF, 1, 2\nREF, 4, 6",
            "REF, 1, 2\nREF, 5, 6\nREF, 4, 4, 0.1",
            "is free along degree of freedom 3 while it turns",
        ),
        ("REF, 1, 2", "REF, 1, 2\nPUNCH_LOW, 1", "follows the reference node 900 of *RIGID BODY of line"),
        ("REF, 1, 2", "REF, 1, 7", "degree of freedom 7 is not known, only 1 to 6"),
        ("BASE_LOW, 1, 3", "BASE_LOW, 1, 4, 0.1", "degree of freedom 4 is not known, only 1, 2 and 3"),
        (
            "BASE_LOW, 1, 3",
            "BASE_LOW, 1, 3\n*NODE\n950, 0., 0., 0.\n*BOUNDARY\n950, 1",
            "node 950 of '950' belongs to no element",
        ),
        (BODY, "*RIGID BODY, ELSET=PUNCH, REF NODE=1\n", "the reference node 1 belongs to an element"),
        (BODY, "*RIGID BODY, ELSET=PUNCH, REF NODE=BASE_LOW\n", "is more than one node"),
        (BODY, "*RIGID BODY, ELSET=PUNCH\n", "*RIGID BODY has no REF NODE="),
        (BODY, "*RIGID BODY, REF NODE=REF\n", "needs an ELSET, NSET, TIE NSET, PIN NSET or ANALYTICAL SURFACE"),
        (
            BODY,
            "*RIGID BODY, ELSET=PUNCH, REF NODE=REF, POSITION=CENTER OF MASS\n",
            "POSITION=CENTER OF MASS is not known",
        ),
        (BODY, "*RIGID BODY, ELSET=PUNCH, REF NODE=REF\n1.\n", "has a data line more than is known"),
        (
            BODY,
            "*NODE\n950, 0., 0., 0.\n*RIGID BODY, ELSET=PUNCH, REF NODE=REF\n*RIGID BODY, NSET=PUNCH_LOW, REF NODE=950\n",
            "follows the reference node of *RIGID BODY of line",
        ),
        (BODY, &format!("{BODY}{share}"), "is the reference node of line"),
        (BODY, share, "takes forces and moments, and no motion is prescribed for it"),
        (
            BODY,
            "*COUPLING, CONSTRAINT NAME=B, REF NODE=900, SURFACE=S_PUNCH_HIGH\n",
            "neither *KINEMATIC nor *DISTRIBUTING",
        ),
        (
            BODY,
            "*COUPLING, CONSTRAINT NAME=B, REF NODE=900, SURFACE=S_NONE\n*KINEMATIC\n",
            "there is no surface 'S_NONE'",
        ),
        (
            BODY,
            "*COUPLING, CONSTRAINT NAME=B, REF NODE=900, SURFACE=S_PUNCH_HIGH\n*KINEMATIC\n4, 6\n",
            "none of the degrees of freedom 1 to 3",
        ),
        (
            BODY,
            "*COUPLING, CONSTRAINT NAME=B, REF NODE=900, SURFACE=S_PUNCH_HIGH, INFLUENCE RADIUS=1.\n*KINEMATIC\n",
            "INFLUENCE RADIUS is not known",
        ),
        (BODY, "*KINEMATIC\n", "*KINEMATIC stands behind no *COUPLING"),
        (
            BODY,
            "*COUPLING, CONSTRAINT NAME=B, REF NODE=900, SURFACE=S_PUNCH_HIGH\n*KINEMATIC\n1, 2\n",
            "no node follows node 900 along degree of freedom 3",
        ),
        (
            BODY,
            "*KINEMATIC COUPLING, REF NODE=900\nPUNCH_NODES, 3, 1\n",
            "the last degree of freedom is below the first",
        ),
        (
            BODY,
            "*RIGID BODY, ELSET=PUNCH, REF NODE=REF, ROT NODE=REF\n",
            "cannot be a REF NODE or ROT NODE and something else",
        ),
    ];
    for (number, (from, to, expected)) in rows.into_iter().enumerate() {
        assert!(good.contains(from), "{from}");
        let name = format!("rigid{number}.inp");
        let message = said_in::<3>(&good.replacen(from, to, 1), &name);
        let line =
            message.strip_prefix(&format!("{name}:")).and_then(|rest| rest.split(':').next()?.parse::<usize>().ok());
        assert!(line.is_some_and(|line| line > 1) && message.contains(expected), "{to}: {message}");
    }
}

/// CalculiX's second node: its displacements are the rotations. A quarter turn about z takes x to y.
#[test]
fn a_rot_node_turns() {
    let body = "*BOUNDARY\nREF, 1, 3\n901, 1, 2\n901, 3, 3, 1.5707963267948966";
    let rigid = format!("*NODE\n901, 0., 0., 0.\n{}", BODY.replace("REF NODE=REF", "REF NODE=REF, ROT NODE=901"));
    let outcome = solved_text::<3>(
        "rot-node",
        &punch(40.0, &rigid, &step(", NLGEOM", body).replace("*STATIC", "*STATIC\n0.25, 1.")),
    );
    for ((place, _), u) in outcome.contact[36..].iter().zip(&outcome.displacement[36..]) {
        let arm = [place[0] - 2.0, place[1] + 1.0];
        let expected = [-arm[1] - arm[0], arm[0] - arm[1], 0.0];
        assert!(u.iter().zip(expected).all(|(u, e)| (u - e).abs() < 1e-13), "{u:?} {expected:?}");
    }
}

/// A rigid square on an elastic one, pressed by a force, then dragged: it slides, and the reaction along x is μ times the force, along y nothing; in the
/// plane its moment is that of the force, which acts off the contact. Bounds as for the dragged block of `friction`.
#[test]
fn a_punch_under_a_force_is_dragged_with_friction() {
    let page = include_str!("../../../../docs/solve.md");
    let shown = page.split("```text\n").find(|block| block.starts_with("*NODE")).unwrap().split("```").next().unwrap();
    // So stiff that the face does not turn, along which friction acts.
    let start = shown[..shown.find("*BOUNDARY").unwrap()].replace("1000., 0.3", "1e6, 0.3");
    let text = format!(
        "{start}*NODE\n9, 0.5, 5.\n*RIGID BODY, ELSET=UPPER, REF NODE=9\n*BOUNDARY\n1, 1, 2\n2, 1, 2\n9, 1\n9, 6\n\
         *STEP\n*STATIC\n*CLOAD\n9, 2, -10.\n*END STEP\n*STEP\n*STATIC\n0.25, 1.\n*BOUNDARY\n9, 1, 1, 0.05\n*NODE PRINT, NSET=9\nRF\n*END STEP\n"
    );
    let outcome = solved_text::<2>("dragged", &text);
    let [pressed, dragged] = &outcome.steps[..] else { panic!("two steps") };
    assert!(
        (pressed.pairs[0].force[1] - 10.0).abs() < 1e-6 && pressed.references[0].force[1].abs() < 1e-6,
        "{pressed:?}"
    );
    let reference = &dragged.references[0];
    assert!((reference.force[0] - 2.0).abs() < 2e-3 && reference.force[1].abs() < 1e-6, "{reference:?}");
    assert_eq!(dragged.sets, [("9".to_owned(), reference.force)]);
    assert!(reference.displacement[0] == 0.05 && reference.displacement[1] < 0.0 && reference.moment[2].abs() > 1.0);
}
