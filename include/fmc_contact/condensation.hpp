// Bodies factorised once, down to the equations that feel contact. Part of fmc_contact.hpp.
#ifndef FMC_CONTACT_CONDENSATION_HPP
#define FMC_CONTACT_CONDENSATION_HPP

#include "view.hpp"

#include <memory>

namespace fmc {

// Cholesky factors of a host's sparse stiffness, for `Context::contact_step` where the host's solver has no Schur complements. It
// owns an `fmc_condensation`, and can be moved but not copied. Every method is the function `fmc_condensation_...` of its
// name, where definitions and causes of failure stand; a failure is thrown as `Error`. One thread at a time.
class Condensation {
 public:
  Condensation() {
    fmc_condensation *made = nullptr;
    check(fmc_condensation_new(&made));
    factors_.reset(made);
  }
  Condensation(View<const int64_t> row_offsets, View<const int64_t> cols, View<const double> values, View<const int64_t> kept)
      : Condensation() {
    factorise(row_offsets, cols, values, kept);
  }

  // The symmetric stiffness in compressed rows, whole or its lower triangle, and the equations that feel contact, ascending.
  void factorise(View<const int64_t> row_offsets, View<const int64_t> cols, View<const double> values,
                 View<const int64_t> kept) {
    if (row_offsets.size() == 0) detail::refuse(FMC_ERROR_LENGTH, "row_offsets: empty, needed is one more than equations");
    const auto count = row_offsets.size() - 1;
    const auto entries = static_cast<std::size_t>(row_offsets.data()[count]);
    need(cols.size(), entries, "cols"), need(values.size(), entries, "values");
    check(fmc_condensation_factorise(get(), count, row_offsets.data(), cols.data(), values.data(), kept.data(), kept.size()));
    count_ = count, kept_ = kept.size();
  }

  // S, row by row.
  std::vector<double> complement() const {
    std::vector<double> found(kept_ * kept_);
    check(fmc_condensation_complement(get(), found.data(), found.size()));
    return found;
  }
  // What a right side, a number for every equation, leaves on those that are kept.
  std::vector<double> condense(View<const double> right) const {
    std::vector<double> found(kept_);
    check(fmc_condensation_condense(get(), right.data(), right.size(), found.data(), found.size()));
    return found;
  }
  // All equations' solution from that of those that are kept.
  std::vector<double> expand(View<const double> right, View<const double> kept) const {
    std::vector<double> found(count_);
    check(fmc_condensation_expand(get(), right.data(), right.size(), kept.data(), kept.size(), found.data(), found.size()));
    return found;
  }

  // For calls of the C interface; factors made by one are not known here.
  fmc_condensation *get() const noexcept { return factors_.get(); }

 private:
  struct Free {
    void operator()(fmc_condensation *factors) const noexcept { fmc_condensation_free(&factors); }
  };

  static void need(std::size_t found, std::size_t expected, const char *what) {
    if (found == expected) return;
    detail::refuse(FMC_ERROR_LENGTH, std::string(what) + ": " + std::to_string(found) + " numbers, needed are " +
                                         std::to_string(expected));
  }

  std::unique_ptr<fmc_condensation, Free> factors_;
  std::size_t count_ = 0, kept_ = 0;
};

}  // namespace fmc

#endif
