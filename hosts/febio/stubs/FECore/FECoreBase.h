// Of FEBio 4, what the plugin uses of its FECoreBase.h and of what that includes: parameters with names, and the macros that list them.
#pragma once
#include <map>
#include <string>
#include <vector>

class DumpStream;
class FEModel;

class vec3d {
 public:
  vec3d() : x(0), y(0), z(0) {}
  vec3d(double X, double Y, double Z) : x(X), y(Y), z(Z) {}
  double x, y, z;
};

enum SUPER_CLASS_ID { FEINVALID_ID, FENLCONSTRAINT_ID };

enum FEParamRange { FE_GREATER, FE_GREATER_OR_EQUAL };
struct RANGE {
  FEParamRange m_rt;
  double m_fmin;
};
inline RANGE FE_RANGE_GREATER(double f) { return {FE_GREATER, f}; }
inline RANGE FE_RANGE_GREATER_OR_EQUAL(double f) { return {FE_GREATER_OR_EQUAL, f}; }

class FEParam {
 public:
  void *data;
  std::vector<RANGE> range;
};

class FEParamContainer {
 public:
  virtual ~FEParamContainer() {}
  virtual void Serialize(DumpStream &) {}
  virtual void BuildParamList() {}
  virtual bool Validate() {
    for (const auto &[name, param] : m_params)
      for (const RANGE &range : param.range) {
        const double value = *static_cast<double *>(param.data);
        if (!(range.m_rt == FE_GREATER ? value > range.m_fmin : value >= range.m_fmin)) return false;
      }
    return true;
  }
  FEParam *AddParameter(double &v, const char *sz) { return Add(sz, {&v, {}}); }
  FEParam *AddParameter(vec3d &v, const char *sz) { return Add(sz, {&v, {}}); }
  FEParam *AddParameter(double &v, RANGE rng, const char *sz) { return Add(sz, {&v, {rng}}); }
  template <typename T>
  void SetParameter(const char *sz, T v) { *static_cast<T *>(m_params.at(sz).data) = v; }

 private:
  FEParam *Add(const char *sz, FEParam param) { return &(m_params[sz] = param); }
  std::map<std::string, FEParam> m_params;
};

class FECoreBase : public FEParamContainer {
 public:
  explicit FECoreBase(FEModel *fem) : m_fem(fem) {}
  virtual bool Init() { return true; }
  FEModel *GetFEModel() const { return m_fem; }

 private:
  FEModel *m_fem;
};

#define DECLARE_FECORE_CLASS() \
 public:                       \
  void BuildParamList() override
#define BEGIN_FECORE_CLASS(theClass, baseClass) \
  void theClass::BuildParamList() {             \
    baseClass::BuildParamList();
#define ADD_PARAMETER(...) AddParameter(__VA_ARGS__)
#define END_FECORE_CLASS() }
#define FECORE_SUPER_CLASS(a) \
 public:                      \
  static SUPER_CLASS_ID superClassID() { return a; }
#define FECORE_BASE_CLASS(theClass) \
 public:                            \
  static const char *BaseClassName() { return #theClass; }
