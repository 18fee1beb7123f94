/* The equilibrium at the end of a load step, by the library's search, with deal.II's matrices and UMFPACK. */
#ifndef FMC_DEALII_SEARCH_H
#define FMC_DEALII_SEARCH_H

#include "contact.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/sparse_direct.h>

#include <cmath>
#include <ctime>
#include <functional>

template <int dim>
class Search {
 public:
  using Vector = dealii::Vector<double>;
  /* Adds internal less external forces at a displacement, and to a matrix, unless it is null, their derivative. */
  using Bodies = std::function<void(const Vector &u, Vector &forces, dealii::SparseMatrix<double> *matrix)>;

  Search(const dealii::DoFHandler<dim> &handler, const dealii::AffineConstraints<double> &hanging, Contact<dim> &contact, Bodies bodies)
      : hanging_(hanging), contact_(contact), bodies_(std::move(bodies)), forces_(handler.n_dofs()) {
    dealii::DynamicSparsityPattern places(handler.n_dofs());
    dealii::DoFTools::make_sparsity_pattern(handler, places);
    hanging_.condense(places);
    pattern_.copy_from(places);
    matrix_.reinit(pattern_);
  }

  /* From u to where degrees of freedom are prescribed, which are held there. Errors: std::runtime_error, u is then what it was. */
  fmc::Equilibrium run(Vector &u, const std::map<dealii::types::global_dof_index, double> &prescribed,
                       const fmc::EquilibriumOptions &options = {}) {
    std::vector<int64_t> unknowns(contact_.dofs().begin(), contact_.dofs().end());
    std::vector<uint8_t> free(u.size(), 1);
    std::vector<double> end(u.size());
    for (const auto &line : hanging_.get_lines()) free[line.index] = 0;
    for (auto &dof : unknowns)
      if (hanging_.is_constrained(static_cast<unsigned>(dof))) dof = -1;
    for (const auto &[dof, value] : prescribed) free[dof] = 0, end[dof] = value;
    held_.clear();
    for (unsigned k = 0; k < u.size(); ++k)
      if (!free[k]) held_.add_line(k);
    held_.close();
    const std::vector<double> start(u.begin(), u.end());
    const auto found = fmc::find_equilibrium(contact_.context(), {unknowns, contact_.start(), free, start, end}, answers(), options);
    if (found.way == FMC_WAY_NONE) throw std::runtime_error("no equilibrium: " + found.texts.at(0));
    std::copy(found.x.begin(), found.x.end(), u.begin());
    hanging_.distribute(u);
    return found;
  }

  /* Processor time of assembling and solving so far. */
  double host_seconds() const { return host_seconds_; }

 private:
  using Numbers = fmc::View<const double>;

  /* Counts the time of the host while it lives. */
  struct Clock {
    double &sum;
    std::clock_t begun = std::clock();
    ~Clock() { sum += double(std::clock() - begun) / CLOCKS_PER_SEC; }
  };

  fmc::EquilibriumHost answers() {
    fmc::EquilibriumHost host;
    host.forces = [this](Numbers x, bool matrix, double *forces, double &) {
      const Clock clock{host_seconds_};
      auto u = vector(x);
      hanging_.distribute(u);
      forces_ = 0;
      if (matrix) matrix_ = 0;
      bodies_(u, forces_, matrix ? &matrix_ : nullptr);
      hanging_.condense(forces_);
      if (matrix) hanging_.condense(matrix_);
      std::copy(forces_.begin(), forces_.end(), forces);
      return std::isfinite(forces_.l2_norm());
    };
    host.product = [this](Numbers v, bool magnitudes, double *product) {
      for (const auto &entry : matrix_)
        product[entry.row()] += (magnitudes ? std::abs(entry.value()) : double(entry.value())) * v[entry.column()];
    };
    host.diagonal = [this](double *diagonal) {
      for (unsigned k = 0; k < matrix_.m(); ++k) diagonal[k] = matrix_.diag_element(k);
    };
    host.solve = [this](Numbers x, uint32_t flags, double shift, Numbers right, double *d) {
      contact_.find_tangent(vector(x), flags);
      const Clock clock{host_seconds_};
      dealii::DynamicSparsityPattern places(matrix_.m());
      for (const auto &entry : pattern_) places.add(entry.row(), entry.column());
      contact_.add_places(places);
      dealii::SparsityPattern pattern;
      pattern.copy_from(places);
      dealii::SparseMatrix<double> sum(pattern);
      for (const auto &entry : matrix_)
        sum.add(entry.row(), entry.column(), (entry.row() == entry.column() ? 1 + shift : 1) * entry.value());
      contact_.add_tangent(sum);
      auto found = vector(right);
      held_.condense(sum, found);
      try {
        dealii::SparseDirectUMFPACK().solve(sum, found);
      } catch (const dealii::ExceptionBase &) {
        return false;
      }
      held_.set_zero(found);
      std::copy(found.begin(), found.end(), d);
      return true;
    };
    return host;
  }

  static Vector vector(Numbers numbers) { return Vector(numbers.begin(), numbers.end()); }

  const dealii::AffineConstraints<double> &hanging_;
  Contact<dim> &contact_;
  Bodies bodies_;
  dealii::SparsityPattern pattern_;
  dealii::SparseMatrix<double> matrix_;
  dealii::AffineConstraints<double> held_;
  Vector forces_;
  double host_seconds_ = 0;
};

#endif
