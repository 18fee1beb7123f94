// Of FEBio 4, what the plugin uses of its FEGlobalVector.h: forces on nodes, added up by equation; those on prescribed unknowns are reactions.
#pragma once
#include <vector>

class FEGlobalVector {
 public:
  FEGlobalVector(std::vector<double> &R, std::vector<double> &Fr) : m_R(R), m_Fr(Fr) {}
  virtual ~FEGlobalVector() {}
  virtual void Assemble(std::vector<int> &, std::vector<int> &elm, std::vector<double> &fe, bool = false) {
    for (std::size_t i = 0; i < fe.size(); ++i) {
      if (elm[i] >= 0) m_R[static_cast<std::size_t>(elm[i])] += fe[i];
      if (elm[i] < -1) m_Fr[static_cast<std::size_t>(-elm[i] - 2)] -= fe[i];
    }
  }

 private:
  std::vector<double> &m_R, &m_Fr;
};
