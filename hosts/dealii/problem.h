/* Bodies of quadrilaterals as a table of numbers, which fmc_agreement (quadrilaterals.py) writes:
 *
 *   nodes N         x y
 *   cells M         body, then four nodes around
 *   held H          node, axis, displacement at the end
 *   materials B     1 for linear elastic or 0 for neo-Hookean, Lame's lambda, shear and bulk modulus
 *   contact 1       fmc_law, stiffness
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
  std::vector<Row> nodes, cells, held, half_spaces;
  std::vector<Material> materials;
  int law;
  double stiffness;

  explicit Problem(const std::string &path) {
    std::ifstream file(path);
    nodes = table(file, "nodes", 2), cells = table(file, "cells", 5), held = table(file, "held", 3);
    for (const auto &row : table(file, "materials", 4)) materials.push_back({row[0] != 0, row[1], row[2], row[3]});
    const auto contact = table(file, "contact", 2);
    law = static_cast<int>(contact.at(0)[0]), stiffness = contact.at(0)[1];
    half_spaces = table(file, "half_spaces", 4);
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
