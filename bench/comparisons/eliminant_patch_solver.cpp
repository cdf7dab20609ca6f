// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include <eliminant/intersect/patches/patch_pair.hpp>
#include <support/patch_nets.hpp>

#include "patch_solvers.hpp"

namespace eliminant::comparisons {

PatchRun eliminant_patches(const test::PatchCase& patches) {
  const auto result = std::make_shared<intersect::SurfaceResult>();
  const auto run = [result, first = test::surface_piece(patches.first), second = test::surface_piece(patches.second)] {
    // As far as the others go.
    intersect::Options options;
    options.tolerance = 1e-6;
    *result = intersect::intersect_patches(first, second, options, Context());
  };
  const auto found = [result] {
    FoundPolylines polylines;
    polylines.complete = result->status == intersect::Status::certified;
    for (const intersect::SurfaceComponent& component : result->components) {
      SpacePolyline& polyline = polylines.polylines.emplace_back();
      for (const intersect::SurfacePoint& point : component.points) polyline.push_back(point.point);
    }
    return polylines;
  };
  return {run, found};
}

}  // namespace eliminant::comparisons
