//! The order of things in a load step.

use super::attempt::LoadStep;
use super::parts::in_parts;
use crate::contact::changes::friction_steps::bear_anew;
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::equilibrium::driver::asking::conversation::Asking;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::outcome::{Found, Refusal};
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::bodies::layers;
use crate::contact::equilibrium::driver::bodies::motions::Motions;
use crate::contact::equilibrium::driver::progress::balance::Balance;
use crate::contact::equilibrium::driver::progress::before::{Before, Kept};
use crate::contact::equilibrium::driver::progress::patches::Patches;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::stood::Former;
use crate::contact::equilibrium::driver::progress::updates::Updates;
use crate::contact::equilibrium::driver::told::told_breaking::with_what_breaks;
use crate::contact::equilibrium::driver::told::uncommitted::uncommitted;
use crate::contact::history::FirstTouches;
use std::sync::Arc;

/// All of it. After a refusal the contact's history has to become what is `kept`.
pub(crate) async fn load_step<const D: usize>(
    asking: Asking<D>,
    step: LoadStep<D>,
    kept: Kept<D>,
) -> Result<Found<D>, Refusal> {
    let host = Host::new(asking, step.unknowns.clone());
    // A search that was left where it was may have left it.
    host.contact(|contact| {
        (contact.history.apart_at, contact.history.sticking) = (None, 1.0);
        contact.history.let_apart.clear();
    })
    .await;
    let is_found = host.contact(|contact| contact.options().law.is_without_stiffness()).await;
    let (unknowns, x) = (step.unknowns.clone(), step.x.clone());
    let former = host.contact(move |contact| Former::of(contact, &unknowns, &x)).await;
    let mut search = match prepared(&host, &step).await {
        Ok((assembly, motions, has_friction, pressed)) => Search {
            host,
            assembly: Arc::new(assembly),
            motions,
            balance: Balance::new(step.options.tolerance, pressed),
            patches: step.options.finds_patches.then(Patches::default),
            updates: Updates::new(&step.options, is_found),
            options: step.options,
            has_friction,
            former,
            unloaded: None,
            falling: None,
            broken: Vec::new(),
            free: Vec::new(),
            warnings: Vec::new(),
        },
        Err(trouble) => return Err(Refusal::new(trouble, Vec::new(), host.solves())),
    };
    if let Some(text) = uncommitted(&search, &step.x).await {
        search.warn(text);
    }
    let coords = search.host.unknowns.coords(&step.x);
    let begun = search.host.contact(move |contact| {
        kept.keep(Before::of(contact));
        // The same step is tried again.
        if contact.history.step.as_ref().is_some_and(|step| *step.coords.given() == coords) {
            contact.history.first_touches = FirstTouches::default();
        }
    });
    begun.await;
    match in_parts(&mut search, &step).await {
        Ok(found) => Ok(found),
        Err(trouble) => {
            let trouble = with_advice(&search, with_what_breaks(&search, trouble)).await;
            Err(Refusal::new(trouble, search.balance.history, search.host.solves()))
        }
    }
}

/// What may lead on, where it is known.
async fn with_advice<const D: usize>(search: &Search<D>, trouble: Trouble) -> Trouble {
    let has_law = search.host.contact(|contact| !contact.governed.is_empty()).await;
    let trouble = match trouble {
        Trouble::Adrift(..) if search.has_friction => trouble.and("its load may be more than friction holds"),
        trouble => trouble,
    };
    match trouble {
        Trouble::Failed(_) if has_law => trouble.and("an interface follows a law of the host: check its tangent first"),
        Trouble::Failed(_) | Trouble::Adrift(..) if !search.may_go_on() => {
            trouble.and("no more linear solves are allowed: allow more, or take smaller load steps")
        }
        Trouble::Failed(_) | Trouble::Adrift(..) if search.has_friction => {
            trouble.and("smaller load steps may lead on")
        }
        trouble => trouble,
    }
}

/// What a search needs to know of bodies and contact.
async fn prepared<const D: usize>(
    host: &Host<D>,
    step: &LoadStep<D>,
) -> Result<(Assembly<D>, Motions, bool, Vec<f64>), Trouble> {
    if step.options.penetration > 0.0 {
        // It would be refused where it is reached, after a whole search.
        host.contact(|contact| contact.check_multipliers()).await?;
    }
    let coords = host.unknowns.coords(&step.x);
    let at = coords.clone();
    let assembly = host.contact(move |contact| Assembly::new(contact, &at)).await?;
    host.forces(&step.x, true).await?;
    let is_new = layers::complete(host, &assembly, &step.x).await?;
    let (has_friction, has_begun) = host.contact(|contact| (contact.has_friction(), contact.slip().is_ok())).await;
    let changes = host.contact(|contact| contact.has_history() || contact.partners.table.has_wear()).await;
    if (has_friction || changes) && !has_begun {
        host.contact(move |contact| contact.begin_step(&coords)).await?;
    } else if has_friction && is_new {
        host.contact(bear_anew).await?;
    }
    let motions = Motions::loose(host, &assembly, &host.unknowns.coords(&step.x)).await?;
    let body = assembly.body.clone();
    let pressed = host.contact(move |contact| contact.stiffness_by_row(&body)).await;
    Ok((assembly, motions, has_friction, pressed))
}
