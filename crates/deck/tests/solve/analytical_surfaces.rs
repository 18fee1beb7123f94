//! Analytical rigid surfaces.

use crate::rigid_surfaces::{arc, ball, check_hertz};
use crate::scene::{Outcome, said, said_in, solved_text};
use std::f64::consts::PI;
use std::fmt::Write;

const MATERIAL: &str = "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SOLID SECTION, ELSET=BASE, MATERIAL=M\n";
const BODY: &str = "*RIGID BODY, ANALYTICAL SURFACE=S_TOOL, REF NODE=9900\n";
const ARC: &str = "*SURFACE, TYPE=SEGMENTS, NAME=S_TOOL\nSTART, 0.5, 0.1339745962155613\nCIRCL, 0., 0., 0., 1.\n";

/// A ball of revolution by its profile: Hertz, and within 0.5 % the ball of lines of a quarter of a degree, which are chords.
#[test]
fn a_profile_of_a_ball_presses_as_hertz_has_it() {
    let profile = solved_text("profile", &ball(&format!("{ARC}{BODY}")));
    check_hertz(&profile);
    let lines = solved_text::<2>("profile-lines", &ball(&arc()));
    let of = |solved: &Outcome<2>| solved.steps[0].sets[0].1[1];
    assert!((of(&profile) / of(&lines) - 1.0).abs() < 5e-3, "{} {}", of(&profile), of(&lines));
}

/// A block of `C3D8` with these coordinates along each axis: its node and element sets `BASE_NODES`, `BASE`, the surface `S_BASE` above, and sets of the nodes at its
/// ends `X0`, `X1`, `Y0`, …
fn base([x, y, z]: [&[f64]; 3]) -> String {
    let node = |i: usize, j: usize, k: usize| 1 + i + x.len() * (j + y.len() * k);
    let mut text = "*NODE, NSET=BASE_NODES\n".to_owned();
    let mut ends: Vec<Vec<String>> = vec![Vec::new(); 6];
    for (k, j, i) in triples([z.len(), y.len(), x.len()]) {
        writeln!(text, "{}, {:?}, {:?}, {:?}", node(i, j, k), x[i], y[j], z[k]).unwrap();
        for (axis, (at, count)) in [(i, x.len()), (j, y.len()), (k, z.len())].into_iter().enumerate() {
            (0..2)
                .filter(|end| at == end * (count - 1))
                .for_each(|end| ends[2 * axis + end].push(node(i, j, k).to_string()));
        }
    }
    text += "*ELEMENT, TYPE=C3D8, ELSET=BASE\n";
    let mut top = String::new();
    for (label, (k, j, i)) in (1..).zip(triples([z.len() - 1, y.len() - 1, x.len() - 1])) {
        let ring = |k| [node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)];
        let nodes: Vec<String> = [ring(k), ring(k + 1)].concat().iter().map(ToString::to_string).collect();
        writeln!(text, "{label}, {}", nodes.join(", ")).unwrap();
        if k + 2 == z.len() {
            writeln!(top, "{label}, S2").unwrap();
        }
    }
    for (name, nodes) in ["X0", "X1", "Y0", "Y1", "Z0", "Z1"].into_iter().zip(ends) {
        writeln!(text, "*NSET, NSET={name}\n{}", nodes.join("\n")).unwrap();
    }
    text + &format!("*SURFACE, NAME=S_BASE\n{top}*NODE, NSET=REF\n9900, 0., 0., 2.\n{MATERIAL}")
}

fn triples([a, b, c]: [usize; 3]) -> impl Iterator<Item = (usize, usize, usize)> {
    (0..a).flat_map(move |i| (0..b).flat_map(move |j| (0..c).map(move |k| (i, j, k))))
}

const PAIR: &str = "*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nS_BASE, S_TOOL\n";

/// Coordinates from 0: even ones, then growing.
fn graded(edge: f64, even: usize, growing: usize) -> Vec<f64> {
    let grown = (1..=growing).scan((edge * even as f64, edge), |(at, edge), _| {
        *edge *= 1.5;
        *at += *edge;
        Some(*at)
    });
    (0..=even).map(|k| k as f64 * edge).chain(grown.collect::<Vec<_>>()).collect()
}

/// A quarter of a base under a ball whose profile turns about z: Hertz, with five edges in the radius of 0.15, which is a quarter of the base: within 6 %.
#[test]
fn a_surface_of_revolution_presses_as_hertz_has_it() {
    let across = graded(0.03, 6, 4);
    let down: Vec<f64> = across.iter().rev().map(|x| -x).collect();
    let tool =
        "*SURFACE, TYPE=REVOLUTION, NAME=S_TOOL\n0., 0., 1., 0., 0., 3.\nSTART, 0.8, -0.6\nCIRCL, 0., -1., 0., 0.\n";
    let text = base([&across, &across, &down])
        + &format!(
            "{tool}{BODY}{PAIR}*BOUNDARY\nX0, 1\nY0, 2\nZ0, 3\n9900, 1, 2\n9900, 4, 6\n*STEP\n*STATIC\n*BOUNDARY\n9900, 3, 3, -0.0225\n*NODE PRINT, NSET=Z0\nRF\n*END STEP\n"
        );
    let solved: Outcome<3> = solved_text("revolution", &text);
    let (step, modulus) = (&solved.steps[0], 1000.0 / 0.91);
    let force = 4.0 * step.sets[0].1[2];
    let radius = (0.75 * force / modulus).cbrt();
    let peak = 1.5 * force / (PI * radius * radius);
    let found = solved.pressures.iter().map(|at| at.pressure).fold(0.0, f64::max);
    let area = (4.0 * step.pairs[0].area / PI).sqrt();
    println!("a {radius} {area} p {peak} {found}");
    assert!(
        (area / radius - 1.0).abs() < 0.06 && (found / peak - 1.0).abs() < 0.06,
        "a {radius} {area} p {peak} {found}"
    );
    assert!((step.references[0].force[2] + step.sets[0].1[2]).abs() < 1e-8 * force);
}

/// A slice of plane strain under a cylinder that is swept along y, as the plane problem of its profile: of each the force by the length.
#[test]
fn a_swept_profile_is_that_of_the_plane() {
    let (across, depth) = (graded(0.025, 8, 6), 0.5);
    let down: Vec<f64> = across.iter().rev().map(|x| -x).collect();
    // x along x, and the generator along y, so that the second axis is z.
    let tool =
        "*SURFACE, TYPE=CYLINDER, NAME=S_TOOL\n0., 0., 1., 1., 0., 1.\n0., 1., 1.\nSTART, 0.8, -0.6\nCIRCL, 0., -1.\n";
    let driven = |axis: usize| {
        format!("*STEP\n*STATIC\n*BOUNDARY\n9900, {axis}, {axis}, -0.0225\n*NODE PRINT, NSET=Z0\nRF\n*END STEP\n")
    };
    let space = base([&across, &[0.0, depth], &down])
        + &format!("{tool}{BODY}{PAIR}*BOUNDARY\nX0, 1\nBASE_NODES, 2\nZ0, 3\n9900, 1, 2\n9900, 4, 6\n{}", driven(3));
    let space: Outcome<3> = solved_text("swept", &space);
    let mut plane = "*NODE\n9900, 0., 2.\n".to_owned();
    let count = across.len();
    for (j, y) in down.iter().enumerate() {
        across.iter().enumerate().for_each(|(i, x)| writeln!(plane, "{}, {x:?}, {y:?}", 1 + i + count * j).unwrap());
    }
    plane += "*ELEMENT, TYPE=CPE4, ELSET=BASE\n";
    for (label, (j, i)) in (1..).zip((0..count - 1).flat_map(|j| (0..count - 1).map(move |i| (j, i)))) {
        let node = |i: usize, j: usize| 1 + i + count * j;
        writeln!(plane, "{label}, {}, {}, {}, {}", node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1))
            .unwrap();
    }
    let first = (count - 2) * (count - 1) + 1;
    plane += &format!(
        "*ELSET, ELSET=TOP, GENERATE\n{first}, {}\n*SURFACE, NAME=S_BASE\nTOP, S3\n*NSET, NSET=Z0, GENERATE\n1, {count}\n*NSET, NSET=X0, GENERATE\n1, {}, {count}\n{MATERIAL}",
        first + count - 2,
        1 + count * (count - 1)
    );
    let profile = "*SURFACE, TYPE=SEGMENTS, NAME=S_TOOL\nSTART, 0.8, 0.4\nCIRCL, 0., 0., 0., 1.\n";
    plane += &format!("{profile}{BODY}{PAIR}*BOUNDARY\nX0, 1\nZ0, 2\n9900, 1\n9900, 6\n{}", driven(2));
    let plane: Outcome<2> = solved_text("swept-plane", &plane);
    let (found, expected) = (space.steps[0].sets[0].1[2] / depth, plane.steps[0].sets[0].1[1]);
    println!("{found} {expected}");
    assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
}

/// A tool with a corner by FILLET RADIUS and with the arc written out, in the model and in an instance that is moved and turned there: one and the same.
#[test]
fn a_profile_is_the_same_by_its_fillet_and_in_an_instance() {
    let block = crate::blocks_text::block("BASE", 1, [3, 2, 2], [[0.0; 3], [3.0, 2.0, 1.0]]);
    let end = format!(
        "{MATERIAL}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n2e4\n*CONTACT PAIR, INTERACTION=I\nSIDE, TOOL\n*BOUNDARY\nLOW, 1, 3\n*STEP\n*STATIC\n\
         *BOUNDARY\nREF, 3, 3, -0.05\nREF, 1, 2\nREF, 4, 6\n*NODE PRINT, NSET=LOW\nRF\n*END STEP\n"
    );
    // A tool whose lower side is z = 1, and its right one x = 2: from above down, round a corner, and to the left.
    let axes = "0., 0., 1., 1., 0., 1.\n0., 1., 1.\n";
    let of = |head: &str, lines: &str| {
        format!(
            "*SURFACE, TYPE=CYLINDER, NAME=S_TOOL{head}\n{lines}*RIGID BODY, ANALYTICAL SURFACE=S_TOOL, REF NODE=900\n"
        )
    };
    let fillet = "START, 2., 2.\nLINE, 2., 0.\nLINE, -1., 0.\n";
    let written = "START, 2., 2.\nLINE, 2., 0.25\nCIRCL, 1.75, 0., 1.75, 0.25\nLINE, -1., 0.\n";
    let in_model = |tool: String| {
        let end = end.replace("SIDE, TOOL", "S_BASE_HIGH, S_TOOL").replace("LOW", "BASE_LOW");
        format!("{block}*NODE, NSET=REF\n900, 2., -1., 3.\n{tool}{end}")
    };
    // In its part z is up: the instance turns z to y, and moves it to where the model has it.
    let local = of("", fillet).replace("REF NODE=900", "REF NODE=1");
    let instance = format!(
        "*PART, NAME=B\n{block}*SOLID SECTION, ELSET=BASE, MATERIAL=M\n*END PART\n*PART, NAME=T\n*END PART\n*ASSEMBLY, NAME=A\n*INSTANCE, NAME=B-1, PART=B\n*END INSTANCE\n\
         *INSTANCE, NAME=T-1, PART=T\n0., 0., 1.\n0., 0., 1., 1., 0., 1., 90.\n*NODE, NSET=REF\n1, 2., 2., 1.\n{local}*END INSTANCE\n\
         *NSET, NSET=REF, INSTANCE=T-1\n1\n*NSET, NSET=LOW, INSTANCE=B-1\nBASE_LOW\n*END ASSEMBLY\n{}",
        end.replace("SIDE, TOOL", "B-1.S_BASE_HIGH, T-1.S_TOOL")
            .replace("*SOLID SECTION, ELSET=BASE, MATERIAL=M\n", "")
    );
    let texts = [
        in_model(of(", FILLET RADIUS=0.25", &format!("{axes}{fillet}"))),
        in_model(of("", &format!("{axes}{written}"))),
    ];
    let [first, second] = texts.map(|text| solved_text::<3>("fillet", &text).steps.remove(0));
    let third = solved_text::<3>("instance", &instance.replace("NAME=S_TOOL\n", "NAME=S_TOOL, FILLET RADIUS=0.25\n"))
        .steps
        .remove(0);
    assert!(first.sets[0].1[2] > 50.0, "{first:?}");
    for other in [second, third] {
        let off = (0..3).map(|k| (first.sets[0].1[k] - other.sets[0].1[k]).abs()).fold(0.0, f64::max);
        assert!(off < 1e-9 * first.sets[0].1[2], "{:?} {:?}", first.sets, other.sets);
        assert!((first.references[0].force[2] - other.references[0].force[2]).abs() < 1e-9 * first.sets[0].1[2]);
    }
}

#[test]
fn what_analytical_surfaces_cannot_be_is_refused_by_its_line() {
    let good = ball(&format!("{ARC}{BODY}"));
    assert_eq!(said(&good, "good.inp"), "nothing");
    for (from, to, expected) in [
        (
            "TYPE=SEGMENTS",
            "TYPE=USER",
            "TYPE=USER is not known; known are ELEMENT, NODE, SEGMENTS, CYLINDER, REVOLUTION",
        ),
        ("TYPE=SEGMENTS", "TYPE=CYLINDER", "this is no analytical surface in 2D: known are SEGMENTS"),
        ("TYPE=SEGMENTS", "TYPE=SEGMENTS, ALIGN=1", "ALIGN is not known"),
        (BODY, "", "no *RIGID BODY has this surface: it needs ANALYTICAL SURFACE=S_TOOL and a REF NODE"),
        ("SURFACE=S_TOOL,", "SURFACE=S_BASE,", "'S_BASE' is no analytical surface"),
        ("SURFACE=S_TOOL,", "SURFACE=NONE,", "there is no surface 'NONE'"),
        (
            BODY,
            &format!("{BODY}*NODE\n9901, 0., 3.\n{}", BODY.replace("9900", "9901")),
            "'S_TOOL' is of another *RIGID BODY already",
        ),
        ("0., 0., 0., 1.\n", "0., 0., 0., 1.5\n", "from its centre"),
        ("0., 0., 0., 1.\n", "0., 0., 0., 1.\nLINE, -1., 0.\n", "a radius of -1 is below 0"),
        ("NAME=S_TOOL", "NAME=S_TOOL, FILLET RADIUS=0.1", "nothing"),
        ("0., 0., 0., 1.\n", "0., 0., 0., 1.\nLINE, 0., 1.\n", "is folded"),
    ] {
        assert!(good.contains(from), "{from}");
        let message = said(&good.replacen(from, to, 1), "analytical.inp");
        assert!(message.contains(expected), "{to}: {message}");
        let line =
            message.strip_prefix("analytical.inp:").and_then(|rest| rest.split(':').next()?.parse::<usize>().ok());
        assert!(expected == "nothing" || line.is_some_and(|line| line > 1), "{to}: {message}");
    }
    let turned = good
        .replace("START, 0.5, 0.1339745962155613\nCIRCL, 0., 0.,", "START, 0., 0.\nCIRCL, 0.5, 0.1339745962155613,");
    let message = said(&turned, "turned.inp");
    assert!(
        message.contains("all of S_BASE lies behind S_TOOL") && message.contains("turn its profile round"),
        "{message}"
    );
    let corner = good
        .replace("NAME=S_TOOL\n", "NAME=S_TOOL, FILLET RADIUS=0.1\n")
        .replace("START, 0.5,", "START, 0.5, 1.\nPARBL, 0.5, 0.5, 0.5,");
    let message = said(&corner, "corner.inp");
    assert!(message.contains("FILLET RADIUS is known for corners between lines and arcs, not at PARBL"), "{message}");
    let space = base([&[0.0, 1.0], &[0.0, 1.0], &[-1.0, 0.0]]) + ARC + BODY + PAIR + "*STEP\n*STATIC\n*END STEP\n";
    let message = said_in::<3>(&space, "space.inp");
    assert!(message.contains("this is no analytical surface in 3D: known are CYLINDER and REVOLUTION"), "{message}");
}
