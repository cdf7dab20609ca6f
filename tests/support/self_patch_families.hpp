// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <support/patch_case.hpp>
#include <support/patch_oracle.hpp>

/// Bicubic patches with known double curves, and embedded ones.
namespace eliminant::test {

/// The double points of a patch that takes points twice by one involution of its parameters: a plane curve that has
/// each pair once, with a side of its box for fixed points of the involution, the pinch points.
struct PairedSheets {
  enum class Involution {
    fold,     ///< (u, v) -> (2 c - u, v); the curve is in (u, v), u >= c
    exchange  ///< (u, v) -> (v, u); the curve is in (u, v / u), v <= u
  };

  Involution involution = Involution::fold;
  PlaneCurve half;
  double centre = 0.5;  ///< c

  /// Both pairs of parameters of a double point.
  std::array<double, 4> parameters(const std::array<double, 2>& on_half) const;
  bool is_pinch_point(const std::array<double, 2>& on_half) const;
};

struct SelfPatchCase {
  PatchCase patches;
  std::optional<PairedSheets> sheets;
  /// Each lies on three arcs, which are counted as going through it.
  unsigned long triple_points = 0;
};

/// Twenty patches that meet themselves (from edge to edge, in loops, with pinch points, with a triple point) and twenty
/// embedded ones; the same at every run.
std::vector<SelfPatchCase> self_patch_cases();
std::vector<SelfPatchCase> self_patch_cases(const std::string& family);

/// The arcs and loops of the double curve, each once, with the pinch and triple points as singular ones. The components
/// are in the parameters of `sheets`, where there are any.
TrueIntersection true_self_intersection(const SelfPatchCase& patch);

}  // namespace eliminant::test
