//! The law of Park, Paulino and Roesler: tractions are derivatives of its potential, and paths through both modes have their closed forms.

use crate::{held, in_space, in_the_plane, moved};
use fmc_contact::Contact;
use fmc_contact::contact::{Cohesive, Ppr, Softening};

/// Those of figure 4 of the paper (energies 100 and 200 N/m, strengths 40 and 30 MPa), in other units.
const PAPER: Ppr = Ppr { normal_shape: 5.0, shear_shape: 1.6, normal_slope: 0.1, shear_slope: 0.2 };

fn law([normal, shear]: [f64; 2], ppr: Ppr) -> Cohesive {
    let alike = Cohesive { normal_energy: normal, shear_energy: shear, ..Cohesive::new(4.0, 1.0) };
    Cohesive { shear_strength: 3.0, softening: Softening::Ppr(ppr), ..alike }
}

fn laws() -> Vec<Cohesive> {
    let late = Ppr { normal_shape: 1.5, shear_shape: 3.0, normal_slope: 0.3, shear_slope: 0.05 };
    let energies = [[0.1, 0.2], [0.2, 0.1], [0.15, 0.15]];
    energies.into_iter().flat_map(|energy| [PAPER, Ppr::default(), late].map(|ppr| law(energy, ppr))).collect()
}

/// One side of the potential, as the paper writes it (equations 20 to 28).
struct Side {
    shape: f64,
    m: f64,
    end: f64,
    factor: f64,
    missing: f64,
}

impl Side {
    /// Γ (1 − Δ/δ)^α (m/α + Δ/δ)^m + ⟨φ − φ of the other⟩.
    fn value(&self, opening: f64) -> f64 {
        let x = (opening / self.end).min(1.0);
        self.factor * (1.0 - x).powf(self.shape) * (self.m / self.shape + x).powf(self.m) + self.missing
    }
}

fn sides(law: &Cohesive) -> [Side; 2] {
    let Softening::Ppr(ppr) = law.softening else { panic!("the law ppr") };
    let energies = [law.normal_energy, law.shear_energy];
    let of = |k: usize, shape: f64, slope: f64, strength: f64| {
        let m = shape * (shape - 1.0) * slope * slope / (1.0 - shape * slope * slope);
        let [own, other] = [energies[k], energies[1 - k]];
        let end = own / strength
            * shape
            * slope
            * (1.0 - slope).powf(shape - 1.0)
            * (shape / m + 1.0)
            * (shape / m * slope + 1.0).powf(m - 1.0);
        let minus = if own > other || (own == other && k == 0) { -own } else { 1.0 };
        Side { shape, m, end, factor: minus * (shape / m).powf(m), missing: (own - other).max(0.0) }
    };
    [
        of(0, ppr.normal_shape, ppr.normal_slope, law.normal_strength),
        of(1, ppr.shear_shape, ppr.shear_slope, law.shear_strength),
    ]
}

fn potential(law: &Cohesive, [opening, sliding]: [f64; 2]) -> f64 {
    let [normal, shear] = sides(law);
    law.normal_energy.min(law.shear_energy) + normal.value(opening) * shear.value(sliding)
}

/// The derivative, by differences of the fourth order: 1e-3 of the way leaves (1e-3)⁴ and rounding of 1e-16 by 1e-3, by α and β.
fn tractions(law: &Cohesive, at: [f64; 2]) -> [f64; 2] {
    let sides = sides(law);
    [0, 1].map(|k| {
        let h = 1e-3 * at[k].min(sides[k].end - at[k]);
        let of = |by: f64| {
            let mut there = at;
            there[k] += by * h;
            potential(law, there)
        };
        (8.0 * (of(1.0) - of(-1.0)) - (of(2.0) - of(-2.0))) / (12.0 * h)
    })
}

/// Forces by area on the second body across the interface and along it, of blocks with an area of 1.
fn pulled<const D: usize>(contact: &Contact<D>, scene: &crate::Scene<D>, [opening, sliding]: [f64; 2]) -> [f64; 2] {
    let found = contact.evaluate(&coords(scene, [opening, sliding])).expect("an evaluation");
    let sum = |axis: usize| -found.forces[scene.first_node[1]..].iter().map(|f| f[axis]).sum::<f64>();
    [sum(D - 1), sum(0)]
}

fn coords<const D: usize>(scene: &crate::Scene<D>, [opening, sliding]: [f64; 2]) -> Vec<[f64; D]> {
    moved(scene, std::array::from_fn(|axis| [sliding, opening, 0.0][if axis == D - 1 { 1 } else { 2 * axis }]))
}

/// An interface in a step that has begun.
fn begun<const D: usize>(scene: &crate::Scene<D>, law: Cohesive) -> Contact<D> {
    let mut contact = held(scene, law);
    contact.begin_step(&scene.coords).expect("a step");
    contact
}

fn are_of_the_potential<const D: usize>(scene: &crate::Scene<D>, law: Cohesive) {
    let (contact, ends) = (begun(scene, law), sides(&law).map(|side| side.end));
    for x in [0.003, 0.05, 0.3, 0.6] {
        for y in [0.004, 0.1, 0.35] {
            let at = [x * ends[0], y * ends[1]];
            let (found, expected) = (pulled(&contact, scene, at), tractions(&law, at));
            for k in 0..2 {
                // What ends early is 0 where the potential would have it push.
                let off = found[k] - expected[k].max(0.0);
                assert!(off.abs() < 2e-8 * law.normal_strength, "{found:?} for {expected:?} at {x}, {y}, {law:?}");
            }
        }
    }
}

#[test]
fn tractions_are_derivatives_of_the_potential() {
    for law in laws() {
        are_of_the_potential(&in_the_plane(0.0)[0], law);
    }
    in_space(0.0).iter().for_each(|scene| are_of_the_potential(scene, laws()[0]));
    are_of_the_potential(&in_the_plane(0.0)[1], laws()[1]);
}

/// The work along a straight way, by Simpson's rule with points that are denser at both ends. Of a rise of 0.01 and an end of (1 − x)^0.5 400
/// parts leave 1e-5; of a traction that ends with a kink 200 leave (1/100)²/12 of it by the way.
fn work((contact, scene): (&Contact<2>, &crate::Scene<2>), count: usize, from: [f64; 2], to: [f64; 2]) -> f64 {
    let at = |k: usize| {
        let s = k as f64 / count as f64;
        s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)
    };
    let middle = |k: usize| 0.5 * (at(k) + at(k + 1));
    let place = |s: f64| [0, 1].map(|i| from[i] + s * (to[i] - from[i]));
    let along = |s: f64| {
        let found = pulled(contact, scene, place(s));
        found[0] * (to[0] - from[0]) + found[1] * (to[1] - from[1])
    };
    let mut last = along(at(0));
    let mut sum = 0.0;
    for k in 0..count {
        let next = along(at(k + 1));
        sum += (at(k + 1) - at(k)) / 6.0 * (last + 4.0 * along(middle(k)) + next);
        last = next;
    }
    sum
}

#[test]
fn each_mode_takes_its_strength_and_its_energy() {
    let scene = &in_the_plane(0.0)[0];
    for law in laws() {
        let contact = begun(scene, law);
        let Softening::Ppr(ppr) = law.softening else { panic!("the law ppr") };
        let modes = [
            ([1.0, 0.0], law.normal_strength, ppr.normal_slope, law.normal_energy),
            ([0.0, 1.0], law.shear_strength, ppr.shear_slope, law.shear_energy),
        ];
        for (k, (way, strength, slope, energy)) in modes.into_iter().enumerate() {
            let end = sides(&law)[k].end;
            let at = |x: f64| way.map(|part| part * x * end);
            let most = pulled(&contact, scene, at(slope))[k];
            // The peak is flat: 1e-3 beside it the traction has fallen by some 1e-6 of it.
            assert!((most - strength).abs() < 1e-10 * strength, "{most} for {strength}");
            for beside in [0.999, 1.001] {
                assert!(pulled(&contact, scene, at(beside * slope))[k] < most);
            }
            let found = work((&contact, scene), 400, [0.0; 2], at(1.0));
            assert!((found - energy).abs() < 1e-5 * energy, "{found} for {energy} in mode {k} of {law:?}");
            let told = contact.cohesive([0, 1], &coords(scene, at(1.1))).expect("bodies").expect("an interface");
            assert!((told.dissipated - energy).abs() < 1e-12 && told.stored < 1e-24, "{told:?}");
            assert!((told.broken_area - 1.0).abs() < 1e-12);
        }
    }
}

/// Opened first and then slid, and the other way round (section 5 of the paper): each leg takes what the other has left.
#[test]
fn what_breaks_first_decides_what_is_taken() {
    let scene = &in_the_plane(0.0)[0];
    for law in laws() {
        let ends = sides(&law).map(|side| side.end);
        let most = law.normal_energy.max(law.shear_energy);
        // a(x) and b(y) of the paper's potential, and what they leave of the other energy.
        let left = |k: usize, opening: f64| {
            let side = &sides(&law)[k];
            (side.value(opening) - side.missing) / (side.value(0.0) - side.missing)
        };
        let of_energy = |energy: f64, left: f64| (most * left - (most - energy)).max(0.0);
        for part in [0.05, 0.2, 1.0] {
            let opened = part * ends[0];
            let first = law.normal_energy * (1.0 - left(0, opened)) + of_energy(law.shear_energy, left(0, opened));
            let slid = part * ends[1];
            let other = law.shear_energy * (1.0 - left(1, slid)) + of_energy(law.normal_energy, left(1, slid));
            for (start, [x, y], expected) in [([opened, 0.0], ends, first), ([0.0, slid], ends, other)] {
                let end = if start[0] > 0.0 { [opened, y] } else { [x, slid] };
                let mut contact = begun(scene, law);
                let of_first = work((&contact, scene), 200, [0.0; 2], start);
                contact.commit_step(&coords(scene, start)).expect("a step");
                let of_second = work((&contact, scene), 200, start, end);
                let found = of_first + of_second;
                assert!((found - expected).abs() < 1e-4 * most, "{found} for {expected}: {start:?} of {law:?}");
            }
            if part == 0.2 && law.normal_energy != law.shear_energy {
                assert!((first - other).abs() > 0.05 * most, "{first} and {other}");
            }
        }
    }
}

/// Whatever way it goes, tractions fall along lines to the origin below the largest openings, are never more than before, and the energy that was
/// dissipated never falls; the work of a closed way is what was dissipated on it.
#[test]
fn nothing_heals_and_unloading_goes_to_the_origin() {
    let scene = &in_the_plane(0.0)[0];
    for law in laws() {
        let (mut contact, ends) = (begun(scene, law), sides(&law).map(|side| side.end));
        let mut before = 0.0;
        for (x, y) in [(0.1, 0.05), (0.02, 0.2), (0.3, 0.0), (0.0, 0.3), (0.25, 0.25), (0.4, 0.35)] {
            let at = [x * ends[0], y * ends[1]];
            contact.commit_step(&coords(scene, at)).expect("a step");
            let peak = pulled(&contact, scene, at);
            let told = contact.cohesive([0, 1], &coords(scene, at)).expect("bodies").expect("an interface");
            assert!(told.dissipated >= before, "{} after {before}", told.dissipated);
            before = told.dissipated;
            for part in [0.7, 0.2] {
                let found = pulled(&contact, scene, at.map(|one| part * one));
                assert!((0..2).all(|k| (found[k] - part * peak[k]).abs() < 1e-11 * law.normal_strength));
                let there = contact.cohesive([0, 1], &coords(scene, at.map(|one| part * one)));
                let there = there.expect("bodies").expect("an interface");
                assert!((there.dissipated - before).abs() < 1e-14);
                assert!((there.stored - part * part * told.stored).abs() < 1e-12 * law.normal_energy);
            }
        }
        // Slid until it is broken and slid back it does not hold again.
        let broken = coords(scene, [0.0, 1.01 * ends[1]]);
        contact.commit_step(&broken).expect("a step");
        let after = pulled(&contact, scene, [0.1 * ends[0], 0.1 * ends[1]]);
        assert!(after.iter().all(|traction| traction.abs() < 1e-12), "{after:?}");
        // What presses is carried by the stiffness of opening without damage.
        let pressed = pulled(&contact, scene, [-1e-3 * ends[0], 0.0])[0];
        let whole = pulled(&held(scene, law), scene, [-1e-3 * ends[0], 0.0])[0];
        assert!(pressed < 0.0 && (pressed - whole).abs() < 1e-12);
    }
}

/// Where both grow and pull, what is stored and dissipated is the potential, in one step or in many.
#[test]
fn what_is_put_in_is_the_potential() {
    let scene = &in_the_plane(0.0)[0];
    for law in laws() {
        let ends = sides(&law).map(|side| side.end);
        for steps in [1, 7] {
            let mut contact = begun(scene, law);
            for step in 1..=steps {
                let at = [0.1, 0.08].map(|part| part * f64::from(step) / f64::from(steps));
                let at = [at[0] * ends[0], at[1] * ends[1]];
                let told = contact.cohesive([0, 1], &coords(scene, at)).expect("bodies").expect("an interface");
                let (put_in, expected) = (told.stored + told.dissipated, potential(&law, at));
                assert!((put_in - expected).abs() < 1e-12, "{put_in} for {expected}: {law:?}");
                contact.commit_step(&coords(scene, at)).expect("a step");
            }
        }
    }
}

/// In the middle of a crack: what is told of it brings back the same bits, in forces and in all that follows.
#[test]
fn a_restart_goes_on_with_the_same_bits() {
    for scene in in_space(0.0) {
        let (law, ends) = (laws()[0], sides(&laws()[0]).map(|side| side.end));
        let bent = |x: f64, y: f64| -> Vec<[f64; 3]> {
            let mut all = coords(&scene, [x * ends[0], y * ends[1]]);
            let upper = scene.first_node[1];
            all[upper..].iter_mut().for_each(|node| node[2] += 0.3 * ends[0] * node[0] * node[1]);
            all
        };
        let mut contact = begun(&scene, law);
        for (x, y) in [(0.2, 0.1), (0.05, 0.3), (0.3, 0.2)] {
            contact.commit_step(&bent(x, y)).expect("a step");
        }
        let mut again = held(&scene, law);
        again.set_cohesive_history(&contact.cohesive_history().expect("a history")).expect("a history");
        again.set_damage(&contact.damage().expect("damage")).expect("damage");
        again.begin_step(&bent(0.3, 0.2)).expect("a step");
        for (x, y) in [(0.1, 0.1), (0.35, 0.15), (0.3, 0.6), (0.9, 0.9)] {
            let (one, other) = (contact.evaluate(&bent(x, y)), again.evaluate(&bent(x, y)));
            assert_eq!(one.expect("an evaluation").forces, other.expect("an evaluation").forces);
            contact.commit_step(&bent(x, y)).expect("a step");
            again.commit_step(&bent(x, y)).expect("a step");
            assert_eq!(contact.damage().expect("damage"), again.damage().expect("damage"));
            assert_eq!(contact.cohesive_history().expect("one"), again.cohesive_history().expect("one"));
        }
    }
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    use fmc_contact::contact::PairOptions;
    use fmc_contact::overlap::Partner::Body;
    let scene = &in_the_plane(0.0)[0];
    let of = |ppr: Ppr| law([0.1, 0.2], ppr);
    let plain = of(PAPER);
    for (wrong, text) in [
        (of(Ppr { normal_shape: 1.0, ..PAPER }), "normal_shape or a shear_shape"),
        (of(Ppr { shear_shape: 0.9, ..PAPER }), "normal_shape or a shear_shape"),
        (of(Ppr { normal_shape: f64::NAN, ..PAPER }), "normal_shape"),
        (of(Ppr { shear_slope: 0.0, ..PAPER }), "shear_slope"),
        (of(Ppr { normal_slope: f64::INFINITY, ..PAPER }), "normal_slope"),
        (of(Ppr { normal_slope: 0.34, ..PAPER }), "normal_slope or a shear_slope"),
        (of(Ppr { normal_slope: 1e-200, ..PAPER }), "stiffness of a cohesive interface"),
        (Cohesive { stiffness: 1e3, ..plain }, "a stiffness"),
        (Cohesive { exponent: 3.0, ..plain }, "mixed_mode_exponent"),
        (Cohesive { viscosity: 1.0, ..plain }, "a viscosity"),
        (Cohesive { normal_strength: -1.0, ..plain }, "normal_strength"),
    ] {
        let mut contact = held(scene, plain);
        let found = contact.set_pair_options([Body(0), Body(1)], Some(PairOptions::with_cohesive(wrong)));
        let found = found.expect_err("a refusal").to_string();
        assert!(found.contains(text), "{found} for {text}");
    }
    held(scene, of(Ppr { normal_slope: 1.0 / 3.0, ..PAPER }));
}
