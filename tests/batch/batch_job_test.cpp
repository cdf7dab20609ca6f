// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include <cli/program.hpp>
#include <eliminant/base/error.hpp>
#include <eliminant/batch/batch_job.hpp>
#include <eliminant/io/results/error_report.hpp>

using namespace eliminant::batch;
using eliminant::InvalidInput;
using eliminant::io::OutputError;

namespace {

std::string refused(const Task& task) { return "{refused " + std::to_string(task.line) + "}"; }
std::string result_of(const Task& task) { return "{" + task.text + "}"; }

// Solves `most` problems of the file, and writes what can be written.
std::uint64_t solve(const std::string& input, const std::string& output, bool resume, std::size_t most = 1000,
                    const std::string& description = "d") {
  LineReader lines(input, {});
  ResultFile results(output, resume, description);
  BatchJob job(lines, results, refused);
  for (std::size_t i = 0; i < most; ++i) {
    const auto task = job.take();
    if (!task) break;
    job.finish({task->number, result_of(*task)});
    job.write();
  }
  if (job.done()) results.finish();
  return job.resumed();
}

}  // namespace

TEST_CASE("batch job: results are written in order, whatever the order they come in") {
  const TemporaryFolder folder;
  LineReader lines(folder.write("in", "a\n\nb\nc\nd\n"), {});
  ResultFile results(folder.file("out"), false, "d");
  BatchJob job(lines, results, refused);
  std::vector<Task> tasks;
  while (auto task = job.take()) tasks.push_back(*task);
  REQUIRE(tasks.size() == 4);
  CHECK(tasks[1].number == 1);
  CHECK(tasks[1].line == 3);
  const std::vector<std::string> written{"", "", "{a}\n{b}\n{c}\n", "{a}\n{b}\n{c}\n{d}\n"};
  std::size_t step = 0;
  for (const std::size_t i : {2U, 1U, 0U, 3U}) {
    job.finish({i, result_of(tasks[i])});
    job.write();
    CHECK(folder.read("out") == written[step++]);
  }
  CHECK(job.done());
}

TEST_CASE("batch job: a problem that is given back is handed out again, and first") {
  const TemporaryFolder folder;
  LineReader lines(folder.write("in", "a\nb\nc\n"), {});
  ResultFile results(folder.file("out"), false, "d");
  BatchJob job(lines, results, refused);
  job.take();
  job.take();
  job.give_back(1);
  job.give_back(0);
  CHECK(job.take()->text == "a");
  CHECK(job.take()->text == "b");
  CHECK(job.take()->text == "c");
  CHECK_FALSE(job.take());
}

TEST_CASE("batch job: no more is read while the window is full") {
  const TemporaryFolder folder;
  LineReader lines(folder.write("in", "a\nb\nc\nd\n"), {});
  ResultFile results(folder.file("out"), false, "d");
  SUBCASE("of problems") {
    BatchJob job(lines, results, refused, {2, 1000});
    job.take();
    job.take();
    CHECK_FALSE(job.take());
    // The second one alone makes no room: it waits for the first.
    job.finish({1, "{}"});
    job.write();
    CHECK_FALSE(job.take());
    job.finish({0, "{}"});
    job.write();
    CHECK(job.take()->text == "c");
  }
  SUBCASE("of bytes") {
    BatchJob job(lines, results, refused, {100, 3});
    for (int i = 0; i < 3; ++i) CHECK(job.take());
    CHECK_FALSE(job.take());
    job.finish({0, "{}"});
    job.write();
    CHECK(job.take());
  }
}

TEST_CASE("batch job: an output cut anywhere is continued to the same file") {
  const TemporaryFolder folder;
  const std::string input = folder.write("in", "aaa\nb\n\ncc\nddd\ne\n");
  solve(input, folder.file("whole"), false);
  const std::string whole = folder.read("whole");
  CHECK(whole == "{aaa}\n{b}\n{cc}\n{ddd}\n{e}\n");
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    CAPTURE(size);
    solve(input, folder.file("cut"), false);
    REQUIRE(truncate(folder.file("cut").c_str(), static_cast<off_t>(size)) == 0);
    const auto kept =
        static_cast<std::uint64_t>(std::count(whole.begin(), whole.begin() + static_cast<long>(size), '\n'));
    CHECK(solve(input, folder.file("cut"), true) == kept);
    CHECK(folder.read("cut") == whole);
  }
  // What a power failure may leave: the length, not the content.
  folder.write("cut", whole.substr(0, 10) + std::string(7, '\0') + "\n");
  CHECK(solve(input, folder.file("cut"), true) == 2);
  CHECK(folder.read("cut") == whole);
}

TEST_CASE("batch job: a torn state does no harm") {
  const TemporaryFolder folder;
  const std::string input = folder.write("in", "aaa\nb\ncc\n");
  solve(input, folder.file("out"), false);
  const std::string state = folder.read("out.state");
  const std::size_t heading = state.find("\nd\n") + 3;
  for (std::size_t size = heading; size <= state.size(); ++size) {
    CAPTURE(size);
    folder.write("out", "{aaa}\n{b");
    folder.write("out.state", state.substr(0, size));
    CHECK(solve(input, folder.file("out"), true) == 1);
    CHECK(folder.read("out") == "{aaa}\n{b}\n{cc}\n");
    CHECK(solve(input, folder.file("out"), true) == 3);
  }
}

TEST_CASE("batch job: an output of something else is not continued, and stays as it is") {
  const TemporaryFolder folder;
  const std::string input = folder.write("in", "a\nb\nc\n");
  solve(input, folder.file("out"), false, 2);
  const auto refuse = [&](const std::string& problems, const std::string& description) {
    CHECK_THROWS_AS(solve(folder.write("other", problems), folder.file("out"), true, 1000, description), InvalidInput);
    CHECK(folder.read("out") == "{a}\n{b}\n");
  };
  refuse("a\nb\nc\n", "other options");
  refuse("x\nb\nc\n", "d");
  // The number of a line is part of the result of one that is no problem.
  refuse("\na\nb\nc\n", "d");
  refuse("a\n", "d");
  folder.write("out.state", "something\n");
  refuse("a\nb\nc\n", "d");
  std::filesystem::remove(folder.file("out.state"));
  refuse("a\nb\nc\n", "d");
  // Without a result there is nothing that could belong to something else.
  folder.write("out", "");
  CHECK(solve(input, folder.file("out"), true) == 0);
  CHECK(folder.read("out") == "{a}\n{b}\n{c}\n");
}

TEST_CASE("batch job: a blank line that came or went before the kept results is noticed, one after them is none") {
  const TemporaryFolder folder;
  solve(folder.write("in", "a\n\nb\nc\n"), folder.file("out"), false);
  const std::string whole = folder.read("out");
  for (const char* changed : {"a\nb\nc\n", "\na\n\nb\nc\n", "a\n\n\nb\nc\n", "a\nb\n\nc\n"}) {
    CAPTURE(changed);
    CHECK_THROWS_AS(solve(folder.write("in", changed), folder.file("out"), true), InvalidInput);
    CHECK(folder.read("out") == whole);
  }
  CHECK(solve(folder.write("in", "a\n\nb\nc\n\n\nd\n"), folder.file("out"), true) == 3);
  CHECK(folder.read("out") == whole + "{d}\n");
}

TEST_CASE("batch job: what is refused keeps its torn last line, and its state") {
  const TemporaryFolder folder;
  const std::string input = folder.write("in", "a\nb\nc\n");
  solve(input, folder.file("out"), false);
  folder.write("out", "{a}\n{b");
  const std::string torn_state = folder.read("out.state") + "4 0123";
  folder.write("out.state", torn_state);
  const auto refuse = [&](const std::string& problems, const std::string& description) {
    CHECK_THROWS_AS(solve(folder.write("other", problems), folder.file("out"), true, 1000, description), InvalidInput);
    CHECK(folder.read("out") == "{a}\n{b");
    CHECK(folder.read("out.state") == torn_state);
  };
  refuse("x\nb\nc\n", "d");
  refuse("\n", "d");
  refuse("a\nb\nc\n", "other options");
  CHECK(solve(input, folder.file("out"), true) == 1);
  CHECK(folder.read("out") == "{a}\n{b}\n{c}\n");
}

TEST_CASE("batch job: problems that were appended are solved") {
  const TemporaryFolder folder;
  solve(folder.write("in", "a\nb\n"), folder.file("out"), false);
  CHECK(solve(folder.write("in", "a\nb\nc\n"), folder.file("out"), true) == 2);
  CHECK(folder.read("out") == "{a}\n{b}\n{c}\n");
}

TEST_CASE("batch job: an output has one writer") {
  const TemporaryFolder folder;
  const ResultFile results(folder.file("out"), false, "d");
  const pid_t other = fork();
  if (other == 0) {
    int status = 1;
    try {
      const ResultFile second(folder.file("out"), true, "d");
    } catch (const OutputError&) {
      status = 0;
    } catch (...) {
    }
    std::_Exit(status);
  }
  int status = 1;
  waitpid(other, &status, 0);
  CHECK(status == 0);
}

TEST_CASE("batch job: what cannot be written is an error of the output") {
  const TemporaryFolder folder;
  const std::string input = folder.write("in", "a\n");
  CHECK_THROWS_AS(solve(input, "/dev/full", false), OutputError);
  CHECK_THROWS_AS(solve(input, folder.file("missing/out"), false), OutputError);
  CHECK_THROWS_AS(solve(input, folder.file("."), false), OutputError);
  CHECK_THROWS_AS(solve(input, "/dev/null", true), InvalidInput);
}
