// SPDX-License-Identifier: BSD-3-Clause
#include "measured_runs.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace eliminant::comparisons {

namespace {

constexpr double milliseconds_per_second = 1000;

/// What the measuring process tells of one run; smaller than what a pipe passes in one piece.
struct Report {
  double milliseconds = 0;
  double peak_megabytes = 0;
  RunOutcome outcome;
};
static_assert(std::is_trivially_copyable_v<Report>);

double processor_milliseconds() {
  constexpr double nanoseconds_per_millisecond = 1e6;
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * milliseconds_per_second +
         static_cast<double>(now.tv_nsec) / nanoseconds_per_millisecond;
}

double peak_megabytes() {
  constexpr double kilobytes_per_megabyte = 1024;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / kilobytes_per_megabyte;
}

void report_runs(const std::function<Run()>& prepare, double limit_seconds, int pipe_end) {
  constexpr int fewest_runs = 3;
  constexpr double enough_milliseconds = 1000;
  const Run run = prepare();
  double total = 0;
  for (int runs = 0; runs < fewest_runs || total < enough_milliseconds; ++runs) {
    if (total > limit_seconds * milliseconds_per_second / 2) return;
    Report report;
    const double start = processor_milliseconds();
    report.outcome = run();
    report.milliseconds = processor_milliseconds() - start;
    report.peak_megabytes = peak_megabytes();
    if (write(pipe_end, &report, sizeof report) != static_cast<ssize_t>(sizeof report)) return;
    total += report.milliseconds;
  }
}

/// In the new process: no destructor of the program may run in it.
[[noreturn]] void measuring_process(const std::function<Run()>& prepare, double limit_seconds, int pipe_end) {
  try {
    report_runs(prepare, limit_seconds, pipe_end);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    _exit(1);
  } catch (...) {
    _exit(1);
  }
  _exit(0);
}

struct Process {
  pid_t id = -1;
  int pipe_end = -1;
};

Process start(const std::function<Run()>& prepare, double limit_seconds) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("compare: no pipe can be opened");
  std::fflush(nullptr);
  const pid_t id = fork();
  if (id < 0) throw std::runtime_error("compare: no process can be started");
  if (id == 0) {
    close(ends[0]);
    measuring_process(prepare, limit_seconds, ends[1]);
  }
  close(ends[1]);
  return {id, ends[0]};
}

/// True when there is something to read, or the other end is closed, before the limit has passed.
bool wait_for_report(int pipe_end, double limit_seconds) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration<double>(limit_seconds);
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd readable{pipe_end, POLLIN, 0};
    const int ready = poll(&readable, 1, static_cast<int>(std::max<long>(left, 0)));
    if (ready > 0) return true;
    if (ready == 0 || errno != EINTR) return false;
  }
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

MeasuredRuns measure(const std::function<Run()>& prepare, double limit_seconds) {
  const Process process = start(prepare, limit_seconds);
  MeasuredRuns measured;
  std::vector<double> milliseconds;
  bool in_time = true;
  for (;;) {
    in_time = wait_for_report(process.pipe_end, limit_seconds);
    Report report;
    if (!in_time || read(process.pipe_end, &report, sizeof report) != static_cast<ssize_t>(sizeof report)) break;
    milliseconds.push_back(report.milliseconds);
    measured.peak_megabytes = report.peak_megabytes;
    measured.outcome = report.outcome;
  }
  close(process.pipe_end);
  if (!in_time) kill(process.id, SIGKILL);
  int status = 0;
  waitpid(process.id, &status, 0);

  const bool sound = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  measured.runs = static_cast<int>(milliseconds.size());
  if (in_time && !sound) {
    measured.ending = Ending::failed;
  } else if (milliseconds.empty()) {
    measured.ending = in_time ? Ending::failed : Ending::out_of_time;
  } else {
    measured.ending = Ending::finished;
    measured.milliseconds = median(std::move(milliseconds));
  }
  return measured;
}

}  // namespace eliminant::comparisons
