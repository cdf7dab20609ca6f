// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include <GeomAPI_IntSS.hxx>
#include <Geom_Curve.hxx>

#include "occt_patch.hpp"
#include "patch_solvers.hpp"

namespace eliminant::comparisons {

namespace {

constexpr double tolerance = 1e-7;
constexpr int samples = 400;

SpacePolyline sampled(const Handle(Geom_Curve) & curve) {
  SpacePolyline polyline;
  const double first = curve->FirstParameter();
  const double last = curve->LastParameter();
  for (int i = 0; i <= samples; ++i) {
    const gp_Pnt point = curve->Value(first + (last - first) * i / samples);
    polyline.push_back({point.X(), point.Y(), point.Z()});
  }
  return polyline;
}

}  // namespace

PatchRun occt_patches(const test::PatchCase& patches) {
  const auto intersection = std::make_shared<GeomAPI_IntSS>();
  const auto run = [intersection, first = occt_patch(patches.first), second = occt_patch(patches.second)] {
    intersection->Perform(first, second, tolerance);
  };
  const auto found = [intersection] {
    FoundPolylines result;
    result.complete = intersection->IsDone();
    if (!result.complete) return result;
    for (int i = 1; i <= intersection->NbLines(); ++i) result.polylines.push_back(sampled(intersection->Line(i)));
    return result;
  };
  return {run, found};
}

}  // namespace eliminant::comparisons
