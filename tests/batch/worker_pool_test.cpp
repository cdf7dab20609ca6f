// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <new>
#include <string>

#include <cli/program.hpp>
#include <eliminant/batch/worker_pool.hpp>

using namespace eliminant::batch;

namespace {

// What the text of a task asks its worker for.
Solved obey(const Task& task) {
  static int solved = 0;
  ++solved;
  if (task.text == "fault") std::raise(SIGSEGV);
  if (task.text == "abort") std::raise(SIGABRT);
  if (task.text == "exit") std::_Exit(7);
  if (task.text == "late") std::raise(SIGALRM);
  if (task.text == "kill") std::raise(SIGKILL);
  // A problem that only a process without a past can solve.
  if (task.text == "choosy" && solved > 1) std::raise(SIGSEGV);
  if (task.text == "greedy") return {"first " + std::to_string(solved == 1), true};
  if (task.text.starts_with("once ")) {
    const std::string mark = task.text.substr(5);
    if (!std::filesystem::exists(mark)) {
      std::filesystem::create_directory(mark);
      std::raise(SIGKILL);
    }
  }
  return {"solved " + task.text.substr(0, 10), false};
}

std::string lost(const Task& task, const Death& death) { return "lost " + task.text + " " + in_words(death); }

std::map<std::uint64_t, std::string> results_of(unsigned workers, const std::vector<std::string>& texts) {
  WorkerPool pool(workers, {obey, lost});
  std::map<std::uint64_t, std::string> results;
  std::size_t next = 0;
  while (results.size() < texts.size()) {
    while (pool.has_idle_worker() && next < texts.size()) {
      pool.start({next, next + 1, texts[next]});
      ++next;
    }
    std::vector<pollfd> others;
    for (auto& outcome : pool.wait(-1, others)) results[outcome.number] = outcome.result;
  }
  CHECK(pool.busy_workers() == 0);
  return results;
}

}  // namespace

TEST_CASE("worker pool: a worker that dies costs its problem only") {
  for (const unsigned workers : {1U, 2U, 3U}) {
    CAPTURE(workers);
    const auto results = results_of(workers, {"a", "fault", "b", "abort", "exit", "c", "late", "kill", "d"});
    CHECK(results.at(0) == "solved a");
    CHECK(results.at(1) == "lost fault by signal 11 (Segmentation fault)");
    CHECK(results.at(2) == "solved b");
    CHECK(results.at(3) == "lost abort by signal 6 (Aborted)");
    CHECK(results.at(4) == "lost exit with exit status 7");
    CHECK(results.at(5) == "solved c");
    CHECK(results.at(6) == "lost late by signal 14 (Alarm clock)");
    CHECK(results.at(7) == "lost kill by signal 9 (Killed)");
    CHECK(results.at(8) == "solved d");
  }
}

TEST_CASE("worker pool: a process without a past decides") {
  const auto results = results_of(1, {"a", "choosy", "choosy", "greedy", "b", "greedy"});
  CHECK(results.at(1) == "solved choosy");
  CHECK(results.at(2) == "solved choosy");
  CHECK(results.at(3) == "first 1");
  CHECK(results.at(4) == "solved b");
  CHECK(results.at(5) == "first 1");
}

TEST_CASE("worker pool: a worker killed from outside is no fault of its problem") {
  const TemporaryFolder folder;
  const auto results = results_of(2, {"once " + folder.file("a"), "once " + folder.file("b"), "c"});
  CHECK(results.at(0) == "solved once /tmp/");
  CHECK(results.at(1) == "solved once /tmp/");
  CHECK(results.at(2) == "solved c");
}

TEST_CASE("worker pool: tasks and results of any length arrive") {
  const auto echo = [](const Task& task) { return Solved{task.text + task.text, false}; };
  WorkerPool pool(1, {echo, lost});
  for (const std::size_t size : {0U, 1U, 65'535U, 65'536U, 5'000'000U}) {
    CAPTURE(size);
    const std::string text(size, 'x');
    pool.start({0, 1, text});
    std::vector<eliminant::batch::Outcome> outcomes;
    std::vector<pollfd> others;
    while (outcomes.empty()) outcomes = pool.wait(-1, others);
    CHECK(outcomes.front().result == text + text);
  }
}
