//! What can go wrong, one variant per cause, holding the facts; the sentence lives in `Display`.
mod checks;
mod counted;
mod law_fault;
mod map_point;
mod memory;
mod text;
pub use law_fault::{FrictionFault, LawFault};
pub use map_point::MapPoint;

/// Cause of a failure. After any error, the object that was called is as it was before the call.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// An array's length does not match the counts (`coords`, `body_ids`, a `conn` not divisible by the nodes of a cell).
    Length {
        /// Name of the array.
        array: &'static str,
        /// Length that was needed (for `conn`: the number it must be a multiple of).
        expected: usize,
        /// Length that was found.
        found: usize,
    },
    /// A cell type of another dimension than the coordinates.
    Dimension {
        /// Block of cells.
        block: usize,
        /// Dimension of the coordinates.
        expected: usize,
        /// Dimension of the cell type.
        found: usize,
    },
    /// A cell or facet names a node that does not exist.
    NodeOutOfRange {
        /// Cell or facet, counted over all blocks.
        cell: usize,
        /// The node it names, as given (negative ids wrap when given as signed numbers and are reported as given).
        node: i64,
        /// Number of nodes.
        node_count: usize,
    },
    /// A coordinate of a used node is NaN or infinite.
    NonFiniteCoordinate {
        /// Node.
        node: usize,
        /// Axis.
        axis: usize,
    },
    /// A node lies beyond the axis, with axisymmetry.
    NegativeRadius {
        /// Node.
        node: usize,
        /// Its first coordinate.
        radius: f64,
    },
    /// A cell or facet names one node twice.
    RepeatedNode {
        /// Cell or facet.
        cell: usize,
        /// Node named twice.
        node: usize,
    },
    /// A row of a basis names an unknown that does not exist.
    UnknownOutOfRange {
        /// Row, which is a node of the mesh.
        row: usize,
        /// The unknown, as given.
        unknown: i64,
        /// How many there are.
        count: usize,
    },
    /// Two cells, or two facets of a surface given by facets, do not fit: an edge, face or node is divided in one of them only.
    NonConforming {
        /// Both cells (or facets), counted over all blocks.
        cells: [usize; 2],
    },
    /// A cell is inverted against those next to it, or, unless a simplex, at one of its corners; or a part of a second-order facet faces away.
    InvertedCell {
        /// Cell, or facet.
        cell: usize,
    },
    /// Several cells are inverted when a mesh is made, or one is a quadrilateral whose edges cross.
    InvertedCells {
        /// The cells, ascending.
        cells: Vec<usize>,
        /// How many of them are quadrilaterals whose nodes go to and fro, as a bow tie.
        bow_ties: usize,
    },
    /// The map of a cell of second order folds: its Jacobian is negative (mirrored: positive) at a node or, in an evaluation, at a quadrature point.
    FoldedCell {
        /// Cell.
        cell: usize,
        /// Where in the cell.
        at: MapPoint,
        /// The determinant there, negative, in the coordinates of a cell with edges of length one (the base of a pyramid: two).
        determinant: f64,
    },
    /// A cell or facet has no length, area or volume.
    ZeroMeasure {
        /// Cell or facet.
        cell: usize,
    },
    /// A tolerance within which nodes are taken as one is so large that two nodes of a cell would be.
    Collapsed {
        /// Cell, counted over all blocks.
        cell: usize,
        /// How far apart the two nodes are: the length of an edge, or of a part of one.
        length: f64,
        /// The tolerance.
        tolerance: f64,
    },
    /// A surface given by facets is not closed: an edge (3D) or node (2D) that belongs to one facet only.
    OpenSurface {
        /// Facet with that edge or node.
        facet: usize,
        /// The nodes of the border edge (2D: the node, twice).
        nodes: [usize; 2],
    },
    /// Two cells of one body have the same nodes: one is there twice.
    RepeatedCell {
        /// Both cells, ascending, counted over all blocks.
        cells: [usize; 2],
    },
    /// More than two facets meet at an edge (3D) or node (2D), or more than two cells at a face.
    NonManifold {
        /// Facet or cell found third.
        facet: usize,
        /// Nodes of the edge (2D: the node, twice), or two nodes of the face.
        nodes: [usize; 2],
    },
    /// Two neighbouring facets, or cells of a body that cannot be oriented, have opposite orientations.
    InconsistentOrientation {
        /// Facet or cell found second.
        facet: usize,
        /// Nodes of the edge (2D: the node, twice).
        nodes: [usize; 2],
    },
    /// A body given by facets encloses a negative volume: its facets point inwards.
    InvertedSurface {
        /// Body id.
        body: i64,
    },
    /// There is nothing to compute with: no cells and no facets.
    Empty,
    /// A parameter that must be positive and finite is not (`stiffness`, `exponent` ≥ 1, `spacing`, a radius, …).
    NotPositive {
        /// Name of the parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// An entry of an array is NaN or infinite, negative where it must not be, or not larger than the one before where entries ascend.
    BadEntry {
        /// Name of the array.
        array: &'static str,
        /// Place in it, counted from 0.
        entry: usize,
        /// What stands there.
        value: f64,
    },
    /// An entry of an array is the number of something that does not exist.
    NoSuchNumber {
        /// Name of the array.
        array: &'static str,
        /// Place in it, counted from 0.
        entry: usize,
        /// What stands there, and how many there are.
        number: [usize; 2],
    },
    /// The mass of a node that feels contact is not positive.
    NotPositiveMass {
        /// Node.
        node: usize,
        /// Its mass.
        value: f64,
    },
    /// A rotation is not orthonormal with determinant +1, or a position or scale is not finite.
    BadPose {
        /// Obstacle.
        obstacle: usize,
    },
    /// No such obstacle.
    ObstacleOutOfRange {
        /// Obstacle asked for.
        obstacle: usize,
        /// Number of obstacles.
        count: usize,
    },
    /// An obstacle that was removed.
    ObstacleRemoved {
        /// Obstacle asked for.
        obstacle: usize,
    },
    /// No such body.
    BodyOutOfRange {
        /// Body asked for, by index.
        body: usize,
        /// Number of bodies.
        count: usize,
    },
    /// An option of a pair cannot be set.
    OfPair {
        /// Both sides, each `"body"` or `"obstacle"` with its index.
        sides: [(&'static str, usize); 2],
        /// Why.
        cause: Box<Error>,
    },
    /// A list of degrees of freedom names one that does not exist.
    DofOutOfRange {
        /// As given.
        dof: i64,
        /// How many there are.
        count: usize,
    },
    /// A list of degrees of freedom does not ascend, or names one that another list has.
    RepeatedDof {
        /// The one that comes too late.
        dof: usize,
    },
    /// A stiffness or a residual that was given is NaN or infinite.
    NonFiniteStiffness {
        /// Name of the array.
        array: &'static str,
        /// Place in it.
        entry: usize,
    },
    /// The stiffness of bodies and contact together is singular to rounding.
    SingularStiffness {
        /// Degree of freedom at which it was found, `node * dim + axis`.
        dof: usize,
    },
    /// The stiffness of bodies and contact together has a negative eigenvalue, even without what contact may add to it.
    IndefiniteStiffness {
        /// Degree of freedom at which it was found, `node * dim + axis`.
        dof: usize,
        /// The stiffness there once those before it have been eliminated.
        pivot: f64,
    },
    /// The stiffness of bodies is not positive definite: they are not held, or buckle.
    NotPositiveDefinite {
        /// Equation at which what elimination of others left is not positive.
        equation: usize,
    },
    /// There are no factors of a matrix: none was given, or the last one had none.
    NotFactorised,
    /// A matrix that has to be symmetric is not.
    Unsymmetric {
        /// Row of an entry that differs from its mirror image.
        row: usize,
        /// Column.
        column: usize,
    },
    /// A host's function that places its nodes failed.
    Place {
        /// What it returned.
        code: i32,
    },
    /// The caller ended the call ([`Contact::set_interrupt`](crate::Contact::set_interrupt)).
    Interrupted,
    /// Memory that a call needs cannot be had.
    Memory {
        /// What it is for.
        what: &'static str,
        /// Bytes.
        bytes: usize,
    },
    /// An elastic slip is NaN or infinite.
    NonFiniteSlip {
        /// Facet, counted over the surface.
        facet: usize,
    },
    /// A row of a list that is carried from one step to the next names what there is not.
    NoSuchRow {
        /// Name of the list.
        list: &'static str,
        /// The row, counted from 0.
        row: usize,
        /// What it names.
        what: &'static str,
    },
    /// No step has begun: with friction slip is counted from there, and [`Contact::commit_step`](crate::Contact::commit_step) ends one.
    NoStep,
    /// The law has no stiffness, and the bodies gave none ([`Contact::set_layer_stiffness`](crate::Contact::set_layer_stiffness)).
    NoStiffness,
    /// Two bodies are tied, joined by a cohesive interface or kept from separating, and face one another nowhere within reach.
    Untied {
        /// Both bodies, by index.
        bodies: [usize; 2],
        /// The reach, and how far apart the nearest faces are, in length; infinite where none face one another.
        distances: [f64; 2],
        /// What they should be: tied, joined by a cohesive interface, or kept from separating.
        held: &'static str,
    },
    /// The points of a convex hull lie in one plane (2D: on one line), or their hull cannot be found to rounding.
    DegenerateHull {
        /// Number of points.
        point_count: usize,
    },
    /// A height field has fewer than two points along an axis.
    TooFewHeights {
        /// Axis.
        axis: usize,
        /// Number of points along it.
        count: usize,
    },
    /// A height is NaN or infinite.
    NonFiniteHeight {
        /// Its place in the array.
        point: usize,
    },
    /// A compound has no parts.
    EmptyCompound,
    /// The estimator, or this build, does not support this (exact overlap with a curved or signed-distance obstacle).
    Unsupported {
        /// What is not supported.
        what: &'static str,
    },
    /// A signed-distance function grows faster between two points than a distance can: contact would be missed.
    SteepDistance {
        /// Obstacle.
        obstacle: usize,
        /// The points in space; in the plane the third coordinate is 0.
        places: [[f64; 3]; 2],
        /// What the function is there, in units of length.
        phi: [f64; 2],
    },
    /// A signed-distance function failed, or returned a value that is not finite.
    SignedDistance {
        /// Obstacle.
        obstacle: usize,
        /// Point, counted within the batch.
        point: usize,
    },
    /// The law of the host on an interface failed, or answered with a number that is not finite.
    InterfaceLaw(LawFault),
    /// The law of friction of the host failed, or answered with what is no limit.
    FrictionLaw(FrictionFault),
    /// The pattern would need more fibers or crossings than can be counted; the spacing is too small for the bodies.
    TooManyFibers {
        /// Number that would be needed.
        needed: f64,
        /// The limit.
        limit: f64,
    },
    /// Lines along a signed-distance obstacle that would need too many steps: its resolution, or the spacing of the lines, is too fine for the contact.
    UnfinishedLines {
        /// Obstacle.
        obstacle: usize,
        /// Number of such lines.
        lines: usize,
        /// Steps that were taken on each.
        steps: usize,
    },
    /// The exact estimator would cut facets into more pieces than can be worked through: a body is tangled with itself, or two are.
    TooManyPieces {
        /// Both sides, each `"body"` or `"obstacle"` with its index.
        sides: [(&'static str, usize); 2],
        /// The limit.
        limit: usize,
    },
    /// A result lies outside the range of a double, as volumes and energies of coordinates that are all below 1e-75, or some above 1e75.
    Overflow {
        /// What overflowed.
        quantity: &'static str,
        /// Its value, infinite or NaN.
        value: f64,
    },
    /// A communicator's rank is not one of its ranks.
    BadRank {
        /// Rank.
        rank: usize,
        /// Number of ranks.
        size: usize,
    },
    /// A communicator failed.
    Communication {
        /// What it returned.
        code: i32,
    },
    /// The evaluation failed on another rank, which has the cause; so it ends on all.
    OnOtherRank {
        /// The first of them.
        rank: usize,
    },
    /// Ranks that share the work were given different coordinates, options or poses of obstacles, or asked for different things.
    RanksDiffer {
        /// The first that differs.
        rank: usize,
    },
    /// Coordinates at which a part of a mesh that was not gathered may be in contact.
    NotGathered {
        /// Index of its body.
        body: usize,
    },
    /// The threads could not be started, or more than 1024 were asked for.
    Threads {
        /// Number asked for.
        threads: usize,
    },
}
