// The equilibrium of a host that has a matrix in compressed rows and no solver: the library's solves. Part of fmc_contact.hpp.
#ifndef FMC_CONTACT_BODIES_HPP
#define FMC_CONTACT_BODIES_HPP

#include "condensation.hpp"
#include "equilibrium.hpp"

#include <cmath>

namespace fmc {

// Bodies of a host. Fills in internal less external forces at x, without contact, a number for every unknown, zero before; where `matrix` is
// not null their derivative, rows and columns of unknowns that are not free included. It counts from 0, and entries at one place add up. False
// where bodies cannot be so, as where a cell is inverted.
using Bodies = std::function<bool(View<const double> x, double *forces, Csr<int64_t> *matrix)>;

namespace detail {

class CsrBodies {
 public:
  CsrBodies(Context &context, const EquilibriumProblem &problem, const Bodies &bodies)
      : context_(context), problem_(problem), bodies_(bodies), first_(context.options().index_base),
        unknowns_(problem.unknown_of_coordinate.begin(), problem.unknown_of_coordinate.end()), coords_(problem.base.size()) {
    for (auto &unknown : unknowns_) unknown -= first_;
    if (unknowns_.empty()) {
      unknowns_.resize(coords_.size());
      std::iota(unknowns_.begin(), unknowns_.end(), 0);
    }
  }

  EquilibriumHost host() {
    EquilibriumHost host;
    host.forces = [this](View<const double> x, bool matrix, double *forces, double &) {
      if (matrix) matrix_ = {}, known_ = false;
      return bodies_(x, forces, matrix ? &matrix_ : nullptr);
    };
    host.product = [this](View<const double> vector, bool magnitudes, double *product) {
      each([&](std::size_t row, std::size_t col, double value) { product[row] += (magnitudes ? std::fabs(value) : value) * vector[col]; });
    };
    host.diagonal = [this](double *diagonal) {
      each([&](std::size_t row, std::size_t col, double value) { diagonal[row] += row == col ? value : 0; });
    };
    host.solve = [this](View<const double> x, uint32_t flags, double shift, View<const double> right, double *d) {
      return solve(x, flags, shift, right, d);
    };
    return host;
  }

 private:
  using Rows = std::vector<std::vector<std::pair<int64_t, double>>>;

  template <class Visit>
  void each(Visit visit) const {
    for (std::size_t row = 0; row < matrix_.rows(); ++row)
      for (auto e = matrix_.row_offsets[row]; e < matrix_.row_offsets[row + 1]; ++e) {
        const auto entry = static_cast<std::size_t>(e);
        visit(row, static_cast<std::size_t>(matrix_.cols[entry]), matrix_.values[entry]);
      }
  }

  // Contact's tangent, entries of free unknowns.
  void add_tangent(View<const double> x, uint32_t flags, Rows &rows) {
    for (std::size_t k = 0; k < coords_.size(); ++k)
      coords_[k] = problem_.base[k] + (unknowns_[k] >= 0 ? x[static_cast<std::size_t>(unknowns_[k])] : 0);
    context_.find_tangent(coords_, flags);
    const Entries entries = context_.tangent_entries();
    // -1: not solved for, or an obstacle, which come beyond the nodes.
    const auto free_unknown = [&](int64_t coordinate) -> int64_t {
      const auto place = static_cast<std::size_t>(coordinate - first_);
      const auto unknown = place < unknowns_.size() ? unknowns_[place] : -1;
      return unknown >= 0 && problem_.free[static_cast<std::size_t>(unknown)] != 0 ? unknown : -1;
    };
    for (std::size_t e = 0; e < entries.values.size(); ++e) {
      const auto row = free_unknown(entries.rows[e]), col = free_unknown(entries.cols[e]);
      if (row >= 0 && col >= 0) rows[static_cast<std::size_t>(row)].emplace_back(col, entries.values[e]);
    }
  }

  bool solve(View<const double> x, uint32_t flags, double shift, View<const double> right, double *d) {
    const std::vector<double> at(x.begin(), x.end());
    const auto is_free = [&](std::size_t unknown) { return problem_.free[unknown] != 0; };
    if (!known_ || at != at_ || flags != flags_ || shift != shift_) {
      Rows rows(x.size());
      for (std::size_t k = 0; k < x.size(); ++k)
        if (!is_free(k)) rows[k].emplace_back(k, 1);
      each([&](std::size_t row, std::size_t col, double value) {
        if (is_free(row) && is_free(col)) rows[row].emplace_back(col, row == col ? (1 + shift) * value : value);
      });
      add_tangent(x, flags, rows);
      Csr<int64_t> sum{{0}, {}, {}};
      for (const auto &row : rows) {
        for (const auto &[col, value] : row) sum.cols.push_back(col), sum.values.push_back(value);
        sum.row_offsets.push_back(static_cast<int64_t>(sum.cols.size()));
      }
      try {
        factors_.factorise(CsrView<int64_t>{sum.row_offsets, sum.cols, sum.values}, {});
      } catch (const Error &error) {
        known_ = false;
        if (error.status() != FMC_ERROR_NOT_POSITIVE_DEFINITE && error.status() != FMC_ERROR_OVERFLOW) throw;
        return false;
      }
      known_ = true, at_ = at, flags_ = flags, shift_ = shift;
    }
    std::vector<double> wanted(right.begin(), right.end());
    for (std::size_t k = 0; k < wanted.size(); ++k) wanted[k] = is_free(k) ? wanted[k] : 0;
    const auto found = factors_.expand(wanted, {});
    std::copy(found.begin(), found.end(), d);
    return true;
  }

  Context &context_;
  const EquilibriumProblem &problem_;
  const Bodies &bodies_;
  int64_t first_;
  std::vector<int64_t> unknowns_;  // Of every coordinate, from 0; negative for one that never moves.
  std::vector<double> coords_, at_;
  Csr<int64_t> matrix_;
  Condensation factors_;
  bool known_ = false;
  uint32_t flags_ = 0;
  double shift_ = 0;
};

}  // namespace detail

// The same with the library's linear solver, which takes matrices that are symmetric and positive definite. With friction, and for bodies that
// may buckle or slip off each other, answer by `EquilibriumHost` and a solver that takes others.
inline Equilibrium find_equilibrium(Context &context, const EquilibriumProblem &problem, const Bodies &bodies,
                                    const EquilibriumOptions &options = {}) {
  detail::CsrBodies answers(context, problem, bodies);
  return find_equilibrium(context, problem, answers.host(), options);
}

}  // namespace fmc

#endif
