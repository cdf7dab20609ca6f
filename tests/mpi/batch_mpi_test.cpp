// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <random>

#include <cli/program.hpp>
#include <support/batch_runs.hpp>

namespace {

// mpirun refuses root, and more ranks than processors, unless it is told otherwise.
std::vector<std::string> mpi_command(int ranks, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{ELIMINANT_MPI_RUN};
  if (geteuid() == 0) words.push_back("--allow-run-as-root");
  for (const std::string& word :
       {std::string("--oversubscribe"), std::string("-n"), std::to_string(ranks), std::string(ELIMINANT_MPI_PROGRAM)})
    words.push_back(word);
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

// The ranks, which are children of mpirun.
std::vector<pid_t> ranks_of(const RunningProgram& mpirun) { return children_of(mpirun.process()); }

std::string sequential(const TemporaryFolder& folder, const std::string& path) {
  return run_program(folder, "batch '" + path + "'").out;
}

}  // namespace

TEST_CASE("batch with MPI: the same bytes for any number of ranks, and of workers") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", batch_problems(300));
  const std::string whole = sequential(folder, path);
  for (const int ranks : {1, 2, 3}) {
    CAPTURE(ranks);
    const std::string output = folder.file("out");
    CHECK(RunningProgram(mpi_command(ranks, {path, "-o", output, "--threads", ranks == 2 ? "2" : "1"})).wait() == 0);
    CHECK(folder.read("out") == whole);
  }
}

TEST_CASE("batch with MPI: a killed rank ends the job, which is resumed with or without MPI") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", batch_problems(2000));
  const std::string whole = sequential(folder, path);
  std::mt19937 random(5);
  for (int i = 0; i < 4; ++i) {
    const std::string output = "out" + std::to_string(i);
    const std::vector<std::string> arguments{path, "-o", folder.file(output), "--resume", "--quiet"};
    RunningProgram mpirun(mpi_command(2, arguments));
    for (int n = 0; n < 1000 && folder.read(output).empty(); ++n) sleep_milliseconds(5);
    sleep_milliseconds(static_cast<int>(random() % 200));
    const std::vector<pid_t> ranks = ranks_of(mpirun);
    if (ranks.size() > static_cast<std::size_t>(i % 2)) kill(ranks[static_cast<std::size_t>(i % 2)], SIGKILL);
    mpirun.wait();
    if (i == 3)
      CHECK(run_program(folder, "batch '" + path + "' -o '" + folder.file(output) + "' --resume").status == 0);
    else
      CHECK(RunningProgram(mpi_command(3, arguments)).wait() == 0);
    CHECK(folder.read(output) == whole);
  }
}

TEST_CASE("batch with MPI: a limit ends one problem, and errors have their exit status") {
  const TemporaryFolder folder;
  std::string slow = "{\"problem\": \"plane_curves\", \"p\": \"(x + y + 1)^40 + x*y^3 - 2\", ";
  slow += "\"q\": \"(x - 2*y + 3)^40 - x^3*y + 5\"}\n";
  const std::string quick = "{\"problem\": \"plane_curves\", \"p\": \"x^2 - 2\", \"q\": \"x - y\"}\n";
  const std::string path = folder.write("problems", quick + slow + quick);
  CHECK(RunningProgram(mpi_command(2, {path, "-o", folder.file("out"), "--time-limit", "0.3"})).wait() == 3);
  const std::string results = folder.read("out");
  CHECK(std::count(results.begin(), results.end(), '\n') == 3);
  CHECK(results.find("\"status\": \"incomplete\"") != std::string::npos);
  CHECK(RunningProgram(mpi_command(2, {folder.file("missing")})).wait() == 2);
  CHECK(RunningProgram(mpi_command(2, {path, "--resume"})).wait() == 2);
  CHECK(RunningProgram(mpi_command(2, {path, "-o", "/dev/full"})).wait() == 1);
}
