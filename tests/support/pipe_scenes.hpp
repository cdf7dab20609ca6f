// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace eliminant::test {

/// A pipe as it was built.
struct ScenePipe {
  std::array<double, 3> direction{};  ///< of length 1
  std::array<double, 3> middle{};
  double radius = 0;
  double length = 0;
};

/// What a scene is made of.
struct SceneRecipe {
  std::string name;
  std::size_t points = 20000;
  std::size_t pipes = 5;
  /// Of these pipes, how many have a second one beside them, nearly parallel, half a radius away.
  std::size_t near_parallel = 0;
  /// Of these pipes, how many end in a quarter of a torus that leads into a second straight pipe.
  std::size_t elbows = 0;
  bool plane = false;
  bool sphere = false;
  /// Standard deviation across the surface, in radii.
  double noise = 0.01;
  /// Part of all points that is uniform in the box.
  double outliers = 0.3;
  double smallest_radius = 0.1;
  double largest_radius = 0.3;
  std::uint64_t seed = 1;
};

/// A cloud and the truth about it. The unit is the metre, the box has about ten of them in each direction.
struct PipeScene {
  SceneRecipe recipe;
  std::vector<std::array<double, 3>> points;
  std::vector<ScenePipe> pipes;
  /// For every point the index of its pipe, -1 for outliers and decoys.
  std::vector<int> labels;
  /// Three standard deviations of the noise on the thickest pipe.
  double distance = 0;
};

/// The scene follows from the recipe on every machine. Points are uniform on the surfaces, pipes do not touch each
/// other. Throws std::runtime_error when so many pipes do not fit into the box.
PipeScene pipe_scene(const SceneRecipe& recipe);

/// Twenty scenes: 1 to 20 pipes, elbows, near-parallel pipes, a plane and a sphere as decoys, 30 to 50 % outliers.
std::vector<SceneRecipe> acceptance_scenes();

/// 200,000 points, ten pipes, 1 % noise, 30 % outliers.
SceneRecipe speed_scene();

/// What a search found, compared with the truth: a cylinder is right when its direction is within 0.2 degrees of a
/// pipe's, its radius within 1 %, its axis within 2 % of the radius at the pipe's middle, and, with `ends`, its length
/// within a fifth plus two radii; each pipe counts once.
struct SceneScore {
  std::size_t right = 0;
  std::size_t found = 0;
  std::size_t pipes = 0;
  double worst_degrees = 0;
  double worst_radius = 0;

  double recall() const { return pipes == 0 ? 1 : static_cast<double>(right) / static_cast<double>(pipes); }
  double precision() const { return found == 0 ? 1 : static_cast<double>(right) / static_cast<double>(found); }
};

SceneScore score(const PipeScene& scene, const std::vector<ScenePipe>& found, bool ends = true);

}  // namespace eliminant::test
