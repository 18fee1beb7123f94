//! Bodies of bilinear quadrilaterals in plane strain, as a host that answers a search.

use fmc_contact::contact::equilibrium::{Answer, DriverOptions, Equilibrium, Found, Refusal, Request, Unknowns};
use fmc_contact::contact::{Contact, EnergyLaw, Friction, Options};
use fmc_contact::{Bodies, CellBlock, CellType, Obstacle, Pose, Shape, Surface};
use nalgebra::{DMatrix, DVector};

pub(crate) const YOUNG: f64 = 1e6;
pub(crate) const POISSON: f64 = 0.3;

/// A rectangle of n by n cells.
#[derive(Clone, Copy)]
pub(crate) struct Block {
    pub(crate) low: [f64; 2],
    pub(crate) high: [f64; 2],
    pub(crate) cells: usize,
}

impl Block {
    pub(crate) fn unit(x: f64, y: f64, cells: usize) -> Self {
        Self { low: [x, y], high: [x + 1.0, y + 1.0], cells }
    }
}

/// Linear bodies, their loads and what is free.
pub(crate) struct Host {
    pub(crate) coords: Vec<[f64; 2]>,
    pub(crate) stiffness: DMatrix<f64>,
    pub(crate) load: Vec<f64>,
    pub(crate) free: Vec<bool>,
    quads: Vec<u32>,
    ids: Vec<i64>,
}

impl Host {
    pub(crate) fn new(blocks: &[Block]) -> Self {
        let (mut coords, mut quads, mut ids) = (Vec::new(), Vec::new(), Vec::new());
        for (id, block) in blocks.iter().enumerate() {
            let (first, n) = (coords.len() as u32, block.cells);
            let at =
                |axis: usize, k: usize| block.low[axis] + (block.high[axis] - block.low[axis]) * k as f64 / n as f64;
            (0..=n).for_each(|j| (0..=n).for_each(|i| coords.push([at(0, i), at(1, j)])));
            let node = |i: usize, j: usize| first + (j * (n + 1) + i) as u32;
            for j in 0..n {
                for i in 0..n {
                    quads.extend([node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]);
                    ids.push(id as i64);
                }
            }
        }
        let mut stiffness = DMatrix::zeros(2 * coords.len(), 2 * coords.len());
        for quad in quads.chunks_exact(4) {
            let of_cell = cell_stiffness(std::array::from_fn(|k| coords[quad[k] as usize]));
            for (a, &p) in quad.iter().enumerate() {
                for (b, &q) in quad.iter().enumerate() {
                    for i in 0..2 {
                        for j in 0..2 {
                            stiffness[(2 * p as usize + i, 2 * q as usize + j)] += of_cell[(2 * a + i, 2 * b + j)];
                        }
                    }
                }
            }
        }
        let count = 2 * coords.len();
        Self { coords, stiffness, load: vec![0.0; count], free: vec![true; count], quads, ids }
    }

    /// Adds a weight to a body, of all its cells together, spread over its nodes as cells of one size do.
    pub(crate) fn add_weight(&mut self, body: i64, weight: [f64; 2]) {
        let cells: Vec<_> =
            self.quads.chunks_exact(4).zip(&self.ids).filter(|(_, id)| **id == body).map(|(quad, _)| quad).collect();
        for quad in &cells {
            for &node in *quad {
                (0..2)
                    .for_each(|axis| self.load[2 * node as usize + axis] += weight[axis] / (4.0 * cells.len() as f64));
            }
        }
    }

    /// Holds an axis of all nodes that are chosen.
    pub(crate) fn hold(&mut self, axis: usize, is_held: impl Fn([f64; 2]) -> bool) {
        for (node, x) in self.coords.iter().enumerate() {
            self.free[2 * node + axis] &= !is_held(*x);
        }
    }

    /// Contact without a stiffness, on a floor at a height.
    pub(crate) fn contact(&self, floor: Option<f64>, friction: f64) -> Contact<2> {
        let blocks = [CellBlock { cell_type: CellType::Quad4, conn: &self.quads }];
        let surface = Surface::from_cells(&self.coords, &blocks, Bodies::Ids(&self.ids)).unwrap();
        let friction = Friction { coefficient: friction, ..Friction::default() };
        let options = Options { friction, ..Options::new(EnergyLaw::depth(0.0)) };
        let mut contact = Contact::new(surface, options).unwrap();
        if let Some(height) = floor {
            contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, height]) }).unwrap();
        }
        contact
    }

    pub(crate) fn unknowns(&self) -> Unknowns<2> {
        let count = self.load.len();
        Unknowns {
            count,
            of_coordinate: (0..count).map(Some).collect(),
            weighted: std::collections::BTreeMap::new(),
            base: self.coords.clone(),
            free: self.free.clone(),
        }
    }

    pub(crate) fn answer(&self, contact: &Contact<2>, request: &Request) -> Answer {
        let column = |v: &[f64]| DVector::from_column_slice(v);
        match request {
            Request::Forces { x, .. } => {
                let forces = &self.stiffness * column(x) - column(&self.load);
                Answer::Forces { forces: forces.as_slice().to_vec(), energy: None }
            }
            Request::Product { vector, magnitudes: false } => {
                Answer::Vector((&self.stiffness * column(vector)).data.into())
            }
            Request::Product { vector, magnitudes: true } => {
                Answer::Vector((self.stiffness.abs() * column(vector)).data.into())
            }
            Request::Diagonal => Answer::Vector(self.stiffness.diagonal().data.into()),
            Request::Solve { x, part, shift, right } => {
                let mut matrix = self.stiffness.clone();
                (0..matrix.nrows()).for_each(|k| matrix[(k, k)] *= 1.0 + shift);
                let placed: Vec<[f64; 2]> =
                    (self.coords.iter().zip(x.as_chunks::<2>().0)).map(|(x, u)| [x[0] + u[0], x[1] + u[1]]).collect();
                for (row, col, value) in contact.tangent(&placed, *part).unwrap().triplets() {
                    if row < matrix.nrows() && col < matrix.ncols() {
                        matrix[(row, col)] += value;
                    }
                }
                let mut right = column(right);
                for (k, _) in self.free.iter().enumerate().filter(|(_, free)| !**free) {
                    matrix.row_mut(k).fill(0.0);
                    matrix.column_mut(k).fill(0.0);
                    (matrix[(k, k)], right[k]) = (1.0, 0.0);
                }
                match matrix.lu().solve(&right) {
                    Some(found) => Answer::Vector(found.data.into()),
                    None => Answer::Refused("the matrix is singular".into()),
                }
            }
            Request::Condensed { .. } => Answer::Refused("bodies are not condensed".into()),
        }
    }

    /// The equilibrium from rest, with unknowns that are not free at `prescribed`.
    pub(crate) fn solved(
        &self,
        contact: &mut Contact<2>,
        prescribed: Option<&[f64]>,
    ) -> Result<Found<2>, Box<Refusal>> {
        self.solved_with(contact, prescribed, DriverOptions::default())
    }

    pub(crate) fn solved_with(
        &self,
        contact: &mut Contact<2>,
        prescribed: Option<&[f64]>,
        options: DriverOptions,
    ) -> Result<Found<2>, Box<Refusal>> {
        let start = vec![0.0; self.load.len()];
        let mut search = Equilibrium::new(contact, self.unknowns(), &start, prescribed, options).unwrap();
        search
            .run(contact, |contact, request| self.answer(contact, request))
            .unwrap()
            .cloned()
            .map_err(|refusal| Box::new(refusal.clone()))
    }
}

/// By 2 by 2 points of Gauss.
fn cell_stiffness(x: [[f64; 2]; 4]) -> DMatrix<f64> {
    let (mu, lambda) = (YOUNG / (2.0 + 2.0 * POISSON), YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON)));
    let material =
        DMatrix::from_row_slice(3, 3, &[lambda + 2.0 * mu, lambda, 0.0, lambda, lambda + 2.0 * mu, 0.0, 0.0, 0.0, mu]);
    let (signs, g) = ([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], 1.0 / 3f64.sqrt());
    let mut total = DMatrix::zeros(8, 8);
    for [s, t] in signs {
        let [xi, eta] = [s * g, t * g];
        let slopes: [[f64; 2]; 4] = signs.map(|[a, b]| [0.25 * a * (1.0 + b * eta), 0.25 * b * (1.0 + a * xi)]);
        let j = |i: usize, k: usize| (0..4).map(|n| slopes[n][k] * x[n][i]).sum::<f64>();
        let (a, b, c, d) = (j(0, 0), j(0, 1), j(1, 0), j(1, 1));
        let det = a * d - b * c;
        let mut strain = DMatrix::zeros(3, 8);
        for n in 0..4 {
            let [dx, dy] = [(d * slopes[n][0] - c * slopes[n][1]) / det, (a * slopes[n][1] - b * slopes[n][0]) / det];
            (strain[(0, 2 * n)], strain[(1, 2 * n + 1)]) = (dx, dy);
            (strain[(2, 2 * n)], strain[(2, 2 * n + 1)]) = (dy, dx);
        }
        total += strain.transpose() * &material * strain * det;
    }
    total
}
