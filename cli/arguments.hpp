// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/io/input/run_options.hpp>

namespace eliminant::cli {

/// The command line is none of those in `--help`.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// A command line that asks for an answer.
struct Arguments {
  enum class Command { solve, curves, verify, implicitize, batch, report };
  Command command = Command::solve;
  /// Of `solve`, `verify`, `implicitize`, `batch` and `report`: a path, or "-" for standard input.
  std::string file;
  /// Of `verify`: what is checked, where it is no certificate.
  std::optional<std::string> candidates;
  std::optional<std::string> tolerance;
  /// Of `curves`.
  std::string p;
  std::string q;
  std::optional<std::string> box;
  /// Of `batch`.
  bool resume = false;
  bool timings = false;
  std::optional<std::string> shard;

  std::optional<std::string> variables;
  std::optional<std::string> output;
  /// Where the certificate is written; of `verify` where it is read.
  std::optional<std::string> certificate;
  /// Where the labelled cloud is written.
  std::optional<std::string> labels;
  std::vector<io::OptionSetting> settings;
  bool echo = false;
  bool progress = false;
  bool quiet = false;
};

/// A command line that asks for a text (`--help`, `--version`).
struct Information {
  std::string text;
};

/// Throws UsageError.
std::variant<Arguments, Information> parse_arguments(const std::vector<std::string>& words);

/// The format that the command line asks for, also when it is wrong elsewhere.
io::Format format_in(const std::vector<std::string>& words);

}  // namespace eliminant::cli
