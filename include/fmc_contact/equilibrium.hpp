// The equilibrium at the end of a load step, in a loop over functions of the host. Part of fmc_contact.hpp.
#ifndef FMC_CONTACT_EQUILIBRIUM_HPP
#define FMC_CONTACT_EQUILIBRIUM_HPP

#include "context.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <tuple>

namespace fmc {

// Tolerances and limits of a search: see `fmc_equilibrium_options`.
struct EquilibriumOptions : fmc_equilibrium_options {
  EquilibriumOptions() : fmc_equilibrium_options() { fmc::check(fmc_equilibrium_options_init(this)); }
};

// The bodies of a host. K is the derivative of the forces at the last request with `matrix`. Output arrays have a number for every unknown,
// zero before; a function returns false if it has no answer.
struct EquilibriumHost {
  // Internal minus external forces at x, without contact. `energy` is strain energy minus the work of loads; leave NaN in it if
  // unknown.
  std::function<bool(View<const double> x, bool matrix, double *forces, double &energy)> forces;
  // K v, or |K| v, with rows and columns of unknowns that are not free.
  std::function<void(View<const double> vector, bool magnitudes, double *product)> product;
  std::function<void(double *diagonal)> diagonal;
  // d with (K + shift diag K + T) d = right in the rows of free unknowns. T: `Context::tangent` at x with these flags.
  std::function<bool(View<const double> x, uint32_t tangent_flags, double shift, View<const double> right, double *d)> solve;
};

// Unknowns of a host: see `fmc_equilibrium_problem`.
struct EquilibriumProblem {
  View<const int64_t> unknown_of_coordinate;  // May be left out: each is moved by the unknown of its own number.
  View<const double> base;
  View<const uint8_t> free;
  View<const double> x;
  View<const double> prescribed;  // May be left out.
};

// Result of a search. `way` is FMC_WAY_NONE for a refusal; `texts` has then a sentence, else the warnings.
struct Equilibrium {
  int way = FMC_WAY_NONE;
  std::vector<double> x, reactions, residuals;
  std::vector<std::string> texts;
  fmc_equilibrium_result counts{};  // Its arrays are gone.
};

namespace detail {

// A problem as C takes it, with the numbers that it points to.
class GivenProblem {
 public:
  GivenProblem(const Context &context, const EquilibriumProblem &problem) {
    const auto axes = static_cast<std::size_t>(context.dim());
    const std::size_t rows = problem.base.size() / axes, count = problem.x.size();
    // Numbers of the same width and base as in the mesh.
    std::vector<int64_t> &wide = wide_;
    wide.assign(problem.unknown_of_coordinate.begin(), problem.unknown_of_coordinate.end());
    if (wide.empty()) {
      wide.resize(problem.base.size());
      std::iota(wide.begin(), wide.end(), context.options().index_base);
    }
    narrow_.assign(wide.begin(), wide.end());
    for (const auto &[size, wanted, name] : {std::tuple(wide.size(), problem.base.size(), "unknown_of_coordinate"),
                                             std::tuple(problem.base.size(), rows * axes, "base"),
                                             std::tuple(problem.free.size(), count, "free"),
                                             std::tuple(problem.prescribed.empty() ? count : problem.prescribed.size(), count, "prescribed")})
      if (size != wanted)
        refuse(FMC_ERROR_LENGTH, std::string(name) + ": " + std::to_string(size) + " numbers, needed are " + std::to_string(wanted));
    check(fmc_equilibrium_problem_init(&given_));
    given_.unknown_count = count, given_.row_count = rows;
    given_.unknown_of_coordinate =
        context.index_size() == 4 ? static_cast<const void *>(narrow_.data()) : static_cast<const void *>(wide.data());
    given_.base = problem.base.data(), given_.free = problem.free.data(), given_.x = problem.x.data();
    given_.prescribed = problem.prescribed.size() > 0 ? problem.prescribed.data() : nullptr;
  }
  GivenProblem(const GivenProblem &) = delete;
  GivenProblem &operator=(const GivenProblem &) = delete;

  const fmc_equilibrium_problem *get() const noexcept { return &given_; }

 private:
  std::vector<int64_t> wide_;
  std::vector<int32_t> narrow_;
  fmc_equilibrium_problem given_;
};

class EquilibriumSearch {
 public:
  EquilibriumSearch(Context &context, const EquilibriumProblem &problem, const EquilibriumOptions &options) {
    const GivenProblem given(context, problem);
    fmc_equilibrium *made = nullptr;
    check(fmc_equilibrium_new(context.get(), given.get(), &options, &made));
    search_.reset(made);
  }

  fmc_equilibrium *get() const noexcept { return search_.get(); }

 private:
  struct Free {
    void operator()(fmc_equilibrium *search) const noexcept { fmc_equilibrium_free(&search); }
  };
  std::unique_ptr<fmc_equilibrium, Free> search_;
};

// Asks the host until the search has ended.
inline Equilibrium answered(Context &context, const EquilibriumSearch &search, const EquilibriumHost &host, std::size_t count) {
  std::vector<double> found(count);
  fmc_equilibrium_request request;
  fmc_equilibrium_answer answer;
  const fmc_equilibrium_answer *given = nullptr;
  double energy = 0;
  const auto view = [count](const double *array) { return View<const double>(array, count); };
  for (;;) {
    check(fmc_equilibrium_next(context.get(), search.get(), given, &request));
    check(fmc_equilibrium_answer_init(&answer));
    bool is_there = true;
    std::fill(found.begin(), found.end(), 0.0);
    switch (request.kind) {
      case FMC_REQUEST_FORCES:
        energy = std::numeric_limits<double>::quiet_NaN();
        is_there = host.forces(view(request.x), request.matrix != 0, found.data(), energy);
        if (energy == energy) answer.energy = &energy;
        break;
      case FMC_REQUEST_PRODUCT:
        host.product(view(request.vector), request.magnitudes != 0, found.data());
        break;
      case FMC_REQUEST_DIAGONAL:
        host.diagonal(found.data());
        break;
      case FMC_REQUEST_SOLVE:
        is_there = host.solve(view(request.x), request.tangent_flags, request.shift, view(request.vector), found.data());
        break;
      case FMC_REQUEST_CONDENSED:
        is_there = false;
        break;
      default: {
        Equilibrium end;
        check(fmc_equilibrium_found(search.get(), &end.counts));
        end.way = end.counts.way;
        if (end.counts.x != nullptr) end.x.assign(end.counts.x, end.counts.x + count);
        if (end.counts.reactions != nullptr) end.reactions.assign(end.counts.reactions, end.counts.reactions + count);
        end.residuals.assign(end.counts.residuals, end.counts.residuals + end.counts.residual_count);
        for (std::size_t k = 0; k < end.counts.text_count; ++k) end.texts.emplace_back(fmc_equilibrium_text(search.get(), k));
        end.counts.x = end.counts.reactions = end.counts.residuals = nullptr;
        return end;
      }
    }
    answer.vector = is_there ? found.data() : nullptr;
    given = &answer;
  }
}

}  // namespace detail

// The equilibrium at the end of a load step: see `fmc_equilibrium_next`. It rethrows an exception of the host's functions; the contact is
// then unchanged.
inline Equilibrium find_equilibrium(Context &context, const EquilibriumProblem &problem, const EquilibriumHost &host,
                                    const EquilibriumOptions &options = {}) {
  const detail::EquilibriumSearch search(context, problem, options);
  try {
    return detail::answered(context, search, host, problem.x.size());
  } catch (...) {
    fmc_equilibrium_abandon(context.get(), search.get());
    throw;
  }
}

// Derivatives of a number J(x, F) of an equilibrium: see `fmc_equilibrium_adjoint`.
struct EquilibriumAdjoint {
  std::vector<double> balance;  // The host's part of dJ/dp is -balance . dR/dp; a load has the derivative `balance`.
  std::vector<double> right;    // Less K^T balance: by the values of unknowns that are not free.
  std::vector<fmc_pair_gradient> pairs;
  bool is_there = false;  // False where the host has no solution.
};

// The adjoint of the equilibrium `problem.x`, found by any solver. `solve_transposed` fills a vector, zero before, with the solution b of
// (K + T)^T b = right in the rows of free unknowns, T being `Context::tangent` there without flags. If J does not depend on forces,
// `by_forces` is empty. `to` selects the derivatives, and receives them.
inline EquilibriumAdjoint adjoint(Context &context, const EquilibriumProblem &problem, View<const double> by_x, View<const double> by_forces,
                                  const std::function<bool(View<const double> right, double *balance)> &solve_transposed,
                                  const Gradients &to = {}) {
  const detail::GivenProblem given(context, problem);
  const std::size_t count = problem.x.size();
  if (by_x.size() != count || (!by_forces.empty() && by_forces.size() != problem.base.size()))
    detail::refuse(FMC_ERROR_LENGTH, "by_x has a number for every unknown, by_forces one for every coordinate");
  const double *of_forces = by_forces.empty() ? nullptr : by_forces.data();
  EquilibriumAdjoint found;
  found.right.resize(count), found.balance.assign(count, 0.0);
  std::size_t pairs = 0;
  const auto asked = [&](const double *balance, const fmc_gradients *gradients) {
    return fmc_equilibrium_adjoint(context.get(), given.get(), by_x.data(), of_forces, balance, found.right.data(), gradients,
                                   found.pairs.data(), found.pairs.size(), &pairs);
  };
  check(asked(nullptr, nullptr));
  found.is_there = solve_transposed(found.right, found.balance.data());
  if (!found.is_there) return found;
  found.pairs.resize(16);
  auto status = asked(found.balance.data(), &to);
  if (status == FMC_ERROR_BUFFER_TOO_SMALL) found.pairs.resize(pairs), status = asked(found.balance.data(), &to);
  check(status);
  found.pairs.resize(pairs);
  return found;
}

}  // namespace fmc

#endif
