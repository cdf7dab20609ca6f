// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <sisl.h>

#include <support/bezier_case.hpp>

/// Control points as SISL has them.
namespace eliminant::comparisons {

constexpr int copy_arrays = 1;

inline std::vector<double> bezier_knots(std::size_t order) {
  std::vector<double> knots(order, 0);
  knots.resize(2 * order, 1);
  return knots;
}

inline bool has_weights(const test::ControlPolygon& polygon) {
  for (const test::HomogeneousPoint& point : polygon)
    if (point[3] != 1) return true;
  return false;
}

/// Points as SISL's B-splines have them: with the weight last, and multiplied in, where there are weights.
inline std::vector<double> coefficients(const test::ControlPolygon& polygon, std::size_t dimension, bool rational) {
  std::vector<double> numbers;
  for (const test::HomogeneousPoint& point : polygon) {
    for (std::size_t k = 0; k < dimension; ++k) numbers.push_back(point[k]);
    if (rational) numbers.push_back(point[3]);
  }
  return numbers;
}

/// SISL's numbers of the kinds of spline.
inline int spline_kind(bool rational) { return rational ? 2 : 1; }

/// SISL's first parameter is the one that runs within a row.
inline std::shared_ptr<SISLSurf> sisl_patch(const test::ControlNet& net) {
  test::ControlPolygon points;
  for (const test::ControlPolygon& row : net) points.insert(points.end(), row.begin(), row.end());
  const bool rational = has_weights(points);
  std::vector<double> knots_within = bezier_knots(net.front().size());
  std::vector<double> knots_across = bezier_knots(net.size());
  std::vector<double> numbers = coefficients(points, 3, rational);
  const int within = static_cast<int>(net.front().size());
  const int across = static_cast<int>(net.size());
  return {newSurf(within, across, within, across, knots_within.data(), knots_across.data(), numbers.data(),
                  spline_kind(rational), 3, copy_arrays),
          freeSurf};
}

}  // namespace eliminant::comparisons
