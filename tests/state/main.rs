//! What was done before does not matter: a contact is what its last calls made of it.
//!
//! A setting is a call that gives a part of the contact a value. Whatever values it had before, in whichever order they came and
//! whatever was evaluated meanwhile, a contact with the same values gives the same bits.

#[path = "../scene/scene.rs"]
mod scene;

mod bearings;
mod detours;
mod looks;
mod one_rank;
mod problem;
mod refusals;
mod released;
mod restart;
mod settings;
