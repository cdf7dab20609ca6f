// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

/// A folder that exists as long as this object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "eliminant-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = pattern;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
  }
  std::string read(const std::string& name) const {
    std::ifstream stream(file(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

 private:
  std::filesystem::path path_;
};

struct Outcome {
  int status = -1;  ///< -1 when a signal ended the program
  std::string out;
  std::string err;
};

/// Runs the program with `arguments`, as a shell reads them.
inline Outcome run_program(const TemporaryFolder& folder, const std::string& arguments) {
  const std::string command =
      std::string("'") + ELIMINANT_PROGRAM + "' " + arguments + " 2>'" + folder.file("err") + "'";
  const int status = std::system(
      (command + (arguments.find('>') == std::string::npos ? " >'" + folder.file("out") + "'" : "")).c_str());
  Outcome outcome;
  if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
  outcome.out = folder.read("out");
  outcome.err = folder.read("err");
  return outcome;
}
