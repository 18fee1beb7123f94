/* Contact of all bodies of a DoFHandler with linear elements (FE_Q(1) or, of simplices, FE_SimplexP(1), as often as there are axes):
 * forces for the right-hand side, the tangent for the matrix. Nodes that hang follow those that hold them: what comes is already condensed. */
#ifndef FMC_DEALII_CONTACT_H
#define FMC_DEALII_CONTACT_H

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>
#include <fmc_contact.hpp>

#include <map>

template <int dim>
class Contact {
 public:
  /* Bodies are the material ids of the cells. `hanging`: as make_hanging_node_constraints finds them, and closed. */
  Contact(const dealii::DoFHandler<dim> &handler, const fmc::Options &options, const dealii::AffineConstraints<double> &hanging = {})
      : dofs_(dofs_of_vertices(handler)), start_(coordinates(handler)), context_(create(handler, start_, options)) {
    follow(hanging);
  }

  /* Obstacles, friction, results. */
  fmc::Context &context() { return context_; }

  /* Adds the contact forces at the displacement u to a vector. */
  fmc_result add_forces(const dealii::Vector<double> &u, dealii::Vector<double> &forces) {
    std::vector<double> found(start_.size());
    const auto result = context_.evaluate(moved(u), found);
    for (std::size_t k = 0; k < found.size(); ++k) forces(dofs_[k]) += found[k];
    return result;
  }

  /* Finds the tangent, which the other two hand out: its places first, since contact comes and goes. */
  void find_tangent(const dealii::Vector<double> &u, uint32_t flags = 0) {
    context_.find_tangent(moved(u), flags);
    tangent_ = context_.tangent_entries();
  }
  void add_places(dealii::DynamicSparsityPattern &pattern) const {
    for_each([&](auto row, auto col, double) { pattern.add(row, col); });
  }
  void add_tangent(dealii::SparseMatrix<double> &matrix) const {
    for_each([&](auto row, auto col, double value) { matrix.add(row, col, value); });
  }

  /* Degree of freedom of every vertex and axis, and where vertices are without displacement. */
  const std::vector<dealii::types::global_dof_index> &dofs() const { return dofs_; }
  const std::vector<double> &start() const { return start_; }

  /* Coordinates at a displacement, for whatever else the context is asked. */
  std::vector<double> moved(const dealii::Vector<double> &u) const {
    auto x = start_;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += u(dofs_[k]);
    return x;
  }

 private:
  static std::vector<dealii::types::global_dof_index> dofs_of_vertices(const dealii::DoFHandler<dim> &handler) {
    std::vector<dealii::types::global_dof_index> dofs(dim * handler.get_triangulation().n_vertices());
    for (const auto &cell : handler.active_cell_iterators())
      for (const auto v : cell->vertex_indices())
        for (int axis = 0; axis < dim; ++axis) dofs[dim * cell->vertex_index(v) + axis] = cell->vertex_dof_index(v, axis);
    return dofs;
  }

  static std::vector<double> coordinates(const dealii::DoFHandler<dim> &handler) {
    std::vector<double> x;
    for (const auto &vertex : handler.get_triangulation().get_vertices())
      for (int axis = 0; axis < dim; ++axis) x.push_back(vertex[axis]);
    return x;
  }

  /* Vertices that hang lie between those that hold them. */
  void follow(const dealii::AffineConstraints<double> &hanging) {
    if (hanging.n_constraints() == 0) return;
    std::map<dealii::types::global_dof_index, int32_t> vertex_of;
    for (std::size_t k = 0; k < dofs_.size(); k += dim) vertex_of[dofs_[k]] = static_cast<int32_t>(k / dim);
    std::vector<int32_t> offsets{0}, cols;
    std::vector<double> weights;
    for (std::size_t k = 0; k < dofs_.size(); k += dim) {
      if (const auto *holders = hanging.get_constraint_entries(dofs_[k]))
        for (const auto &[dof, weight] : *holders) cols.push_back(vertex_of.at(dof)), weights.push_back(weight);
      else cols.push_back(static_cast<int32_t>(k / dim)), weights.push_back(1);
      offsets.push_back(static_cast<int32_t>(cols.size()));
    }
    context_.set_basis(fmc::CsrView<int32_t>{offsets, cols, weights}, dofs_.size() / dim);
  }

  /* Quadrilaterals and hexahedra go row by row in deal.II, around in the library. */
  static fmc::Context create(const dealii::DoFHandler<dim> &handler, const std::vector<double> &x, const fmc::Options &options) {
    const unsigned around[8] = {0, 1, 3, 2, 4, 5, 7, 6};
    std::vector<int32_t> conn, bodies;
    bool simplices = false;
    for (const auto &cell : handler.active_cell_iterators()) {
      simplices = cell->reference_cell().is_simplex();
      bodies.push_back(static_cast<int32_t>(cell->material_id()));
      for (const auto v : cell->vertex_indices())
        conn.push_back(static_cast<int32_t>(cell->vertex_index(simplices ? v : around[v])));
    }
    const auto type = dim == 2 ? (simplices ? FMC_TRI3 : FMC_QUAD4) : (simplices ? FMC_TET4 : FMC_HEX8);
    return fmc::Context(dim, x, {{type, conn}}, options, bodies);
  }

  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t e = 0; e < tangent_.values.size(); ++e) {
      const auto row = static_cast<std::size_t>(tangent_.rows[e]), col = static_cast<std::size_t>(tangent_.cols[e]);
      /* What comes after the nodes are the obstacles. */
      if (row < dofs_.size() && col < dofs_.size()) visit(dofs_[row], dofs_[col], tangent_.values[e]);
    }
  }

  std::vector<dealii::types::global_dof_index> dofs_;
  std::vector<double> start_;
  fmc::Context context_;
  fmc::Entries tangent_;
};

#endif
