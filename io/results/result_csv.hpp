// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/result.hpp>

namespace eliminant::io {

/// One line for each solution under the header x_re,x_im,y_re,y_im,radius,real,multiplicity,certified. `real` is true,
/// false or undecided. What a table cannot hold (status, counts, the common component) is only in the other formats.
std::string result_csv(const intersect::Result& result);

}  // namespace eliminant::io
