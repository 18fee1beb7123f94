// Inputs and outputs of a context. Part of fmc_contact.hpp. fmc_contact.h has the structs of results, with their units: fmc_result,
// fmc_resultant, fmc_pair_result, fmc_contact_point, fmc_gap_constraint, fmc_multiplier, fmc_boundary_facet.
#ifndef FMC_CONTACT_DATA_HPP
#define FMC_CONTACT_DATA_HPP

#include "view.hpp"

namespace fmc {

// Options of an evaluation: the fields of `fmc_options`, which has their units and defaults. With the law "depth", the default, the
// stiffness k is a pressure per length. Without k `find_equilibrium` finds it, and no evaluation is possible before.
struct Options : fmc_options {
  explicit Options(double k = 0) : fmc_options() {
    check(fmc_options_init(this));
    stiffness = k;
  }
  // Sets an option by the name of its field, both as text: set("estimator", "exact").
  Options &set(const std::string &key, const std::string &value) {
    check(fmc_options_set(this, key.c_str(), value.c_str()));
    return *this;
  }
};

// Options of one pair: the fields of `fmc_pair_options`, with their defaults at first.
struct PairOptions : fmc_pair_options {
  PairOptions() : fmc_pair_options() { check(fmc_pair_options_init(this)); }
};

// Another coefficient of friction across a direction: the fields of `fmc_orthotropic_friction`.
struct OrthotropicFriction : fmc_orthotropic_friction {
  OrthotropicFriction() : fmc_orthotropic_friction() { check(fmc_orthotropic_friction_init(this)); }

  // Across a direction of 3 numbers that belongs to the first partner of the call, or to the second.
  OrthotropicFriction(double across, View<const double> along, bool of_second = false) : OrthotropicFriction() {
    if (along.size() != 3) detail::refuse(FMC_ERROR_LENGTH, "a direction has 3 numbers");
    transverse_coefficient = across;
    for (std::size_t axis = 0; axis < 3; ++axis) direction[axis] = along[axis];
    direction_of = of_second ? 1 : 0;
  }
};

// Shapes and initial slopes of the cohesive law of Park, Paulino and Roesler: the fields of `fmc_ppr`, at first the default ones.
struct Ppr : fmc_ppr {
  Ppr() : fmc_ppr() { check(fmc_ppr_init(this)); }
};

// One side of a pair.
struct Partner {
  fmc_partner kind;
  std::size_t index;

  static Partner body(std::size_t index) { return {FMC_PARTNER_BODY, index}; }
  static Partner obstacle(std::size_t index) { return {FMC_PARTNER_OBSTACLE, index}; }
};

// Position, rotation and scale of an obstacle: the fields of `fmc_pose`, at first the origin.
struct Pose : fmc_pose {
  Pose() : fmc_pose() { check(fmc_pose_init(this)); }
  Pose(const fmc_pose &pose) : fmc_pose(pose) {}

  // At a position of 2 or 3 numbers, without rotation: `set_pose` with it resets the rotation of an obstacle. To keep the rotation,
  // change the pose of `obstacle_shape`.
  static Pose at(View<const double> where) {
    Pose pose;
    if (where.size() != 2 && where.size() != 3) detail::refuse(FMC_ERROR_LENGTH, "a position has 2 or 3 numbers");
    for (std::size_t axis = 0; axis < where.size(); ++axis) pose.position[axis] = where[axis];
    return pose;
  }
  // With the shape's last axis along `axis`: the outward normal of a half-space, the axis of a cylinder, cone or capsule.
  static Pose along(View<const double> where, View<const double> axis) {
    Pose pose;
    if (where.size() != axis.size()) detail::refuse(FMC_ERROR_LENGTH, "position and axis have different lengths");
    check(fmc_pose_along(static_cast<int32_t>(where.size()), where.data(), axis.data(), &pose));
    return pose;
  }
};

// Ranks that share the work of a context; one without a function at first.
struct Communicator : fmc_communicator {
  Communicator() : fmc_communicator() { check(fmc_communicator_init(this)); }
};

// Variables by which the contact is differentiated, and output arrays; none at first.
struct Gradients : fmc_gradients {
  Gradients() : fmc_gradients() { check(fmc_gradients_init(this)); }
};

// Direction in which the contact is differentiated: rates, all 0 at first.
struct Directions : fmc_directions {
  Directions() : fmc_directions() { check(fmc_directions_init(this)); }
};

// Rates of energy and nodal forces.
struct Slopes {
  double energy = 0;
  std::vector<double> forces;
};

// When a contact step ends.
struct ContactStepOptions : fmc_contact_step_options {
  ContactStepOptions() : fmc_contact_step_options() { check(fmc_contact_step_options_init(this)); }
};

// Result of a contact step, one number for every degree of freedom on its list; check `state` first.
struct ContactStep : fmc_contact_step_result {
  std::vector<double> displacement;
};

// Cells of one type; Int is int32_t or int64_t. `conn` are node numbers, (cells, nodes per cell), counted from the option
// `index_base`; a matrix has the nodes of a cell one after the other.
template <class Int>
struct Cells {
  fmc_cell_type type;
  View<const Int> conn;
};

// Part of a mesh on this rank: own nodes and their numbers in the whole mesh, cells of own nodes, their numbers and bodies. Int is
// int32_t or int64_t, the same on all ranks.
template <class Int>
struct MeshPart {
  Coords coords;
  View<const Int> node_numbers;
  View<const Cells<Int>> cells;
  View<const Int> cell_numbers;
  View<const Int> body_ids;
  double reach = 0;
};

// The nodes gathered of a mesh in parts: numbers in the whole mesh, the own node of each (-1 where there is none), and where they are.
struct GatheredNodes {
  std::vector<int64_t> numbers, own_nodes;
  std::vector<double> coords;
};

// Facets of one type, of surfaces that are given without cells; `conn` as of `Cells`, (facets, nodes per facet).
template <class Int>
struct Facets {
  fmc_facet_type type;
  View<const Int> conn;
};

namespace detail {

inline std::size_t nodes_of_facet(int32_t facet_type) {
  switch (facet_type) {
    case FMC_FACET_LINE2: return 2;
    case FMC_FACET_LINE3: case FMC_FACET_TRI3: return 3;
    case FMC_FACET_QUAD4: return 4;
    case FMC_FACET_TRI6: return 6;
    case FMC_FACET_QUAD8: return 8;
    case FMC_FACET_QUAD9: return 9;
    default: refuse(FMC_ERROR_UNKNOWN_CELL_TYPE, "no facet type has the number " + std::to_string(facet_type));
  }
}

inline std::size_t nodes_of(int32_t cell_type) {
  switch (cell_type) {
    case FMC_TRI3: return 3;
    case FMC_QUAD4: case FMC_TET4: return 4;
    case FMC_HEX8: case FMC_QUAD8: return 8;
    case FMC_WEDGE6: case FMC_TRI6: return 6;
    case FMC_PYRAMID5: return 5;
    case FMC_QUAD9: return 9;
    case FMC_TET10: return 10;
    case FMC_PYRAMID13: return 13;
    case FMC_WEDGE15: return 15;
    case FMC_HEX20: return 20;
    case FMC_HEX27: return 27;
    default: refuse(FMC_ERROR_UNKNOWN_CELL_TYPE, "no cell type has the number " + std::to_string(cell_type));
  }
}

// Number of rows of `nodes` numbers in a list of node numbers.
template <class Int>
std::size_t rows_of(View<const Int> conn, std::size_t nodes, const char *what) {
  if (conn.size() % nodes == 0 && (conn.row() == 0 || conn.row() == nodes)) return conn.size() / nodes;
  refuse(FMC_ERROR_LENGTH, std::string(what) + ": " + std::to_string(conn.size()) + " node numbers" +
                               (conn.row() > 0 ? " in rows of " + std::to_string(conn.row()) : std::string()) + ", not rows of " +
                               std::to_string(nodes));
}

// A list with one entry for each of `count`, or an empty one, which is NULL.
template <class T>
const T *one_for_each(View<const T> list, std::size_t count, const char *what) {
  if (list.empty()) return nullptr;
  if (list.size() != count)
    refuse(FMC_ERROR_LENGTH, std::string(what) + ": " + std::to_string(list.size()) + " entries, not " + std::to_string(count));
  return list.data();
}

// Blocks for the C interface, and their numbers of cells or facets.
template <class Block>
struct Blocks {
  std::vector<Block> list;
  std::size_t count = 0;
};
template <class Block, class Of>
Blocks<Block> blocks_of(View<const Of> given, std::size_t (*nodes)(int32_t), const char *what) {
  Blocks<Block> blocks;
  for (const auto &one : given) {
    const auto rows = rows_of(one.conn, nodes(one.type), what);
    const auto size = static_cast<int32_t>(sizeof(*one.conn.data()));
    blocks.list.push_back({one.type, size, one.conn.data(), rows});
    blocks.count += rows;
  }
  return blocks;
}

// Numbers in the width of a context, 4 or 8 bytes each: lists that go in and out of it as int64_t.
class Numbers {
 public:
  Numbers(int32_t size, std::size_t count) : size_(size), narrow_(size == 4 ? count : 0), wide_(size == 4 ? 0 : count) {}
  Numbers(int32_t size, View<const int64_t> list) : Numbers(size, list.size()) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (size_ == 4) narrow_[i] = checked(list[i]);
      else wide_[i] = list[i];
    }
  }
  void *data() { return size_ == 4 ? static_cast<void *>(narrow_.data()) : static_cast<void *>(wide_.data()); }
  template <class Int>
  std::vector<Int> as() const {
    return size_ == 4 ? std::vector<Int>(narrow_.begin(), narrow_.end()) : std::vector<Int>(wide_.begin(), wide_.end());
  }

 private:
  static int32_t checked(int64_t number) {
    if (number != static_cast<int32_t>(number))
      refuse(FMC_ERROR_LENGTH, std::to_string(number) + " does not fit into 32 bits, those of the context's numbers");
    return static_cast<int32_t>(number);
  }
  int32_t size_;
  std::vector<int32_t> narrow_;
  std::vector<int64_t> wide_;
};

}  // namespace detail

// A sparse matrix in compressed rows: row r has the entries from row_offsets[r] to row_offsets[r + 1].
template <class Int>
struct Csr {
  std::vector<Int> row_offsets, cols;
  std::vector<double> values;

  std::size_t rows() const noexcept { return row_offsets.empty() ? 0 : row_offsets.size() - 1; }
};

// A sparse matrix of the host in compressed rows that count from `base`, for `Context::set_basis` and `Condensation`.
template <class Int>
struct CsrView {
  View<const Int> row_offsets, cols;
  View<const double> values;
  int32_t base = 0;

  // As the C interface takes it.
  fmc_csr as_c() const {
    fmc_csr c;
    check(fmc_csr_init(&c));
    if (row_offsets.empty()) detail::refuse(FMC_ERROR_LENGTH, "row_offsets: empty, needed is one more than rows");
    const auto entries = static_cast<std::size_t>(row_offsets[row_offsets.size() - 1] - base);
    for (const auto found : {cols.size(), values.size()})
      if (found != entries)
        detail::refuse(FMC_ERROR_LENGTH, "cols and values: " + std::to_string(found) + " numbers, needed are " + std::to_string(entries));
    c.row_count = row_offsets.size() - 1;
    c.index_size = sizeof(Int), c.index_base = base;
    c.row_offsets = row_offsets.data(), c.cols = cols.data(), c.values = values.data();
    return c;
  }
};

// The tangent as entries, one for each pair of row and column.
struct Entries {
  std::vector<int64_t> rows, cols;
  std::vector<double> values;
};

// A term of rank one of the tangent, factor * vector * vector^T.
struct RankOne {
  double factor = 0;
  std::vector<double> vector;
};

// Rows and entries of the last tangent in compressed rows.
struct CsrSize {
  std::size_t rows = 0, entries = 0;
};

// Results of `Context::evaluate_tangent` other than the forces.
struct Evaluation {
  fmc_result result;
  std::size_t rank_one_count = 0;
};

// Nodes and boundary facets of the mesh, and its bodies.
struct Counts {
  std::size_t nodes = 0, facets = 0, bodies = 0;
};

// One warning: a value of `fmc_warning`, and a sentence.
struct Warning {
  int32_t code;
  std::string text;
};

// Kind of an obstacle's shape, a value of `fmc_shape_kind`, and its pose.
struct Obstacle {
  int32_t kind;
  Pose pose;
};

// The contact at every node, see `fmc_context_nodal_contact`: one entry for each, of `normal` and `friction` dim.
struct NodalContact {
  std::vector<double> pressure, gap, area, normal, friction, sliding;
  std::vector<int32_t> status;
  std::vector<double> local_pressure;

  // Allocates all arrays, and points to them.
  fmc_nodal_contact as_c(std::size_t nodes, std::size_t axes) {
    for (auto *field : {&pressure, &gap, &area, &sliding, &local_pressure}) field->resize(nodes);
    normal.resize(nodes * axes), friction.resize(nodes * axes), status.resize(nodes);
    fmc_nodal_contact to;
    check(fmc_nodal_contact_init(&to));
    to.pressure = pressure.data(), to.gap = gap.data(), to.area = area.data(), to.normal = normal.data();
    to.friction = friction.data(), to.sliding = sliding.data(), to.status = status.data();
    to.local_pressure = local_pressure.data();
    return to;
  }
};

// Weighted gaps, see `fmc_gap_constraint`, and their derivative by the degrees of freedom.
struct GapConstraints {
  std::vector<fmc_gap_constraint> rows;
  Csr<int64_t> gradient;
};

// Conductance of contacts: h by pressure where surfaces touch, by gap where they are apart, see `fmc_conductance`. None at first.
struct Conductance {
  std::vector<double> pressures, by_pressure, gaps, by_gap;

  // The same wherever surfaces touch.
  static Conductance constant(double h) {
    Conductance found;
    found.pressures = {0}, found.by_pressure = {h};
    return found;
  }
  // Valid while this object lives and is unchanged.
  fmc_conductance as_c() const {
    if (pressures.size() != by_pressure.size() || gaps.size() != by_gap.size())
      throw Error(FMC_ERROR_LENGTH, "a table of a conductance has columns of different lengths");
    fmc_conductance to;
    check(fmc_conductance_init(&to));
    to.pressure_count = pressures.size(), to.pressures = pressures.data(), to.by_pressure = by_pressure.data();
    to.gap_count = gaps.size(), to.gaps = gaps.data(), to.by_gap = by_gap.data();
    return to;
  }
};

// Flux out of nodes and obstacles, field after field, and its derivative by one field; rows and columns are nodes, then obstacles.
struct ContactFlux {
  std::vector<double> flux, of_obstacles;
  Csr<int64_t> matrix;
};

// Result of `contact_force`: the force on every node, (nodes, dim), and the overlap volume (2D: area).
struct ContactForces {
  std::vector<double> forces;
  double volume = 0;
};

// A step with friction for `contact_force`. The host accepts it by slip = next_slip and start = its end; the coordinates are
// not owned, as everywhere.
struct FrictionStep {
  Coords start;                   // coordinates at which it began
  Coords reference = {};          // those without deformation; empty: `start`
  std::vector<double> slip = {};  // elastic slip that was carried into it, (rows, 8); empty: none
  std::vector<double> next_slip = {};  // receives what is carried into the next one
};

}  // namespace fmc

#endif  // FMC_CONTACT_DATA_HPP
