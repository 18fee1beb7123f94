//! Moments from the facets beside those from all parts of pieces of one body inside those of the other.

use super::cell_integrals::Products;
use super::cell_pieces::CellPieces;
use super::deep_bodies::DeepBodies;
use super::inside_moments::Enclosed;
use super::piece_moments::Moments;
use crate::configuration::Configuration;
use crate::depth_field::DepthField;
use crate::geometry::{Bodies, CellBlock, CellType, Surface, Weighting};
use crate::overlap::depth::integral::DepthRequest;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::region::Region;
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::overlap::pair::sides::{Counterpart, Pair};
use crate::ranks::Sharing;
use fmc_shapes::{
    Diagonals, Mesh, Splitmix, ball_tet4, cuboid_hex8, cuboid_pyramid5, cuboid_tet4, cuboid_wedge6, random_polygon,
    random_polyhedron, random_rotation, rectangle_quad4, rectangle_tri3,
};
use std::sync::OnceLock;

/// How moments compare: the largest difference by the measure of the piece, and numbers of pieces.
#[derive(Clone, Copy, Debug, Default)]
struct Compared {
    difference: f64,
    overlapped: usize,
    /// Those that are found part by part.
    doubtful: usize,
}

impl Compared {
    fn and(self, other: Self) -> Self {
        Self {
            difference: self.difference.max(other.difference),
            overlapped: self.overlapped + other.overlapped,
            doubtful: self.doubtful + other.doubtful,
        }
    }

    fn look_at<const D: usize>(&mut self, enclosed: &Enclosed<D>, moments: &[[f64; 4]], doubtful: &[bool]) {
        for (number, (piece, moments)) in enclosed.pieces.pieces.iter().zip(moments).enumerate() {
            let exact: [f64; 4] = enclosed.part_by_part(number);
            let largest = exact.iter().zip(moments).fold(0.0f64, |most, (m, n)| most.max((m - n).abs()));
            self.difference = self.difference.max(largest / piece.measure);
            self.overlapped += usize::from(exact.iter().any(|m| *m != 0.0));
            self.doubtful += usize::from(doubtful[number]);
        }
    }
}

type Bodied<'a, const D: usize> = (CellType, &'a Mesh<D>);

/// Calls `work` with a pair of bodies of cells, the second of which is the first where there is no other.
fn with_bodies<const D: usize, T>(
    bodies: &[Bodied<D>],
    moved: impl Fn(&[f64; D]) -> [f64; D],
    clearance: f64,
    work: impl FnOnce(&DeepBodies<D>) -> T,
) -> T {
    let mut coords = Vec::new();
    let mut conns = Vec::new();
    let mut ids = Vec::new();
    for (body, (_, mesh)) in bodies.iter().enumerate() {
        conns.push(mesh.conn.iter().map(|n| n + coords.len() as u32).collect::<Vec<u32>>());
        coords.extend_from_slice(&mesh.coords);
        ids.extend(vec![body as i64; mesh.cell_count()]);
    }
    let blocks: Vec<CellBlock> =
        bodies.iter().zip(&conns).map(|((cell_type, _), conn)| CellBlock { cell_type: *cell_type, conn }).collect();
    let surface = Surface::from_cells(&coords, &blocks, Bodies::Ids(&ids)).expect("a valid mesh");
    let field = DepthField::new(&surface, None, Weighting::Plain, None, &|| ()).expect("cells");
    let coords: Vec<[f64; D]> = coords.iter().map(moved).collect();
    let mut configuration = Configuration::new();
    configuration.update(&surface, &coords, false, false).expect("finite coordinates");
    let other = match bodies.len() {
        1 => Counterpart::Itself,
        _ => Counterpart::Facets(configuration.body(&surface, 1)),
    };
    let pair = Pair {
        partners: [Partner::Body(0), Partner::Body(bodies.len() - 1)],
        a: configuration.body(&surface, 0),
        counterpart: other,
        pose: None,
        surface: &surface,
        coords: &coords,
        depth: Some(&field),
        clearance,
        tied: None,
        weighting: Weighting::Plain,
        sharing: Sharing::Alone(None),
        region: OnceLock::new(),
    };
    let request = DepthRequest { second: SecondDerivative::No, obstacle_node: 0, points: false };
    work(&DeepBodies::new(&pair, &request).expect("bodies of cells"))
}

/// The moments of two bodies.
fn compared<const D: usize>(a: Bodied<D>, b: Bodied<D>, clearance: f64) -> Compared {
    with_bodies(
        &[a, b],
        |x| *x,
        clearance,
        |bodies| {
            let Some(region) = bodies.pair.region().expect("a region") else { return Compared::default() };
            let Counterpart::Facets(other) = &bodies.pair.counterpart else { panic!("two bodies") };
            let bounds = bodies.pair.bounds(region);
            let [of_a, of_b] = [0, 1].map(|which| bodies.pieces(which, region, Some(bounds)));
            let mut compared = Compared::default();
            for (which, pieces, others, side) in [(0, &of_a, &of_b, other), (1, &of_b, &of_a, &bodies.pair.a)] {
                let (_, (shares, doubtful)) = bodies.facets(
                    side,
                    (&region.facets[1 - which], bounds),
                    (which == 0, false),
                    pieces,
                    region.aabb.rounding(),
                );
                let enclosed = Enclosed { bodies, pieces, side, other: others, bounds, is_own: false };
                look(&enclosed, shares, &doubtful, &mut compared);
            }
            compared
        },
    )
}

/// Those of a body with itself where it is moved.
fn compared_own<const D: usize>(a: Bodied<D>, moved: impl Fn(&[f64; D]) -> [f64; D]) -> Compared {
    with_bodies(&[a], moved, 0.0, |bodies| {
        let side = &bodies.pair.a;
        let region = Region::new(side.aabb, [(0..side.facets.len() as u32).collect(), Vec::new()]);
        let (all, bounds) = (bodies.pieces(0, &region, None), bodies.pair.bounds(&region));
        let facets = (&region.facets[0][..], bounds);
        let (_, (shares, doubtful)) = bodies.facets(side, facets, (false, true), &all, side.aabb.rounding());
        let enclosed = Enclosed { bodies, pieces: &all, side, other: &all, bounds, is_own: true };
        let mut compared = Compared::default();
        look(&enclosed, shares, &doubtful, &mut compared);
        compared
    })
}

fn look<const D: usize>(
    enclosed: &Enclosed<D>,
    shares: Vec<Vec<(u32, [f64; 4])>>,
    doubtful: &[Vec<u32>],
    compared: &mut Compared,
) {
    let is_doubtful = enclosed.doubtful(doubtful);
    let moments = enclosed.moments(shares.into_iter().flatten(), doubtful);
    compared.look_at(enclosed, &moments, &is_doubtful);
}

/// A mesh of this number, turned at random, as large as 1 or so, with the type of its cells.
fn body(number: u64) -> (CellType, Mesh<3>) {
    let low = [-0.5; 3];
    let inner = |x: &[f64; 3]| x.iter().all(|x| x.abs() < 0.49);
    let (cell_type, mesh) = match number % 7 {
        0 => (CellType::Tet4, cuboid_tet4(low, [0.5; 3], [2, 3, 4])),
        1 => (CellType::Hex8, cuboid_hex8(low, [0.5; 3], [3, 2, 2])),
        2 => (CellType::Wedge6, cuboid_wedge6(low, [0.5; 3], [2, 2, 3])),
        3 => (CellType::Pyramid5, cuboid_pyramid5(low, [0.5; 3], [2, 2, 2])),
        4 => (CellType::Tet4, random_polyhedron(1, 0.6, 0.4, 2, number)),
        5 => (CellType::Tet4, ball_tet4(0.55, 1, 3)),
        _ => (CellType::Hex8, cuboid_hex8(low, [0.5; 3], [2, 2, 2]).skewed(0.2)),
    };
    (cell_type, mesh.jittered(0.1, number, inner))
}

fn flat(number: u64) -> (CellType, Mesh<2>) {
    let (low, high) = ([-0.5; 2], [0.5; 2]);
    match number % 3 {
        0 => (CellType::Tri3, rectangle_tri3(low, high, [4, 3], Diagonals::Same)),
        1 => (CellType::Quad4, rectangle_quad4(low, high, [3, 4])),
        _ => (CellType::Tri3, random_polygon(9, 0.6, 0.4, number)),
    }
}

/// Bodies turned and shifted at random: nothing is in doubt.
#[test]
fn in_any_position() {
    let mut random = Splitmix::new(5);
    let mut all = [Compared::default(); 2];
    for scene in 0..42 {
        let [(type_a, a), (type_b, b)] = [body(scene), body(scene / 6)];
        let offset = [0; 3].map(|_| random.between(-0.6, 0.6));
        let b = b.rotated_by(random_rotation(scene)).translated(offset);
        all[0] = all[0].and(compared((type_a, &a), (type_b, &b), 0.0));
        let [(type_a, a), (type_b, b)] = [flat(scene), flat(scene / 3)];
        let b = b.rotated_by(random_rotation(scene)).translated([offset[0], offset[1]]);
        all[1] = all[1].and(compared((type_a, &a), (type_b, &b), 0.0));
    }
    for compared in all {
        assert!(compared.difference < 3e-14 && compared.overlapped > 1_000, "{compared:?}");
        assert!(compared.doubtful * 1_000 < compared.overlapped, "{compared:?}");
    }
}

fn noisy<const D: usize>(mut mesh: Mesh<D>, noise: f64, random: &mut Splitmix) -> Mesh<D> {
    mesh.coords.as_flattened_mut().iter_mut().for_each(|x| *x += noise * random.between(-1.0, 1.0));
    mesh
}

/// Meshes whose nodes, edges and faces coincide, but for noise of all sizes.
#[test]
fn flush_but_for_noise() {
    let mut random = Splitmix::new(9);
    for (number, noise) in [0.0, 1e-17, 1e-16, 1e-15, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4].into_iter().enumerate() {
        let mut all = Compared::default();
        for scene in 0..16u64 {
            let [(type_a, a), (type_b, b)] = [scene % 4, (scene + number as u64) / 4 % 4].map(|k| {
                let cells = [2, 2, 2 + (scene % 2) as usize];
                let (low, high) = ([0.0; 3], [1.0, 1.0, 1.0]);
                match k {
                    0 => (CellType::Tet4, cuboid_tet4(low, high, cells)),
                    1 => (CellType::Hex8, cuboid_hex8(low, high, cells)),
                    2 => (CellType::Wedge6, cuboid_wedge6(low, high, cells)),
                    _ => (CellType::Pyramid5, cuboid_pyramid5(low, high, cells)),
                }
            });
            // In the half of a cell, its edges or its corners; through it by a thousandth, or by nothing.
            let steps = [0.0, 0.25, 0.5, 1e-3, 1.0 / 3.0, 0.999, 1.0];
            let offset = [0; 3].map(|_| steps[(random.unit() * 7.0) as usize % 7]);
            let (a, b) = (noisy(a, noise, &mut random), noisy(b.translated(offset), noise, &mut random));
            let turn = random_rotation::<3>(scene);
            let (a, b) = if scene % 3 == 0 { (a, b) } else { (a.rotated_by(turn), b.rotated_by(turn)) };
            all = all.and(compared((type_a, &a), (type_b, &b), 0.0));
            let [(type_a, a), (type_b, b)] = [flat(scene % 2), flat(scene / 2 % 2)];
            let b = b.translated([offset[0], offset[1]]);
            let (a, b) = (noisy(a, noise, &mut random), noisy(b, noise, &mut random));
            all = all.and(compared((type_a, &a), (type_b, &b), 0.0));
        }
        assert!(all.difference < 1e-12, "{noise}: {all:?}");
    }
}

/// From all of a cell to a ten-millionth of it.
#[test]
fn deep_and_shallow() {
    for depth in [0.7, 0.2, 1e-2, 1e-4, 1e-7] {
        let (lower, upper) = (cuboid_tet4([0.0; 3], [1.0; 3], [3, 3, 3]), cuboid_hex8([0.0; 3], [0.8; 3], [3, 2, 3]));
        let upper = upper.rotated([0.0, 0.0, 1.0], 0.3).translated([0.2, 0.05, 1.0 - depth]);
        let found = compared((CellType::Tet4, &lower), (CellType::Hex8, &upper), 0.0);
        assert!(found.difference < 1e-14 && found.overlapped > 50, "{depth}: {found:?}");
        let offset = compared((CellType::Tet4, &lower), (CellType::Hex8, &upper), 0.01);
        assert!(offset.difference < 1e-14, "{depth}: {offset:?}");
    }
}

/// A bar bent until its ends go through each other, and twice around.
#[test]
fn folded_over_itself() {
    let bar = cuboid_tet4([0.0, 0.0, 0.0], [12.0, 1.0, 1.0], [24, 2, 2]);
    let bricks = cuboid_hex8([0.0, 0.0, 0.0], [12.0, 1.0, 1.0], [24, 2, 2]);
    let strip = rectangle_quad4([0.0, 0.0], [12.0, 1.0], [24, 2]);
    for turns in [1.1, 1.7, 2.3] {
        let angle = |x: f64| -std::f64::consts::TAU * turns * x / 12.0;
        let bent = |x: &[f64; 3]| {
            let (radius, angle) = (1.5 + x[1], angle(x[0]));
            [radius * angle.cos(), radius * angle.sin(), x[2] + 0.013 * angle]
        };
        let rolled = |x: &[f64; 2]| [(1.5 + x[1] + 0.03 * x[0]) * angle(x[0]).cos(), (1.5 + x[1]) * angle(x[0]).sin()];
        for found in [
            compared_own((CellType::Tet4, &bar), bent),
            compared_own((CellType::Hex8, &bricks), bent),
            compared_own((CellType::Quad4, &strip), rolled),
        ] {
            assert!(found.difference < 1e-13 && found.overlapped > 50, "{turns}: {found:?}");
            assert!(found.doubtful * 2 < found.overlapped, "{turns}: {found:?}");
        }
    }
}

/// Products of coordinates, which axisymmetry asks for.
#[test]
fn products_in_the_plane() {
    let mut random = Splitmix::new(3);
    for scene in 0..60 {
        let [(type_a, a), (type_b, b)] = [flat(scene), flat(scene / 3)];
        let offset = [random.between(-0.6, 0.6), random.between(-0.6, 0.6)];
        let b = b.rotated_by(random_rotation(scene)).translated(offset);
        with_bodies(
            &[(type_a, &a), (type_b, &b)],
            |x| *x,
            0.0,
            |bodies| {
                let Some(region) = bodies.pair.region().expect("a region") else { return };
                let bounds = bodies.pair.bounds(region);
                let [of_a, of_b]: [CellPieces<2>; 2] = [0, 1].map(|which| bodies.pieces(which, region, Some(bounds)));
                let facets = (&region.facets[0][..], bounds);
                let (_, (shares, doubtful)) =
                    bodies.facets(&bodies.pair.a, facets, (false, false), &of_b, region.aabb.rounding());
                let side = &bodies.pair.a;
                let enclosed = Enclosed { bodies, pieces: &of_b, side, other: &of_a, bounds, is_own: false };
                let found: Vec<Products> = enclosed.moments(shares.into_iter().flatten(), &doubtful);
                for (number, (piece, found)) in of_b.pieces.iter().zip(&found).enumerate() {
                    let exact: Products = enclosed.part_by_part(number);
                    let difference = exact.times(-1.0);
                    let mut difference = difference;
                    difference.add(found);
                    let largest = difference.iter().flatten().fold(0.0f64, |most, m| most.max(m.abs()));
                    assert!(largest < 1e-14 * piece.measure, "{scene}: {exact:?} {found:?}");
                }
            },
        );
    }
}
