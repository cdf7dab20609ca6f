// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Curves and patches in plain doubles, for tests, benchmarks and programs that link other libraries.
namespace eliminant::test {

/// (w x, w y, w z, w), each number exactly what it says; in the plane z is 0.
using HomogeneousPoint = std::array<double, 4>;
using ControlPolygon = std::vector<HomogeneousPoint>;
/// A row for each index of the first parameter.
using ControlNet = std::vector<ControlPolygon>;

/// A parameter of the (first) curve at which it is known to meet the other object.
struct PlantedParameter {
  /// Irreducible over Z, ascending coefficients; the root meant is the one in [0, 1].
  std::vector<long> polynomial;
  double approximation = 0;
  /// 1 and more, exactly; 0 where it is not known.
  unsigned long multiplicity = 0;
};

/// A contact moved by 2^-exponent to one side.
struct PushedContact {
  double parameter = 0;  ///< of the contact, approximately
  unsigned long order = 2;
  long exponent = 13;
  bool outwards = true;
};

/// A Bezier curve over [0, 1] and a tensor-product Bezier patch over [0, 1] x [0, 1], or two plane curves.
struct BezierCase {
  std::string family;
  /// First in its family is 0; the same case at every run.
  unsigned long index = 0;
  ControlPolygon curve;
  ControlNet patch;       ///< empty for two plane curves
  ControlPolygon second;  ///< empty for a curve and a patch

  std::vector<PlantedParameter> planted;
  /// The curve lies on the patch, or on the second curve, for exactly these parameters.
  std::optional<std::array<double, 2>> overlap;
  std::optional<PushedContact> pushed;

  bool in_plane() const { return patch.empty(); }
};

}  // namespace eliminant::test
