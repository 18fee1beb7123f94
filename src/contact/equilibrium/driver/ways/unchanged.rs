//! A step that begins where the last one has ended, with the same load: nothing has changed.
//!
//! Its end is where it begins, but for what friction is counted anew by, from the place of now. Multipliers with which the last end was an
//! answer are not updated again, and where there is no load, residuals count by the forces that they counted by.

use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::evaluation::Contact;
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
        let poses = contact.partners.obstacles.poses();
        contact.history.last.as_ref().filter(|last| last.is(&x, &inside, &pressed, &poses)).map(|last| last.scale)
    });
    if let Some(scale) = scale.await {
        search.balance.measured_by(scale);
        search.updates.stay();
    }
}

/// The bodies' forces in the equilibrium that the last search has found here.
pub(crate) async fn found_there<const D: usize>(search: &Search<D>, start: &State<D>) -> Option<Vec<f64>> {
    let x = start.x.clone();
    let inside = move |contact: &mut Contact<D>| {
        contact.history.last.as_ref().filter(|last| last.x == x).map(|last| last.inside.clone())
    };
    search.host.contact(inside).await
}

/// Keeps what the next search takes up.
pub(crate) async fn kept<const D: usize>(search: &Search<D>, end: &State<D>) {
    let (x, inside, scale) = (end.x.clone(), end.inside.clone(), search.balance.scale());
    let pressed = pressed(&end.contact);
    let keep = move |contact: &mut Contact<D>| {
        let poses = contact.partners.obstacles.poses();
        contact.history.last = Some(LastEquilibrium { x, inside, pressed, poses, scale });
    };
    search.host.contact(keep).await;
}
