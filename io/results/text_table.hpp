// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace eliminant::io {

/// Rows of cells, the first row the header, as aligned columns two blanks apart, each line indented by two blanks.
/// Numbers in `right_aligned` columns end at the same place.
std::string text_table(const std::vector<std::vector<std::string>>& rows, const std::vector<bool>& right_aligned);

/// Width of the widest line of such a table.
std::size_t table_width(const std::vector<std::vector<std::string>>& rows);

}  // namespace eliminant::io
