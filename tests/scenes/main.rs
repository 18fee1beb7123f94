//! Random scenes of two blocks, judged by what must hold in every position: walls that are flush but for a few last digits, bodies
//! that touch, deep ones, all types of cells, turned, moved far away, in any unit.
//!
//! `FMC_SCENES=1000..200000` judges the scenes of these seeds, and each scene is found again by its seed alone.

#[path = "../scene/scene.rs"]
mod scene;

mod beside;
mod draw;
mod forces;
mod judge;

use judge::judge;
use std::ops::Range;

/// The seeds asked for; a few hundred scenes, which take seconds, without.
fn seeds(otherwise: Range<u64>) -> Range<u64> {
    let Ok(asked) = std::env::var("FMC_SCENES") else { return otherwise };
    let bound = |text: &str| text.parse().expect("FMC_SCENES is FROM..TO");
    let (from, to) = asked.split_once("..").expect("FMC_SCENES is FROM..TO");
    bound(from)..bound(to)
}

/// Every defect of every scene, not only the first, so that a kind is seen.
fn judge_all<const D: usize>(draw: impl Fn(u64) -> draw::Drawn<D>, seeds: Range<u64>) {
    let count = seeds.end - seeds.start;
    let mut found = 0;
    for seed in seeds {
        let drawn = draw(seed);
        for defect in judge(&drawn) {
            found += 1;
            eprintln!("scene {seed} ({}): {defect}", drawn.words);
        }
    }
    assert_eq!(found, 0, "defects in {count} scenes");
}

#[test]
fn in_the_plane() {
    judge_all(draw::in_the_plane, seeds(0..600));
}

#[test]
fn in_space() {
    judge_all(draw::in_space, seeds(0..150));
}
