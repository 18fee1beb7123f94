//! Against plain Newton iterations with everything at once.

use fmc_contact::contact::{CondensedBodies, ContactStepOptions, ContactStepState, Friction, TangentPart};
use fmc_contact::{
    Bodies, CellBlock, CellType, Contact, EnergyLaw, EnergyProfile, Estimator, Obstacle, Options, PenetrationLaw, Pose,
    Shape, Surface,
};
use fmc_shapes::rectangle_quad4;
use nalgebra::{DMatrix, DVector};

pub(crate) const K: f64 = 2000.0;

/// A row of cells whose nodes stand on springs, coupled with their neighbours as in a membrane, above a round obstacle.
pub(crate) struct Scene {
    coords: Vec<[f64; 2]>,
    pub(crate) contact: Contact<2>,
    stiffness: DMatrix<f64>,
    residual: DVector<f64>,
}

pub(crate) fn scene(law: EnergyLaw, friction: f64) -> Scene {
    let mesh = rectangle_quad4([0.0, 0.0], [2.0, 0.5], [12, 3]);
    let (coords, conn) = (mesh.coords, mesh.conn);
    let block = CellBlock { cell_type: CellType::Quad4, conn: &conn };
    let surface = Surface::from_cells(&coords, &[block], Bodies::Connected).unwrap();
    let mut options = Options::new(law);
    options.friction = Friction::coulomb(friction);
    options.estimator = Estimator::Exact;
    let mut contact = Contact::new(surface, options).unwrap();
    let points = fan();
    let facets = (0..points.len() as u32).map(|k| [k, (k + 1) % points.len() as u32]).collect();
    let pose = Pose::at([1.03, -0.9]);
    contact.add_obstacle(Obstacle { shape: Shape::Polytope { points, facets }, pose }).unwrap();
    let count = 2 * coords.len();
    let mut stiffness = DMatrix::from_diagonal_element(count, count, 20.0);
    let mut join = |a: usize, b: usize, k: f64| {
        for axis in 0..2 {
            let (a, b) = (2 * a + axis, 2 * b + axis);
            for (row, col, value) in [(a, a, k), (b, b, k), (a, b, -k), (b, a, -k)] {
                stiffness[(row, col)] += value;
            }
        }
    };
    for cell in conn.chunks(4) {
        (0..4).for_each(|k| join(cell[k] as usize, cell[(k + 1) % 4] as usize, 50.0));
    }
    let residual = DVector::from_fn(count, |dof, _| if dof % 2 == 1 { 3.0 } else { -1.5 });
    Scene { coords, contact, stiffness, residual }
}

/// A half-disc with a flat base, by edges.
fn fan() -> Vec<[f64; 2]> {
    (0..=24).map(|k| std::f64::consts::PI * f64::from(k) / 24.0).map(|a| [0.8 * a.cos(), 0.8 * a.sin()]).collect()
}

impl Scene {
    /// Number of unknowns.
    pub(crate) fn length(&self) -> usize {
        self.residual.len()
    }

    /// Stiffness of the bodies.
    pub(crate) fn stiffness(&self) -> &DMatrix<f64> {
        &self.stiffness
    }

    /// What contact must bear for equilibrium.
    pub(crate) fn pressed(&self, d: &DVector<f64>) -> DVector<f64> {
        &self.residual + &self.stiffness * d
    }

    pub(crate) fn at(&self, d: &DVector<f64>) -> Vec<[f64; 2]> {
        let moved = |n: usize| std::array::from_fn(|axis| self.coords[n][axis] + d[2 * n + axis]);
        (0..self.coords.len()).map(moved).collect()
    }

    fn residual_at(&self, d: &DVector<f64>) -> DVector<f64> {
        let forces = self.contact.evaluate(&self.at(d)).unwrap().forces;
        &self.residual + &self.stiffness * d - DVector::from_column_slice(forces.as_flattened())
    }

    /// Plain Newton from a start, with halved steps while the residual grows; also the number of iterations.
    pub(crate) fn newton(&self, mut d: DVector<f64>) -> (DVector<f64>, usize) {
        for iteration in 0..200 {
            let r = self.residual_at(&d);
            if r.norm() <= 1e-11 * self.residual.norm() {
                return (d, iteration);
            }
            let mut matrix = self.stiffness.clone();
            let tangent = self.contact.tangent(&self.at(&d), TangentPart::Full).unwrap();
            tangent.triplets().filter(|t| t.0 < d.len() && t.1 < d.len()).for_each(|(r, c, v)| matrix[(r, c)] += v);
            let step = matrix.lu().solve(&-&r).unwrap();
            let mut part = 1.0;
            while part > 1e-3 && self.residual_at(&(&d + &step * part)).norm() > r.norm() {
                part *= 0.5;
            }
            d += step * part;
        }
        panic!("plain Newton does not converge");
    }

    /// The step on the unknowns of the lower two rows, and where it leads all of them.
    pub(crate) fn condensed(&self, options: &ContactStepOptions) -> (DVector<f64>, fmc_contact::contact::ContactStep) {
        let count = 2 * self.coords.len();
        let is_kept = |dof: &usize| self.coords[dof / 2][1] < 0.2;
        let (kept, inner): (Vec<usize>, Vec<usize>) = (0..count).partition(is_kept);
        let pick = |rows: &[usize], cols: &[usize]| {
            DMatrix::from_fn(rows.len(), cols.len(), |r, c| self.stiffness[(rows[r], cols[c])])
        };
        let of = |rows: &[usize]| DVector::from_fn(rows.len(), |r, _| self.residual[rows[r]]);
        let factors = pick(&inner, &inner).lu();
        let (across, loaded) = (factors.solve(&pick(&inner, &kept)).unwrap(), factors.solve(&of(&inner)).unwrap());
        let schur = pick(&kept, &kept) - pick(&kept, &inner) * &across;
        let right = of(&kept) - pick(&kept, &inner) * &loaded;
        let whole = |d: &[f64]| {
            let inside = -&loaded - &across * DVector::from_column_slice(d);
            let mut all = DVector::zeros(count);
            kept.iter().zip(d).for_each(|(&dof, d)| all[dof] = *d);
            inner.iter().zip(inside.iter()).for_each(|(&dof, d)| all[dof] = *d);
            all
        };
        let mut place = |d: &[f64], coords: &mut [[f64; 2]]| {
            coords.copy_from_slice(&self.at(&whole(d)));
            Ok(())
        };
        let rows: Vec<f64> = schur.transpose().as_slice().to_vec();
        let bodies = CondensedBodies { dofs: &kept, held: &[], stiffness: &rows, residual: right.as_slice() };
        let found = self.contact.contact_step(&self.coords, &bodies, options, Some(&mut place)).unwrap();
        (whole(&found.displacement), found)
    }
}

#[test]
fn it_is_that_of_all_unknowns_at_once_with_every_law() {
    let laws = [
        EnergyLaw::depth(K),
        EnergyLaw::Fiber(PenetrationLaw { stiffness: K, profile: EnergyProfile::Quadratic }),
        EnergyLaw::Volume { stiffness: K, exponent: 2.0 },
    ];
    for law in laws {
        let mut scene = scene(law, 0.0);
        if law.is_fiber() {
            let pushed = DVector::from_fn(2 * scene.coords.len(), |dof, _| if dof % 2 == 1 { -0.12 } else { 0.0 });
            let there = scene.at(&pushed);
            scene.contact.keep_patches(&there).unwrap();
        }
        let (whole, found) = scene.condensed(&ContactStepOptions::default());
        assert_eq!(found.state, ContactStepState::Converged, "{law:?}: {found:?}");
        assert!(scene.residual_at(&whole).norm() <= 1e-9 * scene.residual.norm(), "{law:?}");
        let (plain, _) = scene.newton(whole.clone() * 0.9);
        assert!((plain - &whole).amax() <= 1e-9 * whole.amax(), "{law:?}");
        assert!(scene.contact.evaluate(&scene.at(&whole)).unwrap().energy > 0.0);
        // The same bits again.
        assert_eq!(scene.condensed(&ContactStepOptions::default()).1, found);
    }
}

#[test]
fn friction_frozen_and_with_the_current_pressure() {
    let mut scene = scene(EnergyLaw::depth(K), 0.3);
    let start = scene.coords.clone();
    scene.contact.begin_step(&start).unwrap();
    let (current, found) = scene.condensed(&ContactStepOptions::default());
    assert_eq!(found.state, ContactStepState::Converged, "{found:?}");
    assert!(scene.residual_at(&current).norm() <= 1e-9 * scene.residual.norm());
    assert!(scene.contact.evaluate(&scene.at(&current)).unwrap().friction.slip_area > 0.0);
    // Frozen at the solution it is the solution.
    let there = scene.at(&current);
    scene.contact.freeze_friction(&there).unwrap();
    let (frozen, found) = scene.condensed(&ContactStepOptions::default());
    assert_eq!(found.state, ContactStepState::Converged, "{found:?}");
    assert!((frozen - &current).amax() <= 1e-7 * current.amax());
}
