//! A scene from a seed.

use crate::scene::Scene;
use fmc_shapes::{
    Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_pyramid5, cuboid_tet4, cuboid_wedge6, random_rotation,
    rectangle_quad4, rectangle_tri3, second_order,
};

/// Two blocks in the positions that hurt.
pub(crate) struct Drawn<const D: usize> {
    /// At the reference.
    pub(crate) scene: Scene<D>,
    /// Where the forces are asked for.
    pub(crate) coords: Vec<[f64; D]>,
    /// The size of the lower block.
    pub(crate) size: f64,
    /// How far coordinates are rounded, beside the size.
    pub(crate) rounding: f64,
    /// Whether all cells are of first order.
    pub(crate) is_straight: bool,
    pub(crate) words: String,
}

struct Random(Splitmix);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        (self.0.bits() % count as u64) as usize
    }

    fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.between(low, high)
    }
}

/// Names and meshes of one block.
type Blocks<const D: usize> = fn(usize, [f64; D], [f64; D], [usize; D]) -> (&'static str, Mesh<D>);

fn plane_block(kind: usize, min: [f64; 2], max: [f64; 2], cells: [usize; 2]) -> (&'static str, Mesh<2>) {
    let triangles = |diagonals| rectangle_tri3(min, max, cells, diagonals);
    match kind % 6 {
        0 => ("Tri3", triangles(Diagonals::Alternating)),
        1 => ("Tri3", triangles(Diagonals::Same)),
        2 => ("Tri6", second_order(&triangles(Diagonals::Same), 6)),
        3 => ("Quad9", second_order(&rectangle_quad4(min, max, cells), 9)),
        _ => ("Quad4", rectangle_quad4(min, max, cells)),
    }
}

fn solid_block(kind: usize, min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> (&'static str, Mesh<3>) {
    match kind % 8 {
        0 | 1 => ("Tet4", cuboid_tet4(min, max, cells)),
        2 => ("Wedge6", cuboid_wedge6(min, max, cells)),
        3 => ("Pyramid5", cuboid_pyramid5(min, max, cells)),
        4 => ("Tet10", second_order(&cuboid_tet4(min, max, cells), 10)),
        5 => ("Hex20", second_order(&cuboid_hex8(min, max, cells), 20)),
        _ => ("Hex8", cuboid_hex8(min, max, cells)),
    }
}

pub(crate) fn in_the_plane(seed: u64) -> Drawn<2> {
    draw(seed, plane_block)
}

pub(crate) fn in_space(seed: u64) -> Drawn<3> {
    draw(seed, solid_block)
}

/// How deep the upper block is in the lower one, in sizes; most of it is nearly nothing, or nothing.
const DEPTHS: [f64; 12] = [0.0, 0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1e-2, 0.1, 0.25, 0.5, 0.8];
/// What moves each node, in sizes.
const NOISES: [f64; 10] = [0.0, 0.0, 0.0, 1e-16, 1e-15, 1e-13, 1e-9, 1e-6, 1e-3, 0.005];

fn draw<const D: usize>(seed: u64, block: Blocks<D>) -> Drawn<D> {
    let mut random = Random(Splitmix::new(seed.wrapping_mul(0x9E37_79B9).wrapping_add(D as u64)));
    let cells = |random: &mut Random| std::array::from_fn(|_| 1 + random.below(3));
    let (of_lower, of_upper) = (cells(&mut random), cells(&mut random));
    let (first, lower) = block(random.below(24), [0.0; D], [1.0; D], of_lower);
    // Walls of the two blocks are in one plane for most draws, and lines of both grids where cells of both divide a sixth.
    let is_flush = random.below(4) > 0;
    let extent: [f64; D] = std::array::from_fn(|_| match is_flush {
        true => random.one_of(&[1.0, 1.0, 0.5, 2.0, 1.0 / 3.0, 1.5]),
        false => random.between(0.3, 1.7),
    });
    let (second, upper) = block(random.below(24), [0.0; D], extent, of_upper);
    let depth = random.one_of(&DEPTHS);
    let shift: [f64; D] = std::array::from_fn(|axis| match (axis + 1 == D, is_flush) {
        (true, _) => 1.0 - depth,
        (_, true) => random.one_of(&[0.0, 0.0, 0.5, 1.0 / 3.0, 1.0 / 6.0, -0.5, 1.0 - 1e-15]),
        (_, false) => random.between(-0.9, 0.9),
    });
    let mut scene = Scene::of(&[&lower, &upper.translated(shift)]);
    let noise = random.one_of(&NOISES);
    let noisy = |random: &mut Random, coords: &[[f64; D]]| -> Vec<[f64; D]> {
        coords.iter().map(|x| x.map(|x| x + noise * random.between(-1.0, 1.0))).collect()
    };
    // Half of the bodies are made so, half of them move so after they were made.
    if random.below(2) == 0 {
        scene.coords = noisy(&mut random, &scene.coords);
    }
    let mut coords = noisy(&mut random, &scene.coords);
    let (turn, unit, away) = place(&mut random, seed);
    let put = |x: &mut [f64; D]| {
        *x = std::array::from_fn(|i| {
            let turned = turn.map_or(x[i], |turn: [[f64; D]; D]| (0..D).map(|j| turn[i][j] * x[j]).sum());
            unit * (turned + away * [1.0, -0.7, 0.3][i])
        });
    };
    scene.coords.iter_mut().for_each(put);
    coords.iter_mut().for_each(put);
    let order = |name: &str| !["Tri6", "Quad9", "Tet10", "Hex20"].contains(&name);
    Drawn {
        scene,
        coords,
        size: unit,
        rounding: f64::EPSILON * (2.0 + away),
        is_straight: order(first) && order(second),
        words: format!(
            "{first} on {second}, {depth:e} deep, noise {noise:e}{}, unit {unit:e}, {away:e} away{}",
            if turn.is_some() { ", turned" } else { "" },
            if is_flush { ", flush" } else { "" },
        ),
    }
}

/// Turned or along the axes, in this unit, so many sizes away. A million sizes away coordinates are rounded to 1e-10: of triangles and
/// tetrahedra whose corners all lie on the surface, depths that are equal but for that are taken for equal, and near the origin they are not.
fn place<const D: usize>(random: &mut Random, seed: u64) -> (Option<[[f64; D]; D]>, f64, f64) {
    let turn = (random.below(2) == 0).then(|| random_rotation::<D>(seed));
    (turn, random.one_of(&[1.0, 1.0, 1e-6, 1e-3, 1e3, 1e6]), random.one_of(&[0.0, 0.0, 0.0, 1.0, 1e3]))
}
