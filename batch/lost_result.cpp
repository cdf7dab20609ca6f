// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/batch/run_batch.hpp>

#include <csignal>

#include <charconv>
#include <system_error>

#include <eliminant/io/input/json_text.hpp>
#include <eliminant/io/input/stated_kind.hpp>
#include <eliminant/io/results/error_report.hpp>
#include <eliminant/io/results/json_layout.hpp>

namespace eliminant::batch {

namespace {

// A text that ended a worker is not read again when it is large.
constexpr std::size_t longest_read_again = std::size_t{1} << 20U;

std::optional<io::ProblemId> stated_id(const std::string& text) noexcept {
  try {
    const io::JsonDocument document(text);
    const io::JsonValue* const id = document.root().find("id");
    if (id == nullptr) return std::nullopt;
    if (id->kind == io::JsonValue::Kind::text) return id->text;
    long number = 0;
    const char* const end = id->text.data() + id->text.size();
    const std::from_chars_result read = std::from_chars(id->text.data(), end, number);
    if (id->kind != io::JsonValue::Kind::number || read.ptr != end || read.ec != std::errc()) return std::nullopt;
    return number;
  } catch (...) {
    return std::nullopt;
  }
}

std::string result_of(const Task& task, const io::ErrorReport& report, bool incomplete) {
  std::optional<std::string> kind;
  std::optional<io::ProblemId> id;
  if (task.text.size() <= longest_read_again) {
    kind = io::stated_kind(task.text, io::ProblemSyntax::json);
    id = stated_id(task.text);
  }
  return io::json_on_one_line(io::error_json(report, kind, id, incomplete));
}

}  // namespace

std::string too_long_result(const Task& task) {
  const std::string longest = std::to_string(LineReader::longest_line >> 20U);
  return result_of(
      task, {"limit", 3, "the line is longer than " + longest + " MiB, which is the limit", {}, {task.line, 0}}, false);
}

std::string lost_result(const Task& task, const Death& death, bool memory_limited) {
  if (death.signal == SIGALRM) return result_of(task, {"limit", 3, "the time limit was reached", {}, {}}, true);
  // The C++ runtime aborts where memory fails while an exception is on its way.
  if (death.signal == SIGABRT && memory_limited)
    return result_of(task, {"limit", 3, "the memory is exhausted", {}, {task.line, 0}}, true);
  return result_of(
      task, {"crash", 1, "the process that solved this problem was ended " + in_words(death), {}, {task.line, 0}},
      false);
}

}  // namespace eliminant::batch
