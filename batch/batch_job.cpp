// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/batch/batch_job.hpp>

#include <poll.h>

#include <utility>

namespace eliminant::batch {

namespace {

// A quote inside a text is escaped: these can only be fields of a result.
bool has_status(const std::string& result, const char* status) {
  return result.find("\"status\": \"" + std::string(status) + "\"") != std::string::npos;
}

// Results are written together up to this size.
constexpr std::size_t block_size = std::size_t{1} << 20U;

}  // namespace

BatchJob::BatchJob(LineReader& lines, ResultFile& output, std::function<std::string(const Task&)> refused,
                   Window window)
    : lines_(lines), output_(output), refused_(std::move(refused)), window_(window) {
  incomplete_ = output.kept_incomplete();
  skip_kept();
}

void BatchJob::skip_kept() {
  while (first_ < output_.kept()) {
    const auto line = lines_.next();
    if (!line && lines_.at_end()) output_.refuse_kept(first_);
    if (!line) {
      pollfd entry{lines_.awaited(), POLLIN, 0};
      poll(&entry, 1, -1);
      continue;
    }
    hash_.add(line->line, line->text);
    output_.check_kept(++first_, hash_.value());
  }
  output_.drop_torn();
}

bool BatchJob::is_full() const { return slots_.size() >= window_.problems || bytes_ >= window_.bytes; }

void BatchJob::add_slot(LineReader::Line line) {
  hash_.add(line.line, line.text);
  bytes_ += line.text.size();
  slots_.push_back({{first_ + slots_.size(), line.line, std::move(line.text)}, hash_.value(), {}});
}

std::optional<Task> BatchJob::take() {
  if (!given_back_.empty()) {
    const std::uint64_t number = *given_back_.begin();
    given_back_.erase(given_back_.begin());
    return slots_[number - first_].task;
  }
  while (!is_full()) {
    auto line = lines_.next();
    if (!line) return std::nullopt;
    const bool too_long = line->too_long;
    add_slot(std::move(*line));
    const Task& task = slots_.back().task;
    if (!too_long) return task;
    finish({task.number, refused_(task)});
  }
  return std::nullopt;
}

void BatchJob::finish(Outcome outcome) {
  if (outcome.number < first_ || outcome.number - first_ >= slots_.size()) return;
  Slot& slot = slots_[outcome.number - first_];
  if (slot.result) return;
  bytes_ -= slot.task.text.size();
  bytes_ += outcome.result.size();
  std::string().swap(slot.task.text);
  slot.result = std::move(outcome.result);
}

void BatchJob::write() {
  while (!slots_.empty() && slots_.front().result) {
    std::string lines;
    std::uint64_t hash = 0;
    while (!slots_.empty() && slots_.front().result && lines.size() < block_size) {
      const Slot& slot = slots_.front();
      if (has_status(*slot.result, "error")) ++errors_;
      if (has_status(*slot.result, "incomplete")) ++incomplete_;
      lines += *slot.result + '\n';
      bytes_ -= slot.result->size();
      hash = slot.hash;
      slots_.pop_front();
      ++first_;
    }
    output_.append(lines, first_, hash);
  }
}

}  // namespace eliminant::batch
