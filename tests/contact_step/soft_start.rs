//! A column pressed into a block, by a part of a cell at once and by small load steps.

use fmc_contact::contact::{CondensedBodies, ContactStep, ContactStepOptions, ContactStepState};
use fmc_contact::{Bodies, CellBlock, CellType, Contact, EnergyLaw, Error, Estimator, Options, Surface};
use fmc_shapes::rectangle_quad4;

/// A column, a cell wide and two high, above a block of three by two cells of size 1, linear elastic with E = 1 and no lateral
/// contraction. The block is held below, the column at its top.
struct Column {
    coords: Vec<[f64; 2]>,
    contact: Contact<2>,
    stiffness: Vec<Vec<f64>>,
    /// Nodes of the column begin here.
    first: usize,
    list: Vec<usize>,
    held: Vec<usize>,
}

const TOP: f64 = 4.0;

impl Column {
    fn new(k: f64) -> Self {
        let (block, column) =
            (rectangle_quad4([0.0, 0.0], [3.0, 2.0], [3, 2]), rectangle_quad4([1.1, 2.0], [2.1, TOP], [1, 2]));
        let first = block.coords.len();
        let coords = [block.coords, column.coords].concat();
        let conn: Vec<u32> =
            block.conn.into_iter().chain(column.conn.into_iter().map(|node| node + first as u32)).collect();
        let blocks = [CellBlock { cell_type: CellType::Quad4, conn: &conn }];
        let surface = Surface::from_cells(&coords, &blocks, Bodies::Connected).unwrap();
        let options = Options { estimator: Estimator::Exact, ..Options::new(EnergyLaw::depth(k)) };
        let contact = Contact::new(surface, options).unwrap();
        let is_held = |dof: &usize| [0.0, TOP].contains(&coords[dof / 2][1]);
        let (held, list) = (0..2 * coords.len()).partition(is_held);
        let mut stiffness = vec![vec![0.0; 2 * coords.len()]; 2 * coords.len()];
        conn.chunks(4).for_each(|cell| add_cell(&mut stiffness, cell));
        Self { coords, contact, stiffness, first, list, held }
    }

    /// The step from some coordinates.
    fn step(&self, from: &[[f64; 2]], options: &ContactStepOptions) -> Result<ContactStep, Error> {
        let moved: Vec<f64> = from.iter().flatten().zip(self.coords.iter().flatten()).map(|(x, at)| x - at).collect();
        let pull = |&dof: &usize| self.stiffness[dof].iter().zip(&moved).map(|(s, u)| s * u).sum();
        let residual: Vec<f64> = self.list.iter().map(pull).collect();
        let row = |&row: &usize| self.list.iter().map(move |&col| self.stiffness[row][col]);
        let stiffness: Vec<f64> = self.list.iter().flat_map(row).collect();
        let bodies = CondensedBodies { dofs: &self.list, held: &self.held, stiffness: &stiffness, residual: &residual };
        self.contact.contact_step(from, &bodies, options, None)
    }

    /// The column with its top moved down, without contact: all of it.
    fn pressed(&self, by: f64) -> Vec<[f64; 2]> {
        let mut coords = self.coords.clone();
        coords[self.first..].iter_mut().for_each(|x| x[1] -= by);
        coords
    }

    fn by_small_steps(&self, by: f64, count: usize) -> Vec<[f64; 2]> {
        let mut coords = self.coords.clone();
        for k in 1..=count {
            let height = TOP - by * k as f64 / count as f64;
            let tops = self.coords.iter().zip(&mut coords).filter(|(at, _)| at[1] == TOP);
            tops.for_each(|(_, x)| x[1] = height);
            let found = self.step(&coords, &ContactStepOptions::default()).unwrap();
            assert_eq!(found.state, ContactStepState::Converged);
            coords = self.added(coords, &found);
        }
        coords
    }

    fn added(&self, mut coords: Vec<[f64; 2]>, found: &ContactStep) -> Vec<[f64; 2]> {
        self.list.iter().zip(&found.displacement).for_each(|(&dof, by)| coords[dof / 2][dof % 2] += by);
        coords
    }
}

/// That of a unit square in plane strain with ν = 0, by two points of Gauss along each axis.
fn add_cell(stiffness: &mut [Vec<f64>], cell: &[u32]) {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let points = [0.5 - 0.5 / 3f64.sqrt(), 0.5 + 0.5 / 3f64.sqrt()];
    let slope = |corner: [f64; 2], at: [f64; 2]| -> [f64; 2] {
        let part = |axis: usize| if corner[axis] > 0.5 { (at[axis], 1.0) } else { (1.0 - at[axis], -1.0) };
        let ((x, dx), (y, dy)) = (part(0), part(1));
        [dx * y, x * dy]
    };
    for at in points.iter().flat_map(|&x| points.map(|y| [x, y])) {
        for (a, ca) in cell.iter().zip(corners) {
            for (b, cb) in cell.iter().zip(corners) {
                let (ga, gb) = (slope(ca, at), slope(cb, at));
                // σ = E ε: ½ E of both the gradient and its transpose.
                let both = ga[0] * gb[0] + ga[1] * gb[1];
                for i in 0..2 {
                    for j in 0..2 {
                        let same = if i == j { both } else { 0.0 };
                        stiffness[2 * *a as usize + i][2 * *b as usize + j] += 0.25 * 0.5 * (same + ga[j] * gb[i]);
                    }
                }
            }
        }
    }
}

fn distance(one: &[[f64; 2]], other: &[[f64; 2]]) -> f64 {
    one.iter().flatten().zip(other.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn a_deep_start_ends_where_small_load_steps_do() {
    let options = ContactStepOptions { soft_start: true, ..Default::default() };
    for k in [1.0, 10.0, 100.0, 1000.0] {
        let column = Column::new(k);
        for by in [0.02, 0.05, 0.1, 0.2, 0.5] {
            let start = column.pressed(by);
            let found = column.step(&start, &options).unwrap();
            assert_eq!(found.state, ContactStepState::Converged, "{k}, {by}: {found:?}");
            // Both end at a residual of 1e-10 of the forces.
            let apart = distance(&column.added(start.clone(), &found), &column.by_small_steps(by, 40));
            assert!(apart < 1e-10, "{k}, {by}: {apart:e}");
            assert_eq!(column.step(&start, &options).unwrap(), found, "the same bits again");
        }
    }
}

/// That which is softened is not reported: residuals are those of the contact as it is.
#[test]
fn without_it_the_same_start_is_given_up_on_and_iterations_that_run_out_on_soft_contact_are_told() {
    let column = Column::new(1000.0);
    let start = column.pressed(0.2);
    let plain = column.step(&start, &ContactStepOptions::default()).unwrap();
    assert_eq!(plain.state, ContactStepState::NotConverged);
    let few = ContactStepOptions { soft_start: true, max_iterations: 1, ..Default::default() };
    let found = column.step(&start, &few).unwrap();
    assert_eq!((found.state, found.residual_at_start), (ContactStepState::NotConverged, plain.residual_at_start));
    // One for each of four stiffnesses, of which the last is that of the contact.
    assert!((2..=5).contains(&found.iterations) && found.residual > 1e-6 * found.scale, "{found:?}");
}

/// A start from which bodies bear what touches, or that is an equilibrium already, is none to be softened.
#[test]
fn starts_that_are_not_deep_keep_their_bits() {
    let soft = ContactStepOptions { soft_start: true, ..Default::default() };
    for (k, by) in [(0.1, 0.2), (1000.0, 0.0)] {
        let column = Column::new(k);
        let start = column.pressed(by);
        let plain = column.step(&start, &ContactStepOptions::default()).unwrap();
        assert_eq!(column.step(&start, &soft).unwrap(), plain);
    }
    let column = Column::new(1000.0);
    let there = column.by_small_steps(0.2, 40);
    let plain = column.step(&there, &ContactStepOptions::default()).unwrap();
    assert_eq!((column.step(&there, &soft).unwrap(), plain.iterations <= 1), (plain, true));
}
