// Of FEBio 4, what the plugin uses of its FECoreKernel.h: the kernel in which classes are registered, and made by their names.
#pragma once
#include "FECoreBase.h"

#define FE_SDK_VERSION ((4 << 16) | (1 << 8))
#define FECORE_EXPORT extern "C"

class FECoreFactory {
 public:
  FECoreFactory(SUPER_CLASS_ID scid, const char *, const char *, const char *szalias) : m_scid(scid), m_szalias(szalias) {}
  virtual ~FECoreFactory() {}
  virtual FECoreBase *Create(FEModel *) const = 0;
  SUPER_CLASS_ID m_scid;
  std::string m_szalias;
};

class FECoreKernel {
 public:
  static FECoreKernel &GetInstance() { return *Instance(); }
  static void SetInstance(FECoreKernel *kernel) { Instance() = kernel; }
  void RegisterFactory(FECoreFactory *factory) { m_Fac.push_back(factory); }
  FECoreBase *Create(int superClassID, const char *szalias, FEModel *fem) {
    for (const FECoreFactory *factory : m_Fac)
      if (factory->m_scid == superClassID && factory->m_szalias == szalias) {
        FECoreBase *made = factory->Create(fem);
        made->BuildParamList();
        return made;
      }
    return nullptr;
  }

 private:
  static FECoreKernel *&Instance() {
    static FECoreKernel *kernel = nullptr;
    return kernel;
  }
  std::vector<FECoreFactory *> m_Fac;
};

template <typename T>
class FERegisterClass_T : public FECoreFactory {
 public:
  FERegisterClass_T(SUPER_CLASS_ID sid, const char *szclass, const char *szbase, const char *szalias)
      : FECoreFactory(sid, szclass, szbase, szalias) {
    FECoreKernel::GetInstance().RegisterFactory(this);
  }
  FECoreBase *Create(FEModel *fem) const override { return new T(fem); }
};

#define REGISTER_FECORE_CLASS(theClass, ...) \
  static FERegisterClass_T<theClass> _##theClass##_rc(theClass::superClassID(), #theClass, theClass::BaseClassName(), __VA_ARGS__)
