//! The energy of a local law by brute force: lines along the normal on a fine raster, on each of them the places that lie in
//! both bodies, by membership of points alone. Nothing here knows facets at the ends of spans, patches or clipping.
//!
//! Bodies are their own mirror images about the normal, so that the mean normal of the contact is known beforehand.

use crate::halfspaces::{area_vector, dot};
use crate::scene::Scene;
use crate::scene::table::{exactly, local_laws, uncorrected};
use fmc_contact::{Contact, EnergyLaw};
use fmc_shapes::{
    Diagonals, Mesh, Splitmix, ball_tet4, coned, cuboid_surface, cuboid_tet4, disc_tri3, fan_tri3, polygon,
    random_rotation, rectangle_tri3,
};

/// A mesh of simplices as sets of half-spaces n·x ≤ c.
struct Solid<const D: usize>(Vec<Vec<([f64; D], f64)>>);

impl<const D: usize> Solid<D> {
    fn of(mesh: &Mesh<D>) -> Self {
        let planes = |cell: &[u32]| {
            let corners: Vec<[f64; D]> = cell.iter().map(|&node| mesh.coords[node as usize]).collect();
            assert_eq!(corners.len(), D + 1);
            let plane = |k: usize| {
                let others: Vec<[f64; D]> = (0..=D).filter(|&c| c != k).map(|c| corners[c]).collect();
                let face: [[f64; D]; D] = others.try_into().unwrap();
                let (n, level) = (area_vector(&face), dot(&area_vector(&face), &face[0]));
                if dot(&n, &corners[k]) <= level { (n, level) } else { (n.map(|n| -n), -level) }
            };
            (0..=D).map(plane).collect()
        };
        Self(mesh.cells().map(planes).collect())
    }

    /// With a margin for rounding, so that a line in a face between two cells lies in either.
    fn holds(&self, x: &[f64; D]) -> bool {
        self.0.iter().any(|planes| planes.iter().all(|(n, level)| dot(n, x) <= *level + 1e-13))
    }
}

/// Least and largest of n·x over the nodes of both meshes that both reach.
fn common_range<const D: usize>(meshes: [&Mesh<D>; 2], n: &[f64; D]) -> [f64; 2] {
    let ranges = meshes.map(|mesh| {
        let places = mesh.coords.iter().map(|x| dot(n, x));
        places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], t| [low.min(t), high.max(t)])
    });
    [ranges[0][0].max(ranges[1][0]), ranges[0][1].min(ranges[1][1])]
}

/// Steps along a line; what is thinner than the common range by so much may be missed.
const STEPS: usize = 100;

/// Lengths of the places of one line that lie in both bodies, each closed by bisection to 2⁻⁴⁰ of a step.
fn lengths<const D: usize>(inside: impl Fn(f64) -> bool, [low, high]: [f64; 2]) -> Vec<f64> {
    let at = |step: usize| low + (high - low) * (step as f64) / STEPS as f64;
    let border = |mut from: f64, mut to: f64| {
        let is_in = inside(from);
        for _ in 0..40 {
            let middle = 0.5 * (from + to);
            if inside(middle) == is_in { from = middle } else { to = middle }
        }
        0.5 * (from + to)
    };
    let (mut lengths, mut entered) = (Vec::new(), inside(low).then_some(low));
    for step in 1..=STEPS {
        let t = at(step);
        match (entered, inside(t)) {
            (None, true) => entered = Some(border(at(step - 1), t)),
            (Some(from), false) => {
                lengths.push(border(at(step - 1), t) - from);
                entered = None;
            }
            _ => {}
        }
    }
    lengths.extend(entered.map(|from| high - from));
    lengths
}

/// Lines through the middles of the cells of a raster across the last axis, so many a side, within ranges on the others:
/// `visit(cell, lengths of the places in both bodies)`, a cell being its numbers along the axes.
fn cast<const D: usize>(
    solids: &[Solid<D>; 2],
    axes: &[[f64; D]; D],
    range: &[[f64; 2]; D],
    count: usize,
    mut visit: impl FnMut([usize; D], Vec<f64>),
) {
    for line in 0..count.pow(D as u32 - 1) {
        let cell = std::array::from_fn(|axis| line / count.pow(axis as u32) % count);
        let across =
            |axis: usize| range[axis][0] + (range[axis][1] - range[axis][0]) * (cell[axis] as f64 + 0.5) / count as f64;
        let point = |t: f64| -> [f64; D] {
            let along = |axis: usize| if axis == D - 1 { t } else { across(axis) };
            std::array::from_fn(|i| (0..D).map(|axis| along(axis) * axes[axis][i]).sum())
        };
        let found = lengths::<D>(|t| solids.iter().all(|solid| solid.holds(&point(t))), range[D - 1]);
        if !found.is_empty() {
            visit(cell, found);
        }
    }
}

/// Where both bodies are, along every axis; across the lines to a cell of a coarse raster.
fn common<const D: usize>(meshes: [&Mesh<D>; 2], solids: &[Solid<D>; 2], axes: &[[f64; D]; D]) -> [[f64; 2]; D] {
    let range = axes.map(|axis| common_range(meshes, &axis));
    let (count, mut met) = (24, [[usize::MAX, 0]; D]);
    cast(solids, axes, &range, count, |cell, _| {
        (0..D).for_each(|axis| met[axis] = [met[axis][0].min(cell[axis]), met[axis][1].max(cell[axis])]);
    });
    std::array::from_fn(|axis| {
        let [low, high] = range[axis];
        let at = |cell: usize| low + (high - low) * cell as f64 / count as f64;
        let [first, last] = met[axis];
        if axis == D - 1 { [low, high] } else { [at(first.saturating_sub(1)), at((last + 2).min(count))] }
    })
}

/// Σ h^(D−1) ψ(L), and whether a line had two spans.
fn by_raster<const D: usize>(meshes: [&Mesh<D>; 2], axes: &[[f64; D]; D], law: EnergyLaw, count: usize) -> (f64, bool) {
    let solids = meshes.map(Solid::of);
    let range = common(meshes, &solids, axes);
    let (mut energy, mut is_parted) = (0.0, false);
    cast(&solids, axes, &range, count, |_, found| {
        energy += found.iter().map(|&length| law.energy(length)).sum::<f64>();
        is_parted |= found.len() > 1;
    });
    let cell: f64 = range[..D - 1].iter().map(|[low, high]| (high - low) / count as f64).product();
    (energy * cell, is_parted)
}

/// Both bodies turned as one; the last axis, along which they are pressed together, goes along.
fn energies_agree<const D: usize>(a: &Mesh<D>, b: &Mesh<D>, counts: [usize; 2], spacing: f64, has_two_spans: bool) {
    for seed in 0..3 {
        let r = random_rotation::<D>(seed);
        let place: [f64; D] = std::array::from_fn(|_| Splitmix::new(seed).between(-1.0, 1.0));
        let put = |mesh: &Mesh<D>| mesh.clone().rotated_by(r).translated(place);
        let axes: [[f64; D]; D] = std::array::from_fn(|axis| std::array::from_fn(|i| r[i][axis]));
        let (a, b) = (put(a), put(b));
        let scene = Scene::of(&[&a, &b]);
        for law in local_laws(1.0) {
            let [coarse, fine] = counts.map(|count| by_raster([&a, &b], &axes, law, count));
            assert_eq!(fine.1, has_two_spans);
            // Midpoints err by h² and, at walls along the lines, by h: by no more than what halving changes.
            let raster = 2.0 * (fine.0 - coarse.0).abs() / fine.0;
            // The mean normal is sampled and rounded, known to some hundredths, which counts twice where bodies are their
            // own mirror images. What is no polynomial is integrated by points in every common piece of two facets: that
            // is good to a percent on facets as wide as these.
            let is_polynomial = law == local_laws(1.0)[0];
            let quadrature = if is_polynomial { 1e-3 } else { 2e-2 };
            let exact: Contact<D> = scene.contact(exactly(law));
            let found = exact.evaluate(&scene.coords).unwrap().energy;
            let off = (found / fine.0 - 1.0).abs();
            println!("{law:?}, seed {seed}: exact is off by {off:.1e}, the raster by {raster:.1e}");
            assert!(
                raster < 5e-3 && off < raster + quadrature,
                "seed {seed}, {law:?}: exact is off by {off:.1e} ± {raster:.1e}"
            );
            let found = scene.evaluate(uncorrected(law, spacing, seed)).energy;
            let off = (found / fine.0 - 1.0).abs();
            // A line more or less at the rim, where lengths begin with 0, of some hundreds across.
            assert!(off < raster + 3e-3, "seed {seed}, {law:?}: lines are off by {off:.1e} ± {raster:.1e}");
        }
    }
}

fn block() -> Mesh<2> {
    rectangle_tri3([-1.0, -1.0], [1.0, 0.0], [7, 4], Diagonals::Alternating)
}

#[test]
fn of_a_disc_on_a_block() {
    energies_agree(&block(), &disc_tri3(0.6, 24).translated([0.0, 0.5]), [400, 800], 5e-4, false);
}

#[test]
fn of_two_discs() {
    energies_agree(&disc_tri3(0.5, 24), &disc_tri3(0.5, 24).translated([0.0, 0.9]), [400, 800], 2e-4, false);
}

/// An hourglass on its head, most of it in the block: lines beside its neck meet it twice.
#[test]
fn of_an_hourglass_in_a_block() {
    let outline =
        [[-0.4, -0.5], [0.4, -0.5], [0.1, -0.3], [0.4, -0.15], [0.6, 0.5], [-0.6, 0.5], [-0.4, -0.15], [-0.1, -0.3]];
    let hourglass = fan_tri3([0.0, -0.3], &polygon(&outline, 1));
    energies_agree(&block(), &hourglass, [600, 1_200], 2e-4, true);
}

#[test]
fn of_a_ball_on_a_block() {
    let block = cuboid_tet4([-0.7, -0.7, -0.5], [0.7, 0.7, 0.0], [2, 2, 1]);
    let ball = ball_tet4(0.6, 1, 1).translated([0.0, 0.0, 0.5]);
    energies_agree(&block, &ball, [40, 80], 4e-3, false);
}

/// A blunt pyramid with its tip in a block: steeper flanks are patches of their own.
#[test]
fn of_a_pyramid_in_a_block() {
    let block = cuboid_tet4([-0.7, -0.7, -0.5], [0.7, 0.7, 0.0], [3, 2, 1]);
    let cube = coned(&cuboid_surface([-1.0; 3], [1.0; 3], [1; 3]), [0.0; 3], 1);
    let pyramid = cube.mapped(|[x, y, z]| {
        let wide = if z < -0.5 { 0.05 } else { 0.5 };
        [wide * x, wide * y, if z < -0.5 { -0.12 } else { 0.05 + 0.1 * z }]
    });
    energies_agree(&block, &pyramid, [40, 80], 4e-3, false);
}
