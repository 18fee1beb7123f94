/* Linear elastic and compressible neo-Hookean solids, in plane strain where dim is 2:
 * W = G/2 (J^(-2/3) I1 - 3) + K/2 (J - 1)^2, as the reference host has them. Stress and its derivative by the displacement gradient. */
#ifndef FMC_DEALII_MATERIAL_H
#define FMC_DEALII_MATERIAL_H

#include <deal.II/base/tensor.h>

#include <cmath>

struct Material {
  bool is_linear;
  double lame, shear, bulk;

  /* First Piola stress P at the displacement gradient h. */
  dealii::Tensor<2, 3> stress(const dealii::Tensor<2, 3> &h) const {
    if (is_linear) return linear(h);
    const State s(h);
    return shear * s.scale * (s.f - s.i1 / 3 * s.inverse) + bulk * (s.j - 1) * s.j * s.inverse;
  }

  /* Its change with dh. */
  dealii::Tensor<2, 3> change(const dealii::Tensor<2, 3> &h, const dealii::Tensor<2, 3> &dh) const {
    if (is_linear) return linear(dh);
    const State s(h);
    const auto volume = dealii::scalar_product(s.inverse, dh);
    const auto turned = s.inverse * dealii::transpose(dh) * s.inverse;
    const auto deviator = dh - 2. / 3 * (volume * (s.f - s.i1 / 3 * s.inverse) + dealii::scalar_product(s.f, dh) * s.inverse);
    return shear * s.scale * (deviator + s.i1 / 3 * turned) +
           bulk * ((2 * s.j - 1) * s.j * volume * s.inverse - (s.j - 1) * s.j * turned);
  }

 private:
  struct State {
    dealii::Tensor<2, 3> f, inverse; /* F and its inverse's transpose */
    double j, i1, scale;
    explicit State(const dealii::Tensor<2, 3> &h) : f(h) {
      for (unsigned i = 0; i < 3; ++i) f[i][i] += 1;
      j = dealii::determinant(f);
      inverse = dealii::transpose(dealii::invert(f));
      i1 = f.norm_square();
      scale = std::pow(j, -2. / 3); /* not a number where a cell is inverted: the step is then too large */
    }
  };

  dealii::Tensor<2, 3> linear(const dealii::Tensor<2, 3> &h) const {
    auto stress = shear * (h + dealii::transpose(h));
    for (unsigned i = 0; i < 3; ++i) stress[i][i] += lame * dealii::trace(h);
    return stress;
  }
};

/* A gradient in the plane is one in space without strain across. */
template <int dim>
dealii::Tensor<2, 3> in_space(const dealii::Tensor<2, dim> &gradient) {
  dealii::Tensor<2, 3> h;
  for (unsigned i = 0; i < dim; ++i)
    for (unsigned j = 0; j < dim; ++j) h[i][j] = gradient[i][j];
  return h;
}

#endif
