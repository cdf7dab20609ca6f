// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>
#include <cstdio>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <eliminant/cli/answer.hpp>
#include <eliminant/cli/arguments.hpp>
#include <eliminant/cli/batch.hpp>
#include <eliminant/cli/report.hpp>
#include <eliminant/cli/run.hpp>
#include <eliminant/io/input/memory_limit.hpp>
#include <eliminant/io/results/error_report.hpp>

namespace {

using namespace eliminant;

// Errors before there is a problem, and those of the output itself.
int fail(const io::ErrorReport& report, io::Format format) {
  std::fprintf(stderr, "eliminant: %s\n", io::error_line(report, "").c_str());
  if (format == io::Format::json && report.kind != "output") {
    const std::string text = io::error_json(report, std::nullopt, std::nullopt, false);
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) return 1;
  }
  return report.exit_status;
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that goes away is an output that cannot be written, not the end of the process by a signal.
  std::signal(SIGPIPE, SIG_IGN);
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    io::prepare_arithmetic();
    const auto parsed = cli::parse_arguments(words);
    if (const auto* information = std::get_if<cli::Information>(&parsed)) {
      cli::Answer(std::nullopt).write(information->text);
      return 0;
    }
    const auto& arguments = std::get<cli::Arguments>(parsed);
    if (arguments.command == cli::Arguments::Command::report) return cli::report(arguments);
    return arguments.command == cli::Arguments::Command::batch ? cli::solve_batch(arguments) : cli::run(arguments);
  } catch (const cli::UsageError& error) {
    return fail({"usage", 2, error.what(), {}, {}}, cli::format_in(words));
  } catch (const std::exception& error) {
    return fail(io::report_error(error), cli::format_in(words));
  } catch (...) {
    return fail({"internal", 1, "an unknown error", {}, {}}, cli::format_in(words));
  }
}
