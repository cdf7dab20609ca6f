// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/cli/polynomial_arguments.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>

#include <eliminant/cli/arguments.hpp>

namespace eliminant::cli {

std::vector<std::string> protect_polynomials(const std::vector<std::string>& words, const CLI::App& curves) {
  const auto command = std::find(words.begin(), words.end(), "curves");
  if (command == words.end() || std::find(words.begin(), words.end(), "--") != words.end()) return words;
  // Only the common options, whose values are no commands, may stand before it.
  if (std::find(words.begin(), command, "solve") != command) return words;

  std::vector<std::string> options(words.begin(), command + 1);
  std::vector<std::string> polynomials;
  for (auto word = command + 1; word != words.end(); ++word) {
    // What CLI11 would say of these two mistakes speaks of words that nobody typed.
    if (word->starts_with("--") && curves.get_option_no_throw(word->substr(0, word->find('='))) == nullptr)
      throw UsageError("unknown option " + *word +
                       "; see eliminant curves --help, and put -- before a polynomial that begins with two dashes");
    const bool dash = word->size() > 1 && word->front() == '-';
    const CLI::Option* const option = dash ? curves.get_option_no_throw(word->substr(0, word->find('='))) : nullptr;
    if (option == nullptr) {
      polynomials.push_back(*word);
      continue;
    }
    options.push_back(*word);
    const bool takes_next =
        option != nullptr && option->get_items_expected_max() > 0 && word->find('=') == std::string::npos;
    if (takes_next && word + 1 != words.end()) options.push_back(*++word);
  }
  if (polynomials.size() > 2)
    throw UsageError("there are " + std::to_string(polynomials.size()) + " polynomials; expected two");
  if (!polynomials.empty()) {
    options.emplace_back("--");
    options.insert(options.end(), polynomials.begin(), polynomials.end());
  }
  return options;
}

}  // namespace eliminant::cli
