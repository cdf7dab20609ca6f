// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/options.hpp>

namespace eliminant::io {

enum class Format { text, json, csv };

/// Everything that can be chosen for one run, by a problem file or on the command line.
struct RunOptions {
  intersect::Options solve;
  Format format = Format::text;
  std::optional<double> time_limit_seconds;
  std::optional<long> memory_limit_megabytes;
};

/// One option as it was given: `digits` = `30`. Switches have the value `true` or `false`. The place is empty when it
/// was given on the command line.
struct OptionSetting {
  std::string name;
  std::string value;
  SourcePlace place;
};

/// Names that may stand in the "options" of a problem and, with two dashes before, on the command line.
std::span<const char* const> option_names();
/// Whether the option is a switch, which has no value on the command line.
bool is_switch(std::string_view name);

/// Applies `settings` in their order: later ones win. Throws InvalidInput for an unknown name, a value outside the
/// range and for `real` with `complex`; the message names the option, the value and what it can be.
void apply_options(RunOptions& options, std::span<const OptionSetting> settings);

/// The value of the `--tolerance` of verify: between 0 and 1. Throws InvalidInput.
double tolerance(const std::string& value);

/// The settings that lead from the defaults to `options`, to be written into a problem file.
std::vector<OptionSetting> settings_of(const RunOptions& options);

}  // namespace eliminant::io
