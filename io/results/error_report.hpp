// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/io/input/problem_file.hpp>

namespace eliminant::io {

/// An output that could not be written.
class OutputError : public Error {
 public:
  using Error::Error;
};

/// What a user is told about an error. Kinds and their exit status (docs/errors.md): `parse_error`, `invalid_input` and
/// `usage` 2; `limit` and `precision` 3; `output`, `crash` and `internal` 1.
struct ErrorReport {
  std::string kind;
  int exit_status = 1;
  std::string message;
  std::string expected;
  SourcePlace place;
};

ErrorReport report_error(const std::exception& error);

/// Whether the memory was not enough.
bool is_exhausted_memory(const std::exception& error);

/// One line for standard error: `source:line:column: message; expected ...`, without what is not known.
std::string error_line(const ErrorReport& report, const std::string& source);

/// The field `error` of a result.
nlohmann::ordered_json error_object(const ErrorReport& report);

/// The result that stands for an error: its status is `incomplete` when a limit ended the computation, else `error`.
/// `problem` is the kind of the problem; the field is null where that is unknown.
std::string error_json(const ErrorReport& report, const std::optional<std::string>& problem,
                       const std::optional<ProblemId>& id, bool incomplete);

}  // namespace eliminant::io
