// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/result.hpp>

namespace eliminant::io {

/// `certified`, `numeric`, `infinite`, `incomplete`: the same words in every format.
const char* word_for(intersect::Status status);

/// `true`, `false`, `undecided`.
const char* word_for(intersect::Reality reality);

/// `crossing`, `isolated`, `cusp`, `complex`.
const char* word_for(intersect::PairKind kind);

/// The power of ten with this exponent, `1e-15`.
std::string radius_text(long exponent);

}  // namespace eliminant::io
