/* Bodies of quadrilaterals as a table of numbers, which fmc_agreement (quadrilaterals.py) writes:
 *
 *   nodes N         x y
 *   cells M         body, then four nodes around
 *   refined R       number of a cell that is divided into four, so that nodes hang where its neighbour is not
 *   steps 1         number of load steps that are given
 *   held H          node, axis, displacement at the end of each load step
 *   materials B     1 for linear elastic or 0 for neo-Hookean, Lame's lambda, shear and bulk modulus
 *   contact 1       fmc_law, stiffness, coefficient of friction
 *   half_spaces K   a point and the outward normal */
#ifndef FMC_DEALII_PROBLEM_H
#define FMC_DEALII_PROBLEM_H

#include "material.h"

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

struct Problem {
  using Row = std::vector<double>;
  std::vector<Row> nodes, cells, refined, held, half_spaces;
  std::vector<Material> materials;
  int law;
  double stiffness, friction;
  std::size_t steps;

  explicit Problem(const std::string &path) {
    std::ifstream file(path);
    nodes = table(file, "nodes", 2), cells = table(file, "cells", 5), refined = table(file, "refined", 1);
    steps = static_cast<std::size_t>(table(file, "steps", 1).at(0)[0]);
    held = table(file, "held", 2 + steps);
    for (const auto &row : table(file, "materials", 4)) materials.push_back({row[0] != 0, row[1], row[2], row[3]});
    const auto contact = table(file, "contact", 3).at(0);
    law = static_cast<int>(contact[0]), stiffness = contact[1], friction = contact[2];
    half_spaces = table(file, "half_spaces", 4);
  }

  /* What a row of `held` prescribes when so many load steps are done, between whole ones in proportion. */
  double prescribed(const Row &row, double done) const {
    const auto at = [&](double step) { return step < 1 ? 0 : row.at(1 + static_cast<std::size_t>(step)); };
    const double before = std::floor(done), after = std::ceil(done);
    return at(before) + (done - before) * (at(after) - at(before));
  }

 private:
  static std::vector<Row> table(std::ifstream &file, const std::string &name, std::size_t width) {
    std::string found;
    std::size_t count = 0;
    if (!(file >> found >> count) || found != name) throw std::runtime_error("no table of " + name);
    std::vector<Row> rows(count, Row(width));
    for (auto &row : rows)
      for (auto &number : row)
        if (!(file >> number)) throw std::runtime_error("the table of " + name + " ends too soon");
    return rows;
  }
};

#endif
