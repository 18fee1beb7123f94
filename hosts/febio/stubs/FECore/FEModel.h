// Of FEBio 4, what the plugin uses of its FEModel.h and of what that includes: the mesh, callbacks, names of degrees of freedom, the log.
#pragma once
#include "FEMesh.h"

#include <cstdarg>
#include <cstdio>

#define CB_MAJOR_ITERS 0x00000004

typedef bool (*FECORE_CB_FNC)(FEModel *, unsigned int, void *);

class FEModel {
 public:
  FEMesh &GetMesh() { return m_mesh; }
  int GetDOFIndex(const char *sz) const {
    const std::string name(sz);
    return name == "x" ? 0 : name == "y" ? 1 : name == "z" ? 2 : -1;
  }
  void AddCallback(FECORE_CB_FNC pcb, unsigned int nwhen, void *pd) { m_callbacks.push_back({pcb, nwhen, pd}); }
  bool DoCallback(unsigned int nevent) {
    for (const auto &callback : m_callbacks)
      if ((callback.nwhen & nevent) != 0 && !callback.pcb(this, nevent, callback.pd)) return false;
    return true;
  }
  void Logf(int ntag, const char *msg, ...) {
    char text[512];
    va_list rest;
    va_start(rest, msg);
    std::vsnprintf(text, sizeof text, msg, rest);
    va_end(rest);
    (ntag == 0 ? m_log : m_errors) += text;
  }

  FEMesh m_mesh;
  std::string m_log, m_errors;

 private:
  struct Callback {
    FECORE_CB_FNC pcb;
    unsigned int nwhen;
    void *pd;
  };
  std::vector<Callback> m_callbacks;
};
