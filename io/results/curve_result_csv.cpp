// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/curve_result_csv.hpp>

#include <array>

#include <eliminant/io/input/curve_shape.hpp>
#include <eliminant/io/results/result_words.hpp>

namespace eliminant::io {

namespace {

constexpr std::array surface_names{"a", "b", "c"};

std::string columns(const std::string& name) { return name + "_re," + name + "_im,"; }

std::string header(const CurveShape& shape, bool two_curves) {
  std::string line = columns("t");
  if (two_curves) line += columns("u");
  for (const std::string& name : shape.names) line += columns(name);
  line += "radius,real,multiplicity,inside,certified,";
  if (shape.surface)
    for (const char* name : surface_names) line += columns(name);
  if (shape.itself) line += "kind,";
  line.back() = '\n';
  return line;
}

std::string coordinate_cells(const intersect::Coordinate& coordinate) {
  return coordinate.real + "," + coordinate.imaginary + ",";
}

// What is absent has empty cells.
std::string parameter_cells(const std::optional<intersect::Parameter>& parameter) {
  if (!parameter) return ",,";
  return *parameter ? coordinate_cells(**parameter) : "inf,0,";
}

const char* word(bool value) { return value ? "true" : "false"; }

}  // namespace

std::string curve_result_csv(const intersect::CurveResult& result) {
  const CurveShape shape = shape_of(result);
  const bool two_curves = result.problem != "curve_surface";
  std::string out = header(shape, two_curves);
  for (const intersect::CurveSolution& solution : result.solutions) {
    std::string line = parameter_cells(solution.t);
    if (two_curves) line += parameter_cells(solution.u);
    for (const intersect::Coordinate& coordinate : solution.point) line += coordinate_cells(coordinate);
    line += radius_text(solution.radius_exponent) + "," + word_for(solution.reality) + ",";
    line += std::to_string(solution.multiplicity) + "," + word(solution.inside) + "," + word(solution.certified) + ",";
    if (shape.surface)
      for (std::size_t i = 0; i < surface_names.size(); ++i) {
        const bool there = !solution.surface_parameters.empty() && i < solution.surface_parameters.front().size();
        line += there ? parameter_cells(solution.surface_parameters.front()[i]) : ",,";
      }
    if (shape.itself) line += std::string(solution.kind ? word_for(*solution.kind) : "") + ",";
    line.back() = '\n';
    out += line;
  }
  return out;
}

}  // namespace eliminant::io
