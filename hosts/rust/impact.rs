//! An elastic block falls onto another: explicit dynamics with linear triangles of the host's own, in 2D, plane strain. The
//! same program as hosts/c/impact.c, with the same history.
//!
//!     cargo run --release -p fmc-contact --example impact

use fmc_contact::{Bodies, CellBlock, CellType, Contact, EnergyLaw, Error, Estimator, Options, Surface};

const YOUNG: f64 = 1e6;
const POISSON: f64 = 0.3;
const DENSITY: f64 = 1000.0;
const STIFFNESS: f64 = 1e8;
const DT: f64 = 1e-4;
const STEPS: usize = 400;

#[derive(Default)]
struct Mesh {
    nodes: Vec<[f64; 2]>,
    /// Node numbers, three for each.
    triangles: Vec<u32>,
}

impl Mesh {
    /// Appends the block [x0, x0 + side] x [y0, y0 + side], in n x n squares of two triangles each.
    fn add_block(&mut self, [x0, y0]: [f64; 2], side: f64, n: u32) {
        let first = self.nodes.len() as u32;
        for j in 0..=n {
            for i in 0..=n {
                let [i, j, n] = [i, j, n].map(f64::from);
                self.nodes.push([x0 + i * side / n, y0 + j * side / n]);
            }
        }
        for j in 0..n {
            for i in 0..n {
                let a = first + j * (n + 1) + i;
                let (b, d) = (a + 1, a + n + 1);
                let c = d + 1;
                self.triangles.extend([a, b, c, a, c, d]);
            }
        }
    }

    fn triangles(&self) -> impl Iterator<Item = [usize; 3]> {
        self.triangles.chunks_exact(3).map(|t| [t[0], t[1], t[2]].map(|node| node as usize))
    }

    /// Twice the area of a triangle without deformation.
    fn twice_area(&self, triangle: [usize; 3]) -> f64 {
        let [p, q, r] = triangle.map(|node| self.nodes[node]);
        (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])
    }

    fn lumped_masses(&self) -> Vec<f64> {
        let mut mass = vec![0.0; self.nodes.len()];
        for triangle in self.triangles() {
            for node in triangle {
                mass[node] += DENSITY * (self.twice_area(triangle) / 2.0) / 3.0;
            }
        }
        mass
    }

    /// The elastic forces of all triangles: constant strain, small displacements.
    fn internal_forces(&self, x: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut force = vec![[0.0; 2]; x.len()];
        let lambda = YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON));
        let mu = YOUNG / (2.0 * (1.0 + POISSON));
        for node in self.triangles() {
            let area2 = self.twice_area(node);
            let ([mut bx, mut by], [mut exx, mut eyy, mut gxy]) = ([[0.0; 3]; 2], [0.0; 3]);
            for k in 0..3 {
                let (next, last) = (self.nodes[node[(k + 1) % 3]], self.nodes[node[(k + 2) % 3]]);
                bx[k] = (next[1] - last[1]) / area2;
                by[k] = (last[0] - next[0]) / area2;
                let (now, start) = (x[node[k]], self.nodes[node[k]]);
                let (ux, uy) = (now[0] - start[0], now[1] - start[1]);
                exx += bx[k] * ux;
                eyy += by[k] * uy;
                gxy += by[k] * ux + bx[k] * uy;
            }
            let sxx = (lambda + 2.0 * mu) * exx + lambda * eyy;
            let syy = lambda * exx + (lambda + 2.0 * mu) * eyy;
            let sxy = mu * gxy;
            for k in 0..3 {
                force[node[k]][0] -= area2 / 2.0 * (sxx * bx[k] + sxy * by[k]);
                force[node[k]][1] -= area2 / 2.0 * (sxy * bx[k] + syy * by[k]);
            }
        }
        force
    }
}

/// Step, vertical contact force on the upper block, its mean vertical velocity, contact energy: a line every 20 steps.
pub(crate) fn history() -> Result<String, Error> {
    // 1. The lower block, whose bottom row is held, and the upper one, which falls.
    let mut mesh = Mesh::default();
    mesh.add_block([0.0, 0.0], 1.0, 4);
    let (held, upper) = (5, mesh.nodes.len());
    mesh.add_block([0.2, 1.001], 0.6, 3);
    let mass = mesh.lumped_masses();
    let mut x = mesh.nodes.clone();
    let mut v = vec![[0.0; 2]; x.len()];
    v[upper..].fill([0.0, -1.0]);

    // 2. The contact, which finds the facets once.
    let cells = [CellBlock { cell_type: CellType::Tri3, conn: &mesh.triangles }];
    let surface = Surface::from_cells(&x, &cells, Bodies::Connected)?;
    let options = Options { estimator: Estimator::Exact, ..Options::new(EnergyLaw::depth(STIFFNESS)) };
    let contact = Contact::new(surface, options)?;

    // 3. Leapfrog.
    let mut lines = String::new();
    for step in 0..=STEPS {
        let result = contact.evaluate(&x)?;
        if step % 20 == 0 {
            let (mut momentum, mut total) = (0.0, 0.0);
            for n in upper..x.len() {
                momentum += mass[n] * v[n][1];
                total += mass[n];
            }
            let [force, velocity, energy] = [result.bodies[1].force[1], momentum / total, result.energy];
            lines += &format!("{step:6} {force:23.15e} {velocity:23.15e} {energy:23.15e}\n");
        }
        let (force, internal) = (result.forces, mesh.internal_forces(&x));
        for n in held..x.len() {
            for axis in 0..2 {
                v[n][axis] += DT * (force[n][axis] + internal[n][axis]) / mass[n];
                x[n][axis] += DT * v[n][axis];
            }
        }
    }
    Ok(lines)
}

#[allow(dead_code)] // of a test that takes the history from here
fn main() -> Result<(), Error> {
    print!("{}", history()?);
    Ok(())
}
