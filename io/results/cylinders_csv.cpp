// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/cylinders_csv.hpp>

#include <eliminant/io/results/cylinders_words.hpp>
#include <eliminant/io/results/result_words.hpp>

namespace eliminant::io {

std::string cylinders_csv(const intersect::CylindersResult& result) {
  const auto cells = [](const intersect::Coordinate& coordinate) {
    return coordinate.real + "," + coordinate.imaginary + ",";
  };
  std::string out =
      "direction_x_re,direction_x_im,direction_y_re,direction_y_im,direction_z_re,direction_z_im,"
      "axis_x_re,axis_x_im,axis_y_re,axis_y_im,axis_z_re,axis_z_im,radius_squared_re,radius_squared_im,radius,"
      "direction_error,axis_error,radius_squared_error,radius_error,residual,real,multiplicity,certified\n";
  for (const intersect::CylinderSolution& solution : result.solutions) {
    for (const intersect::Coordinate& coordinate : solution.direction) out += cells(coordinate);
    for (const intersect::Coordinate& coordinate : solution.axis_point) out += cells(coordinate);
    out += cells(solution.radius_squared) + (solution.radius ? solution.radius->real : "") + ",";
    out += radius_text(solution.direction_error_exponent) + "," + radius_text(solution.axis_point_error_exponent) + ",";
    out += radius_text(solution.radius_squared_error_exponent) + ",";
    out += (solution.radius ? radius_text(solution.radius_error_exponent) : "") + ",";
    out += residual_text(solution) + "," + word_for(solution.reality) + ",";
    out += std::to_string(solution.multiplicity) + "," + (solution.certified ? "true" : "false") + "\n";
  }
  return out;
}

}  // namespace eliminant::io
