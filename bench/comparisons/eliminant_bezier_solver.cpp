// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include <eliminant/intersect/curve_surface/bezier_intersection.hpp>

#include "bezier_solvers.hpp"

namespace eliminant::comparisons {

namespace {

FoundParameters found(const intersect::BezierIntersections& result) {
  FoundParameters parameters;
  for (const intersect::BezierPoint& point : result.points) {
    // A point with several parameters on the patch is one on the curve.
    if (parameters.points.empty() || parameters.points.back() != point.parameters[0])
      parameters.points.push_back(point.parameters[0]);
  }
  parameters.stretches = result.overlap;
  parameters.complete = result.status == intersect::Status::certified ||
                        (result.status == intersect::Status::infinite && !result.overlap.empty());
  return parameters;
}

intersect::BezierIntersector intersector(const test::BezierCase& bezier) {
  if (bezier.in_plane()) return intersect::BezierIntersector(intersect::BezierCurve{bezier.second});
  intersect::BezierPatch patch;
  patch.degree = {bezier.patch.size() - 1, bezier.patch.front().size() - 1};
  for (const test::ControlPolygon& row : bezier.patch) patch.points.insert(patch.points.end(), row.begin(), row.end());
  return intersect::BezierIntersector(std::move(patch));
}

}  // namespace

BezierRun eliminant_bezier(const test::BezierCase& bezier) {
  return [second = intersector(bezier), first = intersect::BezierCurve{bezier.curve}] {
    return found(second.intersect(first));
  };
}

}  // namespace eliminant::comparisons
