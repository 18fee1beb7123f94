// Bodies factorised once, down to the equations that feel contact. Part of fmc_contact.hpp.
#ifndef FMC_CONTACT_CONDENSATION_HPP
#define FMC_CONTACT_CONDENSATION_HPP

#include "data.hpp"

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
  template <class Int>
  Condensation(const CsrView<Int> &matrix, std::enable_if_t<true, View<const Int>> retained) : Condensation() {
    factorise(matrix, retained);
  }

  // The symmetric stiffness in compressed rows, whole or its lower triangle, and the equations that feel contact, ascending, counted
  // as the matrix does.
  template <class Int>
  void factorise(const CsrView<Int> &matrix, std::enable_if_t<true, View<const Int>> retained) {
    const auto c = matrix.as_c();
    check(fmc_condensation_factorise(get(), &c, retained.data(), retained.size()));
    count_ = c.row_count, retained_ = retained.size();
  }

  // S, row by row.
  std::vector<double> complement() const {
    std::vector<double> found(retained_ * retained_);
    check(fmc_condensation_complement(get(), found.data(), found.size(), nullptr));
    return found;
  }
  // Condenses a right side, a number for every equation, on the retained equations.
  std::vector<double> condense(View<const double> right) const {
    std::vector<double> found(retained_);
    check(fmc_condensation_condense(get(), right.data(), right.size(), found.data(), found.size(), nullptr));
    return found;
  }
  // Solution of all equations from the solution of the retained ones.
  std::vector<double> expand(View<const double> right, View<const double> retained) const {
    std::vector<double> found(count_);
    check(fmc_condensation_expand(get(), right.data(), right.size(), retained.data(), retained.size(), found.data(), found.size(), nullptr));
    return found;
  }

  // For calls of the C interface; factors made by one are not known here.
  fmc_condensation *get() const noexcept { return factors_.get(); }

 private:
  struct Free {
    void operator()(fmc_condensation *factors) const noexcept { fmc_condensation_free(&factors); }
  };

  std::unique_ptr<fmc_condensation, Free> factors_;
  std::size_t count_ = 0, retained_ = 0;
};

}  // namespace fmc

#endif
