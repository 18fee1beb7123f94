//! Linear overclosures: each pair has its slope.

use crate::scene::solved_text;

/// Three squares on one another, held along x, with E = 1e6 and ν = 0, pressed by 10. `joints` are their contact pairs.
fn tower(joints: &str) -> String {
    let mut text = "*NODE\n".to_owned();
    for block in 0..3 {
        for (corner, [x, y]) in [[0, 0], [1, 0], [1, 1], [0, 1]].into_iter().enumerate() {
            text += &format!("{}, {x}., {}.\n", 4 * block + corner + 1, block + y);
        }
    }
    for block in 0..3 {
        let n = 4 * block;
        text += &format!(
            "*ELEMENT, TYPE=CPE4, ELSET=B{block}\n{}, {}, {}, {}, {}\n",
            block + 1,
            n + 1,
            n + 2,
            n + 3,
            n + 4
        );
        text += &format!("*SURFACE, NAME=TOP{block}\nB{block}, S3\n*SURFACE, NAME=BOTTOM{block}\nB{block}, S1\n");
    }
    text += "*MATERIAL, NAME=M\n*ELASTIC\n1e6, 0.\n";
    (0..3).for_each(|block| text += &format!("*SOLID SECTION, ELSET=B{block}, MATERIAL=M\n"));
    text += "*NSET, NSET=ALL, GENERATE\n1, 12\n";
    text + joints + "*BOUNDARY\nALL, 1\n1, 2\n2, 2\n*STEP\n*STATIC\n*DLOAD\nB2, P3, 10.\n*END STEP\n"
}

fn linear(name: &str, slope: &str, surfaces: &str) -> String {
    let behavior = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR";
    format!("*SURFACE INTERACTION, NAME={name}\n{behavior}\n{slope}\n*CONTACT PAIR, INTERACTION={name}\n{surfaces}\n")
}

/// Each square is pressed by 1e-5, and each contact is deep by the pressure by its slope.
#[test]
fn every_pair_has_its_slope() {
    let (soft, stiff) = (linear("SOFT", "1e4", "BOTTOM1, TOP0"), linear("STIFF", "4e4", "BOTTOM2, TOP1"));
    for joints in [soft.clone() + &stiff, stiff + &soft] {
        let outcome = solved_text::<2>("slopes", &tower(&joints));
        // Depths are those of the undeformed squares, whose strain is 1e-5: to about twice that part of a penetration of 1e-3.
        let found = outcome.steps[0].displacement;
        assert!((found - 3e-5 - 0.00125).abs() < 1e-7, "{joints}: {found}");
    }
}

/// A tie beside LINEAR: the squares are pressed as before, the contact is deep by the pressure by its slope, and the tie opens by nothing.
#[test]
fn a_tie_stands_beside_a_slope() {
    let joints = linear("SOFT", "1e4", "BOTTOM2, TOP1") + "*TIE, NAME=T\nBOTTOM1, TOP0\n";
    let outcome = solved_text::<2>("slope-and-tie", &tower(&joints));
    // As above; the tie adds 1e-11.
    let found = outcome.steps[0].displacement;
    assert!((found - 3e-5 - 0.001).abs() < 1e-7, "{found}");
    let across = outcome.displacement[4][1] - outcome.displacement[3][1];
    assert!(across.abs() < 1e-9, "{across}");
    assert_eq!(outcome.steps[0].ties.len(), 1);
}
