// SPDX-License-Identifier: BSD-3-Clause
//
// eliminant's extraction of cylinders beside PCL's RANSAC with normals, on the generated scenes of the tests:
//   scripts/compare.sh cylinders [--first N] [--last N] [--limit SECONDS] [--threads N]
// Scenes 1 to 20 are those of the acceptance test, 21 has 200,000 points. PCL finds no ends: only its axes and radii
// are compared. Times are processor seconds of all threads.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>
#include <support/pipe_scenes.hpp>

#include "cylinder_solvers.hpp"

namespace eliminant::comparisons {

CylinderAnswer eliminant_cylinders(const test::PipeScene& scene, unsigned threads, double limit_seconds) {
  const std::clock_t start = std::clock();
  intersect::CylinderExtractionProblem problem;
  problem.points = scene.points;
  problem.distance = scene.distance;
  intersect::Options options;
  options.threads = threads;
  Context context;
  context.limit_seconds(limit_seconds);
  const intersect::CylinderExtractionResult result = intersect::extract_cylinders(problem, options, context);
  CylinderAnswer answer;
  for (const auto& cylinder : result.cylinders)
    answer.cylinders.push_back({cylinder.direction, cylinder.axis_point, cylinder.radius, cylinder.length});
  answer.stopped = result.status == intersect::Status::incomplete;
  answer.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return answer;
}

}  // namespace eliminant::comparisons

namespace {

using namespace eliminant;

std::string decoys(const test::SceneRecipe& recipe) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (recipe.near_parallel > 0) add(fmt::format("{} pairs near-parallel", recipe.near_parallel));
  if (recipe.elbows > 0) add(fmt::format("{} elbows", recipe.elbows));
  if (recipe.plane) add("plane");
  if (recipe.sphere) add("sphere");
  return text.empty() ? "-" : text;
}

std::string cells(const test::SceneScore& score, const comparisons::CylinderAnswer& answer) {
  return fmt::format("{} / {} | {}{:.1f}", score.right, score.found, answer.stopped ? "> " : "", answer.seconds);
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t first = 1;
  std::size_t last = 21;
  double limit = 60;
  unsigned threads = 2;
  CLI::App app("eliminant beside PCL in finding cylinders in point clouds");
  app.add_option("--first", first, "the first scene")->check(CLI::Range(1, 21));
  app.add_option("--last", last, "the last scene")->check(CLI::Range(1, 21));
  app.add_option("--limit", limit, "seconds for each search");
  app.add_option("--threads", threads, "of eliminant; PCL's search has one");
  CLI11_PARSE(app, argc, argv);
  std::vector<test::SceneRecipe> recipes = test::acceptance_scenes();
  recipes.push_back(test::speed_scene());
  fmt::print("| scene | points | outliers | besides | eliminant: right / found | s | PCL: right / found | s |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  std::fflush(stdout);
  for (std::size_t i = first - 1; i < std::min(last, recipes.size()); ++i) {
    const test::SceneRecipe& recipe = recipes[i];
    const test::PipeScene scene = test::pipe_scene(recipe);
    const auto own = comparisons::eliminant_cylinders(scene, threads, limit);
    const auto other = comparisons::pcl_cylinders(scene, limit);
    fmt::print("| {} pipes | {} | {:.0f} % | {} | {} | {} |\n", recipe.pipes, recipe.points, 100 * recipe.outliers,
               decoys(recipe), cells(test::score(scene, own.cylinders), own),
               cells(test::score(scene, other.cylinders, false), other));
    std::fflush(stdout);
  }
  return 0;
}
