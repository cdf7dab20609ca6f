// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/base/error.hpp>

namespace eliminant::io {

/// Runs `read` so that its errors of syntax and size begin with the name of what was read.
template <class Read>
auto named(const std::string& name, Read read) {
  try {
    return read();
  } catch (const ParseError& error) {
    throw ParseError(name + ": " + error.what(), error.expected(), error.place());
  } catch (const LimitReached& limit) {
    throw LimitReached(name + ": " + limit.what(), limit.place());
  }
}

/// Runs `build`; an InvalidInput or LimitReached that knows no place gets this one.
template <class Build>
auto placed(SourcePlace place, Build build) {
  try {
    return build();
  } catch (const InvalidInput& error) {
    if (error.place().line != 0) throw;
    throw InvalidInput(error.what(), error.expected(), place);
  } catch (const LimitReached& limit) {
    if (limit.place().line != 0) throw;
    throw LimitReached(limit.what(), place);
  }
}

}  // namespace eliminant::io
