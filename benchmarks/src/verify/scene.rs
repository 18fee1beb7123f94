//! Two bodies at one θ, and how fast they move with θ.

use fmc_contact::{
    Bodies, CellBlock, CellType, Contact, EnergyLaw, Error, Estimator, Obstacle, Options, Pose, Shape, Surface,
};
use fmc_shapes::Mesh;
use std::time::Instant;

/// d(pose)/dθ of a rigid shape.
#[derive(Clone, Copy, Debug)]
pub(super) struct PoseRate<const D: usize> {
    /// d(position)/dθ.
    pub position: [f64; D],
    /// Turn about the origin of space, per unit of θ; in 2D the last entry alone counts.
    pub rotation: [f64; 3],
    /// d(scale)/dθ.
    pub scale: f64,
}

impl<const D: usize> PoseRate<D> {
    /// At rest.
    pub(super) const STILL: Self = Self { position: [0.0; D], rotation: [0.0; 3], scale: 0.0 };
}

/// Meshed bodies, and possibly a rigid shape.
pub(super) struct Scene<const D: usize> {
    coords: Vec<[f64; D]>,
    /// dx/dθ of every node.
    velocity: Vec<[f64; D]>,
    meshes: Vec<(CellType, Vec<u32>)>,
    shape: Option<(Obstacle<D>, PoseRate<D>)>,
}

/// What an estimator says of a scene.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measurement {
    /// Overlap.
    pub value: f64,
    /// Its derivative: Σ_a ∂V/∂x_a · dx_a/dθ over the nodes, and the like over the pose of a shape.
    pub derivative: f64,
    /// Standard error of the overlap; 0 for `exact`.
    pub standard_error: f64,
    /// Fibers laid.
    pub fibers: usize,
    /// Crossings that bound the overlap (for `exact`: clipped pieces).
    pub crossings: usize,
    /// Wall time of the evaluation, s. Finding the boundary facets, which is done once per mesh, is not in it.
    pub seconds: f64,
}

impl<const D: usize> Scene<D> {
    /// One meshed body, whose nodes move with `velocity(x)`.
    pub(super) fn of(mesh: &Mesh<D>, velocity: impl Fn([f64; D]) -> [f64; D]) -> Self {
        Self { coords: Vec::new(), velocity: Vec::new(), meshes: Vec::new(), shape: None }.with(mesh, velocity)
    }

    /// With another meshed body.
    pub(super) fn with(mut self, mesh: &Mesh<D>, velocity: impl Fn([f64; D]) -> [f64; D]) -> Self {
        let cell_type = match (D, mesh.nodes_per_cell) {
            (2, 3) => CellType::Tri3,
            (2, 4) => CellType::Quad4,
            (3, 4) => CellType::Tet4,
            (3, 8) => CellType::Hex8,
            (d, n) => panic!("no cell of dimension {d} with {n} nodes"),
        };
        let offset = self.coords.len() as u32;
        self.meshes.push((cell_type, mesh.conn.iter().map(|node| node + offset).collect()));
        self.coords.extend_from_slice(&mesh.coords);
        self.velocity.extend(mesh.coords.iter().map(|x| velocity(*x)));
        self
    }

    /// With a rigid shape.
    pub(super) fn with_shape(self, shape: Shape<D>, pose: Pose<D>, rate: PoseRate<D>) -> Self {
        Self { shape: Some((Obstacle { shape, pose }, rate)), ..self }
    }

    /// Cells in all.
    pub(super) fn cell_count(&self) -> usize {
        self.meshes.iter().map(|(cell_type, conn)| conn.len() / cell_type.node_count()).sum()
    }

    /// Nodes of all bodies.
    pub(super) fn coords(&self) -> &[[f64; D]] {
        &self.coords
    }

    /// Cells as type, nodes and number of the body.
    pub(super) fn cells(&self) -> Vec<(CellType, Vec<u32>, usize)> {
        let bodies = self.meshes.iter().enumerate();
        let cells = bodies.flat_map(|(body, (cell_type, conn))| {
            conn.chunks_exact(cell_type.node_count()).map(move |nodes| (*cell_type, nodes.to_vec(), body))
        });
        cells.collect()
    }

    /// Ends of the stretches of an estimator's fibers that lie in both bodies.
    pub(super) fn spans(&self, estimator: Estimator) -> Result<Vec<[[f64; D]; 2]>, Error> {
        let mut contact = self.contact(1)?;
        contact.set_options(Options { estimator, ..*contact.options() })?;
        let traces = contact.trace(&self.coords)?;
        let ends = traces.iter().flat_map(|fiber| fiber.crossings.chunks_exact(2));
        Ok(ends.map(|ends| [ends[0], ends[1]]).collect())
    }

    /// Ready to be measured, by any estimator.
    pub(super) fn contact(&self, threads: usize) -> Result<Contact<D>, Error> {
        let blocks: Vec<CellBlock> =
            self.meshes.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
        let surface = Surface::from_cells(&self.coords, &blocks, Bodies::Connected)?;
        // An overlap has no stiffness; the law is not used.
        let mut contact = Contact::new(surface, Options { threads, ..Options::new(EnergyLaw::volume(1.0)) })?;
        if let Some((obstacle, _)) = &self.shape {
            contact.add_obstacle(obstacle.clone())?;
        }
        Ok(contact)
    }

    /// Overlap of all pairs, by an estimator.
    pub(super) fn measure(&self, contact: &mut Contact<D>, estimator: Estimator) -> Result<Measurement, Error> {
        contact.set_options(Options { estimator, ..*contact.options() })?;
        let start = Instant::now();
        let overlaps = contact.overlaps(&self.coords)?;
        let seconds = start.elapsed().as_secs_f64();

        let mut sum =
            Measurement { value: 0.0, derivative: 0.0, standard_error: 0.0, fibers: 0, crossings: 0, seconds };
        for overlap in &overlaps {
            sum.value += overlap.volume;
            sum.standard_error = sum.standard_error.hypot(overlap.standard_error);
            sum.fibers += overlap.fiber_count;
            sum.crossings += overlap.crossing_count;
            for (&node, gradient) in overlap.nodes.iter().zip(&overlap.gradient) {
                let velocity = self.velocity[node as usize];
                sum.derivative += (0..D).map(|i| gradient[i] * velocity[i]).sum::<f64>();
            }
            if let (Some(gradient), Some((_, rate))) = (&overlap.pose_gradient, &self.shape) {
                sum.derivative += (0..D).map(|i| gradient.position[i] * rate.position[i]).sum::<f64>();
                sum.derivative += (0..3).map(|i| gradient.rotation[i] * rate.rotation[i]).sum::<f64>();
                sum.derivative += gradient.scale * rate.scale;
            }
        }
        Ok(sum)
    }
}
