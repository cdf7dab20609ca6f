// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/intersect/result.hpp>
#include <eliminant/io/input/run_options.hpp>

namespace eliminant::io {

// The parts of a text for people that results of every kind of problem have in common.

/// Wider tables are written as blocks.
constexpr std::size_t widest_table = 120;

/// "1 point", "2 points".
std::string counted(unsigned long count, const std::string& noun);

/// One line for the status, or the limit, and one for the status of the rest. `infinite` says what status infinite
/// means for this kind of problem.
std::string status_lines(intersect::Status status, const std::optional<intersect::Status>& rest_status,
                         const std::optional<std::string>& limit, const std::string& infinite);

/// The rows of a count audit that part the sum `with_multiplicity`, called `sum`, into what is certified and what not.
std::vector<std::vector<std::string>> certified_rows(unsigned long with_multiplicity, const std::string& sum,
                                                     unsigned long certified, unsigned long listed);

/// "3 real, 2 not real, 0 undecided".
std::string realities(unsigned long distinct, unsigned long real, unsigned long undecided);

/// The table of the options that were given and what was used.
std::string given_and_used(const intersect::EngineReport& used, const RunOptions& given);

/// The line that begins with `seconds`; nothing without stages.
std::string seconds_line(const std::vector<std::pair<std::string, double>>& seconds);

/// "0.5 - 1.25i"; a number known to be real has no imaginary part.
std::string coordinate_text(const intersect::Coordinate& coordinate, intersect::Reality reality);

/// `yes`, `no`, `undecided`.
const char* reality_word(intersect::Reality reality);

/// A column of numbers under `name`. Where one has a sign, the others get a blank in its place: digits stand below
/// digits.
std::vector<std::string> number_column(const std::string& name, std::vector<std::string> numbers);

/// Why solutions are not certified: entry i is the reason of solution i + 1, empty where there is none. Equal reasons
/// stand once, with the numbers of the solutions they hold for.
std::string not_certified_lines(const std::vector<std::string>& reasons);

}  // namespace eliminant::io
