/* Bodies that press each other, in deal.II: press PROBLEM SOLUTION, with a table as problem.h says. Every load step that is given by the
 * library's search. Cells may be refined: nodes hang. The solution has a line of linear solves, seconds of the processor and those in
 * contact, then displacement and contact force of every node. */
#include "mesh.h"
#include "search.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>

#include <ctime>
#include <iomanip>
#include <iostream>

using namespace dealii;

class Press {
 public:
  explicit Press(const Problem &problem)
      : problem_(problem), fe_(FE_Q<dim>(1), dim), handler_((make_mesh(problem, mesh_), mesh_)), options_(problem.stiffness) {
    handler_.distribute_dofs(fe_);
    DoFTools::make_hanging_node_constraints(handler_, hanging_);
    hanging_.close();
    options_.law = problem.law, options_.estimator = FMC_ESTIMATOR_EXACT;
    options_.friction_coefficient = problem.friction;
    contact_ = std::make_unique<Contact<dim>>(handler_, options_, hanging_);
    for (const auto &row : problem.half_spaces) {
      const std::vector<double> point(row.begin(), row.begin() + dim), normal(row.begin() + dim, row.end());
      contact_->context().add_half_space(fmc::Pose::along(point, normal));
    }
    u_.reinit(handler_.n_dofs());
  }

  struct Taken {
    std::size_t solves = 0;
    double seconds = 0, in_contact = 0; /* of the processor */
  };

  /* To the end of the load. */
  Taken run() {
    const auto begun = std::clock();
    Taken taken;
    const auto bodies = [this](const auto &u, auto &forces, auto *matrix) { add_bodies(u, forces, matrix); };
    Search<dim> search(handler_, hanging_, *contact_, bodies);
    fmc::EquilibriumOptions options;
    options.tolerance = 1e-10, options.find_patches = problem_.law == FMC_LAW_FIBER;
    for (std::size_t step = 1; step <= problem_.steps; ++step) {
      if (problem_.friction > 0) contact_->context().begin_step(contact_->moved(u_));
      std::map<types::global_dof_index, double> prescribed;
      for (const auto &row : problem_.held) prescribed[dof(row)] = row.at(1 + step);
      const auto found = search.run(u_, prescribed, options);
      if (problem_.friction > 0) contact_->context().commit_step(contact_->moved(u_));
      std::cout << "load " << step << ": " << found.counts.solve_count << " solves in " << found.counts.part_count << " parts" << std::endl;
      for (const auto &text : found.texts) std::cout << text << std::endl;
      taken.solves += found.counts.solve_count;
    }
    taken.seconds = double(std::clock() - begun) / CLOCKS_PER_SEC, taken.in_contact = taken.seconds - search.host_seconds();
    return taken;
  }

  void write(std::ostream &out) {
    Vector<double> force(u_.size());
    contact_->add_forces(u_, force);
    const auto &dofs = contact_->dofs();
    for (std::size_t k = 0; k < dofs.size(); k += dim)
      out << u_(dofs[k]) << ' ' << u_(dofs[k + 1]) << ' ' << force(dofs[k]) << ' ' << force(dofs[k + 1]) << '\n';
  }

 private:
  types::global_dof_index dof(const Problem::Row &held) const {
    return contact_->dofs()[dim * static_cast<std::size_t>(held[0]) + static_cast<std::size_t>(held[1])];
  }

  /* The bodies' forces and, unless it is null, stiffness. */
  void add_bodies(const Vector<double> &u, Vector<double> &inside, SparseMatrix<double> *matrix) const {
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
      values[displacement].get_function_gradients(u, gradients);
      const auto &material = problem_.materials[cell->material_id()];
      stiffness = 0, force = 0;
      for (const auto q : values.quadrature_point_indices()) {
        const auto h = in_space(gradients[q]);
        const auto stress = material.stress(h) * values.JxW(q);
        for (const auto j : values.dof_indices()) {
          force(j) += scalar_product(stress, in_space(values[displacement].gradient(j, q)));
          if (!matrix) continue;
          const auto change = material.change(h, in_space(values[displacement].gradient(j, q))) * values.JxW(q);
          for (const auto i : values.dof_indices())
            stiffness(i, j) += scalar_product(change, in_space(values[displacement].gradient(i, q)));
        }
      }
      cell->get_dof_indices(dofs);
      if (matrix) matrix->add(dofs, stiffness);
      inside.add(dofs, force);
    }
  }

  const Problem &problem_;
  Triangulation<dim> mesh_;
  FESystem<dim> fe_;
  DoFHandler<dim> handler_;
  AffineConstraints<double> hanging_;
  fmc::Options options_;
  std::unique_ptr<Contact<dim>> contact_;
  Vector<double> u_;
};

int main(int count, char **given) try {
  if (count != 3) throw std::runtime_error("press PROBLEM SOLUTION");
  const Problem problem(given[1]);
  Press press(problem);
  const auto taken = press.run();
  std::ofstream out(given[2]);
  out << std::setprecision(17) << taken.solves << ' ' << taken.seconds << ' ' << taken.in_contact << '\n';
  press.write(out);
} catch (const std::exception &error) {
  std::cerr << error.what() << std::endl;
  return 1;
}
