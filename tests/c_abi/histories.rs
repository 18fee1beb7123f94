//! One impact in every language: the programs are the same line by line, and so are their histories.

use super::hosts::{Link, output};

#[path = "../../hosts/rust/impact.rs"]
mod impact;

/// Step, force, velocity and energy, every 20 steps.
type History = Vec<[f64; 4]>;

/// The programs, of which the first is what the others are compared with. One more language is one more line.
fn histories() -> Vec<(&'static str, History)> {
    vec![
        ("C", parsed(&output("impact.c", Link::Shared))),
        ("C++", parsed(&output("impact.cpp", Link::Shared))),
        ("Fortran", parsed(&super::fortran::output("impact.f90"))),
        ("Rust", parsed(&impact::history().expect("a history"))),
    ]
}

/// Numbers as any of the languages writes them, `1.5e+00` or `1.5E0`.
fn parsed(printed: &str) -> History {
    let numbers = |line: &str| {
        let row: Vec<f64> = line.split_whitespace().map(|word| word.parse().expect("a number")).collect();
        row.try_into().unwrap_or_else(|_| panic!("not four numbers: {line}"))
    };
    printed.lines().map(numbers).collect()
}

#[test]
fn histories_of_all_languages_are_the_same() {
    let all = histories();
    let (first, expected) = &all[0];
    let steps: Vec<f64> = expected.iter().map(|row| row[0]).collect();
    assert_eq!(steps, (0..=20).map(|k| 20.0 * f64::from(k)).collect::<Vec<_>>());
    for (language, history) in &all[1..] {
        assert_eq!(history.len(), expected.len(), "{language}");
        for (found, wanted) in history.iter().zip(expected) {
            // Sums in one order and without contraction: equal in all the digits that are printed, which are 16.
            assert_eq!(found, wanted, "{language} and {first}");
        }
    }
}

/// The block that falls is slowed down, turns back, and is pushed by nothing but what it touches.
#[test]
fn the_impact_is_one() {
    let history = parsed(&impact::history().expect("a history"));
    let velocities: Vec<f64> = history.iter().map(|row| row[2]).collect();
    assert_eq!(history[0][1..], [0.0, -1.0, 0.0]);
    // The contact alone changes the momentum of the block, and only upwards; free flight keeps it to rounding.
    assert!(velocities.windows(2).all(|pair| pair[1] > pair[0] - 1e-12), "{velocities:?}");
    assert!(*velocities.last().expect("an end") > 0.2, "{velocities:?}");
    assert!(history.iter().all(|row| row[1] >= 0.0 && row[3] >= 0.0 && (row[1] > 0.0) == (row[3] > 0.0)));
    // No more energy than that of the fall, m v^2 / 2 with 360 kg and 1 m/s.
    assert!(history.iter().all(|row| row[3] < 180.0));
}
