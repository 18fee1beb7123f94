//! The thickness of bodies of the plane.
//!
//! Bodies are solved per unit thickness: point loads are divided by it, and forces of results are multiplied.

use super::result::StepResult;
use crate::Fault;
use crate::read::{Deck, SectionRow};

/// The thickness of all bodies; 1 in space.
pub(super) fn thickness(deck: &Deck, dimension: usize) -> Result<f64, Fault> {
    let Some(first) = deck.sections.first() else { return Ok(1.0) };
    let ring = deck.sections.iter().find(|section| deck.is_axisymmetric() && section.thickness != 1.0);
    if let Some(SectionRow { line, thickness, .. }) = ring {
        return Err(Fault::new(*line, format!("bodies of revolution have no thickness, and here it is {thickness}")));
    }
    if let Some(section) = deck.sections.iter().find(|section| dimension == 3 && section.thickness != 1.0) {
        return Err(Fault::new(
            section.line,
            format!("solids have no thickness, and here it is {}", section.thickness),
        ));
    }
    match deck.sections.iter().find(|section| section.thickness != first.thickness) {
        None => Ok(first.thickness),
        Some(other) => {
            let message = format!(
                "a thickness of {} besides {} in line {}: all bodies must have one thickness",
                other.thickness, first.thickness, first.line
            );
            Err(Fault::new(other.line, message))
        }
    }
}

impl StepResult {
    /// The same for a thickness, of results per unit thickness.
    pub(super) fn of_thickness(mut self, thickness: f64) -> Self {
        let mut times = |number: &mut f64| *number *= thickness;
        let vectors = [&mut self.reaction, &mut self.load].into_iter();
        let vectors = vectors.chain(self.sets.iter_mut().map(|(_, sum)| sum)).chain(&mut self.reactions);
        let vectors = vectors.chain(self.references.iter_mut().flat_map(|one| [&mut one.force, &mut one.moment]));
        let vectors = vectors.chain(self.bodies.iter_mut().map(|(_, force)| force));
        vectors.flatten().for_each(&mut times);
        self.pairs.iter_mut().for_each(|pair| pair.force.iter_mut().chain([&mut pair.area]).for_each(&mut times));
        self.ties.iter_mut().for_each(|tie| times(&mut tie.area));
        [&mut self.residual, &mut self.largest_force].into_iter().for_each(times);
        self.thickness = thickness;
        self
    }
}
