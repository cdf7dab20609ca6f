// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <optional>
#include <string>

namespace eliminant::cli {

/// Where the one answer of a run goes. Of two threads that want to give it only the first one does.
class Answer {
 public:
  /// Standard output, or the file `path`. Throws io::OutputError when its folder does not exist: before the work.
  explicit Answer(std::optional<std::string> path);

  /// Whether nobody has claimed the answer before.
  bool claim() { return !claimed_.exchange(true); }

  /// Writes the text. Throws io::OutputError when not every byte could be written.
  void write(const std::string& text) const;

 private:
  std::optional<std::string> path_;
  std::atomic<bool> claimed_{false};
};

}  // namespace eliminant::cli
