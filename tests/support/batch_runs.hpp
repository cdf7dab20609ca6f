// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dirent.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

/// Small problems of plane curves, one a line, with an error and a blank line now and then.
inline std::string batch_problems(int count) {
  std::mt19937 random(7);
  const auto coefficient = [&] { return std::to_string(static_cast<int>(random() % 19) - 9); };
  std::string text;
  for (int i = 0; i < count; ++i) {
    if (i % 11 == 5) text += "\n";
    if (i % 13 == 4) text += "{\"problem\": \"plane_curves\", \"p\": \"x^2 - \"}\n";
    text += "{\"problem\": \"plane_curves\", \"id\": " + std::to_string(i) + ", \"p\": \"x^2 + " + coefficient() +
            "*x*y + " + coefficient() + "*y + " + coefficient() + "\", \"q\": \"" + coefficient() + "*x^2 + y^3 + " +
            coefficient() + "*x\"}\n";
  }
  return text;
}

/// A program that runs while the test goes on.
class RunningProgram {
 public:
  /// The words of the command line, the program first. Its messages go nowhere.
  explicit RunningProgram(const std::vector<std::string>& words) {
    process_ = fork();
    if (process_ != 0) return;
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    if (std::freopen("/dev/null", "w", stderr) == nullptr) std::_Exit(127);
    execv(arguments.front(), arguments.data());
    std::_Exit(127);
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram() {
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  pid_t process() const { return process_; }
  /// Its exit status, or -1 when a signal ended it.
  int wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t process_ = -1;
};

/// The processes whose parent is `parent`.
inline std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> children;
  DIR* const folder = opendir("/proc");
  while (const dirent* const entry = readdir(folder)) {
    std::ifstream stat("/proc/" + std::string(entry->d_name) + "/stat");
    std::string text;
    if (!std::getline(stat, text)) continue;
    // The name, which stands in parentheses, may hold anything.
    const std::size_t behind_name = text.rfind(") ");
    if (behind_name == std::string::npos) continue;
    if (std::atoi(text.c_str() + behind_name + 4) == parent) children.push_back(std::atoi(entry->d_name));
  }
  closedir(folder);
  return children;
}

inline void sleep_milliseconds(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}
