// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <support/pipe_scenes.hpp>

namespace eliminant::test {

// Scenes in metres with a noise of 4 mm and a distance of 12 mm; the name is that of the recipe, whose other fields
// mean nothing here.

/// Surfaces that circular cylinders fit in places: boxes, profiles of planes, elliptic cylinders, a corrugated sheet.
std::vector<PipeScene> decoy_scenes();

/// Pipes that touch other surfaces or are seen in part: on a floor, in a corner of planes, junctions, a third of the
/// circumference, slightly elliptic, seen by a scanner in coordinates of a country's grid.
std::vector<PipeScene> touching_scenes();

}  // namespace eliminant::test
