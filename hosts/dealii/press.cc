/* Bodies that press each other, in deal.II: press PROBLEM SOLUTION, with a table as problem.h says. Newton's method of its own on load
 * steps that are halved where it fails; the solution has a line of linear solves, seconds of the processor and those in contact, then
 * displacement and contact force of every node. */
#include "contact.h"
#include "problem.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_direct.h>

#include <ctime>
#include <iomanip>
#include <iostream>

using namespace dealii;
constexpr int dim = 2;
constexpr int MOST = 14; /* solves of a load step */

static double seconds() { return double(std::clock()) / CLOCKS_PER_SEC; } /* of the processor */

static void make_mesh(const Problem &problem, Triangulation<dim> &mesh) {
  std::vector<Point<dim>> points;
  for (const auto &x : problem.nodes) points.emplace_back(x[0], x[1]);
  std::vector<CellData<dim>> cells;
  for (const auto &row : problem.cells) {
    CellData<dim> cell;
    const unsigned order[4] = {1, 2, 4, 3};
    for (unsigned v = 0; v < 4; ++v) cell.vertices[v] = static_cast<unsigned>(row[order[v]]);
    cell.material_id = static_cast<types::material_id>(row[0]);
    cells.push_back(cell);
  }
  GridTools::consistently_order_cells(cells);
  mesh.create_triangulation(points, cells, SubCellData());
}

class Press {
 public:
  explicit Press(const Problem &problem)
      : problem_(problem), fe_(FE_Q<dim>(1), dim), handler_((make_mesh(problem, mesh_), mesh_)), options_(problem.stiffness) {
    handler_.distribute_dofs(fe_);
    dof_.resize(dim * mesh_.n_vertices());
    for (const auto &cell : handler_.active_cell_iterators())
      for (const auto v : cell->vertex_indices())
        for (unsigned axis = 0; axis < dim; ++axis) dof_[dim * cell->vertex_index(v) + axis] = cell->vertex_dof_index(v, axis);
    options_.law = problem.law, options_.estimator = FMC_ESTIMATOR_EXACT;
    contact_ = std::make_unique<Contact<dim>>(handler_, options_);
    for (const auto &row : problem.half_spaces) {
      const std::vector<double> point(row.begin(), row.begin() + dim), normal(row.begin() + dim, row.end());
      contact_->context().add_half_space(fmc::Pose::along(point, normal));
    }
    u_.reinit(handler_.n_dofs());
  }

  double contact_seconds() const { return in_contact_; }

  /* To the end of the load; the number of linear solves. The first touch is that of a soft contact, which is then made stiff. */
  unsigned run() {
    double done = 0, step = 1. / 64, soft = 1e-4;
    unsigned solves = 0;
    while (done < 1 || soft < 1) {
      const auto to = soft < 1 && done > 0 ? done : std::min(done + step, 1.);
      const auto before = u_;
      options_.stiffness = soft * problem_.stiffness;
      contact_->context().set_options(options_);
      const auto taken = solve(done, to);
      solves += std::abs(taken);
      if (taken > 0) {
        std::cout << "load " << to << ", stiffness " << options_.stiffness << ": " << taken << " solves" << std::endl;
        if (soft < 1) soft = std::min(4 * soft, 1.);
        else step = std::min(2 * step, 0.125);
        done = to;
      } else {
        u_ = before, step /= 2;
        if (step < 1e-6) throw std::runtime_error("no equilibrium");
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
      for (const auto &row : problem_.held) {
        const auto dof = dof_[dim * static_cast<std::size_t>(row[0]) + static_cast<std::size_t>(row[1])];
        held.add_line(dof);
        held.set_inhomogeneity(dof, solves == 0 ? (to - from) * row[2] : 0);
      }
      held.close();
      auto left = residual;
      held.set_zero(left);
      if (!std::isfinite(left.l2_norm())) return -solves - 1;
      const double rounding = 1e-15 * matrix.linfty_norm() * u_.l2_norm();
      if (solves > 0 && left.l2_norm() <= std::max(1e-11 * size, rounding)) return solves;
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
