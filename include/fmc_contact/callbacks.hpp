// Functions of the host that the library calls, and which may throw. Part of fmc_contact.hpp.
#ifndef FMC_CONTACT_CALLBACKS_HPP
#define FMC_CONTACT_CALLBACKS_HPP

#include "view.hpp"

#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace fmc {

// Receives messages: `FMC_LOG_WARNING`, and a sentence.
using Log = std::function<void(int32_t level, const char *text)>;

// Whether the call that is running is to end; what it throws ends it, and comes out of it.
using Interrupt = std::function<bool()>;

// Signed distance at a point x of dim numbers: returns it, negative inside, positive outside, with slope of at most 1, and
// writes its gradient, of any length; where it is 0 that is the outward normal.
using SignedDistance = std::function<double(View<const double> x, View<double> gradient)>;

// The same for n points at once: x and gradients (n, dim), distances (n).
using SignedDistances = std::function<void(View<const double> x, View<double> distances, View<double> gradients)>;

// Puts the nodes where they are at a displacement of the degrees of freedom on the list of a contact step: coordinates, (n, dim),
// those of the start with the displacement added on the list.
using Place = std::function<void(View<const double> displacement, View<double> coords)>;

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
using Distances = std::vector<std::unique_ptr<DistanceCall>>;

// The functions of one context, and what one of them has thrown in the call that is running.
struct Callbacks {
  std::exception_ptr thrown;
  std::unique_ptr<LogCall> log;
  std::unique_ptr<InterruptCall> interrupt;
  // Of every obstacle that has any, those of its shape.
  std::map<std::size_t, Distances> distances;

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

}  // namespace detail
}  // namespace fmc

#endif  // FMC_CONTACT_CALLBACKS_HPP
