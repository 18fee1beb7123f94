//! Bodies that are tied.

use crate::scene::Scene;
use crate::{dot, field, flux, in_space, in_the_plane, largest, out_of, pressed};
use fmc_contact::contact::{Conductance, PairOptions};
use fmc_contact::overlap::Partner::Body;

/// They conduct wherever they are tied, also across the gap that a tie keeps, and where they have gone.
fn conducts<const D: usize>(scenes: &[Scene<D>]) {
    for scene in scenes {
        let mut contact = pressed(scene);
        contact.set_pair_options([0, 1].map(Body), Some(PairOptions::tied(0.1))).expect("a tie");
        let h = Conductance { by_pressure: vec![[0.0, 2.0], [4.0, 6.0]], by_gap: Vec::new() };
        let values = field(scene, |mesh, x| if mesh == 0 { 1.0 + x[0] } else { -x[0] });
        // At rest; pressed by 0.02 · K = 2, pulled, and shifted along the tie.
        for (by, expected) in [([0.0, 0.0], 4.0), ([0.0, -0.02], 8.0), ([0.0, 0.02], 4.0), ([0.3, 0.0], 4.0)] {
            let moved = field(scene, |mesh, _| mesh as f64);
            let shifted = |(x, moved): (&[f64; D], f64)| {
                std::array::from_fn(|i| match i {
                    0 => x[0] + moved * by[0],
                    i if i + 1 == D => x[i] + moved * by[1],
                    i => x[i],
                })
            };
            let coords: Vec<[f64; D]> = scene.coords.iter().zip(moved).map(shifted).collect();
            let found = flux(&contact, &coords, &values, &h);
            assert!((out_of(scene, &found, 0) - expected).abs() < 1e-11, "{by:?}: {}", out_of(scene, &found, 0));
            assert!(found.flux.iter().sum::<f64>().abs() < 1e-13 && dot(&values, &found.flux) > 0.0);
        }
        let linear = field(scene, |_, x| 1.0 + 2.0 * x[0]);
        assert!(largest(&flux(&contact, &scene.coords, &linear, &h).flux) < 1e-12);
    }
}

#[test]
fn tied_bodies_conduct() {
    for gap in [0.0, 0.03] {
        conducts(&in_the_plane(gap).into_iter().step_by(4).collect::<Vec<_>>());
        conducts(&in_space(gap).into_iter().step_by(7).collect::<Vec<_>>());
    }
}
