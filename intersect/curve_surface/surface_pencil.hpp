// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curve_surface/surface_preimages.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/numeric/representation_pencil.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// What becomes of a representation with more columns than rows, whose companion pencil is singular.
enum class SingularPencilMethod {
  /// projection, which finds the same and is faster (docs/matrix-representations.md)
  automatic,
  /// The regular part by the staircase of [LuuBuseMourrain2009], section 3.3, with ranks from arithmetic modulo a
  /// prime.
  staircase,
  /// A square matrix by a fixed orthonormal combination of the columns ([HochstenbachMehlPlestenjak2023]): its
  /// eigenvalues are those of the regular part and others without meaning, which no proof accepts.
  projection
};

/// The pencil engine: the matrix representation of a surface rounded to doubles, once, for any number of curves.
class SurfacePencil {
 public:
  /// All must outlive the object. A surface of a degree above numeric::largest_numeric_degree is left to the other
  /// engines.
  SurfacePencil(const symbolic::RationalSurface& surface, const symbolic::MatrixRepresentation& m,
                const SurfaceInversion& inversion);

  /// The eigenvalues in doubles and the parameters that belong to them: candidates, nothing is proven.
  numeric::NumericIntersections candidates(const symbolic::RationalCurve& curve, SingularPencilMethod method,
                                           std::uint64_t seed) const;

  /// All solutions in the complex plane, when each is proven, simple and at a finite parameter of its own, and there
  /// are `expected` of them; else nullopt. Fills what the report says of the pencil.
  std::optional<std::vector<CurveSolution>> solve(const symbolic::RationalCurve& curve, unsigned long expected,
                                                  const Options& options, const Context& context, EngineReport& report,
                                                  SingularPencilMethod method = SingularPencilMethod::automatic) const;

 private:
  const symbolic::MatrixRepresentation& m_;
  const SurfaceInversion& inversion_;
  std::optional<numeric::RepresentationPencil> pencil_;
};

}  // namespace eliminant::intersect
