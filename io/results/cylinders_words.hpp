// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/cylinders/cylinders.hpp>

namespace eliminant::io {

/// The bound of the residual, `1e-14`, or `0`.
std::string residual_text(const intersect::CylinderSolution& solution);

/// The form of the directions of infinitely many cylinders, in x, y, z; empty where there is none.
std::string directions_text(const intersect::CylindersResult& result);

}  // namespace eliminant::io
