// SPDX-License-Identifier: BSD-3-Clause
#include <support/pipe_scenes.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <eliminant/numeric/splitmix64.hpp>

namespace eliminant::test {

namespace {

using Vector = std::array<double, 3>;

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vector& a) { return std::sqrt(dot(a, a)); }
Vector unit(const Vector& a) { return 1 / length(a) * a; }
Vector normal_to(const Vector& a) {
  const Vector other = std::abs(a[0]) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  return unit(cross(a, other));
}

constexpr double half_box = 5;
constexpr double bend_in_radii = 3;  // radius of an elbow's axis

// A quarter of a torus from `start`, where the axis has the direction `along`, turning to `toward`.
struct Elbow {
  Vector start;
  Vector along;
  Vector toward;
  double radius;
};

// Distance of two segments, by looking at points of both: good enough to keep pipes apart.
double distance_between(const ScenePipe& a, const ScenePipe& b) {
  double least = 1e300;
  for (int i = -20; i <= 20; ++i) {
    const Vector point = a.middle + (a.length * i / 40) * a.direction;
    const double at = std::clamp(dot(point - b.middle, b.direction), -b.length / 2, b.length / 2);
    least = std::min(least, length(point - b.middle - at * b.direction));
  }
  return least;
}

class Builder {
 public:
  explicit Builder(const SceneRecipe& recipe) : random_(recipe.seed) { scene_.recipe = recipe; }

  PipeScene build() {
    place_pipes();
    scatter();
    return std::move(scene_);
  }

 private:
  double uniform(double low, double high) { return low + (high - low) * random_.uniform(); }
  // Box and Muller.
  double normal() {
    return std::sqrt(-2 * std::log(1 - random_.uniform())) * std::cos(2 * std::numbers::pi * random_.uniform());
  }
  Vector direction() {
    const double z = uniform(-1, 1);
    const double turn = uniform(0, 2 * std::numbers::pi);
    return {std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z};
  }

  static bool is_inside(const ScenePipe& pipe) {
    for (const double end : {-0.5, 0.5}) {
      const Vector point = pipe.middle + end * pipe.length * pipe.direction;
      for (const double x : point)
        if (std::abs(x) > half_box - pipe.radius) return false;
    }
    return true;
  }

  bool is_free(const ScenePipe& pipe) const {
    return is_inside(pipe) && std::all_of(scene_.pipes.begin(), scene_.pipes.end(), [&](const ScenePipe& other) {
             return distance_between(pipe, other) > 1.5 * (pipe.radius + other.radius);
           });
  }

  void place_pipes() {
    const SceneRecipe& recipe = scene_.recipe;
    std::size_t parallel = recipe.near_parallel;
    std::size_t elbows = recipe.elbows;
    for (int attempt = 0; scene_.pipes.size() < recipe.pipes; ++attempt) {
      if (attempt > 100000) throw std::runtime_error("so many pipes do not fit into the box");
      ScenePipe pipe;
      pipe.radius = uniform(recipe.smallest_radius, recipe.largest_radius);
      pipe.length = std::min(uniform(6, 20) * pipe.radius, 5.0);
      pipe.direction = direction();
      pipe.middle = {uniform(-4, 4), uniform(-4, 4), uniform(-4, 4)};
      if (!is_free(pipe)) continue;
      const bool room = scene_.pipes.size() + 2 <= recipe.pipes;
      if (room && parallel > 0) {
        if (!place_beside(pipe)) continue;
        --parallel;
      } else if (room && elbows > 0) {
        if (!place_elbow(pipe)) continue;
        --elbows;
      } else {
        scene_.pipes.push_back(pipe);
      }
    }
  }

  bool place_beside(const ScenePipe& pipe) {
    ScenePipe beside = pipe;
    const Vector aside = normal_to(pipe.direction);
    beside.middle = pipe.middle + 2.5 * pipe.radius * aside;
    beside.direction = unit(pipe.direction + uniform(-0.02, 0.02) * cross(pipe.direction, aside));
    beside.radius = pipe.radius * uniform(0.9, 1);
    if (!is_free(beside)) {
      if (!is_inside(beside)) return false;
      for (const ScenePipe& other : scene_.pipes)
        if (distance_between(beside, other) <= 1.5 * (beside.radius + other.radius)) return false;
    }
    scene_.pipes.push_back(pipe);
    scene_.pipes.push_back(beside);
    return true;
  }

  bool place_elbow(const ScenePipe& pipe) {
    const double bend = bend_in_radii * pipe.radius;
    const Elbow elbow{pipe.middle + pipe.length / 2 * pipe.direction, pipe.direction, normal_to(pipe.direction),
                      pipe.radius};
    ScenePipe after = pipe;
    after.direction = elbow.toward;
    after.length = pipe.length * uniform(0.6, 1);
    after.middle = elbow.start + bend * elbow.along + (bend + after.length / 2) * elbow.toward;
    if (!is_free(after)) return false;
    scene_.pipes.push_back(pipe);
    scene_.pipes.push_back(after);
    elbows_.push_back(elbow);
    return true;
  }

  void add(const Vector& point, int label) {
    scene_.points.push_back(point);
    scene_.labels.push_back(label);
  }

  Vector on_pipe(const ScenePipe& pipe) {
    const Vector u = normal_to(pipe.direction);
    const Vector v = cross(pipe.direction, u);
    const double turn = uniform(0, 2 * std::numbers::pi);
    const double radius = pipe.radius * (1 + scene_.recipe.noise * normal());
    return pipe.middle + uniform(-0.5, 0.5) * pipe.length * pipe.direction + radius * std::cos(turn) * u +
           radius * std::sin(turn) * v;
  }

  // Uniform on the torus: a point is kept with the probability of its distance from the axis of rotation.
  Vector on_elbow(const Elbow& elbow) {
    const double bend = bend_in_radii * elbow.radius;
    const Vector center = elbow.start + bend * elbow.toward;
    const Vector side = cross(elbow.along, elbow.toward);
    while (true) {
      const double bent = uniform(0, std::numbers::pi / 2);
      const double turn = uniform(0, 2 * std::numbers::pi);
      const Vector outward = std::sin(bent) * elbow.along - std::cos(bent) * elbow.toward;
      if (uniform(0, bend + elbow.radius) > bend + elbow.radius * std::cos(turn)) continue;
      const double radius = elbow.radius * (1 + scene_.recipe.noise * normal());
      return center + (bend + radius * std::cos(turn)) * outward + radius * std::sin(turn) * side;
    }
  }

  // As many points for each surface as its area says.
  void scatter() {
    const SceneRecipe& recipe = scene_.recipe;
    double largest = 0;
    std::vector<double> areas;
    for (const ScenePipe& pipe : scene_.pipes) {
      areas.push_back(2 * std::numbers::pi * pipe.radius * pipe.length);
      largest = std::max(largest, pipe.radius);
    }
    for (const Elbow& elbow : elbows_)
      areas.push_back(std::numbers::pi * std::numbers::pi * bend_in_radii * elbow.radius * elbow.radius);
    const double plane_area = recipe.plane ? 16 : 0;
    const double sphere_radius = 1;
    const double sphere_area = recipe.sphere ? 4 * std::numbers::pi * sphere_radius * sphere_radius : 0;
    double total = plane_area + sphere_area;
    for (const double area : areas) total += area;
    const double sigma = recipe.noise * largest;
    scene_.distance = 3 * sigma;
    const Vector sphere_center{uniform(-3, 3), uniform(-3, 3), uniform(-3, 3)};
    const Vector plane_center{0, 0, -half_box};
    for (std::size_t i = 0; i < recipe.points; ++i) {
      if (random_.uniform() < recipe.outliers) {
        add({uniform(-half_box, half_box), uniform(-half_box, half_box), uniform(-half_box, half_box)}, -1);
        continue;
      }
      double where = uniform(0, total);
      std::size_t part = 0;
      while (part < areas.size() && where >= areas[part]) where -= areas[part++];
      if (part < scene_.pipes.size())
        add(on_pipe(scene_.pipes[part]), static_cast<int>(part));
      else if (part < areas.size())
        add(on_elbow(elbows_[part - scene_.pipes.size()]), -1);
      else if (where < plane_area)
        add(plane_center + Vector{uniform(-2, 2), uniform(-2, 2), sigma * normal()}, -1);
      else
        add(sphere_center + (sphere_radius + sigma * normal()) * direction(), -1);
    }
  }

  numeric::SplitMix64 random_;
  PipeScene scene_;
  std::vector<Elbow> elbows_;
};

bool is_right(const ScenePipe& pipe, const ScenePipe& found, bool ends, double& degrees, double& radius) {
  degrees = std::asin(std::min(1.0, length(cross(pipe.direction, unit(found.direction))))) * 180 / std::numbers::pi;
  radius = std::abs(found.radius - pipe.radius) / pipe.radius;
  const Vector direction = unit(found.direction);
  const Vector across = cross(pipe.middle - found.middle, direction);
  const bool same_axis = degrees <= 0.2 && radius <= 0.01 && length(across) <= 0.02 * pipe.radius;
  const bool same_ends = std::abs(dot(pipe.middle - found.middle, direction)) <= 0.1 * pipe.length + pipe.radius &&
                         std::abs(found.length - pipe.length) <= 0.2 * pipe.length + 2 * pipe.radius;
  return same_axis && (same_ends || !ends);
}

}  // namespace

PipeScene pipe_scene(const SceneRecipe& recipe) { return Builder(recipe).build(); }

std::vector<SceneRecipe> acceptance_scenes() {
  std::vector<SceneRecipe> scenes;
  for (std::size_t n = 1; n <= 20; ++n) {
    SceneRecipe recipe;
    recipe.pipes = n;
    recipe.points = 20000 + 4000 * n;
    recipe.near_parallel = n % 3 == 2 ? 1 + n / 8 : 0;
    recipe.elbows = n % 3 == 0 ? 1 + n / 6 : 0;
    recipe.plane = n % 2 == 0;
    recipe.sphere = n % 4 >= 2;
    recipe.outliers = 0.3 + 0.1 * static_cast<double>(n % 3);
    recipe.seed = 1000 + n;
    recipe.name = std::to_string(n) + " pipes";
    scenes.push_back(recipe);
  }
  return scenes;
}

SceneRecipe speed_scene() {
  SceneRecipe recipe;
  recipe.name = "200000 points";
  recipe.points = 200000;
  recipe.pipes = 10;
  recipe.seed = 7;
  return recipe;
}

SceneScore score(const PipeScene& scene, const std::vector<ScenePipe>& found, bool ends) {
  SceneScore result;
  result.pipes = scene.pipes.size();
  result.found = found.size();
  std::vector<bool> used(found.size(), false);
  for (const ScenePipe& pipe : scene.pipes)
    for (std::size_t i = 0; i < found.size(); ++i) {
      double degrees = 0;
      double radius = 0;
      if (used[i] || !is_right(pipe, found[i], ends, degrees, radius)) continue;
      used[i] = true;
      ++result.right;
      result.worst_degrees = std::max(result.worst_degrees, degrees);
      result.worst_radius = std::max(result.worst_radius, radius);
      break;
    }
  return result;
}

}  // namespace eliminant::test
