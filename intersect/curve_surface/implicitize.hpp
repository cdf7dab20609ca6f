// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/result.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::intersect {

/// A curve or surface whose matrix representation is wanted, and where the options say so its implicit equation.
struct ImplicitizeProblem {
  std::variant<symbolic::ParametricCurve, symbolic::ParametricSurface> geometry;
};

/// The representation of one piece, over the whole parameter line or plane: its domain plays no part.
struct PieceRepresentation {
  std::variant<symbolic::CurvePiece, symbolic::SurfacePiece> piece;
  /// Degree of the moving lines or planes: one number, or two of a tensor-product surface.
  std::vector<long> nu{};
  symbolic::MatrixRepresentation matrix{};
  /// Modulo a prime, at a random point of space and at one of random parameters.
  long rank_off = 0;
  long rank_on = 0;
  /// The rank drops exactly on the curve or surface, and on the extraneous planes: it is full elsewhere.
  bool represents = false;
  /// Degree of the curve or surface times degree of its map.
  long product = 0;
  long map_degree = 1;
  /// Degree of the greatest common divisor of the maximal minors; absent for space curves.
  std::optional<long> minors{};
  /// The minors have planes of base points in common, besides the surface to the power of the map's degree.
  bool extraneous = false;
  /// All of the above is proven; else it was found modulo a prime at random points, which errs in rare cases.
  bool proven = false;
  /// Irreducible over Q and primitive, in x, y, w or x, y, z, w: proven to be the implicit equation.
  std::optional<symbolic::Polynomial> equation{};

  long degree() const { return product / map_degree; }
};

struct ImplicitizeResult {
  /// certified when all pieces are proven; incomplete after a limit.
  Status status = Status::numeric;
  std::optional<std::string> limit;
  std::vector<PieceRepresentation> pieces;
  EngineReport engine;
  std::vector<std::pair<std::string, double>> seconds;
  std::vector<std::string> warnings;
};

/// The smallest matrix of moving lines or planes that represents each piece. Of the options the seed and `equation` are
/// used. Throws InvalidInput for a curve that is a point and for the equation of a space curve; what a limit leaves is
/// in the result. Source: [LuuBuseMourrain2009], section 2.
ImplicitizeResult implicitize(const ImplicitizeProblem& problem, const Options& options, const Context& context);

}  // namespace eliminant::intersect
