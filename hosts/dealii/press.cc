/* Bodies that press each other, in deal.II: press PROBLEM SOLUTION, with a table as problem.h says. Newton's method of its own on load
 * steps that are halved where it fails, or with friction on those that are given. Cells may be refined: nodes hang, and
 * AffineConstraints hold them. The solution has a line of linear solves, seconds of the processor and those in contact, then
 * displacement and contact force of every node. */
#include "contact.h"
#include "mesh.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_direct.h>

#include <ctime>
#include <iomanip>
#include <iostream>

using namespace dealii;
constexpr int MOST = 14; /* solves of a load step */

static double seconds() { return double(std::clock()) / CLOCKS_PER_SEC; } /* of the processor */

class Press {
 public:
  explicit Press(const Problem &problem)
      : problem_(problem), fe_(FE_Q<dim>(1), dim), handler_((make_mesh(problem, mesh_), mesh_)), options_(problem.stiffness) {
    handler_.distribute_dofs(fe_);
    dof_.resize(dim * mesh_.n_vertices());
    for (const auto &cell : handler_.active_cell_iterators())
      for (const auto v : cell->vertex_indices())
        for (unsigned axis = 0; axis < dim; ++axis) dof_[dim * cell->vertex_index(v) + axis] = cell->vertex_dof_index(v, axis);
    DoFTools::make_hanging_node_constraints(handler_, hanging_);
    hanging_.close();
    options_.law = problem.law, options_.estimator = FMC_ESTIMATOR_EXACT;
    options_.friction_coefficient = problem.friction;
    contact_ = std::make_unique<Contact<dim>>(handler_, options_);
    for (const auto &row : problem.half_spaces) {
      const std::vector<double> point(row.begin(), row.begin() + dim), normal(row.begin() + dim, row.end());
      contact_->context().add_half_space(fmc::Pose::along(point, normal));
    }
    u_.reinit(handler_.n_dofs());
  }

  double contact_seconds() const { return in_contact_; }

  /* To the end of the load; the number of linear solves. The first touch is that of a soft contact, which is then made stiff. With
   * friction the way counts: load steps are those that are given, each committed once. */
  unsigned run() {
    const bool slides = problem_.friction > 0;
    const double last = static_cast<double>(problem_.steps);
    double done = 0, step = slides ? 1 : 1. / 64, soft = slides ? 1 : 1e-4;
    unsigned solves = 0;
    while (done < last || soft < 1) {
      const auto to = soft < 1 && done > 0 ? done : std::min(done + step, last);
      const auto before = u_;
      options_.stiffness = soft * problem_.stiffness;
      contact_->context().set_options(options_);
      if (slides) contact_->context().begin_step(contact_->moved(u_));
      const auto taken = solve(done, to);
      solves += std::abs(taken);
      if (taken > 0) {
        std::cout << "load " << to << ", stiffness " << options_.stiffness << ": " << taken << " solves" << std::endl;
        if (slides) contact_->context().commit_step(contact_->moved(u_));
        else if (soft < 1) soft = std::min(4 * soft, 1.);
        else step = std::min(2 * step, 0.125);
        done = to;
      } else {
        u_ = before, step /= 2;
        if (slides || step < 1e-6) throw std::runtime_error("no equilibrium");
      }
    }
    return solves;
  }

  void write(std::ostream &out) {
    Vector<double> force(u_.size());
    contact_->add_forces(u_, force);
    for (std::size_t k = 0; k < dof_.size(); k += dim)
      out << u_(dof_[k]) << ' ' << u_(dof_[k + 1]) << ' ' << force(dof_[k]) << ' ' << force(dof_[k + 1]) << '\n';
  }

 private:
  /* Newton's method; prescribed displacements enter with the first solve. Solves, negative where there is no equilibrium. */
  int solve(double from, double to) {
    for (int solves = 0; solves < MOST; ++solves) {
      SparsityPattern pattern;
      SparseMatrix<double> matrix;
      Vector<double> residual(u_.size()), change(u_.size());
      double size;
      try {
        const auto begun = seconds();
        contact_->find_tangent(u_);
        in_contact_ += seconds() - begun;
        size = assemble(pattern, matrix, residual);
      } catch (const fmc::Error &error) {
        if (error.status() != FMC_ERROR_INVERTED_CELL && error.status() != FMC_ERROR_NON_FINITE_COORDINATE) throw;
        return -solves - 1;
      }
      AffineConstraints<double> held;
      DoFTools::make_hanging_node_constraints(handler_, held);
      for (const auto &row : problem_.held) {
        const auto dof = dof_[dim * static_cast<std::size_t>(row[0]) + static_cast<std::size_t>(row[1])];
        held.add_line(dof);
        held.set_inhomogeneity(dof, solves == 0 ? problem_.prescribed(row, to) - problem_.prescribed(row, from) : 0);
      }
      held.close();
      /* What is left at a node that hangs is its neighbours'. */
      auto left = residual;
      hanging_.condense(left);
      held.set_zero(left);
      if (!std::isfinite(left.l2_norm())) return -solves - 1;
      /* Of a first small load the contact leaves some 1e-11: the last bit of coordinates, times its stiffness. */
      const double rounding = 1e-15 * matrix.linfty_norm() * u_.l2_norm();
      if (solves > 0 && left.l2_norm() <= std::max(1e-10 * size, rounding)) return solves;
      held.condense(matrix, residual);
      SparseDirectUMFPACK direct;
      direct.initialize(matrix);
      direct.vmult(change, residual);
      held.distribute(change);
      u_ += change;
    }
    return -MOST;
  }

  /* Forces that are left over, and the stiffness; what they are compared with. */
  double assemble(SparsityPattern &pattern, SparseMatrix<double> &matrix, Vector<double> &residual) {
    DynamicSparsityPattern places(handler_.n_dofs());
    DoFTools::make_sparsity_pattern(handler_, places);
    contact_->add_places(places);
    hanging_.condense(places);
    pattern.copy_from(places);
    matrix.reinit(pattern);
    Vector<double> inside(u_.size()), outside(u_.size());
    add_bodies(matrix, inside);
    const auto begun = seconds();
    contact_->add_tangent(matrix);
    contact_->add_forces(u_, outside);
    in_contact_ += seconds() - begun;
    residual = outside;
    residual -= inside;
    return std::max(inside.l2_norm(), outside.l2_norm());
  }

  void add_bodies(SparseMatrix<double> &matrix, Vector<double> &inside) const {
    const QGauss<dim> rule(2);
    FEValues<dim> values(fe_, rule, update_gradients | update_JxW_values);
    const auto count = fe_.n_dofs_per_cell();
    FullMatrix<double> stiffness(count, count);
    Vector<double> force(count);
    std::vector<types::global_dof_index> dofs(count);
    std::vector<Tensor<2, dim>> gradients(rule.size());
    const FEValuesExtractors::Vector displacement(0);
    for (const auto &cell : handler_.active_cell_iterators()) {
      values.reinit(cell);
      values[displacement].get_function_gradients(u_, gradients);
      const auto &material = problem_.materials[cell->material_id()];
      stiffness = 0, force = 0;
      for (const auto q : values.quadrature_point_indices()) {
        const auto h = in_space(gradients[q]);
        const auto stress = material.stress(h) * values.JxW(q);
        for (const auto j : values.dof_indices()) {
          const auto change = material.change(h, in_space(values[displacement].gradient(j, q))) * values.JxW(q);
          force(j) += scalar_product(stress, in_space(values[displacement].gradient(j, q)));
          for (const auto i : values.dof_indices())
            stiffness(i, j) += scalar_product(change, in_space(values[displacement].gradient(i, q)));
        }
      }
      cell->get_dof_indices(dofs);
      matrix.add(dofs, stiffness);
      inside.add(dofs, force);
    }
  }

  const Problem &problem_;
  Triangulation<dim> mesh_;
  FESystem<dim> fe_;
  DoFHandler<dim> handler_;
  AffineConstraints<double> hanging_;
  std::vector<types::global_dof_index> dof_; /* of node and axis */
  fmc::Options options_;
  std::unique_ptr<Contact<dim>> contact_;
  Vector<double> u_;
  double in_contact_ = 0;
};

int main(int count, char **given) try {
  if (count != 3) throw std::runtime_error("press PROBLEM SOLUTION");
  const Problem problem(given[1]);
  Press press(problem);
  const auto begun = seconds();
  const auto solves = press.run();
  std::ofstream out(given[2]);
  out << std::setprecision(17) << solves << ' ' << seconds() - begun << ' ' << press.contact_seconds() << '\n';
  press.write(out);
} catch (const std::exception &error) {
  std::cerr << error.what() << std::endl;
  return 1;
}
