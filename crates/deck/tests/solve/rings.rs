//! Bodies of revolution against closed forms.

use crate::scene::{said, solved_text};
use fmc_deck::{Analysis, Deck, SolveOptions};
use std::f64::consts::PI;
use std::fmt::Write;

pub(crate) const MATERIAL: &str = "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n";

/// A section of `CAX8` between two radii of height 1 with labels from `first`: sets `NAME`, `NAME_NODES`, and surfaces `S_NAME_IN` and `S_NAME_OUT`.
fn ring(name: &str, first: usize, [inner, outer]: [f64; 2], cells: usize) -> String {
    let columns = 2 * cells + 1;
    let node = |i: usize, j: usize| first + i + columns * j;
    let mut text = format!("*NODE, NSET={name}_NODES\n");
    for (j, i) in (0..3).flat_map(|j| (0..columns).map(move |i| (j, i))).filter(|(j, i)| j * i % 2 == 0) {
        let r = inner + (outer - inner) * i as f64 / (columns - 1) as f64;
        writeln!(text, "{}, {r:.15}, {}", node(i, j), 0.5 * j as f64).unwrap();
    }
    writeln!(text, "*ELEMENT, TYPE=CAX8, ELSET={name}").unwrap();
    for k in 0..cells {
        let i = 2 * k;
        let nodes = [(i, 0), (i + 2, 0), (i + 2, 2), (i, 2), (i + 1, 0), (i + 2, 1), (i + 1, 2), (i, 1)];
        let nodes: Vec<String> = nodes.iter().map(|&(i, j)| node(i, j).to_string()).collect();
        writeln!(text, "{}, {}", first + k, nodes.join(", ")).unwrap();
    }
    let last = first + cells - 1;
    text + &format!(
        "*SURFACE, NAME=S_{name}_IN\n{first}, S4\n*SURFACE, NAME=S_{name}_OUT\n{last}, S2\n*SOLID SECTION, ELSET={name}, MATERIAL=M\n"
    )
}

/// Lamé: in plane strain σ_rr and σ_θθ are A ∓ B/r² with A = p a²/(b² − a²) and B = A b², and u = (1 + ν)/E ((1 − 2ν) A r + B/r). Sixteen elements of
/// second order: their error is below 1e-6 of the displacement and 1e-3 of the stress of the innermost element, whose mean it is.
#[test]
fn a_thick_cylinder_is_lames() {
    let text = ring("PIPE", 1, [1.0, 2.0], 16)
        + MATERIAL
        + "*BOUNDARY\nPIPE_NODES, 2, 2\n*STEP\n*STATIC\n*DSLOAD\nS_PIPE_IN, P, 12.\n*END STEP\n";
    let solved = solved_text::<2>("lame", &text);
    let (a, b) = (12.0 / 3.0, 12.0 / 3.0 * 4.0);
    for ((place, _), u) in solved.contact.iter().zip(&solved.displacement) {
        let expected = 1.3 / 1000.0 * (0.4 * a * place[0] + b / place[0]);
        assert!((u[0] / expected - 1.0).abs() < 1e-6, "{place:?}: {} {expected}", u[0]);
    }
    // Of an element from r to s, weighted with r: the mean of 1/r² is 2 ln(s/r)/(s² − r²).
    for (k, stress) in solved.stresses.iter().enumerate() {
        let [r, s] = [k, k + 1].map(|k| 1.0 + k as f64 / 16.0);
        let mean = b * 2.0 * (s / r).ln() / (s * s - r * r);
        let [radial, axial, hoop, ..] = stress.0;
        assert!(
            (radial - (a - mean)).abs() < 1e-3 * 12.0 && (hoop - (a + mean)).abs() < 1e-3 * 12.0,
            "{k}: {stress:?}"
        );
        assert!((axial - 0.3 * 2.0 * a).abs() < 1e-3 * 12.0, "{k}: {stress:?}");
    }
}

/// Two rings of one material with an interference δ press each other by p = E′ δ/b (b² − a²)(c² − b²)/(2 b² (c² − a²)), E′ = E/(1 − ν²) in plane strain, where
/// each end is held along the axis. The tolerance is that of the penetration, which takes 1e-6 of the interference, and of the place of the interference, of
/// which δ/b is 1e-3.
#[test]
fn a_press_fit_has_its_pressure() {
    let (a, b, c, interference) = (1.0, 2.0, 3.0, 0.002);
    let text = ring("HUB", 201, [b - 0.5 * interference, c], 8)
        + &ring("SHAFT", 1, [a, b + 0.5 * interference], 8)
        + MATERIAL
        + "*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nS_HUB_IN, S_SHAFT_OUT\n*BOUNDARY\nHUB_NODES, 2, 2\nSHAFT_NODES, 2, 2\n*STEP\n*STATIC\n*END STEP\n";
    let solved = solved_text::<2>("fit", &text);
    let expected =
        1000.0 / 0.91 * interference / b * (b * b - a * a) * (c * c - b * b) / (2.0 * b * b * (c * c - a * a));
    let pair = &solved.steps[0].pairs[0];
    assert!((pair.pressure / expected - 1.0).abs() < 3e-3, "{} {expected}", pair.pressure);
    // The whole ring.
    assert!((pair.area / (2.0 * PI * b) - 1.0).abs() < 2e-3, "{}", pair.area);
}

/// Columns and rows, graded towards the origin, of `CAX4`: `height` is that of the lowest row at a radius, or of the highest.
pub(crate) fn graded(name: &str, first: usize, top: f64, surface: &dyn Fn(f64) -> f64) -> String {
    let count = 44;
    // Even cells of 0.004 in the contact, then growing.
    let at: Vec<f64> =
        (0..=count).map(|k| if k <= 20 { 0.004 * k as f64 } else { 0.08 * 1.09f64.powi(k - 20) }).collect();
    let node = |i: usize, j: usize| first + i + 45 * j;
    let mut text = format!("*NODE, NSET={name}_NODES\n");
    for (j, depth) in at.iter().enumerate() {
        for (i, &r) in at.iter().enumerate() {
            let (low, part) = (surface(r), depth / at[44]);
            writeln!(text, "{}, {r:.12}, {:.12}", node(i, j), low + part * (top - low)).unwrap();
        }
    }
    writeln!(text, "*ELEMENT, TYPE=CAX4, ELSET={name}").unwrap();
    for (j, i) in (0..44).flat_map(|j| (0..44).map(move |i| (j, i))) {
        let mut nodes = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
        if top < 0.0 {
            nodes.reverse();
        }
        writeln!(text, "{}, {}, {}, {}, {}", first + i + 44 * j, nodes[0], nodes[1], nodes[2], nodes[3]).unwrap();
    }
    let face = if top < 0.0 { "S3" } else { "S1" };
    let contact: String = (first..first + 40).map(|label| format!("{label}, {face}\n")).collect();
    let axis: Vec<String> = (0..45).map(|j| node(0, j).to_string()).collect();
    let far: Vec<String> = (0..45).map(|i| node(i, 44).to_string()).collect();
    text + &format!(
        "*SURFACE, NAME=S_{name}\n{contact}*NSET, NSET={name}_AXIS\n{}\n*NSET, NSET={name}_FAR\n{}\n",
        axis.join("\n"),
        far.join("\n")
    )
}

/// Hertz: a³ = 3 F R/4 E* and p₀ = 3 F/2πa², with E* = E/(1 − ν²) of the ball on a base that is a thousand times as stiff. The radius of 0.06 is 15 edges of the mesh, and a
/// tenth of the piece of the ball that is solved: some percent in all.
#[test]
fn a_ball_presses_as_hertz_has_it() {
    let text = graded("BALL", 1, 0.6, &|r: f64| 1.0 - (1.0 - r * r).sqrt())
        + &graded("BASE", 5001, -0.6, &|_| 0.0)
        + MATERIAL
        + "*MATERIAL, NAME=STIFF\n*ELASTIC\n1e6, 0.3\n*SOLID SECTION, ELSET=BALL, MATERIAL=M\n*SOLID SECTION, ELSET=BASE, MATERIAL=STIFF\n\
           *SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nS_BALL, S_BASE\n*BOUNDARY\nBALL_AXIS, 1\nBASE_AXIS, 1\nBASE_FAR, 2\n\
           *STEP\n*STATIC\n*BOUNDARY\nBALL_FAR, 2, 2, -0.0036\n*NODE PRINT, NSET=BASE_FAR\nRF\n*END STEP\n";
    let solved = solved_text::<2>("ball", &text);
    let pair = &solved.steps[0].pairs[0];
    let (force, modulus) = (pair.force[1].abs(), 1000.0 / 0.91);
    let radius = (0.75 * force / modulus).cbrt();
    let peak = 1.5 * force / (PI * radius * radius);
    let found = solved.pressures.iter().map(|at| at.pressure).fold(0.0, f64::max);
    println!("a {radius} {}, p {peak} {found}", (pair.area / PI).sqrt());
    assert!(((pair.area / PI).sqrt() / radius - 1.0).abs() < 0.03, "{} {radius}", pair.area);
    assert!((found / peak - 1.0).abs() < 0.04, "{found} {peak}");
    // The whole ring's.
    assert!((solved.steps[0].sets[0].1[1] / force - 1.0).abs() < 1e-6);
}

/// Loads and reactions are those of whole rings: what CalculiX 2.20 takes, and 180 times the reactions that it prints of its sector of 2°. Forces on nodes, pressure
/// and weight: sums by statics.
#[test]
fn loads_and_reactions_are_of_the_whole_ring() {
    let ring = ring("PIPE", 1, [1.0, 2.0], 2);
    let text = |load: &str| {
        ring.clone()
            + MATERIAL
            + "*DENSITY\n2.\n*BOUNDARY\n1, 2\n2, 2\n3, 2\n4, 2\n5, 2\n*STEP\n*STATIC\n"
            + load
            + "*NODE PRINT, NSET=PIPE_NODES\nRF\n*END STEP\n"
    };
    for (load, expected) in [
        ("*CLOAD\n15, 2, 6.\n11, 2, 3.\n", -9.0),
        ("*DLOAD\nPIPE, P3, 10.\n", 30.0 * PI),
        ("*DLOAD\nPIPE, GRAV, 10., 0., -1.\n", 60.0 * PI),
    ] {
        let step = &solved_text::<2>("whole", &text(load)).steps[0];
        assert!((step.sets[0].1[1] - expected).abs() < 1e-6 && (step.reaction[1] - expected).abs() < 1e-6, "{step:?}");
    }
}

/// A disc of `CAX8` in a stiff ring, pressed by a rigid plate: the pressure is E′ u/h of uniaxial strain, also at the axis, where the ring of a node has no area. The
/// penetration takes 1e-3 of it at most.
#[test]
fn the_node_on_the_axis_has_a_pressure() {
    let text = ring("DISC", 1, [0.0, 1.0], 4)
        .replace("*SURFACE, NAME=S_DISC_IN", "*SURFACE, NAME=TOP\nDISC, S3\n*SURFACE, NAME=S_DISC_IN")
        + MATERIAL
        + "*NODE\n900, 0., 2.\n*SURFACE, TYPE=SEGMENTS, NAME=PLATE\nSTART, 2., 1.\nLINE, 0., 1.\n*RIGID BODY, ANALYTICAL SURFACE=PLATE, REF NODE=900\n\
           *SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nTOP, PLATE\n*BOUNDARY\nDISC_NODES, 1\n1, 2\n2, 2\n3, 2\n4, 2\n5, 2\n6, 2\n7, 2\n8, 2\n9, 2\n900, 1\n900, 6\n\
           *STEP\n*STATIC\n*BOUNDARY\n900, 2, 2, -0.001\n*END STEP\n";
    let solved = solved_text::<2>("axis-pressure", &text);
    let expected = 1000.0 * 0.7 / (1.3 * 0.4) * 1e-3;
    let top: Vec<_> = solved.contact.iter().filter(|(place, _)| place[1] == 1.0 && place[0] < 1.0).take(8).collect();
    assert!(top[0].0[0] == 0.0 && top.len() == 8);
    for (place, pressure) in top {
        assert!((pressure / expected - 1.0).abs() < 1e-3, "{place:?}: {pressure} {expected}");
    }
}

/// Nodes on the axis that nothing holds there are told, by the first of them.
#[test]
fn free_nodes_on_the_axis_are_told() {
    let notes = |held: &str| {
        let text = ring("DISC", 1, [0.0, 1.0], 2)
            + MATERIAL
            + &format!("*BOUNDARY\n1, 2\n{held}*STEP\n*STATIC\n*DLOAD\nDISC, P3, 10.\n*END STEP\n");
        let file = std::env::temp_dir().join(format!("fmc-deck-axis-{}.inp", std::process::id()));
        std::fs::write(&file, text).unwrap();
        let deck = Deck::read(&file).unwrap();
        std::fs::remove_file(file).unwrap();
        let analysis = Analysis::<2>::new(&deck, SolveOptions::default()).unwrap();
        analysis.notes.into_iter().map(|note| note.message).collect::<Vec<_>>().join(" ")
    };
    let told = "node 6 lies on the axis r = 0 and is free to leave it";
    assert!(notes("1, 1\n11, 1\n").contains(told) && !notes("1, 1\n6, 1\n11, 1\n").contains("axis"));
}

#[test]
fn what_rings_cannot_be_is_refused() {
    let good = ring("PIPE", 1, [1.0, 2.0], 2)
        + MATERIAL
        + "*NODE\n900, 0., 3.\n*BOUNDARY\n1, 2\n*STEP\n*STATIC\n*DLOAD\nPIPE, P3, 10.\n*END STEP\n";
    assert_eq!(said(&good, "ring.inp"), "nothing");
    for (from, to, expected) in [
        ("1, 1.000000000000000, 0", "1, -1.000000000000000, 0", "node 1 lies at r = -1: the first coordinate of CAX"),
        ("MATERIAL=M\n", "MATERIAL=M\n2.\n", "bodies of revolution have no thickness, and here it is 2"),
        ("PIPE, P3, 10.", "PIPE, GRAV, 10., 1., 0.", "GRAV acts along the axis of bodies of revolution"),
        (
            "*STEP\n",
            "*ELEMENT, TYPE=CPE3, ELSET=FLAT\n900, 1, 2, 11\n*STEP\n",
            "elements of type CPE3 together with CAX8: axisymmetric and plane bodies",
        ),
        (
            "*STEP\n",
            "*NSET, NSET=TOP\n11, 12, 13, 14, 15\n*RIGID BODY, NSET=TOP, REF NODE=900\n*STEP\n",
            "moves along its axis alone",
        ),
    ] {
        assert!(good.contains(from), "{from}");
        let found = said(&good.replacen(from, to, 1), "ring.inp");
        assert!(found.contains(expected), "{to}: {found}");
    }
}
