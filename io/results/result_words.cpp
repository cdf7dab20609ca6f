// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/result_words.hpp>

namespace eliminant::io {

const char* word_for(intersect::Status status) {
  switch (status) {
    case intersect::Status::certified:
      return "certified";
    case intersect::Status::numeric:
      return "numeric";
    case intersect::Status::infinite:
      return "infinite";
    case intersect::Status::incomplete:
      return "incomplete";
  }
  return "incomplete";
}

const char* word_for(intersect::Reality reality) {
  switch (reality) {
    case intersect::Reality::real:
      return "true";
    case intersect::Reality::non_real:
      return "false";
    case intersect::Reality::undecided:
      return "undecided";
  }
  return "undecided";
}

const char* word_for(intersect::PairKind kind) {
  switch (kind) {
    case intersect::PairKind::crossing:
      return "crossing";
    case intersect::PairKind::isolated:
      return "isolated";
    case intersect::PairKind::cusp:
      return "cusp";
    case intersect::PairKind::complex:
      return "complex";
  }
  return "complex";
}

std::string radius_text(long exponent) { return "1e" + std::to_string(exponent); }

}  // namespace eliminant::io
