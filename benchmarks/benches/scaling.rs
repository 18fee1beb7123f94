//! What an evaluation costs, by mesh size, by bodies and by threads: the least of several times on one thread, in one run.
//!
//! `cargo bench -p fmc-benchmarks --bench scaling` prints a table; `-- quick` leaves out the largest meshes, and
//! `-- size`, `corner`, `plates`, `bodies` or `small` prints a part. What was measured is left in out/bench/scaling.json for the pages.

mod kept;

use fmc_contact::contact::TangentPart;
use fmc_contact::{
    Bodies, CellBlock, CellType, Contact, EnergyLaw, Estimator, FiberOptions, Obstacle, Options, Pose, Shape, Surface,
};
use fmc_shapes::{Mesh, cuboid_tet4, icosphere};
use kept::keep;
use std::collections::BTreeMap;
use std::time::Instant;

/// Figures by scene and path, times in milliseconds.
type Figures = BTreeMap<String, BTreeMap<&'static str, f64>>;

/// A part of the table.
type Part = dyn Fn(&mut Figures);

/// A mesh in contact.
struct Scene {
    surface: Surface<3>,
    coords: Vec<[f64; 3]>,
}

impl Scene {
    fn of_cells(meshes: &[Mesh<3>], cell_type: CellType) -> Self {
        let (all, ids) = joined(meshes);
        let block = CellBlock { cell_type, conn: &all.conn };
        let surface = Surface::from_cells(&all.coords, &[block], Bodies::Ids(&ids)).expect("a valid mesh");
        Self { surface, coords: all.coords }
    }

    fn of_facets(meshes: &[Mesh<3>]) -> Self {
        let (all, ids) = joined(meshes);
        let surface = Surface::from_facets(&all.coords, &all.facets(), Bodies::Ids(&ids)).expect("a valid mesh");
        Self { surface, coords: all.coords }
    }

    fn contact(&self, options: Options) -> Contact<3> {
        Contact::new(self.surface.clone(), options).expect("valid options")
    }
}

fn joined(meshes: &[Mesh<3>]) -> (Mesh<3>, Vec<i64>) {
    let mut all = meshes[0].clone();
    let mut ids = vec![0; meshes[0].cell_count()];
    for (body, mesh) in meshes.iter().enumerate().skip(1) {
        all.append(mesh);
        ids.resize(ids.len() + mesh.cell_count(), body as i64);
    }
    (all, ids)
}

/// Least time in milliseconds of `work` at coordinates that move a little from call to call, as a host's do.
fn least(coords: &[[f64; 3]], rounds: usize, mut work: impl FnMut(&[[f64; 3]])) -> f64 {
    let mut least = f64::INFINITY;
    for round in 0..=rounds {
        let shift = 1e-9 * round as f64;
        let moved: Vec<[f64; 3]> = coords.iter().map(|x| [x[0] + shift, x[1], x[2]]).collect();
        let start = Instant::now();
        work(&moved);
        if round > 0 {
            least = least.min(1e3 * start.elapsed().as_secs_f64());
        }
    }
    least
}

fn force(contact: &Contact<3>, coords: &[[f64; 3]], rounds: usize) -> f64 {
    least(coords, rounds, |x| drop(contact.evaluate(x).expect("a force")))
}

fn tangent(contact: &Contact<3>, coords: &[[f64; 3]], rounds: usize) -> f64 {
    least(coords, rounds, |x| drop(contact.tangent(x, TangentPart::Full).expect("a tangent")))
}

fn paths() -> [(&'static str, Options); 4] {
    let exact = |law| Options { estimator: Estimator::Exact, ..Options::new(law) };
    let lines = |law| Options { estimator: Estimator::Fibers(FiberOptions::default()), ..Options::new(law) };
    [
        ("exact volume", exact(EnergyLaw::volume(1.0))),
        ("lines volume", lines(EnergyLaw::volume(1.0))),
        ("lines fiber", lines(EnergyLaw::fiber(1.0))),
        ("exact fiber", exact(EnergyLaw::fiber(1.0))),
    ]
}

/// Two spheres of triangles that overlap in a lens of about 250 facets, whatever their number.
fn spheres(level: usize) -> Scene {
    let ball = icosphere(1.0, level);
    let facets = (20 << (2 * level)) as f64;
    // A cap of height h has the part h / 2 of a sphere's facets.
    let depth = 2.0 * 2.0 * 125.0 / facets;
    let direction = [0.3 / 1.95, 0.4 / 1.95, 1.884_807_682_498_071_6 / 1.95];
    let other = ball.clone().rotated([1.0, 2.0, 3.0], 0.7).translated(direction.map(|d| d * (2.0 - depth)));
    Scene::of_facets(&[ball, other])
}

fn block(divisions: [usize; 3], low: [f64; 3], high: [f64; 3]) -> Mesh<3> {
    cuboid_tet4(low, high, divisions)
}

fn by_size(levels: &[usize], figures: &mut Figures) {
    println!("µs per facet of the whole mesh, some 250 facets in contact: force / tangent (asked 0.02, tangent twice)");
    for &level in levels {
        let scene = spheres(level);
        let facets = scene.surface.facet_count();
        print!("{facets:>8} facets");
        for (name, options) in paths() {
            let contact = scene.contact(options);
            let found = contact.evaluate(&scene.coords).expect("a force").facet_count;
            let per_facet = |ms: f64| 1e3 * ms / facets as f64;
            let (f, t) = (force(&contact, &scene.coords, 7), tangent(&contact, &scene.coords, 5));
            print!(" · {name} ({found}) {:.4} / {:.4}", per_facet(f), per_facet(t));
            figures.insert(format!("spheres {facets}/{name}"), [("force", f), ("tangent", t)].into());
        }
        println!();
    }
}

fn corner(figures: &mut Figures) {
    println!("exact fiber, a corner in a block: ms (asked 5 at 86 k facets)");
    for n in [10usize, 20, 40, 60] {
        let cube = block([n; 3], [0.0; 3], [1.0; 3]).rotated([1.0, -1.0, 0.0], 0.955).translated([0.0, 0.0, 0.98]);
        let lowest = cube.coords.iter().map(|x| x[2]).fold(f64::INFINITY, f64::min);
        let cube = cube.translated([0.0, 0.0, 1.0 - lowest - 1.0 / n as f64]);
        let scene = Scene::of_cells(&[cube, block([n; 3], [-0.7, -0.5, 0.0], [0.6, 0.8, 1.0])], CellType::Tet4);
        let options = Options { estimator: Estimator::Exact, ..Options::new(EnergyLaw::fiber(1.0)) };
        let contact = scene.contact(options);
        let found = contact.evaluate(&scene.coords).expect("a force").facet_count;
        let (facets, ms) = (scene.surface.facet_count(), force(&contact, &scene.coords, 5));
        println!("{facets:>8} facets, {found} in contact: {ms:.2}");
        figures.insert(format!("corner {facets}/exact fiber"), [("force", ms)].into());
    }
}

/// Two plates that lie on one another: nearly all facets of both are in contact.
fn plates() -> Scene {
    let n = 63;
    let lower = block([n, n, 1], [0.0, 0.0, 0.0], [1.0, 1.0, 0.02]);
    let upper = block([n + 1, n - 1, 1], [0.01, 0.02, 0.019], [1.01, 1.02, 0.039]).rotated([0.0, 0.0, 1.0], 0.01);
    Scene::of_cells(&[lower, upper], CellType::Tet4)
}

fn whole_faces(figures: &mut Figures) {
    let scene = plates();
    println!("plates on one another, {} facets: ms, force / tangent; on two threads", scene.surface.facet_count());
    for (name, options) in paths() {
        let (one, two) = (scene.contact(options), scene.contact(Options { threads: 2, ..options }));
        let found = one.evaluate(&scene.coords).expect("a force").facet_count;
        let times = [&one, &two].map(|c| (force(c, &scene.coords, 5), tangent(c, &scene.coords, 3)));
        let [(f, t), (f2, t2)] = times;
        let of_path = [("force", f), ("tangent", t), ("force_gain", f / f2), ("tangent_gain", t / t2)];
        figures.insert(format!("plates/{name}"), of_path.into());
        println!(
            "{name:>14} ({found}): {f:.1} / {t:.1}; {f2:.1} / {t2:.1} ({:.2} and {:.2} times faster)",
            f / f2,
            t / t2
        );
    }
}

fn bodies(figures: &mut Figures) {
    let cube = |i: usize, gap: f64| {
        let at = [i % 13, i / 13 % 13, i / 169].map(|k| k as f64 * (1.0 + gap));
        block([2, 2, 2], at, at.map(|x| x + 1.0))
    };
    let many =
        |count: usize, gap: f64| Scene::of_cells(&(0..count).map(|i| cube(i, gap)).collect::<Vec<_>>(), CellType::Tet4);
    let apart = many(2000, 0.1);
    let options = Options { check_cells: false, ..Options::new(EnergyLaw::volume(1.0)) };
    let ms = force(&apart.contact(options), &apart.coords, 9);
    println!("2 000 bodies apart: {ms:.3} ms (asked 0.5)");
    figures.insert("bodies apart".into(), [("force", ms)].into());
    for count in [20, 200, 2000] {
        let scene = many(count, -0.01);
        let contact = scene.contact(Options { estimator: Estimator::Exact, ..options });
        let pairs = contact.evaluate(&scene.coords).expect("a force").pairs.len();
        let ms = force(&contact, &scene.coords, 5);
        figures.insert(format!("touching {count}"), [("each", ms / pairs as f64)].into());
        println!(
            "{count:>5} bodies that touch, {pairs} pairs, exact volume: {:.2} µs per pair",
            1e3 * ms / pairs as f64
        );
    }
    for (name, options) in paths() {
        let count = 100;
        let slab = block([101, 101, 1], [-0.5, -0.5, -0.1], [10.5, 10.5, 0.0]);
        let mut meshes = vec![slab];
        for i in 0..count {
            let at = [(i % 10) as f64 * 1.03 + 0.1, (i / 10) as f64 * 1.03 + 0.1, -0.001];
            meshes.push(block([2, 2, 2], at, [at[0] + 0.2, at[1] + 0.2, at[2] + 0.2]));
        }
        let scene = Scene::of_cells(&meshes, CellType::Tet4);
        let alone = force(
            &scene.contact(options),
            &scene
                .coords
                .iter()
                .map(|x| {
                    // Lifted off the slab, nothing touches.
                    if x[2] > -0.0011 && x[2] != 0.0 { [x[0], x[1], x[2] + 1.0] } else { *x }
                })
                .collect::<Vec<_>>(),
            3,
        );
        let each = (force(&scene.contact(options), &scene.coords, 5) - alone).max(0.0) / count as f64;
        figures.insert(format!("slab/{name}"), [("each", each)].into());
        println!(
            "{count} bodies on a slab, {} facets, {name}: {:.1} µs per body (asked 30); nothing touching {alone:.2} ms",
            scene.surface.facet_count(),
            1e3 * each
        );
    }
}

fn small_things(figures: &mut Figures) {
    let scene = Scene::of_cells(&[block([2, 2, 2], [0.0; 3], [1.0; 3])], CellType::Tet4);
    let mut contact = scene.contact(Options { estimator: Estimator::Exact, ..Options::new(EnergyLaw::volume(1.0)) });
    for i in 0..1000 {
        let pose = Pose::at([0.0, 0.0, -1.0 - f64::from(i)]);
        contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose }).expect("a half-space");
    }
    let ms = force(&contact, &scene.coords, 9);
    println!("1 000 half-spaces far away, exact: {ms:.3} ms (asked 1)");
    figures.insert("half-spaces".into(), [("force", ms)].into());
    let turned = block([20, 20, 20], [0.0; 3], [1.0; 3]).rotated([1.0, 2.0, 3.0], 0.4);
    let scene = Scene::of_cells(&[turned], CellType::Tet4);
    let plain = Options { check_cells: false, ..Options::new(EnergyLaw::volume(1.0)) };
    for (name, options) in paths() {
        let own = scene.contact(Options { self_contact: true, check_cells: false, ..options });
        let ms = force(&own, &scene.coords, 9);
        println!("self-contact of an unfolded block of 48 k cells, {name}: {ms:.3} ms (asked 1)");
        figures.insert(format!("self-contact/{name}"), [("force", ms)].into());
    }
    let checked = scene.contact(Options { check_cells: true, ..plain });
    let without = force(&scene.contact(plain), &scene.coords, 15);
    let cells = 48_000.0;
    let each = (force(&checked, &scene.coords, 15) - without) / cells;
    println!("check of cells: {:.2} ns a cell (asked 1.5)", 1e6 * each);
    figures.insert("check of cells".into(), [("each", each)].into());
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let is_quick = words.iter().any(|word| word == "quick");
    let is_asked = |name: &str| words.iter().all(|word| word == "quick") || words.iter().any(|word| word == name);
    let sizes: &[usize] = if is_quick { &[4, 5] } else { &[4, 5, 6, 7] };
    let parts: [(&str, &Part); 5] = [
        ("size", &|figures| by_size(sizes, figures)),
        ("corner", &corner),
        ("plates", &whole_faces),
        ("bodies", &bodies),
        ("small", &small_things),
    ];
    let mut figures = Figures::new();
    parts.iter().filter(|(name, _)| is_asked(name)).for_each(|(_, part)| part(&mut figures));
    keep("scaling", figures.into_iter().map(|(scene, found)| (scene, serde_json::json!(found))));
}
