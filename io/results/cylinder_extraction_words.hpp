// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace eliminant::io {

/// A measured number with that many significant digits, 17 at most: more a double does not have.
std::string measured_text(double value, long digits);

}  // namespace eliminant::io
