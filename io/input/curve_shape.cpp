// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/curve_shape.hpp>

namespace eliminant::io {

CurveShape shape_of(const intersect::CurveResult& result) {
  // What the first solution has, all have.
  const intersect::CurveSolution* const first = result.solutions.empty() ? nullptr : &result.solutions.front();
  const bool in_plane = result.in_plane || (first != nullptr && first->point.size() == 3);
  CurveShape shape;
  shape.t = !result.first_implicit && (first == nullptr || first->t);
  shape.itself = result.problem == "self_intersection";
  shape.u = (result.problem == "curve_curve" && !result.second_implicit && (first == nullptr || first->u)) ||
            (shape.itself && shape.t);
  shape.surface = result.problem == "curve_surface";
  shape.names = in_plane ? std::vector<std::string>{"x", "y", "w"} : std::vector<std::string>{"x", "y", "z", "w"};
  return shape;
}

}  // namespace eliminant::io
