// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/common_points.hpp>

#include <eliminant/intersect/parameter_roots.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using Coordinates = std::vector<ComplexBall>;

ComplexBall minor(const Coordinates& a, const Coordinates& b, std::size_t j, std::size_t pivot, long precision_bits) {
  ComplexBall value;
  ComplexBall product;
  acb_mul(value.get(), a[j].get(), b[pivot].get(), precision_bits);
  acb_mul(product.get(), a[pivot].get(), b[j].get(), precision_bits);
  acb_sub(value.get(), value.get(), product.get(), precision_bits);
  return value;
}

}  // namespace

bridge::System common_point_system(const bridge::BallSurface& surface, const symbolic::RationalCurve& curve,
                                   const bridge::HomogeneousParameters& parameters,
                                   std::array<std::size_t, 2> variables, std::size_t pivot) {
  std::vector<symbolic::UnivariatePolynomial> derivatives;
  for (const symbolic::UnivariatePolynomial& f : curve.coordinates()) derivatives.push_back(f.derivative());
  return [&surface, &curve, derivatives, parameters, variables, pivot](const std::vector<ComplexBall>& at,
                                                                       long precision_bits) {
    bridge::HomogeneousParameters here = parameters;
    for (std::size_t k = 0; k < 2; ++k) here[variables[k]] = at[k];
    const Coordinates on_surface = surface.point_at(here, precision_bits);
    const std::array<Coordinates, 2> partials{surface.derivative_at(here, variables[0], precision_bits),
                                              surface.derivative_at(here, variables[1], precision_bits)};
    Coordinates on_curve;
    Coordinates tangent;
    for (std::size_t k = 0; k < 4; ++k) {
      on_curve.push_back(evaluate(curve.coordinates()[k], at[2], precision_bits));
      tangent.push_back(evaluate(derivatives[k], at[2], precision_bits));
    }
    bridge::SystemValue result;
    for (std::size_t j = 0; j < 4; ++j) {
      if (j == pivot) continue;
      result.values.push_back(minor(on_surface, on_curve, j, pivot, precision_bits));
      result.jacobian.push_back({minor(partials[0], on_curve, j, pivot, precision_bits),
                                 minor(partials[1], on_curve, j, pivot, precision_bits),
                                 minor(on_surface, tangent, j, pivot, precision_bits)});
    }
    return result;
  };
}

}  // namespace eliminant::intersect
