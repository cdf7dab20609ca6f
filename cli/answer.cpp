// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/cli/answer.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <eliminant/io/results/error_report.hpp>

namespace eliminant::cli {

Answer::Answer(std::optional<std::string> path) : path_(std::move(path)) {
  if (!path_) return;
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::path(*path_).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, error))
    throw io::OutputError("cannot write '" + *path_ + "': there is no folder '" + folder.string() + "'");
  if (std::filesystem::is_directory(*path_, error))
    throw io::OutputError("cannot write '" + *path_ + "': it is a directory");
}

void Answer::write(const std::string& text) const {
  const std::string name = path_ ? "'" + *path_ + "'" : "standard output";
  const auto fail = [&] { throw io::OutputError("cannot write " + name + ": " + std::strerror(errno)); };
  std::FILE* const file = path_ ? std::fopen(path_->c_str(), "wb") : stdout;
  if (file == nullptr) fail();
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
  const bool closed = !path_ || std::fclose(file) == 0;
  if (!written || !closed) fail();
}

}  // namespace eliminant::cli
