// Of FEBio 4, what the plugin uses of its FEMesh.h and of what that includes: nodes with their equations.
#pragma once
#include "FECoreBase.h"

class FEDomain;

class FENode {
 public:
  vec3d m_r0, m_rt, m_rp;  // Undeformed, now, and at the end of the last step.
  // Equation of each degree of freedom: -1 for one that is fixed, -n - 2 for one that is prescribed and has the number n.
  std::vector<int> m_ID;
};

class FEMesh {
 public:
  int Nodes() const { return static_cast<int>(m_Node.size()); }
  FENode &Node(int i) { return m_Node[static_cast<std::size_t>(i)]; }
  int Domains() { return static_cast<int>(m_Domain.size()); }
  FEDomain &Domain(int n) { return *m_Domain[static_cast<std::size_t>(n)]; }

  std::vector<FENode> m_Node;
  std::vector<FEDomain *> m_Domain;
};
