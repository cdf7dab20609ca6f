// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curve_result.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/surface_preimages.hpp>
#include <eliminant/numeric/companion_pencil.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

namespace eliminant::intersect {

/// The pencil engine: the matrix representation of a surface rounded to doubles, once, for any number of curves.
///
/// A representation with more columns than rows is projected to a square one by a fixed orthonormal combination of its
/// columns ([HochstenbachMehlPlestenjak2023]): its eigenvalues are those of the regular part of the pencil of
/// [LuuBuseMourrain2009] and others without meaning, which no proof accepts.
class SurfacePencil {
 public:
  /// Both must outlive the object.
  SurfacePencil(const symbolic::MatrixRepresentation& m, const SurfaceInversion& inversion);

  /// All solutions in the complex plane, when each is proven, simple and at a finite parameter of its own, and there
  /// are `expected` of them; else nullopt. Fills what the report says of the pencil.
  std::optional<std::vector<CurveSolution>> solve(const symbolic::RationalCurve& curve, unsigned long expected,
                                                  const Options& options, const Context& context,
                                                  EngineReport& report) const;

 private:
  /// M = sum of x_k blocks[k], square.
  std::array<numeric::Matrix<double>, 4> blocks_;
  const SurfaceInversion& inversion_;
};

}  // namespace eliminant::intersect
