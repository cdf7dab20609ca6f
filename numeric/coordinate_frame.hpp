// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/numeric/rational_forms.hpp>

namespace eliminant::numeric {

/// The smallest power of two above x, within 2^-500 and 2^500; 1 where x is not positive and finite.
double power_of_two_above(double x);

/// Affine coordinates in which a surface is about as large as 1 and near to the origin:
/// x'_k = (x_k - centre_k w) / scale_k, the scales powers of two.
struct CoordinateFrame {
  std::array<double, 4> centre{};
  std::array<double, 4> scale{1, 1, 1, 1};

  /// The point in the middle of the parameters goes to the origin.
  static CoordinateFrame of(const SurfaceForms& surface);
  void apply(CoordinateRows& rows) const;
};

/// Another homogeneous parameter of a curve: (t_0, t_1) = (scale (c x_0 + s x_1), c x_1 - s x_0), c and s cosine and
/// sine of an angle.
struct ParameterTurn {
  double scale = 1;
  double cosine = 1;
  double sine = 0;

  template <class Scalar>
  std::array<Scalar, 2> back(const std::array<Scalar, 2>& x) const {
    return {scale * (cosine * x[0] + sine * x[1]), cosine * x[1] - sine * x[0]};
  }
  /// The curve in (x_0 : x_1).
  void apply(const CurveForms& curve, CurveForms& result) const;
};

}  // namespace eliminant::numeric
