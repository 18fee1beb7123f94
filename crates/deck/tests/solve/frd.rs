//! The file of results as cgx reads it: fixed columns.

use crate::scene::path;
use fmc_deck::{Analysis, Deck, SolveOptions, frd_start, frd_step};
use std::ops::ControlFlow;

/// The values of a block, node after node.
fn block(text: &str, name: &str, count: usize) -> Vec<(u64, Vec<f64>)> {
    let head = format!(" -4  {name:8}");
    let lines = text.lines().skip_while(|line| !line.starts_with(&head));
    let rows = lines.skip_while(|line| !line.starts_with(" -1")).take_while(|line| !line.starts_with(" -3"));
    let value = |line: &str, k: usize| line[13 + 12 * k..25 + 12 * k].trim().parse().unwrap();
    rows.map(|line| (line[3..13].trim().parse().unwrap(), (0..count).map(|k| value(line, k)).collect())).collect()
}

#[test]
fn results_stand_in_their_columns() {
    let deck = Deck::read(&path("tied.inp")).unwrap();
    let analysis = Analysis::<3>::new(&deck, SolveOptions::default()).unwrap();
    let order = analysis.order.clone();
    let (mut text, mut expected) = (String::new(), Vec::new());
    analysis
        .solve(&mut |_, _| ControlFlow::Continue(()), &mut |at, step| {
            text = frd_start(&deck, &order, at.model()) + &frd_step(&deck, &order, at, &step);
            expected = at.displacement().to_vec();
            Ok(())
        })
        .unwrap();
    let found = block(&text, "DISP", 3);
    assert_eq!(found.len(), expected.len());
    for ((label, found), (expected, &node)) in found.iter().zip(expected.iter().zip(&order[0])) {
        assert_eq!(*label, deck.mesh.node_tags[node]);
        // Six digits are written.
        found.iter().zip(expected).for_each(|(f, e)| assert!((f - e).abs() <= 1e-5 * e.abs() + 1e-12, "{f} {e}"));
    }
    for (_, stress) in block(&text, "STRESS", 6) {
        assert!((stress[2] - 10.0).abs() < 1e-4 && stress[0].abs() < 1e-8, "{stress:?}");
    }
    // Counts of nodes and cells, and the nodes of the first cell, as CalculiX has them.
    assert!(text.contains(&format!("\n    2C{:30}{:38}\n", expected.len(), 1)));
    assert!(text.contains(&format!("\n    3C{:30}{:38}\n", 26, 1)));
    let cell = " -1         1    1    0    1\n -2         1         2         5         4        10        11        14        13\n";
    assert!(text.contains(cell));
}
