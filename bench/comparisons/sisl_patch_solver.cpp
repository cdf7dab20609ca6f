// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <memory>

#include "patch_solvers.hpp"
#include "sisl_patch.hpp"

namespace eliminant::comparisons {

namespace {

constexpr double tolerance = 1e-6;
constexpr double unused_tolerance = 0;
/// Steps as long as the tolerance allows.
constexpr double longest_step = 0;
constexpr int in_space_only = 1;
constexpr int undrawn = 0;
constexpr int samples = 400;

using Surface = std::shared_ptr<SISLSurf>;

/// What SISL allocates for an answer.
struct Answer {
  Answer() = default;
  Answer(const Answer&) = delete;
  Answer& operator=(const Answer&) = delete;
  ~Answer() {
    std::free(first);   // NOLINT: allocated by SISL
    std::free(second);  // NOLINT
    if (curves != nullptr) freeIntcrvlist(curves, curve_count);
  }

  int point_count = 0;
  double* first = nullptr;
  double* second = nullptr;
  int curve_count = 0;
  SISLIntcurve** curves = nullptr;
  int status = 0;
};

std::array<double, 3> point_of(SISLSurf* surface, const double* parameters) {
  std::array<double, 2> at{parameters[0], parameters[1]};
  std::array<double, 3> point{};
  std::array<double, 3> normal{};
  int left_within = 0;
  int left_across = 0;
  int status = 0;
  s1421(surface, 0, at.data(), &left_within, &left_across, point.data(), normal.data(), &status);
  return point;
}

/// The marched curve, or where there is none the points from which it was to start.
SpacePolyline sampled(SISLSurf* surface, const SISLIntcurve& intersection) {
  SpacePolyline polyline;
  SISLCurve* const curve = intersection.pgeom;
  if (curve == nullptr) {
    for (int i = 0; i < intersection.ipoint; ++i)
      polyline.push_back(point_of(surface, intersection.epar1 + static_cast<std::ptrdiff_t>(2 * i)));
    return polyline;
  }
  const double first = curve->et[curve->ik - 1];
  const double last = curve->et[curve->in];
  int left = 0;
  for (int i = 0; i <= samples; ++i) {
    std::array<double, 3> point{};
    int status = 0;
    s1227(curve, 0, first + (last - first) * i / samples, &left, point.data(), &status);
    if (status >= 0) polyline.push_back(point);
  }
  return polyline;
}

}  // namespace

PatchRun sisl_patches(const test::PatchCase& patches) {
  struct State {
    Surface first;
    Surface second;
    std::unique_ptr<Answer> answer;
  };
  const auto state = std::make_shared<State>(State{sisl_patch(patches.first), sisl_patch(patches.second), nullptr});
  const auto run = [state] {
    state->answer = std::make_unique<Answer>();
    Answer& answer = *state->answer;
    s1859(state->first.get(), state->second.get(), unused_tolerance, tolerance, &answer.point_count, &answer.first,
          &answer.second, &answer.curve_count, &answer.curves, &answer.status);
    for (int i = 0; i < answer.curve_count && answer.status >= 0; ++i) {
      int status = 0;
      s1310(state->first.get(), state->second.get(), answer.curves[i], tolerance, longest_step, in_space_only, undrawn,
            &status);
    }
  };
  const auto found = [state] {
    const Answer& answer = *state->answer;
    FoundPolylines result;
    result.complete = answer.status >= 0;
    if (!result.complete) return result;
    for (int i = 0; i < answer.point_count; ++i)
      result.polylines.push_back({point_of(state->first.get(), answer.first + static_cast<std::ptrdiff_t>(2 * i))});
    for (int i = 0; i < answer.curve_count; ++i)
      result.polylines.push_back(sampled(state->first.get(), *answer.curves[i]));
    return result;
  };
  return {run, found};
}

}  // namespace eliminant::comparisons
