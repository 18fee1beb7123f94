// Of FEBio 4, what the plugin uses of its FELinearSystem.h and of what that includes: element matrices, and the pattern of the global one.
#pragma once
#include <set>
#include <utility>
#include <vector>

class matrix {
 public:
  matrix(int nr, int nc) : m_nc(nc), m_d(static_cast<std::size_t>(nr * nc), 7) {}
  double *operator[](int l) { return &m_d[static_cast<std::size_t>(l * m_nc)]; }
  const double *operator[](int l) const { return &m_d[static_cast<std::size_t>(l * m_nc)]; }
  void zero() { m_d.assign(m_d.size(), 0); }

 private:
  int m_nc;
  std::vector<double> m_d;
};

class FEElementMatrix : public matrix {
 public:
  FEElementMatrix(int nr, int nc) : matrix(nr, nc) {}
  void SetIndices(const std::vector<int> &lm) { m_lm = lm; }
  const std::vector<int> &RowIndices() const { return m_lm; }
  void SetNodes(const std::vector<int> &en) { m_node = en; }
  const std::vector<int> &Nodes() const { return m_node; }

 private:
  std::vector<int> m_lm, m_node;
};

class FEGlobalMatrix {
 public:
  void build_add(std::vector<int> &lm) {
    for (const int i : lm)
      for (const int j : lm)
        if (i != -1 && j != -1) m_pattern.insert({i < -1 ? -i - 2 : i, j < -1 ? -j - 2 : j});
  }
  std::set<std::pair<int, int>> m_pattern;
};

class FELinearSystem {
 public:
  explicit FELinearSystem(bool bsymm) : m_bsymm(bsymm) {}
  virtual ~FELinearSystem() {}
  bool IsSymmetric() const { return m_bsymm; }
  virtual void Assemble(const FEElementMatrix &ke) = 0;

 private:
  bool m_bsymm;
};
