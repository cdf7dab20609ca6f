// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/cli/batch.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <map>

#include <eliminant/cli/run.hpp>
#include <eliminant/io/input/memory_limit.hpp>
#include <eliminant/io/results/error_report.hpp>
#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/version.hpp>

namespace eliminant::cli {

namespace {

// Everything besides the lines that decides what the results are.
std::string description_of(const Arguments& arguments, const std::optional<batch::Shard>& shard) {
  nlohmann::ordered_json out;
  out["version"] = std::string(version);
  out["options"] = nlohmann::ordered_json::object();
  std::map<std::string, std::string> options;
  for (const io::OptionSetting& setting : arguments.settings)
    if (setting.name != "threads" && setting.name != "format") options[setting.name] = setting.value;
  for (const auto& [name, value] : options) out["options"][name] = value;
  if (arguments.variables) out["variables"] = *arguments.variables;
  if (arguments.timings) out["timings"] = true;
  if (shard) out["shard"] = std::to_string(shard->index) + "/" + std::to_string(shard->count);
  return io::json_line(out);
}

}  // namespace

batch::BatchSettings batch_settings(const Arguments& arguments) {
  io::RunOptions options;
  io::apply_options(options, arguments.settings);
  batch::BatchSettings settings;
  settings.input = arguments.file;
  settings.output = arguments.output;
  if (arguments.shard) settings.shard = batch::parse_shard(*arguments.shard);
  settings.resume = arguments.resume;
  settings.description = description_of(arguments, settings.shard);
  settings.workers = options.solve.threads;
  settings.progress = arguments.progress;
  settings.quiet = arguments.quiet;
  return settings;
}

batch::Solver batch_solver(const Arguments& arguments) {
  const auto solve = [&arguments](const batch::Task& task) {
    // The memory of a worker begins at its first problem: what it has of its parent depends on when it was forked.
    [[maybe_unused]] static const bool counted = (io::count_memory_from_now(), true);
    LineResult result = result_line({task.line, task.text}, arguments);
    return batch::Solved{std::move(result.json), result.memory_exhausted};
  };
  const bool memory_limited =
      std::any_of(arguments.settings.begin(), arguments.settings.end(),
                  [](const io::OptionSetting& option) { return option.name == "memory-limit"; });
  const auto lost = [memory_limited](const batch::Task& task, const batch::Death& death) {
    return batch::lost_result(task, death, memory_limited);
  };
  return {solve, lost};
}

int solve_batch(const Arguments& arguments) {
  return with_reported_errors(arguments.file,
                              [&] { return batch::run_batch(batch_settings(arguments), batch_solver(arguments)); });
}

int with_reported_errors(const std::string& source, const std::function<int()>& solve) {
  try {
    return solve();
  } catch (const io::OutputError&) {
    throw;
  } catch (const std::exception& error) {
    const io::ErrorReport report = io::report_error(error);
    std::fprintf(stderr, "eliminant: %s\n", io::error_line(report, source == "-" ? "standard input" : source).c_str());
    return report.exit_status;
  }
}

}  // namespace eliminant::cli
