// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/germ_in_space.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/bridge/rounding/simple_fraction.hpp>
#include <eliminant/symbolic/elimination/space_curve_germ.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Polynomial;
using symbolic::Rational;

/// The axes of the frame are the columns, divided by 9: it is orthogonal.
constexpr std::array<std::array<long, 3>, 3> axes{{{1, 8, -4}, {4, -4, -7}, {8, 1, 4}}};
constexpr double axis_length = 9;

/// Of the product of both degrees: the resultants have that degree, in two variables.
constexpr long largest_projected_degree = 32;

std::array<Polynomial, 3> frame_around(const std::array<Rational, 3>& point) {
  const auto coordinate = [&](std::size_t k) {
    Polynomial x = Polynomial::constant(3, point[k]);
    for (std::size_t axis = 0; axis < 3; ++axis) x = x + Rational(axes[k][axis]) * Polynomial::variable(3, axis);
    return x;
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

std::array<Rational, 3> fraction_of(const std::array<double, 3>& point, double error) {
  std::array<Rational, 3> result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = bridge::simple_fraction(point[k], error).value_or(bridge::exactly(point[k]));
  return result;
}

std::vector<SpaceForm> gradient(const Polynomial& p) {
  std::vector<SpaceForm> result;
  for (std::size_t k = 0; k < 3; ++k) result.emplace_back(p.derivative(k));
  return result;
}

/// The least absolute value.
double least_magnitude(const DoubleInterval& x) { return std::max({x.lower, -x.upper, 0.0}); }

}  // namespace

GermInSpace::GermInSpace(const Polynomial& f, const Polynomial& g, const std::array<double, 3>& point, double error)
    : origin_(point), equations_{f, g} {
  std::array<Rational, 3> origin;
  for (std::size_t k = 0; k < 3; ++k) origin[k] = bridge::exactly(point[k]);
  const std::array<Polynomial, 3> simple = frame_around(fraction_of(point, error));
  const bool on_both = std::all_of(equations_.begin(), equations_.end(),
                                   [&](const Polynomial& p) { return p.compose(simple).constant_term().is_zero(); });
  const std::array<Polynomial, 3> frame = on_both ? simple : frame_around(origin);
  for (std::size_t i = 0; i < 2; ++i) {
    equations_[i] = equations_[i].compose(frame);
    gradients_[i] = gradient(equations_[i]);
  }
}

std::array<double, 3> GermInSpace::to_frame(const std::array<double, 3>& point) const {
  std::array<double, 3> result{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < 3; ++k)
      result[axis] += static_cast<double>(axes[k][axis]) * (point[k] - origin_[k]) / (axis_length * axis_length);
  return result;
}

void GermInSpace::project() {
  if (projected_) return;
  projected_ = true;
  if (equations_[0].total_degree() * equations_[1].total_degree() > largest_projected_degree) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    projections_[axis] = symbolic::projected_curve(equations_[0], equations_[1], axis);
    if (projections_[axis]) projected_gradients_[axis] = gradient(*projections_[axis]);
  }
}

std::optional<std::size_t> GermInSpace::graph_coordinate(double half_width) {
  std::array<DoubleInterval, 3> box;
  for (DoubleInterval& side : box) side = DoubleInterval::around(0, half_width);
  const auto at = [&](const std::vector<SpaceForm>& form, std::size_t k) { return form[k].at(box).value; };
  std::optional<std::size_t> best;
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3;
    const std::size_t b = (k + 2) % 3;
    const double least =
        least_magnitude(at(gradients_[0], a) * at(gradients_[1], b) - at(gradients_[0], b) * at(gradients_[1], a));
    if (!(least > largest)) continue;
    largest = least;
    best = k;
  }
  if (best) return best;
  project();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3;
    const std::size_t b = (k + 2) % 3;
    if (!projections_[a] || !projections_[b]) continue;
    // Least slopes first: the larger the derivative by the other coordinate beside that by this one.
    const auto steepness = [&](std::size_t projected_along, std::size_t other) {
      const std::vector<SpaceForm>& form = projected_gradients_[projected_along];
      return least_magnitude(at(form, other)) / std::max(at(form, k).magnitude(), 1e-300);
    };
    const double least = std::min(steepness(a, b), steepness(b, a));
    if (!(least > largest)) continue;
    largest = least;
    best = k;
  }
  return best;
}

bool GermInSpace::is_singular() {
  project();
  return symbolic::is_singular_at_origin(equations_[0], equations_[1], projections_);
}

}  // namespace eliminant::intersect
