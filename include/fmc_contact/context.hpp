// A mesh in contact, for many evaluations. Part of fmc_contact.hpp.
#ifndef FMC_CONTACT_CONTEXT_HPP
#define FMC_CONTACT_CONTEXT_HPP

#include "callbacks.hpp"
#include "data.hpp"
#include "shapes.hpp"

#include <algorithm>
#include <memory>

namespace fmc {

// Facets, search trees and obstacles of a mesh in contact, and the results of the last evaluation. It owns an `fmc_context`, and
// can be moved but not copied. Every method is the function `fmc_context_...` of its name, which documents shapes, signs, units
// and causes of failure. A failure throws `Error`. A call rethrows an exception of its callbacks.
//
// Threads: as in C. Const methods at once on one context, as long as no other runs; different contexts at once.
class Context : public AddsShapes<Context> {
 public:
  // Context from cells, in a block for each type, {{FMC_HEX8, hexes}, {FMC_TET4, tets}}, with 32-bit node numbers. `dim` is 2
  // or 3; `body_ids`, one for every cell over all blocks, may be left out: bodies are the connected components.
  Context(int dim, Coords coords, View<const Cells<int32_t>> cells, const Options &options, View<const int32_t> body_ids = {})
      : Context(dim, 4, [&](fmc_context **made) { return from_cells(dim, coords, cells, options, body_ids, made); }) {}
  // The same with 64-bit numbers. A context keeps the width of its numbers: rows and columns of tangents have the same width.
  Context(int dim, Coords coords, View<const Cells<int64_t>> cells, const Options &options, View<const int64_t> body_ids = {})
      : Context(dim, 8, [&](fmc_context **made) { return from_cells(dim, coords, cells, options, body_ids, made); }) {}

  // Context from the closed surfaces of bodies, in a block for each type of facet, {{FMC_FACET_TRI6, curved}, {FMC_FACET_TRI3, flat}}:
  // edges with the body to their left, others counter-clockwise seen from outside. `body_ids`: one for every facet.
  static Context from_facets(int dim, Coords coords, View<const Facets<int32_t>> facets, const Options &options,
                             View<const int32_t> body_ids = {}) {
    return of_facets(dim, coords, facets, options, body_ids);
  }
  static Context from_facets(int dim, Coords coords, View<const Facets<int64_t>> facets, const Options &options,
                             View<const int64_t> body_ids = {}) {
    return of_facets(dim, coords, facets, options, body_ids);
  }

  // Context of a mesh that ranks hold in parts. All ranks make the same calls: `set_coords` with the coordinates of their own nodes,
  // then the other functions with the coordinates of the gathered nodes.
  template <class Int>
  static Context from_part(int dim, const fmc_communicator &ranks, const MeshPart<Int> &part, const Options &options) {
    return Context(dim, sizeof(Int), [&](fmc_context **made) {
      const auto blocks = detail::blocks_of<fmc_cell_block>(part.cells, detail::nodes_of, "cells");
      fmc_mesh_part given;
      check(fmc_mesh_part_init(&given));
      given.coords = part.coords.as_c(dim);
      given.index_size = sizeof(Int);
      given.node_numbers = detail::one_for_each(part.node_numbers, given.coords.node_count, "node_numbers");
      given.blocks = blocks.list.data(), given.block_count = blocks.list.size();
      given.cell_numbers = detail::one_for_each(part.cell_numbers, blocks.count, "cell_numbers");
      given.body_ids = detail::one_for_each(part.body_ids, blocks.count, "body_ids");
      given.reach = part.reach;
      return fmc_context_new_from_part(dim, &ranks, &given, &options, made);
    });
  }

  int dim() const noexcept { return dim_; }
  // Bytes of the numbers of nodes, cells and degrees of freedom.
  int32_t index_size() const noexcept { return index_size_; }
  // For calls of the C interface. The wrapper still owns the context. Only the methods here support callbacks that
  // throw.
  fmc_context *get() const noexcept { return context_.get(); }

  void set_options(const Options &options) { call(fmc_context_set_options(get(), &options)); }
  // The options in force; their stiffness includes the factors of `stiffen`.
  Options options() const {
    Options options(0);
    check(fmc_context_options(get(), &options));
    return options;
  }
  Counts counts() const {
    Counts counts;
    check(fmc_context_counts(get(), &counts.nodes, &counts.facets, &counts.bodies));
    return counts;
  }
  // Number of nodes that the option `weld` has removed.
  size_t welded_node_count() const {
    size_t count = 0;
    check(fmc_context_welded_node_count(get(), &count));
    return count;
  }

  // Messages to the host, called at the end of an evaluation; empty: none. The evaluation rethrows its exception, and its
  // results are valid.
  void set_log(Log log) {
    auto next = log ? std::make_unique<detail::LogCall>(detail::LogCall{std::move(log), callbacks_.get()}) : nullptr;
    call(fmc_context_set_log(get(), next ? detail::LogCall::run : nullptr, next.get()));
    callbacks_->log = std::move(next);
  }
  // Called some twenty times a second during a call, on its thread: whether to end the call. Empty: none. An interrupted call
  // throws `FMC_ERROR_INTERRUPTED`, or the exception of the function, and the context is unchanged.
  void set_interrupt(Interrupt asked) {
    auto next = asked
        ? std::make_unique<detail::InterruptCall>(detail::InterruptCall{std::move(asked), callbacks_.get()})
        : nullptr;
    call(fmc_context_set_interrupt(get(), next ? detail::InterruptCall::run : nullptr, next.get()));
    callbacks_->interrupt = std::move(next);
  }

  // Forces at the current coordinates of all nodes, written into the host's array or, with the flag `FMC_EVALUATE_ADD`, added to
  // it.
  fmc_result evaluate(Coords coords, Forces forces, uint32_t flags = 0) {
    fmc_result result;
    const auto x = coords.as_c(dim_);
    const auto f = forces.as_c(dim_);
    call(fmc_context_evaluate(get(), &x, &f, flags, &result));
    return result;
  }
  // Without forces at nodes: overlap, energy, resultants.
  fmc_result evaluate(Coords coords) {
    fmc_result result;
    const auto x = coords.as_c(dim_);
    call(fmc_context_evaluate(get(), &x, nullptr, 0, &result));
    return result;
  }

  // Of the last evaluation: force and moment on bodies and obstacles, the pairs that overlap, warnings.
  fmc_resultant body(std::size_t index) const { return get_one<fmc_resultant>(fmc_context_body_resultant, index); }
  fmc_resultant obstacle(std::size_t index) const { return get_one<fmc_resultant>(fmc_context_obstacle_resultant, index); }
  fmc_pair_result pair(std::size_t index) const { return get_one<fmc_pair_result>(fmc_context_pair_result, index); }
  Warning warning(std::size_t index) const {
    int32_t code = 0;
    const char *text = nullptr;
    check(fmc_context_warning(get(), index, &code, &text));
    return {code, text};
  }
  std::vector<fmc_resultant> bodies() const { return get_all<fmc_resultant>(fmc_context_body_resultant); }
  std::vector<fmc_resultant> obstacles() const { return get_all<fmc_resultant>(fmc_context_obstacle_resultant); }
  std::vector<fmc_pair_result> pairs() const { return get_all<fmc_pair_result>(fmc_context_pair_result); }
  std::vector<Warning> warnings() const {
    std::vector<Warning> all;
    int32_t code = 0;
    const char *text = nullptr;
    while (more(fmc_context_warning(get(), all.size(), &code, &text))) all.push_back({code, text});
    return all;
  }

  // The tangent at `coords` in compressed rows, with flags of `fmc_context_tangent` (`FMC_TANGENT_SEMIDEFINITE`, `FMC_TANGENT_SYMMETRIC`) and of
  // `fmc_context_tangent_csr` (`FMC_CSR_BLOCKS`, `FMC_CSR_OBSTACLES`). Unsymmetric with friction. Terms of rank one,
  // which the law "volume" has, are not in it.
  template <class Int = int32_t>
  Csr<Int> tangent(Coords coords, uint32_t flags = 0) {
    find_tangent(coords, flags & ~layout);
    return tangent_csr<Int>(flags & layout);
  }
  // Finds the tangent and keeps it for the functions below; so does `evaluate_tangent`, together with the forces. Returns the number of
  // terms of rank one.
  std::size_t find_tangent(Coords coords, uint32_t flags = 0) {
    std::size_t count = 0;
    const auto x = coords.as_c(dim_);
    call(fmc_context_tangent(get(), &x, flags, &count));
    return count;
  }
  Evaluation evaluate_tangent(Coords coords, Forces forces, uint32_t flags = 0) {
    Evaluation found;
    const auto x = coords.as_c(dim_);
    const auto f = forces.as_c(dim_);
    call(fmc_context_evaluate_tangent(get(), &x, flags, &f, &found.result, &found.rank_one_count));
    return found;
  }
  CsrSize tangent_csr_size(uint32_t flags = 0) const {
    std::size_t offsets = 0, entries = 0;
    check(fmc_context_tangent_csr(get(), flags, nullptr, 0, &offsets, nullptr, nullptr, 0, &entries));
    return {offsets - 1, entries};
  }
  template <class Int = int32_t>
  Csr<Int> tangent_csr(uint32_t flags = 0) const {
    const auto block = (flags & FMC_CSR_BLOCKS) != 0 ? axes() * axes() : 1;
    return csr<Int>(block, [&](auto... arrays) { return fmc_context_tangent_csr(get(), flags, arrays...); });
  }
  // Into arrays of the host, of the lengths from `tangent_csr_size`, and with numbers of the context's width.
  template <class Int>
  void tangent_csr(uint32_t flags, View<Int> row_offsets, View<Int> cols, View<double> values) const {
    const auto block = (flags & FMC_CSR_BLOCKS) != 0 ? axes() * axes() : 1;
    if (sizeof(Int) != static_cast<std::size_t>(index_size_))
      detail::refuse(FMC_ERROR_INDEX_SIZE, "numbers of the context have " + std::to_string(index_size_) + " bytes");
    need(row_offsets.size(), tangent_csr_size(flags).rows + 1, "row_offsets");
    need(values.size(), cols.size() * block, "values");
    check(fmc_context_tangent_csr(get(), flags, row_offsets.data(), row_offsets.size(), nullptr, cols.data(), values.data(),
                                  cols.size(), nullptr));
  }
  Entries tangent_entries() const {
    std::size_t count = 0;
    check(fmc_context_tangent_entries(get(), nullptr, nullptr, nullptr, 0, &count));
    detail::Numbers rows(index_size_, count), cols(index_size_, count);
    std::vector<double> values(count);
    check(fmc_context_tangent_entries(get(), rows.data(), cols.data(), values.data(), count, nullptr));
    return {rows.as<int64_t>(), cols.as<int64_t>(), std::move(values)};
  }
  // y = tangent * x, terms of rank one included: dim numbers for every node and, if the length includes them, every obstacle.
  void tangent_product(View<const double> x, View<double> y) const {
    need(y.size(), x.size(), "y");
    check(fmc_context_tangent_product(get(), x.data(), y.data(), x.size()));
  }
  RankOne tangent_rank_one(std::size_t index) const {
    RankOne term;
    term.vector.resize(tangent_csr_size(FMC_CSR_OBSTACLES).rows);
    check(fmc_context_tangent_rank_one(get(), index, &term.factor, term.vector.data(), term.vector.size()));
    return term;
  }
  void keep_pattern(bool keep) { call(fmc_context_keep_pattern(get(), keep ? 1 : 0)); }
  void set_obstacle_rotations(bool on) { call(fmc_context_set_obstacle_rotations(get(), on ? 1 : 0)); }

  // Ranks that share the work, as filled in by `fmc_mpi.h` or the host; and their work.
  void set_communicator(const fmc_communicator &ranks) { call(fmc_context_set_communicator(get(), &ranks)); }
  void clear_communicator() { call(fmc_context_set_communicator(get(), nullptr)); }
  fmc_rank_counts rank_counts() const {
    fmc_rank_counts counts;
    check(fmc_context_rank_counts(get(), &counts));
    return counts;
  }

  // Sets the coordinates of the own nodes of a mesh in parts; true where other cells were gathered, with other numbers.
  bool set_coords(Coords own) {
    int32_t renumbered = 0;
    const auto x = own.as_c(dim_);
    call(fmc_context_set_coords(get(), &x, &renumbered));
    return renumbered != 0;
  }
  fmc_gathered_counts gathered_counts() const {
    fmc_gathered_counts counts;
    check(fmc_context_gathered_counts(get(), &counts));
    return counts;
  }
  GatheredNodes gathered_nodes() const {
    const std::size_t count = counts().nodes;
    detail::Numbers numbers(index_size_, count), own(index_size_, count);
    std::vector<double> coords(count * axes());
    check(fmc_context_gathered_nodes(get(), numbers.data(), own.data(), coords.data(), count, nullptr));
    return {numbers.as<int64_t>(), own.as<int64_t>(), std::move(coords)};
  }
  std::vector<int64_t> gathered_cells() const {
    std::size_t count = 0;
    check(fmc_context_gathered_cells(get(), nullptr, 0, &count));
    detail::Numbers numbers(index_size_, count);
    check(fmc_context_gathered_cells(get(), numbers.data(), count, nullptr));
    return numbers.as<int64_t>();
  }
  // Slip carried into the step, of all facets with slip, for a restart on any number of ranks.
  std::vector<fmc_carried_slip> carried_slip() const {
    return detail::rows<fmc_carried_slip>([&](auto... room) { return fmc_context_carried_slip(get(), room...); });
  }
  void set_carried_slip(View<const fmc_carried_slip> carried) {
    call(fmc_context_set_carried_slip(get(), carried.data(), carried.size()));
  }

  // Largest step of central differences for the contact alone; `masses`: one for every node.
  double stable_step(Coords coords, View<const double> masses) {
    double step = 0;
    const auto x = coords.as_c(dim_);
    call(fmc_context_stable_step(get(), &x, detail::one_for_each(masses, x.node_count, "masses"), &step));
    return step;
  }

  // Stiffness of every pair from the masses and the largest step of the bodies without contact.
  void stiffness_from_masses(Coords coords, View<const double> masses, double limit) {
    const auto x = coords.as_c(dim_);
    call(fmc_context_stiffness_from_masses(get(), &x, detail::one_for_each(masses, x.node_count, "masses"), limit));
  }

  // Part of a step in which no body passes through another.
  fmc_step_limit step_limit(Coords coords, Coords step) {
    fmc_step_limit limit;
    const auto x = coords.as_c(dim_), d = step.as_c(dim_);
    call(fmc_context_step_limit(get(), &x, &d, &limit));
    return limit;
  }

  // Closes gaps up to `close` and removes overlaps up to `remove` without strain; offsets of surfaces from their nodes.
  fmc_adjustment adjust(Coords coords, double close, double remove) {
    fmc_adjustment adjustment{};
    const auto x = coords.as_c(dim_);
    call(fmc_context_adjust(get(), &x, close, remove, &adjustment));
    return adjustment;
  }
  std::vector<double> offsets() const {
    return detail::rows<double>([&](auto... room) { return fmc_context_offsets(get(), room...); });
  }
  void set_offsets(View<const double> offsets) { call(fmc_context_set_offsets(get(), offsets.data(), offsets.size())); }

  // The law "fiber": keeps the patches found at `coords`, and returns the number of directions; or releases them.
  std::size_t keep_patches(Coords coords) {
    std::size_t directions = 0;
    const auto x = coords.as_c(dim_);
    call(fmc_context_keep_patches(get(), &x, &directions));
    return directions;
  }
  void release_patches() { call(fmc_context_keep_patches(get(), nullptr, nullptr)); }

  // Friction: steps begun and accepted, friction frozen for outer iterations, the elastic slip for a restart, (rows, 8).
  void begin_step(Coords coords) { at(fmc_context_begin_step, coords); }
  void commit_step(Coords coords) { at(fmc_context_commit_step, coords); }
  void freeze_friction(Coords coords) { at(fmc_context_freeze_friction, coords); }
  void release_friction() { call(fmc_context_freeze_friction(get(), nullptr)); }
  std::vector<double> slip() const {
    return detail::rows<double>([&](auto... room) { return fmc_context_slip(get(), room...); });
  }
  void set_slip(View<const double> slip) { call(fmc_context_set_slip(get(), slip.data(), slip.size())); }

  // Wear: coefficients of both sides of a pair, depth at every node, volume of every body, and (rows, 4) for a restart; number of
  // cycles that a step represents.
  void set_pair_wear(Partner a, Partner b, double wear_a, double wear_b) {
    call(fmc_context_set_pair_wear(get(), a.kind, a.index, b.kind, b.index, wear_a, wear_b));
  }
  std::array<double, 2> pair_wear(Partner a, Partner b) const {
    std::array<double, 2> found{};
    check(fmc_context_pair_wear(get(), a.kind, a.index, b.kind, b.index, &found[0], &found[1]));
    return found;
  }
  std::vector<double> worn_depth() const {
    return detail::rows<double>([&](auto... room) { return fmc_context_worn_depth(get(), room...); });
  }
  std::vector<double> worn_volumes() const {
    return detail::rows<double>([&](auto... room) { return fmc_context_worn_volumes(get(), room...); });
  }
  std::vector<double> worn_facets() const {
    return detail::rows<double>([&](auto... room) { return fmc_context_worn_facets(get(), room...); });
  }
  void set_worn_facets(View<const double> worn) { call(fmc_context_set_worn_facets(get(), worn.data(), worn.size())); }
  void set_wear_cycles(double cycles) { call(fmc_context_set_wear_cycles(get(), cycles)); }

  // Equilibrium of the contact with condensed bodies, of stiffness (n, n) and residual (n) on n degrees of freedom; `fixed`: others
  // that do not move; `place` moves the nodes that follow.
  ContactStep contact_step(Coords coords, View<const int64_t> dofs, View<const double> stiffness, View<const double> residual,
                           View<const int64_t> fixed = {}, const Place &place = {},
                           const ContactStepOptions &options = {}) {
    const auto count = dofs.size();
    if (stiffness.size() != count * count)
      detail::refuse(FMC_ERROR_LENGTH, "stiffness: " + std::to_string(stiffness.size()) + " numbers, not " +
                                           std::to_string(count * count));
    const auto x = coords.as_c(dim_);
    detail::PlaceCall placing{place, x.node_count * axes(), nullptr};
    ContactStep step;
    step.displacement.resize(count);
    detail::Numbers list(index_size_, dofs), others(index_size_, fixed);
    const auto status = fmc_context_contact_step(
        get(), &x, &options, list.data(), count, others.data(), fixed.size(), stiffness.data(),
        detail::one_for_each(residual, count, "residual"), place ? detail::PlaceCall::run : nullptr, &placing,
        step.displacement.data(), &step);
    if (placing.thrown) std::rethrow_exception(placing.thrown);
    call(status);
    return step;
  }

  // The law "depth": coordinates without deformation; planes of symmetry by a point in each and its normal, in dense rows of dim
  // numbers, or by the nodes in them. Empty lists: no planes.
  void set_reference(Coords coords) { at(fmc_context_set_reference, coords); }
  void set_symmetry_planes(View<const double> points, View<const double> normals) {
    std::size_t count = points.size() / static_cast<std::size_t>(dim());
    detail::one_for_each(points, count * static_cast<std::size_t>(dim()), "points");
    detail::one_for_each(normals, points.size(), "normals");
    call(fmc_context_set_symmetry_planes(get(), points.data(), normals.data(), count));
  }
  void set_symmetry_nodes(View<const int64_t> nodes) {
    detail::Numbers numbers(index_size_, nodes);
    call(fmc_context_set_symmetry_nodes(get(), numbers.data(), nodes.size()));
  }

  // Names a part of the surface by places in `boundary_facets`, counted from 0; returns its number, 1, 2, ..., for `surface_a` and
  // `surface_b` of the options of a pair.
  int32_t add_surface(View<const std::size_t> facets) {
    int32_t surface = 0;
    call(fmc_context_add_surface(get(), facets.data(), facets.size(), &surface));
    return surface;
  }

  // Straight faces that meet at less than this angle, in degrees, represent a smooth surface; 0: none.
  void set_surface_smoothing(double feature_angle) { call(fmc_context_set_surface_smoothing(get(), feature_angle)); }

  // Unknowns of the host by which the nodes of the mesh move: one row for every node, one column for every unknown.
  template <class Int>
  void set_basis(const CsrView<Int> &weights, std::size_t unknown_count) {
    const auto c = weights.as_c();
    call(fmc_context_set_basis(get(), &c, unknown_count));
  }
  void clear_basis() { call(fmc_context_set_basis(get(), nullptr, 0)); }

  // The surface: its facets, and the matrix from nodes to the points of facets, contact points and gaps.
  std::vector<fmc_boundary_facet> boundary_facets() const {
    return detail::rows<fmc_boundary_facet>([&](auto... room) { return fmc_context_boundary_facets(get(), room...); });
  }
  Csr<int64_t> point_weights() const {
    return csr<int64_t>(1, [&](auto... arrays) { return fmc_context_point_weights(get(), arrays...); });
  }

  // The contact at `coords`: at nodes, at points, and as constraints of nodes within `reach` of a partner.
  NodalContact nodal_contact(Coords coords) {
    const auto x = coords.as_c(dim_);
    const auto nodes = counts().nodes;
    NodalContact at;
    const auto to = at.as_c(nodes, axes());
    call(fmc_context_nodal_contact(get(), &x, &to));
    return at;
  }
  // The derivatives of `energy` * w + `adjoint` . F, see `fmc_context_vjp`; an adjoint without nodes means zeros. `to` selects the
  // derivatives, and receives them; derivatives by pairs are returned.
  std::vector<fmc_pair_gradient> vjp(Coords coords, double energy, Coords adjoint, const Gradients& to) {
    const auto x = coords.as_c(dim_), a = adjoint.as_c(dim_);
    const auto* forces = a.node_count == 0 ? nullptr : &a;
    std::vector<fmc_pair_gradient> pairs(16);
    for (;;) {
      std::size_t count = 0;
      const auto status = fmc_context_vjp(get(), &x, energy, forces, &to, pairs.data(), pairs.size(), &count);
      if (status == FMC_ERROR_BUFFER_TOO_SMALL) {
        pairs.resize(8 * pairs.size());
        continue;
      }
      call(status);
      pairs.resize(count);
      return pairs;
    }
  }
  // Rates of energy and forces along rates of their variables, see `fmc_context_jvp`.
  Slopes jvp(Coords coords, const Directions& along) {
    const auto x = coords.as_c(dim_);
    Slopes found;
    found.forces.resize(x.node_count * axes());
    call(fmc_context_jvp(get(), &x, &along, &found.energy, found.forces.data()));
    return found;
  }
  std::vector<fmc_contact_point> contact_points(Coords coords) {
    const auto x = coords.as_c(dim_);
    return found<fmc_contact_point>([&](auto... room) { return fmc_context_contact_points(get(), &x, room...); });
  }
  GapConstraints gap_constraints(Coords coords, double reach) {
    const auto x = coords.as_c(dim_);
    GapConstraints gaps;
    gaps.rows = found<fmc_gap_constraint>([&](auto... room) { return fmc_context_gap_constraints(get(), &x, reach, room...); });
    gaps.gradient = csr<int64_t>(1, [&](auto... arrays) { return fmc_context_gap_gradient(get(), arrays...); });
    return gaps;
  }

  // Flux of one or several fields through the contact, field after field, with values for every row of `coords`, and for every
  // obstacle. Without values for obstacles there is no flux into them. See `fmc_context_flux`.
  ContactFlux flux(Coords coords, const Conductance& conductance, const std::vector<double>& fields,
                   const std::vector<double>& of_obstacles = {}) {
    const auto x = coords.as_c(dim_);
    const auto tables = conductance.as_c();
    const std::size_t count = x.node_count == 0 ? 0 : fields.size() / x.node_count;
    ContactFlux found;
    found.flux.resize(fields.size()), found.of_obstacles.resize(of_obstacles.size());
    const auto* others = of_obstacles.empty() ? nullptr : of_obstacles.data();
    auto* into = of_obstacles.empty() ? nullptr : found.of_obstacles.data();
    call(fmc_context_flux(get(), &x, &tables, count, fields.data(), others, found.flux.data(), into));
    found.matrix = csr<int64_t>(1, [&](auto... arrays) { return fmc_context_flux_matrix(get(), arrays...); });
    return found;
  }

  // The energy that friction has dissipated since the step began, as heat at nodes. Effusivities, one for every body and then for every
  // obstacle, divide it; see `fmc_context_friction_heat`.
  std::vector<double> friction_heat(Coords coords, const std::vector<double>& effusivities = {}) {
    const auto x = coords.as_c(dim_);
    std::vector<double> heat(x.node_count);
    const auto* given = effusivities.empty() ? nullptr : effusivities.data();
    call(fmc_context_friction_heat(get(), &x, given, heat.data(), nullptr));
    return heat;
  }

  // The tie of two bodies; its area is 0 where they are not tied.
  fmc_tie tie(std::size_t a, std::size_t b) const {
    fmc_tie result{};
    check(fmc_context_tie(get(), a, b, &result));
    return result;
  }
  // Traction and jump of all ties.
  std::vector<fmc_tie_node> tie_nodes(Coords coords) {
    const auto x = coords.as_c(dim_);
    return found<fmc_tie_node>([&](auto... room) { return fmc_context_tie_nodes(get(), &x, room...); });
  }
  // All ties as equations of the coordinates, by degrees of freedom that count from 0.
  Csr<int64_t> tie_constraints() const {
    return csr<int64_t>(1, [&](auto... arrays) { return fmc_context_tie_constraints(get(), arrays...); });
  }

  // Ties two parts of the surface, of two bodies or of one; `period`, one number for every axis, is the shift from part B to part A.
  // Returns its number.
  int32_t add_tie(int32_t surface_a, int32_t surface_b, View<const double> period, double reach = 0) {
    int32_t tie = 0;
    detail::one_for_each(period, static_cast<std::size_t>(dim()), "period");
    call(fmc_context_add_tie(get(), surface_a, surface_b, period.data(), reach, &tie));
    return tie;
  }
  void remove_tie(int32_t tie) { call(fmc_context_remove_tie(get(), tie)); }
  // Jump of such a tie: distance of part A from part B in addition to the period.
  void set_tie_jump(int32_t tie, View<const double> jump) {
    detail::one_for_each(jump, static_cast<std::size_t>(dim()), "jump");
    call(fmc_context_set_tie_jump(get(), tie, jump.data()));
  }
  fmc_tie added_tie(int32_t tie) const {
    fmc_tie result{};
    check(fmc_context_added_tie(get(), tie, &result));
    return result;
  }
  // Force of such a tie on part A.
  std::vector<double> tie_force(Coords coords, int32_t tie) {
    const auto x = coords.as_c(dim_);
    std::vector<double> force(static_cast<std::size_t>(dim()));
    call(fmc_context_tie_force(get(), &x, tie, force.data(), force.size(), nullptr));
    return force;
  }

  // The cohesive interface of two bodies at coordinates; its area is 0 where they have none.
  fmc_cohesive cohesive(std::size_t a, std::size_t b, Coords coords) {
    const auto x = coords.as_c(dim_);
    fmc_cohesive result{};
    call(fmc_context_cohesive(get(), a, b, &x, &result));
    return result;
  }
  // All points of cohesive interfaces, in the order of their damage.
  std::vector<fmc_cohesive_point> cohesive_points(Coords coords) {
    const auto x = coords.as_c(dim_);
    return found<fmc_cohesive_point>([&](auto... room) { return fmc_context_cohesive_points(get(), &x, room...); });
  }
  // Damage of all points and energy per area that they have dissipated, two numbers for each; see `fmc_context_damage`.
  std::vector<double> damage() const {
    return detail::rows<double>([&](auto... room) { return fmc_context_damage(get(), room...); });
  }
  void set_damage(View<const double> damage) { call(fmc_context_set_damage(get(), damage.data(), damage.size())); }
  // Further state of these points, from friction and viscosity, five numbers for each; see `fmc_context_cohesive_history`.
  std::vector<double> cohesive_history() const {
    return detail::rows<double>([&](auto... room) { return fmc_context_cohesive_history(get(), room...); });
  }
  void set_cohesive_history(View<const double> history) {
    call(fmc_context_set_cohesive_history(get(), history.data(), history.size()));
  }
  // Duration of a step, for the viscosity of cohesive interfaces.
  void set_time_step(double time_step) { call(fmc_context_set_time_step(get(), time_step)); }

  // Updates the multipliers by the penetration, see `fmc_context_augment`.
  fmc_augmentation augment(Coords coords, double tolerance, double reach = 0) {
    const auto x = coords.as_c(dim_);
    fmc_augmentation result{};
    call(fmc_context_augment(get(), &x, reach, tolerance, &result));
    return result;
  }
  // Multiplies the stiffness of the laws; see `fmc_context_stiffen`.
  void stiffen(double factor) { call(fmc_context_stiffen(get(), factor)); }
  std::vector<fmc_multiplier> multipliers() const {
    return detail::rows<fmc_multiplier>([&](auto... room) { return fmc_context_multipliers(get(), room...); });
  }
  void set_multipliers(const std::vector<fmc_multiplier> &multipliers) {
    call(fmc_context_set_multipliers(get(), multipliers.data(), multipliers.size()));
  }

  void set_pair_options(Partner a, Partner b, const PairOptions &options) {
    call(fmc_context_set_pair_options(get(), a.kind, a.index, b.kind, b.index, &options));
  }
  // The same with another coefficient of friction across a direction.
  void set_orthotropic_pair(Partner a, Partner b, const PairOptions &options, const OrthotropicFriction &friction) {
    call(fmc_context_set_orthotropic_pair(get(), a.kind, a.index, b.kind, b.index, &options, &friction));
  }
  // The same with shapes of the cohesive law of `FMC_SOFTENING_PPR`.
  void set_ppr_pair(Partner a, Partner b, const PairOptions &options, const Ppr &ppr) {
    call(fmc_context_set_ppr_pair(get(), a.kind, a.index, b.kind, b.index, &options, &ppr));
  }
  // The same with your own law for `FMC_INTERFACE_LAW`, of bodies a and b; every point keeps `history_count` numbers.
  void set_law_pair(std::size_t a, std::size_t b, const PairOptions &options, InterfaceLaw law, std::size_t history_count = 0) {
    auto next = std::make_unique<detail::LawCall>(detail::LawCall{std::move(law), &callbacks_->thrown});
    const auto given = next->as_c(history_count);
    // The place first: once the library has the pointer, nothing may fail.
    auto &place = callbacks_->laws[std::minmax(a, b)];
    call(fmc_context_set_law_pair(get(), FMC_PARTNER_BODY, a, FMC_PARTNER_BODY, b, &options, &given));
    place = std::move(next);
  }
  // The same with your own law of friction; every facet keeps `history_count` numbers for each of its partners.
  void set_friction_law_pair(Partner a, Partner b, const PairOptions &options, FrictionLaw law, std::size_t history_count = 0) {
    auto next = std::make_unique<detail::FrictionLawCall>(detail::FrictionLawCall{std::move(law), &callbacks_->thrown});
    const auto given = next->as_c(history_count);
    // The place first: once the library has the pointer, nothing may fail.
    const std::pair<int32_t, std::size_t> one{a.kind, a.index}, other{b.kind, b.index};
    auto &place = callbacks_->friction_laws[std::minmax(one, other)];
    call(fmc_context_set_friction_law_pair(get(), a.kind, a.index, b.kind, b.index, &options, &given));
    place = std::move(next);
  }
  // History of your laws of friction after the committed steps, in the order of the slip.
  std::vector<double> friction_history() const {
    return detail::rows<double>([&](auto... room) { return fmc_context_friction_history(get(), room...); });
  }
  void set_friction_history(View<const double> history) {
    call(fmc_context_set_friction_history(get(), history.data(), history.size()));
  }
  // Fields that your own laws receive, (rows of coordinates, field_count).
  void set_law_fields(View<const double> values, std::size_t field_count) {
    const auto each = field_count == 0 ? 1 : field_count;
    if (values.size() % each != 0) detail::refuse(FMC_ERROR_LENGTH, "values has one number for every field of a row");
    call(fmc_context_set_law_fields(get(), values.data(), values.size() / each, field_count));
  }
  // All points of interfaces by your own laws, in the order of their history.
  std::vector<fmc_law_point> law_points(Coords coords) {
    const auto x = coords.as_c(dim_);
    return found<fmc_law_point>([&](auto... room) { return fmc_context_law_points(get(), &x, room...); });
  }
  // The history of all these points, after the steps that were committed.
  std::vector<double> law_history() const {
    return detail::rows<double>([&](auto... room) { return fmc_context_law_history(get(), room...); });
  }
  void set_law_history(View<const double> history) {
    call(fmc_context_set_law_history(get(), history.data(), history.size()));
  }
  // The pair follows the options of the context again.
  void clear_pair_options(Partner a, Partner b) {
    call(fmc_context_set_pair_options(get(), a.kind, a.index, b.kind, b.index, nullptr));
  }
  PairOptions pair_options(Partner a, Partner b) const {
    PairOptions options;
    check(fmc_context_pair_options(get(), a.kind, a.index, b.kind, b.index, &options));
    return options;
  }
  // Its direction is 0 where friction is the same in all directions.
  OrthotropicFriction orthotropic_pair(Partner a, Partner b) const {
    OrthotropicFriction friction;
    check(fmc_context_orthotropic_pair(get(), a.kind, a.index, b.kind, b.index, &friction));
    return friction;
  }
  // The default ones where the softening is another.
  Ppr ppr_pair(Partner a, Partner b) const {
    Ppr ppr;
    check(fmc_context_ppr_pair(get(), a.kind, a.index, b.kind, b.index, &ppr));
    return ppr;
  }

  // Adds a rigid obstacle; `add_ball` and the like make a shape and add it. Returns the index, which an obstacle keeps when
  // others are removed.
  std::size_t add_obstacle(const Shape &shape, const Pose &pose = {}) {
    detail::ShapeArrays arrays;
    const fmc_shape &fields = shape.as_c(dim_, arrays, callbacks_.get());
    // The place for its functions first: once the library has their pointers, nothing may fail.
    std::map<std::size_t, detail::Distances> place;
    place.emplace(0, std::move(arrays.distances));
    std::size_t index = 0;
    call(fmc_context_add_obstacle(get(), &fields, &pose, &index));
    auto node = place.extract(place.begin());
    node.key() = index;
    callbacks_->distances.insert(std::move(node));
    return index;
  }
  Obstacle obstacle_shape(std::size_t obstacle) const {
    Obstacle found{};
    check(fmc_context_obstacle_shape(get(), obstacle, &found.kind, &found.pose));
    return found;
  }
  // The whole pose: to move an obstacle only, change the position of `obstacle_shape(obstacle).pose`.
  void set_pose(std::size_t obstacle, const Pose &pose) { call(fmc_context_set_pose(get(), obstacle, &pose)); }
  void remove_obstacle(std::size_t obstacle) {
    call(fmc_context_remove_obstacle(get(), obstacle));
    callbacks_->distances.erase(obstacle);
  }

 private:
  static constexpr uint32_t layout = FMC_CSR_BLOCKS | FMC_CSR_OBSTACLES;
  struct Free {
    void operator()(fmc_context *context) const noexcept { fmc_context_free(&context); }
  };

  template <class Make, class = std::enable_if_t<std::is_invocable_v<Make, fmc_context **>>>
  Context(int dim, int32_t index_size, const Make &make) : dim_(dim), index_size_(index_size) {
    fmc_context *made = nullptr;
    check(make(&made));
    context_.reset(made);
  }
  template <class Int>
  static fmc_status from_cells(int dim, const Coords &coords, View<const Cells<Int>> cells, const Options &options,
                               View<const Int> body_ids, fmc_context **made) {
    const auto blocks = detail::blocks_of<fmc_cell_block>(cells, detail::nodes_of, "cells");
    const auto x = coords.as_c(dim);
    const auto *ids = detail::one_for_each(body_ids, blocks.count, "body_ids");
    return fmc_context_new_from_cells(dim, &x, blocks.list.data(), blocks.list.size(), ids, &options, made);
  }
  template <class Int>
  static Context of_facets(int dim, const Coords &coords, View<const Facets<Int>> facets, const Options &options,
                           View<const Int> body_ids) {
    return Context(dim, sizeof(Int), [&](fmc_context **made) {
      const auto blocks = detail::blocks_of<fmc_facet_block>(facets, detail::nodes_of_facet, "facets");
      const auto x = coords.as_c(dim);
      const auto *ids = detail::one_for_each(body_ids, blocks.count, "body_ids");
      return fmc_context_new_from_facets(dim, &x, blocks.list.data(), blocks.list.size(), ids, &options, made);
    });
  }
  // A matrix from a function of the C interface, with `block` numbers per entry.
  template <class Int, class Function>
  Csr<Int> csr(std::size_t block, const Function &function) const {
    using Array = void *;
    using Count = std::size_t *;
    std::size_t offset_count = 0, count = 0;
    check(function(Array(nullptr), std::size_t(0), &offset_count, Array(nullptr), static_cast<double *>(nullptr), std::size_t(0),
                   &count));
    detail::Numbers offsets(index_size_, offset_count), cols(index_size_, count);
    std::vector<double> values(count * block);
    check(function(offsets.data(), offset_count, Count(nullptr), cols.data(), values.data(), count, Count(nullptr)));
    return {offsets.as<Int>(), cols.as<Int>(), std::move(values)};
  }

  std::size_t axes() const noexcept { return static_cast<std::size_t>(dim_); }
  // The end of every call that may have called a callback: rethrows the callback's exception.
  template <class T, class Give>
  std::vector<T> found(const Give &give) {
    return detail::rows<T>(give, [this](fmc_status status) { call(status); });
  }
  void call(fmc_status status) {
    if (callbacks_) callbacks_->rethrow();
    check(status);
  }
  void at(fmc_status (*function)(fmc_context *, const fmc_coords *), const Coords &coords) {
    const auto x = coords.as_c(dim_);
    call(function(get(), &x));
  }
  static void need(std::size_t length, std::size_t expected, const char *what) {
    if (length != expected)
      detail::refuse(FMC_ERROR_LENGTH,
                     std::string(what) + " has " + std::to_string(length) + " entries, not " + std::to_string(expected));
  }
  template <class T>
  T get_one(fmc_status (*getter)(const fmc_context *, std::size_t, T *), std::size_t index) const {
    T one;
    check(getter(get(), index, &one));
    return one;
  }
  // Whether a getter has found one more; there are none before the first evaluation.
  static bool more(fmc_status status) {
    if (status != FMC_ERROR_INDEX_OUT_OF_RANGE) check(status);
    return status == FMC_OK;
  }
  template <class T>
  std::vector<T> get_all(fmc_status (*getter)(const fmc_context *, std::size_t, T *)) const {
    std::vector<T> all;
    T one;
    while (more(getter(get(), all.size(), &one))) all.push_back(one);
    return all;
  }

  int dim_ = 0;
  // Bytes of the numbers in all lists of the context.
  int32_t index_size_ = 4;
  // Ends after the context, which has pointers to it.
  std::unique_ptr<detail::Callbacks> callbacks_ = std::make_unique<detail::Callbacks>();
  std::unique_ptr<fmc_context, Free> context_;
};

}  // namespace fmc

#endif  // FMC_CONTACT_CONTEXT_HPP
