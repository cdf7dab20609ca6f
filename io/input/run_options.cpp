// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/run_options.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

namespace eliminant::io {

namespace {

constexpr std::array known_names{"format",    "digits",  "engine",     "matrix",       "precision", "epsilon",
                                 "real",      "complex", "certify",    "no-certify",   "equation",  "bspline",
                                 "tolerance", "threads", "time-limit", "memory-limit", "seed"};

[[noreturn]] void refuse(const OptionSetting& setting, const std::string& expected) {
  throw InvalidInput("option " + setting.name + " is '" + setting.value.substr(0, 40) + "'", expected, setting.place);
}

template <class Number>
Number whole_number(const OptionSetting& setting, Number least, Number greatest) {
  Number value{};
  const char* const end = setting.value.data() + setting.value.size();
  const auto [rest, error] = std::from_chars(setting.value.data(), end, value);
  if (error != std::errc{} || rest != end || value < least || value > greatest)
    refuse(setting, "a whole number from " + std::to_string(least) + " to " + std::to_string(greatest));
  return value;
}

double positive_number(const OptionSetting& setting) {
  double value = 0;
  const char* const end = setting.value.data() + setting.value.size();
  const auto [rest, error] = std::from_chars(setting.value.data(), end, value);
  if (error != std::errc{} || rest != end || !std::isfinite(value) || value <= 0) refuse(setting, "a positive number");
  return value;
}

// Relative to the size of something: less than 1.
double relative_tolerance(const OptionSetting& setting) {
  const double value = positive_number(setting);
  if (value >= 1) refuse(setting, "a number between 0 and 1");
  return value;
}

bool switch_value(const OptionSetting& setting) {
  if (setting.value != "true" && setting.value != "false") refuse(setting, "true or false");
  return setting.value == "true";
}

template <class Value, std::size_t count>
Value one_of(const OptionSetting& setting, const std::array<std::pair<const char*, Value>, count>& choices) {
  std::string list;
  for (const auto& [name, value] : choices) {
    if (setting.value == name) return value;
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  refuse(setting, "one of " + list);
}

using intersect::Engine;
using intersect::Field;
using intersect::ResultantMatrix;

constexpr std::array<std::pair<const char*, Format>, 3> formats{
    {{"text", Format::text}, {"json", Format::json}, {"csv", Format::csv}}};
constexpr std::array<std::pair<const char*, Engine>, 4> engines{
    {{"auto", Engine::automatic}, {"pencil", Engine::pencil}, {"exact", Engine::exact}, {"box", Engine::box}}};
constexpr std::array<std::pair<const char*, ResultantMatrix>, 4> matrices{{{"auto", ResultantMatrix::automatic},
                                                                           {"sylvester", ResultantMatrix::sylvester},
                                                                           {"bezout", ResultantMatrix::bezout},
                                                                           {"hybrid", ResultantMatrix::hybrid}}};
constexpr std::array<std::pair<const char*, int>, 6> precisions{
    {{"auto", 0}, {"53", 53}, {"128", 128}, {"256", 256}, {"512", 512}, {"1024", 1024}}};

template <class Value, std::size_t count>
const char* name_of(Value value, const std::array<std::pair<const char*, Value>, count>& choices) {
  return std::find_if(choices.begin(), choices.end(), [&](const auto& choice) { return choice.second == value; })
      ->first;
}

void apply(RunOptions& options, const OptionSetting& setting) {
  intersect::Options& solve = options.solve;
  const std::string_view name = setting.name;
  if (name == "format") {
    options.format = one_of(setting, formats);
  } else if (name == "digits") {
    solve.digits = whole_number<long>(setting, 1, 100'000);
  } else if (name == "engine") {
    solve.engine = one_of(setting, engines);
  } else if (name == "matrix") {
    solve.matrix = one_of(setting, matrices);
  } else if (name == "precision") {
    solve.precision_bits = one_of(setting, precisions);
  } else if (name == "epsilon") {
    solve.epsilon = positive_number(setting);
  } else if (name == "real") {
    solve.field = switch_value(setting) ? Field::real : Field::automatic;
  } else if (name == "complex") {
    solve.field = switch_value(setting) ? Field::complex : Field::automatic;
  } else if (name == "certify") {
    solve.certify = switch_value(setting);
  } else if (name == "no-certify") {
    solve.certify = !switch_value(setting);
  } else if (name == "equation") {
    solve.equation = switch_value(setting);
  } else if (name == "bspline") {
    solve.splines = switch_value(setting);
  } else if (name == "tolerance") {
    solve.tolerance = relative_tolerance(setting);
  } else if (name == "threads") {
    solve.threads = whole_number<unsigned>(setting, 1, 1024);
  } else if (name == "time-limit") {
    options.time_limit_seconds = positive_number(setting);
  } else if (name == "memory-limit") {
    options.memory_limit_megabytes = whole_number<long>(setting, 1, 1L << 30);
  } else if (name == "seed") {
    solve.seed = whole_number<std::uint64_t>(setting, 0, UINT64_MAX);
  } else {
    std::string list;
    for (const char* known : known_names) list += (list.empty() ? "" : ", ") + std::string(known);
    throw InvalidInput("unknown option '" + setting.name + "'", "one of " + list, setting.place);
  }
}

bool is_on(std::span<const OptionSetting> settings, std::string_view name) {
  return std::any_of(settings.begin(), settings.end(),
                     [&](const OptionSetting& setting) { return setting.name == name && setting.value == "true"; });
}

std::string shortest(double value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? std::string(text.data(), end) : std::string("0");
}

}  // namespace

std::span<const char* const> option_names() { return known_names; }

bool is_switch(std::string_view name) {
  return name == "real" || name == "complex" || name == "certify" || name == "no-certify" || name == "equation" ||
         name == "bspline";
}

void apply_options(RunOptions& options, std::span<const OptionSetting> settings) {
  const auto refuse_both = [&](const char* a, const char* b) {
    if (is_on(settings, a) && is_on(settings, b))
      throw InvalidInput("options " + std::string(a) + " and " + b + " were both given", "one of the two",
                         settings.front().place);
  };
  refuse_both("real", "complex");
  refuse_both("certify", "no-certify");
  for (const OptionSetting& setting : settings) apply(options, setting);
}

double tolerance(const std::string& value) { return relative_tolerance({"tolerance", value, {}}); }

std::vector<OptionSetting> settings_of(const RunOptions& options) {
  const RunOptions defaults;
  std::vector<OptionSetting> settings;
  const auto add = [&](const char* name, std::string value) { settings.push_back({name, std::move(value), {}}); };
  const intersect::Options& solve = options.solve;
  if (options.format != defaults.format) add("format", name_of(options.format, formats));
  if (solve.digits != defaults.solve.digits) add("digits", std::to_string(solve.digits));
  if (solve.engine != defaults.solve.engine) add("engine", name_of(solve.engine, engines));
  if (solve.matrix != defaults.solve.matrix) add("matrix", name_of(solve.matrix, matrices));
  if (solve.precision_bits != 0) add("precision", name_of(solve.precision_bits, precisions));
  if (solve.epsilon) add("epsilon", shortest(*solve.epsilon));
  if (solve.field == Field::real) add("real", "true");
  if (solve.field == Field::complex) add("complex", "true");
  if (!solve.certify) add("certify", "false");
  if (solve.equation) add("equation", "true");
  if (solve.splines) add("bspline", "true");
  if (solve.tolerance != defaults.solve.tolerance) add("tolerance", shortest(solve.tolerance));
  if (solve.threads != defaults.solve.threads) add("threads", std::to_string(solve.threads));
  if (options.time_limit_seconds) add("time-limit", shortest(*options.time_limit_seconds));
  if (options.memory_limit_megabytes) add("memory-limit", std::to_string(*options.memory_limit_megabytes));
  if (solve.seed != defaults.solve.seed) add("seed", std::to_string(solve.seed));
  return settings;
}

}  // namespace eliminant::io
