// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/overlaps/equal_surfaces.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/overlaps/patch_overlap.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/symbolic/elimination/surface_overlap.hpp>
#include <eliminant/symbolic/geometry/image_dimension.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Integer;
using symbolic::Polynomial;
using symbolic::Rational;
using symbolic::RationalSurface;

/// A square of parameters around a point as a patch.
std::optional<PreparedNet> patch_around(const RationalSurface& map, const std::array<Rational, 2>& at) {
  const Rational reach(Integer(1), Integer(16));
  symbolic::ParameterRegion region;
  for (std::size_t k = 0; k < 2; ++k) region.sides[k] = {at[k] - reach, at[k] + reach};
  PreparedNet net = prepared_patch({map, region}, "whole");
  if (!has_positive_weights(net)) return std::nullopt;
  return net;
}

bool overlap_near(const RationalSurface& first, const RationalSurface& second, const std::array<Rational, 2>& at,
                  const std::array<Rational, 2>& image, const Context& context) {
  const auto a = patch_around(first, at);
  const auto b = patch_around(second, image);
  if (!a || !b) return false;
  const auto origin = a->origin();
  const auto a_net = a->rounded(origin);
  const auto b_net = b->rounded(origin);
  if (!a_net || !b_net) return false;
  constexpr double rough = 1e-2;
  const auto overlap = patch_overlap({a->exact, *a_net}, {b->exact, *b_net}, rough * size_of(*a), context);
  return overlap && !overlap->outlines.empty();
}

/// Real parameters of the map near which it has the point, by two of the equations.
std::vector<std::array<Rational, 2>> real_parameters(const RationalSurface& map, const std::vector<Rational>& point,
                                                     std::size_t skipped, const Options& options,
                                                     const Context& context) {
  PlaneCurvesProblem problem;
  bool has_first = false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == skipped) continue;
    (has_first ? problem.q : problem.p) = point[3] * map.coordinates()[k] - point[k] * map.coordinates()[3];
    has_first = true;
  }
  std::vector<std::array<Rational, 2>> result;
  if (problem.p.is_zero() || problem.q.is_zero()) return result;
  Options real = options;
  real.field = Field::real;
  for (const Solution& solution : intersect_plane_curves(problem, real, context).solutions) {
    std::array<Rational, 2> at;
    for (std::size_t k = 0; k < 2; ++k) {
      const Coordinate& x = k == 0 ? solution.x : solution.y;
      bridge::RealBall rounded;
      constexpr long few_bits = 40;
      arb_set_round(rounded.get(), x.ball.real(), few_bits);
      arf_get_fmpq(at[k].get(), arb_midref(rounded.get()));
    }
    result.push_back(std::move(at));
  }
  return result;
}

}  // namespace

bool are_one_surface(const RationalSurface& first, const RationalSurface& second, const Options& options,
                     const Context& context) {
  if (!symbolic::is_two_dimensional(first) || !symbolic::is_two_dimensional(second)) return false;
  // Beyond that the equation takes longer than the eliminant, which tells it, too.
  constexpr long largest_degree = 12;
  if (2 * first.bidegree()[0] * first.bidegree()[1] > largest_degree) return false;
  try {
    return symbolic::have_equal_image(first, second, options.seed, context);
  } catch (const LimitReached&) {
    // Of the equation, or of the context.
    context.checkpoint("comparing surfaces");
  } catch (const InvalidInput&) {
    // No matrix represents the first.
  }
  return false;
}

bool have_common_real_part(const RationalSurface& first, const RationalSurface& second, const Options& options,
                           const Context& context) {
  // In general position, of both signs, within and beyond 1.
  constexpr std::array<std::array<int, 2>, 6> starts{{{7, 5}, {-9, 4}, {6, -23}, {-35, -19}, {29, 41}, {-3, 57}}};
  constexpr int parts = 16;
  for (const auto& start : starts) {
    context.checkpoint("looking for a common part");
    const std::array<Rational, 2> at{Rational(Integer(start[0]), Integer(parts)),
                                     Rational(Integer(start[1]), Integer(parts))};
    const std::vector<Rational> point = first.at({at[0], at[1]});
    if (point[3].is_zero()) continue;
    for (std::size_t skipped = 0; skipped < 3; ++skipped)
      for (const auto& image : real_parameters(second, point, skipped, options, context))
        if (overlap_near(first, second, at, image, context)) return true;
  }
  return false;
}

}  // namespace eliminant::intersect
