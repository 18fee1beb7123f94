// Of FEBio 4, what the plugin uses of its FENLConstraint.h and of what that includes: the base class of the plugin's constraint.
#pragma once
#include "FECoreBase.h"
#include "FEGlobalVector.h"
#include "FEModel.h"

class FEGlobalMatrix;
class FELinearSystem;
class FETimeInfo {};

class FEModelComponent : public FECoreBase {
 public:
  explicit FEModelComponent(FEModel *fem) : FECoreBase(fem) {}
  int GetDOFIndex(const char *szdof) const { return GetFEModel()->GetDOFIndex(szdof); }
  FEMesh &GetMesh() { return GetFEModel()->GetMesh(); }
};

class FEStepComponent : public FEModelComponent {
 public:
  explicit FEStepComponent(FEModel *fem) : FEModelComponent(fem) {}
  bool IsActive() const { return m_bactive; }
  virtual void Activate() { m_bactive = true; }

 private:
  bool m_bactive = false;
};

class FENLConstraint : public FEStepComponent {
  FECORE_SUPER_CLASS(FENLCONSTRAINT_ID)
  FECORE_BASE_CLASS(FENLConstraint)

 public:
  explicit FENLConstraint(FEModel *fem) : FEStepComponent(fem) {}
  virtual void LoadVector(FEGlobalVector &R, const FETimeInfo &tp) = 0;
  virtual void StiffnessMatrix(FELinearSystem &LS, const FETimeInfo &tp) = 0;
  virtual bool Augment(int, const FETimeInfo &) { return true; }
  virtual void BuildMatrixProfile(FEGlobalMatrix &M) = 0;
  virtual void Reset() {}
  virtual void PrepStep() {}
};
