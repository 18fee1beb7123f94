// An elastic block falls onto another: explicit dynamics with linear triangles of the host's own, in 2D, plane strain. The same
// program as hosts/c/impact.c, with the same history.
//
//   c++ -std=c++17 -ffp-contract=off impact.cpp $(pkg-config --cflags --libs fmc_contact)
#include <fmc_contact.hpp>

#include <cstdio>

namespace {

using Point = std::array<double, 2>;

constexpr double young = 1e6, poisson = 0.3, density = 1000, stiffness = 1e8, dt = 1e-4;
constexpr int steps = 400;

struct Mesh {
  std::vector<Point> nodes;
  std::vector<std::array<int32_t, 3>> triangles;

  // Appends the block [x0, x0 + side] x [y0, y0 + side], in n x n squares of two triangles each.
  void add_block(double x0, double y0, double side, int n) {
    const auto first = static_cast<int32_t>(nodes.size());
    for (int j = 0; j <= n; j++)
      for (int i = 0; i <= n; i++) nodes.push_back({x0 + i * side / n, y0 + j * side / n});
    for (int j = 0; j < n; j++)
      for (int i = 0; i < n; i++) {
        const int32_t a = first + j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      }
  }
  const Point &node(std::size_t triangle, std::size_t k) const { return nodes[index(triangle, k)]; }
  std::size_t index(std::size_t triangle, std::size_t k) const { return static_cast<std::size_t>(triangles[triangle][k % 3]); }

  // Twice the area of a triangle without deformation.
  double twice_area(std::size_t t) const {
    const Point &p = node(t, 0), &q = node(t, 1), &r = node(t, 2);
    return (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
  }
  std::vector<double> lumped_masses() const {
    std::vector<double> mass(nodes.size());
    for (std::size_t t = 0; t < triangles.size(); t++)
      for (std::size_t k = 0; k < 3; k++) mass[index(t, k)] += density * (twice_area(t) / 2) / 3;
    return mass;
  }
  // The elastic forces of all triangles: constant strain, small displacements.
  std::vector<Point> internal_forces(const std::vector<Point> &x) const {
    std::vector<Point> force(x.size());
    const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson)), mu = young / (2 * (1 + poisson));
    for (std::size_t t = 0; t < triangles.size(); t++) {
      const double area2 = twice_area(t);
      double bx[3], by[3], exx = 0, eyy = 0, gxy = 0;
      for (std::size_t k = 0; k < 3; k++) {
        const Point &next = node(t, k + 1), &last = node(t, k + 2);
        bx[k] = (next[1] - last[1]) / area2;
        by[k] = (last[0] - next[0]) / area2;
        const double ux = x[index(t, k)][0] - node(t, k)[0], uy = x[index(t, k)][1] - node(t, k)[1];
        exx += bx[k] * ux;
        eyy += by[k] * uy;
        gxy += by[k] * ux + bx[k] * uy;
      }
      const double sxx = (lambda + 2 * mu) * exx + lambda * eyy;
      const double syy = lambda * exx + (lambda + 2 * mu) * eyy;
      const double sxy = mu * gxy;
      for (std::size_t k = 0; k < 3; k++) {
        force[index(t, k)][0] -= area2 / 2 * (sxx * bx[k] + sxy * by[k]);
        force[index(t, k)][1] -= area2 / 2 * (sxy * bx[k] + syy * by[k]);
      }
    }
    return force;
  }
};

}  // namespace

int main() try {
  // 1. The lower block, whose bottom row is held, and the upper one, which falls.
  Mesh mesh;
  mesh.add_block(0, 0, 1, 4);
  const std::size_t held = 5, upper = mesh.nodes.size();
  mesh.add_block(0.2, 1.001, 0.6, 3);
  const std::vector<double> mass = mesh.lumped_masses();
  std::vector<Point> x = mesh.nodes, v(x.size()), force(x.size());
  for (std::size_t n = upper; n < x.size(); n++) v[n][1] = -1;

  // 2. The contact, which finds the facets once.
  fmc::Options options(stiffness);
  options.law = FMC_LAW_DEPTH;
  options.estimator = FMC_ESTIMATOR_EXACT;
  fmc::Context contact(2, x, {{FMC_TRI3, mesh.triangles}}, options);

  // 3. Leapfrog; a line of the history every 20 steps.
  for (int step = 0; step <= steps; step++) {
    const fmc_result result = contact.evaluate(x, force);
    if (step % 20 == 0) {
      double momentum = 0, total = 0;
      for (std::size_t n = upper; n < x.size(); n++) {
        momentum += mass[n] * v[n][1];
        total += mass[n];
      }
      std::printf("%6d %23.15e %23.15e %23.15e\n", step, contact.body(1).force[1], momentum / total, result.energy);
    }
    const std::vector<Point> internal = mesh.internal_forces(x);
    for (std::size_t n = held; n < x.size(); n++)
      for (std::size_t axis = 0; axis < 2; axis++) {
        v[n][axis] += dt * (force[n][axis] + internal[n][axis]) / mass[n];
        x[n][axis] += dt * v[n][axis];
      }
  }
  return 0;
} catch (const std::exception &error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
