// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/surface_result_words.hpp>

#include <algorithm>
#include <cmath>
#include <variant>

#include <eliminant/io/results/curve_topology_words.hpp>

namespace eliminant::io {

namespace {

using intersect::BranchEndKind;
using intersect::SurfaceComponentKind;
using intersect::SurfaceSingularity;
using intersect::Transition;
using symbolic::ComponentKind;
using symbolic::DeterminantVanishing;

// Of the two parameters of a surface that begin at `index`.
void add_domains(SurfaceDomains& domains, std::size_t index, const symbolic::ParametricSurface& surface) {
  for (const symbolic::SurfacePiece& piece : surface.pieces) {
    if (!piece.region) return;
    for (std::size_t direction = 0; direction < 2; ++direction) {
      const symbolic::Interval& side = piece.region->sides[direction];
      std::optional<symbolic::Interval>& domain = domains[index + direction];
      if (!domain) domain = side;
      if (side.lower < domain->lower) domain->lower = side.lower;
      if (domain->upper < side.upper) domain->upper = side.upper;
    }
  }
}

}  // namespace

SurfaceDomains domains_of(const intersect::SurfaceSurfaceProblem& problem) {
  SurfaceDomains domains;
  if (const auto* first = std::get_if<symbolic::ParametricSurface>(&problem.first)) add_domains(domains, 0, *first);
  if (const auto* second = std::get_if<symbolic::ParametricSurface>(&problem.second)) add_domains(domains, 2, *second);
  return domains;
}

SurfaceDomains domains_of(const intersect::SurfaceSelfIntersectionProblem& problem) {
  SurfaceDomains domains;
  add_domains(domains, 0, problem.surface);
  add_domains(domains, 2, problem.surface);
  return domains;
}

const char* word_for(SurfaceComponentKind kind) {
  switch (kind) {
    case SurfaceComponentKind::curve:
      return "curve";
    case SurfaceComponentKind::loop:
      return "loop";
    case SurfaceComponentKind::point:
      return "point";
    case SurfaceComponentKind::overlap:
      return "overlap";
  }
  return "curve";
}

const char* word_for(BranchEndKind kind) {
  switch (kind) {
    case BranchEndKind::border:
      return "border";
    case BranchEndKind::singular:
      return "singular_point";
    case BranchEndKind::infinity:
      return "infinity";
    case BranchEndKind::unknown:
      return "unknown";
  }
  return "unknown";
}

const char* word_for(Transition transition) {
  switch (transition) {
    case Transition::out:
      return "out";
    case Transition::in:
      return "in";
    case Transition::touching:
      return "touching";
  }
  return "touching";
}

const char* word_for(SurfaceSingularity kind) {
  switch (kind) {
    case SurfaceSingularity::contact:
      return "contact";
    case SurfaceSingularity::crossing:
      return "crossing";
    case SurfaceSingularity::cusp:
      return "cusp";
    case SurfaceSingularity::pinch_point:
      return "pinch_point";
    case SurfaceSingularity::triple_point:
      return "triple_point";
    case SurfaceSingularity::undecided:
      return "undecided";
  }
  return "undecided";
}

const char* word_for(ComponentKind kind) {
  switch (kind) {
    case ComponentKind::curve:
      return "curve";
    case ComponentKind::base_point:
      return "base_point";
    case ComponentKind::at_infinity:
      return "at_infinity";
    case ComponentKind::contracted_curve:
      return "contracted_curve";
    case ComponentKind::coincident_parameters:
      return "coincident_parameters";
  }
  return "curve";
}

const char* word_for(DeterminantVanishing vanishing) {
  switch (vanishing) {
    case DeterminantVanishing::no:
      return "no";
    case DeterminantVanishing::no_surface:
      return "no_surface";
    case DeterminantVanishing::overlap:
      return "overlap";
    case DeterminantVanishing::many_to_one:
      return "many_to_one";
    case DeterminantVanishing::contracted:
      return "contracted";
  }
  return "no";
}

std::vector<std::string> border_words(const intersect::BranchEnd& end) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < parameter_names.size(); ++i) {
    if (end.side[i] != 0) words.push_back(std::string(parameter_names[i]) + (end.side[i] < 0 ? "=lower" : "=upper"));
    if (i % 2 == 1 && end.third_side[i / 2]) words.emplace_back(i == 1 ? "u+v=upper" : "s+t=upper");
  }
  return words;
}

std::array<double, 7> values_of(const intersect::SurfacePoint& point) {
  std::array<double, 7> values{};
  std::copy(point.parameters.begin(), point.parameters.end(), values.begin());
  std::copy(point.point.begin(), point.point.end(), values.begin() + 4);
  return values;
}

std::string parameter_text(double value) { return coordinate_text(std::isinf(value) ? INFINITY : value); }

std::string coordinate_text(double value) {
  if (std::isnan(value)) return "";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  return value == 0 ? "0" : double_text(value);
}

}  // namespace eliminant::io
