// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <eliminant/intersect/curves/curve_result.hpp>

namespace eliminant::io {

/// Which values every solution of a result has, the same in all formats and also where the list is empty.
struct CurveShape {
  bool t = true;                   ///< a parameter on the (first) curve
  bool u = false;                  ///< a parameter on the second curve, or the other one of a curve with itself
  bool itself = false;             ///< a curve with itself: solutions have a kind
  bool surface = false;            ///< parameters on the surface
  std::vector<std::string> names;  ///< of the homogeneous coordinates of points: x, y, z, w, or in the plane x, y, w
};

CurveShape shape_of(const intersect::CurveResult& result);

}  // namespace eliminant::io
