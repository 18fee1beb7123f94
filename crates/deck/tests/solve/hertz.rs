//! A cylinder on a stiff block.

use crate::scene::solved;
use fmc_deck::SolveOptions;
use std::f64::consts::PI;

/// Hertz: a = √(4 P R / π E*), p₀ = √(P E* / π R), with E* = E/(1 − ν²) and P the force of the whole cylinder, of which a half is solved.
/// The half width a of 0.046 is 14 edges of the mesh, and a/R adds as much: some percent in all.
#[test]
fn a_cylinder_presses_as_hertz_has_it() {
    let outcome = solved::<2>("hertz.inp", SolveOptions::default());
    let pair = &outcome.steps[0].pairs[0];
    let (force, modulus) = (2.0 * pair.force[1].abs(), 1000.0 / 0.91);
    let (width, peak) = ((4.0 * force / (PI * modulus)).sqrt(), (force * modulus / PI).sqrt());
    let found = outcome.pressures.iter().map(|at| at.pressure).fold(0.0, f64::max);
    println!("a {width} {}, p {peak} {found}", pair.area);
    assert!((pair.area / width - 1.0).abs() < 0.03, "half width {}, Hertz {width}", pair.area);
    assert!((found / peak - 1.0).abs() < 0.03, "pressure {found}, Hertz {peak}");
}
