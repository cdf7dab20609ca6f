// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <eliminant/io/input/problem_file.hpp>

namespace eliminant::io {

/// The kind that a text calls itself in its field "problem", for the report on a text that is no problem; nullopt when
/// it does not say, or is no JSON. Throws nothing.
std::optional<std::string> stated_kind(const std::string& text, ProblemSyntax syntax) noexcept;

}  // namespace eliminant::io
