// The equilibrium of a block that lies on another, which a floor holds up: squares of the host's own, linear elastic, in plane strain.
// Nothing holds the blocks but contact and one support sideways, they begin with gaps, and no stiffness is chosen.
//
//   c++ -std=c++17 equilibrium.cpp $(pkg-config --cflags --libs fmc_contact)
#include <fmc_contact.hpp>

#include <cstdio>

namespace {

constexpr double young = 1e6, poisson = 0.3, weight = -10;  // Of each node along y.

// Stiffness of a square, 8 x 8, integrated at four points.
std::array<double, 64> square() {
  const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson)), mu = young / (2 * (1 + poisson)), at = 1 / std::sqrt(3.0);
  const double signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::array<double, 64> k{};
  for (const auto &point : signs) {
    double g[4][2];
    for (int a = 0; a < 4; a++) {
      g[a][0] = signs[a][0] * (1 + signs[a][1] * at * point[1]) / 2;
      g[a][1] = signs[a][1] * (1 + signs[a][0] * at * point[0]) / 2;
    }
    for (int a = 0; a < 4; a++)
      for (int b = 0; b < 4; b++)
        for (int i = 0; i < 2; i++)
          for (int j = 0; j < 2; j++) {
            const double dot = i == j ? g[a][0] * g[b][0] + g[a][1] * g[b][1] : 0;
            k[static_cast<std::size_t>((2 * a + i) * 8 + 2 * b + j)] += (lambda * g[a][i] * g[b][j] + mu * (g[a][j] * g[b][i] + dot)) / 4;
          }
  }
  return k;
}

}  // namespace

int main() try {
  // 1. Two blocks of 3 x 3 and 2 x 2 squares of edge 1.
  std::vector<std::array<double, 2>> nodes;
  std::vector<int32_t> conn;
  const auto add_block = [&](int n, double x, double y) {
    const auto first = static_cast<int32_t>(nodes.size());
    for (int j = 0; j <= n; j++)
      for (int i = 0; i <= n; i++) nodes.push_back({x + i, y + j});
    for (int j = 0; j < n; j++)
      for (int i = 0; i < n; i++)
        for (const int32_t node : {j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1, (j + 1) * (n + 1) + i}) conn.push_back(first + node);
  };
  add_block(3, 0, 0.02);
  add_block(2, 0.4, 3.05);

  // 2. The contact, a floor.
  fmc::Context contact(2, nodes, {{FMC_QUAD4, conn}}, fmc::Options());
  contact.add_half_space(fmc::Pose::along({0.0, 0.0}, {0.0, 1.0}));

  // 3. The bodies: internal less external forces at displacements u, and the matrix.
  const auto k = square();
  const fmc::Bodies bodies = [&](fmc::View<const double> u, double *forces, fmc::Csr<int64_t> *matrix) {
    std::vector<std::vector<std::pair<std::size_t, double>>> rows(u.size());
    for (std::size_t cell = 0; cell < conn.size(); cell += 4)
      for (std::size_t a = 0; a < 8; a++)
        for (std::size_t b = 0; b < 8; b++) {
          const auto row = 2 * static_cast<std::size_t>(conn[cell + a / 2]) + a % 2, col = 2 * static_cast<std::size_t>(conn[cell + b / 2]) + b % 2;
          forces[row] += k[8 * a + b] * u[col];
          rows[row].emplace_back(col, k[8 * a + b]);
        }
    for (std::size_t row = 1; row < u.size(); row += 2) forces[row] -= weight;
    if (matrix == nullptr) return true;
    matrix->row_offsets = {0};
    for (const auto &row : rows) {
      for (const auto &[col, value] : row) matrix->cols.push_back(static_cast<int64_t>(col)), matrix->values.push_back(value);
      matrix->row_offsets.push_back(static_cast<int64_t>(matrix->cols.size()));
    }
    return true;
  };

  // 4. The unknowns are displacements; one of each block is held sideways.
  std::vector<double> u(2 * nodes.size());
  std::vector<uint8_t> free(u.size(), 1);
  free[0] = free[2 * 16] = 0;
  const fmc::Equilibrium found = fmc::find_equilibrium(contact, {{}, nodes, free, u, {}}, bodies);
  for (const auto &text : found.texts) std::puts(text.c_str());
  if (found.way == FMC_WAY_NONE) return 1;

  // 5. Check: the floor bears both blocks, the lower one the upper.
  for (std::size_t n = 0; n < nodes.size(); n++)
    for (std::size_t axis = 0; axis < 2; axis++) nodes[n][axis] += found.x[2 * n + axis];
  contact.evaluate(nodes);
  const double floor = -contact.obstacle(0).force[1], upper = contact.body(1).force[1];
  std::printf("%zu linear solves; the floor bears %.6f of 250, the upper block is borne by %.6f of 90\n", found.counts.solve_count, floor, upper);
  if (std::fabs(floor - 250) > 1e-5 || std::fabs(upper - 90) > 1e-5) throw std::logic_error("weights are not borne");
  return 0;
} catch (const std::exception &error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
