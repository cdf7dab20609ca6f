// SPDX-License-Identifier: BSD-3-Clause
//
// eliminant beside OCCT and SISL on the same Bezier curves and patches, in one run, in process, each with one thread:
//   scripts/compare.sh bezier [--markdown] [--only TEXT] [--all]
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <eliminant/version.hpp>
#include <support/bezier_families.hpp>

#include "bezier_solvers.hpp"
#include "family_comparison.hpp"
#include "tables.hpp"

namespace {

using namespace eliminant::comparisons;
using eliminant::test::BezierCase;

const std::vector<FamilyRow> rows_of_table{
    {"segment x bicubic patch", {"segment x bicubic"}},
    {"cubic x bicubic", {"cubic x bicubic"}},
    {"rational cubic x rational bicubic", {"rational cubic x rational bicubic"}},
    {"degree 8 x bidegree (5,5)", {"degree 8 x bidegree (5,5)"}},
    {"contacts of order 2 and 3, dyadic", {"contact of order 2", "contact of order 3"}},
    {"contacts of order 2 and 3, irrational", {"irrational contact of order 2", "irrational contact of order 3"}},
    {"plane cubic x cubic", {"plane cubic x cubic"}},
    {"plane degree 8 x 8", {"plane degree 8 x 8"}},
};

struct Solver {
  std::string name;
  BezierRun (*prepare)(const BezierCase&);
};

const std::array<Solver, 3> solvers{{{"eliminant", eliminant_bezier}, {"OCCT", occt_bezier}, {"SISL", sisl_bezier}}};

/// One solver on one family.
struct Summary {
  std::vector<double> microseconds;  ///< of each case
  std::size_t lost = 0;
  std::size_t repeated = 0;  ///< beside a true solution that was found
  std::size_t invented = 0;
  std::size_t failed = 0;  ///< cases without an answer, or not certified
};

double processor_microseconds() {
  constexpr double microseconds_per_second = 1e6;
  constexpr double nanoseconds_per_microsecond = 1e3;
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * microseconds_per_second +
         static_cast<double>(now.tv_nsec) / nanoseconds_per_microsecond;
}

/// The median of several measurements, each of so many runs that the clock is not what is measured.
double time_of(const BezierRun& run) {
  constexpr double long_enough = 300;
  constexpr int measurements = 5;
  constexpr double very_long = 200000;
  double first = processor_microseconds();
  run();
  first = processor_microseconds() - first;
  const int runs = std::max(1, static_cast<int>(long_enough / std::max(first, 0.5)));
  std::vector<double> times;
  for (int i = 0; i < (first > very_long ? 1 : measurements); ++i) {
    const double start = processor_microseconds();
    for (int k = 0; k < runs; ++k) run();
    times.push_back((processor_microseconds() - start) / runs);
  }
  return median(times);
}

/// How far a parameter may be from the true one and still be it: at a contact a solver of tolerance 1e-6 knows its
/// third part of the digits.
constexpr double same_parameter = 0.02;

/// Each true solution takes the nearest of the points, or lies in a stretch; what is left over repeats one or is
/// invented.
void count_differences(const FoundParameters& truth, const FoundParameters& found, Summary& summary) {
  std::vector<double> left = found.points;
  std::set<std::size_t> used;
  for (const double t : truth.points) {
    const auto nearest = std::min_element(left.begin(), left.end(),
                                          [&](double a, double b) { return std::abs(a - t) < std::abs(b - t); });
    if (nearest != left.end() && std::abs(*nearest - t) < same_parameter) {
      left.erase(nearest);
      continue;
    }
    bool covered = false;
    for (std::size_t k = 0; k < found.stretches.size(); ++k)
      if (found.stretches[k][0] - same_parameter < t && t < found.stretches[k][1] + same_parameter) {
        covered = true;
        used.insert(k);
      }
    if (!covered) ++summary.lost;
  }
  for (const std::array<double, 2>& stretch : truth.stretches) {
    const double begin = stretch[0];
    const double end = stretch[1];
    bool covered = false;
    for (std::size_t k = 0; k < found.stretches.size(); ++k)
      if (found.stretches[k][0] < end && begin < found.stretches[k][1]) {
        covered = true;
        used.insert(k);
      }
    if (!covered) ++summary.lost;
    std::erase_if(left, [&](double t) { return begin - same_parameter < t && t < end + same_parameter; });
  }
  for (const double t : left) {
    const bool beside_one = std::any_of(truth.points.begin(), truth.points.end(),
                                        [&](double other) { return std::abs(other - t) < same_parameter; });
    ++(beside_one ? summary.repeated : summary.invented);
  }
  summary.invented += found.stretches.size() - used.size();
}

using Measurements = std::array<Summary, solvers.size()>;

Measurements measure(const std::vector<BezierCase>& cases) {
  Measurements measurements;
  for (const BezierCase& bezier : cases) {
    const FoundParameters truth = eliminant_bezier(bezier)();
    for (std::size_t i = 0; i < solvers.size(); ++i) {
      try {
        const BezierRun run = solvers[i].prepare(bezier);
        const FoundParameters found = run();
        if (!found.complete) ++measurements[i].failed;
        count_differences(truth, found, measurements[i]);
        measurements[i].microseconds.push_back(time_of(run));
      } catch (const std::exception& error) {
        fmt::print(stderr, "{} {}: {}\n", bezier.family, bezier.index, error.what());
        ++measurements[i].failed;
      }
    }
  }
  return measurements;
}

std::size_t solution_count(const std::vector<BezierCase>& cases) {
  std::size_t count = 0;
  for (const BezierCase& bezier : cases) {
    const FoundParameters truth = eliminant_bezier(bezier)();
    count += truth.points.size() + truth.stretches.size();
  }
  return count;
}

std::string faults_of(const Summary& summary) {
  return faults({{summary.lost, "lost"},
                 {summary.repeated, "repeated"},
                 {summary.invented, "invented"},
                 {summary.failed, "failed"}});
}

/// Keeps standard output for the tables: SISL writes its complaints there.
class QuietOutput {
 public:
  QuietOutput() {
    std::fflush(stdout);
    kept_ = dup(STDOUT_FILENO);
    if (kept_ < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) throw std::runtime_error("no descriptor is left");
  }
  QuietOutput(const QuietOutput&) = delete;
  QuietOutput& operator=(const QuietOutput&) = delete;
  ~QuietOutput() {
    std::fflush(stdout);
    dup2(kept_, STDOUT_FILENO);
    close(kept_);
  }

 private:
  int kept_ = -1;
};

void compare(const Selection& selection) {
  std::optional<QuietOutput> quiet(std::in_place);
  Table times{{"microseconds, median (largest)", "cases", "solutions"}};
  Table differences{{"against the certified answers", "OCCT", "SISL", "eliminant"}};
  for (const Solver& solver : solvers) times[0].push_back(solver.name);
  times[0].insert(times[0].end(), {"OCCT : eliminant", "SISL : eliminant"});
  for (const FamilyRow& row : chosen_rows(rows_of_table, selection, [] { return eliminant::test::bezier_cases(); })) {
    fmt::print(stderr, "{}\n", row.name);
    std::vector<BezierCase> cases;
    for (const std::string& family : row.families)
      for (BezierCase& bezier : eliminant::test::bezier_cases(family)) cases.push_back(std::move(bezier));
    const Measurements measured = measure(cases);
    times.push_back({row.name, std::to_string(cases.size()), std::to_string(solution_count(cases))});
    for (const Summary& summary : measured)
      times.back().push_back(fmt::format("{} ({})", three_digits(median(summary.microseconds)),
                                         three_digits(largest(summary.microseconds))));
    for (std::size_t i = 1; i < solvers.size(); ++i)
      times.back().push_back(three_digits(median(measured[i].microseconds) / median(measured[0].microseconds)));
    differences.push_back({row.name, faults_of(measured[1]), faults_of(measured[2]), faults_of(measured[0])});
  }
  quiet.reset();
  fmt::print("eliminant {}, {}, {}\n\n", eliminant::version, occt_version(), sisl_version());
  print_table(times, selection.markdown);
  print_table(differences, selection.markdown);
}

}  // namespace

int main(int argc, char** argv) {
  Selection selection;
  CLI::App app("eliminant, OCCT and SISL on the same Bezier curves and patches", "compare_bezier");
  return run_comparison(app, selection, argc, argv, [&] { compare(selection); });
}
