// A tetrahedron is lowered, tip first, into a cube: a mixed mesh in a context, which finds the facets once and then
// evaluates the forces at every position.
//
//   c++ -std=c++17 approach.cpp $(pkg-config --cflags --libs fmc_contact)
#include <fmc_contact.hpp>

#include <cmath>
#include <cstdio>

int main() try {
  // 1. Two bodies: a unit cube with its top at z = 1, and a tetrahedron whose tip hangs above the middle of it.
  std::vector<std::array<double, 3>> coords = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1},
                                               {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 1.05}, {0.2, 0.3, 2}, {0.9, 0.3, 2},
                                               {0.5, 0.9, 2}};
  const std::vector<int32_t> hexes = {0, 1, 2, 3, 4, 5, 6, 7}, tets = {8, 9, 11, 10};

  // 2. The context, which gives itself back.
  fmc::Options options(1e6);
  options.law = FMC_LAW_VOLUME;
  options.estimator = FMC_ESTIMATOR_EXACT;
  fmc::Context contact(3, coords, {{FMC_HEX8, hexes}, {FMC_TET4, tets}}, options);

  // 3. Lower the tetrahedron and look at the force on it.
  std::vector<std::array<double, 3>> forces(coords.size());
  for (int step = 0; step < 5; step++) {
    const fmc_result result = contact.evaluate(coords, forces);
    const fmc_resultant cube = contact.body(0), tetrahedron = contact.body(1);
    std::printf("tip at %5.2f  volume %.6f  area %.4f  force %8.2f\n", coords[8][2], result.volume, result.contact_area,
                tetrahedron.force[2] + 0.0);

    // 4. Check: action is reaction, and the overlap is a cone over its cut at z = 1, one third of area times depth.
    const double depth = std::fmax(0.0, 1 - coords[8][2]), base = 0.21 * std::pow(depth / 0.95, 2);
    const double scale = std::fmax(1.0, std::fabs(tetrahedron.force[2]));
    const double imbalance = std::fabs(cube.force[2] + tetrahedron.force[2]);
    if (imbalance > 1e-12 * scale) throw std::logic_error("forces do not balance");
    if (std::fabs(result.volume - base * depth / 3) > 1e-12) throw std::logic_error("the volume is wrong");
    for (std::size_t node = 8; node < coords.size(); node++) coords[node][2] -= 0.05;
  }
  return 0;
} catch (const std::exception &error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
