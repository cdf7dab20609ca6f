// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/cli/arguments.hpp>

namespace eliminant::cli {

/// Reads a result and writes its picture, SVG or HTML by the name of the output; or, where that fails, says why on
/// standard error. Returns the exit status. Throws io::OutputError.
int report(const Arguments& arguments);

}  // namespace eliminant::cli
