//! Rigid surfaces of elements, which have no inside.

use crate::blocks_text::{block, elastic};
use crate::rings::{MATERIAL, graded};
use crate::scene::{Outcome, said, said_in, solved_text};
use fmc_deck::{Analysis, Deck, SolveOptions, StepResult, frd_start, frd_step, vtu};
use fmc_solid::statics::Equilibrium;
use std::f64::consts::PI;
use std::fmt::Write;
use std::ops::ControlFlow;

const LINEAR: &str = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n2e4\n";

/// A plate wider than the base, in a gap of 0.01 above it, and a punch that covers a part of its face.
const PLATE: [[f64; 3]; 2] = [[-1.0, -1.0, 1.01], [4.0, 3.0, 2.0]];
const PUNCH: [[f64; 3]; 2] = [[0.2, 0.1, 1.01], [1.5, 1.2, 1.51]];

/// A block held below and a tool with the reference node 900, in one step with this head.
fn pressed(tool: &str, head: &str, driven: &str) -> String {
    block("BASE", 1, [3, 2, 2], [[0.0; 3], [3.0, 2.0, 1.0]])
        + "*NODE, NSET=REF\n900, 2., -1., 3.\n*AMPLITUDE, NAME=RISE\n0., 0., 1., 0.5\n"
        + &elastic(&["BASE"], 1000.0, 0.3)
        + tool
        + &format!(
            "*SURFACE INTERACTION, NAME=I\n{LINEAR}*CONTACT PAIR, INTERACTION=I\nS_TOOL, S_BASE_HIGH\n*BOUNDARY\nBASE_LOW, 1, 3\n"
        )
        + &format!("*STEP{head}\n*STATIC\n{driven}\n*NODE PRINT, NSET=BASE_LOW\nRF\n*END STEP\n")
}

const BODY: &str = "*RIGID BODY, ELSET=TOOL, REF NODE=REF\n";

fn solid([low, high]: [[f64; 3]; 2]) -> String {
    let cell = block("TOOL", 101, [1, 1, 1], [low, high]);
    format!("{cell}*SOLID SECTION, ELSET=TOOL, MATERIAL=M\n*SURFACE, NAME=S_TOOL\nTOOL, S1\n{BODY}")
}

/// The first `count` faces of the same box, the lowest first; outwards is the side that is named.
fn shell([low, high]: [[f64; 3]; 2], count: usize, side: &str) -> String {
    let mut text = "*NODE\n".to_owned();
    for k in 0..8usize {
        let x = |axis: usize| if k >> axis & 1 == 0 { low[axis] } else { high[axis] };
        writeln!(text, "{}, {}, {}, {}", 101 + k, x(0), x(1), x(2)).unwrap();
    }
    text += "*ELEMENT, TYPE=R3D4, ELSET=TOOL\n";
    let faces = [[0, 2, 3, 1], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6], [4, 5, 7, 6]];
    for (k, face) in faces.iter().take(count).enumerate() {
        let mut nodes: Vec<String> = face.iter().map(|node| (101 + node).to_string()).collect();
        if side == "SNEG" {
            nodes.reverse();
        }
        writeln!(text, "{}, {}", 101 + k, nodes.join(", ")).unwrap();
    }
    format!("{text}*SURFACE, NAME=S_TOOL\nTOOL, {side}\n{BODY}")
}

fn step(name: &str, text: &str) -> StepResult {
    let solved: Outcome<3> = solved_text(name, text);
    solved.steps.into_iter().next().unwrap()
}

/// Largest difference of force, moment and motion of the reference node, and of what holds the base, by the force.
fn off(one: &StepResult, other: &StepResult) -> f64 {
    let numbers = |step: &StepResult| {
        let reference = &step.references[0];
        [reference.force, reference.moment, reference.displacement, step.sets[0].1].concat()
    };
    let scale = other.sets[0].1[2].abs();
    numbers(one).iter().zip(numbers(other)).map(|(p, q)| (p - q).abs() / scale).fold(0.0, f64::max)
}

const WAYS: [&str; 3] = [
    "*BOUNDARY\nREF, 3, 3, -0.05\nREF, 1, 2\nREF, 4, 6",
    "*BOUNDARY\nREF, 1, 2\nREF, 4, 6\n*CLOAD\nREF, 3, -50.",
    "*BOUNDARY, AMPLITUDE=RISE\nREF, 3, 3, -0.1\nREF, 4, 4, 0.02\n*BOUNDARY\nREF, 1, 2\nREF, 5, 6",
];

/// Where only its face touches, a rigid face is a rigid solid: driven, under a force, tilted along an amplitude, by either side. Up to rounding and the residual of
/// 1e-9 of the forces.
#[test]
fn a_rigid_face_presses_as_a_solid() {
    for (way, head) in WAYS.iter().flat_map(|way| [(way, ""), (way, ", NLGEOM")]) {
        let of = |tool: &str| step("rigid-face", &pressed(tool, head, way));
        let solid = of(&solid(PLATE));
        for (count, side) in [(1, "SPOS"), (1, "SNEG"), (6, "SPOS")] {
            let found = of(&shell(PLATE, count, side));
            assert!(off(&found, &solid) < 5e-9, "{count} {side} {way} {head}: {:e}", off(&found, &solid));
        }
        assert!(solid.references[0].moment[0].abs() > 10.0 && solid.sets[0].1[2] > 40.0, "{solid:?}");
    }
}

/// With edges in the contact, depths at these depend on what lies behind a face, up to the penetration of 2e-2 of a cell: a part of 1e-3 of the force for the face
/// alone, 5e-3 for the box, whose layer is thin at its edges. A closed surface needs no side, and general contact no surface.
#[test]
fn a_rigid_punch_presses_as_a_solid() {
    let solid = step("rigid-punch", &pressed(&solid(PUNCH), "", WAYS[0]));
    for (count, side, bound) in [(1, "SNEG", 1e-3), (6, "SPOS", 5e-3)] {
        let found = step("rigid-punch", &pressed(&shell(PUNCH, count, side), "", WAYS[0]));
        let off = (found.sets[0].1[2] / solid.sets[0].1[2] - 1.0).abs();
        assert!(off < bound, "{count}: {off:e}");
    }
    let pair = pressed(&shell(PUNCH, 6, "SPOS"), "", WAYS[0]);
    let general = pair.replace("*SURFACE, NAME=S_TOOL\nTOOL, SPOS\n", "").replace(
        "*CONTACT PAIR, INTERACTION=I\nS_TOOL, S_BASE_HIGH\n",
        "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n",
    );
    assert!(off(&step("rigid-punch", &general), &step("rigid-punch", &pair)) < 5e-9);
}

/// A block between planes of symmetry, under a plate that goes on beyond these, as under one that ends there: without the planes the pressure would fall
/// towards them.
#[test]
fn a_rigid_plate_may_go_on_beyond_planes_of_symmetry() {
    let of = |name: &str, tool: &str| {
        let text = pressed(tool, "", WAYS[0]);
        step(name, &text.replacen("*STEP\n", "*BOUNDARY\nBASE_NODES, 1, 2\n*STEP\n", 1))
    };
    let ends_there = of("rigid-trimmed", &solid([[0.0, 0.0, 1.01], [3.0, 2.0, 2.0]]));
    let goes_on = of("rigid-beyond", &shell(PLATE, 1, "SPOS"));
    assert!(off(&goes_on, &ends_there) < 5e-9, "{goes_on:?} {ends_there:?}");
}

/// Rigid lines along the lower side of a circle of radius 1 from its lowest point, four to a degree, of 30 degrees.
pub(crate) fn arc() -> String {
    let mut text = "*NODE\n".to_owned();
    let at = |k: usize| (k as f64 / 4.0).to_radians();
    (0..=120).for_each(|k| writeln!(text, "{}, {:.12}, {:.12}", 9001 + k, at(k).sin(), 1.0 - at(k).cos()).unwrap());
    writeln!(text, "*ELEMENT, TYPE=RAX2, ELSET=TOOL").unwrap();
    (0..120).for_each(|k| writeln!(text, "{}, {}, {}", 9001 + k, 9001 + k, 9002 + k).unwrap());
    text + "*SURFACE, NAME=S_TOOL\nTOOL, SNEG\n*RIGID BODY, ELSET=TOOL, REF NODE=9900\n"
}

/// A base of revolution under a rigid ball.
pub(crate) fn ball(tool: &str) -> String {
    format!("{}{MATERIAL}*NODE\n9900, 0., 2.\n{tool}", graded("BASE", 1, -0.6, &|_| 0.0))
        + "*SOLID SECTION, ELSET=BASE, MATERIAL=M\n*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nS_BASE, S_TOOL\n\
           *BOUNDARY\nBASE_AXIS, 1\nBASE_FAR, 2\n9900, 1\n9900, 6\n*STEP\n*STATIC\n*BOUNDARY\n9900, 2, 2, -0.0036\n\
           *NODE PRINT, NSET=BASE_FAR\nRF\n*END STEP\n"
}

/// Hertz: a³ = 3 F R/4 E* and p₀ = 3 F/2πa², with E* = E/(1 − ν²) of the base. The radius of 0.06 is 15 edges of the base and 14 of the ball: some percent in all.
pub(crate) fn check_hertz(solved: &Outcome<2>) {
    let (step, modulus) = (&solved.steps[0], 1000.0 / 0.91);
    let force = step.sets[0].1[1];
    let radius = (0.75 * force / modulus).cbrt();
    let peak = 1.5 * force / (PI * radius * radius);
    let found = solved.pressures.iter().map(|at| at.pressure).fold(0.0, f64::max);
    let area = step.pairs[0].area;
    assert!(((area / PI).sqrt() / radius - 1.0).abs() < 0.03, "{area} {radius}");
    assert!((found / peak - 1.0).abs() < 0.04, "{found} {peak}");
    assert!((step.references[0].force[1] / force + 1.0).abs() < 1e-9, "{step:?}");
}

#[test]
fn a_rigid_ball_presses_as_hertz_has_it() {
    let solved = solved_text("rigid-ball", &ball(&arc()));
    check_hertz(&solved);
    assert_eq!(solved.steps[0].pairs[0].names, ["BASE", "TOOL"]);
}

/// Files of results have the layer: nodes behind the face have labels after the last, here 901 to 904, and the cell that of its element.
#[test]
fn results_have_the_layer() {
    let file = std::env::temp_dir().join(format!("fmc-deck-layer-{}.inp", std::process::id()));
    std::fs::write(&file, pressed(&shell(PLATE, 1, "SPOS"), "", WAYS[0])).unwrap();
    let deck = Deck::read(&file).unwrap();
    std::fs::remove_file(file).unwrap();
    let analysis = Analysis::<3>::new(&deck, SolveOptions::default()).unwrap();
    let told = |words: &str| analysis.notes.iter().any(|note| note.message.contains(words));
    assert!(told("rigid faces are the front of a layer of cells, 1.601e0 to 1.601e0 thick"), "{:?}", analysis.notes);
    let order = analysis.order.clone();
    let mut written = Vec::new();
    let reached = &mut |at: &Equilibrium<3>, step: StepResult| {
        let text = frd_start(&deck, &order, at.model()) + &frd_step(&deck, &order, at, &step);
        written.push((text, vtu(&deck, &order, at, &step).cell_count()));
        Ok(())
    };
    analysis.solve(&mut |_, _| ControlFlow::Continue(()), reached).unwrap();
    let (frd, cells) = &written[0];
    assert!(frd.contains("\n -1       101    1    0    2\n -2       901       902       903       904       101       103       104       102\n"), "{frd}");
    // The block, the layer, and the reference node.
    assert_eq!(*cells, 12 + 1 + 1);
}

#[test]
fn what_rigid_surfaces_cannot_be_is_refused_by_its_line() {
    let good = pressed(&shell(PUNCH, 6, "SPOS"), "", WAYS[0]);
    assert_eq!(said_in::<3>(&good, "good.inp"), "nothing");
    let row = "TOOL, SPOS\n";
    for (from, to, expected) in [
        (row, "TOOL, S1\n", "element 101 of type R3D4 presses with one side, SPOS or SNEG, and the surface names S1"),
        (row, "TOOL\n", "and the surface names none"),
        (row, "TOOL, SPOS\n101, SNEG\n", "element 101 of type R3D4 has its other side in line"),
        (row, "101, SPOS\n102, SNEG\n", "and element 102 look to opposite sides"),
        (BODY, "*RIGID BODY, NSET=REF, REF NODE=REF\n", "element 101 of type R3D4 is in no ELSET of a *RIGID BODY"),
        (row, "TOOL, SPOS\n*ELSET, ELSET=TOOL\n1\n", "element 101 of type R3D4 and the solid 1 are in one set"),
        ("103, 102, 104, 108, 106", "103, 102, 104, 108, 1", "element 103 of type R3D4 has node 1 of a solid"),
        ("103, 102, 104, 108, 106", "103, 102, 104, 108, 4711", "element 103 names node 4711, which does not exist"),
        ("103, 102, 104, 108, 106", "103, 102, 104, 108", "element 103 has 3 nodes; R3D4 has 4"),
        ("103, 102, 104, 108, 106", "103, 102, 104, 108, 106\n203, 102, 104, 106, 108", "meet at one edge"),
        ("103, 102, 104, 108, 106", "102, 102, 104, 108, 106", "element 102 is there twice"),
        ("101, 101, 103, 104, 102", "101, 101, 103, 103, 102", "element 101 of type R3D4"),
        ("TYPE=R3D4", "TYPE=R2D2", "element 101 has 4 nodes; R2D2 has 2"),
        (
            "*STATIC\n",
            "*STATIC\n*DLOAD\nTOOL, P1, 1.\n",
            "element 101 of type R3D4 is rigid: put a force on its reference node",
        ),
    ] {
        assert!(good.contains(from), "{from}");
        let message = said_in::<3>(&good.replacen(from, to, 1), "rigid-surface.inp");
        let line = message.strip_prefix("rigid-surface.inp:").and_then(|rest| rest.split(':').next()?.parse().ok());
        assert!(line.is_some_and(|line: usize| line > 1) && message.contains(expected), "{to}: {message}");
    }
    // The other side of a plate, in a gap and without one.
    for plate in [PLATE, [[-1.0, -1.0, 1.0], [4.0, 3.0, 2.0]]] {
        let away = pressed(&shell(plate, 1, "SPOS"), "", WAYS[0]);
        assert_eq!(said_in::<3>(&away, "looks.inp"), "nothing");
        let message = said_in::<3>(&away.replace("TOOL, SPOS", "TOOL, SNEG"), "away.inp");
        assert!(message.contains("all of S_BASE_HIGH lies behind S_TOOL: name the other side"), "{message}");
    }
    // The other side of a plate, in a gap and without one.
    for plate in [PLATE, [[-1.0, -1.0, 1.0], [4.0, 3.0, 2.0]]] {
        let away = pressed(&shell(plate, 1, "SPOS"), "", WAYS[0]);
        assert_eq!(said_in::<3>(&away, "looks.inp"), "nothing");
        let message = said_in::<3>(&away.replace("TOOL, SPOS", "TOOL, SNEG"), "away.inp");
        assert!(message.contains("all of S_BASE_HIGH lies behind S_TOOL: name the other side"), "{message}");
    }
    let open = pressed(&shell(PUNCH, 5, "SPOS"), "", WAYS[0]).replace("*SURFACE, NAME=S_TOOL\nTOOL, SPOS\n", "");
    let open = open.replace(
        "*CONTACT PAIR, INTERACTION=I\nS_TOOL, S_BASE_HIGH\n",
        "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n",
    );
    let message = said_in::<3>(&open, "open.inp");
    assert!(message.contains("element 101 of type R3D4 has no side that presses"), "{message}");
    let plane = said(&ball(&arc()).replace("RAX2", "R2D2"), "plane.inp");
    assert!(plane.contains("elements of type R2D2 together with CAX4: axisymmetric and plane bodies"), "{plane}");
}
