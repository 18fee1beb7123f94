// Of FEBio 4, what the plugin uses of its FEException.h: after this one FEBio tries the step again.
#pragma once

class FEException {
 public:
  virtual ~FEException() {}
};
class NANInResidualDetected : public FEException {};
