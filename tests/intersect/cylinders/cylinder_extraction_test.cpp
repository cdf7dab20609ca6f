// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <eliminant/base/error.hpp>
#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>
#include <eliminant/numeric/splitmix64.hpp>
#include <limits>
#include <numbers>
#include <support/pipe_scenes.hpp>
#include <support/surface_scenes.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

CylinderExtractionResult extract(const PipeScene& scene, unsigned threads = 1, std::uint64_t seed = 0) {
  CylinderExtractionProblem problem;
  problem.points = scene.points;
  problem.distance = scene.distance;
  Options options;
  options.threads = threads;
  options.seed = seed;
  return extract_cylinders(problem, options, Context());
}

std::vector<ScenePipe> pipes_of(const CylinderExtractionResult& result) {
  std::vector<ScenePipe> found;
  for (const ExtractedCylinder& cylinder : result.cylinders)
    found.push_back({cylinder.direction, cylinder.axis_point, cylinder.radius, cylinder.length});
  return found;
}

SceneScore score_of(const PipeScene& scene, const CylinderExtractionResult& result) {
  return score(scene, pipes_of(result));
}

SceneRecipe small_scene(std::size_t pipes, std::uint64_t seed) {
  SceneRecipe recipe;
  recipe.pipes = pipes;
  recipe.points = 6000;
  recipe.seed = seed;
  return recipe;
}

bool same_numbers(const CylinderExtractionResult& a, const CylinderExtractionResult& b) {
  if (a.cylinders.size() != b.cylinders.size() || a.labels != b.labels) return false;
  for (std::size_t i = 0; i < a.cylinders.size(); ++i) {
    const ExtractedCylinder& c = a.cylinders[i];
    const ExtractedCylinder& d = b.cylinders[i];
    if (c.direction != d.direction || c.axis_point != d.axis_point || c.radius != d.radius || c.length != d.length ||
        c.residual != d.residual)
      return false;
  }
  return a.counts.samples == b.counts.samples;
}

// The points of a surface of nothing but `count` points, from two random numbers each.
template <class Surface>
CylinderExtractionProblem surface_cloud(std::size_t count, double distance, Surface surface) {
  eliminant::numeric::SplitMix64 random(17);
  CylinderExtractionProblem problem;
  problem.distance = distance;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = random.uniform();
    problem.points.push_back(surface(u, random.uniform(), distance / 3 * (2 * random.uniform() - 1)));
  }
  return problem;
}

constexpr double turn = 2 * std::numbers::pi;

}  // namespace

TEST_CASE("extract_cylinders: every pipe of small scenes, nothing else, for any number of threads") {
  for (const std::size_t pipes : {1, 3}) {
    const PipeScene scene = pipe_scene(small_scene(pipes, 40 + pipes));
    const CylinderExtractionResult result = extract(scene);
    CAPTURE(pipes);
    CHECK(result.status == Status::numeric);
    CHECK(result.confidence >= 0.99);
    const SceneScore found = score_of(scene, result);
    CHECK(found.right == pipes);
    CHECK(found.found == pipes);
    CHECK(same_numbers(result, extract(scene, 2)));
    CHECK(same_numbers(result, extract(scene, 5)));
  }
}

TEST_CASE("extract_cylinders: labels and counts agree with the truth and with each other") {
  const PipeScene scene = pipe_scene(small_scene(2, 51));
  const CylinderExtractionResult result = extract(scene);
  REQUIRE(result.cylinders.size() == 2);
  CHECK(result.cylinders[0].inliers >= result.cylinders[1].inliers);
  CHECK(result.counts.points == scene.points.size());
  CHECK(result.counts.on_cylinders == result.cylinders[0].inliers + result.cylinders[1].inliers);
  REQUIRE(result.labels.size() == scene.points.size());
  for (std::int32_t label = 0; label < 2; ++label)
    CHECK(static_cast<std::size_t>(std::count(result.labels.begin(), result.labels.end(), label)) ==
          result.cylinders[static_cast<std::size_t>(label)].inliers);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < scene.labels.size(); ++i) wrong += (scene.labels[i] >= 0) != (result.labels[i] >= 0);
  CHECK(wrong < scene.points.size() / 100);
}

TEST_CASE("extract_cylinders: near-parallel pipes stay two, an elbow is no pipe, half of the points are outliers") {
  SceneRecipe recipe = small_scene(4, 61);
  recipe.points = 12000;
  recipe.near_parallel = 1;
  recipe.elbows = 1;
  recipe.outliers = 0.5;
  const PipeScene scene = pipe_scene(recipe);
  const SceneScore found = score_of(scene, extract(scene, 2));
  CHECK(found.right == 4);
  CHECK(found.found == 4);
}

TEST_CASE("extract_cylinders: planes, spheres, cones and tori have no cylinders") {
  const auto plane = surface_cloud(3000, 0.02, [](double u, double v, double noise) {
    return std::array{4 * u, 4 * v, noise};
  });
  const auto sphere = surface_cloud(3000, 0.02, [](double u, double v, double noise) {
    const double z = 2 * u - 1;
    const double r = std::sqrt(1 - z * z);
    const double radius = 1 + noise;
    return std::array{radius * r * std::cos(turn * v), radius * r * std::sin(turn * v), radius * z};
  });
  const auto torus = surface_cloud(6000, 0.02, [](double u, double v, double noise) {
    const double r = 1.5 + (0.5 + noise) * std::cos(turn * v);
    return std::array{r * std::cos(turn * u), r * std::sin(turn * u), (0.5 + noise) * std::sin(turn * v)};
  });
  const auto cone = surface_cloud(4000, 0.02, [](double u, double v, double noise) {
    const double r = 0.2 + u + noise;
    return std::array{r * std::cos(turn * v), r * std::sin(turn * v), 2 * u};
  });
  for (const auto* problem : {&plane, &sphere, &torus, &cone}) {
    const CylinderExtractionResult result = extract_cylinders(*problem, {}, Context());
    CAPTURE(problem - &plane);
    CHECK(result.cylinders.empty());
    CHECK(result.counts.on_cylinders == 0);
  }
}

TEST_CASE("extract_cylinders: a cloud far from the origin, and half a pipe") {
  const double away = 5e6;
  const auto half = surface_cloud(2000, 0.03, [&](double u, double v, double noise) {
    const double angle = std::numbers::pi * v;
    return std::array{away + 5 * u, (1 + noise) * std::cos(angle) - away, (1 + noise) * std::sin(angle) + 1e5};
  });
  const CylinderExtractionResult result = extract_cylinders(half, {}, Context());
  REQUIRE(result.cylinders.size() == 1);
  const ExtractedCylinder& pipe = result.cylinders.front();
  CHECK(pipe.radius == doctest::Approx(1).epsilon(0.002));
  CHECK(pipe.direction[0] == doctest::Approx(1).epsilon(1e-5));
  CHECK(pipe.length == doctest::Approx(5).epsilon(0.01));
  CHECK(std::abs(pipe.axis_point[1] + away) < 0.01);
  CHECK(std::abs(pipe.axis_point[2] - 1e5) < 0.01);
  // Some at the very ends may be left out.
  CHECK(pipe.inliers >= 1990);
  CHECK(pipe.inliers <= 2000);
  // The noise is uniform up to 0.01.
  CHECK(pipe.residual == doctest::Approx(0.01 / std::sqrt(3)).epsilon(0.05));
}

TEST_CASE("extract_cylinders: no scale is special, and points without return do no harm") {
  const PipeScene scene = pipe_scene(small_scene(1, 41));
  const CylinderExtractionResult plain = extract(scene);
  REQUIRE(plain.cylinders.size() == 1);
  for (const int exponent : {-300, -70, 70, 300}) {
    PipeScene scaled = scene;
    scaled.distance = std::ldexp(scene.distance, exponent);
    for (auto& point : scaled.points)
      for (double& x : point) x = std::ldexp(x, exponent);
    const CylinderExtractionResult result = extract(scaled);
    CAPTURE(exponent);
    CHECK(result.labels == plain.labels);
    REQUIRE(result.cylinders.size() == 1);
    CHECK(result.cylinders[0].radius == std::ldexp(plain.cylinders[0].radius, exponent));
    CHECK(result.cylinders[0].direction == plain.cylinders[0].direction);
  }
  for (const double far : {1e15, 1e30, 1e300}) {
    PipeScene marked = scene;
    marked.points.push_back({far, 0, 0});
    marked.points.push_back({-far, far, 3});
    const CylinderExtractionResult result = extract(marked);
    CAPTURE(far);
    CHECK(score_of(scene, result).recall() == 1);
    CHECK(result.warnings.size() == 1);
    CHECK(result.labels.back() == -1);
  }
  PipeScene fine = scene;
  fine.distance = 1e-30;
  CHECK_THROWS_AS(extract(fine), InvalidInput);
}

TEST_CASE("extract_cylinders: radii outside the range, and too few points, are not reported") {
  CylinderExtractionProblem problem = surface_cloud(1000, 0.03, [](double u, double v, double noise) {
    return std::array{(1 + noise) * std::cos(turn * v), (1 + noise) * std::sin(turn * v), 4 * u};
  });
  CHECK(extract_cylinders(problem, {}, Context()).cylinders.size() == 1);
  problem.min_inliers = 1001;
  CHECK(extract_cylinders(problem, {}, Context()).cylinders.empty());
  problem.min_inliers.reset();
  problem.max_radius = 0.9;
  CHECK(extract_cylinders(problem, {}, Context()).cylinders.empty());
  problem.max_radius.reset();
  problem.min_radius = 1.1;
  CHECK(extract_cylinders(problem, {}, Context()).cylinders.empty());
}

TEST_CASE("extract_cylinders: inliers and residual are those of the cylinder printed, in noise too") {
  CylinderExtractionProblem problem;
  problem.distance = 0.01;
  problem.min_inliers = 10;
  eliminant::numeric::SplitMix64 random(3);
  for (int i = 0; i < 1000; ++i) problem.points.push_back({random.uniform(), random.uniform(), random.uniform()});
  const CylinderExtractionResult result = extract_cylinders(problem, {}, Context());
  REQUIRE_FALSE(result.cylinders.empty());
  for (std::size_t n = 0; n < result.cylinders.size(); ++n) {
    const ExtractedCylinder& cylinder = result.cylinders[n];
    std::size_t count = 0;
    double squares = 0;
    for (std::size_t i = 0; i < problem.points.size(); ++i) {
      if (result.labels[i] != static_cast<std::int32_t>(n)) continue;
      double height = 0;
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double apart = problem.points[i][k] - cylinder.axis_point[k];
        height += apart * cylinder.direction[k];
        square += apart * apart;
      }
      const double residual = std::sqrt(square - height * height) - cylinder.radius;
      CHECK(std::fabs(residual) <= problem.distance * (1 + 1e-9));
      CHECK(std::fabs(height) <= cylinder.length / 2 * (1 + 1e-9));
      squares += residual * residual;
      ++count;
    }
    CHECK(count == cylinder.inliers);
    CHECK(count >= 10);
    CHECK(cylinder.residual == doctest::Approx(std::sqrt(squares / static_cast<double>(count))));
  }
}

TEST_CASE("extract_cylinders: copies of points are no evidence, and are labelled like them") {
  CylinderExtractionProblem noise;
  noise.distance = 0.01;
  eliminant::numeric::SplitMix64 random(5);
  for (int i = 0; i < 300; ++i) {
    const std::array<double, 3> point{random.uniform(), random.uniform(), random.uniform()};
    noise.points.insert(noise.points.end(), 100, point);
  }
  const CylinderExtractionResult none = extract_cylinders(noise, {}, Context());
  CHECK(none.cylinders.empty());
  // 0.2 % of the different points are fewer.
  CHECK(none.min_inliers == 50);

  const PipeScene scene = pipe_scene(small_scene(2, 52));
  const CylinderExtractionResult once = extract(scene);
  PipeScene twice = scene;
  twice.points.insert(twice.points.end(), scene.points.begin(), scene.points.end());
  const CylinderExtractionResult result = extract(twice);
  REQUIRE(result.cylinders.size() == once.cylinders.size());
  for (std::size_t n = 0; n < once.cylinders.size(); ++n)
    CHECK(result.cylinders[n].inliers == 2 * once.cylinders[n].inliers);
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    CHECK(result.labels[i] == once.labels[i]);
    CHECK(result.labels[i + scene.points.size()] == once.labels[i]);
  }
}

TEST_CASE("extract_cylinders: clouds of no, few, equal and collinear points have no cylinders") {
  CylinderExtractionProblem problem;
  problem.distance = 0.1;
  CHECK(extract_cylinders(problem, {}, Context()).cylinders.empty());
  problem.points.assign(4, {1, 2, 3});
  CHECK(extract_cylinders(problem, {}, Context()).labels == std::vector<std::int32_t>(4, -1));
  problem.points.assign(500, {1, 2, 3});
  CHECK(extract_cylinders(problem, {}, Context()).cylinders.empty());
  for (std::size_t i = 0; i < problem.points.size(); ++i) problem.points[i] = {static_cast<double>(i), 0, 0};
  CHECK(extract_cylinders(problem, {}, Context()).cylinders.empty());
}

TEST_CASE("extract_cylinders: what cannot be a problem is refused") {
  CylinderExtractionProblem problem;
  problem.points.assign(10, {0, 0, 0});
  const auto refused = [&] { return extract_cylinders(problem, {}, Context()); };
  CHECK_THROWS_WITH_AS(refused(), "the distance is not positive", InvalidInput);
  problem.distance = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(refused(), InvalidInput);
  problem.distance = 1;
  problem.confidence = 1;
  CHECK_THROWS_WITH_AS(refused(), "the confidence is not between 0 and 1", InvalidInput);
  problem.confidence = 0.5;
  problem.min_radius = 3;
  problem.max_radius = 2;
  CHECK_THROWS_WITH_AS(refused(), "min_radius is larger than max_radius", InvalidInput);
  problem.max_radius.reset();
  problem.points[6][1] = std::nan("");
  CHECK_THROWS_WITH_AS(refused(), "point 7 is not finite", InvalidInput);
  problem.points[6] = {1e308, 1e308, 1e308};
  problem.points[5] = {-1e308, -1e308, -1e308};
  CHECK_THROWS_AS(refused(), InvalidInput);
}

TEST_CASE("extract_cylinders: a cancelled search gives what it has, marked incomplete") {
  const PipeScene scene = pipe_scene(small_scene(2, 71));
  CylinderExtractionProblem problem;
  problem.points = scene.points;
  problem.distance = scene.distance;
  Context context;
  int rounds = 0;
  context.on_progress([&](std::string_view) {
    if (++rounds == 2) context.cancel();
  });
  const CylinderExtractionResult result = extract_cylinders(problem, {}, context);
  CHECK(result.status == Status::incomplete);
  REQUIRE(result.limit);
  CHECK(result.limit->find("cancelled") == 0);
  CHECK(result.counts.samples == 4096);
  CHECK(score_of(scene, result).right == 2);
}

TEST_CASE("Decoy scenes: no cylinder along edges of planes, in elliptic cylinders and corrugated sheets") {
  std::vector<PipeScene> scenes = decoy_scenes();
  REQUIRE(scenes.size() == 9);
  if (std::getenv("ELIMINANT_ALL_FAMILIES") == nullptr) scenes = {scenes[0], scenes[5]};
  for (const PipeScene& scene : scenes) {
    CAPTURE(scene.recipe.name);
    CHECK(extract(scene, 2).cylinders.empty());
  }
}

TEST_CASE("Touching scenes: pipes on floors, in corners, at junctions, seen in part and slightly elliptic are found") {
  std::vector<PipeScene> scenes = touching_scenes();
  REQUIRE(scenes.size() == 8);
  if (std::getenv("ELIMINANT_ALL_FAMILIES") == nullptr) scenes.resize(4);
  for (const PipeScene& scene : scenes) {
    const SceneScore found = score(scene, pipes_of(extract(scene, 2)), false);
    CAPTURE(scene.recipe.name);
    CHECK(found.right == scene.pipes.size());
    CHECK(found.found == scene.pipes.size());
  }
}

TEST_CASE("Pipe scenes: every pipe of the acceptance scenes with recall and precision of 0.95") {
  std::vector<SceneRecipe> recipes = acceptance_scenes();
  REQUIRE(recipes.size() == 20);
  if (std::getenv("ELIMINANT_ALL_FAMILIES") == nullptr) recipes.resize(1);
  SceneScore total;
  for (const SceneRecipe& recipe : recipes) {
    const PipeScene scene = pipe_scene(recipe);
    const SceneScore found = score_of(scene, extract(scene, 2));
    CAPTURE(recipe.name);
    CHECK(found.recall() >= 0.8);
    total.right += found.right;
    total.found += found.found;
    total.pipes += found.pipes;
  }
  CHECK(total.recall() >= 0.95);
  CHECK(total.precision() >= 0.95);
}
