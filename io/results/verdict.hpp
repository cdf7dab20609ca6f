// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <eliminant/intersect/plane_curves/match_candidates.hpp>
#include <eliminant/io/input/problem_file.hpp>

namespace eliminant::io {

/// The answer of `verify` about a certificate: accepted, or refused for these reasons.
std::string certificate_verdict(const std::vector<std::string>& reasons, const std::optional<ProblemId>& id,
                                Format format);

/// The answer of `verify` about candidates (docs/formats.md). Candidates count from 1 in text, from 0 in JSON.
std::string candidates_verdict(const intersect::CandidateReport& report, const std::optional<ProblemId>& id,
                               Format format);

}  // namespace eliminant::io
