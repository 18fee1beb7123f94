//! Integrals over what both surfaces have in common: exact for fields of the cells, else of second order.

use crate::blocks::rectangles;
use crate::scene::Scene;
use crate::{K, dot, field, flux, out_of, pressed};
use fmc_contact::contact::Conductance;
use fmc_contact::{EnergyLaw, Options};
use fmc_shapes::{Mesh, patch_quad4, rectangle_quad4, second_order};
use std::f64::consts::{PI, TAU};

/// For fields T and S: S · q = ∫ h (T_A − T_B)(S_A − S_B) dA, exact for all that cells of second order on straight faces can have.
#[test]
fn quadratic_fields_are_integrated_exactly() {
    let below = rectangles([0.0, 0.0], [1.0, 0.5], [2, 1]);
    let above = rectangle_quad4([0.0, 0.49], [1.0, 1.0], [3, 1]);
    for below in &below[2..] {
        let scene = Scene::of(&[below, &above]);
        let (t, s) = (
            field(&scene, |mesh, x| if mesh == 0 { 1.0 + x[0] * x[0] } else { x[0] }),
            field(&scene, |mesh, x| if mesh == 0 { x[0] * x[0] } else { 2.0 - x[0] }),
        );
        let found = flux(&pressed(&scene), &scene.coords, &t, &Conductance::constant(3.0));
        // ∫ (1 + x² − x)(x² − 2 + x) dx = ∫ x⁴ − 2x² + 3x − 2 dx = 1/5 − 2/3 + 3/2 − 2
        let expected = 3.0 * (0.2 - 2.0 / 3.0 + 1.5 - 2.0);
        assert!((dot(&s, &found.flux) - expected).abs() < 1e-12, "{}", dot(&s, &found.flux) - expected);
    }
}

/// Fields that no cell has, on meshes that do not match, P1 against P2: halving cells divides errors by four.
#[test]
fn errors_are_of_second_order() {
    let error = |n: usize| {
        let below = rectangle_quad4([0.0, 0.0], [1.0, 0.5], [2 * n, 1]);
        let above = second_order(&rectangle_quad4([0.0, 0.49], [1.0, 1.0], [3 * n, 1]), 9);
        let scene = Scene::of(&[&below, &above]);
        let t = field(&scene, |mesh, x| if mesh == 0 { (PI * x[0]).sin() } else { 0.0 });
        let found = flux(&pressed(&scene), &scene.coords, &t, &Conductance::constant(1.0));
        let s = field(&scene, |mesh, x| if mesh == 1 { (PI * x[0]).sin() } else { 0.0 });
        (dot(&s, &found.flux) + 0.5).abs()
    };
    let [one, two, four] = [4, 8, 16].map(error);
    assert!((one / two).log2() > 1.9 && (two / four).log2() > 1.9, "{one:e} {two:e} {four:e}");
}

/// Bars of revolution: the area is that of whole rings.
#[test]
fn axisymmetric_areas_are_rings() {
    for h in [Conductance::constant(3.0), Conductance { by_pressure: vec![[1.0, 3.0]], by_gap: vec![[0.0, 3.0]] }] {
        let below = rectangle_quad4([0.0, 0.0], [1.0, 0.5], [3, 1]);
        let above = rectangle_quad4([0.2, 0.49], [0.8, 1.0], [4, 1]);
        let scene = Scene::of(&[&below, &above]);
        let contact = scene.contact(Options { axisymmetric: true, ..Options::new(EnergyLaw::depth(K)) });
        let values = field(&scene, |mesh, x| if mesh == 0 { 5.0 } else { x[0] });
        let found = flux(&contact, &scene.coords, &values, &h);
        // ∫ 3 (5 − r) 2πr dr from 0.2 to 0.8
        let at = |r: f64| 3.0 * TAU * (2.5 * r * r - r * r * r / 3.0);
        assert!((out_of(&scene, &found, 0) - (at(0.8) - at(0.2))).abs() < 1e-12);
    }
}

/// A quarter of a ring about another one, both of second order: an interference far smaller than the height of the arcs.
#[test]
fn curved_faces_conduct_as_their_curves() {
    let ring = |from: f64, to: f64, around: usize| -> Mesh<2> {
        let straight = patch_quad4([1, around], |r, a| [r, a]);
        let bent = |[r, a]: [f64; 2]| {
            let (radius, angle) = (from + (to - from) * r, 0.5 * PI * a);
            [radius * angle.cos(), radius * angle.sin()]
        };
        second_order(&straight, 9).mapped(bent)
    };
    for (inner, outer) in [(16, 22), (32, 44)] {
        let scene = Scene::of(&[&ring(0.5, 1.0005, inner), &ring(1.0, 1.5, outer)]);
        // The pressure is K times the interference.
        let h = Conductance { by_pressure: vec![[0.0, 1.0], [0.1, 3.0]], by_gap: Vec::new() };
        let found = flux(&pressed(&scene), &scene.coords, &field(&scene, |mesh, _| 1.0 - mesh as f64), &h);
        let expected = 2.0 * 0.5 * PI;
        let off = out_of(&scene, &found, 0) / expected - 1.0;
        // Half of the area is by the interference larger: 2.5e-4.
        assert!(off.abs() < 1e-3, "{inner}: {off:e}");
    }
}

/// Of a body that is tilted a part is pressed: pieces are cut where the gap is zero, and h may have a step there.
#[test]
fn a_tilted_body_conducts_where_it_is_pressed() {
    let below = rectangle_quad4([0.0, 0.0], [1.0, 0.5], [2, 1]);
    let above = rectangle_quad4([0.0, 0.5], [1.0, 1.0], [3, 1]).mapped(|[x, y]| [x, y + 0.02 * (x - 0.4)]);
    let scene = Scene::of(&[&below, &above]);
    let h = Conductance { by_pressure: vec![[0.0, 5.0]], by_gap: vec![[0.0, 1.0], [0.5, 1.0]] };
    let found = flux(&pressed(&scene), &scene.coords, &field(&scene, |mesh, _| mesh as f64), &h);
    // Half along either face; at both ends of the upper one 0.02 times the gap lies beside the lower one.
    let length = 0.5 * (1.0 + 0.02f64.hypot(1.0));
    let expected = (5.0 * 0.4 + 0.6) * length - 0.5 * 0.02 * (5.0 * 0.008 + 0.012);
    assert!(
        (out_of(&scene, &found, 1) / expected - 1.0).abs() < 1e-6,
        "{}",
        out_of(&scene, &found, 1) / expected - 1.0
    );
}
