// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <support/patch_case.hpp>

/// The solvers that intersect two Bezier patches. Each takes a case in its own form before anything is measured.
namespace eliminant::comparisons {

using SpacePolyline = std::vector<std::array<double, 3>>;

/// Polylines in space, a point being one of a single point.
struct FoundPolylines {
  std::vector<SpacePolyline> polylines;
  bool complete = true;  ///< the solver says that it is done; of eliminant: certified
};

struct PatchRun {
  /// What is measured; may be repeated.
  std::function<void()> run;
  /// What the last run found.
  std::function<FoundPolylines()> found;
};

/// intersect_patches with its defaults: curve error 1e-9 of the size, topology proven.
PatchRun eliminant_patches(const test::PatchCase& patches);
/// GeomAPI_IntSS at a tolerance of 1e-7, the one that its documentation recommends. It tells of no isolated points.
PatchRun occt_patches(const test::PatchCase& patches);
/// s1859 for the topology and s1310 along each curve, at a tolerance of 1e-6.
PatchRun sisl_patches(const test::PatchCase& patches);

}  // namespace eliminant::comparisons
