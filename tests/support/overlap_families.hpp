// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <support/text_patches.hpp>

/// Pairs of patches that are parts of one surface.
namespace eliminant::test {

using symbolic::Interval;
using symbolic::Polynomial;
using symbolic::SurfacePiece;

struct OverlapPair {
  std::string name;
  SurfacePiece first;
  SurfacePiece second;
  /// Curves, loops, points, overlaps that are in common.
  std::array<unsigned long, 4> counts{};
  /// Whether a point of the first patch, by its parameters, lies in the second; at least `margin` away from the border.
  enum class Place { inside, outside, near_border };
  std::function<Place(double u, double v)> place;
};

inline OverlapPair::Place place_by(double least_distance) {
  constexpr double margin = 1e-3;
  if (least_distance > margin) return OverlapPair::Place::inside;
  return least_distance < -margin ? OverlapPair::Place::outside : OverlapPair::Place::near_border;
}

/// (a x + b) / (c x + d).
struct Fraction {
  Rational a = 1;
  Rational b;
  Rational c;
  Rational d = 1;

  Rational at(const Rational& x) const { return (a * x + b) / (c * x + d); }
  Rational before(const Rational& y) const { return (b - d * y) / (c * y - a); }
};

/// The map with its parameters replaced, homogenised by its bidegree, and the domain that has the same points. With
/// `exchange` the new parameters are exchanged, too.
inline SurfacePiece reparametrised(const SurfacePiece& patch, const std::array<Fraction, 2>& by, bool exchange) {
  const auto degrees = patch.map.bidegree();
  std::array<std::vector<Polynomial>, 2> numerators;
  std::array<std::vector<Polynomial>, 2> denominators;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Polynomial x = Polynomial::variable(2, exchange ? 1 - axis : axis);
    const Polynomial one = Polynomial::constant(2, 1);
    numerators[axis] = denominators[axis] = {one};
    for (long i = 0; i < degrees[axis]; ++i) {
      numerators[axis].push_back(numerators[axis].back() * (by[axis].a * x + by[axis].b * one));
      denominators[axis].push_back(denominators[axis].back() * (by[axis].c * x + by[axis].d * one));
    }
  }
  std::vector<Polynomial> coordinates;
  for (const Polynomial& coordinate : patch.map.coordinates()) {
    Polynomial sum(2);
    for (const auto& term : coordinate.terms()) {
      Polynomial product = Polynomial::constant(2, term.coefficient);
      for (std::size_t axis = 0; axis < 2; ++axis)
        product = product * numerators[axis][term.exponents[axis]] *
                  denominators[axis][static_cast<std::size_t>(degrees[axis]) - term.exponents[axis]];
      sum = sum + product;
    }
    coordinates.push_back(sum);
  }
  symbolic::ParameterRegion region;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Rational lower = by[axis].before(patch.region->sides[axis].lower);
    Rational upper = by[axis].before(patch.region->sides[axis].upper);
    if (upper < lower) std::swap(lower, upper);
    region.sides[exchange ? 1 - axis : axis] = {lower, upper};
  }
  return {symbolic::RationalSurface(symbolic::RationalSurface::Kind::tensor_product, coordinates), region};
}

/// All coordinates after an affine map of space.
inline SurfacePiece moved_in_space(const SurfacePiece& patch) {
  const auto& c = patch.map.coordinates();
  const std::vector<Polynomial> coordinates{Rational(100) * c[0] + Rational(70) * c[1] + Rational(5000) * c[3],
                                            Rational(90) * c[1] - Rational(30) * c[2],
                                            Rational(80) * c[2] + Rational(25) * c[0] - Rational(700) * c[3], c[3]};
  return {symbolic::RationalSurface(symbolic::RationalSurface::Kind::tensor_product, coordinates), patch.region};
}

/// A graph over (u, v), or a rational map near it, that does not meet itself on [0, 1]^2.
inline PatchText random_text(std::mt19937& random, long degree, bool rational) {
  std::uniform_int_distribution<long> digit(-9, 9);
  const auto sum = [&](const std::string& start, long denominator) {
    std::string text = start;
    for (long i = 0; i <= degree; ++i)
      for (long j = 0; j <= degree; ++j)
        text += " + " + std::to_string(digit(random)) + "/" + std::to_string(denominator) + "*u^" + std::to_string(i) +
                "*v^" + std::to_string(j);
    return text;
  };
  return {sum("u", 800), sum("v", 800), sum("0", 20), rational ? sum("1", 400) : "1"};
}

/// Two rectangles of one map: what they have in common is known by the rectangles.
inline OverlapPair rectangles(const std::string& name, const PatchText& text, const Sides& first, const Sides& second) {
  OverlapPair pair{name, patch(text, first), patch(text, second), {}, {}};
  unsigned long widths = 0;
  bool apart = false;
  for (std::size_t k = 0; k < 2; ++k) {
    const Rational& lower = first[k].lower < second[k].lower ? second[k].lower : first[k].lower;
    const Rational& upper = first[k].upper < second[k].upper ? first[k].upper : second[k].upper;
    apart = apart || upper < lower;
    if (lower < upper) ++widths;
  }
  if (!apart) ++pair.counts[widths == 2 ? 3 : widths == 1 ? 0 : 2];
  pair.place = [second](double u, double v) {
    const auto within = [](double x, const Interval& side) {
      return std::min(x - fmpq_get_d(side.lower.get()), fmpq_get_d(side.upper.get()) - x);
    };
    return place_by(std::min(within(u, second[0]), within(v, second[1])));
  };
  return pair;
}

/// One surface in different parameters: planes, cylinders, spheres, cones.
std::vector<OverlapPair> overlaps_of_common_surfaces();

/// Pairs of rectangles of random maps, one of them in new parameters.
std::vector<OverlapPair> overlaps_of_shared_maps(unsigned seed);

}  // namespace eliminant::test
