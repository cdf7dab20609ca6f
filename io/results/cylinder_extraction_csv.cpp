// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/cylinder_extraction_csv.hpp>

#include <eliminant/io/results/cylinder_extraction_words.hpp>

namespace eliminant::io {

std::string cylinder_extraction_csv(const intersect::CylinderExtractionResult& result, long digits) {
  std::string out = "direction_x,direction_y,direction_z,x,y,z,radius,length,inliers,residual\n";
  for (const intersect::ExtractedCylinder& cylinder : result.cylinders) {
    for (const double number : cylinder.direction) out += measured_text(number, digits) + ",";
    for (const double number : cylinder.axis_point) out += measured_text(number, digits) + ",";
    out += measured_text(cylinder.radius, digits) + "," + measured_text(cylinder.length, digits) + "," +
           std::to_string(cylinder.inliers) + "," + measured_text(cylinder.residual, digits) + "\n";
  }
  return out;
}

}  // namespace eliminant::io
