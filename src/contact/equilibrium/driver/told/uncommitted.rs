//! A load step that was never accepted.

use crate::contact::equilibrium::driver::progress::search::Search;
use crate::geometry::Vector;

/// Part of the assembly's size that is rounding of coordinates.
const ROUNDING: f64 = 1e-12;

/// What is said of a search that begins at the equilibrium of the last one, while slip, damage and wear still count from where that one
/// began.
pub(crate) async fn uncommitted<const D: usize>(search: &Search<D>, x: &[f64]) -> Option<String> {
    let (last, coords) = (x.to_vec(), search.host.unknowns.coords(x));
    let nothing = ROUNDING * search.assembly.size;
    let is_forgotten = search.host.contact(move |contact| {
        let is_last = contact.history.last.as_ref().is_some_and(|found| found.x == last);
        let Some(step) = contact.history.step.as_ref().filter(|_| is_last) else { return false };
        let Ok(points) = contact.mesh.surface.mesh_points(&coords) else { return false };
        let is_elsewhere =
            |(k, x): (usize, &[f64; D])| (Vector::from(*x) - Vector::from(step.coords[k])).amax() > nothing;
        points.iter().enumerate().any(is_elsewhere)
    });
    is_forgotten.await.then(|| {
        "the step that led to the equilibrium where this one begins was not committed: slip, damage and wear count from where it began; \
         commit each load step"
            .to_owned()
    })
}
