// fmc_contact.h for C++17 and later, header only: contexts that free themselves, failures as exceptions, arrays of the host
// in whatever container it keeps them, callbacks that may throw.
//
//   fmc::Options options(1e5);                                  // the stiffness k; every other option has a default
//   fmc::Context contact(2, x, {{FMC_QUAD4, quads}}, options);  // finds the boundary facets once
//   std::vector<double> f(x.size());
//   const fmc_result result = contact.evaluate(x, f);           // contact forces at the nodes
//
// The dimension is an argument, 2 or 3; x are the coordinates of all nodes, (nodes, dim). Nothing of the host is kept or copied.
// Supported arrays: fmc_contact/view.hpp. Documentation of the functions: `fmc_contact.h`, under their names with `fmc_context_`
// in front. Programs: hosts/cpp.
#ifndef FMC_CONTACT_HPP
#define FMC_CONTACT_HPP

#include "fmc_contact/bodies.hpp"
#include "fmc_contact/condensation.hpp"
#include "fmc_contact/context.hpp"
#include "fmc_contact/equilibrium.hpp"

namespace fmc {

// Version of the library, such as "0.1.0", and of its binary interface.
inline std::string version() { return fmc_version(); }
inline int abi_version() { return fmc_abi_version(); }
// Whether the library has a feature, see `fmc_has_feature`.
inline bool has_feature(const std::string &name) { return fmc_has_feature(name.c_str()) != 0; }

// Contact forces between bodies, in one call; bit-for-bit identical to a `Context`. Cells in a block for each type, {{FMC_HEX8, hexes},
// {FMC_TET4, tets}}, with numbers of 32 or 64 bits; `body_ids`, one for every cell, may be left out. With friction, at the end `coords`
// of a step, which receives the slip that is carried into the next one.
inline ContactForces contact_force(int dim, Coords coords, View<const Cells<int32_t>> cells, const Options &options,
                                   View<const int32_t> body_ids = {}, FrictionStep *step = nullptr);
inline ContactForces contact_force(int dim, Coords coords, View<const Cells<int64_t>> cells, const Options &options,
                                   View<const int64_t> body_ids = {}, FrictionStep *step = nullptr);

// A stiffness k to begin with, from Young's modulus of the softer body and the size of its cells, see `fmc_suggest_stiffness`; `dim`
// and `exponent` for the law "volume" alone.
inline double suggest_stiffness(double modulus, double cell_size, fmc_law law = FMC_LAW_DEPTH, int dim = 3, double exponent = 1) {
  double k = 0;
  check(fmc_suggest_stiffness(law, dim, exponent, modulus, cell_size, &k));
  return k;
}

namespace detail {

template <class Int>
ContactForces force(int dim, const Coords &coords, View<const Cells<Int>> cells, const Options &options, View<const Int> body_ids,
                    FrictionStep *step) {
  const DenseRows x(coords, dim);
  const auto blocks = blocks_of<fmc_cell_block>(cells, nodes_of, "cells");
  const auto *ids = one_for_each(body_ids, blocks.count, "body_ids");
  ContactForces found;
  found.forces.resize(x.node_count() * static_cast<std::size_t>(dim));
  const auto call = [&](const fmc_friction_step *c) {
    check(fmc_contact_force(dim, x.data(), x.node_count(), blocks.list.data(), blocks.list.size(), ids, &options, c,
                            found.forces.data(), &found.volume));
  };
  if (step == nullptr) {
    call(nullptr);
    return found;
  }
  const DenseRows start(step->start, dim), reference(step->reference, dim);
  if (start.node_count() != x.node_count()) refuse(FMC_ERROR_LENGTH, "start has another number of nodes than coords");
  if (reference.node_count() != x.node_count() && reference.node_count() != 0)
    refuse(FMC_ERROR_LENGTH, "reference has another number of nodes than coords");
  fmc_friction_step c;
  std::size_t count = 0;
  check(fmc_friction_step_init(&c));
  c.start = start.data();
  c.reference = reference.node_count() != 0 ? reference.data() : nullptr;
  c.slip = step->slip.empty() ? nullptr : step->slip.data();
  c.slip_count = step->slip.size();
  c.next_slip_count = &count;
  // Without slip the number of facets is asked for first.
  if (step->slip.empty()) call(&c);
  std::vector<double> next(step->slip.empty() ? count : step->slip.size());
  c.next_slip = next.data();
  c.next_slip_capacity = next.size();
  call(&c);
  step->next_slip = std::move(next);
  return found;
}

}  // namespace detail

inline ContactForces contact_force(int dim, Coords coords, View<const Cells<int32_t>> cells, const Options &options,
                                   View<const int32_t> body_ids, FrictionStep *step) {
  return detail::force(dim, coords, cells, options, body_ids, step);
}
inline ContactForces contact_force(int dim, Coords coords, View<const Cells<int64_t>> cells, const Options &options,
                                   View<const int64_t> body_ids, FrictionStep *step) {
  return detail::force(dim, coords, cells, options, body_ids, step);
}

}  // namespace fmc

#endif  // FMC_CONTACT_HPP
