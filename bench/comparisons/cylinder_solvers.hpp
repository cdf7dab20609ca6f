// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <support/pipe_scenes.hpp>

namespace eliminant::comparisons {

/// The cylinders that a search finds in a scene, and the processor seconds it takes.
struct CylinderAnswer {
  std::vector<test::ScenePipe> cylinders;
  double seconds = 0;
  /// The time was over before the search.
  bool stopped = false;
};

CylinderAnswer eliminant_cylinders(const test::PipeScene& scene, unsigned threads, double limit_seconds);

/// The best cylinder of PCL's SACMODEL_CYLINDER (two points with normals, RANSAC, then its own least squares), again
/// and again without the points of those found, until the best has fewer points than eliminant asks for. Lengths are
/// not found. It is told the range of radii of the scene.
CylinderAnswer pcl_cylinders(const test::PipeScene& scene, double limit_seconds);

}  // namespace eliminant::comparisons
