// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdlib>
#include <memory>

#include <sisl.h>

#include "bezier_solvers.hpp"
#include "sisl_patch.hpp"

namespace eliminant::comparisons {

namespace {

using test::BezierCase;
using test::ControlPolygon;

constexpr double tolerance = 1e-6;
constexpr double unused_tolerance = 0;

using Curve = std::shared_ptr<SISLCurve>;

Curve curve_of(const ControlPolygon& polygon, std::size_t dimension) {
  const bool rational = has_weights(polygon);
  std::vector<double> knots = bezier_knots(polygon.size());
  std::vector<double> numbers = coefficients(polygon, dimension, rational);
  const int order = static_cast<int>(polygon.size());
  return {newCurve(order, order, knots.data(), numbers.data(), spline_kind(rational), static_cast<int>(dimension),
                   copy_arrays),
          freeCurve};
}

/// What SISL allocates for an answer.
struct Answer {
  Answer() = default;
  Answer(const Answer&) = delete;
  Answer& operator=(const Answer&) = delete;
  ~Answer() {
    std::free(first);   // NOLINT: allocated by SISL
    std::free(second);  // NOLINT
    if (stretches != nullptr) freeIntcrvlist(stretches, stretch_count);
  }

  int point_count = 0;
  double* first = nullptr;
  double* second = nullptr;
  int stretch_count = 0;
  SISLIntcurve** stretches = nullptr;
  int status = 0;

  /// Parameters on the curve: in the first array of points, and of each stretch, or in the second.
  FoundParameters on_curve(bool in_first) const {
    FoundParameters found;
    found.complete = status >= 0;
    if (!found.complete) return found;
    const double* const points = in_first ? first : second;
    found.points.assign(points, points + point_count);
    for (int i = 0; i < stretch_count; ++i) {
      const SISLIntcurve& stretch = *stretches[i];
      const double* const parameters = in_first ? stretch.epar1 : stretch.epar2;
      const double begin = parameters[0];
      const double end = parameters[stretch.ipoint - 1];
      found.stretches.push_back({std::min(begin, end), std::max(begin, end)});
    }
    return found;
  }
};

}  // namespace

BezierRun sisl_bezier(const BezierCase& bezier) {
  if (bezier.in_plane())
    return [first = curve_of(bezier.curve, 2), second = curve_of(bezier.second, 2)] {
      Answer answer;
      s1857(first.get(), second.get(), unused_tolerance, tolerance, &answer.point_count, &answer.first, &answer.second,
            &answer.stretch_count, &answer.stretches, &answer.status);
      return answer.on_curve(true);
    };
  return [curve = curve_of(bezier.curve, 3), surface = sisl_patch(bezier.patch)] {
    Answer answer;
    s1858(surface.get(), curve.get(), unused_tolerance, tolerance, &answer.point_count, &answer.first, &answer.second,
          &answer.stretch_count, &answer.stretches, &answer.status);
    return answer.on_curve(false);
  };
}

std::string sisl_version() { return "SISL"; }

}  // namespace eliminant::comparisons
