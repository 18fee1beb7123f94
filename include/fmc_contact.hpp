// fmc_contact.h for C++17 and later, header only: contexts that free themselves, failures as exceptions, arrays of the host
// in whatever container it keeps them, callbacks that may throw.
//
//   fmc::Options options(1e5);                                  // the stiffness k; every other option has a default
//   fmc::Context contact(2, x, {{FMC_QUAD4, quads}}, options);  // finds the boundary facets once
//   std::vector<double> f(x.size());
//   const fmc_result result = contact.evaluate(x, f);           // contact forces at the nodes
//
// The dimension is an argument, 2 or 3; x are the coordinates of all nodes, (nodes, dim). Nothing of the host is kept or copied.
// What arrays can be: fmc_contact/view.hpp. What the functions do: `fmc_contact.h`, under their names with `fmc_context_`
// in front. Programs: hosts/cpp.
#ifndef FMC_CONTACT_HPP
#define FMC_CONTACT_HPP

#include "fmc_contact/condensation.hpp"
#include "fmc_contact/context.hpp"

namespace fmc {

// Version of the library, such as "0.1.0", and of its binary interface.
inline std::string version() { return fmc_version(); }
inline int abi_version() { return fmc_abi_version(); }
// Whether the library has a feature, see `fmc_has_feature`.
inline bool has_feature(const std::string &name) { return fmc_has_feature(name.c_str()) != 0; }

// Contact forces between bodies of one cell type, in one call; the bits are those of a `Context`. `conn` are node numbers,
// (cells, nodes per cell), of 32 or 64 bits; `body_ids`, one for every cell, may be left out.
inline ContactForces contact_force(int dim, Coords coords, fmc_cell_type type, View<const int32_t> conn, const Options &options,
                                   View<const int32_t> body_ids = {});
inline ContactForces contact_force(int dim, Coords coords, fmc_cell_type type, View<const int64_t> conn, const Options &options,
                                   View<const int64_t> body_ids = {});

// The same with friction, at the end `coords` of a step.
inline ContactForces contact_force_step(int dim, Coords coords, fmc_cell_type type, View<const int32_t> conn,
                                        const Options &options, FrictionStep &step, View<const int32_t> body_ids = {});
inline ContactForces contact_force_step(int dim, Coords coords, fmc_cell_type type, View<const int64_t> conn,
                                        const Options &options, FrictionStep &step, View<const int64_t> body_ids = {});

// A stiffness k to begin with, from Young's modulus of the softer body and the size of its cells, see `fmc_suggest_stiffness`; `dim`
// and `exponent` for the law "volume" alone.
inline double suggest_stiffness(double modulus, double cell_size, fmc_law law = FMC_LAW_DEPTH, int dim = 3, double exponent = 1) {
  double k = 0;
  check(fmc_suggest_stiffness(law, dim, exponent, modulus, cell_size, &k));
  return k;
}

namespace detail {

template <class Int>
ContactForces force(int dim, const Coords &coords, fmc_cell_type type, View<const Int> conn, const Options &options,
                    View<const Int> body_ids, fmc_friction_step *step) {
  const DenseRows x(coords, dim);
  const auto cells = rows_of(conn, nodes_of(type), "cells");
  const auto *ids = one_for_each(body_ids, cells, "body_ids");
  ContactForces found;
  found.forces.resize(x.node_count() * static_cast<std::size_t>(dim));
  auto *f = found.forces.data();
  check(step == nullptr
            ? Calls<Int>::force(dim, x.data(), x.node_count(), type, conn.data(), cells, ids, &options, f, &found.volume)
            : Calls<Int>::force_step(dim, x.data(), x.node_count(), type, conn.data(), cells, ids, &options, step, f,
                                     &found.volume));
  return found;
}

template <class Int>
ContactForces force_step(int dim, const Coords &coords, fmc_cell_type type, View<const Int> conn, const Options &options,
                         View<const Int> body_ids, FrictionStep &step) {
  const auto nodes = coords.as_c(dim).node_count;
  const DenseRows start(step.start, dim), reference(step.reference, dim);
  if (start.node_count() != nodes) refuse(FMC_ERROR_LENGTH, "start has another number of nodes than coords");
  if (reference.node_count() != nodes && reference.node_count() != 0)
    refuse(FMC_ERROR_LENGTH, "reference has another number of nodes than coords");
  fmc_friction_step c;
  check(fmc_friction_step_init(&c));
  c.start = start.data();
  c.reference = reference.node_count() != 0 ? reference.data() : nullptr;
  // Without slip, the number of facets is asked for: a length that cannot be right is refused, and the right one told.
  double none = 0;
  std::vector<double> next(step.slip.size());
  c.slip = step.slip.empty() ? nullptr : step.slip.data();
  c.next_slip = next.empty() ? &none : next.data();
  c.slip_length = next.size();
  try {
    auto found = force(dim, coords, type, conn, options, body_ids, &c);
    step.next_slip = std::move(next);
    return found;
  } catch (const Error &error) {
    if (error.status() != FMC_ERROR_LENGTH || !step.slip.empty() || c.facet_count == 0) throw;
  }
  next.resize(c.facet_count * static_cast<std::size_t>(dim));
  c.next_slip = next.data();
  c.slip_length = next.size();
  auto found = force(dim, coords, type, conn, options, body_ids, &c);
  step.next_slip = std::move(next);
  return found;
}

}  // namespace detail

inline ContactForces contact_force(int dim, Coords coords, fmc_cell_type type, View<const int32_t> conn, const Options &options,
                                   View<const int32_t> body_ids) {
  return detail::force(dim, coords, type, conn, options, body_ids, nullptr);
}
inline ContactForces contact_force(int dim, Coords coords, fmc_cell_type type, View<const int64_t> conn, const Options &options,
                                   View<const int64_t> body_ids) {
  return detail::force(dim, coords, type, conn, options, body_ids, nullptr);
}
inline ContactForces contact_force_step(int dim, Coords coords, fmc_cell_type type, View<const int32_t> conn,
                                        const Options &options, FrictionStep &step, View<const int32_t> body_ids) {
  return detail::force_step(dim, coords, type, conn, options, body_ids, step);
}
inline ContactForces contact_force_step(int dim, Coords coords, fmc_cell_type type, View<const int64_t> conn,
                                        const Options &options, FrictionStep &step, View<const int64_t> body_ids) {
  return detail::force_step(dim, coords, type, conn, options, body_ids, step);
}

}  // namespace fmc

#endif  // FMC_CONTACT_HPP
