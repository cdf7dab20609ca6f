// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/cylinder_extraction_words.hpp>

#include <fmt/format.h>
#include <algorithm>

namespace eliminant::io {

std::string measured_text(double value, long digits) {
  return fmt::format("{:.{}g}", value == 0 ? 0.0 : value, std::clamp(digits, 1L, 17L));
}

}  // namespace eliminant::io
