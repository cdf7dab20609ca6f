// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>

namespace eliminant::io {

/// One line for each cylinder, below
/// `direction_x,direction_y,direction_z,x,y,z,radius,length,inliers,residual`.
std::string cylinder_extraction_csv(const intersect::CylinderExtractionResult& result, long digits);

}  // namespace eliminant::io
