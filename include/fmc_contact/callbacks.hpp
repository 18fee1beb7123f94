// Functions of the host that the library calls, and which may throw. Part of fmc_contact.hpp.
#ifndef FMC_CONTACT_CALLBACKS_HPP
#define FMC_CONTACT_CALLBACKS_HPP

#include "view.hpp"

#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace fmc {

// Receives messages: `FMC_LOG_WARNING`, and a sentence.
using Log = std::function<void(int32_t level, const char *text)>;

// Returns whether to end the running call. An exception that it throws ends the call, which rethrows it.
using Interrupt = std::function<bool()>;

// Signed distance at a point x of dim numbers: returns it, negative inside, positive outside, with slope of at most 1. It
// writes the gradient, of any length; where the distance is 0 the gradient is the outward normal.
using SignedDistance = std::function<double(View<const double> x, View<double> gradient)>;

// The same for n points at once: x and gradients (n, dim), distances (n).
using SignedDistances = std::function<void(View<const double> x, View<double> distances, View<double> gradients)>;

// Places the nodes for a displacement of the degrees of freedom on the list of a contact step. It gets the coordinates of the
// start, (n, dim), with the displacement added on the list.
using Place = std::function<void(View<const double> displacement, View<double> coords)>;

// Points of an interface at which the library calls your law, with the shapes of `fmc_law_points`.
struct LawPoints {
  std::size_t count, dim, history_count, field_count, body, partner;
  double time_step;
  View<const double> jump, axes, position, reference, area, history, fields;
};

// Output of your law, as in `fmc_law_response`.
struct LawResponse {
  View<double> traction, tangent, history, stored, dissipated;
};

// Your own law of an interface: all entries of traction and tangent have to be written. See `fmc_respond`.
using InterfaceLaw = std::function<void(const LawPoints &points, const LawResponse &response)>;

// Facets of a pair for which the library calls your law of friction, with the shapes of `fmc_friction_facets`.
struct FrictionFacets {
  std::size_t count, dim, history_count, field_count, body, partner;
  int32_t partner_kind;
  double time_step, stiffness;
  View<const std::size_t> facet;
  View<const double> pressure, slip, trial, axes, position, area, history, fields;
};

// Output of your law of friction, as in `fmc_friction_response`.
struct FrictionResponse {
  View<double> limit, by_pressure, by_slip, history;
};

// Your own law of friction: all entries of limit and by_pressure have to be written. See `fmc_limit_friction`.
using FrictionLaw = std::function<void(const FrictionFacets &facets, const FrictionResponse &response)>;

namespace detail {

struct PlaceCall {
  const Place &function;
  std::size_t numbers;
  std::exception_ptr thrown;

  static int32_t run(void *user, std::size_t n, const double *displacement, double *coords) noexcept {
    auto &self = *static_cast<PlaceCall *>(user);
    try {
      self.function({displacement, n}, {coords, self.numbers});
      return 0;
    } catch (...) {
      self.thrown = std::current_exception();
      return 1;
    }
  }
};

struct DistanceCall;
struct LogCall;
struct InterruptCall;
struct LawCall;
struct FrictionLawCall;
using Distances = std::vector<std::unique_ptr<DistanceCall>>;

// The functions of one context, and the exception that one of them has thrown in the running call.
struct Callbacks {
  std::exception_ptr thrown;
  std::unique_ptr<LogCall> log;
  std::unique_ptr<InterruptCall> interrupt;
  // The functions of the shape of every obstacle that has any.
  std::map<std::size_t, Distances> distances;
  // Of every pair of bodies that has one, the lower first.
  std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<LawCall>> laws;
  // By kind and index of both partners.
  std::map<std::pair<std::pair<int32_t, std::size_t>, std::pair<int32_t, std::size_t>>, std::unique_ptr<FrictionLawCall>> friction_laws;

  void rethrow() {
    if (thrown) std::rethrow_exception(std::exchange(thrown, nullptr));
  }
};

struct LogCall {
  Log function;
  Callbacks *callbacks;

  static void run(void *user, int32_t level, const char *text) noexcept {
    auto &self = *static_cast<LogCall *>(user);
    if (self.callbacks->thrown) return;
    try {
      self.function(level, text);
    } catch (...) {
      self.callbacks->thrown = std::current_exception();
    }
  }
};

struct InterruptCall {
  Interrupt function;
  Callbacks *callbacks;

  static int32_t run(void *user) noexcept {
    auto &self = *static_cast<InterruptCall *>(user);
    try {
      return self.function() ? 1 : 0;
    } catch (...) {
      if (!self.callbacks->thrown) self.callbacks->thrown = std::current_exception();
      return 1;
    }
  }
};

// One of the two functions is empty.
struct DistanceCall {
  SignedDistance one;
  SignedDistances many;
  std::size_t dim;
  Callbacks *callbacks;

  static int32_t run(void *user, std::size_t n, const double *x, double *phi, double *grad) noexcept {
    auto &self = *static_cast<DistanceCall *>(user);
    const auto dim = self.dim;
    try {
      if (self.many) self.many({x, n * dim}, {phi, n}, {grad, n * dim});
      else for (std::size_t i = 0; i < n; ++i) phi[i] = self.one({x + i * dim, dim}, {grad + i * dim, dim});
      return 0;
    } catch (...) {
      self.callbacks->thrown = std::current_exception();
      return 1;
    }
  }
};

struct LawCall {
  InterfaceLaw function;
  std::exception_ptr *thrown;

  static int32_t run(void *user, const fmc_law_points *points, const fmc_law_response *response) noexcept {
    auto &self = *static_cast<LawCall *>(user);
    const auto &of = *points;
    const auto &to = *response;
    const auto n = of.count, rows = n * of.dim, squares = rows * of.dim, kept = n * of.history_count;
    try {
      self.function({n, of.dim, of.history_count, of.field_count, of.body, of.partner, of.time_step, {of.jump, rows}, {of.axes, squares},
                     {of.position, rows}, {of.reference, rows}, {of.area, n}, {of.history, kept},
                     {of.fields, 2 * n * of.field_count}},
                    {{to.traction, rows}, {to.tangent, squares}, {to.history, kept}, {to.stored, n}, {to.dissipated, n}});
      return 0;
    } catch (...) {
      *self.thrown = std::current_exception();
      return -1;
    }
  }

  fmc_own_law as_c(std::size_t history_count) {
    fmc_own_law law;
    check(fmc_own_law_init(&law));
    law.history_count = history_count, law.respond = run, law.user = this;
    return law;
  }
};

struct FrictionLawCall {
  FrictionLaw function;
  std::exception_ptr *thrown;

  static int32_t run(void *user, const fmc_friction_facets *facets, const fmc_friction_response *response) noexcept {
    auto &self = *static_cast<FrictionLawCall *>(user);
    const auto &of = *facets;
    const auto &to = *response;
    const auto n = of.count, across = n * (of.dim - 1), kept = n * of.history_count;
    try {
      self.function({n, of.dim, of.history_count, of.field_count, of.body, of.partner, of.partner_kind, of.time_step, of.stiffness,
                     {of.facet, n}, {of.pressure, n}, {of.slip, across}, {of.trial, across}, {of.axes, across * of.dim},
                     {of.position, n * of.dim}, {of.area, n}, {of.history, kept}, {of.fields, 2 * n * of.field_count}},
                    {{to.limit, n}, {to.by_pressure, n}, {to.by_slip, across}, {to.history, kept}});
      return 0;
    } catch (...) {
      *self.thrown = std::current_exception();
      return -1;
    }
  }

  fmc_friction_law as_c(std::size_t history_count) {
    fmc_friction_law law;
    check(fmc_friction_law_init(&law));
    law.history_count = history_count, law.limit = run, law.user = this;
    return law;
  }
};

// Keeps the sentences of a check.
inline void keep_sentence(void *user, int32_t, const char *text) { static_cast<std::vector<std::string> *>(user)->emplace_back(text); }

}  // namespace detail

// Checks your law of friction, and returns a sentence for each check: whether the same input has the same answer, and whether its
// derivatives match its limit, up to this pressure and this slip. A fault throws `Error`. See `fmc_friction_law_check`.
inline std::vector<std::string> check_friction_law(FrictionLaw law, std::size_t history_count, std::size_t dim, double pressure, double slip,
                                                   double time_step = 0) {
  std::exception_ptr thrown;
  detail::FrictionLawCall call{std::move(law), &thrown};
  const auto given = call.as_c(history_count);
  std::vector<std::string> sentences;
  const auto status = fmc_friction_law_check(&given, dim, pressure, slip, time_step, detail::keep_sentence, &sentences);
  if (thrown) std::rethrow_exception(thrown);
  check(status);
  return sentences;
}

// Checks your own law, and returns a sentence for each check: whether the same input has the same answer, and whether its tangent is the
// derivative of its traction, at jumps of this scale. A fault throws `Error`. See `fmc_own_law_check`.
inline std::vector<std::string> check_law(InterfaceLaw law, std::size_t history_count, int dim, double scale,
                                          View<const double> jump = {}, double time_step = 0) {
  std::exception_ptr thrown;
  detail::LawCall call{std::move(law), &thrown};
  const auto given = call.as_c(history_count);
  std::vector<std::string> sentences;
  const auto each = static_cast<std::size_t>(dim);
  if (dim < 2 || jump.size() % each != 0) detail::refuse(FMC_ERROR_LENGTH, "jump has one number for every axis of a point");
  const auto status = fmc_own_law_check(&given, each, scale, jump.data(), jump.size() / each, time_step, detail::keep_sentence, &sentences);
  if (thrown) std::rethrow_exception(thrown);
  check(status);
  return sentences;
}
}  // namespace fmc

#endif  // FMC_CONTACT_CALLBACKS_HPP
