// SPDX-License-Identifier: BSD-3-Clause
#include <support/surface_scenes.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

#include <eliminant/numeric/splitmix64.hpp>

namespace eliminant::test {

namespace {

using Vector = std::array<double, 3>;

constexpr double turn = 2 * std::numbers::pi;
constexpr double noise = 0.004;

Vector plus(const Vector& a, double s, const Vector& b) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& a) { return plus({}, 1 / std::sqrt(dot(a, a)), a); }

// Where coordinates (u, v, along) are.
struct Place {
  Vector origin;
  Vector u;
  Vector v;
  Vector along;

  Vector at(const Vector& p) const { return plus(plus(plus(origin, p[0], u), p[1], v), p[2], along); }
};

Place place(const Vector& origin, const Vector& direction) {
  const Vector along = unit(direction);
  const Vector u = unit(cross(along, std::abs(along[0]) < 0.9 ? Vector{1, 0, 0} : Vector{0, 1, 0}));
  return {origin, u, cross(along, u), along};
}

bool is_inside(const Vector& point, const Place& axis, double radius, double length) {
  const Vector from = plus(point, -1, axis.origin);
  const double height = dot(from, axis.along);
  const Vector across = plus(from, -height, axis.along);
  return std::abs(height) < length / 2 && dot(across, across) < radius * radius;
}

const Vector skew{0.3, -0.5, 0.8};

class SceneBuilder {
 public:
  SceneBuilder(std::string name, std::uint64_t seed) : random_(seed) {
    scene_.recipe.name = std::move(name);
    scene_.distance = 3 * noise;
  }

  double uniform(double low, double high) { return low + (high - low) * random_.uniform(); }
  bool toss() { return random_.below(2) == 0; }

  void add(const Vector& point, int label = -1) {
    Vector moved = point;
    for (double& x : moved) x += noise * normal();
    scene_.points.push_back(moved);
    scene_.labels.push_back(label);
  }

  // `count` points that `surface` draws in the coordinates of the place.
  void surface(int count, const Place& at, const std::function<Vector()>& surface) {
    for (int i = 0; i < count; ++i) add(at.at(surface()));
  }

  // A pipe whose axis is that of the place; what `hidden` says is left out.
  void pipe(int count, const Place& at, double radius, double length, double seen = turn,
            const std::function<bool(const Vector&)>& hidden = {}) {
    const int label = static_cast<int>(scene_.pipes.size());
    scene_.pipes.push_back({at.along, at.origin, radius, length});
    for (int i = 0; i < count; ++i) {
      const double angle = uniform(0, seen);
      const Vector point =
          at.at({radius * std::cos(angle), radius * std::sin(angle), uniform(-length / 2, length / 2)});
      if (!hidden || !hidden(point)) add(point, label);
    }
  }

  void outliers(int count) {
    for (int i = 0; i < count; ++i) {
      scene_.points.push_back({uniform(-4, 4), uniform(-4, 4), uniform(-4, 4)});
      scene_.labels.push_back(-1);
    }
  }

  PipeScene scene() { return std::move(scene_); }
  PipeScene& unfinished() { return scene_; }

 private:
  double normal() { return std::sqrt(-2 * std::log(1 - random_.uniform())) * std::cos(turn * random_.uniform()); }

  numeric::SplitMix64 random_;
  PipeScene scene_;
};

PipeScene box(const std::string& name, std::uint64_t seed, const Vector& direction, int outliers) {
  SceneBuilder scene(name, seed);
  scene.surface(6000, place({}, direction), [&] {
    Vector point{scene.uniform(-2, 2), scene.uniform(-2, 2), scene.uniform(-2, 2)};
    point[static_cast<std::size_t>(scene.uniform(0, 3))] = scene.toss() ? 2 : -2;
    return point;
  });
  scene.outliers(outliers);
  return scene.scene();
}

// Two planes of width 0.4 that meet under an angle.
PipeScene profile(const std::string& name, std::uint64_t seed, double angle) {
  SceneBuilder scene(name, seed);
  scene.surface(5000, place({}, skew), [&] {
    const double x = scene.uniform(0, 0.4);
    const double height = scene.uniform(-2, 2);
    return scene.toss() ? Vector{x, 0, height} : Vector{x * std::cos(angle), x * std::sin(angle), height};
  });
  scene.outliers(500);
  return scene.scene();
}

PipeScene square_beam(const std::string& name, std::uint64_t seed) {
  SceneBuilder scene(name, seed);
  constexpr double half = 0.15;
  scene.surface(6000, place({}, skew), [&] {
    const double x = scene.uniform(-half, half);
    const double height = scene.uniform(-2, 2);
    const double side = scene.toss() ? half : -half;
    return scene.toss() ? Vector{x, side, height} : Vector{side, x, height};
  });
  scene.outliers(500);
  return scene.scene();
}

void elliptic_cylinder(SceneBuilder& scene, double radius, double ratio) {
  const double b = radius / std::sqrt(ratio);
  scene.surface(4000, place({}, skew), [&] {
    const double angle = scene.uniform(0, turn);
    return Vector{ratio * b * std::cos(angle), b * std::sin(angle), scene.uniform(-2, 2)};
  });
  scene.outliers(500);
}

PipeScene ellipse(const std::string& name, std::uint64_t seed, double ratio) {
  SceneBuilder scene(name, seed);
  elliptic_cylinder(scene, 0.5, ratio);
  return scene.scene();
}

PipeScene corrugated_sheet(const std::string& name, std::uint64_t seed) {
  SceneBuilder scene(name, seed);
  scene.surface(8000, place({}, skew), [&] {
    const double x = scene.uniform(-1.5, 1.5);
    return Vector{x, scene.uniform(-1.5, 1.5), 0.3 * std::sin(6 * x)};
  });
  scene.outliers(500);
  return scene.scene();
}

PipeScene third_of_a_pipe(const std::string& name, std::uint64_t seed) {
  SceneBuilder scene(name, seed);
  scene.pipe(3000, place({}, skew), 0.4, 4, turn / 3);
  scene.outliers(800);
  return scene.scene();
}

PipeScene mild_ellipse(const std::string& name, std::uint64_t seed) {
  SceneBuilder scene(name, seed);
  elliptic_cylinder(scene, 0.3, 1.04);
  scene.unfinished().pipes.push_back({unit(skew), {}, 0.3, 4});
  return scene.scene();
}

PipeScene pipe_on_floor(const std::string& name, std::uint64_t seed) {
  SceneBuilder scene(name, seed);
  scene.pipe(3000, place({0, 0, 0.2}, {1, 0.2, 0}), 0.2, 4);
  scene.surface(8000, place({}, {0, 0, 1}), [&] {
    return Vector{scene.uniform(-2.5, 2.5), scene.uniform(-2.5, 2.5), 0};
  });
  scene.outliers(800);
  return scene.scene();
}

// A pipe that touches a floor and a wall, all around or, with `shadow`, on the side that is not between them.
PipeScene pipe_in_corner(const std::string& name, std::uint64_t seed, bool shadow) {
  SceneBuilder scene(name, seed);
  constexpr double radius = 0.2;
  const auto hidden = [&](const Vector& point) { return shadow && point[1] + point[2] < 2 * radius; };
  scene.pipe(3000, place({0, radius, radius}, {1, 0, 0}), radius, 4, turn, hidden);
  for (int i = 0; i < 9000; ++i) {
    const double x = scene.uniform(-2.5, 2.5);
    const double away = scene.uniform(shadow ? 1.7 * radius : 0, 2.5);
    scene.add(scene.toss() ? Vector{x, away, 0} : Vector{x, 0, away});
  }
  scene.outliers(800);
  return scene.scene();
}

// A branch leaves a pipe at a right angle; neither goes on inside the other.
PipeScene junction(const std::string& name, std::uint64_t seed, double branch_radius) {
  SceneBuilder scene(name, seed);
  constexpr double radius = 0.3;
  constexpr double length = 2.2;
  const Place main = place({}, skew);
  const Place branch = place(plus({}, length / 2, main.u), main.u);
  scene.pipe(4000, main, radius, 4, turn,
             [&](const Vector& point) { return is_inside(point, branch, branch_radius, length); });
  const int count = static_cast<int>(4000 * branch_radius * length / (radius * 4));
  scene.pipe(count, branch, branch_radius, length, turn,
             [&](const Vector& point) { return is_inside(point, main, radius, 4); });
  ScenePipe& seen = scene.unfinished().pipes.back();
  seen.length = length - radius;
  seen.middle = plus({}, (length + radius) / 2, main.u);
  scene.outliers(1000);
  return scene.scene();
}

// Pipes between a wall and a scanner 3 m away, by rays of equal angles; coordinates of millions of metres.
PipeScene scan(const std::string& name, std::uint64_t seed) {
  SceneBuilder scene(name, seed);
  PipeScene& built = scene.unfinished();
  const Vector grid{4.5e5, 5.4e6, 120};
  for (int k = 0; k < 3; ++k)
    built.pipes.push_back({unit({0, 0.2 * k, 1}), {2.6 - 0.2 * k, 1.2 * (k - 1), 0}, 0.25 - 0.05 * k, 2.4});
  constexpr int steps = 240;
  for (int i = -steps / 2; i < steps / 2; ++i)
    for (int j = -steps / 2; j < steps / 2; ++j) {
      const Vector ray = unit({1, i * 1.4 / steps, j * 1.0 / steps});
      double nearest = 3 / ray[0];
      int label = -1;
      for (std::size_t k = 0; k < built.pipes.size(); ++k) {
        const ScenePipe& pipe = built.pipes[k];
        const Vector from = plus({}, -1, pipe.middle);
        const Vector d = plus(ray, -dot(ray, pipe.direction), pipe.direction);
        const Vector e = plus(from, -dot(from, pipe.direction), pipe.direction);
        const double b = dot(d, e);
        const double discriminant = b * b - dot(d, d) * (dot(e, e) - pipe.radius * pipe.radius);
        if (discriminant < 0) continue;
        const double way = (-b - std::sqrt(discriminant)) / dot(d, d);
        if (way >= nearest || std::abs(dot(plus(from, way, ray), pipe.direction)) > pipe.length / 2) continue;
        nearest = way;
        label = static_cast<int>(k);
      }
      scene.add(plus({}, nearest, ray), label);
    }
  for (Vector& point : built.points) point = plus(point, 1, grid);
  for (ScenePipe& pipe : built.pipes) pipe.middle = plus(pipe.middle, 1, grid);
  return scene.scene();
}

}  // namespace

std::vector<PipeScene> decoy_scenes() {
  return {
      box("upright box", 1, {0, 0, 1}, 0),   box("turned box", 2, skew, 500), profile("angle profile", 3, turn / 4),
      profile("blunt profile", 4, turn / 3), square_beam("square beam", 5),   ellipse("ellipse 1.2", 6, 1.2),
      ellipse("ellipse 1.5", 7, 1.5),        ellipse("ellipse 2", 8, 2),      corrugated_sheet("corrugated sheet", 9)};
}

std::vector<PipeScene> touching_scenes() {
  return {junction("junction 0.3", 20, 0.3),
          junction("junction 0.15", 21, 0.15),
          third_of_a_pipe("third of a pipe", 22),
          mild_ellipse("ellipse 1.04", 23),
          pipe_on_floor("pipe on a floor", 24),
          pipe_in_corner("pipe in a corner", 25, false),
          pipe_in_corner("pipe in a corner, seen in part", 26, true),
          scan("scan of a wall", 27)};
}

}  // namespace eliminant::test
