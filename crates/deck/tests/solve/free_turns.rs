//! Reference nodes whose rotations are free.

use crate::blocks_text::{block, elastic};
use crate::scene::{said_in, solved_text};

/// A column with a rigid plate as its top, and a punch beside its reference node, which tilts it.
pub(crate) fn plate(step: &str) -> String {
    block("BASE", 1, [2, 2, 2], [[0.0; 3], [2.0, 1.5, 3.0]])
        + &block("PLATE", 101, [2, 2, 1], [[-0.2, 0.1, 3.01], [1.7, 1.6, 3.4]])
        + "*NODE, NSET=REF\n900, 2., -1., 4.\n"
        + &elastic(&["BASE", "PLATE"], 1000.0, 0.3)
        + "*RIGID BODY, ELSET=PLATE, REF NODE=900\n"
        + "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n2e3\n*CONTACT PAIR, INTERACTION=I\nS_PLATE_LOW, S_BASE_HIGH\n"
        + &format!("*BOUNDARY\nBASE_LOW, 1, 3\n*STEP\n*STATIC\n{step}\n*NODE PRINT, NSET=BASE_LOW\nRF\n*END STEP\n")
}

/// A plate that tilts under forces and moments bears them where it is driven to the place that it found: the inverse problem. Contact carries all of it.
#[test]
fn a_plate_that_tilts_bears_its_loads_where_it_rests() {
    // The resultant goes through the plate, at x = 0.95 and y = 0.8.
    let free = "*BOUNDARY\n900, 1, 2\n900, 6, 6, 0.001\n*CLOAD\n900, 3, -20.\n900, 4, -36.\n900, 5, -21.";
    let loaded = solved_text::<3>("tilting", &plate(free));
    let reference = &loaded.steps[0].references[0];
    let ([_, _, down], [x, y, z]) = (reference.displacement, reference.rotation);
    assert!(down < -0.01 && x.abs() > 1e-4 && y.abs() > 1e-4 && (z - 0.001).abs() < 1e-15, "{reference:?}");
    // Free components bear nothing but the residual.
    assert!(reference.force[2].abs() < 1e-6 && reference.moment[..2].iter().all(|m| m.abs() < 1e-6), "{reference:?}");
    assert!((loaded.steps[0].sets[0].1[2] - 20.0).abs() < 1e-6);
    // All of its nodes move by the rotation.
    for ((place, _), u) in loaded.contact.iter().zip(&loaded.displacement).skip(27) {
        let [a, b, c] = [place[0] - 2.0, place[1] + 1.0, place[2] - 4.0];
        let moved = [y * c - z * b, z * a - x * c, down + x * b - y * a];
        assert!((0..3).all(|k| (u[k] - moved[k]).abs() < 1e-12), "{u:?} {moved:?}");
    }
    let driven =
        format!("*BOUNDARY\n900, 1, 2\n900, 3, 3, {down:?}\n900, 4, 4, {x:?}\n900, 5, 5, {y:?}\n900, 6, 6, {z:?}");
    let driven = solved_text::<3>("tilted", &plate(&driven));
    let other = &driven.steps[0].references[0];
    let found = [other.force[2] + 20.0, other.moment[0] + 36.0, other.moment[1] + 21.0];
    assert!(found.iter().all(|off| off.abs() < 1e-4), "{other:?}");
    for k in 0..2 {
        assert!((other.force[k] - reference.force[k]).abs() < 1e-4, "{other:?} {reference:?}");
    }
    assert!((other.moment[2] - reference.moment[2]).abs() < 1e-4, "{other:?} {reference:?}");
}

/// A bar with a rigid end under a moment bends to a circle: φ = M L / E I, and the free rotation is told. Quadratic elements meet pure bending: 1e-6 is what
/// the residual leaves of it.
#[test]
fn a_moment_on_a_free_end_bends_a_bar() {
    let text = "*NODE\n1, 0., 0.\n2, 4., 0.\n3, 8., 0.\n4, 0., 1.\n5, 4., 1.\n6, 8., 1.\n7, 2., 0.\n8, 6., 0.\n9, 0., 0.5\n10, 4., 0.5\n11, 8., 0.5\n12, 2., 1.\n13, 6., 1.\n99, 8., 0.5\n\
                *ELEMENT, TYPE=CPS8, ELSET=BAR\n1, 1, 2, 5, 4, 7, 10, 12, 9\n2, 2, 3, 6, 5, 8, 11, 13, 10\n*NSET, NSET=END\n3, 6, 11\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*SOLID SECTION, ELSET=BAR, MATERIAL=M\n2.\n\
                *RIGID BODY, NSET=END, REF NODE=99\n*BOUNDARY\n1, 1, 2\n4, 1\n9, 1\n*STEP\n*STATIC\n*CLOAD\n99, 6, 0.25\n*END STEP\n";
    let solved = solved_text::<2>("bent", text);
    let reference = &solved.steps[0].references[0];
    let turn = 0.25 * 8.0 / (1000.0 * 2.0 / 12.0);
    assert!((reference.rotation[2] - turn).abs() < 1e-6 * turn, "{reference:?} {turn}");
    assert!(reference.moment[2].abs() < 1e-8 && reference.force.iter().all(|f| f.abs() < 1e-8), "{reference:?}");
}

/// A moment about a held place is no force: the row of loads has what the file names, and what is held bears the rest.
#[test]
fn moments_about_held_places_are_no_forces() {
    let text = block("BASE", 1, [1, 1, 1], [[0.0; 3], [1.0; 3]])
        + "*NODE\n900, 0.5, -1., 1.5\n"
        + &elastic(&["BASE"], 1000.0, 0.3)
        + "*RIGID BODY, NSET=BASE_HIGH, REF NODE=900\n*BOUNDARY\nBASE_LOW, 1, 3\n900, 1, 3\n900, 5, 6\n*STEP\n*STATIC\n\
           *CLOAD\n900, 4, 2.\n900, 3, 5.\n*END STEP\n";
    let step = solved_text::<3>("held-moment", &text).steps.remove(0);
    assert_eq!(step.load, [0.0, 0.0, 5.0]);
    // The residual is 1e-9 of forces of some units.
    assert!((0..3).all(|k| (step.load[k] + step.reaction[k]).abs() < 1e-7), "{:?} {:?}", step.load, step.reaction);
}

#[test]
fn rotations_that_no_node_feels_are_refused() {
    let text = |nodes: &str, head: &str| {
        block("BASE", 1, [1, 1, 1], [[0.0; 3], [1.0; 3]])
            + "*NODE\n900, 0.5, 0., 2.\n"
            + &elastic(&["BASE"], 1000.0, 0.3)
            + &format!(
                "*RIGID BODY, NSET={nodes}, REF NODE=900\n*BOUNDARY\nBASE_LOW, 1, 3\n*STEP{head}\n*STATIC\n*CLOAD\n900, 4, 1.\n*END STEP\n"
            )
    };
    let line = text("EDGE", "").replace("*NODE\n900", "*NSET, NSET=EDGE\n5, 6\n*NODE\n900");
    let said = said_in::<3>(&line, "line.inp");
    assert!(said.contains("of node 900, of *RIGID BODY") && said.contains("is free, and no node feels it"), "{said}");
    let said = said_in::<3>(&text("BASE_HIGH", ", NLGEOM"), "finite.inp");
    assert!(
        said.contains("with NLGEOM, degree of freedom 4 of node 900") && said.contains("is free in this step"),
        "{said}"
    );
    assert_eq!(said_in::<3>(&text("BASE_HIGH", ""), "free.inp"), "nothing");
}
