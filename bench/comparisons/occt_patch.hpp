// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include <Geom_BezierSurface.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pnt.hxx>

#include <support/bezier_case.hpp>

/// Control nets as OCCT has them.
namespace eliminant::comparisons {

inline int count_of(std::size_t size) { return static_cast<int>(size); }

inline gp_Pnt affine_point(const test::HomogeneousPoint& point) {
  return {point[0] / point[3], point[1] / point[3], point[2] / point[3]};
}

inline Handle(Geom_BezierSurface) occt_patch(const test::ControlNet& net) {
  const int rows = count_of(net.size());
  const int columns = count_of(net.front().size());
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  TColStd_Array2OfReal weights(1, rows, 1, columns);
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= columns; ++j) {
      const test::HomogeneousPoint& point = net[static_cast<std::size_t>(i - 1)][static_cast<std::size_t>(j - 1)];
      poles(i, j) = affine_point(point);
      weights(i, j) = point[3];
    }
  return new Geom_BezierSurface(poles, weights);
}

}  // namespace eliminant::comparisons
