//! Blocks cut from one grid: every wall of one lies in a wall of the other, and faces in contact may lie in inner faces
//! of the other's cells. Coordinates carry noise from below rounding to 1e-4.
//!
//! What is asked is volume and force to 1e-9 and 20 times the noise. The force across walls that are flush is anything
//! between none and that of the whole strip, and is not asked for; but forces add up to zero under the law "volume".

use crate::scene::table::{by_laws, local_laws};
use crate::scene::{Scene, exact, fibers};
use fmc_contact::contact::TangentPart;
use fmc_contact::{EnergyLaw, Estimator, FiberOptions, Obstacle, Options, PenetrationLaw, Pose, Shape, Warning};
use fmc_shapes::{
    Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_surface, cuboid_tet4, polygon, rectangle_quad4, rectangle_tri3,
};

/// Noise from this power of ten to this one.
const NOISE: [[i32; 2]; 8] =
    [[-17, -16], [-16, -15], [-15, -14], [-14, -13], [-13, -12], [-12, -10], [-10, -8], [-8, -4]];

/// How deep a block of unit size lies in the other; a quarter is one cell of the grid.
const DEPTHS: [f64; 3] = [0.25, 0.1, 0.01];

const DRAWS: usize = 12;

/// Error of the default lines.
const SAMPLED: f64 = 2e-2;

/// Draws of noise of all sizes.
struct Noise {
    random: Splitmix,
    size: f64,
}

impl Noise {
    fn draw(random: Splitmix, [from, to]: [i32; 2]) -> Self {
        let mut random = random;
        let size = 10f64.powf(random.between(from.into(), to.into()));
        Self { random, size }
    }

    fn on<const D: usize>(&mut self, mesh: &Mesh<D>) -> Mesh<D> {
        let mut mesh = mesh.clone();
        mesh.coords.iter_mut().flatten().for_each(|x| *x += self.random.between(-self.size, self.size));
        mesh
    }

    /// Error that is allowed where this is the sampling error.
    fn allows(&self, sampled: f64) -> f64 {
        1e-9 + 20.0 * self.size + sampled
    }
}

/// Calls `visit` for every draw of noise.
fn for_every_draw(mut visit: impl FnMut(Noise)) {
    for (n, range) in NOISE.into_iter().enumerate() {
        for draw in 0..DRAWS {
            visit(Noise::draw(Splitmix::new((n * DRAWS + draw) as u64), range));
        }
    }
}

fn sunk<const D: usize>(mesh: &Mesh<D>, depth: f64) -> Mesh<D> {
    mesh.clone().mapped(|mut x| {
        x[D - 1] -= depth;
        x
    })
}

/// Force by unit area of blocks that overlap by `depth`.
fn pressure(law: &EnergyLaw, depth: f64) -> f64 {
    match *law {
        EnergyLaw::Volume { stiffness, .. } => stiffness,
        EnergyLaw::Fiber(PenetrationLaw { stiffness, .. }) => stiffness * depth,
        _ => unreachable!("a law of the tests"),
    }
}

/// Lines by the law "volume" alone: under the law "fiber" single ones along walls decide the force.
fn options_with(estimator: Options) -> Vec<Options> {
    let all = by_laws([estimator], &[EnergyLaw::volume(1.0), local_laws(1.0)[0]]);
    all.into_iter().filter(|options| options.estimator == Estimator::Exact || !options.law.is_fiber()).collect()
}

/// Unit blocks, the second on the first: one block by one, or divided into two bodies side by side.
fn stacked<const D: usize>(lower: &Mesh<D>, uppers: &[Mesh<D>], estimator: Options, sampled: f64) {
    for depth in DEPTHS {
        for_every_draw(|mut noise| {
            let uppers: Vec<Mesh<D>> = uppers.iter().map(|mesh| noise.on(&sunk(mesh, depth))).collect();
            let lower = noise.on(lower);
            let scene = Scene::of(&std::iter::once(&lower).chain(&uppers).collect::<Vec<_>>());
            for options in options_with(estimator) {
                // Twice as deep as a quarter of its width, a half has its side taken for a patch by the law "fiber".
                if options.law.is_fiber() && uppers.len() > 1 {
                    continue;
                }
                let found = scene.evaluate(options);
                let expected = pressure(&options.law, depth);
                let allowed = noise.allows(sampled * depth);
                // Pairs of blocks that touch side by side overlap by as much as the noise.
                assert!((found.volume - depth).abs() <= allowed, "V {} for {depth}, {:e}", found.volume, noise.size);
                let force: f64 = (1..=uppers.len()).map(|mesh| found.bodies[mesh].force[D - 1]).sum();
                let allowed = noise.allows(sampled) / depth;
                assert!((force / expected - 1.0).abs() <= allowed, "{options:?} {depth} {:e}: {force}", noise.size);
                // Walls that are parallel to the lines but for noise carry forces that do not add up to zero.
                if !options.law.is_fiber() {
                    let is_unbalanced = |warning: &Warning| matches!(warning, Warning::Unbalanced { .. });
                    assert!(!found.warnings.iter().any(is_unbalanced), "{:e}: {:?}", noise.size, found.warnings);
                }
            }
        });
    }
}

/// On a rigid block in the place of the lower one, and on the plane that it ends in.
fn on_obstacles<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) {
    let polytope = Shape::Polytope { points: lower.coords.clone(), facets: lower.facets() };
    for shape in [polytope, Shape::HalfSpace] {
        for depth in DEPTHS {
            for_every_draw(|mut noise| {
                let scene = Scene::of(&[&noise.on(&sunk(upper, depth))]);
                for options in options_with(exact()) {
                    let mut contact = scene.contact(options);
                    contact.add_obstacle(Obstacle { shape: shape.clone(), pose: Pose::at([0.0; D]) }).unwrap();
                    let found = contact.evaluate(&scene.coords).unwrap();
                    assert!((found.volume - depth).abs() <= noise.allows(0.0), "{shape:?}: {}", found.volume);
                    let (expected, force) = (pressure(&options.law, depth), found.bodies[0].force[D - 1]);
                    assert!((force / expected - 1.0).abs() <= noise.allows(0.0) / depth, "{shape:?}: {force}");
                }
            });
        }
    }
}

/// [0, 1]² below, two halves above, by this mesher.
fn in_2d(mesh: impl Fn([f64; 2], [f64; 2], [usize; 2]) -> Mesh<2>, estimator: Options, sampled: f64) {
    let lower = mesh([0.0, -1.0], [1.0, 0.0], [4, 4]);
    stacked(&lower, &[mesh([0.0; 2], [1.0; 2], [4, 4])], estimator, sampled);
    stacked(&lower, &[mesh([0.0; 2], [0.5, 1.0], [2, 4]), mesh([0.5, 0.0], [1.0; 2], [2, 4])], estimator, sampled);
}

fn in_3d(mesh: impl Fn([f64; 3], [f64; 3], [usize; 3]) -> Mesh<3>, estimator: Options, sampled: f64) {
    let lower = mesh([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [4; 3]);
    stacked(&lower, &[mesh([0.0; 3], [1.0; 3], [4; 3])], estimator, sampled);
    let halves = [mesh([0.0; 3], [0.5, 1.0, 1.0], [2, 4, 4]), mesh([0.5, 0.0, 0.0], [1.0; 3], [2, 4, 4])];
    stacked(&lower, &halves, estimator, sampled);
}

fn triangles(low: [f64; 2], high: [f64; 2], divisions: [usize; 2]) -> Mesh<2> {
    rectangle_tri3(low, high, divisions, Diagonals::Alternating)
}

#[test]
fn quadrilaterals_and_triangles() {
    in_2d(rectangle_quad4, exact(), 0.0);
    in_2d(triangles, exact(), 0.0);
    in_2d(rectangle_quad4, fibers(FiberOptions::default()), SAMPLED);
}

#[test]
fn hexahedra() {
    in_3d(cuboid_hex8, exact(), 0.0);
}

#[test]
fn tetrahedra() {
    in_3d(cuboid_tet4, exact(), 0.0);
}

#[test]
fn surfaces_without_cells() {
    in_3d(cuboid_surface, exact(), 0.0);
}

#[test]
fn lines_in_3d() {
    in_3d(cuboid_tet4, fibers(FiberOptions::default()), SAMPLED);
}

#[test]
fn rigid_blocks_and_planes() {
    let lower = polygon(&[[0.0, -1.0], [1.0, -1.0], [1.0, 0.0], [0.0, 0.0]], 4);
    on_obstacles(&lower, &triangles([0.0; 2], [1.0; 2], [4, 4]));
    let lower = cuboid_surface([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [4; 3]);
    on_obstacles(&lower, &cuboid_hex8([0.0; 3], [1.0; 3], [4; 3]));
}

/// The force jumps where faces lie flush: a tangent that is returned is symmetric all the same.
#[test]
fn tangents_are_symmetric_where_faces_lie_flush() {
    let law = EnergyLaw::Volume { stiffness: 1.0, exponent: 2.0 };
    let cube = cuboid_hex8([0.0; 3], [1.0; 3], [1; 3]);
    for by in [[0.5, 0.0, 0.25], [0.5, 0.25, 0.25], [0.75, 0.0, 0.25], [0.5, 1e-9, 0.25], [0.0, 0.0, 0.5]] {
        let scene = Scene::of(&[&cube, &cube.clone().translated(by)]);
        let contact = scene.contact(Options { law, ..exact() });
        let tangent = contact.tangent(&scene.coords, TangentPart::Full).unwrap();
        let mut matrix = vec![[0.0; 48]; 48];
        tangent.triplets().for_each(|(row, col, value)| matrix[row][col] += value);
        let largest = matrix.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        for row in 0..48 {
            for col in 0..row {
                let off = (matrix[row][col] - matrix[col][row]).abs();
                assert!(off <= 1e-9 * largest, "{by:?}: {off:e} of {largest:e}");
            }
        }
    }
}
