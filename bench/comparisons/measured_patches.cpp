// SPDX-License-Identifier: BSD-3-Clause
#include "measured_patches.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <stdexcept>

namespace eliminant::comparisons {

namespace {

double processor_milliseconds() {
  constexpr double milliseconds_per_second = 1e3;
  constexpr double nanoseconds_per_millisecond = 1e6;
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * milliseconds_per_second +
         static_cast<double>(now.tv_nsec) / nanoseconds_per_millisecond;
}

double time_of(const PatchRun& solver) {
  constexpr std::size_t repetitions = 5;
  constexpr double long_milliseconds = 200;
  std::vector<double> times;
  do {
    const double start = processor_milliseconds();
    solver.run();
    times.push_back(processor_milliseconds() - start);
  } while (times.size() < repetitions && times.front() < long_milliseconds);
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

/// The answer as numbers: time, complete, then each polyline after the number of its points.
std::vector<double> message_of(double milliseconds, const FoundPolylines& found) {
  std::vector<double> numbers{milliseconds, found.complete ? 1.0 : 0.0};
  for (const SpacePolyline& polyline : found.polylines) {
    numbers.push_back(static_cast<double>(polyline.size()));
    for (const auto& point : polyline) numbers.insert(numbers.end(), point.begin(), point.end());
  }
  return numbers;
}

MeasuredPatches answer_in(const std::vector<double>& numbers) {
  MeasuredPatches measured;
  if (numbers.size() < 2) return measured;
  measured.ending = Ending::finished;
  measured.milliseconds = numbers[0];
  measured.found.complete = numbers[1] != 0;
  for (std::size_t k = 2; k < numbers.size();) {
    SpacePolyline& polyline = measured.found.polylines.emplace_back();
    for (auto left = static_cast<std::size_t>(numbers[k++]); left > 0; --left, k += 3)
      polyline.push_back({numbers.at(k), numbers.at(k + 1), numbers.at(k + 2)});
  }
  return measured;
}

bool write_all(int pipe_end, const std::vector<double>& numbers) {
  const char* bytes = reinterpret_cast<const char*>(numbers.data());
  std::size_t left = numbers.size() * sizeof(double);
  while (left > 0) {
    const ssize_t written = write(pipe_end, bytes, left);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    left -= static_cast<std::size_t>(written);
  }
  return true;
}

/// Everything that comes before the other end is closed; false when that takes too long.
bool read_all(int pipe_end, double limit_seconds, std::vector<double>& numbers) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration<double>(limit_seconds);
  std::vector<char> bytes;
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd readable{pipe_end, POLLIN, 0};
    const int ready = poll(&readable, 1, static_cast<int>(std::max<long>(left, 0)));
    if (ready == 0) return false;
    if (ready < 0) {
      if (errno == EINTR) continue;
      return false;
    }
    std::array<char, 1U << 16U> part{};
    const ssize_t size = read(pipe_end, part.data(), part.size());
    if (size <= 0) break;
    bytes.insert(bytes.end(), part.begin(), part.begin() + size);
  }
  numbers.resize(bytes.size() / sizeof(double));
  std::copy_n(bytes.begin(), numbers.size() * sizeof(double), reinterpret_cast<char*>(numbers.data()));
  return true;
}

/// In the new process: no destructor of the program may run in it.
[[noreturn]] void solving_process(PatchRun (*prepare)(const test::PatchCase&), const test::PatchCase& patches,
                                  int pipe_end) {
  try {
    const PatchRun solver = prepare(patches);
    const double milliseconds = time_of(solver);
    _exit(write_all(pipe_end, message_of(milliseconds, solver.found())) ? 0 : 1);
  } catch (...) {
    _exit(1);
  }
}

}  // namespace

MeasuredPatches measure_patches(PatchRun (*prepare)(const test::PatchCase&), const test::PatchCase& patches,
                                double limit_seconds) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("compare: no pipe can be opened");
  std::fflush(nullptr);
  const pid_t id = fork();
  if (id < 0) throw std::runtime_error("compare: no process can be started");
  if (id == 0) {
    close(ends[0]);
    // What solvers print is not part of the tables.
    dup2(STDERR_FILENO, STDOUT_FILENO);
    solving_process(prepare, patches, ends[1]);
  }
  close(ends[1]);
  std::vector<double> numbers;
  const bool in_time = read_all(ends[0], limit_seconds, numbers);
  close(ends[0]);
  if (!in_time) kill(id, SIGKILL);
  int status = 0;
  waitpid(id, &status, 0);
  MeasuredPatches measured;
  if (!in_time)
    measured.ending = Ending::out_of_time;
  else if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
    measured = answer_in(numbers);
  return measured;
}

}  // namespace eliminant::comparisons
