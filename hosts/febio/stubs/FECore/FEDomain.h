// Of FEBio 4, what the plugin uses of its FEDomain.h and of what that includes: elements with their shapes and nodes.
#pragma once
#include "FEMesh.h"

enum FE_Element_Class { FE_ELEM_INVALID_CLASS, FE_ELEM_SOLID, FE_ELEM_SHELL };
enum FE_Element_Shape {
  ET_TET4, ET_TET5, ET_TET10, ET_TET15, ET_TET20, ET_PENTA6, ET_PENTA15, ET_HEX8, ET_HEX20, ET_HEX27, ET_PYRA5, ET_PYRA13, ET_QUAD4
};

class FEElement {
 public:
  FEElement(int id, FE_Element_Class eclass, FE_Element_Shape shape, std::vector<int> node)
      : m_node(std::move(node)), m_id(id), m_class(eclass), m_shape(shape) {}
  int GetID() const { return m_id; }
  int Class() const { return m_class; }
  int Shape() const { return m_shape; }
  std::vector<int> m_node;

 private:
  int m_id, m_class, m_shape;
};

class FEDomain {
 public:
  virtual ~FEDomain() {}
  virtual int Elements() const { return static_cast<int>(m_Elem.size()); }
  virtual FEElement &ElementRef(int i) { return m_Elem[static_cast<std::size_t>(i)]; }
  std::vector<FEElement> m_Elem;
};
