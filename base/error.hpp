// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

/// The errors of eliminant. What is mathematics (no solution, infinitely many, an overlap) is never one of them: it is
/// an alternative of the result. Every message names the object, what was found and what was expected.
namespace eliminant {

/// Root of all errors thrown by the library.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A place in an input text; lines and columns count from 1, 0 means "no such place".
struct SourcePlace {
  std::size_t line = 0;
  std::size_t column = 0;
};

/// The input can be read, but is not a problem of the kind it says it is. `place` may be empty.
class InvalidInput : public Error {
 public:
  explicit InvalidInput(const std::string& message, std::string expected = {}, SourcePlace place = {})
      : Error(message), expected_(std::move(expected)), place_(place) {}
  /// What would have been accepted, as a noun phrase.
  const std::string& expected() const { return expected_; }
  SourcePlace place() const { return place_; }

 private:
  std::string expected_;
  SourcePlace place_;
};

/// The input is not a sentence of the grammar.
class ParseError : public InvalidInput {
 public:
  using InvalidInput::InvalidInput;
};

/// The input is well formed, but larger than a size limit, or a time or memory limit was reached.
class LimitReached : public Error {
 public:
  explicit LimitReached(const std::string& message, SourcePlace place = {}) : Error(message), place_(place) {}
  SourcePlace place() const { return place_; }

 private:
  SourcePlace place_;
};

/// The numeric stage could not reach the goal at the largest precision it may use.
class PrecisionExhausted : public Error {
 public:
  using Error::Error;
};

}  // namespace eliminant
