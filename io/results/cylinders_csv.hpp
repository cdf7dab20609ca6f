// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/cylinders/cylinders.hpp>

namespace eliminant::io {

/// Cylinders through five points, one line each (docs/formats.md).
std::string cylinders_csv(const intersect::CylindersResult& result);

}  // namespace eliminant::io
