// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2dInt_GInter.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <GeomAPI_IntCS.hxx>
#include <Geom_BezierCurve.hxx>
#include <Standard_Version.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

#include "bezier_solvers.hpp"
#include "occt_patch.hpp"

namespace eliminant::comparisons {

namespace {

using test::BezierCase;
using test::ControlPolygon;

Handle(Geom_BezierCurve) space_curve(const ControlPolygon& polygon) {
  TColgp_Array1OfPnt poles(1, count_of(polygon.size()));
  TColStd_Array1OfReal weights(1, count_of(polygon.size()));
  for (int i = 1; i <= poles.Length(); ++i) {
    const test::HomogeneousPoint& point = polygon[static_cast<std::size_t>(i - 1)];
    poles(i) = affine_point(point);
    weights(i) = point[3];
  }
  return new Geom_BezierCurve(poles, weights);
}

Handle(Geom2d_BezierCurve) plane_curve(const ControlPolygon& polygon) {
  TColgp_Array1OfPnt2d poles(1, count_of(polygon.size()));
  TColStd_Array1OfReal weights(1, count_of(polygon.size()));
  for (int i = 1; i <= poles.Length(); ++i) {
    const test::HomogeneousPoint& point = polygon[static_cast<std::size_t>(i - 1)];
    poles(i) = gp_Pnt2d(point[0] / point[3], point[1] / point[3]);
    weights(i) = point[3];
  }
  return new Geom2d_BezierCurve(poles, weights);
}

FoundParameters curve_on_patch(const Handle(Geom_BezierCurve) & curve, const Handle(Geom_BezierSurface) & surface) {
  const GeomAPI_IntCS intersection(curve, surface);
  FoundParameters found;
  found.complete = intersection.IsDone();
  if (!found.complete) return found;
  for (int i = 1; i <= intersection.NbPoints(); ++i) {
    double u = 0;
    double v = 0;
    double t = 0;
    intersection.Parameters(i, u, v, t);
    found.points.push_back(t);
  }
  for (int i = 1; i <= intersection.NbSegments(); ++i) {
    const Handle(Geom_Curve) segment = intersection.Segment(i);
    found.stretches.push_back({segment->FirstParameter(), segment->LastParameter()});
  }
  return found;
}

FoundParameters curve_on_curve(const Handle(Geom2d_BezierCurve) & first, const Handle(Geom2d_BezierCurve) & second) {
  const Geom2dAPI_InterCurveCurve intersection(first, second);
  FoundParameters found;
  for (int i = 1; i <= intersection.NbPoints(); ++i)
    found.points.push_back(intersection.Intersector().Point(i).ParamOnFirst());
  for (int i = 1; i <= intersection.NbSegments(); ++i) {
    const IntRes2d_IntersectionSegment& segment = intersection.Intersector().Segment(i);
    const double begin = segment.HasFirstPoint() ? segment.FirstPoint().ParamOnFirst() : 0;
    const double end = segment.HasLastPoint() ? segment.LastPoint().ParamOnFirst() : 1;
    found.stretches.push_back({std::min(begin, end), std::max(begin, end)});
  }
  return found;
}

}  // namespace

BezierRun occt_bezier(const BezierCase& bezier) {
  if (bezier.in_plane())
    return [first = plane_curve(bezier.curve), second = plane_curve(bezier.second)] {
      return curve_on_curve(first, second);
    };
  return [curve = space_curve(bezier.curve), surface = occt_patch(bezier.patch)] {
    return curve_on_patch(curve, surface);
  };
}

std::string occt_version() { return "OCCT " OCC_VERSION_COMPLETE; }

}  // namespace eliminant::comparisons
