//! Element types: wedges, bodies of two types, plates.

use crate::blocks_text::{block, block_with_wedges, elastic};
use crate::scene::{Outcome, largest_off, path, said, said_in, solved_text};

/// Two blocks pressed on each other, the lower with so many columns of wedges.
fn pressed(wedges: usize) -> Outcome<3> {
    let text = block_with_wedges("LOW", 1, [3, 2, 2], [[0.0; 3], [3.0, 2.0, 1.0]], wedges)
        + &block("TOP", 101, [2, 2, 1], [[0.5, 0.5, 1.0], [2.5, 1.5, 2.0]])
        + &elastic(&["LOW", "TOP"], 1000.0, 0.3)
        + "*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nS_TOP_LOW, S_LOW_HIGH\n"
        + "*BOUNDARY\nLOW_LOW, 1, 3\nTOP_HIGH, 1, 2\nTOP_HIGH, 3, 3, -0.02\n"
        + "*STEP\n*STATIC\n*END STEP\n";
    solved_text::<3>("wedges", &text)
}

/// A pull through hexahedra and wedges of one body: uniform stress, to the residual, and as long as Hooke has it.
#[test]
fn a_pull_goes_through_cells_of_two_types() {
    for wedges in [1, 3] {
        let text = block_with_wedges("BAR", 1, [3, 2, 2], [[0.0; 3], [3.0, 2.0, 1.0]], wedges)
            + &elastic(&["BAR"], 1000.0, 0.3)
            + "*BOUNDARY\nBAR_LOW, 3\n1, 1, 2\n4, 2\n*STEP\n*STATIC\n*DSLOAD\nS_BAR_HIGH, P, -10.\n*END STEP\n";
        let outcome = solved_text::<3>("pulled-wedges", &text);
        assert_eq!(outcome.stresses.len(), 4 * (3 - wedges) + 8 * wedges);
        let off = largest_off(&outcome.stresses, [0.0, 0.0, 10.0, 0.0, 0.0, 0.0]);
        assert!(off < 1e-8, "{wedges}: {off:.2e}");
        let up = outcome.displacement.iter().map(|u| u[2]).fold(0.0, f64::max);
        assert!((up - 0.01).abs() < 1e-12, "{up}");
    }
}

/// Wedges in contact beside hexahedra: the force is that of hexahedra alone but for what triangles are stiffer by in so coarse a mesh.
#[test]
fn wedges_press_as_hexahedra_do() {
    let force = |outcome: &Outcome<3>| outcome.steps[0].pairs[0].force[2];
    let [hexahedra, mixed, wedges] = [0, 1, 3].map(|columns| force(&pressed(columns)));
    println!("{hexahedra} {mixed} {wedges}");
    assert!(hexahedra > 1.0 && (mixed / hexahedra - 1.0).abs() < 0.05 && (wedges / hexahedra - 1.0).abs() < 0.1);
}

/// Two plates under a pressure p in plane stress: σ_yy = −p and nothing else, and down by 2 p/E: plane strain has 0.91 of it. Bounds as in `blocks`.
#[test]
fn plates_press_in_plane_stress() {
    let text = std::fs::read_to_string(path("patch.inp")).unwrap().replace("CPE4", "CPS4");
    let outcome = solved_text::<2>("plates", &text);
    assert!(largest_off(&outcome.stresses, [0.0, -10.0, 0.0, 0.0, 0.0, 0.0]) < 5e-3);
    assert!(outcome.stresses.iter().all(|stress| stress.0[2] == 0.0));
    let down = outcome.displacement.iter().map(|u| u[1]).fold(0.0, f64::min);
    assert!((down + 0.02).abs() < 1e-4, "{down}");
}

/// A bar of the plane of thickness 0.5, pulled by a force of 3 at a reference node: the stress is that force by 0.5, and what holds it is the force. A pressure is
/// one, whatever the thickness. Bounds by the residual.
#[test]
fn thin_plates_share_a_force() {
    let good = "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n9, 2., 0.25\n*ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n*SURFACE, NAME=R\nE, S2\n\
                *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*SOLID SECTION, ELSET=E, MATERIAL=M\n0.5\n\
                *COUPLING, CONSTRAINT NAME=C, REF NODE=9, SURFACE=R\n*KINEMATIC\n*BOUNDARY\n1, 1\n4, 1\n9, 2\n9, 6\n*STEP\n*STATIC\n\
                *CLOAD\n9, 1, 3.\n*END STEP\n*STEP\n*STATIC\n*CLOAD, OP=NEW\n*DSLOAD\nR, P, -8.\n*END STEP\n";
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-9, "{found}, not {expected}");
    let outcome = solved_text::<2>("thin", good);
    let [force, pressure] = &outcome.steps[..] else { panic!("two steps") };
    near(force.displacement, 3.0 / 0.5 / 1000.0);
    near(force.reaction[0], -3.0);
    near(force.load[0], 3.0);
    // The force of 3 at y = 0.25 is borne at y = 0.5.
    near(force.references[0].moment[2], -0.75);
    near(pressure.displacement, 8.0 / 1000.0);
    near(pressure.reaction[0], -8.0 * 0.5);
    assert!(largest_off(&outcome.stresses, [8.0, 0.0, 0.0, 0.0, 0.0, 0.0]) < 1e-9);
    let two = good.replace("*COUPLING", "*SOLID SECTION, ELSET=E, MATERIAL=M\n0.25\n*COUPLING");
    assert!(said(&two, "two.inp").contains("all bodies must have one thickness"), "{}", said(&two, "two.inp"));
    assert!(said(&good.replace("\n0.5\n", "\n-0.5\n"), "below.inp").contains("a thickness above 0"));
    let solid = block("BAR", 1, [1, 1, 1], [[0.0; 3], [1.0; 3]])
        + &elastic(&["BAR"], 1.0, 0.0)
        + "0.5\n*STEP\n*STATIC\n*END STEP\n";
    assert!(
        said_in::<3>(&solid, "solid.inp").contains("solids have no thickness"),
        "{}",
        said_in::<3>(&solid, "solid.inp")
    );
}

#[test]
fn what_plates_and_wedges_cannot_be_is_refused() {
    let good = std::fs::read_to_string(path("patch.inp")).unwrap();
    let plates = good.replace("CPE4", "CPS4");
    assert_eq!(said(&plates, "plates.inp"), "nothing");
    let message = said(&plates.replace("*STEP", "*STEP, NLGEOM"), "large.inp");
    assert!(message.contains("has plane stress, which is known for *ELASTIC without NLGEOM"), "{message}");
    let message = said(&plates.replace("*ELASTIC\n1000., 0.3", "*HYPERELASTIC, NEO HOOKE\n100., 1e-3"), "rubber.inp");
    assert!(message.contains("has plane stress, which is known for *ELASTIC"), "{message}");
    // The first element of a body alone.
    let square = "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n5, 2., 0.\n6, 2., 1.\n*ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n\
                  *ELEMENT, TYPE=CPE4, ELSET=E\n2, 2, 5, 6, 3\n*MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n\
                  *SOLID SECTION, ELSET=E, MATERIAL=M\n*STEP\n*STATIC\n*END STEP\n";
    let message = said(square, "both.inp");
    assert!(message.contains("elements of plane strain together with elements of plane stress"), "{message}");
    let wedges = block_with_wedges("BAR", 1, [1, 1, 1], [[0.0; 3], [1.0; 3]], 1) + &elastic(&["BAR"], 1.0, 0.0);
    let loaded = |face: &str| format!("{wedges}*STEP\n*STATIC\n*DLOAD\nBAR, {face}, 1.\n*END STEP\n");
    assert_eq!(said_in::<3>(&loaded("P2"), "wedge.inp"), "nothing");
    let message = said_in::<3>(&loaded("P6"), "wedge.inp");
    assert!(message.contains("of type C3D6 has no face P6; its faces are P1 to P5"), "{message}");
    // Surfaces without an inside.
    for (rows, expected) in [
        (
            "*ELEMENT, TYPE=R3D4, ELSET=R\n9001, 1, 2, 4, 3\n",
            "element 9001 of type R3D4 is in no ELSET of a *RIGID BODY, which moves it",
        ),
        ("*ELEMENT, TYPE=R2D2, ELSET=R\n9001, 1, 2\n", "elements of type R2D2 together with 3D elements"),
    ] {
        let message = said_in::<3>(&format!("{}{rows}", loaded("P2")), "surface.inp");
        assert!(message.contains(expected), "{message}");
    }
}
