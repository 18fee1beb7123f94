//! `*TRANSFORM`: supports and loads along axes of their own.

use crate::scene::solved_text;
use std::fmt::Write;

/// A bar of length 4 and height 1 along 30 degrees, pulled by 10 along itself: E = 1000 and no contraction. `turned` are the ways to say the same.
fn bar(ends: &str) -> String {
    let (s, c) = 30_f64.to_radians().sin_cos();
    let mut text = "*NODE, NSET=ALL\n".to_owned();
    for (node, [x, y]) in [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 1.0]].into_iter().enumerate() {
        writeln!(text, "{}, {:.15}, {:.15}", node + 1, c * x - s * y, s * x + c * y).unwrap();
    }
    text + "*ELEMENT, TYPE=CPE4, ELSET=E\n1, 1, 2, 3, 4\n*NSET, NSET=FIX\n1, 4\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n\
            *SOLID SECTION, ELSET=E, MATERIAL=M\n"
        + ends
}

/// F L / E A along the bar, and a reaction against the force; rounding of 15 digits.
#[test]
fn a_bar_is_pulled_along_itself() {
    let (s, c) = 30_f64.to_radians().sin_cos();
    let ends = format!(
        "*TRANSFORM, NSET=ALL, TYPE=R\n{:.15}, {:.15}, 0., {:.15}, {:.15}, 0.\n*BOUNDARY\nFIX, 1\n1, 2\n*STEP\n*STATIC\n*CLOAD\n2, 1, 5.\n3, 1, 5.\n\
         *NODE PRINT, NSET=FIX\nRF\n*END STEP\n",
        2.0 * c,
        2.0 * s,
        -s,
        c
    );
    let outcome = solved_text::<2>("turned-bar", &bar(&ends));
    for node in [1, 2] {
        let [x, y] = outcome.displacement[node];
        assert!((x - 0.04 * c).abs() < 1e-12 && (y - 0.04 * s).abs() < 1e-12, "{x} {y}");
    }
    let step = &outcome.steps[0];
    let near =
        |found: [f64; 3], sign: f64| (found[0] - sign * 10.0 * c).abs() + (found[1] - sign * 10.0 * s).abs() < 1e-10;
    assert!(near(step.load, 1.0) && near(step.reaction, -1.0) && near(step.sets[0].1, -1.0), "{step:?}");
    assert!(step.references.is_empty());
}

/// A motion along the bar by `*BOUNDARY`, released in a second step: the bar then rests without a load.
#[test]
fn a_motion_is_released() {
    let (s, c) = 30_f64.to_radians().sin_cos();
    let ends = format!(
        "*TRANSFORM, NSET=ALL\n{:.15}, {:.15}, 0., {:.15}, {:.15}, 0.\n*BOUNDARY\nFIX, 1\n1, 2\n*STEP\n*STATIC\n*BOUNDARY\n2, 1, 1, 0.04\n3, 1, 1, 0.04\n\
         *NODE PRINT, NSET=FIX\nRF\n*END STEP\n*STEP\n*STATIC\n*BOUNDARY, OP=NEW\nFIX, 1\n1, 2\n*END STEP\n",
        c, s, -s, c
    );
    let outcome = solved_text::<2>("released-bar", &bar(&ends));
    let [x, y, _] = outcome.steps[0].sets[0].1;
    assert!((x + 10.0 * c).abs() + (y + 10.0 * s).abs() < 1e-10, "{x} {y}");
    let left = outcome.displacement.iter().flatten().fold(0.0, |most: f64, u| most.max(u.abs()));
    assert!(left < 1e-10 && outcome.steps[1].reaction.iter().all(|f| f.abs() < 1e-9), "{left}");
}

/// A sector from 10 to 40 degrees of a thick cylinder of plane strain under inner pressure, its sides held along the tangent: Lamé. `CPE8`, eight by
/// four elements; 1e-3: four times what the mesh leaves.
#[test]
fn a_sector_is_a_whole_cylinder() {
    let (a, b, young, poisson, pressure) = (1.0, 2.0, 1000.0, 0.3, 10.0);
    let (rows, columns) = (8, 4);
    let label = |i: usize, j: usize| 1 + j * (2 * rows + 1) + i;
    let (mut nodes, mut cells, mut sides) = (String::new(), String::new(), String::new());
    let mut places = Vec::new();
    for j in 0..=2 * columns {
        for i in 0..=2 * rows {
            if i % 2 == 1 && j % 2 == 1 {
                continue;
            }
            let r = a + (b - a) * i as f64 / (2 * rows) as f64;
            let (s, c) = (10.0 + 30.0 * j as f64 / (2 * columns) as f64).to_radians().sin_cos();
            writeln!(nodes, "{}, {:.15}, {:.15}", label(i, j), r * c, r * s).unwrap();
            places.push((r, [c, s]));
            if j == 0 || j == 2 * columns {
                writeln!(sides, "{}", label(i, j)).unwrap();
            }
        }
    }
    for j in 0..columns {
        for i in 0..rows {
            let at = |di: usize, dj: usize| label(2 * i + di, 2 * j + dj).to_string();
            let all = [[0, 0], [2, 0], [2, 2], [0, 2], [1, 0], [2, 1], [1, 2], [0, 1]].map(|[di, dj]| at(di, dj));
            writeln!(cells, "{}, {}", 1 + j * rows + i, all.join(", ")).unwrap();
        }
    }
    let inner: String = (0..columns).map(|j| format!("{}, P4, {pressure}\n", 1 + j * rows)).collect();
    let text = format!(
        "*NODE\n{nodes}*ELEMENT, TYPE=CPE8, ELSET=E\n{cells}*NSET, NSET=SIDES\n{sides}*MATERIAL, NAME=M\n*ELASTIC\n{young}, {poisson}\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*TRANSFORM, NSET=SIDES, TYPE=C\n0., 0., 0., 0., 0., 1.\n*BOUNDARY\nSIDES, 2\n*STEP\n*STATIC\n*DLOAD\n{inner}*END STEP\n"
    );
    let outcome = solved_text::<2>("sector", &text);
    for (node, (r, [c, s])) in places.into_iter().enumerate() {
        let factor = (1.0 + poisson) / young * pressure * a * a / (b * b - a * a);
        let exact = factor * ((1.0 - 2.0 * poisson) * r + b * b / r);
        let [x, y] = outcome.displacement[node];
        let (radial, tangential) = (x * c + y * s, y * c - x * s);
        assert!(
            (radial / exact - 1.0).abs() < 1e-3 && tangential.abs() < 1e-3 * exact,
            "{r}: {radial} {exact} {tangential}"
        );
    }
}
