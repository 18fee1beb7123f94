//! A file solved.

use fmc_deck::{Analysis, Deck, SolveOptions, Solved, StepResult};
use fmc_solid::fem::Stress;
use fmc_solid::statics::{NodalPressure, nodal_pressures};
use std::ops::ControlFlow;
use std::path::PathBuf;

/// The path of a file of this test.
pub(crate) fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/solve/decks").join(name)
}

/// What all steps left, and the fields of the last.
pub(crate) struct Outcome<const D: usize> {
    pub(crate) steps: Vec<StepResult>,
    /// Of the cells.
    pub(crate) stresses: Vec<Stress>,
    /// Of the nodes.
    pub(crate) displacement: Vec<[f64; D]>,
    /// Of the first body.
    pub(crate) pressures: Vec<NodalPressure<D>>,
    /// Coordinates of the nodes, and the pressure that files have.
    pub(crate) contact: Vec<([f64; D], f64)>,
}

/// Solves a text as a file.
pub(crate) fn solved_text<const D: usize>(name: &str, text: &str) -> Outcome<D> {
    let file = std::env::temp_dir().join(format!("fmc-deck-{name}-{}.inp", std::process::id()));
    std::fs::write(&file, text).unwrap();
    let outcome = solved(file.to_str().unwrap(), SolveOptions::default());
    std::fs::remove_file(file).unwrap();
    outcome
}

/// The pressures of an FRD file, node after node.
fn frd_pressures(text: &str) -> Vec<f64> {
    let lines = text.lines().skip_while(|line| !line.starts_with(" -4  CONTACT"));
    let rows = lines.skip_while(|line| !line.starts_with(" -1")).take_while(|line| !line.starts_with(" -3"));
    rows.map(|line| line[13..25].trim().parse().unwrap()).collect()
}

/// Solves a file.
pub(crate) fn solved<const D: usize>(name: &str, options: SolveOptions) -> Outcome<D> {
    let deck = Deck::read(&path(name)).unwrap();
    assert_eq!(deck.dimension().unwrap(), D);
    let analysis = Analysis::<D>::new(&deck, options).unwrap();
    let order = analysis.order.clone();
    let mut all = Outcome {
        steps: Vec::new(),
        stresses: Vec::new(),
        displacement: Vec::new(),
        pressures: Vec::new(),
        contact: Vec::new(),
    };
    let ended = analysis.solve(&mut |_, _| ControlFlow::Continue(()), &mut |at, step| {
        let found = frd_pressures(&fmc_deck::frd_step(&deck, &order, at, &step));
        all.contact = at.model().coords().iter().copied().zip(found).collect();
        all.steps.push(step);
        all.displacement = at.displacement().to_vec();
        all.stresses = at.model().stresses(at.displacement());
        all.pressures = nodal_pressures(at.model(), 0, &at.balance().contact.forces);
        Ok(())
    });
    assert!(matches!(ended, Ok(Solved::Finished)), "{ended:?}");
    all
}

/// Largest difference of the stress of any cell from one that is the same everywhere.
pub(crate) fn largest_off(stresses: &[Stress], expected: [f64; 6]) -> f64 {
    let off = |stress: &Stress| stress.0.iter().zip(expected).map(|(s, e)| (s - e).abs()).fold(0.0, f64::max);
    stresses.iter().map(off).fold(0.0, f64::max)
}

/// What is said of a file of the plane: of reading it, or of what it means.
pub(crate) fn said(text: &str, name: &str) -> String {
    said_in::<2>(text, name)
}

/// What is said of a file.
pub(crate) fn said_in<const D: usize>(text: &str, name: &str) -> String {
    let folder = std::env::temp_dir().join(format!("fmc-deck-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join(name);
    std::fs::write(&file, text).unwrap();
    let said = match Deck::read(&file) {
        Err(error) => error,
        Ok(deck) => match Analysis::<D>::new(&deck, SolveOptions::default()) {
            Err(fault) => deck.located(&fault),
            Ok(_) => "nothing".to_owned(),
        },
    };
    said.replace(&folder.display().to_string(), "").trim_start_matches('/').to_owned()
}
