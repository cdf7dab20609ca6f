// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace eliminant::cli {

/// The words of the command line, those behind the command `curves` in an order in which a polynomial that begins with
/// "-" is not taken for an option: options first, then "--", then the polynomials. A word is an option when it is the
/// name of one of `curves`; everything is left alone when "--" is already there. Throws UsageError for another word
/// that begins with two dashes and for more than two polynomials.
std::vector<std::string> protect_polynomials(const std::vector<std::string>& words, const CLI::App& curves);

}  // namespace eliminant::cli
