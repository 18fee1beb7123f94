// Every function of the wrapper, each beside something else that must say the same.
//
//   c++ -std=c++17 everything.cpp $(pkg-config --cflags --libs fmc_contact)
#include "expect.hpp"

#include <cmath>
#include <cstring>

namespace {

using Numbers = std::vector<double>;

// Two squares, the second 0.01 deep in the first.
const Numbers coords = {0, 0, 1, 0, 1, 1, 0, 1, 0.99, 0.1, 1.99, 0.1, 1.99, 0.9, 0.99, 0.9};
const std::vector<int32_t> quads = {0, 1, 2, 3, 4, 5, 6, 7};
const std::vector<double> cube = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
const std::vector<int32_t> hex = {0, 1, 2, 3, 4, 5, 6, 7};

bool close(double a, double b, double tolerance) { return std::fabs(a - b) <= tolerance * std::fmax(1.0, std::fabs(b)); }

void of_the_library() {
  EXPECT(fmc::version() == fmc_version() && fmc::abi_version() == FMC_ABI_VERSION);
  EXPECT(!fmc::has_feature("tangent"));
  EXPECT(fmc::suggest_stiffness(1e6, 10) == 1e6);
  EXPECT(fmc::suggest_stiffness(1e6, 0.1, FMC_LAW_VOLUME, 2) == 1e6);
  EXPECT(refused(FMC_ERROR_NOT_POSITIVE, "modulus", [] { fmc::suggest_stiffness(-1, 1); }));
}

void forces_and_getters() {
  fmc::Options options(1e5);
  fmc::Context contact(2, coords, {{FMC_QUAD4, quads}}, options);
  Numbers forces(16), twice(16);
  const auto result = contact.evaluate(coords, forces);
  contact.evaluate(coords, twice);
  contact.evaluate(coords, twice, FMC_EVALUATE_ADD);
  for (std::size_t k = 0; k < 16; ++k) EXPECT(twice[k] == 2 * forces[k]);
  EXPECT(contact.evaluate(coords).energy == result.energy && contact.get() != nullptr && contact.dim() == 2);
  const auto counts = contact.counts();
  EXPECT(counts.nodes == 8 && counts.facets == 8 && counts.bodies == 2);
  EXPECT(contact.bodies().size() == 2 && contact.pairs().size() == 1);
  EXPECT(contact.obstacles().empty() && contact.warnings().empty());
  EXPECT(contact.bodies()[1].force[0] == contact.body(1).force[0] && contact.pair(0).volume == result.volume);
  EXPECT(refused(FMC_ERROR_INDEX_OUT_OF_RANGE, "", [&] { contact.pair(1); }));
  EXPECT(refused(FMC_ERROR_INDEX_OUT_OF_RANGE, "", [&] { contact.warning(0); }));
  options.stiffness = 2e5;
  contact.set_options(options);
  EXPECT(close(contact.evaluate(coords).energy, 2 * result.energy, 1e-14));

  // Nobody ends a call.
  contact.set_interrupt([] { return false; });
  EXPECT(close(contact.evaluate(coords).energy, 2 * result.energy, 1e-14));
  contact.set_interrupt({});

  // The pair with a law of its own, left out, and as before.
  const auto a = fmc::Partner::body(0), b = fmc::Partner::body(1);
  fmc::PairOptions own;
  own.law = FMC_LAW_DEPTH;
  own.stiffness = 1e5;
  contact.set_pair_options(a, b, own);
  EXPECT(contact.evaluate(coords).energy == result.energy && contact.pair_options(b, a).stiffness == 1e5);
  own = fmc::PairOptions();
  own.excluded = 1;
  contact.set_pair_options(a, b, own);
  EXPECT(contact.evaluate(coords).pair_count == 0);

  // Tied, each row of weights adds up to 0, and the tractions are the force.
  own = fmc::PairOptions();
  own.interface_kind = FMC_INTERFACE_TIED;
  own.reach = 0.5;
  contact.set_pair_options(a, b, own);
  contact.evaluate(coords);
  const auto tie = contact.tie(0, 1);
  EXPECT(tie.area > 0 && tie.node_count > 0 && contact.pair_options(a, b).interface_kind == FMC_INTERFACE_TIED);
  double pulled = 0;
  for (const auto &node : contact.tie_nodes(coords)) pulled += node.traction[0] * node.area * (node.body == 1 ? 1 : -1);
  EXPECT(close(pulled, contact.body(1).force[0], 1e-12));
  if (tie.largest_gap == 0) {
    const auto equations = contact.tie_constraints();
    EXPECT(equations.rows() == 2 * tie.node_count);
  } else {
    EXPECT(refused(FMC_ERROR_UNSUPPORTED, "gap", [&] { contact.tie_constraints(); }));
  }
  // A tie conducts by its area, and what leaves one body enters the other.
  std::vector<double> warm(contact.counts().nodes, 1.0);
  const auto no_flux = contact.flux(coords, fmc::Conductance::constant(2), warm);
  for (const auto q : no_flux.flux) EXPECT(q == 0);
  EXPECT(no_flux.matrix.rows() == warm.size() && no_flux.of_obstacles.empty());
  for (std::size_t node = 0; node < warm.size(); ++node) warm[node] = double(node % 3);
  double through = 0, power = 0;
  const auto conducted = contact.flux(coords, fmc::Conductance::constant(2), warm);
  for (std::size_t node = 0; node < warm.size(); ++node) through += conducted.flux[node], power += conducted.flux[node] * warm[node];
  EXPECT(power > 0 && std::abs(through) < 1e-12 * power);
  auto negative = fmc::Conductance::constant(-1);
  EXPECT(refused(FMC_ERROR_NOT_POSITIVE, "by_pressure", [&] { contact.flux(coords, negative, warm); }));
  // Held together until it breaks, with damage that is set.
  own = fmc::PairOptions();
  own.interface_kind = FMC_INTERFACE_COHESIVE;
  own.normal_strength = 1;
  own.normal_energy = 0.1;
  own.reach = 0.5;
  contact.set_pair_options(a, b, own);
  const auto glue = contact.cohesive(0, 1, coords);
  EXPECT(glue.area == tie.area && glue.point_count == contact.cohesive_points(coords).size() && glue.damaged_area <= glue.area);
  auto damage = contact.damage();
  EXPECT(damage.size() == 2 * glue.point_count);
  damage[0] = 1;
  contact.set_damage(damage);
  EXPECT(contact.damage() == damage && contact.cohesive(0, 1, coords).broken_area > 0);
  EXPECT(refused(FMC_ERROR_LENGTH, "damage", [&] { contact.set_damage({1.0}); }));
  auto past = contact.cohesive_history();
  EXPECT(past.size() == 5 * glue.point_count);
  past[2] = 0.25;
  contact.set_cohesive_history(past);
  EXPECT(contact.cohesive_history() == past && contact.cohesive(0, 1, coords).rubbed > 0);
  EXPECT(refused(FMC_ERROR_LENGTH, "history", [&] { contact.set_cohesive_history({1.0}); }));
  // With a viscosity a step has a length in time.
  own.viscosity = 0.5;
  contact.set_pair_options(a, b, own);
  EXPECT(refused(FMC_ERROR_UNSUPPORTED, "without a time step", [&] { contact.cohesive(0, 1, coords); }));
  EXPECT(refused(FMC_ERROR_NOT_POSITIVE, "time_step", [&] { contact.set_time_step(0); }));
  contact.set_time_step(0.1);
  EXPECT(contact.cohesive(0, 1, coords).viscous >= 0);
  // Sliding without separation, the tractions are the force too; rough, the pair is in contact again.
  own = fmc::PairOptions();
  own.interface_kind = FMC_INTERFACE_NO_SEPARATION;
  own.reach = 0.5;
  contact.set_pair_options(a, b, own);
  contact.evaluate(coords);
  pulled = 0;
  for (const auto &node : contact.tie_nodes(coords)) pulled += node.traction[0] * node.area * (node.body == 1 ? 1 : -1);
  EXPECT(contact.tie(0, 1).area == tie.area && close(pulled, contact.body(1).force[0], 1e-12));
  EXPECT(refused(FMC_ERROR_UNSUPPORTED, "do not separate", [&] { contact.tie_constraints(); }));
  own = fmc::PairOptions();
  own.interface_kind = FMC_INTERFACE_ROUGH;
  contact.set_pair_options(a, b, own);
  EXPECT(contact.pair_options(b, a).interface_kind == FMC_INTERFACE_ROUGH && contact.tie(0, 1).area == 0);
  // Shapes of a cohesive law come back; other softenings have none.
  own = fmc::PairOptions();
  own.interface_kind = FMC_INTERFACE_COHESIVE;
  own.normal_strength = own.normal_energy = 1;
  own.reach = 0.5;
  fmc::Ppr ppr;
  ppr.normal_shape = 5, ppr.shear_slope = 0.2;
  EXPECT(refused(FMC_ERROR_OPTIONS_CONFLICT, "'ppr'", [&] { contact.set_ppr_pair(a, b, own, ppr); }));
  own.softening = FMC_SOFTENING_PPR;
  contact.set_ppr_pair(a, b, own, ppr);
  EXPECT(contact.ppr_pair(b, a).normal_shape == 5 && contact.ppr_pair(a, b).shear_slope == 0.2);
  EXPECT(contact.pair_options(a, b).softening == FMC_SOFTENING_PPR && contact.cohesive(0, 1, coords).area > 0);
  ppr.shear_slope = 1;
  EXPECT(refused(FMC_ERROR_UNSUPPORTED, "shear_slope", [&] { contact.set_ppr_pair(a, b, own, ppr); }));
  // A law of our own: linear springs, and how far they have opened.
  const auto springs = [](const fmc::LawPoints &points, const fmc::LawResponse &response) {
    for (std::size_t i = 0; i < points.count * points.dim; ++i) response.traction[i] = 3 * points.jump[i];
    for (std::size_t i = 0; i < response.tangent.size(); ++i) response.tangent[i] = i % (points.dim * points.dim) % (points.dim + 1) == 0 ? 3 : 0;
    for (std::size_t i = 0; i < points.count; ++i) response.history[i] = std::max(points.history[i], points.jump[i * points.dim]);
  };
  own = fmc::PairOptions();
  EXPECT(refused(FMC_ERROR_OPTIONS_CONFLICT, "'law'", [&] { contact.set_law_pair(0, 1, own, springs, 1); }));
  own.interface_kind = FMC_INTERFACE_LAW;
  own.reach = 0.5;
  EXPECT(refused(FMC_ERROR_UNSUPPORTED, "without the law", [&] { contact.set_pair_options(a, b, own); }));
  // They are stiffer by a field, which is 1 everywhere.
  const auto by_field = [&](const fmc::LawPoints &points, const fmc::LawResponse &response) {
    springs(points, response);
    for (std::size_t i = 0; i < response.traction.size(); ++i) response.traction[i] *= points.fields[2 * (i / points.dim) + 1];
  };
  contact.set_law_fields(Numbers(contact.counts().nodes, 1.0), 1);
  EXPECT(refused(FMC_ERROR_LENGTH, "values", [&] { contact.set_law_fields({1.0}, 1); }));
  contact.set_law_pair(1, 0, own, by_field, 1);
  contact.evaluate(coords);
  pulled = 0;
  for (const auto &point : contact.law_points(coords)) {
    for (int axis = 0; axis < 2; ++axis) pulled -= point.traction[axis] * point.axes[3 * axis] * point.area;
    EXPECT(close(point.traction[0], 3 * point.jump[0], 1e-14) && point.body == 0 && point.partner == 1);
  }
  EXPECT(close(pulled, -contact.body(1).force[0], 1e-12) && contact.pair_options(b, a).interface_kind == FMC_INTERFACE_LAW);
  auto opened = contact.law_history();
  EXPECT(opened.size() == contact.law_points(coords).size());
  opened[0] = 0.5;
  contact.set_law_history(opened);
  EXPECT(contact.law_history() == opened);
  EXPECT(refused(FMC_ERROR_LENGTH, "history", [&] { contact.set_law_history({1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0}); }));
  EXPECT(fmc::check_law(springs, 1, 2, 0.1).size() == 3 && fmc::check_law(springs, 1, 3, 0.1, {0.1, 0.2, 0.3}).size() == 3);
  const auto wrong = [&](const fmc::LawPoints &points, const fmc::LawResponse &response) {
    springs(points, response);
    response.tangent[0] = 2;
  };
  EXPECT(refused(FMC_ERROR_INTERFACE_LAW, "derivative of traction 0 by jump 0 is given as 2", [&] { fmc::check_law(wrong, 1, 2, 0.1); }));
  // Another coefficient across a direction is one of space.
  own = fmc::PairOptions();
  own.friction_coefficient = 0.5;
  const Numbers direction = {1, 2, 3};
  EXPECT(refused(FMC_ERROR_UNSUPPORTED, "2D", [&] { contact.set_orthotropic_pair(a, b, own, {0.2, direction}); }));
  EXPECT(contact.orthotropic_pair(a, b).direction[0] == 0);
  EXPECT(refused(FMC_ERROR_LENGTH, "3 numbers", [] { fmc::OrthotropicFriction(0.2, Numbers{1, 2}); }));
  contact.clear_pair_options(a, b);
  EXPECT(contact.tie(0, 1).area == 0 && contact.tie_nodes(coords).empty());
  EXPECT(contact.pair_options(a, b).excluded == 0 && contact.evaluate(coords).pair_count == 1);
  EXPECT(refused(FMC_ERROR_OBSTACLE_OUT_OF_RANGE, "", [&] { contact.pair_options(a, fmc::Partner::obstacle(0)); }));

  // Fields: the nodal forces from pressures, the resultant from the points, the derivative of the gaps by differences.
  const auto at = contact.nodal_contact(coords);
  contact.evaluate(coords, forces);
  for (std::size_t k = 0; k < 16; ++k)
    EXPECT(close(-at.pressure[k / 2] * at.area[k / 2] * at.normal[k], forces[k], 1e-9));
  EXPECT(at.status[4] == FMC_NODE_TOUCHING && at.status[0] == FMC_NODE_APART && at.gap[4] < 0);
  double sum = 0;
  for (const auto &point : contact.contact_points(coords)) sum += point.pressure * point.area * point.normal[0];
  EXPECT(close(std::fabs(sum), contact.body(1).force[0], 1e-9));
  const auto gaps = contact.gap_constraints(coords, 0.1);
  EXPECT(!gaps.rows.empty() && gaps.gradient.rows() == gaps.rows.size());
  const double step = 1e-6;
  auto moved = coords;
  for (std::size_t n = 4; n < 8; ++n) moved[2 * n] += step;
  const auto after = contact.gap_constraints(moved, 0.1);
  for (std::size_t r = 0; r < gaps.rows.size(); ++r) {
    double slope = 0;
    for (auto e = static_cast<std::size_t>(gaps.gradient.row_offsets[r]);
         e < static_cast<std::size_t>(gaps.gradient.row_offsets[r + 1]); ++e)
      if (gaps.gradient.cols[e] >= 8 && gaps.gradient.cols[e] % 2 == 0) slope += gaps.gradient.values[e];
    EXPECT(close((after.rows[r].gap - gaps.rows[r].gap) / step, slope, 1e-5));
  }

  // Derivatives: the energy's by the coordinates is minus the force; the forces' by the stiffness is what they are by it.
  std::vector<double> slopes(16), by_reference(16), lift(16, 0.0);
  for (std::size_t n = 4; n < 8; ++n) lift[2 * n] = 1;
  fmc::Gradients gradients;
  gradients.coords = slopes.data();
  gradients.reference = by_reference.data();
  EXPECT(contact.vjp(coords, 1.0, {}, gradients).empty());
  for (std::size_t k = 0; k < 16; ++k) EXPECT(close(-slopes[k], forces[k], 1e-9));
  fmc::Gradients of_pairs;
  of_pairs.of_pairs = FMC_GRADIENT_STIFFNESS;
  const auto by_pair = contact.vjp(coords, 0.0, lift, of_pairs);
  double pushed = 0;
  for (std::size_t n = 4; n < 8; ++n) pushed += forces[2 * n];
  EXPECT(by_pair.size() == 1 && close(by_pair[0].stiffness * contact.options().stiffness, pushed, 1e-9));
  // The transpose: along the lift energy rises by minus what pushes, forces grow with the stiffness.
  fmc::Directions along;
  along.coords = lift.data();
  EXPECT(close(contact.jvp(coords, along).energy, -pushed, 1e-9));
  along = fmc::Directions();
  along.pairs = by_pair.data(), along.pair_count = by_pair.size();
  const auto rates = contact.jvp(coords, along);
  for (std::size_t k = 0; k < 16; ++k) EXPECT(close(rates.forces[k] * contact.options().stiffness, by_pair[0].stiffness * forces[k], 1e-9));

  // Moved out by what it penetrates, the square presses twice as much; moved back, as before.
  const auto moved_out = contact.augment(coords, 1e-9);
  const auto multipliers = contact.multipliers();
  EXPECT(!moved_out.is_converged && moved_out.penetration > 0 && multipliers.size() == moved_out.multiplier_count);
  contact.evaluate(coords);
  const double with = contact.body(1).force[0];
  contact.set_multipliers({});
  contact.evaluate(coords);
  EXPECT(std::fabs(with) > 1.5 * std::fabs(contact.body(1).force[0]) && contact.multipliers().empty());
  contact.set_multipliers(multipliers);
  contact.stiffen(4);
  EXPECT(close(contact.multipliers()[0].shift, multipliers[0].shift / 4, 1e-12));
  contact.stiffen(0.25);
  contact.set_multipliers(multipliers);
  contact.evaluate(coords);
  EXPECT(contact.body(1).force[0] == with);
  contact.set_multipliers({});
  contact.evaluate(coords);

  // Facets; points, which are the nodes here; and a basis whose unknowns are the nodes in the opposite order.
  EXPECT(contact.welded_node_count() == 0);
  EXPECT(contact.boundary_facets().size() == 8 && contact.boundary_facets()[0].cell == 0);
  const auto points = contact.point_weights();
  EXPECT(points.rows() == 8 && points.cols[3] == 3 && points.values[3] == 1);
  const std::vector<int64_t> offsets = {0, 1, 2, 3, 4, 5, 6, 7, 8}, unknowns = {7, 6, 5, 4, 3, 2, 1, 0};
  const Numbers ones(8, 1);
  Numbers reversed(16), reversed_forces(16);
  for (std::size_t k = 0; k < 16; ++k) reversed[k] = coords[(7 - k / 2) * 2 + k % 2];
  const fmc::CsrView<int64_t> basis{offsets, unknowns, ones};
  contact.set_basis(basis, 8);
  contact.evaluate(reversed, reversed_forces);
  for (std::size_t k = 0; k < 16; ++k) EXPECT(reversed_forces[k] == forces[(7 - k / 2) * 2 + k % 2]);
  const std::vector<int32_t> from_one = {1, 2, 3, 4, 5, 6, 7, 8, 9}, narrow = {8, 7, 6, 5, 4, 3, 2, 1};
  contact.set_basis(fmc::CsrView<int32_t>{from_one, narrow, ones, 1}, 8);
  contact.evaluate(reversed, twice);
  EXPECT(twice == reversed_forces);
  EXPECT(refused(FMC_ERROR_LENGTH, "cols", [&] { contact.set_basis(fmc::CsrView<int64_t>{unknowns, unknowns, ones}, 8); }));
  EXPECT(refused(FMC_ERROR_LENGTH, "cols", [&] { contact.set_basis(fmc::CsrView<int64_t>{offsets, unknowns, {1.0}}, 8); }));
  EXPECT(refused(FMC_ERROR_INDEX_OUT_OF_RANGE, "", [&] { contact.set_basis(basis, 7); }));
  contact.clear_basis();
  contact.evaluate(coords, twice);
  EXPECT(twice == forces);

  // Coordinates without deformation twice as large: depths are those there. A side named as one of symmetry is no surface.
  const double energy = contact.evaluate(coords).energy;
  auto large = coords;
  for (auto &x : large) x *= 2;
  contact.set_reference(large);
  EXPECT(contact.evaluate(coords).energy > 1.5 * energy);
  contact.set_reference(coords);
  EXPECT(contact.evaluate(coords).energy == energy);
  contact.set_symmetry_nodes({0, 1});
  EXPECT(contact.evaluate(coords).energy >= energy);
  contact.set_symmetry_nodes({});
  EXPECT(contact.evaluate(coords).energy == energy);
  contact.set_symmetry_planes(std::vector<double>{-7, 0}, std::vector<double>{2, 0});
  contact.set_surface_smoothing(30);
  contact.set_surface_smoothing(0);
  EXPECT(contact.evaluate(coords).energy == energy);
  EXPECT(refused(FMC_ERROR_NOT_POSITIVE, "", [&] {
    contact.set_symmetry_planes(std::vector<double>{0, 0}, std::vector<double>{0, 0});
  }));
  EXPECT(refused(FMC_ERROR_NODE_OUT_OF_RANGE, "", [&] { contact.set_symmetry_nodes({8}); }));
  EXPECT(contact.add_surface({0, 1}) == 1);
  EXPECT(refused(FMC_ERROR_BAD_VALUE, "", [&] { contact.add_surface({99}); }));
  const std::vector<double> none{0, 0};
  EXPECT(refused(FMC_ERROR_BAD_VALUE, "", [&] { contact.add_tie(1, 9, none); }));
  EXPECT(refused(FMC_ERROR_BAD_VALUE, "", [&] { contact.set_tie_jump(1, none); }));
  EXPECT(refused(FMC_ERROR_BAD_VALUE, "", [&] { contact.added_tie(1); }));
  EXPECT(refused(FMC_ERROR_BAD_VALUE, "", [&] { contact.tie_force(coords, 1); }));
  EXPECT(refused(FMC_ERROR_BAD_VALUE, "", [&] { contact.remove_tie(1); }));
}

void tangents() {
  fmc::Options options(1e5);
  fmc::Context contact(2, coords, {{FMC_QUAD4, quads}}, options);
  contact.add_half_space(fmc::Pose::along({0, 0.005}, {0, 1}));
  const auto csr = contact.tangent(coords, FMC_CSR_OBSTACLES);
  const auto wide = contact.tangent<int64_t>(coords, FMC_CSR_OBSTACLES);
  EXPECT(csr.rows() == 18 && wide.row_offsets[0] == 0 && wide.cols.size() == csr.cols.size() && wide.values == csr.values);
  const auto size = contact.tangent_csr_size(FMC_CSR_OBSTACLES);
  EXPECT(size.rows == 18 && size.entries == csr.values.size());

  // Dense, from rows, from blocks, from entries, by products, and by differences of the forces.
  const std::size_t n = 18;
  Numbers dense(n * n), other(n * n), column(n);
  for (std::size_t r = 0; r < n; ++r)
    for (auto e = static_cast<std::size_t>(csr.row_offsets[r]); e < static_cast<std::size_t>(csr.row_offsets[r + 1]); ++e)
      dense[r * n + static_cast<std::size_t>(csr.cols[e])] = csr.values[e];
  const auto found = contact.find_tangent(coords);
  const auto entries = contact.tangent_entries();
  EXPECT(found == 0 && entries.values.size() == size.entries);
  for (std::size_t e = 0; e < entries.values.size(); ++e)
    other[static_cast<std::size_t>(entries.rows[e]) * n + static_cast<std::size_t>(entries.cols[e])] = entries.values[e];
  EXPECT(other == dense);
  const auto blocks = contact.tangent_csr(FMC_CSR_OBSTACLES | FMC_CSR_BLOCKS);
  std::fill(other.begin(), other.end(), 0);
  for (std::size_t r = 0; r < blocks.rows(); ++r)
    for (auto e = static_cast<std::size_t>(blocks.row_offsets[r]); e < static_cast<std::size_t>(blocks.row_offsets[r + 1]); ++e)
      for (std::size_t k = 0; k < 4; ++k)
        other[(2 * r + k / 2) * n + 2 * static_cast<std::size_t>(blocks.cols[e]) + k % 2] = blocks.values[4 * e + k];
  EXPECT(other == dense);
  std::vector<int32_t> offsets(blocks.row_offsets.size()), cols(blocks.cols.size());
  Numbers values(blocks.values.size());
  contact.tangent_csr<int32_t>(FMC_CSR_OBSTACLES | FMC_CSR_BLOCKS, offsets, cols, values);
  EXPECT(offsets == blocks.row_offsets && cols == blocks.cols && values == blocks.values);
  EXPECT(refused(FMC_ERROR_LENGTH, "row_offsets", [&] { contact.tangent_csr<int32_t>(0, {}, cols, values); }));
  for (std::size_t c = 0; c < n; ++c) {
    Numbers unit(n), product(n);
    unit[c] = 1;
    contact.tangent_product(unit, product);
    for (std::size_t r = 0; r < n; ++r) EXPECT(close(product[r], dense[r * n + c], 1e-12));
  }
  const double step = 1e-6;
  Numbers plus(16), minus(16);
  auto moved = coords;
  moved[8] += step, contact.evaluate(moved, plus), moved[8] -= 2 * step, contact.evaluate(moved, minus);
  for (std::size_t r = 0; r < 16; ++r) EXPECT(close((minus[r] - plus[r]) / (2 * step), dense[r * n + 8], 1e-6));

  // A flag of the tangent and one of its layout: each does what it does alone.
  contact.find_tangent(coords, FMC_TANGENT_SEMIDEFINITE);
  const auto definite = contact.tangent_csr(FMC_CSR_OBSTACLES);
  EXPECT(contact.tangent(coords, FMC_TANGENT_SEMIDEFINITE | FMC_CSR_OBSTACLES).values == definite.values && definite.values != csr.values);

  // Both at once, and kept patterns.
  Numbers forces(16), alone(16);
  const auto both = contact.evaluate_tangent(coords, forces, FMC_TANGENT_SEMIDEFINITE);
  EXPECT(contact.evaluate(coords, alone).energy == both.result.energy && alone == forces && both.rank_one_count == 0);
  contact.keep_pattern(true);
  contact.find_tangent(coords);
  const auto before = contact.tangent_csr_size();
  auto apart = coords;
  for (std::size_t k = 8; k < 16; k += 2) apart[k] += 1;
  contact.find_tangent(apart);
  EXPECT(contact.tangent_csr_size().entries >= before.entries);
  contact.keep_pattern(false);
  contact.set_obstacle_rotations(true);
  EXPECT(contact.tangent(coords, FMC_CSR_OBSTACLES).rows() == 20);

  // The step that the contact allows grows with the root of the masses.
  const double limit = contact.stable_step(coords, Numbers(8, 1.0));
  EXPECT(limit > 0 && limit < 1 && close(contact.stable_step(coords, Numbers(8, 4.0)), 2 * limit, 1e-12));
  EXPECT(refused(FMC_ERROR_LENGTH, "masses", [&] { contact.stable_step(coords, Numbers(7, 1.0)); }));

  const fmc::Options unset(0);
  fmc::Context explicit_host(2, coords, {{FMC_QUAD4, quads}}, unset);
  explicit_host.stiffness_from_masses(coords, Numbers(8, 1.0), 0.01);
  EXPECT(explicit_host.evaluate(coords).energy > 0 && explicit_host.stable_step(coords, Numbers(8, 1.0)) > 0.01);

  // A step of nothing may be taken whole; one of twenty sizes, not.
  EXPECT(contact.step_limit(coords, Numbers(16, 0.0)).part == 1);
  Numbers far(16, 0.0);
  for (std::size_t k = 8; k < 16; k += 2) far[k] = -20;
  EXPECT(contact.step_limit(coords, far).part < 0.1);
  EXPECT(refused(FMC_ERROR_LENGTH, "coords", [&] { contact.step_limit(coords, Numbers(14, 0.0)); }));

  // What overlaps is removed without strain, and comes back with the offsets.
  const double pressed = contact.evaluate(coords, forces).energy;
  const auto adjusted = contact.adjust(coords, 0, 1);
  EXPECT(adjusted.count > 0 && adjusted.removed > 0 && adjusted.left < 0.1 * adjusted.removed);
  EXPECT(contact.evaluate(coords, forces).energy < 0.1 * pressed && contact.offsets().size() == 16);
  EXPECT(refused(FMC_ERROR_LENGTH, "offsets", [&] { contact.set_offsets(Numbers(15, 0.0)); }));
  contact.set_offsets(Numbers());
  EXPECT(contact.evaluate(coords, forces).energy == pressed);

  // One rank that shares with none but itself.
  fmc::Communicator ranks;
  EXPECT(ranks.size == 1);
  EXPECT(refused(FMC_ERROR_NULL_POINTER, "all_gather", [&] { contact.set_communicator(ranks); }));
  ranks.all_gather = [](void *, const void *send, const uint64_t *counts, void *received) {
    std::memcpy(received, send, counts[0]);
    return 0;
  };
  contact.set_communicator(ranks);
  EXPECT(contact.evaluate(coords, forces).energy == both.result.energy && contact.rank_counts().call_count == 2);
  contact.clear_communicator();
  EXPECT(contact.rank_counts().call_count == 0);

  // A term of rank one: the law "volume" with m = 2.
  options.law = FMC_LAW_VOLUME;
  options.exponent = 2;
  fmc::Context squared(2, coords, {{FMC_QUAD4, quads}}, options);
  EXPECT(squared.find_tangent(coords) == 1);
  const auto term = squared.tangent_rank_one(0);
  const auto &g = term.vector;
  EXPECT(term.factor == 2 * options.stiffness && close(g[0] + g[2] + g[4] + g[6], 0.8, 1e-9));
}

// A square on springs that a floor lifts: the equilibrium by functions of the host, one who refuses, and what it says of itself.
void an_equilibrium() {
  const Numbers coords = {0, 0, 1, 0, 1, 1, 0, 1};
  const std::vector<int32_t> quads = {0, 1, 2, 3};
  fmc::Context contact(2, coords, {{FMC_QUAD4, quads}}, fmc::Options(0));
  contact.add_half_space(fmc::Pose::at({0, 0.1}));
  const std::vector<int64_t> unknowns = {0, 1, 2, 3, 4, 5, 6, 7};
  const std::vector<uint8_t> free(8, 1);
  const Numbers rest(8, 0.0);
  const double k = 1e3;
  fmc::EquilibriumHost host;
  host.forces = [&](fmc::View<const double> x, bool, double *forces, double &energy) {
    energy = 0;
    for (std::size_t i = 0; i < 8; ++i) forces[i] = k * x[i], energy += k * x[i] * x[i] / 2;
    return true;
  };
  host.product = [&](fmc::View<const double> v, bool, double *product) {
    for (std::size_t i = 0; i < 8; ++i) product[i] = k * v[i];
  };
  host.diagonal = [&](double *diagonal) {
    for (std::size_t i = 0; i < 8; ++i) diagonal[i] = k;
  };
  host.solve = [&](fmc::View<const double> x, uint32_t flags, double shift, fmc::View<const double> right, double *d) {
    Numbers at(coords);
    for (std::size_t i = 0; i < 8; ++i) at[i] += x[i];
    double a[8][9] = {};
    for (std::size_t i = 0; i < 8; ++i) a[i][i] = k * (1 + shift), a[i][8] = right[i];
    const auto tangent = contact.tangent(at, flags);
    for (std::size_t row = 0; row < tangent.rows(); ++row)
      for (auto e = tangent.row_offsets[row]; e < tangent.row_offsets[row + 1]; ++e)
        a[row][static_cast<std::size_t>(tangent.cols[static_cast<std::size_t>(e)])] += tangent.values[static_cast<std::size_t>(e)];
    for (std::size_t c = 0; c < 8; ++c)
      for (std::size_t r = 0; r < 8; ++r)
        if (r != c) {
          const double part = a[r][c] / a[c][c];
          for (std::size_t j = c; j < 9; ++j) a[r][j] -= part * a[c][j];
        }
    for (std::size_t i = 0; i < 8; ++i) d[i] = a[i][8] / a[i][i];
    return true;
  };
  const fmc::EquilibriumProblem problem{unknowns, coords, free, rest, {}};
  const auto found = fmc::find_equilibrium(contact, problem, host);
  EXPECT(found.way != FMC_WAY_NONE && found.x.size() == 8 && found.counts.solve_count > 0);
  // The foot is on the floor to a thousandth of its way, and what lifts it is what springs hold.
  EXPECT(close(found.x[1], 0.1, 1e-2) && close(found.x[3], 0.1, 1e-2) && std::fabs(found.x[0] + found.x[2]) < 1e-9);
  // The adjoint, of the height of a corner of the same springs on a floor of a given stiffness.
  fmc::Context pressed(2, coords, {{FMC_QUAD4, quads}}, fmc::Options(1e4));
  pressed.add_half_space(fmc::Pose::at({0, 0.1}));
  Numbers state(8, 0.0), by_x(8, 0.0), positions(2);
  by_x[1] = 1;
  state[1] = state[3] = 0.05;
  const fmc::EquilibriumProblem there{unknowns, coords, free, state, {}};
  fmc::Gradients to;
  to.positions = positions.data();
  Numbers at(coords);
  for (std::size_t i = 0; i < 8; ++i) at[i] += state[i];
  const auto adjoint = fmc::adjoint(pressed, there, by_x, {}, [&](fmc::View<const double> right, double *b) {
    double a[8][9] = {};
    for (std::size_t i = 0; i < 8; ++i) a[i][i] = k, a[i][8] = right[i];
    const auto tangent = pressed.tangent(at);
    for (std::size_t row = 0; row < tangent.rows(); ++row)
      for (auto e = tangent.row_offsets[row]; e < tangent.row_offsets[row + 1]; ++e)
        if (row < 8 && tangent.cols[static_cast<std::size_t>(e)] < 8)
          a[static_cast<std::size_t>(tangent.cols[static_cast<std::size_t>(e)])][row] += tangent.values[static_cast<std::size_t>(e)];
    for (std::size_t c = 0; c < 8; ++c)
      for (std::size_t r = 0; r < 8; ++r)
        if (r != c) {
          const double part = a[r][c] / a[c][c];
          for (std::size_t j = c; j < 9; ++j) a[r][j] -= part * a[c][j];
        }
    for (std::size_t i = 0; i < 8; ++i) b[i] = a[i][8] / a[i][i];
    return true;
  }, to);
  EXPECT(adjoint.is_there && adjoint.pairs.empty());
  // At free unknowns what is left is K b. If all but the springs' ends rises by one, the corner does: the floor's part is one less theirs.
  double springs = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT(std::fabs(adjoint.right[i] - k * adjoint.balance[i]) < 1e-9);
    if (i % 2 == 1) springs += k * adjoint.balance[i];
  }
  EXPECT(close(positions[1], 1 - springs, 1e-9) && positions[1] > 0.1);
  bool is_refused = false;
  try {
    fmc::adjoint(contact, there, by_x, {}, [](fmc::View<const double>, double *) { return true; });
  } catch (const fmc::Error &error) {
    is_refused = error.status() == FMC_ERROR_UNSUPPORTED;
  }
  EXPECT(is_refused);
  fmc::EquilibriumOptions check;
  check.check = 1;
  const auto said = fmc::find_equilibrium(contact, problem, host, check);
  EXPECT(said.texts.size() >= 5 && said.texts[1].find("derivative of the residual") != std::string::npos);
  host.forces = [](fmc::View<const double>, bool, double *, double &) { return false; };
  EXPECT(fmc::find_equilibrium(contact, problem, host).way == FMC_WAY_NONE);
  host.forces = [](fmc::View<const double>, bool, double *, double &) -> bool { throw std::runtime_error("of the host"); };
  bool has_thrown = false;
  try {
    fmc::find_equilibrium(contact, problem, host);
  } catch (const std::runtime_error &error) {
    has_thrown = std::string(error.what()) == "of the host";
  }
  EXPECT(has_thrown);
}

// A mesh in one part is the whole mesh, its nodes and cells in the order of their numbers.
void a_mesh_in_parts() {
  fmc::Communicator ranks;
  ranks.all_gather = [](void *, const void *send, const uint64_t *counts, void *received) {
    if (counts[0] > 0) std::memcpy(received, send, counts[0]);
    return 0;
  };
  fmc::Options options(1e5);
  options.law = FMC_LAW_DEPTH;
  options.friction_coefficient = 0.3;
  options.friction_stiffness = 1e5;
  const std::vector<int32_t> numbers = {17, 16, 15, 14, 13, 12, 11, 10}, cells = {1, 0}, ids = {0, 1};
  const std::vector<fmc::Cells<int32_t>> blocks = {{FMC_QUAD4, quads}};
  fmc::MeshPart<int32_t> part{coords, numbers, blocks, cells, ids, 0.5};
  auto parts = fmc::Context::from_part(2, ranks, part, options);
  EXPECT(!parts.set_coords(coords));
  auto nodes = parts.gathered_nodes();
  EXPECT(nodes.numbers.size() == 8 && nodes.numbers[0] == 10 && nodes.own_nodes[0] == 7 && nodes.coords[0] == coords[14]);
  const auto counts = parts.gathered_counts();
  EXPECT(counts.facet_count == 8 && counts.whole_facet_count == 8 && counts.own_cell_count == 2 && counts.gather_count == 1);
  EXPECT((parts.gathered_cells() == std::vector<int64_t>{0, 1}));
  fmc::Context whole(2, coords, {{FMC_QUAD4, quads}}, options, ids);
  Numbers slid = coords, forces(16), of_parts(16);
  for (std::size_t n = 4; n < 8; ++n) slid[2 * n + 1] += 0.01;
  whole.begin_step(coords);
  parts.begin_step(nodes.coords);
  whole.commit_step(slid);
  parts.set_coords(slid);
  parts.commit_step(parts.gathered_nodes().coords);
  const auto carried = parts.carried_slip();
  EXPECT(carried.size() == 2 && carried[0].slip[1] * carried[1].slip[1] < 0);
  parts.set_coords(coords);
  parts.set_carried_slip(carried);
  whole.evaluate(coords, forces);
  parts.evaluate(parts.gathered_nodes().coords, of_parts);
  for (std::size_t n = 0; n < 8; ++n)
    for (std::size_t axis = 0; axis < 2; ++axis)
      EXPECT(close(of_parts[2 * n + axis], forces[2 * static_cast<std::size_t>(nodes.own_nodes[n]) + axis], 1e-12));
  EXPECT(refused(FMC_ERROR_UNSUPPORTED, "fmc_context_new_from_part", [&] { whole.set_coords(coords); }));
  EXPECT(refused(FMC_ERROR_LENGTH, "", [&] { parts.set_coords(Numbers(14, 0.0)); }));
  EXPECT(refused(FMC_ERROR_NON_FINITE_COORDINATE, "node 2", [&] { auto bad = coords; bad[5] = NAN; parts.set_coords(bad); }));
  EXPECT(refused(FMC_ERROR_UNSUPPORTED, "not gathered", [&] { parts.set_carried_slip(std::vector<fmc_carried_slip>{{7, 0, 0, 0, 0, 1, {}, 0}}); }));
}

// A law of friction of our own that repeats the coefficient, and counts steps.
void friction_by_our_own_law() {
  fmc::Options options(1e3);
  options.friction_coefficient = 0.3;
  const auto placed = [](double by) {
    return Numbers{-0.5, -2, 1.5, -2, 1.5, 0, -0.5, 0, by, -1e-3, 1 + by, -1e-3, 1 + by, 0.999, by, 0.999};
  };
  const auto reference = placed(0);
  const auto limit = [](const fmc::FrictionFacets &facets, const fmc::FrictionResponse &response) {
    for (std::size_t i = 0; i < facets.count; ++i) {
      response.limit[i] = 0.3 * facets.pressure[i];
      response.by_pressure[i] = 0.3;
      response.history[i] = facets.history[i] + 1;
    }
  };
  fmc::Context lawful(2, reference, {{FMC_QUAD4, quads}}, fmc::Options(1e3));
  lawful.set_friction_law_pair(fmc::Partner::body(1), fmc::Partner::body(0), fmc::PairOptions(), limit, 1);
  fmc::Context plain(2, reference, {{FMC_QUAD4, quads}}, options);
  lawful.begin_step(reference);
  plain.begin_step(reference);
  Numbers by_law(16), by_library(16);
  lawful.evaluate(placed(1e-3), by_law);
  plain.evaluate(placed(1e-3), by_library);
  for (std::size_t i = 0; i < 16; ++i) EXPECT(close(by_law[i], by_library[i], 1e-13));
  lawful.commit_step(placed(1e-3));
  auto rubbed = lawful.friction_history();
  EXPECT(rubbed == Numbers(lawful.slip().size() / 8, 1.0) && !rubbed.empty());
  rubbed[0] = 5;
  lawful.set_friction_history(rubbed);
  EXPECT(lawful.friction_history() == rubbed);
  EXPECT(refused(FMC_ERROR_LENGTH, "history", [&] { lawful.set_friction_history({1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0}); }));
  fmc::PairOptions rubs;
  rubs.friction_coefficient = 0.2;
  EXPECT(refused(FMC_ERROR_UNSUPPORTED, "together with your own law of friction",
                 [&] { lawful.set_friction_law_pair(fmc::Partner::body(0), fmc::Partner::body(1), rubs, limit, 1); }));
  EXPECT(fmc::check_friction_law(limit, 1, 2, 1.0, 1.0).size() == 2);
  const auto wrong = [&](const fmc::FrictionFacets &facets, const fmc::FrictionResponse &response) {
    limit(facets, response);
    response.by_pressure[0] = 0.2;
  };
  EXPECT(refused(FMC_ERROR_INTERFACE_LAW, "the derivative of the limit by the pressure is given as 2",
                 [&] { fmc::check_friction_law(wrong, 1, 3, 1.0, 1.0); }));
  const auto throws = [](const fmc::FrictionFacets &, const fmc::FrictionResponse &) { throw 7; };
  lawful.set_friction_law_pair(fmc::Partner::body(0), fmc::Partner::body(1), fmc::PairOptions(), throws);
  int thrown = 0;
  try {
    lawful.evaluate(placed(1e-3));
  } catch (int number) {
    thrown = number;
  }
  EXPECT(thrown == 7);
}

void friction_and_patches() {
  fmc::Options options(1e3);
  options.friction_coefficient = 0.3;
  const auto placed = [](double by) {
    return Numbers{-0.5, -2, 1.5, -2, 1.5, 0, -0.5, 0, by, -1e-3, 1 + by, -1e-3, 1 + by, 0.999, by, 0.999};
  };
  const auto reference = placed(0);
  auto start = reference;
  fmc::Context contact(2, start, {{FMC_QUAD4, quads}}, options);
  EXPECT(refused(FMC_ERROR_NO_STEP, "", [&] { contact.evaluate(start); }));
  contact.begin_step(start);
  fmc::FrictionStep step{start, reference};
  for (const double by : {1e-4, 1e-3, 9e-4, -1e-3}) {
    const auto end = placed(by);
    Numbers forces(16);
    const auto dissipated = contact.evaluate(end, forces).friction_dissipation;
    double heat = 0;
    for (const auto part : contact.friction_heat(end, {1, 2})) heat += part;
    EXPECT(std::fabs(heat - dissipated) <= 1e-12 * dissipated);
    step.start = start;
    EXPECT(fmc::contact_force(2, end, {{FMC_QUAD4, quads}}, options, {}, &step).forces == forces);
    const auto rejected = step.next_slip;
    const std::vector<int64_t> wide(quads.begin(), quads.end());
    EXPECT(fmc::contact_force(2, end, {{FMC_QUAD4, wide}}, options, {}, &step).forces == forces && step.next_slip == rejected);
    contact.commit_step(end);
    EXPECT(contact.slip() == step.next_slip);
    step.slip = step.next_slip;
    start = end;
  }
  // Another reference, other depths: as in a context that is made there.
  auto large = reference;
  for (auto &x : large) x *= 2;
  fmc::Context from_large(2, large, {{FMC_QUAD4, quads}}, options);
  from_large.begin_step(start);
  fmc::FrictionStep once{start, large};
  Numbers expected(16);
  from_large.evaluate(placed(0), expected);
  EXPECT(fmc::contact_force(2, placed(0), {{FMC_QUAD4, quads}}, options, {}, &once).forces == expected);
  once.reference = {};
  EXPECT(fmc::contact_force(2, placed(0), {{FMC_QUAD4, quads}}, options, {}, &once).forces != expected);

  const auto kept = contact.slip();
  contact.set_slip(Numbers());
  EXPECT(contact.slip() != kept);
  contact.set_slip(kept);
  EXPECT(contact.slip() == kept);
  EXPECT(refused(FMC_ERROR_LENGTH, "", [&] { contact.set_slip({1.0}); }));
  EXPECT(refused(FMC_ERROR_INDEX_OUT_OF_RANGE, "row 0", [&] { contact.set_slip(Numbers(8, 0.5)); }));
  EXPECT(contact.worn_facets().empty() && contact.worn_depth() == Numbers(8) && contact.worn_volumes() == Numbers(2));
  contact.set_pair_wear(fmc::Partner::body(1), fmc::Partner::body(0), 0.25, 0.5);
  EXPECT(contact.pair_wear(fmc::Partner::body(0), fmc::Partner::body(1)) == (std::array<double, 2>{0.5, 0.25}));
  // Other options leave it, and it leaves them.
  fmc::PairOptions rubbed;
  rubbed.friction_coefficient = 0.5;
  contact.set_pair_options(fmc::Partner::body(0), fmc::Partner::body(1), rubbed);
  EXPECT(contact.pair_wear(fmc::Partner::body(0), fmc::Partner::body(1))[0] == 0.5);
  contact.set_pair_wear(fmc::Partner::body(0), fmc::Partner::body(1), 0, 0);
  EXPECT(contact.pair_options(fmc::Partner::body(0), fmc::Partner::body(1)).friction_coefficient == 0.5);
  EXPECT(refused(FMC_ERROR_NOT_POSITIVE, "wear_coefficient", [&] { contact.set_pair_wear(fmc::Partner::body(0), fmc::Partner::body(1), -1, 0); }));
  contact.clear_pair_options(fmc::Partner::body(0), fmc::Partner::body(1));
  contact.set_wear_cycles(10);
  EXPECT(refused(FMC_ERROR_NOT_POSITIVE, "wear_cycles", [&] { contact.set_wear_cycles(0); }));
  contact.set_worn_facets({0.0, 0.0, 0.25, 0.5});
  EXPECT(contact.worn_facets() == Numbers({0.0, 0.0, 0.25, 0.5}));
  EXPECT(contact.worn_depth()[0] == 0.25 && contact.worn_volumes() == Numbers({0.5, 0.0}));
  EXPECT(refused(FMC_ERROR_LENGTH, "", [&] { contact.set_worn_facets({1.0}); }));
  EXPECT(refused(FMC_ERROR_INDEX_OUT_OF_RANGE, "row 0", [&] { contact.set_worn_facets(Numbers(4, 0.5)); }));
  contact.set_worn_facets(Numbers());
  step.start = fmc::Coords(start.data(), 14);
  EXPECT(refused(FMC_ERROR_LENGTH, "start", [&] { fmc::contact_force(2, start, {{FMC_QUAD4, quads}}, options, {}, &step); }));
  contact.freeze_friction(start);
  const auto frozen = contact.tangent(start, FMC_TANGENT_SYMMETRIC);
  contact.release_friction();
  EXPECT(frozen.rows() == 16);

  fmc::Options fiber(1e5);
  fiber.law = FMC_LAW_FIBER;
  fmc::Context patches(2, coords, {{FMC_QUAD4, quads}}, fiber);
  EXPECT(patches.keep_patches(coords) == 1);
  patches.release_patches();
  EXPECT(close(patches.evaluate(coords).energy, 0.5 * 1e5 * 1e-4 * 0.8, 1e-9));
}

void obstacles() {
  fmc::Options options(1e5);
  options.law = FMC_LAW_VOLUME;
  options.spacing = 0.02;
  fmc::Context contact(3, cube, {{FMC_HEX8, hex}}, options);
  // Shapes whose top is 0.1 above the cube's bottom: box, cylinder, polygon, hull and compound are the same box.
  const Numbers box = {-0.2, -0.3, -0.1, 0.2, -0.3, -0.1, 0.2, 0.3, -0.1, -0.2, 0.3, -0.1,
                       -0.2, -0.3, 0.1,  0.2, -0.3, 0.1,  0.2, 0.3, 0.1,  -0.2, 0.3, 0.1};
  const std::vector<int32_t> sides = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                      1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
  const std::vector<int64_t> wide(sides.begin(), sides.end());
  const auto pose = fmc::Pose::at({0.5, 0.5, 0});
  const double volume = 0.4 * 0.6 * 0.1;
  const auto measured = [&](std::size_t obstacle) {
    const double found = contact.evaluate(cube).volume;
    EXPECT(contact.obstacle_shape(obstacle).pose.position[0] == 0.5);
    contact.remove_obstacle(obstacle);
    return found;
  };
  EXPECT(close(measured(contact.add_cuboid({0.2, 0.3, 0.1}, pose)), volume, 1e-3 * volume));
  EXPECT(close(measured(contact.add_polytope(box, sides, pose)), volume, 1e-3 * volume));
  EXPECT(close(measured(contact.add_polytope(box, wide, pose)), volume, 1e-3 * volume));
  if (fmc::has_feature("shapes")) {
    EXPECT(close(measured(contact.add_convex_hull(box, pose)), volume, 1e-3 * volume));
    const std::vector<fmc::Part> parts = {{fmc::Shape::cuboid({0.2, 0.3, 0.1})}, {fmc::Shape::polytope(box, sides)},
                                          {fmc::Shape::polytope(box, wide)}, {fmc::Shape::convex_hull(box)},
                                          {fmc::Shape::ball(0.05)}, {fmc::Shape::cone(0.01, 0.02)},
                                          {fmc::Shape::cylinder(0.01, 0.02)}, {fmc::Shape::capsule(0.01, 0.02)}};
    EXPECT(close(measured(contact.add_compound(parts, pose)), volume, 1e-3 * volume));
    EXPECT(refused(FMC_ERROR_EMPTY_COMPOUND, "", [&] { contact.add_compound({}); }));
    const fmc::Part below = {fmc::Shape::half_space(), fmc::Pose::along({0, 0, 0.1}, {0, 0, 1})};
    EXPECT(close(measured(contact.add_compound({below}, pose)), 0.1, 1e-3));
    // A function in a compound in a compound.
    const auto plane = fmc::Shape::signed_distance([](auto x, auto gradient) {
      gradient[2] = 1, gradient[0] = gradient[1] = 0;
      return x[2];
    });
    const fmc::Part inner = {fmc::Shape::compound({{plane, fmc::Pose::at({0, 0, 0.1})}})};
    EXPECT(close(measured(contact.add_obstacle(fmc::Shape::compound({inner}), pose)), 0.1, 1e-3));
  }
  const std::vector<std::size_t> grid = {2, 2};
  EXPECT(close(measured(contact.add_height_field(grid, {0.4, 0.6}, Numbers(4, 0.1), 0.2, pose)), volume, 1e-3 * volume));
  EXPECT(refused(FMC_ERROR_LENGTH, "heights", [&] { contact.add_height_field(grid, {1, 1}, {1, 2, 3}, 1); }));
  EXPECT(refused(FMC_ERROR_LENGTH, "half_extents", [&] { contact.add_cuboid({1, 1}); }));
  const double pi = 3.14159265358979323846;
  EXPECT(close(measured(contact.add_cylinder(0.2, 0.1, pose)), pi * 0.04 * 0.1, 1e-4));
  EXPECT(close(measured(contact.add_cone(0.2, 0.1, pose)), pi * 0.01 * 0.1 / 3, 1e-4));
  EXPECT(close(measured(contact.add_capsule(0.1, 0.2, pose)), pi * 0.01 * 0.2 + 2 * pi * 0.001 / 3, 1e-4));
  EXPECT(close(measured(contact.add_ball(0.2, pose)), 2 * pi * 0.008 / 3, 1e-4));
  const auto floor = contact.add_half_space(fmc::Pose::along({0.5, 0, 0.1}, {0, 0, 1}));
  EXPECT(contact.obstacle_shape(floor).kind == FMC_SHAPE_HALF_SPACE && close(contact.evaluate(cube).volume, 0.1, 1e-4));
  contact.set_pose(floor, fmc::Pose::along({0, 0, 0.2}, {0, 0, 1}));
  EXPECT(close(contact.evaluate(cube).volume, 0.2, 1e-4) && contact.obstacles().size() == floor + 1);
  // Another coefficient across a direction comes back in either order, and other options take it back.
  const auto a = fmc::Partner::body(0), b = fmc::Partner::obstacle(floor);
  fmc::PairOptions own;
  own.law = FMC_LAW_DEPTH;
  own.stiffness = 1;
  own.friction_coefficient = 0.5;
  contact.set_orthotropic_pair(a, b, own, {0.2, Numbers{1, 2, 3}, true});
  EXPECT(contact.orthotropic_pair(a, b).direction_of == 1 && contact.orthotropic_pair(b, a).direction_of == 0);
  EXPECT(contact.orthotropic_pair(a, b).direction[2] == 3 && contact.pair_options(a, b).friction_coefficient == 0.5);
  contact.set_pair_options(a, b, fmc::PairOptions());
  EXPECT(contact.orthotropic_pair(a, b).direction[2] == 0);
  EXPECT(refused(FMC_ERROR_BAD_POSE, "", [] { fmc::Pose::along({0, 0}, {0, 0}); }));
  EXPECT(refused(FMC_ERROR_LENGTH, "position", [] { fmc::Pose::along({0, 0}, {0, 0, 1}); }));
  EXPECT(refused(FMC_ERROR_NOT_POSITIVE, "", [&] { contact.add_ball(-1); }));
}

// Four springs in two rows, condensed to their lower ends: two of 1 in a row are one of 1/2. As in hosts/c/condensation.c.
void condensation() {
  const std::vector<int64_t> offsets = {0, 2, 4, 6, 8}, cols = {0, 2, 1, 3, 0, 2, 1, 3}, retained = {2, 3};
  const Numbers values = {2, -1, 2, -1, -1, 1, -1, 1}, load = {0, 0, -0.4, -0.4};
  fmc::Condensation bodies;
  EXPECT(refused(FMC_ERROR_NOT_FACTORISED, "", [&] { bodies.complement(); }));
  const fmc::CsrView<int64_t> K{offsets, cols, values};
  bodies.factorise(K, retained);
  const auto same = [](const Numbers &found, const Numbers &expected) {
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT(std::abs(found.at(k) - expected[k]) < 1e-15);
  };
  same(bodies.complement(), {0.5, 0, 0, 0.5});
  same(bodies.condense(load), {-0.4, -0.4});
  same(bodies.expand(load, Numbers{0.5, 1}), {0.25, 0.5, 0.5, 1});
  EXPECT(refused(FMC_ERROR_LENGTH, "right", [&] { bodies.expand(Numbers{0.5, 1}, Numbers{0.5, 1}); }));
  EXPECT(refused(FMC_ERROR_LENGTH, "row_offsets", [&] { bodies.factorise(fmc::CsrView<int64_t>{{}, cols, values}, retained); }));
  EXPECT(refused(FMC_ERROR_LENGTH, "cols", [&] { bodies.factorise(fmc::CsrView<int64_t>{offsets, retained, values}, retained); }));
  EXPECT(refused(FMC_ERROR_LENGTH, "values", [&] { bodies.factorise(fmc::CsrView<int64_t>{offsets, cols, load}, retained); }));
  const fmc::Condensation moved = std::move(bodies);
  EXPECT(moved.condense(load).size() == 2);
  const Numbers loose = {0, 0, 2, -1, 0, 1, -1, 1};
  EXPECT(refused(FMC_ERROR_NOT_POSITIVE_DEFINITE, "", [&] { fmc::Condensation(fmc::CsrView<int64_t>{offsets, cols, loose}, retained); }));
}

}  // namespace

int main() try {
  of_the_library();
  forces_and_getters();
  tangents();
  a_mesh_in_parts();
  friction_by_our_own_law();
  friction_and_patches();
  obstacles();
  condensation();
  an_equilibrium();
  // A rigid square on springs sinks onto another that is held, as in hosts/c/contact_step.c: u = 100.8 / 1001.
  const Numbers start = {0, 0, 2, 0, 2, 1, 0, 1, 0.5, 1.1, 1.5, 1.1, 1.5, 2, 0.5, 2};
  Numbers sunk = start;
  for (std::size_t node = 4; node < 8; ++node) sunk[2 * node + 1] -= 0.12;
  fmc::Options stiff(1000);
  stiff.set("law", "fiber");
  const std::vector<int32_t> both = {0, 1, 2, 3, 4, 5, 6, 7};
  fmc::Context pressed(2, start, {{FMC_QUAD4, both}}, stiff);
  pressed.keep_patches(sunk);
  const std::vector<int64_t> dofs = {9, 11}, held = {0, 1, 2, 3, 4, 5, 6, 7};
  const Numbers springs = {0.5, 0, 0, 0.5}, load = {0.4, 0.4};
  const auto follow = [](fmc::View<const double> displacement, fmc::View<double> places) {
    places[2 * 7 + 1] += displacement[0];
    places[2 * 6 + 1] += displacement[1];
  };
  const auto step = pressed.contact_step(start, dofs, springs, load, held, follow);
  EXPECT(step.state == FMC_STEP_CONVERGED && close(-step.displacement[0], 100.8 / 1001, 1e-9));
  const auto fails = [](fmc::View<const double>, fmc::View<double>) { throw std::out_of_range("no place"); };
  try {
    pressed.contact_step(start, dofs, springs, load, held, fails);
    EXPECT(false);
  } catch (const std::out_of_range &error) {
    EXPECT(std::string(error.what()) == "no place");
  }
  EXPECT(refused(FMC_ERROR_LENGTH, "stiffness", [&] { pressed.contact_step(start, dofs, load, load); }));
  return report();
} catch (const std::exception &error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
