//! `*EQUATION`: what follows what, against merged meshes, closed forms and statics.

use crate::blocks_text::{block, elastic};
use crate::scene::{Outcome, said_in, solved_text};

/// A column of two blocks, of one mesh or joined by equations, bent by a shear at its top, with a punch beside the load that a force presses on it.
fn column(is_merged: bool) -> String {
    let size = [2.0, 2.0, 4.0];
    let blocks = match is_merged {
        true => block("LOWER", 1, [2, 2, 4], [[0.0; 3], size]).replace("S_LOWER_HIGH", "S_UPPER_HIGH"),
        false => {
            block("LOWER", 1, [2, 2, 2], [[0.0; 3], [2.0, 2.0, 2.0]])
                + &block("UPPER", 101, [2, 2, 2], [[0.0, 0.0, 2.0], size])
                + "*EQUATION\n2\nLOWER_HIGH, 1, 1., UPPER_LOW, 1, -1.\n2\nUPPER_LOW, 2, 2.5\nLOWER_HIGH, 2, -2.5\n2\nLOWER_HIGH, 3, 1., UPPER_LOW, 3, -1.\n"
        }
    };
    let sets: &[&str] = if is_merged { &["LOWER", "PUNCH"] } else { &["LOWER", "UPPER", "PUNCH"] };
    let top = if is_merged { "LOWER_HIGH" } else { "UPPER_HIGH" };
    blocks
        + &block("PUNCH", 201, [1, 1, 1], [[0.4, 0.3, 4.01], [1.3, 1.2, 4.5]])
        + &elastic(sets, 1000.0, 0.3)
        + "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n2e4\n*CONTACT PAIR, INTERACTION=I\nS_PUNCH_LOW, S_UPPER_HIGH\n"
        + "*BOUNDARY\nLOWER_LOW, 1, 3\nPUNCH_NODES, 1, 2\n*STEP\n*STATIC\n*BOUNDARY\nPUNCH_HIGH, 3, 3, -0.03\n*CLOAD\n"
        + &format!("{top}, 1, 0.5\n*NODE PRINT, NSET=LOWER_LOW\nRF\n*END STEP\n")
}

/// Displacements of the places of another outcome.
fn there(outcome: &Outcome<3>, others: &Outcome<3>) -> Vec<[[f64; 3]; 2]> {
    let places = outcome.contact.iter().zip(&outcome.displacement);
    let at = |place: &[f64; 3]| {
        let row =
            others.contact.iter().position(|(other, _)| other.iter().zip(place).all(|(a, b)| (a - b).abs() < 1e-12));
        others.displacement[row.unwrap()]
    };
    places.map(|((place, _), u)| [*u, at(place)]).collect()
}

/// Two blocks joined node by node are one mesh: displacements, reactions and the force of contact. The residual is 1e-9 of the forces.
#[test]
fn joined_blocks_are_one_mesh_also_with_contact_beside() {
    let (joined, merged) = (solved_text::<3>("equations", &column(false)), solved_text::<3>("merged", &column(true)));
    let size = merged.steps[0].displacement;
    for [u, v] in there(&joined, &merged) {
        assert!((0..3).all(|k| (u[k] - v[k]).abs() < 1e-7 * size), "{u:?} {v:?}");
    }
    let (joined, merged) = (&joined.steps[0], &merged.steps[0]);
    for k in 0..3 {
        assert!((joined.sets[0].1[k] - merged.sets[0].1[k]).abs() < 1e-6 * merged.largest_force, "{joined:?}");
        assert!((joined.reaction[k] + joined.load[k]).abs() < 1e-6 * merged.largest_force, "{joined:?}");
    }
    let force = |step: &fmc_deck::StepResult| step.pairs[0].force[2].abs();
    assert!((force(joined) - force(merged)).abs() < 1e-6 * force(merged) && force(merged) > 1.0);
}

/// `PIN` and `TIE` join nodes as equations of all axes do, to the bit.
#[test]
fn nodes_of_mpc_go_with_others() {
    let equations = column(false);
    let start = equations.find("*EQUATION").unwrap();
    let end = start + equations[start..].find("\n*NODE").unwrap();
    let terms = |axis: usize| format!("2\nLOWER_HIGH, {axis}, 1., UPPER_LOW, {axis}, -1.\n");
    let of = |name: &str, rows: &str| {
        let text = format!("{}{rows}{}", &equations[..start], &equations[end + 1..]);
        solved_text::<3>(name, &text).displacement
    };
    let expected = of("all-axes", &format!("*EQUATION\n{}{}{}", terms(1), terms(2), terms(3)));
    for kind in ["PIN", "TIE"] {
        assert_eq!(of("mpc", &format!("*MPC\n{kind}, LOWER_HIGH, UPPER_LOW\n")), expected);
    }
}

/// A bar whose ends differ by the displacement of a node that belongs to no element.
fn periodic(step: &str) -> String {
    block("BAR", 1, [1, 1, 3], [[0.0; 3], [2.0, 1.5, 6.0]])
        + "*NODE, NSET=STRETCH\n900, 9., 9., 9.\n"
        + &elastic(&["BAR"], 1000.0, 0.3)
        + "*EQUATION\n3\nBAR_HIGH, 3, 1., BAR_LOW, 3, -1., STRETCH, 3, -1.\n2\nBAR_HIGH, 1, 1., BAR_LOW, 1, -1.\n2\nBAR_HIGH, 2, 1., BAR_LOW, 2, -1.\n"
        + "*BOUNDARY\n1, 1, 3\n2, 2, 3\n3, 3\n"
        + &format!("*STEP\n*STATIC\n{step}\n*NODE PRINT, NSET=STRETCH\nRF\n*END STEP\n")
}

/// Uniform stress E ε, and the force that the node bears, E ε A. Linear elements meet uniform strain: the residual of 1e-9 is left.
#[test]
fn a_periodic_bar_is_stretched_by_a_node_of_no_element() {
    let driven = solved_text::<3>("periodic", &periodic("*BOUNDARY\nSTRETCH, 3, 3, 0.06"));
    let step = &driven.steps[0];
    assert!(
        driven.stresses.iter().all(|s| (s.0[2] - 10.0).abs() < 1e-6 && s.0[0].abs() < 1e-6),
        "{:?}",
        driven.stresses
    );
    assert!((step.sets[0].1[2] - 30.0).abs() < 1e-6 && step.references[0].displacement == [0.0, 0.0, 0.06], "{step:?}");
    let loaded = solved_text::<3>("periodic-load", &periodic("*CLOAD\n900, 3, 30."));
    let step = &loaded.steps[0];
    assert!(loaded.stresses.iter().all(|s| (s.0[2] - 10.0).abs() < 1e-6), "{:?}", loaded.stresses);
    assert!((step.references[0].displacement[2] - 0.06).abs() < 1e-9 && step.references[0].force[2] == 0.0, "{step:?}");
    assert!(fmc_deck::step_table(step).contains("node 900"));
}

/// A lever of equations: chains, a first degree of freedom that is held, and twice the same equation. Forces have the ratio of the motions, by virtual work.
#[test]
fn chains_are_put_into_one_another_and_hand_on_forces() {
    // Corners of a bar: 13 to 16 are its top. 13 goes up by half of 14, 14 as 15, and 16, which is held, as twice 15 would: by -2.
    let text = |equations: &str, held: &str| {
        block("BAR", 1, [1, 1, 3], [[0.0; 3], [2.0, 1.5, 6.0]])
            + &elastic(&["BAR"], 1000.0, 0.3)
            + equations
            + &format!(
                "*BOUNDARY\nBAR_LOW, 1, 3\n*STEP\n*STATIC\n*BOUNDARY\n{held}\n*NODE PRINT, NSET=BAR_LOW\nRF\n*END STEP\n"
            )
    };
    let chain = "*EQUATION\n2\n13, 3, 2., 14, 3, -1.\n2\n14, 3, 1., 15, 3, -1.\n2\n16, 3, 0.5, 15, 3, 1.\n2\n13, 3, 4., 15, 3, -2.\n";
    let solved = solved_text::<3>("chain", &text(chain, "16, 3, 3, -0.02"));
    let up = |label: usize| solved.displacement[label - 1][2];
    for (label, expected) in [(13, 0.005), (14, 0.01), (15, 0.01), (16, -0.02)] {
        assert!((up(label) - expected).abs() < 1e-15, "{label}: {}", up(label));
    }
    let direct =
        solved_text::<3>("direct", &text("", "13, 3, 3, 0.005\n14, 3, 3, 0.01\n15, 3, 3, 0.01\n16, 3, 3, -0.02"));
    let reaction = |label: usize| direct.steps[0].reactions[label - 1][2];
    // Work of a motion of 16 by 1.
    let expected = reaction(16) - 0.25 * reaction(13) - 0.5 * (reaction(14) + reaction(15));
    let found = solved.steps[0].reactions[15][2];
    assert!((found - expected).abs() < 1e-6 * expected.abs(), "{found} {expected}");
    for (u, v) in solved.displacement.iter().zip(&direct.displacement) {
        assert!((0..3).all(|k| (u[k] - v[k]).abs() < 1e-9), "{u:?} {v:?}");
    }
}

/// What cannot hold is refused at its line, with its nodes.
#[test]
fn equations_that_cannot_hold_are_refused() {
    let said = |equations: &str, held: &str| {
        let text = block("BAR", 1, [1, 1, 1], [[0.0; 3], [1.0; 3]])
            + "*NODE\n900, 0., 0., 2.\n901, 0., 0., 3.\n"
            + &elastic(&["BAR"], 1000.0, 0.3)
            + "*EQUATION\n"
            + equations
            + &format!("*BOUNDARY\nBAR_LOW, 1, 3\n*STEP\n*STATIC\n*BOUNDARY\n{held}\n*END STEP\n");
        let said = said_in::<3>(&text, "equation.inp");
        said.split_once(": ").map_or(said.clone(), |(_, rest)| rest.to_owned())
    };
    let both = said("2\n5, 3, 1., 6, 3, -1.\n", "5, 3, 3, 0.1\n6, 3, 3, 0.2");
    assert!(both.contains("its remaining degrees of freedom 3 of node 5, 3 of node 6 are fixed"), "{both}");
    assert_eq!(said("2\n5, 3, 1., 6, 3, -1.\n", "5, 3, 3, 0.1\n6, 3, 3, 0.1"), "nothing");
    let loose = said("3\n5, 3, 1., 900, 3, -1., 901, 3, 1.\n", "6, 3, 3, 0.1");
    assert!(loose.contains("belongs to no element, and the equations leave its degree of freedom 3 free"), "{loose}");
    for (equations, expected) in [
        ("2\n5, 3, 1.\n", "this equation has 2 terms, and 1 are there"),
        ("1\n5, 3, 1., 6, 3, 1.\n", "has 1 terms, and more are there"),
        ("2\n5, 4, 1., 6, 3, 1.\n", "degree of freedom 4 of *EQUATION is not known, only 1 to 3"),
        ("2\n5, 3, 0., 6, 3, 1.\n", "the first factor of an equation is 0"),
        ("2\n5, 3, 1., 6, 3\n", "expected a node or set, a degree of freedom and a factor"),
        ("two\n5, 3, 1., 6, 3\n", "expected the number of terms of an equation, found 'two'"),
        ("2\n5, 3, 1., BAR_LOW, 3, 1.\n", "'BAR_LOW' has 4 nodes, and '5', the first of the equation, has 1"),
        ("2\n5, 3, 1., 902, 3, 1.\n", "there is no node 902"),
    ] {
        let found = said(equations, "6, 3, 3, 0.1");
        assert!(found.contains(expected), "{found} | {expected}");
    }
}
