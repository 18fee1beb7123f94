// A small host of the plugin, in place of FEBio: two blocks of springs between the nodes of hexahedra, and Newton's method on them.
#ifndef SPRINGS_H
#define SPRINGS_H

#include <FECore/FECoreKernel.h>
#include <FECore/FEDomain.h>
#include <FECore/FELinearSystem.h>
#include <FECore/FENLConstraint.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>

constexpr double spring = 1e5;  // Force by length of each.

class LinearSystem : public FELinearSystem {
 public:
  using FELinearSystem::FELinearSystem;
  void Assemble(const FEElementMatrix &ke) override {
    // FEBio takes it for that of a rigid connector if it names no nodes, and for three unknowns of each if it does.
    complete = complete && 3 * ke.Nodes().size() == ke.RowIndices().size();
    for (std::size_t i = 0; i < ke.RowIndices().size(); ++i)
      for (std::size_t j = 0; j < ke.RowIndices().size(); ++j)
        entries[{ke.RowIndices()[i], ke.RowIndices()[j]}] += ke[static_cast<int>(i)][static_cast<int>(j)];
  }
  std::map<std::pair<int, int>, double> entries;
  bool complete = true;
};

class Springs {
 public:
  FEModel model;
  FEDomain domain;
  int equation_count = 0, prescribed_count = 0;

  // `count` cubes along each edge, `size` long in all.
  void add_block(int count, double size, std::array<double, 3> at) {
    const int first = model.m_mesh.Nodes(), rows = count + 1;
    for (int k = 0; k < rows * rows * rows; ++k) {
      const std::array<int, 3> step = {k % rows, k / rows % rows, k / rows / rows};
      FENode node;
      node.m_r0 = vec3d(at[0] + size * step[0] / count, at[1] + size * step[1] / count, at[2] + size * step[2] / count);
      node.m_rt = node.m_rp = node.m_r0;
      model.m_mesh.m_Node.push_back(node);
    }
    for (int k = 0; k < count * count * count; ++k) {
      const int corner = first + k % count + rows * (k / count % count + rows * (k / count / count)), up = rows * rows;
      std::vector<int> cell = {corner, corner + 1, corner + 1 + rows, corner + rows};
      for (int n = 0; n < 4; ++n) cell.push_back(cell[static_cast<std::size_t>(n)] + up);
      for (const int a : cell)
        for (const int b : cell)
          if (a < b) ends[{a, b}] += spring;
      domain.m_Elem.emplace_back(static_cast<int>(domain.m_Elem.size()) + 1, FE_ELEM_SOLID, ET_HEX8, cell);
    }
  }

  // Nodes on the floor do not slide, those on top are moved; all others are free.
  void number(double top) {
    model.m_mesh.m_Domain = {&domain};
    for (FENode &node : model.m_mesh.m_Node) {
      if (node.m_r0.z > top - 1e-9)
        node.m_ID = {-prescribed_count - 2, -prescribed_count - 3, -prescribed_count - 4}, prescribed_count += 3;
      else if (node.m_r0.z < 1e-9)
        node.m_ID = {-1, -1, equation_count++};
      else
        node.m_ID = {equation_count, equation_count + 1, equation_count + 2}, equation_count += 3;
    }
  }

  static double &component(vec3d &v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

  // Where the unknowns of equations are.
  std::vector<double *> unknowns() {
    std::vector<double *> found(static_cast<std::size_t>(equation_count));
    for (FENode &node : model.m_mesh.m_Node)
      for (int axis = 0; axis < 3; ++axis)
        if (node.m_ID[static_cast<std::size_t>(axis)] >= 0)
          found[static_cast<std::size_t>(node.m_ID[static_cast<std::size_t>(axis)])] = &component(node.m_rt, axis);
    return found;
  }

  // What pushes the nodes, by equation, the springs' forces and those of the constraint; `reactions`: at what is prescribed.
  std::vector<double> residual(FENLConstraint &contact, std::vector<double> &reactions, bool with_springs = true) {
    std::vector<double> R(static_cast<std::size_t>(equation_count));
    reactions.assign(static_cast<std::size_t>(prescribed_count), 0);
    FEGlobalVector vector(R, reactions);
    contact.LoadVector(vector, FETimeInfo());
    if (with_springs) each_spring([&](FENode &a, FENode &b, std::array<double, 3> n, double k) {
      double longer = 0;
      for (int axis = 0; axis < 3; ++axis)
        longer += n[static_cast<std::size_t>(axis)] * (component(b.m_rt, axis) - component(b.m_r0, axis) - component(a.m_rt, axis) + component(a.m_r0, axis));
      std::vector<int> nodes = {0, 1}, lm = a.m_ID;
      lm.insert(lm.end(), b.m_ID.begin(), b.m_ID.end());
      std::vector<double> forces;
      for (const double sign : {k * longer, -k * longer})
        for (const double part : n) forces.push_back(sign * part);
      vector.Assemble(nodes, lm, forces);
    });
    return R;
  }

  LinearSystem stiffness(FENLConstraint &contact, bool is_symmetric, bool with_springs = true) {
    LinearSystem system(is_symmetric);
    contact.StiffnessMatrix(system, FETimeInfo());
    if (with_springs) each_spring([&](FENode &a, FENode &b, std::array<double, 3> n, double k) {
      FEElementMatrix ke(6, 6);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) ke[i][j] = (i / 3 == j / 3 ? k : -k) * n[static_cast<std::size_t>(i % 3)] * n[static_cast<std::size_t>(j % 3)];
      std::vector<int> lm = a.m_ID;
      lm.insert(lm.end(), b.m_ID.begin(), b.m_ID.end());
      ke.SetIndices(lm), ke.SetNodes({0, 1});
      system.Assemble(ke);
    });
    return system;
  }

  // A step of FEBio: the nodes on top are moved, Newton's method, multipliers. Returns the iterations, -1 where they were too many.
  int solve(FENLConstraint &contact, vec3d push, bool is_symmetric) {
    for (FENode &node : model.m_mesh.m_Node) {
      node.m_rp = node.m_rt;
      if (node.m_ID[0] < -1) node.m_rt = vec3d(node.m_rt.x + push.x, node.m_rt.y + push.y, node.m_rt.z + push.z);
    }
    contact.PrepStep();
    std::vector<double> reactions;
    for (int iteration = 0, augmentation = 0; iteration < 200; ++iteration) {
      std::vector<double> R = residual(contact, reactions);
      double largest = 0;
      for (const double r : R) largest = std::fmax(largest, std::fabs(r));
      if (iteration > 0 && largest < 1e-9 && contact.Augment(augmentation++, FETimeInfo())) return iteration;
      const std::vector<double *> x = unknowns();
      const std::vector<double> du = solved(stiffness(contact, is_symmetric).entries, R);
      for (std::size_t k = 0; k < x.size(); ++k) *x[k] += du[k];
    }
    return -1;
  }

 private:
  std::map<std::pair<int, int>, double> ends;

  template <class Visit>
  void each_spring(const Visit &visit) {
    for (const auto &[pair, k] : ends) {
      FENode &a = model.m_mesh.Node(pair.first), &b = model.m_mesh.Node(pair.second);
      const std::array<double, 3> d = {b.m_r0.x - a.m_r0.x, b.m_r0.y - a.m_r0.y, b.m_r0.z - a.m_r0.z};
      const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      visit(a, b, {d[0] / length, d[1] / length, d[2] / length}, k);
    }
  }

  // Gauss's elimination, with pivots.
  static std::vector<double> solved(const std::map<std::pair<int, int>, double> &entries, std::vector<double> b) {
    const std::size_t n = b.size();
    std::vector<std::vector<double>> a(n, std::vector<double>(n));
    for (const auto &[place, value] : entries)
      if (place.first >= 0 && place.second >= 0) a[static_cast<std::size_t>(place.first)][static_cast<std::size_t>(place.second)] = value;
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k; i < n; ++i)
        if (std::fabs(a[i][k]) > std::fabs(a[pivot][k])) pivot = i;
      std::swap(a[k], a[pivot]), std::swap(b[k], b[pivot]);
      for (std::size_t i = k + 1; i < n; ++i) {
        const double factor = a[i][k] / a[k][k];
        for (std::size_t j = k; factor != 0 && j < n; ++j) a[i][j] -= factor * a[k][j];
        b[i] -= factor * b[k];
      }
    }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
      b[k] /= a[k][k];
    }
    return b;
  }
};

#endif
