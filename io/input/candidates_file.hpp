// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <eliminant/intersect/plane_curves/match_candidates.hpp>
#include <eliminant/symbolic/arithmetic/limits.hpp>

namespace eliminant::io {

struct CandidatesFile {
  std::vector<intersect::Candidate> candidates;
  /// No candidate could be anything but real: a table with two coordinates.
  bool real_only = false;
};

/// Reads somebody's solutions, every number exactly as written. JSON: a result of this program, or any object with
/// "solutions", or an array of such; each solution has "x" and "y", numbers or [real, imaginary], and may have
/// "multiplicity"; other fields are ignored. Otherwise CSV: columns x_re,x_im,y_re,y_im or x,y, and multiplicity; with
/// a header they may stand in any order among others, without one they are 2 (x,y), 3 (and multiplicity), 4 or 5 (with
/// imaginary parts). Throws ParseError, InvalidInput and LimitReached with the place.
CandidatesFile read_candidates(const std::string& text, const symbolic::Limits& limits = {});

}  // namespace eliminant::io
