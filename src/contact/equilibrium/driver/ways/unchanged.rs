//! A step that begins where the last one has ended, with the same load: nothing has changed.
//!
//! Its end is where it begins, but for what friction is counted anew by, from the place of now. Multipliers with which the last end was an
//! answer are not updated again, and where there is no load, residuals count by the forces that they counted by.

use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::history::LastEquilibrium;
use crate::contact::results::ContactForces;

/// What every pair presses with.
fn pressed<const D: usize>(contact: &ContactForces<D>) -> Vec<f64> {
    contact.pairs.iter().map(|pair| pair.pressure * pair.contact_area).collect()
}

/// Takes up what the last search knew, where nothing has changed since its end.
pub(crate) async fn taken_up<const D: usize>(search: &mut Search<D>, start: &State<D>, moved: &[f64]) {
    if moved.iter().any(|way| *way != 0.0) {
        return;
    }
    let (x, inside, pressed) = (start.x.clone(), start.inside.clone(), pressed(&start.contact));
    let scale = search.host.contact(move |contact| {
        contact.history.last.as_ref().filter(|last| last.is(&x, &inside, &pressed)).map(|last| last.scale)
    });
    if let Some(scale) = scale.await {
        search.balance.measured_by(scale);
        search.updates.stay();
    }
}

/// Whether the last search has ended here.
pub(crate) async fn was_found<const D: usize>(search: &Search<D>, start: &State<D>) -> bool {
    let x = start.x.clone();
    search.host.contact(move |contact| contact.history.last.as_ref().is_some_and(|last| last.x == x)).await
}

/// Keeps what the next search takes up.
pub(crate) async fn kept<const D: usize>(search: &Search<D>, end: &State<D>) {
    let last = LastEquilibrium {
        x: end.x.clone(),
        inside: end.inside.clone(),
        pressed: pressed(&end.contact),
        scale: search.balance.scale(),
    };
    search.host.contact(move |contact| contact.history.last = Some(last)).await;
}
