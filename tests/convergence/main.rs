//! How fast, and how honestly, the sampled estimator approaches the exact one.

#[path = "../scene/scene.rs"]
mod scene;

mod disc_and_sphere;
mod isotropic;
mod order;
mod spheres;
mod standard_error;
mod star;
