/* The mesh of a problem, with the cells divided that it names. */
#ifndef FMC_DEALII_MESH_H
#define FMC_DEALII_MESH_H

#include "problem.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

constexpr int dim = 2;

inline void make_mesh(const Problem &problem, dealii::Triangulation<dim> &mesh) {
  std::vector<dealii::Point<dim>> points;
  for (const auto &x : problem.nodes) points.emplace_back(x[0], x[1]);
  std::vector<dealii::CellData<dim>> cells;
  for (const auto &row : problem.cells) {
    dealii::CellData<dim> cell;
    const unsigned order[4] = {1, 2, 4, 3};
    for (unsigned v = 0; v < 4; ++v) cell.vertices[v] = static_cast<unsigned>(row[order[v]]);
    cell.material_id = static_cast<dealii::types::material_id>(row[0]);
    cells.push_back(cell);
  }
  dealii::GridTools::consistently_order_cells(cells);
  mesh.create_triangulation(points, cells, dealii::SubCellData());
  for (const auto &row : problem.refined)
    dealii::Triangulation<dim>::active_cell_iterator(&mesh, 0, static_cast<int>(row[0]))->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
}

#endif
